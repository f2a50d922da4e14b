# SPDX-License-Identifier: MIT
"""What the commands do when all is well: outputs, formats, options, equal bytes, and the published figures."""

import csv
import io
import itertools
import json
import os
import re
import shutil
import subprocess

import glb
from harness import MANIFEST_NAME, Row, read_bytes

CATALOG_OPTIONS = {"--models", "--only"}
OUTPUT_OPTIONS = {"--encoding", "--texel-format", "--texel-order", "--row-pitch", "--caps", "--rate"}
OPTIONS = {
    "bake": CATALOG_OPTIONS | OUTPUT_OPTIONS | {"--output", "--strict", "--keep-going", "--compare-vat",
                                                "--no-measure",
                                                "--no-fsync", "--jobs", "--lock-timeout", "--format"},
    "report": CATALOG_OPTIONS | {"--rates", "--format"},
    "compare": CATALOG_OPTIONS | {"--rate", "--copies", "--format"},
    "inspect": {"--bones", "--row", "--clip", "--bone", "--format"},
    "verify": {"--strict", "--format"},
    "export": {"--exr", "--output"},
    "menagerie": {"--only"},
}
GLOBAL_OPTIONS = {"--version", "--json-errors", "--quiet"}

# The goat: 53 bones, 496 rows at 30 Hz, 2,500 vertices.
GOAT_BYTES = {"mat4 RGBA32F": 1_682_432, "mat4 RGBA16F": 841_216, "VAT RGB32F position": 14_880_000}
GOAT_COPIES = 30
GOAT_COPIES_BYTES = {"mat4 RGBA32F": 50_472_960, "VAT RGB32F position": 446_400_000}
CONTROL = re.compile(rb"[\x00-\x09\x0b-\x1f\x7f]")


def _options_in(text):
    return set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", text)) - {"--help"}


def _deer(case, **fields):
    return case.write_animal(glb.tiny_animal().glb(), **fields)


def _two(case):
    """A catalog of "deer" and "elk"."""
    elk = glb.tiny_animal(("Walk", "Idle", "Run"))
    elk.json["nodes"][1]["translation"] = [0.5, 0.0, 0.0]
    case.write("models/deer.glb", glb.tiny_animal().glb())
    case.write("models/elk.glb", elk.glb())
    return case.write_catalog({"deer": {"model": "deer.glb"}, "elk": {"model": "elk.glb"}})


# Help and version


def _help(case):
    top = case.run("--help")
    case.equal((top.exit_code, top.stderr), (0, ""), "exit code and stderr of --help")
    for command in OPTIONS:
        case.contains(top.stdout, f"  {command} ", "commands")
    case.equal(_options_in(top.stdout), GLOBAL_OPTIONS, "options of posepack --help")
    for command, options in OPTIONS.items():
        for flag in ("--help", "-h"):
            result = case.run(command, flag)
            case.equal((result.exit_code, result.stderr), (0, ""),
                       f"exit code and stderr of {command} {flag}")
            case.equal(_options_in(result.stdout) - GLOBAL_OPTIONS, options, f"options of {command} {flag}")
            case.contains(result.stdout, "Exit codes: 0 ok", command + " " + flag)


def _version(case):
    result = case.run("--version")
    with open(os.path.join(case.settings.project, "CMakeLists.txt"), encoding="utf-8") as file:
        version = re.search(r"project\(posepack VERSION (\S+)", file.read()).group(1)
    case.equal((result.exit_code, result.stdout, result.stderr), (0, f"posepack {version}\n", ""),
               "--version")


# Bake


def _bake_text(case):
    result = case.bake(_two(case), measure=True, fsync=True)
    case.expect_ok(result)
    case.contains(result.stdout, "baked 2 of 2 animals into out", "text")
    rows = [line.split()[0] for line in result.stdout.splitlines() if line.strip()]
    case.check("deer" in rows and "elk" in rows,
               f"text: expected a line for each animal, found {result.stdout}")
    case.equal(case.output(), ["deer.posepack", "elk.posepack", MANIFEST_NAME], "files")


