#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Bakes every file of a folder of the assets, and compares what became of it with the checked-in table.

    run.py FOLDER --binary build/release/posepack [--project DIR] [--sanitized] [--update]

FOLDER is animals, features or invalid. Each file is baked alone: the exit code and the issue must equal the
table's, a refusal is one line and publishes nothing, no signal, and less than 2 s and 128 MiB. The table itself
must obey rules.py. --update writes the table from what the program does, by the same rules.
"""

import argparse
import concurrent.futures
import json
import os
import re
import subprocess
import sys
import tempfile
import threading

import rules
import table

WORKERS = 2
LIMIT_S = 2.0  # of processor time: a busy machine stretches the clock, not the work
LIMIT_MIB = 128.0
KILL_AFTER_S = 60.0
SKIPPED = 77
LEAST_FILES = {"animals": 49, "features": 105, "invalid": 330}


class Outcome:
    """What one run did. `issue` is that of its error line, or "-"."""

    def __init__(self, exit_code, usage, stderr, published):
        self.exit_code, self.stderr, self.published = exit_code, stderr, published
        self.cpu_s = usage.ru_utime + usage.ru_stime
        self.peak_mib = usage.ru_maxrss / 1024
        self.errors = [line for line in stderr.splitlines() if line.startswith("posepack: error[")]
        found = re.match(r"posepack: error\[([^]]*)\]", self.errors[0]) if self.errors else None
        self.issue = found.group(1) if found else rules.NOT_COUNTED


def bake(binary, path, scratch):
    """Bakes one model in a folder of its own, with the error measured."""
    with tempfile.TemporaryDirectory(dir=scratch) as folder:
        catalog, out = os.path.join(folder, "catalog.json"), os.path.join(folder, "out")
        with open(catalog, "w", encoding="utf-8") as file:
            json.dump({"schema": 1, "animals": {"model": {"model": os.path.basename(path)}}}, file)
        with open(os.path.join(folder, "stderr"), "w+b") as stderr:
            process = subprocess.Popen([binary, "bake", catalog, "--models", os.path.dirname(path), "-o", out,
                                        "--no-fsync", "-j1"], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                       stderr=stderr)
            timer = threading.Timer(KILL_AFTER_S, process.kill)
            timer.start()
            _, status, usage = os.wait4(process.pid, 0)  # the peak of this child alone
            timer.cancel()
            process.returncode = os.waitstatus_to_exitcode(status)
            stderr.seek(0)
            text = stderr.read().decode("utf-8", "replace")
        published = sorted(set(os.listdir(out)) - {".posepack.lock"}) if os.path.isdir(out) else []
        return Outcome(process.returncode, usage, text, published)


def faults_of_run(outcome, row, sanitized):
    faults = []
    if (outcome.exit_code, outcome.issue) != (row.exit_code, row.issue):
        faults.append(f"expected {row.exit_code} {row.issue}, found {outcome.exit_code} {outcome.issue}: "
                      f"{outcome.stderr[:300]}")
    if outcome.exit_code < 0:
        faults.append(f"ended by signal {-outcome.exit_code}")
    if outcome.exit_code == 0:
        if outcome.published != ["manifest.json", "model.posepack"] or outcome.errors:
            faults.append(f"expected a palette, a manifest and no error line, found {outcome.published}")
    elif outcome.published or len(outcome.errors) != 1 or not outcome.stderr.endswith("\n"):
        faults.append(f"expected one error line and nothing published, found {len(outcome.errors)} lines and "
                      f"{outcome.published}")
    if not sanitized and (outcome.cpu_s >= LIMIT_S or outcome.peak_mib >= LIMIT_MIB):
        faults.append(f"expected less than {LIMIT_S} s and {LIMIT_MIB} MiB, found {outcome.cpu_s:.2f} s and "
                      f"{outcome.peak_mib:.0f} MiB")
    return faults


def find_assets(folder, project):
    """The folder of assets; ends the run as skipped, or failed under CI, where there is none."""
    assets = os.environ.get("POSEPACK_ASSETS") or os.path.join(project, "..", "shared", "assets")
    if os.path.isdir(os.path.join(assets, folder)):
        return assets
    print(f"SKIPPED: expected models in {assets}/{folder}; set POSEPACK_ASSETS")
    sys.exit(1 if os.environ.get("CI") == "true" else SKIPPED)


def row_by_rule(folder, file, outcome, readme_row, is_moving):
    """The row that rules.py makes of an outcome."""
    row = table.Row(file, outcome.exit_code, outcome.issue)
    if folder == "invalid":
        row.verdict = rules.verdict_of(readme_row.split(" | ")[1])
        row.sentence = rules.invalid_sentence(row, is_moving)
    else:
        row.sentence = rules.feature_sentence(row, readme_row)
    return row


def compare(folder, row, ruled, is_moving, exits):
    """What is wrong with the table's row, seen beside the rules."""
    faults = rules.faults_of(row, exits, is_moving, folder == "invalid")
    if row.verdict != ruled.verdict:
        faults.append(f"the README's verdict is '{ruled.verdict}', the table says '{row.verdict}'")
    return faults


