"""Open3D, which is called from Python; in a process of its own, which can be stopped."""

import pathlib
import sys

from .job import Result, Setting, read_output
from .process import run
from .search import search

SCRIPT = pathlib.Path(__file__).with_name("open3d_filters.py")

# Half a second each, for a start of Python. The number of points jumps with the size of the cells.
TRIES = 20


def simplify(job, filters, parameter):
    output = job.folder / "open3d.ply"
    output.unlink(missing_ok=True)
    printed, _ = run([sys.executable, SCRIPT, filters, repr(parameter), job.input, output],
                     job.folder, job.deadline)
    return Result(read_output(output, "Open3D"), float(printed.split()[-1]), "call")


def voxel_size(job, filters):
    return search(lambda size: len(simplify(job, filters, size).points),
                  job.count, job.diagonal, TRIES)


def voxel(job):
    size = voxel_size(job, "voxel")
    yield Setting(f"voxel size {size:.6g}", lambda: simplify(job, "voxel", size))


def farthest_point(job):
    yield Setting(f"{job.count} points", lambda: simplify(job, "farthest_point", job.count))


def outliers_voxel(job):
    size = voxel_size(job, "outliers_voxel")
    yield Setting(f"outliers 20 0.3, voxel size {size:.6g}",
                  lambda: simplify(job, "outliers_voxel", size))


METHODS = {
    "open3d_voxel": voxel,
    "open3d_farthest_point": farthest_point,
    "open3d_outliers_voxel": outliers_voxel,
}
