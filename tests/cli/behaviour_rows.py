# SPDX-License-Identifier: MIT
"""Help, and what a bake does when all is well: outputs, formats, options, equal bytes."""

import csv
import io
import itertools
import os
import re
import shutil

from harness import MANIFEST_NAME, Row, read_bytes
from herd import deer, deer_and_elk

CATALOG_OPTIONS = {"--models", "--only"}
OUTPUT_OPTIONS = {"--encoding", "--texel-format", "--texel-order", "--row-pitch", "--caps", "--space", "--rate",
                  "--influences", "--unused-bones"}
OPTIONS = {
    "bake": CATALOG_OPTIONS | OUTPUT_OPTIONS | {
        "--output", "--strict", "--allow-data-uris", "--keep-going", "--compare-vat", "--no-measure", "--no-fsync", "--jobs",
        "--lock-timeout", "--format", "--max-error", "--p999-error", "--rms-error"},
    "report": CATALOG_OPTIONS | {"--rates", "--output", "--format", "--heat-map", "--max-error", "--p999-error", "--rms-error"},
    "compare": CATALOG_OPTIONS | {"--rate", "--copies", "--format"},
    "inspect": {"--bones", "--row", "--phase", "--clip", "--bone", "--format"},
    "verify": {"--strict", "--format"},
    "export": {"--exr", "--output"},
    "menagerie": {"--only", "--animals", "--birds", "--seed", "--statistics", "--toy"},
}
GLOBAL_OPTIONS = {"--version", "--json-errors", "--quiet"}


def _options_in(text):
    return set(re.findall(r"(?<![\w-])--[a-z][a-z0-9-]*", text)) - {"--help"}


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
    result = case.bake(deer_and_elk(case), measure=True, fsync=True)
    case.expect_ok(result)
    case.contains(result.stdout, "baked 2 of 2 animals into out", "text")
    rows = [line.split()[0] for line in result.stdout.splitlines() if line.strip()]
    case.check("deer" in rows and "elk" in rows,
               f"text: expected a line for each animal, found {result.stdout}")
    case.equal(case.output(), ["deer.posepack", "elk.posepack", MANIFEST_NAME], "files")


def _bake_csv(case):
    result = case.bake(deer_and_elk(case), "--format", "csv", measure=True)
    case.expect_ok(result)
    table = list(csv.DictReader(io.StringIO(result.stdout)))
    animals = {row["animal"]: row for row in table}
    case.check({"deer", "elk"} <= animals.keys(), f"csv: expected both animals, found {result.stdout}")
    case.equal(animals["elk"]["clips"], "3", "clips of the elk")
    case.equal(animals["deer"]["bones"], "3", "bones of the deer")
    for row in table:
        case.check(None not in row and None not in row.values(), f"csv: a row of another length: {row}")


def _bake_json(case):
    result = case.bake(deer_and_elk(case), "--format", "json", "--compare-vat", measure=True)
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
    case.expect_ok(case.bake(deer(case)))
    record = case.manifest()["records"][0]
    case.equal((record["error"], record["clips"][0]["error"]), (None, None), "error in the manifest")
    case.equal(case.inspect("out/deer.posepack")["clips"][0]["error"], None, "error in the container")
    case.contains(case.run("inspect", "out/deer.posepack").stdout, "not measured", "inspect")
    case.expect_ok(case.bake(deer(case), measure=True, output="measured"))
    measured = case.manifest("measured")["records"][0]
    case.check(measured["container_sha256"] != record["container_sha256"]
               and measured["recipe_sha256"] != record["recipe_sha256"],
               "expected another recipe where the bytes differ")
    error, radius = measured["error"], measured["radius_m"]
    for figure in ("max", "p999", "rms"):
        case.check(abs(error[figure + "_m"] - error[figure] * radius) <= 1e-6 * error["max_m"],
                   f"{figure}_m: expected {figure} x radius_m, found {error}")


