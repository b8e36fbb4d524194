"""PCL, by the program run_pcl_filters, which is built when it is first needed."""

import functools
import pathlib

import numpy

from .job import Result, Setting
from .process import Deadline, Failure, run
from .search import search

SOURCES = pathlib.Path(__file__).parent

# cheap, and needed: the number of points jumps with the size of the cells
TRIES = 20

# Radii of moving least squares, in diagonals of the bounding box: from just above the spacing of
# 134,000 points to one that smooths noise of 0.2 % away. No radius is best for every input.
RADII = (0.004, 0.008, 0.012, 0.016, 0.024)

# seconds; PCL's templates take about one minute
BUILD_TIMEOUT = 900


@functools.lru_cache(maxsize=None)
def build(build_folder):
    """the program, or why there is none"""
    deadline = Deadline(BUILD_TIMEOUT)
    build_folder.mkdir(parents=True, exist_ok=True)
    try:
        run(["cmake", "-S", SOURCES, "-B", build_folder, "-DCMAKE_BUILD_TYPE=Release"],
            build_folder, deadline)
        run(["cmake", "--build", build_folder], build_folder, deadline)
    except Failure as failure:
        return Failure(f"run_pcl_filters cannot be built: {failure}")
    return build_folder / "run_pcl_filters"


def program(job):
    with job.deadline.paused():
        built = build(job.build_folder)
    if isinstance(built, Failure):
        raise built
    return built


def simplify(job, outliers, sampling, size, radius=0.0):
    """Files are plain arrays of floats, the scalars of PCL's points."""
    executable = program(job)
    input_name, output_name = job.folder / "pcl_input", job.folder / "pcl_output"
    if not input_name.exists():
        job.points.astype(numpy.float32).tofile(input_name)
    printed, _ = run([executable, outliers, sampling, repr(size), repr(radius),
                      input_name, output_name], job.folder, job.deadline)
    points = numpy.fromfile(output_name, numpy.float32).reshape(-1, 3)
    return Result(points, float(printed.split()[-1]), "call")


def size_of_cells(job, outliers, sampling):
    return search(lambda size: len(simplify(job, outliers, sampling, size).points),
                  job.count, job.diagonal, TRIES)


def voxel_grid(job):
    size = size_of_cells(job, "keep", "voxel_grid")
    yield Setting(f"leaf {size:.6g}", lambda: simplify(job, "keep", "voxel_grid", size))


def uniform(job):
    size = size_of_cells(job, "keep", "uniform")
    yield Setting(f"radius {size:.6g}", lambda: simplify(job, "keep", "uniform", size))


def with_each_radius(job, description, outliers, sampling):
    size = size_of_cells(job, outliers, sampling)
    for radius in RADII:
        yield Setting(
            f"{description} {size:.6g}, MLS radius {radius} diagonals",
            lambda radius=radius: simplify(job, outliers, sampling, size, radius * job.diagonal))


def voxel_grid_mls(job):
    yield from with_each_radius(job, "leaf", "keep", "voxel_grid")


def outliers_uniform_mls(job):
    yield from with_each_radius(job, "outliers 20 0.3, radius", "remove", "uniform")


METHODS = {
    "pcl_voxel_grid": voxel_grid,
    "pcl_uniform": uniform,
    "pcl_voxel_grid_mls": voxel_grid_mls,
    "pcl_outliers_uniform_mls": outliers_uniform_mls,
}
