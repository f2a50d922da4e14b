# SPDX-License-Identifier: MIT
"""posepack report: its formats, and that the page says what was measured."""

import csv
import io
import itertools
import json
import re
import shutil
import subprocess

import glb
from harness import Row, read_bytes
from herd import deer, deer_and_elk
from report_page import Page, charts, drawings

ERRORS = ("max", "p999", "rms")
COSTS = {"bytes": "bytes", "ns": "decode_ns_per_vertex", "fetches": "fetches", "alu": "alu_operations"}
ROW_KEYS = {"form", "encoding", "texel_format", "rows", "chosen", "bytes", "error", "decode_ns_per_vertex",
            "fetches", "alu_operations", "bake_ms"}
ERROR_KEYS = {"max", "p999", "rms", "max_m", "p999_m", "rms_m", "normal_max_deg", "normal_p999_deg",
              "normal_rms_deg", "worst"}
TIMES = {"decode_ns_per_vertex", "bake_ms"}
EVIL = ("<script>alert(1)</script>", "\"'&amp;]]>\u202eevil\ufffe")


def _json(case, catalog, *options):
    result = case.run("report", catalog, "--format", "json", *options)
    case.equal(result.exit_code, 0, f"exit code (stderr {result.stderr[:300]!r})")
    return result.json()


def _page(case, catalog, *options, output="report.html"):
    result = case.run("report", catalog, "-o", output, *options, writes=(output,))
    case.equal((result.exit_code, result.stderr), (0, ""), "exit code and stderr")
    text = read_bytes(case.path(output)).decode("utf-8")
    case.equal(result.stdout, f"wrote {output} ({len(text.encode())} bytes)\n", "stdout")
    return Page(text)


def _without_times(value):
    if isinstance(value, dict):
        return {key: _without_times(member) for key, member in value.items() if key not in TIMES}
    return [_without_times(member) for member in value] if isinstance(value, list) else value


def _stretching():
    """The tiny animal, whose spine squashes in its second clip: no dual quaternion can hold it."""
    document = glb.tiny_animal()
    scales = [number for key in range(glb.KEY_COUNT) for number in (1.0, 1.0 + 0.5 * abs(glb.wave(key)), 1.0)]
    animation = document.json["animations"][1]
    animation["samplers"].append({"input": document.names["times"], "output": document.add("scales", scales, "VEC3")})
    animation["channels"].append(glb.channel(2, "scale", 1))
    return document


def _formats(case):
    catalog = deer(case)
    shown = _json(case, catalog, "--rates", "keys,15")
    rows = shown["animals"][0]["rows"]
    case.equal(len(rows), 12, "rows of three encodings, two formats and two rates")
    for row in rows:
        case.equal((set(row), set(row["error"])), (ROW_KEYS, ERROR_KEYS), "keys of a row")
        case.equal(row["form"], f"{row['encoding']} {row['texel_format']}", "form")
        case.check(row["bake_ms"] > 0 and row["decode_ns_per_vertex"] > 0,
                   f"times: expected them above 0, found {row}")
    by_form = {(row["encoding"], row["texel_format"], row["rows"]): row for row in rows}
    for encoding, texels in itertools.product(("mat4", "affine", "dualquat"), ("rgba16f", "rgba32f")):
        at_keys, at_15 = by_form[encoding, texels, "keys"], by_form[encoding, texels, "15 Hz"]
        case.check(at_15["error"]["max"] > 2 * at_keys["error"]["max"],
                   f"{encoding} {texels}: half the rate, expected a larger error")
        texel_bytes = {"mat4": 4, "affine": 3, "dualquat": 2}[encoding] * (8 if texels == "rgba16f" else 16)
        case.equal((at_keys["bytes"], at_15["bytes"]), (60 * 3 * texel_bytes, 30 * 3 * texel_bytes),
                   f"{encoding} {texels}: bytes of 60 and 30 rows of three bones")
    case.equal(shown["animals"][0]["heat_map"], None, "heat map that nobody asked for")
    table = list(csv.DictReader(io.StringIO(case.run("report", catalog, "--rates", "keys", "--format", "csv").stdout)))
    case.equal([row["animal"] for row in table], ["deer"] * 6, "csv")
    first = by_form["mat4", "rgba32f", "keys"]
    case.equal((int(table[0]["bytes"]), float(table[0]["max"]), table[0]["worst_bone"]),
               (first["bytes"], first["error"]["max"], first["error"]["worst"]["bone"]), "csv: first row")
    text = case.run("report", catalog)
    case.equal((text.exit_code, text.stdout.count("deer")), (0, 24 + 24), "exit code and lines of text and totals")