def _equal_bytes(case):
    catalog = deer_and_elk(case)
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
    catalog = deer_and_elk(case)
    case.expect_ok(case.bake(catalog, "--only", "elk"))
    case.equal(case.output(), ["elk.posepack", MANIFEST_NAME], "files of --only elk")
    case.expect_ok(case.bake(catalog, "--only", "elk,deer", output="both"))
    case.equal([record["id"] for record in case.manifest("both")["records"]], ["deer", "elk"],
               "ids of --only elk,deer")
    for number, only in enumerate(("deer,elk", "elk,deer,elk", "deer,deer,elk")):
        case.expect_ok(case.bake(catalog, "--only", only, output=f"order_{number}"))
        case.check(case.output_bytes(f"order_{number}") == case.output_bytes("both"),
                   f"--only {only}: other bytes than --only elk,deer")
    case.expect_bake_refused(catalog, 1, "E-USAGE", "--only", "dear", output="none",
                             mentions=("'dear'", "'deer'"))


def _rates(case):
    """A loop of one second has as many rows as its rate, played once one more; its period stays exact."""
    catalog = deer(case, clips=[{"name": "Walk", "wrap": "loop"}, {"name": "Idle", "wrap": "once"}])
    for rate, rows in ((None, (30, 31)), (10, (10, 11)), (24, (24, 25)), (59.94, (60, 61)),
                       (1000, (1000, 1001))):
        case.expect_ok(case.bake(catalog, *(("--rate", rate) if rate else ())))
        clips = case.inspect("out/deer.posepack")["clips"]
        case.equal(tuple(clip["row_count"] for clip in clips), rows, f"rows at {rate} Hz")
        for clip, intervals in zip(clips, (rows[0], rows[1] - 1)):
            case.equal((clip["period_s"], clip["rate_hz"]), (1.0, float(intervals)),
                       f"period and rate at {rate} Hz")


def _encodings(case):
    catalog = deer(case, clips=["Walk"])
    case.expect_ok(case.bake(catalog, "--texel-format", "rgba32f", "--space", "model", output="reference"))
    places = [(0, 1), (7, 1), (7, 2), (22, 2), (29, 0)]
    reference = [case.matrix("reference/deer.posepack", *place) for place in places]
    for encoding, texels, order, pitch in itertools.product(("mat4", "affine", "dualquat"), ("rgba16f", "rgba32f"),
                                                            ("bone-major", "planar"), ("tight", "align256")):
        named = f"{encoding} {texels} {order} {pitch}"
        case.expect_ok(case.bake(catalog, "--encoding", encoding, "--texel-format", texels,
                                 "--texel-order", order, "--row-pitch", pitch, "--space", "model",
                                 output=named))
        file = f"{named}/deer.posepack"
        shown = case.inspect(file)
        case.equal((shown["encoding"], shown["texel_format"], shown["texel_order"]),
                   (encoding, texels, order), named)
        if pitch == "align256":
            case.equal(shown["row_pitch_bytes"] % 256, 0, f"{named}: pitch modulo 256")
        case.expect_ok(case.run("verify", "--strict", named))
        # Halves of dual quaternions and of optimised rounding move what the vertices do not see.
        tolerance = 2e-3 if texels == "rgba16f" else 1e-6 if encoding == "dualquat" else 0.0
        for place, expected in zip(places, reference):
            found = case.matrix(file, *place)
            case.check(all(abs(a - b) <= tolerance for a, b in zip(found, expected)),
                       f"{named}: matrix {place} differs")


def _states(case):
    catalog = deer(case, default_state="graze",
                    clips=[{"name": "walk", "states": ["roam"], "speed_mps": 1.5},
                                                        {"name": "IDLE", "states": ["graze"]}])
    case.expect_ok(case.bake(catalog))
    shown = case.inspect("out/deer.posepack")
    names = {state["name"] for state in shown["states"]}
    case.check({"graze", "roam", "idle", "wander"} <= names, f"states: found {sorted(names)}")
    case.equal(shown["clips"][0]["speed_mps"], 1.5, "speed of the walk")
    case.contains(case.run("inspect", "out/deer.posepack").stdout, "graze (default) -> Idle", "inspect")


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
]
