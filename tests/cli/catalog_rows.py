# SPDX-License-Identifier: MIT
"""Broken and unusual catalogs, and the answer each must get."""

import json
import os
import re
import subprocess

import glb
from harness import Row, Skip

DEER = {"model": "deer.glb"}
LISTED_NAMES = 10


def _catalog(animals, **fields):
    return json.dumps({"schema": 1, **fields, "animals": animals})


def _nested(depth):
    """Objects in objects, `depth` deep with the catalog itself."""
    return '{"schema": 1, "animals": ' + '{"a": ' * (depth - 1) + "1" + "}" * depth


def _many(count):
    return _catalog({f"a{number}": {"model": "m"} for number in range(count)})


# name, title, text of the catalog, exit code, issue, what the message must name
REFUSED = [
    ("C01", "empty file", "", 4, "E-CAT-JSON", ()),
    ("C02", "an array on top", "[]", 4, "E-CAT-TYPE", ()),
    ("C03", "65 nested objects", _nested(65), 6, "E-LIM-JSON-DEPTH", ()),
    ("C04", "an animal twice",
     '{"schema": 1, "animals": {"deer": {"model": "deer.glb"}, "deer": {"model": "deer.glb"}}}',
     4, "E-CAT-JSON-DUP", ("deer",)),
    ("C06", "model path that climbs out", _catalog({"deer": {"model": "../outside/deer.glb"}}), 4,
     "E-CAT-PATH", ("..",)),
    ("C07a", "absolute model path", _catalog({"deer": {"model": "/m/deer.glb"}}), 4, "E-CAT-PATH",
     ("/m/deer.glb",)),
    ("C07b", "model path with a drive", _catalog({"deer": {"model": "C:\\m\\deer.glb"}}), 4, "E-CAT-PATH",
     ()),
    ("C07c", "model path of a share", _catalog({"deer": {"model": "\\\\srv\\m\\deer.glb"}}), 4, "E-CAT-PATH",
     ()),
    ("C11a", "id CON", _catalog({"CON": DEER}), 4, "E-CAT-ID", ("CON",)),
    ("C11b", "id aux.x", _catalog({"aux.x": DEER}), 4, "E-CAT-ID", ("aux.x",)),
    ("C11c", "id with a dot at its end", _catalog({"deer.": DEER}), 4, "E-CAT-ID", ("deer.",)),
    ("C11d", "id with a space at its end", _catalog({"deer ": DEER}), 4, "E-CAT-ID", ("deer ",)),
    ("C12", "ids that differ by case only", _catalog({"deer": DEER, "Deer": DEER}), 4, "E-CAT-ID",
     ("Deer", "deer")),
    ("C14a", "rate 0", _catalog({"deer": {**DEER, "rate_hz": 0}}), 4, "E-CAT-RANGE", ("rate_hz",)),
    ("C14b", "rate -30", _catalog({"deer": {**DEER, "rate_hz": -30}}), 4, "E-CAT-RANGE", ("rate_hz",)),
    ("C14c", "rate 1e9", _catalog({"deer": {**DEER, "rate_hz": 1e9}}), 4, "E-CAT-RANGE", ("rate_hz",)),
    ("C17", "schema one above the known one", _catalog({"deer": DEER}, later=[], schema=2), 5,
     "E-CAT-VERSION", ()),
    ("C18", "100,001 entries", _many(100_001), 6, "E-LIM-ENTRIES", ("100,001",)),
    ("C20", "a key that nobody knows", _catalog({"deer": {**DEER, "modle": 1}}), 4, "E-CAT-KEY", ("modle",)),
    ("C21", "control characters in an id", _catalog({"de\x1b[31mer\n": DEER}), 4, "E-CAT-ID", ()),
]


def _refused_row(name, title, text, exit_code, issue, mentions):
    def run(case):
        case.write("models/deer.glb", glb.tiny_animal().glb())
        case.write("outside/deer.glb", glb.tiny_animal().glb())
        catalog = case.write("models/catalog.json", text)
        case.expect_bake_refused(catalog, exit_code, issue, mentions=("catalog.json", *mentions))
    return Row(name, title, run)


def _symbolic_link(case):
    case.write("outside/deer.glb", glb.tiny_animal().glb())
    os.symlink("../outside", case.path("models/link"))
    os.symlink("../outside/deer.glb", case.path("models/deer.glb"))
    for model in ("link/deer.glb", "deer.glb"):
        catalog = case.write_catalog({"deer": {"model": model}})
        case.expect_bake_refused(catalog, 4, "E-CAT-PATH", mentions=("deer",))


