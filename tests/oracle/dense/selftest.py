#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The dense search finds nothing wrong in what posepack writes, and finds what is made wrong: an error printed too small
or too large, and a bone-row that is not the one that was measured.

    selftest.py --posepack FILE
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

ORACLE = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ORACLE), str(ORACLE.parent / "reader")]

import numpy as np  # noqa: E402  # the path comes first

import dense_error  # noqa: E402
from dense.curves import slerp  # noqa: E402
from dense.glb import Glb  # noqa: E402
from dense.search import Place  # noqa: E402
from dense.skin import Skin  # noqa: E402
from posepack_reader import Container  # noqa: E402

ANIMAL, POINTS = "fox", 8


def faults_of(printed, found, at_printed):
    return len(list(dense_error.Verdict("clip", Place(found), printed, at_printed).faults()))


def check_rule():
    assert faults_of(0.0098, 0.01, 0.0098) == 0
    assert faults_of(0.0096, 0.01, 0.0096) == 1, "less than 0.97"
    assert faults_of(0.0004, 0.0008, 0.0004) == 0 and faults_of(0.0002, 0.0008, 0.0002) == 1, "small errors"
    assert faults_of(0.0102, 0.01, 0.0102) == 1, "more than was found"
    assert faults_of(0.0099, 0.01, 0.005) == 1, "another error at the printed time"


def check_slerp():
    turn = [0.0, 0.0, np.sin(0.4), np.cos(0.4)]
    half = slerp(np.array([[0.0, 0.0, 0.0, 1.0]]), -np.array([turn]), np.array([[0.5]]))
    assert np.allclose(half, [[0.0, 0.0, np.sin(0.2), np.cos(0.2)]], atol=1e-15), "the shorter arc"


def check_container(folder, models):
    record = json.loads((folder / "manifest.json").read_text())["records"][0]
    glb = Glb(models / record["model"])
    container = Container((folder / record["container"]).read_bytes())
    skin = Skin(glb, container, dense_error.INFLUENCES)

    def fault_count():
        verdicts = [dense_error.check_clip(glb, container, skin, number, clip, POINTS)[0]
                    for number, clip in enumerate(record["clips"])]
        return sum(1 for verdict in verdicts if list(verdict.faults()))

    assert fault_count() == 0
    pixels = np.frombuffer(container.pixels, "<f2").copy()
    pixels[3::12] += np.float16(0.125)  # every bone an eighth of R aside
    container.pixels = pixels.tobytes()
    assert fault_count() == len(record["clips"]), "moved rows"
    return len(record["clips"])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--posepack", required=True)
    posepack = parser.parse_args().posepack
    check_rule()
    check_slerp()
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        subprocess.run([posepack, "-q", "menagerie", str(folder / "models")], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([posepack, "-q", "bake", str(ORACLE.parents[1] / "catalogs/menagerie.json"), "--models",
                        str(folder / "models"), "--only", ANIMAL, "-o", str(folder / "out"), "--no-fsync"], check=True,
                       stdout=subprocess.DEVNULL)
        print(f"the rule, slerp, and {check_container(folder / 'out', folder / 'models')} clips, whole and moved")


if __name__ == "__main__":
    main()
