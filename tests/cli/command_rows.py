# SPDX-License-Identifier: MIT
"""The commands beside bake, and what all commands do with their streams."""

import csv
import io
import json
import os
import re
import shutil
import subprocess

import glb
from harness import MANIFEST_NAME, Row, read_bytes
from herd import deer, deer_and_elk

# The goat: 53 bones, 496 rows at 30 Hz, 2,500 vertices.
GOAT_BYTES = {"mat4 RGBA32F": 1_682_432, "mat4 RGBA16F": 841_216, "VAT RGB32F position": 14_880_000}
GOAT_COPIES = 30
GOAT_COPIES_BYTES = {"mat4 RGBA32F": 50_472_960, "VAT RGB32F position": 446_400_000}
CONTROL = re.compile(rb"[\x00-\x09\x0b-\x1f\x7f]")


def _inspect(case):
    case.expect_ok(case.bake(deer_and_elk(case), "--space", "model", measure=True))
    text = case.run("inspect", "--bones", "out/elk.posepack")
    case.expect_ok(text)
    for part in ("affine rgba16f", "3 bones x 90 rows", "Walk", "Run", "radius R", "spine", "head", "PIXL"):
        case.contains(text.stdout, part, "text")
    shown = case.inspect("out/elk.posepack")
    case.equal((shown["bone_count"], shown["row_count"], shown["clip_count"]), (3, 90, 3), "counts")
    case.equal(shown["file_bytes"], len(read_bytes(case.path("out/elk.posepack"))), "file_bytes")
    by_clip = case.inspect("out/elk.posepack", "--clip", "Run", "--row", 3, "--bone", "head")
    by_row = case.inspect("out/elk.posepack", "--row", shown["clips"][2]["first_row"] + 3, "--bone", 2)
    case.equal(by_clip, by_row, "a bone-row by clip and name, and by numbers")
    matrix = case.run("inspect", "out/elk.posepack", "--row", 0, "--bone", "root")
    case.equal([line.split() for line in matrix.stdout.splitlines()[1:]],
               [["1", "0", "0", "0.5"], ["0", "1", "0", "0"], ["0", "0", "1", "0"]], "matrix as text")
    case.equal(case.inspect("out/elk.posepack", "--clip", "Run", "--phase", 0, "--bone", "head")["matrix"],
               case.inspect("out/elk.posepack", "--clip", "Run", "--row", 0, "--bone", "head")["matrix"],
               "phase 0 is row 0")
    for options, mention in ((("--row", 90), "89"), (("--row", 99999999999), "row"),
                             (("--row", 0, "--bone", "tail"), "tail"), (("--row", 0, "--bone", 3), "0 to 2"),
                             (("--row", 0, "--clip", "Swim"), "Swim"), (("--row", -1), "row"),
                             (("--clip", "Walk"), "--row"), (("--bone", 1), "--row"),
                             (("--phase", 0.5), "--clip"), (("--phase", 2, "--clip", "Run"), "0 to 1"),
                             (("--phase", 0, "--row", 0, "--clip", "Run"), "both")):
        case.expect_refused(case.run("inspect", "out/elk.posepack", *options), 1, "E-USAGE", (mention,))


def _verify(case):
    case.expect_ok(case.bake(deer_and_elk(case)))
    size = sum(len(data) for name, data in case.output_bytes().items() if name != MANIFEST_NAME)
    text = case.run("verify", "out", writes=())
    case.expect_ok(text)
    case.equal(text.stdout, f"ok: 2 containers, {size:,} bytes checked\n", "text")
    shown = case.run("verify", "out", "--format", "json", writes=()).json()
    case.equal((shown["ok"], shown["containers"], shown["bytes"], shown["findings"]), (True, 2, size, []),
               "json")
    os.remove(case.path("out/elk.posepack"))
    failed = case.run("verify", "out", "--format", "json", writes=())
    case.equal((failed.exit_code, failed.json()["ok"]), (8, False), "exit code and ok of a folder with a gap")
    case.equal([finding["code"] for finding in failed.json()["findings"]], ["E-MAN-MISSING"], "findings")


def _compare_goat(case):
    made = case.run("menagerie", "goats", "--only", "goat", writes=("goats",))
    case.equal((made.exit_code, case.output("goats")), (0, ["goat.glb"]), "exit code and files of menagerie")
    catalog = os.path.join(case.settings.project, "catalogs", "menagerie.json")
    arguments = ("compare", catalog, "--models", "goats", "--only", "goat")
    shown = case.run(*arguments, "--format", "json").json()
    goat = shown["animals"][0]
    case.equal((goat["bones"], goat["rows"], goat["vertices"]), (53, 496, 2500), "bones, rows and vertices")
    case.equal({form: goat["bytes"][form] for form in GOAT_BYTES}, GOAT_BYTES, "bytes of one goat")
    many = case.run(*arguments, "--copies", GOAT_COPIES, "--format", "json").json()["total"]["bytes"]
    case.equal({form: many[form] for form in GOAT_COPIES_BYTES}, GOAT_COPIES_BYTES,
               f"bytes of {GOAT_COPIES} goats")
    text = case.run(*arguments)
    for number in GOAT_BYTES.values():
        case.contains(text.stdout, str(number), "text")
    table = list(csv.DictReader(io.StringIO(case.run(*arguments, "--format", "csv").stdout)))
    case.equal((table[0]["animal"], table[0]["mat4 RGBA32F"]), ("goat", str(GOAT_BYTES["mat4 RGBA32F"])),
               "csv")