def _link_inside(case):
    case.write("models/herd/deer.glb", glb.tiny_animal().glb())
    os.symlink("herd/deer.glb", case.path("models/latest.glb"))
    case.expect_ok(case.bake(case.write_catalog({"deer": {"model": "latest.glb"}})))


def _clip_missing(case):
    names = [f"Clip_{letter}" for letter in "ABCDEFGHIJKL"]
    catalog = case.write_animal(glb.tiny_animal(names).glb(), clips=["Clip_B", "Wlak"])
    result = case.expect_bake_refused(catalog, 4, "E-CAT-CLIP-MISSING", mentions=("deer", "'Wlak'"))
    listed = set(re.findall(r"Clip_[A-L]", result.stderr.split("did you mean")[0]))
    case.equal(len(listed), LISTED_NAMES, "clip names listed")


def _made_locales(case):
    """A folder for LOCPATH with the locales of this test, made here so that they need not be installed."""
    folder = case.path("tmp/locales")
    os.makedirs(folder)
    for name in ("de_DE", "tr_TR"):
        path = os.path.join(folder, name + ".UTF-8")
        try:
            made = subprocess.run(["localedef", "-c", "-i", name, "-f", "UTF-8", path], capture_output=True,
                                  check=False)
        except FileNotFoundError:
            raise Skip("localedef is not on the PATH") from None
        if not os.path.isdir(path):
            if os.environ.get("CI"):
                case.check(False, f"localedef made no {name}: {made.stderr.decode()[:300]}; install 'locales'")
            raise Skip(f"localedef made no {name}; the package 'locales' has its sources")
    # That the C library finds it here: a comma in the numbers of German.
    shown = subprocess.run(["locale", "decimal_point"], capture_output=True, check=True,
                           env={**os.environ, "LOCPATH": folder, "LC_ALL": "de_DE.UTF-8"}).stdout
    case.equal(shown.strip(), b",", "decimal point of de_DE.UTF-8")
    return folder


def _minus_zero(case):
    """-0 is 0: the container forbids it where nothing may lie below zero."""
    clips = [{"name": "Walk", "speed_mps": 0.0, "stride_phase": 0.0}]
    case.expect_ok(case.bake(case.write_animal(glb.tiny_animal().glb(), clips=clips), output="plain"))
    clips = [{"name": "Walk", "speed_mps": -0.0, "stride_phase": -0.0}]
    catalog = case.write_animal(glb.tiny_animal().glb(), clips=clips)
    case.contains(open(catalog, encoding="utf-8").read(), "-0.0", "the catalog")
    case.expect_ok(case.bake(catalog, output="minus"))
    case.check(case.output_bytes("minus")["deer.posepack"] == case.output_bytes("plain")["deer.posepack"],
               "bytes differ between 0 and -0")


def _locales(case):
    folder = _made_locales(case)
    catalog = case.write_animal(glb.tiny_animal().glb(), rate_hz=23.976)
    outputs = {}
    for locale in ("C", "de_DE.UTF-8", "tr_TR.UTF-8"):
        environment = {"LC_ALL": locale, "LANG": locale, "LOCPATH": folder}
        case.expect_ok(case.bake(catalog, measure=True, env=environment))
        shown = case.run("inspect", "out/deer.posepack", env=environment)
        outputs[locale] = (case.output_bytes(), shown.stdout)
    case.equal(len(outputs["C"][0]), 2, "files of a bake")
    for locale, output in outputs.items():
        case.check(output == outputs["C"], f"output under {locale} differs from that under C")


def _most_entries(case):
    """100,000 entries are a catalog: the first missing model is the failure, not their number."""
    catalog = case.write("models/catalog.json", _many(100_000))
    result = case.bake(catalog, "--only", "a7")
    case.equal(result.exit_code, 2, "exit code for a missing model")
    case.contains(result.stderr, "E-IO-OPEN", "stderr")


ROWS = [_refused_row(*row) for row in REFUSED] + [
    Row("C09", "model path through a link that leaves the root", _symbolic_link),
    Row("C09b", "MUST PASS: a link that stays inside", _link_inside),
    Row("C15", "a clip that the model does not have", _clip_missing),
    Row("C18b", "MUST PASS: 100,000 entries", _most_entries),
    Row("C14d", "MUST PASS: minus zero", _minus_zero),
    Row("C19", "MUST PASS: rate 23.976 under three locales", _locales),
]
