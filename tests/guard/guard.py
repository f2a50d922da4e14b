# SPDX-License-Identifier: MIT
"""What every guard shares: the files of the project, and a report that cannot pass by looking at nothing."""

import os
import shutil
import subprocess
import sys

SKIPPED_FOLDERS = {".git", "build", "node_modules", "__pycache__"}


class Report:
    """Counts what was looked at and collects what was found wrong."""

    def __init__(self, things):
        self.things = things
        self.count = 0
        self.faults = []

    def looked(self, count=1):
        self.count += count

    def fault(self, where, what):
        self.faults.append(f"{where}: {what}")

    def finish(self):
        """Prints the count and the faults. Returns the exit code: 0 when something was seen and nothing is wrong."""
        print(f"{self.things}: {self.count} looked at, {len(self.faults)} faults")
        for fault in self.faults:
            print("  " + fault)
        if self.count == 0:
            print(f"  expected some {self.things}, found none: the guard looked in the wrong place")
        return 1 if self.faults or self.count == 0 else 0


def project_root():
    """The folder named by the first argument."""
    if len(sys.argv) < 2 or not os.path.isfile(os.path.join(sys.argv[1], "CMakeLists.txt")):
        sys.exit(f"usage: {os.path.basename(sys.argv[0])} PROJECT_ROOT")
    return os.path.abspath(sys.argv[1])


def project_files(root):
    """Paths of all files, relative to the root and sorted: those git tracks or would, else the whole tree."""
    if os.path.exists(os.path.join(root, ".git")) and shutil.which("git"):
        listing = subprocess.run(
            ["git", "-c", f"safe.directory={root}", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
            cwd=root, capture_output=True, check=True).stdout.decode("utf-8")
        paths = [path for path in listing.split("\0") if path]
        return sorted(path for path in set(paths) if os.path.isfile(os.path.join(root, path)))
    found = []
    for folder, folders, names in os.walk(root):
        folders[:] = [name for name in folders if name not in SKIPPED_FOLDERS]
        found += [os.path.relpath(os.path.join(folder, name), root) for name in names]
    return sorted(path.replace(os.sep, "/") for path in found)


def read_text(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read()


def available(*commands):
    """Those of the commands that are on the PATH."""
    return [command for command in commands if shutil.which(command)]
