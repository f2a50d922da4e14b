#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs posepack_import_bench on the nine four-legged animals of the assets.

    import_bench.py EXE [options of posepack_import_bench]

Models: POSEPACK_ASSETS/animals, else ../shared/assets/animals beside the checkout; without them the run is skipped
(exit code 77), but fails where CI=true. A ratio above the target of 1.5 fails the run only with --limit 1.5.
"""

import os
import subprocess
import sys

PROJECT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
ANIMALS = ["alpaca", "bull", "deer", "donkey", "fox", "horse", "husky", "stag", "wolf"]
SKIPPED = 77


def main():
    assets = os.environ.get("POSEPACK_ASSETS") or os.path.join(PROJECT, "..", "shared", "assets")
    folder = os.path.join(assets, "animals")
    if not os.path.isdir(folder):
        print(f"skipped: no folder {folder}; POSEPACK_ASSETS names its parent")
        return 1 if os.environ.get("CI") == "true" else SKIPPED
    files = [os.path.join(folder, name + ".glb") for name in ANIMALS]
    return subprocess.run([*sys.argv[1:], *files], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
