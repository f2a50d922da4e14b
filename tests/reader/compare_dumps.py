#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares what two readers say of the same containers: the C loader and the one written from the specification.

    compare_dumps.py [--refusals-agree] DUMP_TOOL PATH...

DUMP_TOOL is the built dump_container. A PATH is a container or a folder that is searched for `*.posepack`. Every line
of both dumps must be equal. A refused file is a failure, unless --refusals-agree is given: then both readers must
refuse it with the same result. Fails when nothing was compared.
"""
import argparse
import pathlib
import subprocess
import sys

import posepack_reader


def containers(paths):
    for path in paths:
        yield from sorted(path.rglob("*.posepack")) if path.is_dir() else [path]


def first_difference(ours, theirs):
    """A sentence about the first line that differs, or None."""
    for number, (our_line, their_line) in enumerate(zip(ours, theirs), 1):
        if our_line != their_line:
            return f"line {number}: specification says `{our_line}`, loader says `{their_line}`"
    if len(ours) != len(theirs):
        return f"specification has {len(ours)} lines, loader has {len(theirs)}"
    return None


def compare(tool, path):
    """The dump of one file, and what is wrong with it (None if nothing is)."""
    ours = posepack_reader.dump_bytes(path.read_bytes())
    run = subprocess.run([tool, path], stdout=subprocess.PIPE, check=False)
    if run.returncode != 0:
        return ours, f"the dump tool ended with {run.returncode}"
    return ours, first_difference(ours, run.stdout.decode("ascii").splitlines())


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--refusals-agree", action="store_true")
    parser.add_argument("tool")
    parser.add_argument("paths", nargs="+", type=pathlib.Path)
    options = parser.parse_args()
    opened = refused = failed = matrices = rows = samples = 0
    results = set()
    for path in containers(options.paths):
        lines, problem = compare(options.tool, path)
        if lines[0].startswith("refused"):
            refused += 1
            results.add(lines[0].split()[1])
            if problem is None and not options.refusals_agree:
                problem = lines[0]
        else:
            opened += 1
            bone_rows = [line for line in lines if line.startswith("row ")]
            matrices += len(bone_rows)
            rows += sum(" bone 0 " in line for line in bone_rows)
            samples += sum(line.startswith("sample ") for line in lines)
        if problem is not None:
            failed += 1
            print(f"{path}: {problem}")
    print(f"compared {opened + refused} files: {opened} opened with {rows} rows, {matrices} matrices of rows "
          f"and {samples} of phases, {refused} refused ({', '.join(sorted(results)) or 'none'}); {failed} differ")
    if samples == 0:
        print("nothing was compared")
    return 1 if failed or samples == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
