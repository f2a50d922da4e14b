# SPDX-License-Identifier: MIT
"""Checks that every stress case does what is expected, and that docs/stress.md holds what `posepack stress` and
`posepack stress --list` print; with --update writes them anew.

Usage: stress_docs.py PATH_TO_POSEPACK PATH_TO_STRESS_MD [--update]
"""
import pathlib
import re
import subprocess
import sys


def block_of(name):
    return re.compile(rf"(<!-- {name} -->\n```text\n)(.*?)(```\n)", re.DOTALL)


def main():
    posepack, page = sys.argv[1], pathlib.Path(sys.argv[2])
    update = "--update" in sys.argv[3:]
    run = subprocess.run([posepack, "stress"], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        print(f"posepack stress: expected exit code 0, found {run.returncode}\n{run.stderr}")
        return 1
    count = re.search(r"^(\d+) cases: \1 as expected, 0 not", run.stdout, re.MULTILINE)
    if not count or int(count.group(1)) < 60:
        print("expected at least 60 cases, all as expected")
        return 1
    listed = subprocess.run([posepack, "stress", "--list"], capture_output=True, text=True, check=True)
    text = page.read_text(encoding="utf-8")
    for name, printed in (("table", run.stdout), ("list", listed.stdout)):
        blocks = block_of(name).findall(text)
        if len(blocks) != 1:
            print(f"{page}: expected one block behind '<!-- {name} -->', found {len(blocks)}")
            return 1
        if update:
            text = block_of(name).sub(lambda match, printed=printed: match.group(1) + printed + match.group(3), text)
        elif blocks[0][1] != printed:
            print(f"{page}: the {name} is stale; run: python3 {' '.join(sys.argv)} --update")
            return 1
    if update:
        page.write_text(text, encoding="utf-8")
    print(f"stress_docs: {count.group(1)} cases as expected")
    return 0


if __name__ == "__main__":
    sys.exit(main())
