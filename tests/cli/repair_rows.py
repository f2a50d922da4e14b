# SPDX-License-Identifier: MIT
"""What is repaired with one warning that counts, and refused under --strict; and what is refused always."""

import json
import math

import glb
from harness import Row

NAN, INFINITY = float("nan"), float("inf")


def _weights(*changes):
    """Overwrites the four weights of vertices: (vertex, weights)."""
    def change(document):
        for vertex, weights in changes:
            document.put("weights", 4 * vertex, *weights)
    return change


def _more_influences(document):
    """A second set for all vertices: six influences of 1/6 on three vertices, nothing on the others."""
    count = document.accessor("positions")["count"]
    many = (0, 5, 9)
    joints, weights = [], []
    for number, (name, _, height) in enumerate(glb.JOINTS[1:], 1):
        document.json["nodes"].append({"name": name + "_2", "translation": [0.0, 0.1, 0.0]})
        document.json["nodes"][number].setdefault("children", []).append(len(document.json["nodes"]) - 1)
    extra = [len(document.json["nodes"]) - 2, len(document.json["nodes"]) - 1]
    document.json["skins"][0]["joints"] += extra
    binds = []
    for _, _, height in glb.JOINTS + [("", 0, 0.1), ("", 0, 0.6)]:
        binds += [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -height, 0, 1]
    document.json["skins"][0]["inverseBindMatrices"] = document.add("more_binds", binds, "MAT4")
    for vertex in range(count):
        is_many = vertex in many
        joints += [4, 0, 0, 0]
        weights += [0.2 if is_many else 0.0, 0.0, 0.0, 0.0]
        if is_many:
            document.put("joints", 4 * vertex, 0, 1, 2, 3)
            document.put("weights", 4 * vertex, 0.2, 0.2, 0.2, 0.2)
    attributes = document.json["meshes"][0]["primitives"][0]["attributes"]
    attributes["JOINTS_1"] = document.add("joints_1", joints, "VEC4", glb.UBYTE)
    attributes["WEIGHTS_1"] = document.add("weights_1", weights, "VEC4")


def _near_times(document):
    times = [0, 0.5, 0.5 + 5e-7, 1]
    document.add("few_times", times, "SCALAR")
    document.add("few_values", [0, 0, 0] * 4, "VEC3")
    document.json["animations"][1]["samplers"] = [{"input": document.names["few_times"],
                                                   "output": document.names["few_values"]}]


def _long_quaternions(document):
    for key in (3, 8, 9):
        document.put("spine", 4 * key, *[1.5 * part for part in glb.quaternion_z(0.5 * glb.wave(key))])


def _two_channels(document):
    clip = document.json["animations"][0]
    clip["samplers"].append({"input": document.names["times"], "output": document.names["head"]})
    clip["channels"].append(glb.channel(2, "rotation", 2))


# name, title, change, warning, what it counts, error under --strict
REPAIRED = [
    ("R01", "NaN weights", _weights((2, [NAN, 0.5, 0, 0]), (7, [0.5, NAN, NAN, 0])), "W-GLB-WEIGHTS", "2",
     "E-GLB-WEIGHTS"),
    ("R02", "negative weights", _weights((1, [-0.5, 1, 0, 0]), (2, [0.75, -0.25, 0, 0]), (3, [1, 0, 0, -1])),
     "W-GLB-WEIGHTS", "3", "E-GLB-WEIGHTS"),
    ("R03", "weight sums of 0.18 and 1.76", _weights((4, [0.1, 0.08, 0, 0]), (8, [0.88, 0.88, 0, 0])),
     "W-GLB-WEIGHTS", "2", "E-GLB-WEIGHTS"),
    ("R04", "key times 5e-7 s apart", _near_times, "W-GLB-TIMES", "1", "E-GLB-TIMES"),
    ("R05", "rotation keys of length 1.5", _long_quaternions, "W-GLB-QUAT", "3", "E-GLB-QUAT"),
    ("R06", "two channels on one target", _two_channels, "W-GLB-CHANNEL", "1", "E-GLB-CHANNEL"),
    ("R07", "five influences on three vertices", _more_influences, "W-GLB-INFLUENCES", "3", "E-GLB-WEIGHTS"),
]