def _bake_csv(case):
    result = case.bake(_two(case), "--format", "csv", measure=True)
    case.expect_ok(result)
    table = list(csv.DictReader(io.StringIO(result.stdout)))
    animals = {row["animal"]: row for row in table}
    case.check({"deer", "elk"} <= animals.keys(), f"csv: expected both animals, found {result.stdout}")
    case.equal(animals["elk"]["clips"], "3", "clips of the elk")
    case.equal(animals["deer"]["bones"], "3", "bones of the deer")
    for row in table:
        case.check(None not in row and None not in row.values(), f"csv: a row of another length: {row}")


def _bake_json(case):
    result = case.bake(_two(case), "--format", "json", "--compare-vat", measure=True)
    case.expect_ok(result)
    case.equal(result.stdout_bytes, read_bytes(case.path("out", MANIFEST_NAME)),
               "json on stdout against the manifest")
    for record in result.json()["records"]:
        container = read_bytes(case.path("out", record["container"]))
        case.equal(record["container_bytes"], len(container), "container_bytes")
        shown = case.inspect("out/" + record["container"])
        case.equal(record["texel_bytes"], shown["row_pitch_bytes"] * shown["texture_height"], "texel_bytes")
        case.check(0 < record["error"]["rms"] <= record["error"]["p999"] <= record["error"]["max"] < 0.05,
                   f"error: expected 0 < rms <= p99.9 <= max < 0.05, found {record['error']}")
        case.equal([clip["error"] for clip in record["clips"]][0]["max"], shown["clips"][0]["error"]["max"],
                   "error in manifest and container")
        rows, bones, vertices = record["row_count"], record["bone_count"], record["vertex_count"]
        case.equal((bones, vertices), (3, 20), "bones and vertices")
        case.equal((record["vram"]["mat4_rgba32f"], record["vram"]["vat_position_rgb32f"]),
                   (rows * bones * 64, rows * vertices * 12), "memory of mat4 RGBA32F and of VAT")


def _not_measured(case):
    case.expect_ok(case.bake(_deer(case)))
    record = case.manifest()["records"][0]
    case.equal((record["error"], record["clips"][0]["error"]), (None, None), "error in the manifest")
    case.equal(case.inspect("out/deer.posepack")["clips"][0]["error"], None, "error in the container")
    case.contains(case.run("inspect", "out/deer.posepack").stdout, "not measured", "inspect")


def _equal_bytes(case):
    catalog = _two(case)
    case.expect_ok(case.bake(catalog, measure=True))
    first = case.output_bytes()
    os.makedirs(case.path("elsewhere"))
    shutil.copytree(case.path("models"), case.path("moved"))
    os.rename(case.path("moved/catalog.json"), case.path("moved/catalog"))
    variations = [
        ("again", (catalog,), {}),
        ("jobs 1", (catalog, "--jobs", 1), {}),
        ("jobs 2", (catalog, "--jobs", 2), {}),
        ("jobs 7", (catalog, "--jobs", 7), {}),
        ("another folder", ("../models/catalog.json",), {"cwd": case.path("elsewhere")}),
        ("models elsewhere", (case.path("moved/catalog"), "--models", "moved"), {}),
        ("time zone", (catalog,), {"env": {"TZ": "Pacific/Chatham"}}),
        ("umask", (catalog,), {"umask": 0o077}),
        ("LANG", (catalog,), {"env": {"LANG": "tr_TR.UTF-8", "LC_ALL": "tr_TR.UTF-8"}}),
        ("with fsync", (catalog,), {"fsync": True}),
    ]
    for number, (name, arguments, options) in enumerate(variations):
        output = f"out_{number}"
        case.expect_ok(case.bake(*arguments, output=case.path(output), measure=True, **options))
        case.check(case.output_bytes(output) == first,
                   f"{name}: the files differ from those of the first bake")


