# SPDX-License-Identifier: MIT
"""The reader as a program; see __init__.py."""
import os
import sys

if not __package__:  # run as a folder: the package is beside it
    sys.path[0] = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

from posepack_reader import dump_bytes  # noqa: E402  # the path comes first


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: python3 posepack_reader FILE.posepack")
    with open(sys.argv[1], "rb") as file:
        print("\n".join(dump_bytes(file.read())))


if __name__ == "__main__":
    main()
