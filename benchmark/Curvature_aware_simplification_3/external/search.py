"""The size (a radius, the side of a cell) for which a program returns a given number of points."""

import math

# relative; 7 of 13,227 points, far below what changes any measure of the output
TOLERANCE = 5e-4


def search(count_at, count, diagonal, tries):
    """the size whose number of points is nearest to `count` among at most `tries`

    On a surface the number falls with the square of the size, which gives the next size to try.
    Where that leaves the bracket (the number also jumps, as cells move), the bracket is halved.
    """
    too_small, too_large = 0.0, math.inf
    size = diagonal / math.sqrt(count)
    best_difference, best_size = math.inf, size
    for _ in range(tries):
        returned = count_at(size)
        if abs(returned - count) < best_difference:
            best_difference, best_size = abs(returned - count), size
        if best_difference <= TOLERANCE * count:
            break
        if returned > count:
            too_small = size
        else:
            too_large = size
        # at most a factor of 4: a program that fails on too small a size may return anything
        step = min(max(math.sqrt(returned / count), 0.25), 4.0)
        size *= step
        if not too_small < size < too_large:
            size = math.sqrt(too_small * too_large) if too_small else too_large / 2.0
    return best_size