def _by_extension(case):
    catalog = deer(case)
    for name, start in (("r.json", "{"), ("r.CSV", "animal,"), ("r.txt", "animal "), ("r.html", "<!DOCTYPE html>")):
        case.equal(case.run("report", catalog, "--rates", "keys", "-o", name, writes=(name,)).exit_code, 0, name)
        text = read_bytes(case.path(name)).decode()
        case.check(text.startswith(start), f"{name}: expected {start!r} first, found {text[:30]!r}")
    result = case.run("report", catalog, "--rates", "keys", "-o", "r.dat", "--format", "json", writes=("r.dat",))
    case.equal((result.exit_code, json.loads(read_bytes(case.path("r.dat")))["schema"]), (0, "posepack-report-1"),
               "--format before the extension")
    missing = case.run("report", catalog, "--rates", "keys", "-o", "no/such/r.html")
    case.expect_refused(missing, 2, "E-IO-WRITE", ("no/such/r.html",))


def _well_formed(case):
    page = _page(case, deer_and_elk(case), "--rates", "keys,15")
    case.equal(page.faults, [], "faults of the HTML")
    case.equal(len(page.ids), len(set(page.ids)), "ids that stand twice")
    case.check(all(link[:1] == "#" and link[1:] in page.ids for link in page.links), f"links: {page.links}")
    case.check(len(page.links) >= 2, "expected a link an animal")
    case.check(len(drawings(page.text)) > 3 * 12, "expected twelve charts a section")
    for outside in ("http:", "https:", "url(", "@import", "<link", "<img", "src=", "xlink"):
        case.check(outside not in page.text, f"the page refers to something outside: {outside}")
    case.check("default-src 'none'" in page.text, "expected a policy without any resource")
    case.equal(len(page.scripts), 1, "scripts")
    if shutil.which("node") is None:
        case.notes.append("node is not on the PATH: the script was not read")
        return
    case.write("script.js", page.scripts[0])
    read = subprocess.run(["node", "--check", case.path("script.js")], capture_output=True, check=False)
    case.equal(read.returncode, 0, f"node --check ({read.stderr!r})")


def _hostile(case):
    document = glb.tiny_animal(EVIL)
    for node, name in zip(document.json["nodes"], ("<b>mesh", "root&lt;", "sp\x1bine'\"", "</svg><head>")):
        node["name"] = name
    page = _page(case, case.write_animal(document.glb()), "--rates", "keys")
    case.equal(page.faults, [], "faults of the HTML")
    case.equal(len(page.scripts), 1, "scripts")
    drawings(page.text)
    for part in ("<b>mesh", "</svg><head>", "alert(1)</script", "\u202e", "\ufffe", "\x1b"):
        case.check(part not in page.text, f"the page holds {part!r} of a name")
    case.contains(page.text, "&lt;script&gt;alert(1)&lt;/script&gt;", "the page")
    clips = page.section_tables("a0")[0]
    case.equal([row["clip"] for row in clips], [EVIL[0], "\"'&amp;]]>\\u202eevil\\ufffe"], "names of the clips")


def _front_of(points):
    """Indices of points (cost, error) that no other dominates, by the definition."""
    def dominates(a, b):
        return a[0] <= b[0] and a[1] <= b[1] and a != b
    return {i for i, point in enumerate(points) if not any(dominates(other, point) for other in points)}


