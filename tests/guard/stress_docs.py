# SPDX-License-Identifier: MIT
"""Checks that every stress case does what is expected, and that docs/stress.md holds the table that
`posepack stress` prints; with --update writes it anew.

Usage: stress_docs.py PATH_TO_POSEPACK PATH_TO_STRESS_MD [--update]
"""
import pathlib
import re
import subprocess
import sys

BLOCK = re.compile(r"(<!-- table -->\n```text\n)(.*?)(```\n)", re.DOTALL)


def main():
    posepack, page = sys.argv[1], pathlib.Path(sys.argv[2])
    run = subprocess.run([posepack, "stress"], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        print(f"posepack stress: expected exit code 0, found {run.returncode}\n{run.stderr}")
        return 1
    text = page.read_text(encoding="utf-8")
    blocks = BLOCK.findall(text)
    if len(blocks) != 1:
        print(f"{page}: expected one table behind '<!-- table -->', found {len(blocks)}")
        return 1
    count = re.search(r"^(\d+) cases: \1 as expected, 0 not", run.stdout, re.MULTILINE)
    if not count or int(count.group(1)) < 60:
        print("expected at least 60 cases, all as expected")
        return 1
    if "--update" in sys.argv[3:]:
        page.write_text(BLOCK.sub(lambda match: match.group(1) + run.stdout + match.group(3), text), encoding="utf-8")
    elif blocks[0][1] != run.stdout:
        print(f"{page} is stale; run: python3 {' '.join(sys.argv)} --update")
        return 1
    print(f"stress_docs: {count.group(1)} cases as expected")
    return 0


if __name__ == "__main__":
    sys.exit(main())
