"""CGAL's Poisson elimination, which is newer than the CGAL of Debian 12. A newer one is unpacked and
the program run_poisson_eliminate is built with it when it is first needed.

Its running time explodes on noise and outliers, where its balls hold many points: the deadline of the
method bounds it."""

import functools
import pathlib

import numpy

from .job import Result, Setting
from .process import Deadline, Failure, run

SOURCES = pathlib.Path(__file__).parent / "poisson_eliminate"
NEWEST_CGAL = pathlib.Path(__file__).parents[3] / "scripts" / "newest_cgal.sh"

# seconds, with the package that is downloaded
BUILD_TIMEOUT = 600

# maximum radius in output spacings; 0 is the default, which takes a volume for an area
RADII = (0.0, 1.0, 1.5, 2.0)


@functools.lru_cache(maxsize=None)
def build(build_folder):
    """the program, or why there is none"""
    deadline = Deadline(BUILD_TIMEOUT)
    folder = build_folder / "poisson_eliminate"
    folder.mkdir(parents=True, exist_ok=True)
    try:
        cgal, _ = run([NEWEST_CGAL, folder / "cgal"], folder, deadline)
        run(["cmake", "-S", SOURCES, "-B", folder, "-DCMAKE_BUILD_TYPE=Release",
             f"-DCGAL_DIR={cgal.strip().splitlines()[-1]}"], folder, deadline)
        run(["cmake", "--build", folder], folder, deadline)
    except Failure as failure:
        return Failure(f"run_poisson_eliminate cannot be built: {failure}")
    return folder / "run_poisson_eliminate"


def simplify(job, radius):
    with job.deadline.paused():
        executable = build(job.build_folder)
    if isinstance(executable, Failure):
        raise executable
    input_name, output_name = job.folder / "poisson_input", job.folder / "poisson_output"
    if not input_name.exists():
        job.points.astype(numpy.float64).tofile(input_name)
    printed, _ = run([executable, input_name, output_name, job.count, repr(radius)], job.folder,
                     job.deadline)
    points = numpy.fromfile(output_name, numpy.float64).reshape(-1, 3)
    return Result(points, float(printed.split()[-1]), "call")


def poisson_eliminate(job):
    for radius in RADII:
        description = f"maximum radius {radius:g} spacings" if radius else "defaults"
        yield Setting(description, lambda radius=radius: simplify(job, radius))


METHODS = {"cgal_poisson_eliminate": poisson_eliminate}