def _fronts(case):
    catalog = deer_and_elk(case)
    rates = ("--rates", "keys,7,11,15,30,60")
    page, shown = _page(case, catalog, *rates), _json(case, catalog, *rates)
    checked = 0
    for number, animal in enumerate(shown["animals"]):
        drawn = charts(page.section_text(f"a{number}"))
        case.equal(set(drawn), set(itertools.product(ERRORS, COSTS)), "charts of an animal")
        for (error, cost), points in drawn.items():
            case.equal(len(points), len(animal["rows"]), f"points of {error} against {cost}")
            case.equal([chosen for _, _, chosen in points], [row["chosen"] for row in animal["rows"]], "chosen points")
            if cost == "ns":
                continue  # differs from run to run
            front = _front_of([(row[COSTS[cost]], row["error"][error]) for row in animal["rows"]])
            case.equal({i for i, (_, is_front, _) in enumerate(points) if is_front}, front,
                       f"front of {error} against {cost}")
            case.check(0 < len(front) < len(points), f"expected some points on the front, found {sorted(front)}")
            checked += 1
    case.equal(checked, 2 * 3 * 3, "fronts")
    drawn = charts(page.section_text("catalog"))["max", "bytes"]
    front = _front_of([(total["bytes"], total["max"]["worst"]) for total in shown["totals"]])
    case.equal({i for i, (_, is_front, _) in enumerate(drawn) if is_front}, front, "front of the catalog")


def _heat(case):
    for options in ((), ("encoding", "dualquat"), ("texel_format", "rgba32f")):
        catalog = deer(case, output=dict([options] if options else []))
        shown = _json(case, catalog, "--rates", "keys,12", "--heat-map")["animals"][0]
        chosen = next(row for row in shown["rows"] if row["chosen"])
        heat = shown["heat_map"]
        case.equal(heat["bones"], ["root", "spine", "head"], "bones")
        largest = 0.0
        for clip, figures in zip(heat["clips"], shown["clips"]):
            case.equal(len(clip["edges_s"]), len(clip["errors"]) + 1, "edges of the bins")
            case.check(len(clip["errors"]) > 20, "expected many bins")
            worst = max(max(row) for row in clip["errors"])
            case.equal(worst, figures["error"]["max"], f"largest of {clip['name']}, as printed")
            largest = max(largest, worst)
        case.equal(largest, chosen["error"]["max"], "largest of all, as printed")
        place = chosen["error"]["worst"]
        clip = next(clip for clip in heat["clips"] if clip["name"] == place["clip"])
        cells = [(value, bin_number, bone) for bin_number, row in enumerate(clip["errors"])
                 for bone, value in enumerate(row) if value == largest]
        case.check(any(heat["bones"][bone] == place["bone"] and
                       clip["edges_s"][b] - 1e-6 <= place["time_s"] <= clip["edges_s"][b + 1] + 1e-6
                       for _, b, bone in cells), f"expected {place} among {cells}")
    page = _page(case, catalog, "--rates", "keys")
    svg = re.search(r'<svg class="heat".*?</svg>', page.text, re.DOTALL).group(0)
    titles = [float(text) for text in re.findall(r": ([\d.]+e-?\d+) R", svg)]
    case.equal(max(titles), float(page.section_tables("overview")[0][0]["max / R"]), "largest of the map, as printed")


