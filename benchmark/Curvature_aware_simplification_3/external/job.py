"""What every method is given, and what it returns."""

import dataclasses
import functools
import pathlib
import typing

import numpy

from . import ply
from .process import Deadline


@dataclasses.dataclass
class Job:
    input: pathlib.Path         # ply file
    points: numpy.ndarray       # its points
    count: int                  # of points to return
    folder: pathlib.Path        # for temporary files
    build_folder: pathlib.Path  # for programs that are built first
    deadline: Deadline

    @functools.cached_property
    def diagonal(self):
        """of the bounding box"""
        points = self.points.astype(float)
        return float(numpy.linalg.norm(points.max(axis=0) - points.min(axis=0)))


@dataclasses.dataclass
class Result:
    points: numpy.ndarray
    seconds: float
    timed: str  # "call": the program's functions alone; "process": with start, input and output


@dataclasses.dataclass
class Setting:
    """one way of calling a method; `call` makes the final call, after any search"""
    description: str
    call: typing.Callable[[], Result]


def read_output(name, program):
    """points that `program` should have written; it may have said in its own way that it did not"""
    if not name.exists():
        raise ValueError(f"{program} wrote no points")
    return ply.read_points(name)