def _bake_herd(case):
    made = case.run("menagerie", "herd", "--animals", "62", "--seed", "5", "--only", "goat,bee", writes=("herd",))
    names = ["bee.glb", "bee_0032.glb", "bee_0062.glb", "catalog.json", "goat.glb", "goat_0046.glb"]
    case.equal((made.exit_code, sorted(case.output("herd"))), (0, names), "exit code and files of menagerie")
    baked = case.bake("herd/catalog.json", "--models", "herd", "--no-measure")
    case.equal(baked.exit_code, 0, "exit code of bake")


def _goat_on_disk(case):
    """What compare says of mat4 is what a bake writes."""
    case.run("menagerie", "goats", "--only", "goat", writes=("goats",))
    catalog = os.path.join(case.settings.project, "catalogs", "menagerie.json")
    for texels, form in (("rgba32f", "mat4 RGBA32F"), ("rgba16f", "mat4 RGBA16F")):
        result = case.bake(catalog, "--models", "goats", "--only", "goat", "--encoding", "mat4",
                           "--texel-format", texels,
                           "--caps", "desktop")
        case.equal(result.exit_code, 0, f"exit code (stderr {result.stderr})")
        record = case.manifest()["records"][0]
        case.equal((record["bone_count"], record["row_count"], record["vertex_count"]), (53, 496, 2500),
                   "counts")
        shown = case.inspect("out/goat.posepack")
        spare = (-record["row_count"] % shown["rows_per_line"]) * 53 * 4 * (16 if texels == "rgba32f" else 8)
        case.equal(record["texel_bytes"] - spare, GOAT_BYTES[form],
                   f"texels of {form} without the last line's spare")


def _stress(case):
    text = case.run("stress", "--only", "shear,falling_keys", writes=())
    case.equal((text.exit_code, text.stderr), (0, ""), "exit code and stderr")
    for part in ("switches form to affine 16F", "refuses: E-GLB-TIMES", "2 cases: 2 as expected, 0 not."):
        case.contains(text.stdout, part, "text")
    names = case.run("stress", "--list", writes=())
    case.contains(names.stdout, "falling_keys ", "list")
    details = case.run("stress", "--only", "shear", "--details", writes=())
    case.contains(details.stdout, " of 155 bone-rows in runs", "details")
    shown = case.run("stress", "--only", "shear", "--format", "json", "--jobs", 1, writes=()).json()
    case.equal((shown["ok"], [one["name"] for one in shown["cases"]]), (True, ["shear"]), "json")
    finer = case.run("stress", "--only", "one_metre,falling_keys", "--bound-factor", "0.000001", writes=())
    case.equal((finer.exit_code, len(finer.lines("error"))), (8, 1), "exit code and errors under a finer bound")
    case.contains(finer.stderr, "error[E-STRESS-DIFFERS]: one_metre: expected 'meets the bound'", "stderr")
    case.contains(finer.stdout, "2 cases: 1 as expected, 1 not.", "text under a finer bound")
    for options, mention in ((("--only", "one_meter"), "did you mean 'one_metre'?"),
                             (("--bound-factor", "0"), "--bound-factor"), (("--bound-factor", "nan"), "nan"),
                             (("--jobs", "-1"), "--jobs"), (("--format", "csv"), "text, json")):
        case.expect_refused(case.run("stress", *options, writes=()), 1, "E-USAGE", (mention,))