def _repaired_row(name, title, change, warning, count, error):
    def run(case):
        document = glb.tiny_animal()
        change(document)
        catalog = case.write_animal(document.glb(), clips=[{"name": "*", "wrap": "once"}])
        result = case.bake(catalog)
        case.expect_ok(result, [warning])
        case.check(f" {count} " in result.stderr,
                   f"the warning: expected the count {count}, found {result.stderr}")
        if case.output():
            case.equal(len(case.manifest()["records"][0]["remarks"]), 1, "remarks in the manifest")
        case.expect_bake_refused(catalog, 3, error, "--strict", mentions=("deer.glb",), output="strict")
    return Row(name, title + ": repaired with one warning, refused under --strict", run)


def _set_bind(value):
    return lambda document: document.put("binds", 16 + 13, value)


def _zero_rest(document):
    document.json["nodes"][2]["rotation"] = [0, 0, 0, 0]


def _no_moving_channel(document):
    document.json["animations"] = [{"name": "Still", "samplers": [], "channels": []}]


def _morph_only(document):
    """A morph target on the mesh, moved by the only clip; no skin."""
    for node in document.json["nodes"]:
        node.pop("skin", None)
    document.json.pop("skins")
    primitive = document.json["meshes"][0]["primitives"][0]
    primitive["attributes"] = {"POSITION": primitive["attributes"]["POSITION"]}
    primitive["targets"] = [{"POSITION": document.names["normals"]}]
    document.add("factors", [glb.wave(key) for key in range(glb.KEY_COUNT)], "SCALAR")
    document.json["animations"] = [{"name": "Morph", "channels": [glb.channel(0, "weights", 0)],
                                    "samplers": [{"input": document.names["times"],
                                                  "output": document.names["factors"]}]}]


def _no_mesh(document):
    document.json.pop("skins")
    document.json["nodes"][0].pop("skin")
    document.json["nodes"][0].pop("mesh")


# name, title, change, exit code, issue (None: any of that exit code), mentions
REFUSED = [
    ("R10", "NaN in a key", lambda d: d.put("root", 4, NAN), 3, "E-GLB-NUMBER", ()),
    ("R11", "infinity in a key time", lambda d: d.put("times", glb.KEY_COUNT - 1, INFINITY), 3,
     "E-GLB-NUMBER", ()),
    ("R12", "infinity in a position", lambda d: d.put("positions", 31, INFINITY), 3, "E-GLB-NUMBER", ()),
    ("R13", "NaN in an inverse bind", _set_bind(NAN), 3, "E-GLB-NUMBER", ()),
    ("R14", "rest rotation of zeros", _zero_rest, 3, "E-GLB-QUAT", ()),
    ("R15", "clip without a channel", _no_moving_channel, 5, "E-GLB-NO-ANIMATION", ()),
    ("R16", "moves by morph targets only", _morph_only, 5, "E-GLB-MORPH-ONLY", ("VAT",)),
    ("R17", "moves nodes without a mesh", _no_mesh, 5, "E-GLB-NO-MESH", ()),
]


def _refused_row(name, title, change, exit_code, issue, mentions):
    def run(case):
        document = glb.tiny_animal()
        change(document)
        catalog = case.write_animal(document.glb())
        case.expect_bake_refused(catalog, exit_code, issue, mentions=mentions)
        case.expect_bake_refused(catalog, exit_code, issue, "--strict", mentions=mentions)
    return Row(name, title + ": refused, with and without --strict", run)


def _last_channel_wins(case):
    """The doubled channel of the spine has the head's keys: the bake must equal one that has only those."""
    document = glb.tiny_animal()
    _two_channels(document)
    alone = glb.tiny_animal()
    alone.json["animations"][0]["samplers"][0]["output"] = alone.names["head"]
    matrices = []
    for name, made in (("doubled", document), ("alone", alone)):
        case.bake(case.write_animal(made.glb(), clips=["Walk"]), output=name)
        matrices.append([case.matrix(f"{name}/deer.posepack", row, "spine") for row in (3, 11)])
    case.equal(matrices[0], matrices[1], "spine where two channels move it")
    turn = 0.7 * glb.wave(3, 2)
    case.check(abs(matrices[0][0][0] - math.cos(turn)) < 1e-3, f"spine at key 3: expected a turn by {turn}")


