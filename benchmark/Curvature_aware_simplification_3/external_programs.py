#!/usr/bin/env python3
"""Simplifies one point set with MeshLab, Open3D, PCL and CloudCompare, as their users would.

Where a program takes a radius or the size of a cell, the one is searched for with which it
returns about the number of points that is asked for. Each setting of each method writes the points
to a ply file and appends a line to index.jsonl. A program that is missing, fails or takes too long
has a line with the error instead, and the others still run.

The packages of Debian that are needed are listed in scripts/external_packages.txt.
"""

import argparse
import json
import pathlib
import re
import sys
import tempfile

import numpy

sys.dont_write_bytecode = True  # before the imports of what lies beside the sources

from external import (ply, with_cloudcompare, with_meshlab, with_open3d, with_pcl,
                      with_poisson_eliminate)
from external.job import Job
from external.process import Deadline

METHODS = {
    **with_meshlab.METHODS,
    **with_open3d.METHODS,
    **with_pcl.METHODS,
    **with_cloudcompare.METHODS,
    **with_poisson_eliminate.METHODS,
}


class Index:
    """index.jsonl and the files that it names"""

    def __init__(self, folder):
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)

    def append(self, method, setting=None, seconds=None, timed=None, points=None, file=None,
               error=None):
        record = {"method": method, "setting": setting, "seconds": seconds, "timed": timed,
                  "points": points, "file": file, "error": error}
        line = json.dumps(record)
        with open(self.folder / "index.jsonl", "a") as index:
            index.write(line + "\n")
        print(line, flush=True)

    def append_error(self, method, setting, exception):
        lines = str(exception).splitlines() or [type(exception).__name__]
        self.append(method, setting, error=lines[0])

    def append_result(self, method, setting, result):
        file = f"{method}--{re.sub('[^a-zA-Z0-9.]+', '_', setting).strip('_')}.ply"
        finite = result.points[numpy.isfinite(result.points).all(axis=1)]
        lost = len(result.points) - len(finite)
        ply.write_points(self.folder / file, finite)
        self.append(method, setting, round(result.seconds, 4), result.timed, len(finite), file,
                    f"{lost} points are not finite and left out" if lost else None)


def run_method(method, job, index):
    """Anything that goes wrong with a program, foreseen or not, is a result of the comparison."""
    try:
        for setting in METHODS[method](job):
            try:
                index.append_result(method, setting.description, setting.call())
            except Exception as exception:
                index.append_error(method, setting.description, exception)
    except Exception as exception:
        index.append_error(method, None, exception)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("input", type=pathlib.Path, help="binary ply file of points")
    parser.add_argument("output", type=pathlib.Path, help="folder")
    parser.add_argument("--count", type=int, required=True, help="number of points to return")
    parser.add_argument("--methods", default=",".join(METHODS), help="default: %(default)s")
    parser.add_argument("--timeout", type=float, default=600,
                        help="seconds of a method, with its search and all its settings")
    parser.add_argument("--build-folder", type=pathlib.Path, default="build/external",
                        help="for the program that calls PCL")
    arguments = parser.parse_args()
    arguments.methods = arguments.methods.split(",")
    unknown = set(arguments.methods) - set(METHODS)
    if unknown:
        parser.error(f"no method is called {', '.join(sorted(unknown))}")
    if arguments.count < 1:
        parser.error("the number of points must be positive")
    return arguments


def main():
    arguments = parse_arguments()
    points = ply.read_points(arguments.input)
    index = Index(arguments.output)
    for method in arguments.methods:
        with tempfile.TemporaryDirectory() as folder:
            run_method(method, Job(arguments.input.resolve(), points, arguments.count,
                                   pathlib.Path(folder), arguments.build_folder.resolve(),
                                   Deadline(arguments.timeout)), index)


if __name__ == "__main__":
    main()