def _only(case):
    catalog = _two(case)
    case.expect_ok(case.bake(catalog, "--only", "elk"))
    case.equal(case.output(), ["elk.posepack", MANIFEST_NAME], "files of --only elk")
    case.expect_ok(case.bake(catalog, "--only", "elk,deer", output="both"))
    case.equal([record["id"] for record in case.manifest("both")["records"]], ["deer", "elk"],
               "ids of --only elk,deer")
    case.expect_bake_refused(catalog, 1, "E-USAGE", "--only", "dear", output="none",
                             mentions=("'dear'", "'deer'"))


def _rates(case):
    """A loop of one second has as many rows as its rate; played once it has one more; its period stays exact."""
    catalog = _deer(case, clips=[{"name": "Walk", "wrap": "loop"}, {"name": "Idle", "wrap": "once"}])
    for rate, rows in ((None, (30, 31)), (10, (10, 11)), (24, (24, 25)), (59.94, (60, 61)),
                       (1000, (1000, 1001))):
        case.expect_ok(case.bake(catalog, *(("--rate", rate) if rate else ())))
        clips = case.inspect("out/deer.posepack")["clips"]
        case.equal(tuple(clip["row_count"] for clip in clips), rows, f"rows at {rate} Hz")
        for clip, intervals in zip(clips, (rows[0], rows[1] - 1)):
            case.equal((clip["period_s"], clip["rate_hz"]), (1.0, float(intervals)),
                       f"period and rate at {rate} Hz")


def _encodings(case):
    catalog = _deer(case, clips=["Walk"])
    case.expect_ok(case.bake(catalog, "--texel-format", "rgba32f", output="reference"))
    places = [(0, 1), (7, 1), (7, 2), (22, 2), (29, 0)]
    reference = [case.matrix("reference/deer.posepack", *place) for place in places]
    for encoding, texels, order, pitch in itertools.product(("mat4", "affine"), ("rgba16f", "rgba32f"),
                                                            ("bone-major", "planar"), ("tight", "align256")):
        named = f"{encoding} {texels} {order} {pitch}"
        case.expect_ok(case.bake(catalog, "--encoding", encoding, "--texel-format", texels, "--texel-order",
                                 order,
                                 "--row-pitch", pitch, output=named))
        file = f"{named}/deer.posepack"
        shown = case.inspect(file)
        case.equal((shown["encoding"], shown["texel_format"], shown["texel_order"]),
                   (encoding, texels, order), named)
        if pitch == "align256":
            case.equal(shown["row_pitch_bytes"] % 256, 0, f"{named}: pitch modulo 256")
        case.expect_ok(case.run("verify", "--strict", named))
        tolerance = 1e-3 if texels == "rgba16f" else 0.0
        for place, expected in zip(places, reference):
            found = case.matrix(file, *place)
            case.check(all(abs(a - b) <= tolerance for a, b in zip(found, expected)),
                       f"{named}: matrix {place} differs")


def _states(case):
    catalog = _deer(case, default_state="graze",
                    clips=[{"name": "walk", "states": ["roam"], "speed_mps": 1.5},
                                                        {"name": "IDLE", "states": ["graze"]}])
    case.expect_ok(case.bake(catalog))
    shown = case.inspect("out/deer.posepack")
    names = {state["name"]: state for state in shown["states"]["states"]} if isinstance(shown["states"],
                                                                                        dict) else {
        state["name"]: state for state in shown["states"]}
    case.check({"graze", "roam", "idle", "wander"} <= names.keys(), f"states: found {sorted(names)}")
    case.equal(shown["clips"][0]["speed_mps"], 1.5, "speed of the walk")
    case.contains(case.run("inspect", "out/deer.posepack").stdout, "graze (default) -> Idle", "inspect")


# The other commands


def _inspect(case):
    case.expect_ok(case.bake(_two(case), measure=True))
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
    for options, mention in ((("--row", 90), "89"), (("--row", 99999999999), "row"),
                             (("--bone", "tail"), "tail"),
                             (("--bone", 3), "0 to 2"), (("--clip", "Swim"), "Swim"), (("--row", -1), "row")):
        case.expect_refused(case.run("inspect", "out/elk.posepack", *options), 1, "E-USAGE", (mention,))


