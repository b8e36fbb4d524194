"""Tables and plots from the results of the comparison. Nothing in them is typed."""

import collections
import csv

import comparison

COLUMNS = [("recon_mean", "recon mean"), ("recon_p99", "p99"), ("recon_max", "max"),
           ("distance_mean", "Δ mean"), ("distance_max", "Δ max"), ("delta_mls", "Δ MLS"),
           ("far_share", "far"), ("m", "m"), ("spacing_variation", "CV")]
RATIOS = {"recon_mean": "recon mean", "recon_p99": "p99", "recon_max": "max", "distance_mean": "Δ mean"}


def number(value):
    return "–" if value is None else f"{value:.2e}" if value and value < 0.01 else f"{value:.3g}"


def table(results):
    """one row for each method at its default, and one for its best setting"""
    best = min((r["recon_mean"] for r in peers_of(comparison.selected(results))), default=None)
    has_border = any("border_max" in r for r in results)
    columns = COLUMNS + ([("border_max", "border max")] if has_border else [])
    lines = ["| method | setting | points | " + " | ".join(title for _, title in columns)
             + " | s | MB |", "|---" * (len(columns) + 5) + "|"]
    seen = collections.Counter()
    for r in comparison.selected(results):
        seen[r["method"]] += 1
        setting = r.get("setting") or ""
        if seen[r["method"]] == 2:
            setting = "**tuned:** " + setting
        if "recon_mean" not in r:
            lines.append(f"| {r['method']} | {setting} | failed: {r.get('error', 'no result')} |"
                         + " |" * (len(columns) + 2))
            continue
        values = [number(r.get(key)) for key, _ in columns]
        if r["recon_mean"] == best:
            values[0] = f"**{values[0]}**"
        seconds = f"{r['seconds']:.2f}" if r.get("seconds") is not None else "–"
        if r.get("timed") == "process":
            seconds += " (process)"
        memory = f"{r['peak_bytes'] / 1e6:.0f}" if r.get("peak_bytes") else "–"
        lines.append(f"| {r['method']} | {setting} | {r['points']:,} | " + " | ".join(values)
                     + f" | {seconds} | {memory} |")
    return "\n".join(lines) + "\n"


def peers_of(results):
    return [r for r in results if "recon_mean" in r and not r["method"].startswith("this package")
            and r["method"] != comparison.EDGE_COLLAPSE]


def is_function_of_cgal(method):
    """or a chain of them; averages in voxels are what users have in their place"""
    return method.startswith(("CGAL", "remove_outliers", "jet_smooth", "voxel centroids"))


def best_peers(results):
    """of each measure: the result of a peer with the least; None if all are exact"""
    best = {}
    for key in RATIOS:
        # a subset of a clean input has no distance at all
        counts = [r for r in peers_of(results) if key != "distance_mean" or r[key] > 1e-9]
        best[key] = min(counts, key=lambda r: r[key], default=None)
    return best


def over_best_peers(results):
    """of each measure: this package at its defaults over the best tuned peer"""
    ours = comparison.settings_of(results, "this package")[0]
    return {key: ours[key] / peer[key] if peer else float("nan")
            for key, peer in best_peers(results).items()}


def ratios(all_results):
    """this package at its defaults over the best of all tuned peers, for each case"""
    lines = ["| case | " + " | ".join(RATIOS.values()) + " | best peer by mean |",
             "|---" * (len(RATIOS) + 2) + "|"]
    for case, results in all_results.items():
        if not comparison.settings_of(results, "this package") or not peers_of(results):
            continue
        by_mean = best_peers(results)["recon_mean"]
        lines.append(f"| {case} | "
                     + " | ".join(f"{v:.2f}" for v in over_best_peers(results).values())
                     + f" | {by_mean['method']}, {by_mean.get('setting', '')} |")
    return "\n".join(lines) + "\n"


def write_csv(file, results):
    """all results, flat"""
    flat = [{**{k: v for k, v in r.items() if k != "stages"},
             **{f"{k}_seconds": v for k, v in r.get("stages", {}).items()}} for r in results]
    first = ["case", "method", "setting", "points", "error"]
    fields = first + sorted({key for r in flat for key in r} - set(first) - {"file", "input"})
    with open(file, "w", newline="") as stream:
        writer = csv.DictWriter(stream, fields, extrasaction="ignore")
        writer.writeheader()
        writer.writerows(flat)


def write_table(file, rows):
    """a table of the paper: rows of equal length, the first with the titles"""
    with open(file, "w", newline="") as stream:
        csv.writer(stream).writerows(rows)
    lines = ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join([lines[0], "|---" * len(rows[0]) + "|", *lines[1:]]) + "\n"


def stages(results):
    """of this package at its defaults"""
    ours = comparison.settings_of(results, "this package")
    if not ours or "stages" not in ours[0]:
        return ""
    parts = ", ".join(f"{k} {1000 * v:.0f}" for k, v in ours[0]["stages"].items())
    return f"Stages of this package, in ms: {parts}.\n"
