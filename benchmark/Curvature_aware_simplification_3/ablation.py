"""What each idea of the adaptive method is worth: the error with the idea switched off."""

import concurrent.futures
import math

from comparison import Case, in_words
from page import write_table

DEGRADATIONS = ["clean", "sparse", "noise:0.2", "outliers:5", "clusters:5", "density:10", "density:100",
                "uneven_noise:0.2", "density:100+uneven_noise:1", "scan lines", "noisy scan lines",
                "depth steps", "steps of cameras", "frames", "copies", "few points", "dense noise", "laser scan"]
IDEAS = [
    ("uniform density", "adaptivity=0"),
    ("curvature in balls of half a spacing", "curvature_radius=0.5"),
    ("lower bound of the curvature 0.1 of the mean, not 0.5", "least_curvature=0.1"),
    ("curvature not averaged along the surface", "average_curvature=0"),
    ("at most one sample for two points", "densest=0.5"),
    ("no relaxation", "iterations=0"),
    ("4 iterations", "iterations=4"),
    ("20 iterations", "iterations=20"),
    ("narrow repulsion, as in the paper for h of two spacings", "reach_of_repulsion=1.22"),
    ("heights count once in the repulsion", "weight_of_height=1"),
    ("few and far neighbors push as many near ones do", "least_weight_of_neighbors=0"),
    ("all samples move at once", "turns=1"),
    ("first steps no longer than the last", "length_of_first_steps=1"),
    ("samples may cross borders", "keep_borders=0"),
    ("steps of the depth taken for faces", "undo_rounding=0"),
    ("steps of the depth of several cameras taken for faces", "tell_cameras=0"),
    ("copies of places not merged", "merge_copies=0"),
    ("outliers not looked for", "find_outliers=0"),
    ("clusters not taken for outliers", "find_clusters=0"),
    ("sparse parts of a surface taken for outliers", "keep_sparse_surfaces=0"),
    ("far parts with strong noise taken for outliers", "keep_noisy_layers=0"),
    ("lone points of sparse borders taken for outliers", "keep_lone_points=0"),
    ("noise not measured", "measure_noise=0"),
    ("noise measured in single columns of points", "find_columns=0"),
    ("the same noise everywhere", "noise_by_place=0"),
    ("noise measured at 512 places", "most_noise_probes=512"),
    ("two noisy sheets not told from one", "tell_two_sheets=0"),
    ("noise not limited where layers are thick by shape", "limit_noise_by_shape=0"),
    ("noise measured around quadrics only", "noise_around_planes=0"),
    ("noise taken from fits that stand on the surface as well", "tell_standing_fits=0"),
    ("noise not limited by what few points show", "limit_noise_by_planes=0"),
    ("points that are dense against noise not thinned", "thin_dense_noise=0"),
    ("points not smoothed first", "smooth_points=0"),
    ("points smoothed around themselves, not their foot points", "smooth_around_foot_points=0"),
    ("thin parts smoothed as others", "spare_thin_parts=0"),
    ("points smoothed in the same balls whatever the shape", "smooth_by_shape=0"),
    ("points smoothed all the same where fits miss the shape",
     "residuals_explained_by_noise=1e300"),
    ("as few neighbors between the lines of a scan as elsewhere", "widen_between_lines=0"),
    ("balls of fits not moved to foot points", "moves_to_foot_point=0"),
    ("narrowest fits only", "denoise=0"),
    ("widest fits of half as many points", "points_of_widest_fit=289"),
    ("steps to wider fits by a Wiener filter", "missed_shape=0"),
    ("noise along bent surfaces left in the samples", "correct_bias_of_noise=0"),
    ("noisy samples not pushed apart once more", "even_out=0"),
    ("fits not corrected by points", "correct_by_points=0"),
    ("samples left beside sparse and exact points", "largest_amplification=1e300"),
    ("samples on unknown surfaces left far from points", "stay_near_points=0"),
    ("samples not moved to sharp edges", "move_to_edges=0"),
    ("samples not moved into corners of borders", "move_to_corners=0"),
    ("no samples kept for what the others miss", "share_to_insert=0"),
]
SEEDS = [0]
MEASURES = [("recon_mean", "mean"), ("recon_p99", "p99"), ("recon_max", "max"),
            ("distance_mean", "Δ mean")]


