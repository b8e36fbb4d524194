#!/usr/bin/env python3
"""Runs the whole comparison and writes results/README.md; called by scripts/benchmark.sh."""

import argparse
import datetime
import functools
import json
import os
import pathlib
import platform
import subprocess
import sys

from PIL import Image

from ablation import ablation
from comparison import Case, Comparison
from page import ratios, stages, table, write_csv
from paper_figures import Figures
from scaling import scaling
from shapes import shapes_page

HERE = pathlib.Path(__file__).resolve().parent
DEGRADATIONS = ["clean", "noise:0.2", "outliers:5", "density:10", "uneven_noise:0.2", "hole:10",
                "duplicates:100"]
ANALYTIC = ["sphere", "torus", "ellipsoid", "rounded_box", "wavy_patch"]


def first_line(command):
    try:
        return subprocess.run(command, capture_output=True, text=True).stdout.splitlines()[0]
    except (OSError, IndexError):
        return "not found"


def processor():
    for line in open("/proc/cpuinfo"):
        if line.startswith("model name"):
            return line.partition(":")[2].strip()
    return platform.processor()


def surroundings(arguments):
    """what the figures depend on"""
    version = subprocess.run(["dpkg-query", "-W", "-f", "${Package} ${Version}, ", "libcgal-dev",
                              "libeigen3-dev", "libtbb-dev", "libboost-dev"],
                             capture_output=True, text=True).stdout.rstrip(", ")
    commit = first_line(["git", "-C", str(HERE), "rev-parse", "--short", "HEAD"])
    command, kept = f"scripts/benchmark.sh {arguments.mode}", ""
    if arguments.reuse:
        command += " --reuse"
    if arguments.rerun:
        command += f' --rerun "{arguments.rerun}"'
    if arguments.reuse or arguments.rerun:
        kept = ("Rows that were not run again are from an earlier run, and their seconds maybe from "
                "another machine; the section on cost has all times from one.\n")
    return (f"{datetime.date.today()}, commit {commit}, {processor()}, {os.cpu_count()} threads, "
            f"{first_line(['g++', '--version'])}, {version}.\n"
            f"Command: `{command}`.\n{kept}")


def render(reference, items, output, **camera):
    command = ["xvfb-run", "-a", "/usr/bin/python3", str(HERE / "../../scripts/render_points.py"),
               str(reference), *items, "--output", str(output)]
    for name, value in camera.items():
        values = value if isinstance(value, (tuple, list)) else [value]
        command += [f"--{name}", *map(str, values)]
    subprocess.run(command, check=True)
    # 64 colors are enough for gray surfaces and blue points, in a quarter of the size
    Image.open(output).convert("RGB").quantize(64).save(output, optimize=True)


def cases(mode, shared, meshes):
    """Igea where it is at hand; the data of CGAL and analytic surfaces always"""
    elephant = meshes / "refined_elephant.off"
    igea = shared / "igea.ply"
    if mode == "quick":
        return [Case("torus", "torus", d, percentage=5, sample=20000)
                for d in ("clean", "noise:0.2", "outliers:5")]
    result = []
    if igea.exists():
        result += [Case("Igea", igea, "clean", 13227), Case("Igea at 1 %", igea, "clean", 1343)]
        result += [Case("Igea", igea, d, 13227) for d in DEGRADATIONS[1:5]]
    if mode == "igea":
        return result
    result += [Case("elephant", elephant, d, 10000, sample=100000) for d in DEGRADATIONS]
    result += [Case(s, s, d, 4000, sample=80000) for s in ANALYTIC for d in DEGRADATIONS[:5]]
    result += [Case(s, shared / f"{s}.ply", "clean", percentage=5)
               for s in ("room_scan", "kinect_clutter", "terrain_utm")
               if (shared / f"{s}.ply").exists()]
    return result


