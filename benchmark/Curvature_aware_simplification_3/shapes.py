"""This package at its defaults over the best tuned peer, for many shapes and degradations: the page
results/shapes.md."""

import concurrent.futures
import csv
from statistics import geometric_mean

from comparison import Case, in_words, settings_of
from page import RATIOS, best_peers, is_function_of_cgal, over_best_peers

# three of each kind, meshes of CGAL or analytic surfaces
SHAPES = {"smooth": ["bunny00", "armadillo", "refined_elephant"],
          "sharp edges": ["fandisk", "joint", "rotor"],
          "thin parts": ["hand", "dino", "turbine"],
          "open": ["wavy_patch", "horizons", "lion"]}
ANALYTIC = ["wavy_patch"]
SAMPLE = 30000
SEEDS = [0, 1]
# what is done to the input, and the number of output points
CONDITIONS = [("clean", 3000), ("clean", 300), ("noise:0.2", 3000), ("noise:0.5", 3000),
              ("uneven_noise:0.5", 3000), ("outliers:5", 3000), ("density:10", 3000)]


def column(condition):
    degradation, count = condition
    return in_words(degradation) + ("" if count == CONDITIONS[0][1] else f", {count}")


def is_off_surface(condition):
    """whether the input is, so that the distance to the surface is no matter of rounding"""
    return "noise" in condition[0] or "outliers" in condition[0]


def mean_over_seeds(rows_of_seeds):
    """One result for each setting that did not fail. With a single input, the best of many settings
    would be the luckiest."""
    by_setting = {}
    for rows in rows_of_seeds:
        for row in rows:
            if "recon_mean" in row:
                by_setting.setdefault((row["method"], row.get("setting", "")), []).append(row)
    return [{"method": method, "setting": setting,
             **{key: sum(row[key] for row in rows) / len(rows) for key in RATIOS}}
            for (method, setting), rows in by_setting.items() if len(rows) == len(rows_of_seeds)]


def table(found, key, conditions):
    """a row for each shape, a column for each condition, and their geometric means"""
    lines = ["| | shape | " + " | ".join(map(column, conditions)) + " | all |",
             "|---" * (len(conditions) + 3) + "|"]

    def line(kind, name, shapes):
        values = [geometric_mean([found[s, c][key] for s in shapes]) for c in conditions]
        lines.append(f"| {kind} | {name} | " + " | ".join(f"{v:.2f}" for v in values)
                     + f" | {geometric_mean(values):.2f} |")

    for kind, shapes in SHAPES.items():
        for shape in shapes:
            line(kind, in_words(shape), [shape])
        line(kind, "all of these", shapes)
    line("all", "", [shape for shapes in SHAPES.values() for shape in shapes])
    return "\n".join(lines) + "\n"


def summary(results):
    """geometric means over all shapes and conditions, against more and less choice of peers"""
    def of_cgal(rows):
        return [r for r in rows if r["method"].startswith("this package")
                or is_function_of_cgal(r["method"])]

    def best_by_mean(rows):
        """of all peers, the setting with the best mean, for the other measures as well"""
        best = best_peers(rows)["recon_mean"]
        return [r for r in rows if r["method"].startswith("this package") or r is best]

    keys = [key for key in RATIOS if key.startswith("recon")]
    lines = ["| over | " + " | ".join(RATIOS[key] for key in keys) + " |",
             "|---" * (len(keys) + 1) + "|"]
    for title, chosen in [("the best of all settings of all peers, of each measure its own", list),
                          ("the same of CGAL's functions and chains of them", of_cgal),
                          ("the setting of a peer that has the best mean", best_by_mean),
                          ("the same of CGAL's functions and chains of them",
                           lambda rows: best_by_mean(of_cgal(rows)))]:
        found = [over_best_peers(chosen(rows)) for rows in results.values()]
        values = [geometric_mean([ratios[key] for ratios in found]) for key in keys]
        lines.append(f"| {title} | " + " | ".join(f"{v:.2f}" for v in values) + " |")
    return "\n".join(lines) + "\n"


def write_csv(file, results):
    """ours and the best peer of each case and measure"""
    with open(file, "w", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerow(["shape", "condition", "measure", "this package", "best peer", "method",
                         "setting"])
        for (shape, condition), rows in results.items():
            for key, peer in best_peers(rows).items():
                if peer:
                    ours = settings_of(rows, "this package")[0]
                    writer.writerow([shape, column(condition), RATIOS[key], f"{ours[key]:.5g}",
                                     f"{peer[key]:.5g}", peer["method"], peer["setting"]])


def shapes_page(comparison, meshes, arguments, surroundings, output):
    tasks = [(shape, condition, Case(
        f"{shape} {condition[1]} {seed}",
        shape if shape in ANALYTIC else meshes / f"{shape}.off", condition[0],
        count=condition[1], sample=SAMPLE, seed=seed))
             for shapes in SHAPES.values() for shape in shapes for condition in CONDITIONS
             for seed in SEEDS]

    def measured(task):
        return comparison.results(task[2], reuse=arguments.reuse, rerun=arguments.rerun)

    of_seeds = {}
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for (shape, condition, _), rows in zip(tasks, pool.map(measured, tasks)):
            of_seeds.setdefault((shape, condition), []).append(rows)
    results = {key: mean_over_seeds(rows) for key, rows in of_seeds.items()}
    write_csv(output / "shapes.csv", results)
    found = {key: over_best_peers(rows) for key, rows in results.items()}
    text = f"""# Shapes and degradations

{surroundings}
This package at its defaults over tuned peers: {SAMPLE:,} random points of each surface, degraded as
the column tells, are simplified to {CONDITIONS[0][1]:,}, or as many as it says. Measures and degradations
are those of [the other page](README.md), and means over {len(SEEDS)} inputs for each setting. Peers are
CGAL's functions and chains of them, farthest points, clustering, particle simulation and classical
LOP, with the settings that `simplify_and_measure --list` prints; this package has one.

{summary(results)}
The tables below are over the best of all settings of all peers, of each measure its own: that is one
of about fifty, and partly luck, most of all for the largest error, which is that of one place. The
last rows and columns are geometric means. Ours and the best peer of each are in `shapes.csv`.
"""
    for key, title in RATIOS.items():
        conditions = [c for c in CONDITIONS if key != "distance_mean" or is_off_surface(c)]
        text += f"\n## {title[0].upper() + title[1:]}\n\n{table(found, key, conditions)}"
    (output / "shapes.md").write_text(text)