def cases(igea, meshes):
    """a head, an animal with thin parts, sharp edges, thin walls, rounded edges, open terrain, twigs"""
    shapes = [(str(igea), None)] if igea else []
    shapes += [(str(meshes / "refined_elephant.off"), 60000),
               (str(meshes / "anchor_dense.off"), 40000), (str(meshes / "rotor.off"), 30000),
               ("rounded_box", 40000), ("wavy_patch", 40000), ("tree", 40000)]
    for source, sample in shapes:
        for degradation in DEGRADATIONS:
            if degradation == "scan lines":
                # 20,000 points on lines that are four times as far apart as these, and 1,500 of the output
                yield degradation, Case(source, source, "lines:1.7+noise:0.07",
                                        percentage=0.75, sample=200000)
                continue
            if degradation == "noisy scan lines":
                # the same with noise along the rays, as large as the distance of the points on a line
                yield degradation, Case(source, source, "lines:1.7+range_noise:0.4",
                                        percentage=0.75, sample=200000)
                continue
            if degradation == "depth steps":
                # 30,000 points; steps of 2 to 3 of their spacings
                yield degradation, Case(source, source, "noise:0.1+depth:1", percentage=10, sample=30000)
                continue
            if degradation == "steps of cameras":
                # the same, each point as one of three cameras sees it
                yield degradation, Case(source, source, "noise:0.1+cameras:1", percentage=10, sample=30000)
                continue
            if degradation == "frames":
                # 10,000 points ten times, with noise of a third of their spacing; percentage of the 10,000
                yield degradation, Case(source, source, "frames:0.3", percentage=10, sample=10000)
                continue
            if degradation == "copies":
                # 10,000 points twenty times, with noise of a hundredth of their spacing; percentage of the 10,000
                yield degradation, Case(source, source, "copies:0.01", percentage=10, sample=10000)
                continue
            if degradation == "few points":
                # 900 of 6,000, which are about as far apart as the thinnest parts are thick
                yield degradation, Case(source, source, "noise:0.1", percentage=15, sample=6000)
                continue
            if degradation == "dense noise":
                # a ball of 4 sigma holds thousands of points
                yield degradation, Case(source, source, "noise:1.5", 2500, sample=400000)
                continue
            if degradation == "laser scan":
                continue  # of no shape: below
            sparse = degradation == "sparse"
            yield degradation, Case(source, source, "clean" if sparse else degradation,
                                    percentage=1 if sparse else 10, sample=sample)
    for seed in range(1, 8):
        # 4,000 of 40,000 points of the ground, posts and wires, as a scanner sees them
        yield "laser scan", Case(f"street {seed}", "street", percentage=10, sample=40000, seed=seed)


def ablation(comparison, igea, meshes, output):
    """a table: geometric means over the shapes and seeds, as ratios to all ideas together"""
    tasks = [(degradation, case, seed, idea, parameters)
             for degradation, case in cases(igea, meshes) for seed in SEEDS
             for idea, parameters in [("", "iterations=10"), *IDEAS]]

    def measured(task):
        _, case, seed, _, parameters = task
        own_seed = [] if case.seed else ["--seed", str(seed)]
        return comparison.call([*case.options(), *own_seed, "--parameters", parameters])[-1]

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        results = list(pool.map(measured, tasks))
    found = {(degradation, case.name, seed, idea): result
             for (degradation, case, seed, idea, _), result in zip(tasks, results)}
    rows = [["without", "measure", *map(in_words, DEGRADATIONS), "all"]]
    for idea, _ in IDEAS:
        for measure, title in MEASURES:
            logarithms = {d: [] for d in DEGRADATIONS}
            for (degradation, shape, seed, name), result in found.items():
                base = found[degradation, shape, seed, ""]
                if name == idea and measure in result and measure in base:
                    logarithms[degradation].append(math.log(result[measure] / base[measure]))
            everything = sum(logarithms.values(), [])
            rows.append([idea if title == "mean" else "", title,
                         *(f"{math.exp(sum(v) / len(v)):.2f}" if v else "–"
                           for v in [*logarithms.values(), everything])])
    seeds = "one seed" if len(SEEDS) == 1 else f"{len(SEEDS)} seeds"
    return ("Error with one idea switched off, over that with all of them, as geometric means over "
            "Igea, the elephant, the anchor, the rotor, the rounded box, the wavy patch and a tree with "
            f"twigs, {seeds} each: above 1, the idea helps. Where the reconstruction drops a part of "
            "one shape by chance, a mean changes by several percent, and so do the largest errors. "
            "*Sparse*: 1 % of the points. *Scan lines*: 1,500 of 20,000 points on lines that are four "
            "times as far apart as these, with noise; *noisy* ones with noise along the rays that is as large as the "
            "distance of the points on a line. *Depth steps*: 30,000 points with a noise of "
            "0.1 %, whose depth is then rounded to steps of 1 %, along one axis, or (*steps of cameras*) "
            "each along one of three. *Frames*: each of 10,000 points ten "
            "times, with a noise of 0.3 % along one direction. *Copies*: each of 10,000 points twenty times, with a "
            "noise of 0.01 %. *Few points*: 900 of 6,000, with a noise of "
            "0.1 %. *Dense noise*: 2,500 of 400,000, with a noise of 1.5 %. *Laser scan*: 4,000 of 40,000 points of the ground, posts and wires of a street, "
            "from seven seeds, as a scanner in it sees them. Of the tree with *density 100*, "
            "fewer points are left than are asked for.\n\n"
            + write_table(output / "ablation.csv", rows))