def _verify(case):
    case.expect_ok(case.bake(_two(case)))
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


def _report(case):
    catalog = _deer(case)
    shown = case.run("report", catalog, "--rates", "keys,15", "--format", "json").json()
    keys = {"animal", "encoding", "texel_format", "rate", "bytes", "max", "p999", "rms", "max_m",
            "normal_max_deg",
            "normal_p999_deg", "normal_rms_deg", "worst", "decode_ns_per_vertex", "bake_ms"}
    case.equal(len(shown["rows"]), 8, "rows of two encodings, two formats and two rates")
    for row in shown["rows"]:
        case.equal(set(row), keys, "keys of a row")
        case.equal(set(row["worst"]), {"clip", "time_s", "mesh", "vertex", "bone"}, "keys of the worst place")
        case.check(row["bake_ms"] > 0 and row["decode_ns_per_vertex"] > 0,
                   f"times: expected them above 0, found {row}")
    by_form = {(row["encoding"], row["texel_format"], row["rate"]): row for row in shown["rows"]}
    for encoding, texels in itertools.product(("mat4", "affine"), ("rgba16f", "rgba32f")):
        at_keys, at_15 = by_form[encoding, texels, "keys"], by_form[encoding, texels, "15"]
        case.check(at_15["max"] > 2 * at_keys["max"],
                   f"{encoding} {texels}: half the rate, expected a larger error")
        case.check(at_15["bytes"] < at_keys["bytes"],
                   f"{encoding} {texels}: half the rate, expected fewer bytes")
    table = list(csv.DictReader(io.StringIO(case.run("report", catalog, "--rates", "keys", "--format",
                                                     "csv").stdout)))
    case.equal([row["animal"] for row in table], ["deer"] * 4, "csv")
    text = case.run("report", catalog)
    case.equal((text.exit_code, text.stdout.count("deer")), (0, 16), "exit code and lines of text")


def _export(case):
    case.expect_ok(case.bake(_deer(case), measure=True))
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
    case.expect_ok(case.bake(_deer(case)))
    for arguments in (("inspect", "out/deer.posepack"), ("verify", "out"),
                      ("compare", "models/catalog.json")):
        with open("/dev/full", "wb") as full:
            process = case.start(*arguments, stdout=full, stderr=subprocess.PIPE)
            _, stderr = process.communicate()
        case.equal(process.returncode, 2,
                   f"exit code of posepack {' '.join(arguments)} into a full device ({stderr})")


ROWS = [
    Row("B01", "--help of every command lists every option", _help),
    Row("B02", "--version", _version),
    Row("B03", "bake: text", _bake_text),
    Row("B04", "bake: csv", _bake_csv),
    Row("B05", "bake: json is the manifest, and agrees with the containers", _bake_json),
    Row("B06", "bake --no-measure says so everywhere", _not_measured),
    Row("B07", "equal bytes: again, jobs, folder, time zone, umask, language", _equal_bytes),
    Row("B08", "bake --only", _only),
    Row("B09", "bake --rate: rows and exact periods", _rates),
    Row("B10", "all encodings, formats, orders and pitches hold the same matrices", _encodings),
    Row("B11", "states and speeds of the catalog", _states),
    Row("B12", "inspect: text, json, one bone-row, wrong places", _inspect),
    Row("B13", "verify of a folder: text and json", _verify),
    Row("B14", "compare: the published bytes of the goat", _compare_goat),
    Row("B15", "bake: the published bytes of the goat", _goat_on_disk),
    Row("B16", "report: json, csv, text", _report),
    Row("B17", "export --exr: file and attributes", _export),
    Row("B18", "--quiet and --json-errors", _remarks),
    Row("B19", "hostile names do not reach the terminal", _hostile_names),
    Row("B20", "stdout is a full device", _full_stdout),
]