def kernels(program, output):
    run = subprocess.run([str(program), "--benchmark_format=json", "--benchmark_min_time=0.2"],
                         capture_output=True, text=True)
    if run.returncode != 0:
        return "The kernels failed.\n"
    benchmarks = json.loads(run.stdout)["benchmarks"]  # without the context, which names the machine
    (output / "kernels.json").write_text(json.dumps(benchmarks, indent=1))
    times = {b["name"]: b["real_time"] for b in benchmarks}
    names = list(dict.fromkeys(name.split("/")[0] for name in times))
    columns = list(dict.fromkeys(name.split("/", 1)[1] for name in times))
    title = [c.replace("/real_time", "").replace("M:", "M = ").replace("/threads:", ", threads: ")
             for c in columns]
    lines = ["| stage, ms | " + " | ".join(title) + " |", "|---" * (len(columns) + 1) + "|"]
    for name in names:
        lines.append(f"| {name.replace('_', ' ')} | "
                     + " | ".join(f"{times[f'{name}/{c}']:.1f}" for c in columns) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("mode", choices=["quick", "igea", "shapes", "full"])
    parser.add_argument("--build", required=True, help="folder of the built programs")
    parser.add_argument("--meshes", required=True, help="folder of CGAL's meshes")
    parser.add_argument("--shared", default=str(HERE / "../../../shared/data"),
                        help="folder of scans that are not part of the project")
    parser.add_argument("--output", default=str(HERE / "results"))
    parser.add_argument("--reuse", action="store_true",
                        help="take the results that are there, and run what is missing")
    parser.add_argument("--rerun", metavar="START",
                        help="like --reuse, but run the methods again whose names start so")
    parser.add_argument("--seconds", type=int, default=300, help="limit for one method")
    arguments = parser.parse_args()

    build, meshes = pathlib.Path(arguments.build), pathlib.Path(arguments.meshes)
    shared, output = pathlib.Path(arguments.shared).resolve(), pathlib.Path(arguments.output)
    if arguments.mode == "shapes":
        shapes_page(Comparison(build / "simplify_and_measure", build / "shapes", arguments.seconds,
                               timed=False), meshes, arguments, surroundings(arguments), output)
        print(f"Results are in {output / 'shapes.md'}")
        return 0
    quick = arguments.mode == "quick"
    comparison = Comparison(build / "simplify_and_measure", output, 60 if quick else
                            arguments.seconds, tuned=not quick, timed=not quick)
    external = None if quick else HERE / "external_programs.py"

    results, sections = {}, []
    all_cases = {case.title(): case for case in cases(arguments.mode, shared, meshes)}
    for title, case in all_cases.items():
        results[title] = comparison.results(case, external, arguments.reuse, arguments.rerun)
        sections.append(f"### {title}\n\n{table(results[title])}\n{stages(results[title])}")
    write_csv(output / "results.csv", [r for rows in results.values() for r in rows])

    page = [("# Results\n", lambda: surroundings(arguments)),
            ("", (HERE / "reading.md").read_text),
            ("## This package at its defaults over the best tuned peer\n", lambda: ratios(results)),
            ("## All methods\n", lambda: "\n".join(sections)),
            ("## Stages\n", lambda: kernels(build / "kernels", output))]
    if not quick:
        igea = shared / "igea.ply"
        figures = Figures(comparison, meshes, igea if igea.exists() else None, render, output)
        page += [("## Cost\n",
                  lambda: scaling(build, igea if igea.exists() else None, output)),
                 ("", (HERE / "history.md").read_text),
                 ("## What each idea is worth\n",
                  lambda: ablation(comparison, igea if igea.exists() else None, meshes, output)),
                 ("## The paper, row by row\n", str),
                 ("### Table 1\n", figures.table_1),
                 ("### Fig. 2: uniform and curvature-aware\n", figures.figure_2),
                 ("### Fig. 3: start and iterations\n", figures.figure_3),
                 ("### Fig. 4: curvature dependence\n", figures.figure_4),
                 ("### Fig. 5: noise and outliers\n", figures.figure_5),
                 ("### Fig. 6: regularity against iterations\n", figures.figure_6)]
        # the paper's Armadillo and Indolady: evenly and unevenly sampled
        for figure, title in ((7, "Igea, clean"), (8, "Igea, density 10")):
            if title in all_cases:
                page.append((f"### Fig. {figure}: all methods on {title}\n",
                             functools.partial(figures.all_methods, f"figure_{figure}",
                                               all_cases[title], results[title], external)))
    # written as it grows, so that a run that is stopped leaves what it has
    text = ""
    for title, make in page:
        text += f"{title}\n{make()}\n"
        (output / "README.md").write_text(text)
    print(f"Results are in {output / 'README.md'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
