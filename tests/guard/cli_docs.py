# SPDX-License-Identifier: MIT
"""Checks that docs/cli holds what `posepack COMMAND --help` prints; with --update writes it anew.

Usage: cli_docs.py PATH_TO_POSEPACK DOCS_FOLDER [--update]
"""
import pathlib
import re
import subprocess
import sys


def help_text(posepack, command):
    run = subprocess.run([posepack, *command, "--help"], capture_output=True, text=True, check=True)
    return run.stdout


def command_names(main_help):
    names = []
    for line in main_help.split("Subcommands:", 1)[1].splitlines():
        match = re.match(r"  ([a-z]+)\s", line)
        if match:
            names.append(match.group(1))
    return names


def main():
    posepack, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    update = "--update" in sys.argv[3:]
    main_help = help_text(posepack, [])
    pages = {"posepack.txt": main_help}
    for name in command_names(main_help):
        pages[f"{name}.txt"] = help_text(posepack, [name])
    stale = []
    for name, text in pages.items():
        path = folder / name
        if update:
            path.write_text(text, encoding="utf-8")
        elif not path.exists() or path.read_text(encoding="utf-8") != text:
            stale.append(name)
    extra = sorted(path.name for path in folder.glob("*.txt") if path.name not in pages)
    print(f"cli_docs: {len(pages)} help texts compared")
    if stale or extra or len(pages) < 2:
        print(f"stale: {stale}, without a command: {extra}; run: python3 {' '.join(sys.argv)} --update")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
