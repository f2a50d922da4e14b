#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Baking speed against three.js: whole processes, side by side, taking turns.

    bench.py --posepack EXE [--rounds N] [--json FILE] [--markdown FILE] [--check]

Bakes the nine four-legged animals of the assets with posepack (without and with measuring its error, on all cores
and on one) and with three.js in Node (three_bake.mjs: every clip, frame by frame, to half floats in memory,
nothing written). Each round runs every contender once, in an order that moves on from round to round. Times
are wall clock of the process from start to end; memory is its largest resident set. Prints the machine, what
was run, medians with the smallest and largest value, and whether the targets hold; targets are judged by the
median of the ratios within a round. A target that falls short fails the run only under --check.

Models: POSEPACK_ASSETS/animals, else ../shared/assets/animals beside the checkout; without them the run is
skipped (exit code 77), but fails where CI=true.
"""

import argparse
import json
import os
import platform
import statistics
import subprocess
import sys
import tempfile
import time

PROJECT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
CATALOG = os.path.join(PROJECT, "tests", "data", "real_animals.json")
THREE_BAKE = os.path.join(PROJECT, "tests", "bench", "three_bake.mjs")
ANIMALS = ["alpaca", "bull", "deer", "donkey", "fox", "horse", "husky", "stag", "wolf"]

LEAST_SPEED = 5.0  # three.js / posepack without measuring
MOST_MEASURED = 3.0  # posepack with measuring / three.js
MOST_PEAK_MIB = 64.0
MOST_START_MS = 10.0  # posepack --help
SKIPPED = 77
MIN_ROUNDS = 5
START_RUNS = 21


# ---- Running ----

def run_once(command):
    """Runs a command, output thrown away. Returns (wall seconds, CPU seconds, peak resident MiB)."""
    begin = time.perf_counter()
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE)
    said = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    wall_s = time.perf_counter() - begin
    process.returncode = os.waitstatus_to_exitcode(status)
    process.stderr.close()
    if process.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit code {process.returncode}\n{said.decode(errors='replace')}")
    bytes_per_unit = 1 if sys.platform == "darwin" else 1024
    return wall_s, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * bytes_per_unit / 2**20


def contenders(options, models, scratch):
    """What is compared: key -> (title, command)."""

    def bake(folder, *more):
        return [options.posepack, "-q", "bake", CATALOG, "--models", models, "--only", ",".join(ANIMALS),
                "-o", os.path.join(scratch, folder), "--no-fsync", *more]

    files = [os.path.join(models, f"{name}.glb") for name in ANIMALS]
    return {
        "bake": ("posepack, not measured", bake("a", "--no-measure")),
        "bake_one_job": ("posepack, not measured, 1 job", bake("a1", "--no-measure", "--jobs", "1")),
        "measured": ("posepack, error measured", bake("b")),
        "measured_one_job": ("posepack, error measured, 1 job", bake("b1", "--jobs", "1")),
        "three": ("three.js in Node", ["node", THREE_BAKE, *files]),
    }


def run_rounds(commands, rounds):
    """Samples of every contender: key -> list of run_once results, one a round. One more round warms up."""
    samples = {key: [] for key in commands}
    keys = list(commands)
    for turn in range(rounds + 1):
        shift = turn % len(keys)
        for key in keys[shift:] + keys[:shift]:
            result = run_once(commands[key][1])
            if turn > 0:
                samples[key].append(result)
        print(f"round {turn} of {rounds}" if turn else "warmed up", file=sys.stderr)
    return samples


# ---- What was run, and where ----

def first_line(command):
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        return done.stdout.strip().splitlines()[0]
    except (OSError, subprocess.CalledProcessError, IndexError):
        return "unknown"


def cpu_name():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            for line in file:
                if line.startswith("model name"):
                    return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()


def three_version():
    path = os.path.join(PROJECT, "tests", "node", "node_modules", "three", "package.json")
    with open(path, encoding="utf-8") as file:
        return json.load(file)["version"]


def describe(options, models):
    git = ["git", "-c", f"safe.directory={PROJECT}", "-C", PROJECT]
    state = subprocess.run([*git, "status", "--porcelain"], capture_output=True, text=True, check=False).stdout
    sizes = [os.path.getsize(os.path.join(models, f"{name}.glb")) for name in ANIMALS]
    return {
        "cpu": cpu_name(),
        "cores": len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count(),
        "kernel": f"{platform.system()} {platform.release()}",
        "load": " ".join(f"{load:.2f}" for load in os.getloadavg()),
        "commit": first_line([*git, "rev-parse", "HEAD"]) + (", with changes" if state else ""),
        "posepack": first_line([options.posepack, "--version"]),
        "node": f"{first_line(['node', '--version'])}, three.js {three_version()}",
        "inputs": f"{', '.join(ANIMALS)} ({len(ANIMALS)} GLBs, {sum(sizes) / 1e6:.1f} MB)",
    }


def baked_amounts(commands):
    """How much each side bakes, so that a reader can see they do the same: text."""
    shown = subprocess.run([*commands["bake"][1], "--format", "json"], capture_output=True, text=True, check=True)
    records = json.loads(shown.stdout)["records"]
    rows = [sum(clip["row_count"] for clip in record["clips"]) for record in records]
    matrices = sum(count * record["bone_count"] for count, record in zip(rows, records))
    three = json.loads(subprocess.run(commands["three"][1], capture_output=True, text=True, check=True).stdout)
    return (f"posepack {sum(rows)} rows, {matrices} matrices (a loop does not store its last pose twice); "
            f"three.js {three['rows']} rows, {three['matrices']} matrices")


# ---- Results ----

def spread(values):
    return {"median": statistics.median(values), "min": min(values), "max": max(values)}


def summarise(samples):
    """key -> wall_ms, cpu_ms and peak_mib, each with median, min and max."""
    names = [("wall_ms", 0, 1e3), ("cpu_ms", 1, 1e3), ("peak_mib", 2, 1.0)]
    return {key: {name: spread([run[place] * scale for run in runs]) for name, place, scale in names}
            for key, runs in samples.items()}


def round_ratios(samples, over, under, place=0):
    """Ratios within each round: of wall clock, or of CPU time with place 1."""
    return spread([a[place] / b[place] for a, b in zip(samples[over], samples[under])])


def cpu_ratios(samples):
    """The ratios of the targets in CPU time: of use where other work disturbs the wall clock."""
    return {"three / bake": round_ratios(samples, "three", "bake", 1),
            "measured / three": round_ratios(samples, "measured", "three", 1)}


def judge(samples, summary, start_ms):
    """The targets: list of {name, found, unit, target, holds}."""

    def target(name, found, unit, sign, limit):
        holds = found["median"] >= limit if sign == ">=" else found["median"] <= limit
        return {"name": name, "found": found, "unit": unit, "target": f"{sign} {limit:g}{unit}", "holds": holds}

    peaks = [summary[key]["peak_mib"] for key in summary if key != "three"]
    peak = {name: max(p[name] for p in peaks) for name in ("median", "min", "max")}
    speed = round_ratios(samples, "three", "bake")
    measured = round_ratios(samples, "measured", "three")
    return [
        target("three.js / posepack, not measured", speed, " x", ">=", LEAST_SPEED),
        target("posepack, measured / three.js", measured, " x", "<=", MOST_MEASURED),
        target("peak memory of posepack", peak, " MiB", "<=", MOST_PEAK_MIB),
        target("start of posepack --help", start_ms, " ms", "<=", MOST_START_MS),
    ]


def table(titles, summary, markdown):
    """Lines of the table of times and memory."""
    rows = [["", "wall ms", "least..most", "CPU ms", "peak MiB"]]
    for key, entry in summary.items():
        wall = entry["wall_ms"]
        rows.append([titles[key], f"{wall['median']:.0f}", f"{wall['min']:.0f}..{wall['max']:.0f}",
                     f"{entry['cpu_ms']['median']:.0f}", f"{entry['peak_mib']['max']:.1f}"])
    if markdown:
        rows.insert(1, ["---", "---:", "---:", "---:", "---:"])
        return ["| " + " | ".join(row) + " |" for row in rows]
    widths = [max(len(row[c]) for row in rows) for c in range(len(rows[0]))]
    return ["  ".join(cell.ljust(widths[c]) if c == 0 else cell.rjust(widths[c]) for c, cell in enumerate(row))
            for row in rows]


def verdict_lines(verdicts):
    for verdict in verdicts:
        found = verdict["found"]
        yield (f"{'PASS       ' if verdict['holds'] else 'FALLS SHORT'}  {verdict['name']}: "
               f"{found['median']:.2f}{verdict['unit']} ({found['min']:.2f}..{found['max']:.2f}), "
               f"target {verdict['target']}")


def report_text(result, titles):
    """The whole report as text, and the table as Markdown."""
    about = [f"{name:9} {text}" for name, text in result["about"].items()]
    markdown = table(titles, result["contenders"], True)
    cpu = ", ".join(f"{name} {found['median']:.2f} x" for name, found in result["cpu_ratios"].items())
    verdicts = [*verdict_lines(result["targets"]), f"The same ratios in CPU time, no target: {cpu}"]
    parts = [about, table(titles, result["contenders"], False), verdicts, markdown]
    return "\n\n".join("\n".join(part) for part in parts), "\n".join(markdown) + "\n"


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--posepack", required=True, help="the compiler")
    parser.add_argument("--rounds", type=int, default=7, help=f"at least {MIN_ROUNDS} (default: 7)")
    parser.add_argument("--json", help="file for all figures")
    parser.add_argument("--markdown", help="file for the table")
    parser.add_argument("--check", action="store_true", help="fail when a target falls short")
    options = parser.parse_args()
    if options.rounds < MIN_ROUNDS:
        parser.error(f"--rounds: expected at least {MIN_ROUNDS}, found {options.rounds}")
    return options


def measure(options, models):
    with tempfile.TemporaryDirectory(prefix="posepack-bench-") as scratch:
        commands = contenders(options, models, scratch)
        about = describe(options, models)
        about["baked"] = baked_amounts(commands)
        for key in ("bake", "three"):
            about[f"{key} runs"] = " ".join(commands[key][1]).replace(scratch, "TMP").replace(models, "MODELS")
        samples = run_rounds(commands, options.rounds)
        start_ms = spread([run_once([options.posepack, "--help"])[0] * 1e3 for _ in range(START_RUNS)])
    summary = summarise(samples)
    result = {"about": about, "rounds": options.rounds, "contenders": summary,
              "targets": judge(samples, summary, start_ms), "cpu_ratios": cpu_ratios(samples)}
    return result, {key: title for key, (title, _) in commands.items()}


def write_file(path, text):
    if path:
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)


def main():
    options = parse_options()
    assets = os.environ.get("POSEPACK_ASSETS") or os.path.join(PROJECT, "..", "shared", "assets")
    models = os.path.join(os.path.abspath(assets), "animals")
    if not os.path.isdir(models):
        print(f"skipped: no folder {models}; POSEPACK_ASSETS names its parent")
        return 1 if os.environ.get("CI") == "true" else SKIPPED
    result, titles = measure(options, models)
    text, markdown = report_text(result, titles)
    print(text)
    write_file(options.json, json.dumps(result, indent=1) + "\n")
    write_file(options.markdown, markdown)
    return 1 if options.check and not all(target["holds"] for target in result["targets"]) else 0


if __name__ == "__main__":
    sys.exit(main())
