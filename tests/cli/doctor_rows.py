# SPDX-License-Identifier: MIT
"""doctor: what it says of good, odd, repaired and refused models, and that it answers as a bake does."""

import re

import glb
from harness import Row

CONTROL = re.compile(rb"[\x00-\x09\x0b-\x1f\x7f]")


def _examine(case, data, *options, name="deer.glb"):
    """The exit code and the JSON of doctor on these bytes."""
    case.write(name, data)
    result = case.run("doctor", name, "--format", "json", *options, writes=())
    case.equal(result.stderr, "", "stderr")
    return result.exit_code, result.json()


def _good(case):
    exit_code, shown = _examine(case, glb.tiny_animal().glb())
    case.equal((exit_code, shown["ok"], shown["refusal"], shown["strict_refusal"]), (0, True, None, None), "verdict")
    case.equal((shown["skeleton"]["bones"], shown["contents"]["skins"][0]["joints"]), (3, 3), "bones and joints")
    case.equal([clip["name"] for clip in shown["clips"]], ["Walk", "Idle"], "clips")
    text = case.run("doctor", "deer.glb", writes=())
    case.equal(text.exit_code, 0, "exit code of text")
    for part in ("deer.glb: can be baked", "What is in the file", "Clips (2)", "Walk", "What a bake would give",
                 "mat4 RGBA32F", "affine RGBA16F"):
        case.contains(text.stdout, part, "text")


def _as_a_bake(case):
    """Rows, bytes and error are those of a bake of the same file."""
    data = glb.tiny_animal().glb()
    _, shown = _examine(case, data)
    case.expect_ok(case.bake(case.write_animal(data), measure=True))
    record = case.manifest()["records"][0]
    bake = shown["bake"]
    for ours, theirs in (("rows", "row_count"), ("bones", "bone_count"), ("vertices", "vertex_count"),
                         ("texel_bytes", "texel_bytes"), ("encoding", "encoding")):
        case.equal(bake[ours], record[theirs], ours)
    case.check(abs(bake["error"]["max_m"] - record["error"]["max_m"]) <= 1e-6 * record["error"]["max_m"],
               f"error: expected {record['error']['max_m']}, found {bake['error']['max_m']}")
    for clip, baked in zip(shown["clips"], record["clips"]):
        case.equal((clip["name"], clip["plan"]["rows"], clip["plan"]["wrap"]),
                   (baked["name"], baked["row_count"], baked["wrap"]), "clip")
    sizes = {form["form"]: form["bytes"] for form in bake["forms"]}
    texels = record["row_count"] * record["bone_count"]
    case.equal(sizes, {"mat4 RGBA32F": texels * 64, "mat4 RGBA16F": texels * 32, "affine RGBA32F": texels * 48,
                       "affine RGBA16F": texels * 24, "dualquat RGBA16F": texels * 16}, "bytes of the forms")
    _, quick = _examine(case, data, "--no-measure")
    case.equal((quick["bake"]["error"], quick["bake"]["rows"]), (None, record["row_count"]), "--no-measure")


def _repaired(case):
    document = glb.tiny_animal()
    document.put("weights", 0, -1.0, 1.0)
    exit_code, shown = _examine(case, document.glb())
    found = [(finding["code"], finding["treatment"]) for finding in shown["findings"]]
    case.equal((exit_code, found), (0, [("W-GLB-WEIGHTS", "repair")]), "findings")
    case.equal(shown["strict_refusal"]["code"], "E-GLB-WEIGHTS", "what --strict would answer")
    text = case.run("doctor", "deer.glb", writes=()).stdout
    for part in ("1 repair,", "What is repaired", "1 vertex", "With --strict it would be refused"):
        case.contains(text, part, "text")
    exit_code, strict = _examine(case, document.glb(), "--strict")
    case.equal((exit_code, strict["exit_code"], strict["refusal"]["code"], strict["bake"]),
               (3, 3, "E-GLB-WEIGHTS", None), "--strict")


