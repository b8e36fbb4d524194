#!/usr/bin/env python3
"""Runs every method on inputs and collects the measures of the results.

Each method runs in a process of its own with a limit of time. A method that fails, or runs out of
its time, gets a row that says so.
"""

import json
import pathlib
import subprocess
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
EDGE_COLLAPSE = "quadric edge collapse (no peer: it is given the mesh)"


def in_words(degradation):
    return degradation.replace(":", " ").replace("_", " ")


class Case:
    """an input, what is done to it, and the number of output points"""

    def __init__(self, name, source, degradation="clean", count=None, percentage=None, sample=None,
                 seed=0):
        self.name, self.source, self.degradation = name, str(source), degradation
        self.count, self.percentage, self.sample, self.seed = count, percentage, sample, seed

    def options(self):
        options = ["--input", self.source, "--degradation", self.degradation]
        if self.count:
            options += ["--count", str(self.count)]
        if self.percentage:
            options += ["--percentage", str(self.percentage)]
        if self.sample:
            options += ["--sample", str(self.sample)]
        if self.seed:
            options += ["--seed", str(self.seed)]
        return options

    def title(self):
        return f"{self.name}, {in_words(self.degradation)}"


class Comparison:
    def __init__(self, program, folder, seconds=300, tuned=True, timed=True):
        self.program, self.folder, self.seconds = str(program), pathlib.Path(folder), seconds
        self.tuned, self.timed = tuned, timed
        self.folder.mkdir(parents=True, exist_ok=True)

    def call(self, options):
        """the results of one process; those before a failure count, and the failure is one more"""
        command = [self.program, *options]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=self.seconds)
            output, error = done.stdout, None
            if done.returncode != 0:
                lines = done.stderr.strip().splitlines()
                error = lines[-1] if lines else f"ended with {done.returncode}"
        except subprocess.TimeoutExpired as expired:
            output = expired.stdout.decode() if expired.stdout else ""
            error = f"stopped after {self.seconds} s"
        results = [json.loads(line) for line in output.splitlines() if line.endswith("}")]
        return results + ([{"error": error}] if error else [])

    def methods(self):
        listed = subprocess.run([self.program, "--list"], capture_output=True, text=True, check=True)
        return list(json.loads(listed.stdout))

    def file(self, case):
        return self.folder / (case.title().replace(",", "").replace(" ", "_") + ".jsonl")

    def read(self, case):
        """the results of an earlier run"""
        with open(self.file(case)) as file:
            return [json.loads(line) for line in file]

    def results(self, case, external=None, reuse=False, rerun=None):
        """of an earlier run as far as they are wanted and there: all with `reuse`, or those of the
        methods whose names do not start with `rerun`"""
        earlier = self.read(case) if (reuse or rerun) and self.file(case).exists() else []
        if earlier and not rerun:
            return earlier
        return self.run(case, external, [r for r in earlier if not r["method"].startswith(rerun)])

    def run(self, case, external=None, kept=()):
        """all settings of all methods but those with results that are kept; returns and stores the
        list of results"""
        results, kept_methods = [], {result["method"] for result in kept}
        for method in self.methods() + [EDGE_COLLAPSE]:
            if method in kept_methods:
                results += [result for result in kept if result["method"] == method]
                continue
            begin = time.monotonic()
            new = self.call([*case.options(), "--method", method,
                             *([] if self.tuned else ["--defaults-only"])])
            results += [{**result, "method": method} for result in new]
            print(f"{case.title()}: {method}, {time.monotonic() - begin:.0f} s", flush=True)
        if external and not kept:
            results += self.run_external(case, external)
        if self.timed:
            self.time_again(case, [r for r in results if r["method"] not in kept_methods])
        results += [r for r in kept if r["method"] not in {result["method"] for result in results}]
        name = pathlib.Path(case.source).name
        results = [{**result, "case": case.title(), "input": name} for result in results]
        with open(self.file(case), "w") as file:
            file.writelines(json.dumps(result) + "\n" for result in results)
        return results

    def call_external(self, case, external, folder, methods=None):
        """programs outside read and write files; `folder` then has their points and an index"""
        points = pathlib.Path(folder) / "input.ply"
        self.call([*case.options(), "--write-input", str(points)])
        count = self.call([*case.options(), "--parameters", "iterations=0"])[0]["count"]
        subprocess.run(["/usr/bin/python3", str(external), str(points), str(folder), "--count",
                        str(count), "--timeout", str(self.seconds),
                        *(["--methods", ",".join(methods)] if methods else [])], check=False)

    def run_external(self, case, external):
        """all settings of the programs outside, measured like the others"""
        results = []
        with tempfile.TemporaryDirectory() as folder:
            self.call_external(case, external, folder)
            index = pathlib.Path(folder) / "index.jsonl"
            for line in index.read_text().splitlines() if index.exists() else []:
                entry = json.loads(line)
                if entry.get("file"):
                    file = pathlib.Path(folder) / entry["file"]
                    measured = self.call([*case.options(), "--measure", str(file)])[0]
                    entry = {**measured, **{k: v for k, v in entry.items() if v is not None}}
                results.append(entry)
        return results

    def time_again(self, case, results):
        """The setting that counts is called four times more, and the median of the last three is
        its time: what ran in the search may have been disturbed."""
        for best in selected(results):
            if best.get("timed") or not best.get("setting") or "error" in best:
                continue
            again = self.call([*case.options(), "--method", best["method"], "--setting",
                               best["setting"], "--rounds", "4", "--time-only"])
            if again and "seconds" in again[-1]:
                best["seconds"] = again[-1]["seconds"]


def write_outputs(comparison, case, results, external, folder):
    """the points of the best setting of each method as files: [(method, file)]"""
    folder = pathlib.Path(folder)
    best = [settings[0] for settings in map(lambda m: sorted(settings_of(results, m),
            key=lambda r: r["recon_mean"]), dict.fromkeys(r["method"] for r in results)) if settings]
    written = []
    for i, result in enumerate(best):
        if result["method"] != EDGE_COLLAPSE and not result.get("timed"):
            file = folder / f"{i}.ply"
            comparison.call([*case.options(), "--method", result["method"], "--setting",
                             result["setting"], "--write", str(file)])
            written.append((result["method"], file))
    outside = [result["method"] for result in best if result.get("timed")]
    if outside and external:
        comparison.call_external(case, external, folder, outside)
        written += [(r["method"], folder / r["file"]) for r in best
                    if r.get("timed") and (folder / r["file"]).exists()]
    return written


def settings_of(results, method):
    return [r for r in results if r["method"] == method and "recon_mean" in r]


def selected(results):
    """for each method its first setting, the default, and the one of the best mean error"""
    chosen = []
    for method in dict.fromkeys(r["method"] for r in results):
        settings = settings_of(results, method)
        if settings:
            chosen.append(settings[0])
            best = min(settings, key=lambda r: r["recon_mean"])
            if best is not settings[0]:
                chosen.append(best)
        else:
            chosen.append(next(r for r in results if r["method"] == method))
    return chosen
