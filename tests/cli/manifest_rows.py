# SPDX-License-Identifier: MIT
"""`verify` of an output folder whose manifest and containers do not fit, and the bake that repairs it."""

import os

from harness import MANIFEST_NAME, Row, read_bytes
from herd import many_deer


def _baked_herd(case):
    catalog = many_deer(case, 2)
    case.expect_ok(case.bake(catalog))
    case.expect_ok(case.run("verify", "out"))
    return catalog


def _expect_repaired(case, catalog, *options):
    clean = case.bake(catalog, *options, output="clean")
    case.expect_ok(clean)
    case.expect_ok(case.bake(catalog, *options))
    case.expect_ok(case.run("verify", "--strict", "out"))
    case.check(case.output_bytes() == case.output_bytes("clean"),
               "the repaired folder differs from a clean bake")


def _verify_refused(case, exit_code, issue, *mentions, options=()):
    result = case.run("verify", *options, "out", writes=())
    case.equal(result.exit_code, exit_code, f"exit code (stderr {result.stderr})")
    lines = result.lines("error")
    case.check(len(lines) == 1 and lines[0].startswith(f"posepack: error[{issue}]: "),
               f"stderr: expected one {issue}, found {result.stderr}")
    for mention in mentions:
        case.contains(result.stderr, mention, "stderr")
    return result


def _half_a_manifest(case):
    catalog = _baked_herd(case)
    text = read_bytes(case.path("out", MANIFEST_NAME))
    case.write("out/" + MANIFEST_NAME, text[:len(text) // 2])
    result = _verify_refused(case, 7, "E-MAN-JSON", MANIFEST_NAME)
    case.expect_refused(result, 7, "E-MAN-JSON")
    _expect_repaired(case, catalog)


def _exchanged(case):
    catalog = _baked_herd(case)
    case.write("out/deer_00.posepack", read_bytes(case.path("out/deer_01.posepack")))
    _verify_refused(case, 8, "E-MAN-HASH", "deer_00.posepack")
    _expect_repaired(case, catalog)


def _missing(case):
    catalog = _baked_herd(case)
    os.remove(case.path("out/deer_01.posepack"))
    _verify_refused(case, 8, "E-MAN-MISSING", "deer_01.posepack")
    _expect_repaired(case, catalog)


def _killed_before_the_commit(case):
    catalog = _baked_herd(case)
    old = read_bytes(case.path("out", MANIFEST_NAME))
    case.expect_ok(case.bake(catalog, "--rate", 20))
    case.write("out/" + MANIFEST_NAME, old)
    result = case.run("verify", "out", writes=())
    case.equal(result.exit_code, 8, "exit code of verify")
    case.equal(len(result.lines("error")), 2, "findings")
    case.check(all("E-MAN-HASH" in line for line in result.lines("error")), f"stderr: {result.stderr}")
    _expect_repaired(case, catalog)


def _stray(case):
    _baked_herd(case)
    case.write("out/stray.posepack", read_bytes(case.path("out/deer_01.posepack")))
    case.expect_ok(case.run("verify", "out"), ["W-MAN-STRAY"])
    _verify_refused(case, 8, "E-MAN-STRAY", "stray.posepack", options=("--strict",))


def _damaged(case):
    """A bit flipped in a listed container is the container's fault first."""
    catalog = _baked_herd(case)
    data = bytearray(read_bytes(case.path("out/deer_00.posepack")))
    data[-1] ^= 0x10
    case.write("out/deer_00.posepack", bytes(data))
    _verify_refused(case, 7, "E-PACK-INVALID", "deer_00.posepack", "SECTION_CRC")
    _expect_repaired(case, catalog)


def _climbing_manifest(case):
    """A manifest is input too: it names no file outside its folder."""
    _baked_herd(case)
    os.rename(case.path("out/deer_00.posepack"), case.path("deer_00.posepack"))
    text = read_bytes(case.path("out", MANIFEST_NAME))
    case.write("out/" + MANIFEST_NAME, text.replace(b'"deer_00.posepack"', b'"../deer_00.posepack"'))
    _verify_refused(case, 7, "E-MAN-JSON")


def _newer(case):
    _baked_herd(case)
    text = read_bytes(case.path("out", MANIFEST_NAME))
    newer = text.replace(b'"schema": 1', b'"schema": 2')
    case.check(newer != text, "expected the schema number in the manifest")
    case.write("out/" + MANIFEST_NAME, newer)
    _verify_refused(case, 7, "E-MAN-VERSION")


def _no_manifest(case):
    os.makedirs(case.path("out"))
    case.expect_refused(case.run("verify", "out", writes=()), 2, "E-IO-OPEN", (MANIFEST_NAME,))
    case.expect_refused(case.run("verify", "nowhere", writes=()), 2, "E-IO-OPEN", ("nowhere",))


ROWS = [
    Row("M01", "manifest cut in half", _half_a_manifest),
    Row("M02", "a container replaced by another good one", _exchanged),
    Row("M03", "a listed container with a flipped bit", _damaged),
    Row("M04", "a listed container is missing", _missing),
    Row("M05", "new containers under the old manifest", _killed_before_the_commit),
    Row("M06", "a manifest that names a file outside its folder", _climbing_manifest),
    Row("M07", "a container that is not listed", _stray),
    Row("M08", "a manifest of a later schema", _newer),
    Row("M09", "a folder without a manifest, and no folder", _no_manifest),
]