def _odd(case):
    document = glb.tiny_animal()
    document.json["nodes"].append({"name": "Armature", "scale": [100, 100, 100], "children": [1]})
    document.json["nodes"][0]["translation"] = [1, 2, 3]
    document.json["images"] = [{"uri": "picture.png"}]
    exit_code, shown = _examine(case, document.glb())
    case.equal((exit_code, sorted(oddity["id"] for oddity in shown["odd"])),
               (0, ["armature-scale", "huge", "mesh-node-moved", "outside-images"]), "oddities")
    case.equal([round(value, 6) for value in shown["skeleton"]["armature_scale"]], [100, 100, 100], "scale")


def _left_out(case):
    document = glb.tiny_animal()
    mesh = document.json["meshes"][0]
    mesh["name"] = "Body"
    mesh["primitives"][0]["targets"] = [{"POSITION": document.names["positions"]}]
    document.json["meshes"].append({"name": "Antler", "primitives": [
        {"attributes": {"POSITION": document.names["positions"]}}]})
    document.json["nodes"].append({"name": "Antler", "mesh": 1})
    exit_code, shown = _examine(case, document.glb())
    case.equal((exit_code, {finding["treatment"] for finding in shown["findings"]}), (0, {"left-out"}), "findings")
    case.equal((shown["contents"]["rigid_nodes"], shown["contents"]["morphed_meshes"]), (["Antler"], ["Body"]),
               "names of what is left out")
    text = case.run("doctor", "deer.glb", writes=()).stdout
    for part in ("What is left out of the palette", "1 rigid mesh that nothing moves: not in the palette (Antler)", "1 in Body"):
        case.contains(text, part, "text")


def _refused(case):
    """Exit code, id and advice of every stage are those of a bake."""
    still = glb.tiny_animal()
    del still.json["animations"]
    morph = glb.tiny_animal()
    for animation in morph.json["animations"]:
        for channel in animation["channels"]:
            channel["target"] = {"node": 0, "path": "weights"}
    far = glb.tiny_animal()
    far.json["nodes"][1]["translation"] = [70_000, 0, 0]
    for data, exit_code, code, is_read in ((b"", 3, "E-GLB-TRUNCATED", False),
                                           (still.glb(), 5, "E-GLB-NO-ANIMATION", True),
                                           (morph.glb(), 5, "E-GLB-MORPH-ONLY", True),
                                           (far.glb(), 6, "E-LIM-HALF-RANGE", True)):
        found, shown = _examine(case, data)
        case.equal((found, shown["exit_code"], shown["refusal"]["code"], shown["ok"]),
                   (exit_code, exit_code, code, False), f"refusal {code}")
        case.equal((shown["contents"] is not None, shown["bake"]), (is_read, None), f"what is left of {code}")
        baked = case.bake(case.write_animal(data), output="refused")
        case.equal(baked.exit_code, exit_code, f"exit code of bake for {code}")
        text = case.run("doctor", "deer.glb", writes=())
        case.equal((text.exit_code, text.stderr), (exit_code, ""), f"text of {code}")
        for part in ("cannot be baked", f"error[{code}]", "; try: ", f"exit code {exit_code}"):
            case.contains(text.stdout, part, f"text of {code}")
    case.expect_refused(case.run("doctor", "missing.glb", writes=()), 2, "E-IO-OPEN", ("missing.glb",))


def _hostile(case):
    document = glb.tiny_animal(("W\x1b[31malk\x07", "\u202eevil\u009b", "x" * 200))
    document.json["asset"]["generator"] = "gen\x1b]0;title\x07" + "y" * 500
    document.json["nodes"][2]["name"] = "sp\x1b[1mine"
    document.json["extensionsUsed"] = ["ACME_\x1b[1m"]
    case.write("de\x1b[1mer.glb", document.glb())
    for options in ((), ("--format", "json")):
        result = case.run("doctor", "de\x1b[1mer.glb", *options, writes=())
        case.equal(result.exit_code, 0, f"exit code (stderr {result.stderr!r})")
        case.check(not CONTROL.search(result.stdout_bytes), "control characters in the report")


ROWS = [
    Row("D01", "doctor: a good model", _good),
    Row("D02", "doctor: the figures of a bake", _as_a_bake),
    Row("D03", "doctor: repairs, and --strict", _repaired),
    Row("D04", "doctor: oddities", _odd),
    Row("D05", "doctor: what is left out, by name", _left_out),
    Row("D06", "doctor: refusals at every stage, as a bake gives them", _refused),
    Row("D07", "doctor: hostile names", _hostile),
]