def run_folder(arguments, assets, files, expected):
    """Runs all files; returns the rows by rule and the number of faults."""
    exits = rules.issue_exits(arguments.project)
    with open(os.path.join(assets, "README.md"), encoding="utf-8") as file:
        readme = table.readme_rows(file.read())
    rows, faults_found = [], 0
    with tempfile.TemporaryDirectory(prefix="posepack-corpus-") as scratch, \
            concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
        paths = [os.path.join(assets, arguments.folder, file) for file in files]
        outcomes = pool.map(lambda path: bake(arguments.binary, path, scratch), paths)
        for file, path, outcome in zip(files, paths, outcomes):
            is_moving = rules.moves(path)
            ruled = row_by_rule(arguments.folder, file, outcome, readme.get(file, "| ? | ? |"), is_moving)
            row = ruled if arguments.update else expected.get(file)
            faults = ["expected a row in the table, found none"] if row is None else \
                compare(arguments.folder, row, ruled, is_moving, exits) + \
                faults_of_run(outcome, row, arguments.sanitized)
            print(f"{'FAIL' if faults else 'ok  '} {file}: {outcome.exit_code} {outcome.issue} "
                  f"({outcome.cpu_s:.2f} s, {outcome.peak_mib:.0f} MiB)")
            for fault in faults:
                print(f"     {fault}")
            faults_found += len(faults)
            rows.append(ruled)
    return rows, faults_found


def parse():
    parser = argparse.ArgumentParser(description="Files of others against a table of results.")
    parser.add_argument("folder", choices=sorted(LEAST_FILES))
    parser.add_argument("--binary", required=True, type=os.path.abspath, help="the program to test")
    parser.add_argument("--project", default=os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
    parser.add_argument("--sanitized", action="store_true", help="no limits on time and memory")
    parser.add_argument("--update", action="store_true", help="write the table")
    return parser.parse_args()


def main():
    arguments = parse()
    assets = find_assets(arguments.folder, arguments.project)
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), arguments.folder + ".txt")
    expected = {}
    if not arguments.update:
        with open(path, encoding="utf-8") as file:
            expected = table.parse(file.read())
    files = sorted(name for name in os.listdir(os.path.join(assets, arguments.folder)) if name.endswith(".glb"))
    rows, faults = run_folder(arguments, assets, files, expected)
    missing = sorted(set(expected) - set(files))
    if missing or len(files) < LEAST_FILES[arguments.folder]:
        print(f"FAIL expected {LEAST_FILES[arguments.folder]} files or more, found {len(files)}; missing: {missing}")
        faults += 1
    baked = sum(row.exit_code == 0 for row in rows)
    print(f"{arguments.folder}: {len(rows)} files, {baked} bake, {len(rows) - baked} refused, {faults} faults")
    if arguments.update:
        with open(path, "w", encoding="utf-8") as file:
            file.write(table.render(rows))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
