"""How time and memory grow with the input, and what compares them with CGAL's own functions."""

import json
import os
import subprocess

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import matplotlib.ticker

from page import write_table

STAGES = ["sorting", "features", "outliers", "noise", "smoothing", "selection", "relaxation",
          "projection"]


def measure(program, **options):
    command = [str(program)]
    for name, value in options.items():
        command += [f"--{name.replace('_', '-')}"] + ([] if value is True else [str(value)])
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}: {run.stderr}")
    return json.loads(run.stdout)


def row(label, result, base=None):
    relative = f"{result['seconds'] / base['seconds']:.2f}" if base else ""
    ratio = f"{result['ratio']:.2f}" if "ratio" in result else ""
    return [label, f"{result['seconds']:.3g}", relative, ratio, f"{result['bytes']:.0f}",
            *(f"{1000 * result['stages'][stage]:.0f}" for stage in STAGES)]


def scaling(build, igea, output):
    program = build / "measure_scaling"
    threads = os.cpu_count()
    rows = [["input", "s", "over the clean / first one", "over one pca_estimate_normals",
             "bytes per input point", *(f"{stage}, ms" for stage in STAGES)]]
    series = {"input points M, N = 5 %": [], "output points N, M = 1e6": [],
              "neighbors k, M = 1e6, N = 5 %": [], "threads, M = 1e6, N = 5 %": []}
    by_size, by_samples, by_neighbors, by_threads = series.values()

    for size, n in ((134345, 13227), (1450000, 14600)):
        rows.append(row(f"torus, {size:,} → {n:,}",
                        measure(program, points=size, output_points=n, ratio=True)))
    for name in ("torus", "duplicates", "line", "clusters", "outliers", "noise", "layer", "sheets"):
        result = measure(program, points=200000, output_points=10000, input=name)
        clean = result if name == "torus" else clean
        rows.append(row(f"{name}, 200,000 → 10,000", result, clean))
    for size in (10000, 100000, 1000000, 10000000):
        result = measure(program, points=size, output_points=size // 20,
                         rounds=1 if size > 1000000 else 3)
        by_size.append((size, result["seconds"]))
        if size >= 1000000:
            million = result if size == 1000000 else million
            rows.append(row(f"torus, {size:,} → {size // 20:,}", result, million))
    for n in (1000, 10000, 50000, 200000):
        by_samples.append((n, measure(program, output_points=n)["seconds"]))
    for k in (8, 16, 32, 64):
        by_neighbors.append((k, measure(program, neighbors=k)["seconds"]))
    for count in [1 << i for i in range(threads.bit_length()) if 1 << i <= threads]:
        result = measure(program, threads=count)
        by_threads.append((count, result["seconds"]))
        one = result if count == 1 else one
        rows.append(row(f"torus, 1,000,000 → 50,000, threads: {count}", result, one))

    figure, axes = plt.subplots(1, 4, figsize=(16, 3.6))
    for axis, (title, points) in zip(axes, series.items()):
        axis.plot(*zip(*points), marker="o")
        axis.set(xscale="log", xlabel=title, ylabel="seconds")
        if points is by_size:
            axis.set_yscale("log")
        else:
            axis.set_ylim(0, 1.1 * max(y for _, y in points))
        axis.set_xticks([x for x, _ in points], [f"{x:g}" for x, _ in points])
        axis.xaxis.set_minor_locator(matplotlib.ticker.NullLocator())
    figure.tight_layout()
    figure.savefig(output / "scaling.png", dpi=70)
    plt.close(figure)

    text = ("Random points of a torus and what could cost more than those: each point ten times, all "
            "points on a line, two clusters 5e7 spacings apart, 10 % outliers, Gaussian noise of one and of "
            "ten spacings of the points, ten squares 0.6 of these spacings apart.\n\n"
            + write_table(output / "scaling.csv", rows) + "\n![scaling](scaling.png)\n")
    if igea:
        run = subprocess.run([str(build / "compare_with_wlop"), str(igea), "13227"],
                             capture_output=True, text=True)
        text += ("\nAll in one process, ratios of times of the same round:\n\n```\n"
                 + (run.stdout.replace(str(igea), igea.name) or run.stderr) + "```\n")
    return text
