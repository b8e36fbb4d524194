"""CloudCompare, by its command line."""

from .job import Result, Setting, read_output
from .process import run_headless
from .search import search

# half a second each, and its numbers of points change smoothly
TRIES = 12


def subsample(job, spacing):
    """points no two of which are nearer than `spacing`

    The shift is CloudCompare's own remedy for coordinates too large for its floats.
    """
    output = job.folder / "cloudcompare.ply"
    output.unlink(missing_ok=True)
    _, seconds = run_headless(
        ["CloudCompare", "-SILENT", "-AUTO_SAVE", "OFF", "-NO_TIMESTAMP",
         "-C_EXPORT_FMT", "PLY", "-PLY_EXPORT_FMT", "BINARY_LE",
         "-O", "-GLOBAL_SHIFT", "AUTO", str(job.input), "-SS", "SPATIAL", f"{spacing:.9g}",
         "-SAVE_CLOUDS", "FILE", str(output)],
        job.folder, job.deadline)
    return Result(read_output(output, "CloudCompare"), seconds, "process")


def spatial(job):
    spacing = search(lambda size: len(subsample(job, size).points),
                     job.count, job.diagonal, TRIES)
    yield Setting(f"spacing {spacing:.6g}", lambda: subsample(job, spacing))


METHODS = {"cloudcompare_spatial": spatial}
