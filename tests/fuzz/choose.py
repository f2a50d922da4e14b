#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Chooses the inputs worth checking in: of a fuzzer's corpus, the smallest file for every outcome.

    choose.py REPLAY FUZZED-FOLDER CHECKED-IN-FOLDER [--largest BYTES]

REPLAY is a replay_* program. Outcomes are its --explain lines with numbers and quoted text left out, so that one
file remains for each refusal at each kind of place. Files already checked in stay, and count for their outcomes;
new ones are named after their outcome.
"""

import argparse
import hashlib
import os
import re
import shutil
import subprocess
import sys


def outcomes_of(replay, folder):
    """File -> what the target said of it, without what varies."""
    text = subprocess.run([replay, "--explain", folder], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          check=True).stdout.decode("utf-8", "replace")
    outcomes = {}
    for line in text.splitlines():
        path, _, outcome = line.partition("\t")
        plain = re.sub(r"'[^']*'|[-+]?\b[\d.]+(e[-+]?\d+)?\b|\bnan\b|\binf\b", "#", outcome)
        outcomes.setdefault(path, set()).add(plain)
    return outcomes


def name_of(outcome, data, ending):
    found = re.search(r"(?:error|warning)\[[EW]-([A-Z-]+)\]", outcome)
    word = (found.group(1) if found else outcome).lower().replace("-", "_")
    return f"{re.sub(r'[^a-z_]', '', word)[:40]}_{hashlib.sha256(data).hexdigest()[:8]}{ending}"


def main():
    parser = argparse.ArgumentParser(description="The smallest input for every outcome.")
    parser.add_argument("replay")
    parser.add_argument("fuzzed")
    parser.add_argument("kept")
    parser.add_argument("--largest", type=int, default=4096, help="bytes of a file that may be taken")
    arguments = parser.parse_args()

    kept = outcomes_of(arguments.replay, arguments.kept) if os.listdir(arguments.kept) else {}
    known = set().union(*kept.values()) if kept else set()
    ending = ".posepack" if "container" in arguments.replay else ".glb"
    added = 0
    fuzzed = outcomes_of(arguments.replay, arguments.fuzzed)
    for path in sorted(fuzzed, key=lambda path: (os.path.getsize(path), path)):
        new = fuzzed[path] - known
        if not new or os.path.getsize(path) > arguments.largest:
            continue
        with open(path, "rb") as file:
            name = name_of(min(new), file.read(), ending)
        shutil.copyfile(path, os.path.join(arguments.kept, name))
        known |= fuzzed[path]
        added += 1
    print(f"{len(kept)} inputs were there, {added} added, {len(known)} outcomes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
