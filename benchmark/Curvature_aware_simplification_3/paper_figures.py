"""Table 1 and Fig. 2 to 8 of the paper, row by row, from data at hand."""

import pathlib
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from comparison import Case, write_outputs
from page import number, write_table

PAPER_TABLE_1 = [
    # model, input points, output points, iterations, seconds, error, stand-in
    ("Igea", 134345, 13227, 10, 8.17, 3.32e-4, None),
    ("Santa", 75781, 7567, 10, 4.56, 3.01e-4, "man.off"),
    ("Armadillo", 172974, 17226, 10, 10.39, 3.45e-4, "armadillo.off"),
    ("Octopus", 269390, 8060, 10, 5.00, 2.31e-4, "refined_elephant.off"),
    ("Face", 84397, 4189, 20, 11.90, 9.84e-4, "mannequin-devil.off"),
    ("Galaad", 1451502, 14608, 10, 14.14, 7.99e-4, "bear.off"),
]


class Figures:
    def __init__(self, comparison, cgal_meshes, igea, render, output):
        self.comparison, self.meshes, self.igea = comparison, pathlib.Path(cgal_meshes), igea
        self.render, self.output = render, pathlib.Path(output)

    def simplify(self, case, parameters, points_file=None):
        options = [*case.options(), "--parameters", parameters]
        if points_file:
            options += ["--write", str(points_file)]
        return self.comparison.call(options)[-1]

    def pictures(self, name, case, rows, **camera):
        """simplifies with each of the parameters and draws the results side by side"""
        items, measured = [], []
        for i, (title, parameters) in enumerate(rows):
            file = self.output / f"{name}_{i}.ply"
            measured.append((title, self.simplify(case, parameters, file)))
            items.append(f"{file}={title}")
        self.render(case.source, items, self.output / f"{name}.png", **camera)
        for item in items:
            pathlib.Path(item.partition("=")[0]).unlink()
        keys = ("recon_mean", "recon_p99", "distance_mean", "m", "spacing_variation")
        rows = [["", "recon mean", "p99", "Δ mean", "m", "CV"]]
        rows += [[title, *(number(r.get(k)) for k in keys)] for title, r in measured]
        return write_table(self.output / f"{name}.csv", rows) + f"\n![{name}]({name}.png)\n"

    def armadillo(self, degradation="clean", count=17226):
        return Case("Armadillo", self.meshes / "armadillo.off", degradation, count, sample=172974)

    def table_1(self):
        rows = [["model", "points", "output", "paper: s", "ours: s", "paper: Δ", "ours: Δ MLS",
                 "data"]]
        for model, size, count, iterations, seconds, error, stand_in in PAPER_TABLE_1:
            source = self.meshes / stand_in if stand_in else self.igea
            if not source:
                continue
            case = Case(model, source, count=count, sample=size if stand_in else None)
            result = self.simplify(case, f"paper=1 radius=paper iterations={iterations}")
            data = f"stand-in: {size:,} random points on {stand_in}" if stand_in else "the same model"
            rows.append([model, size, count, seconds, f"{result['seconds']:.2f}", f"{error:.2e}",
                         number(result["delta_mls"]), data])
        return write_table(self.output / "table_1.csv", rows)

    def figure_2(self):
        case = (Case("Igea", self.igea, count=13227) if self.igea else
                Case("Elephant", self.meshes / "refined_elephant.off", count=4400))
        return self.pictures("figure_2", case, [
            ("uniform start", "paper=1 curvature_weight=0 iterations=0"),
            ("uniform, d = 0.1", "paper=1 curvature_weight=0 curvature_dependence=0.1"),
            ("curvature-aware start", "paper=1 iterations=0"),
            ("curvature-aware, d = 2", "paper=1 iterations=10"),
            ("adaptive, uniform", "adaptivity=0"),
            ("adaptive, defaults", "iterations=10")], size=400, columns=3)

    def figure_3(self):
        return self.pictures("figure_3", self.armadillo(), [
            ("weights (1, 0), 10 iterations", "paper=1 curvature_weight=0 iterations=10"),
            ("weights (1, 0), 30 iterations", "paper=1 curvature_weight=0 iterations=30"),
            ("weights (1/4, 3/4), 10 iterations", "paper=1 iterations=10"),
            ("adaptive, 10 iterations", "iterations=10")],
            direction=(0.2, 0.1, -1.0), size=450)

    def figure_4(self):
        case = Case("Santa", self.meshes / "man.off", count=7567, sample=75781)
        return self.pictures("figure_4", case, [
            (f"d = {d}", f"paper=1 curvature_dependence={d}") for d in (0.1, 2, 10)], size=500)

    def figure_5(self):
        """noise and outliers, raw and with the outliers removed before"""
        case = Case("Face", self.igea or self.meshes / "mannequin-devil.off", "outliers:5",
                    percentage=5)
        raw = self.pictures("figure_5", case, [
            ("settings of the paper, 20 iterations", "paper=1 iterations=20"),
            ("radius 4 spacings", "paper=1 iterations=20 radius=4"),
            ("adaptive, 20 iterations", "iterations=20")], size=500)
        cleaned = self.comparison.call([*case.options(), "--parameters",
                                        "paper=1 iterations=20 remove_outliers=2"])[-1]
        return raw + f"\nThe settings of the paper after `remove_outliers`: recon mean {number(cleaned.get('recon_mean'))}, " \
                     f"Δ mean {number(cleaned.get('distance_mean'))}.\n"

    def all_methods(self, name, case, results, external):
        """Fig. 7 and 8: the best setting of every method, side by side"""
        with tempfile.TemporaryDirectory() as folder:
            written = write_outputs(self.comparison, case, results, external, folder)
            items = [f"{file}={method}" for method, file in written]
            self.render(case.source, items, self.output / f"{name}.png", columns=6, size=240)
        return f"The tables above, and:\n\n![{name}]({name}.png)\n"

    def figure_6(self):
        """regularity against iterations"""
        figure, axes = plt.subplots(1, 2, figsize=(10, 4))
        rows = [["stand-in for", "start", "iterations", "m"]]
        cases = (Case("Octopus", self.meshes / "refined_elephant.off", count=8060, sample=269390),
                 Case("Santa", self.meshes / "man.off", count=7567, sample=75781))
        iterations = (0, 1, 2, 4, 6, 8, 10, 15, 20, 30)
        for axis, case in zip(axes, cases):
            for title, start in (("paper, curvature-aware start", "paper=1 "),
                                 ("paper, uniform start", "paper=1 curvature_weight=0 "),
                                 ("adaptive", "")):
                m = [self.simplify(case, f"{start}iterations={i}")["m"] for i in iterations]
                rows += [[case.name, title, i, number(value)] for i, value in zip(iterations, m)]
                axis.plot(iterations, m, marker="o", label=title)
            axis.set(title=f"stand-in for {case.name}", xlabel="iterations", ylabel="m",
                     yscale="log")
            axis.legend()
        figure.tight_layout()
        figure.savefig(self.output / "figure_6.png", dpi=80)
        plt.close(figure)
        write_table(self.output / "figure_6.csv", rows)
        return "![figure_6](figure_6.png)\n"