def _influences_left_out(case):
    """What four of five influences cost stands in the warning and the manifest; of eight there is no word."""
    document = glb.tiny_animal()
    _more_influences(document)
    catalog = case.write_animal(document.glb(), clips=[{"name": "*", "wrap": "once"}])
    result = case.bake(catalog, measure=True)
    case.expect_ok(result, ["W-GLB-INFLUENCES"])
    case.contains(result.stderr, "moves 3 vertices of the model by at most", "the warning")
    reduction = case.manifest()["records"][0]["reduction"]
    case.equal((reduction["vertex_count"], reduction["influences_most"]), (3, 5), "what lost influences")
    case.check(0 < reduction["rms"] <= reduction["max"] < 0.5, f"expected a share of R, found {reduction}")
    case.expect_ok(case.run("verify", "--strict", "out"))
    case.expect_ok(case.bake(catalog, "--influences", 8, "--strict", output="eight", measure=True))
    case.equal(case.manifest("eight")["records"][0]["reduction"], None, "reduction where eight are kept")
    case.equal(case.manifest("eight")["options"], {"influences": 8, "strict": True}, "options in the manifest")
    case.expect_refused(case.bake(catalog, "--influences", 6, output="six"), 1, "E-USAGE", ("4 or 8", "6"))


def _unused_bones(case):
    """Named by doctor and inspect, kept unless asked or a bound chooses; the joint map says which joints have none."""
    document = glb.tiny_animal()
    document.json["nodes"].append({"name": "Pole"})
    document.json["nodes"][1]["children"].append(len(document.json["nodes"]) - 1)
    document.json["skins"][0]["joints"].append(len(document.json["nodes"]) - 1)
    document.json["skins"][0].pop("inverseBindMatrices")
    catalog = case.write_animal(document.glb())
    text = case.run("doctor", "models/deer.glb", writes=()).stdout
    case.contains(text, "1 bone moves no vertex: Pole", "doctor")
    case.expect_ok(case.bake(catalog))
    case.contains(case.run("inspect", "out/deer.posepack", writes=()).stdout,
                  "unused    1 bone without a vertex: Pole", "inspect")
    case.expect_ok(case.bake(catalog, "--unused-bones", "drop", output="dropped"))
    text = case.run("inspect", "dropped/deer.posepack", writes=()).stdout
    case.contains(text, "1 joint without a bone", "inspect of the smaller one")
    shown = json.loads(case.run("inspect", "--format", "json", "dropped/deer.posepack", writes=()).stdout)
    case.equal(shown["space"]["meshes"][0]["bone_of_joint"], [0, 1, 2, None], "joint map")
    case.equal(shown["bone_count"], 3, "bones")
    case.expect_ok(case.run("verify", "--strict", "dropped"))
    bounded = ("--max-error", "default")
    case.expect_ok(case.bake(catalog, *bounded, output="chosen", measure=True))
    case.equal(case.manifest("chosen")["records"][0]["bone_count"], 3, "bones under a bound")
    case.expect_ok(case.bake(catalog, *bounded, "--unused-bones", "keep", output="kept", measure=True))
    case.equal(case.manifest("kept")["records"][0]["bone_count"], 4, "bones under a bound that keeps them")


def _one_point(case):
    """No size to measure an error by: baked or refused by name, but not called a bad container."""
    document = glb.tiny_animal()
    document.put("positions", 0, *[0.0] * 3 * document.accessor("positions")["count"])
    result = case.bake(case.write_animal(document.glb()))
    case.check(result.exit_code in (0, 3, 5),
               f"exit code: expected 0, 3 or 5, found {result.exit_code} ({result.stderr})")
    case.expect_bounded(result, "bake")


ROWS = [_repaired_row(*row) for row in REPAIRED] + [_refused_row(*row) for row in REFUSED] + [
    Row("R18", "every vertex in one point", _one_point),
    Row("R21", "of five influences four are kept, measured; or all", _influences_left_out),
    Row("R22", "a bone that moves no vertex", _unused_bones),
    Row("R20", "of two channels on one target the last wins", _last_channel_wins),
]