def _chosen(case):
    """What a bake of the catalog writes is marked, whatever the catalog asks for."""
    for fields, options, expected in (
            ({}, (), ("affine rgba16f", "keys")),
            ({"output": {"encoding": "dualquat", "texel_format": "rgba32f"}, "rate_hz": 15}, (),
             ("dualquat rgba32f", "15 Hz")),
            ({"output": {"encoding": "mat4"}, "rate_hz": 22}, (), ("mat4 rgba16f", "22 Hz")),
            ({"clips": [{"name": "Walk", "rate_hz": 10}, "Idle"]}, (), ("affine rgba16f", "catalog"))):
        catalog = deer(case, **fields)
        rows = _json(case, catalog, "--rates", "keys,15", *options)["animals"][0]["rows"]
        chosen = [row for row in rows if row["chosen"]]
        case.equal([(row["form"], row["rows"]) for row in chosen], [expected], f"chosen of {fields}")
        case.equal(len(rows), 12 if expected[1] in ("keys", "15 Hz") else 13, "rows")
        case.expect_ok(case.bake(catalog, measure=True))
        record = case.manifest()["records"][0]
        found = chosen[0]["error"] if chosen else {}
        case.equal({key: found.get(key) for key in ("max", "p999", "rms")},
                   {key: record["error"][key] for key in ("max", "p999", "rms")}, "errors, as the bake has them")


def _refused(case):
    """A form that an animal cannot have is said and left out; the rest is reported."""
    catalog = case.write_animal(_stretching().glb(), output={"encoding": "dualquat"})
    result = case.run("report", catalog, "--rates", "keys", "--format", "json")
    case.equal((result.exit_code, len(result.lines("error"))), (0, 2), "exit code and refusals on stderr")
    shown = result.json()["animals"][0]
    case.equal([(form["form"], form["rows"], form["issue"]["code"]) for form in shown["refused"]],
               [("dualquat rgba32f", "keys", "E-LIM-SIMILARITY"), ("dualquat rgba16f", "keys", "E-LIM-SIMILARITY")],
               "refused forms")
    case.equal((len(shown["rows"]), [row["chosen"] for row in shown["rows"] if row["chosen"]]), (4, []), "rows")
    case.equal((shown["clips"], shown["heat_map"]), ([], None), "clips and heat map of what was refused")
    page = Page(case.run("report", catalog, "--rates", "keys", "--format", "html").stdout)
    case.equal(page.faults, [], "faults of the HTML")
    case.equal(page.text.count("E-LIM-SIMILARITY"), 2, "refusals in the page")


def _repeatable(case):
    catalog = deer_and_elk(case)
    shown = [_json(case, catalog, "--rates", "keys,15", "--heat-map") for _ in range(2)]
    case.equal(_without_times(shown[0]), _without_times(shown[1]), "two reports but for their times")
    pages = [_page(case, catalog, "--rates", "keys,15").text for _ in range(2)]
    parts = [re.findall(r'<div class="e-\w+ k-(?:bytes|fetches|alu)">.*?</svg>|<svg class="heat".*?</svg>', page, re.DOTALL)
             for page in pages]
    case.equal(len(parts[0]), 3 * 9 + 2, "drawings that hold no times")
    case.check(parts[0] == parts[1], "drawings differ from run to run")


def _documented_costs(case):
    """Fetches and operations are those of the encodings' pages."""
    rows = _json(case, deer(case), "--rates", "keys")["animals"][0]["rows"]
    for row in rows:
        with open(f"{case.settings.project}/docs/encodings/{row['encoding']}.md", encoding="utf-8") as file:
            page = file.read()
        fetches = re.search(r"\| texel fetches, 4 influences and 2 rows \| (\d+) \|", page)
        operations = re.search(r"\| scalar operations .*? \| about (\d+) \|", page)
        case.equal((row["fetches"], row["alu_operations"]), (int(fetches.group(1)), int(operations.group(1))),
                   f"costs of {row['form']}")


ROWS = [
    Row("E01", "report: json, csv, text", _formats),
    Row("E02", "report: the format by the name of the output", _by_extension),
    Row("E03", "report: the page is well formed and alone", _well_formed),
    Row("E04", "report: hostile names in the page", _hostile),
    Row("E05", "report: Pareto fronts against their definition", _fronts),
    Row("E06", "report: the heat map's largest is the printed one", _heat),
    Row("E07", "report: the chosen row is what a bake writes", _chosen),
    Row("E08", "report: forms that an animal cannot have", _refused),
    Row("E09", "report: equal but for times", _repeatable),
    Row("E10", "report: costs are those of the documents", _documented_costs),
]
