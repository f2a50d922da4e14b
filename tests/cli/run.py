#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs every row of the command-line tests against a built posepack, and says what failed.

    run.py --binary build/release/posepack [--project DIR] [--sanitized] [--keep] [ROW ...]

Without names all rows run. A row may be skipped with a reason that is printed; a run of no rows fails.
"""

import argparse
import os
import shutil
import sys
import tempfile
import time
import traceback

import behaviour_rows
import catalog_rows
import command_rows
import container_rows
import doctor_rows
import environment_rows
import glb_rows
import limit_rows
import manifest_rows
import matrix_rows
import mutation_rows
import repair_rows
import report_rows
import storage_rows
from harness import Case, Skip

MODULES = [glb_rows, storage_rows, matrix_rows, repair_rows, limit_rows, catalog_rows, container_rows, manifest_rows,
           environment_rows, behaviour_rows, command_rows, report_rows, doctor_rows, mutation_rows]


class Settings:
    """What every case knows of the run."""

    def __init__(self, arguments, scratch):
        self.binary = os.path.abspath(arguments.binary)
        self.project = os.path.abspath(arguments.project)
        self.sanitized = arguments.sanitized
        self.scratch = scratch


def parse():
    parser = argparse.ArgumentParser(description="Tests of the posepack command line.")
    parser.add_argument("--binary", required=True, help="the program to test")
    parser.add_argument("--project",
                        default=os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."),
                        help="root of the project, for its sample catalogs")
    parser.add_argument("--sanitized", action="store_true", help="no limits on time and memory")
    parser.add_argument("--keep", action="store_true", help="keep the scratch folder")
    parser.add_argument("--verbose", action="store_true", help="name every row")
    parser.add_argument("rows", nargs="*", help="names of rows (default: all)")
    return parser.parse_args()


def chosen_rows(names):
    rows = [row for module in MODULES for row in module.ROWS]
    known = [row.name for row in rows]
    doubled = sorted({name for name in known if known.count(name) > 1})
    missing = sorted(set(names) - set(known))
    if doubled or missing:
        sys.exit(f"rows named twice: {doubled}; rows asked for that do not exist: {missing}")
    return [row for row in rows if not names or row.name in names]


def run_row(settings, row):
    """Runs one row. Returns its case, and why it was skipped or None."""
    case = Case(settings, tempfile.mkdtemp(prefix=row.name + "-", dir=settings.scratch))
    os.chmod(case.folder, 0o755)  # so that another user can be tried in it
    skipped = None
    try:
        row.run(case)
    except Skip as reason:
        skipped = str(reason)
    except Exception:  # pylint: disable=broad-except  # one broken row must not hide the others
        case.faults.append(traceback.format_exc().strip())
    return case, skipped


def run_all(settings, rows, verbose):
    counts = {"run": 0, "skipped": 0, "failed": 0}
    for row in rows:
        start = time.monotonic()
        case, skipped = run_row(settings, row)
        if skipped is not None:
            counts["skipped"] += 1
            print(f"skip {row.name}: {row.title}: {skipped}")
        else:
            counts["run"] += 1
        if case.faults:
            counts["failed"] += 1
            print(f"FAIL {row.name}: {row.title}")
            for fault in case.faults:
                print("     " + fault.replace("\n", "\n     "))
        elif verbose and skipped is None:
            print(f"ok   {row.name}: {row.title} ({time.monotonic() - start:.2f} s)")
        for note in case.notes:
            print(f"note {row.name}: {note}")
    return counts


def main():
    arguments = parse()
    rows = chosen_rows(arguments.rows)
    scratch = tempfile.mkdtemp(prefix="posepack-cli-")
    os.chmod(scratch, 0o755)
    start = time.monotonic()
    try:
        counts = run_all(Settings(arguments, scratch), rows, arguments.verbose)
    finally:
        if arguments.keep:
            print(f"kept {scratch}")
        else:
            shutil.rmtree(scratch, ignore_errors=True)
    print(f"command-line rows: {counts['run']} run, {counts['skipped']} skipped, {counts['failed']} failed "
          f"in {time.monotonic() - start:.1f} s")
    if counts["run"] == 0:
        print("expected some rows to run, found none")
    return 1 if counts["failed"] or counts["run"] == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