def _export(case):
    case.expect_ok(case.bake(deer(case), measure=True))
    beside = case.run("export", "--exr", "out/deer.posepack")
    case.equal(beside.exit_code, 0, f"exit code (stderr {beside.stderr})")
    named = case.run("export", "--exr", "out/deer.posepack", "-o", "named.exr", writes=("named.exr",))
    case.equal(named.exit_code, 0, f"exit code (stderr {named.stderr})")
    image = read_bytes(case.path("named.exr"))
    case.equal(image[:4], b"\x76\x2f\x31\x01", "magic")
    case.equal(read_bytes(case.path("out/deer.exr")), image, "the file beside the container")
    missing = case.run("export", "--exr", "out/deer.posepack", "-o", "no/such/deer.exr")
    case.expect_refused(missing, 2, "E-IO-WRITE", ("no/such/deer.exr",))
    if shutil.which("exrheader") is None:
        case.notes.append("exrheader is not on the PATH: attributes were not read")
        return
    header = subprocess.run(["exrheader", case.path("named.exr")], capture_output=True,
                            check=True).stdout.decode()
    shown = case.inspect("out/deer.posepack")
    for attribute in ("clips", "states", "bones", "space", "encoding", "texelOrder", "boneCount", "rowCount",
                      "texelsPerBone", "rowsPerLine"):
        case.contains(header, "posepack:" + attribute, "attributes")
    for channel in "RGBA":
        case.check(re.search(rf"\b{channel}, 16-bit floating-point", header),
                   f"exrheader: expected a half {channel}")
    size = f"({shown['texture_width'] - 1} {shown['texture_height'] - 1})"
    case.check(f"dataWindow (type box2i): (0 0) - {size}" in header,
               f"dataWindow: expected it to end at {size}")


def _remarks(case):
    """Warnings stand on stderr; --quiet drops them; --json-errors gives one object a line."""
    document = glb.tiny_animal()
    document.put("weights", 0, -1.0, 1.0)
    catalog = case.write_animal(document.glb())
    case.expect_ok(case.bake(catalog), ["W-GLB-WEIGHTS"])
    case.expect_ok(case.bake(catalog, "--quiet"))
    case.expect_ok(case.bake(catalog, "-q"))
    finding = json.loads(case.bake(catalog, "--json-errors").stderr)
    case.equal((finding["code"], finding["severity"]), ("W-GLB-WEIGHTS", "warning"), "warning as JSON")
    refused = case.bake(catalog, "--json-errors", "--strict", output="strict")
    finding = json.loads(refused.stderr)
    case.equal((refused.exit_code, finding["code"], finding["exit_code"]), (3, "E-GLB-WEIGHTS", 3),
               "error as JSON")
    case.check(all(finding[key] for key in ("advice", "detail", "where")), f"error as JSON: {finding}")


def _hostile_names(case):
    """Names from a file reach a terminal without their control characters."""
    names = ("W\x1b[31malk\x07", "Id\nle: error[E-FAKE]", "\u202eevil\u009b", "x" * 200)
    document = glb.tiny_animal(names)
    document.json["nodes"][2]["name"] = "sp\x1b]0;title\x07ine"
    catalog = case.write_animal(document.glb())
    result = case.bake(catalog, measure=True)
    shown = [result]
    if case.equal(result.exit_code, 0, f"exit code (stderr {result.stderr[:300]!r})"):
        shown += [case.run("inspect", "--bones", "out/deer.posepack"), case.run("verify", "out"),
                  case.run("report", catalog, "--rates", "keys")]
    document.json["nodes"][2]["rotation"] = [0, 0, 0, 0]
    shown.append(case.bake(case.write_animal(document.glb(), clips=["W\x1b[31malk"]), output="refused"))
    shown.append(case.bake(case.write_animal(glb.tiny_animal().glb(), clips=["W\x7falk"]), output="refused"))
    shown.append(case.run("bake", "cat\x1b[1malog\n.json", "-o", "refused"))
    shown.append(case.run("inspect", "fi\x1b[1mle.posepack"))
    for run in shown:
        for stream in (run.stdout_bytes, run.stderr_bytes):
            case.check(not CONTROL.search(stream) and b"\xc2\x9b" not in stream,
                       f"control characters in {stream[:300]!r}")


def _full_stdout(case):
    """A result that cannot be shown is an error, not a success."""
    if not os.path.exists("/dev/full"):
        return
    case.expect_ok(case.bake(deer(case)))
    for arguments in (("inspect", "out/deer.posepack"), ("verify", "out"),
                      ("compare", "models/catalog.json")):
        with open("/dev/full", "wb") as full:
            process = case.start(*arguments, stdout=full, stderr=subprocess.PIPE)
            _, stderr = process.communicate()
        case.equal(process.returncode, 2,
                   f"exit code of posepack {' '.join(arguments)} into a full device ({stderr})")


ROWS = [
    Row("B12", "inspect: text, json, one bone-row, wrong places", _inspect),
    Row("B13", "verify of a folder: text and json", _verify),
    Row("B14", "compare: the published bytes of the goat", _compare_goat),
    Row("B14b", "menagerie --animals: a herd that bakes by its own catalog", _bake_herd),
    Row("B15", "bake: the published bytes of the goat", _goat_on_disk),
    Row("B16b", "stress: text, details, json, a bound that is too fine, wrong words", _stress),
    Row("B17", "export --exr: file and attributes", _export),
    Row("B18", "--quiet and --json-errors", _remarks),
    Row("B19", "hostile names do not reach the terminal", _hostile_names),
    Row("B20", "stdout is a full device", _full_stdout),
]
