# SPDX-License-Identifier: MIT
"""Limits of the baker: what lies on one is baked, one more is refused before it costs anything."""

import glb
from harness import Row

MAX_BONES, MAX_ROWS, MAX_NODE_DEPTH, MAX_NAME_BYTES = 1024, 65_536, 4096, 255
MAX_DURATION_S = 600.0
MAX_TEXTURE_TEXELS = 4096


def _bones(count):
    """The tiny animal with joints hung on its root until there are `count`."""
    document = glb.tiny_animal()
    joints = document.json["skins"][0]["joints"]
    for number in range(len(joints), count):
        document.json["nodes"].append({"name": f"extra_{number}"})
        joints.append(len(document.json["nodes"]) - 1)
    document.json["nodes"][1]["children"] += joints[3:]
    document.json["skins"][0].pop("inverseBindMatrices")
    return document


def _depth(count):
    """A chain under the head that makes the hierarchy `count` nodes deep, its root counted."""
    document = glb.tiny_animal()
    parent = 3  # third of its chain
    for _ in range(count - 3):
        document.json["nodes"].append({})
        document.json["nodes"][parent]["children"] = [len(document.json["nodes"]) - 1]
        parent = len(document.json["nodes"]) - 1
    return document


def _duration(last_s):
    """The clip "Walk" as two keys, the last at that time."""
    document = glb.tiny_animal(("Walk",))
    document.add("two_times", [0.0, last_s], "SCALAR")
    document.add("two_keys", [0, 0, 0, 1, 0, 0], "VEC3")
    document.json["animations"] = [{"name": "Walk", "channels": [glb.channel(1, "translation", 0)],
                                    "samplers": [{"input": document.names["two_times"],
                                                  "output": document.names["two_keys"]}]}]
    return document


def _row(name, what, makes, options, issue):
    """`makes` gives the document on the limit and the one beyond it; `options` go with each."""
    def run(case):
        on_limit, beyond = makes()
        on_options, beyond_options = options
        result = case.bake(case.write_animal(on_limit.glb(), clips=[{"name": "Walk", "wrap": "once"}]),
                           *on_options)
        case.equal(result.exit_code, 0, f"exit code on the limit (stderr {result.stderr})")
        catalog = case.write_animal(beyond.glb(), clips=[{"name": "Walk", "wrap": "once"}])
        case.expect_bake_refused(catalog, 6, issue, *beyond_options, output="beyond")
    return Row(name, f"limit: {what}", run)


def _names(case):
    """Joint names over 255 bytes are refused, or shortened: never stored."""
    for length in (MAX_NAME_BYTES, MAX_NAME_BYTES + 1):
        document = glb.tiny_animal()
        document.json["nodes"][2]["name"] = "s" * length
        catalog = case.write_animal(document.glb())
        if length > MAX_NAME_BYTES:
            case.expect_bake_refused(catalog, 6, "E-LIM-STRING", output="beyond")
        elif case.expect_ok(case.bake(catalog)):
            case.equal(case.inspect("out/deer.posepack")["bones"][1]["name"], "s" * length,
                       "name of the spine")


def _texture(case):
    """1,024 bones fill a line of 3,072 texels: 10,000 rows and more need as many lines."""
    document = _bones(MAX_BONES)
    document.put("times", glb.KEY_COUNT - 1, 10.0)
    catalog = case.write_animal(document.glb(), clips=[{"name": "Walk", "wrap": "once"}])
    case.expect_bake_refused(catalog, 6, "E-LIM-TEXTURE", "--rate", 1000, "--caps", "webgl2",
                             mentions=(f"{MAX_TEXTURE_TEXELS}",))


def _shared_output(case):
    """60,000 channels of one sampler: its values are read once, and the last channel wins."""
    document = glb.tiny_animal(("Walk",))
    channels = document.json["animations"][0]["channels"]
    channels += [channels[0]] * 60_000
    result = case.bake(case.write_animal(document.glb(), clips=[{"name": "Walk"}]))
    case.expect_ok(result, warnings=["W-GLB-CHANNEL"])


def _instances(case):
    """60,000 nodes that draw one mesh: the vertices they ask for are counted before they are made."""
    document = glb.tiny_animal()
    document.json["nodes"] += [{"mesh": 0, "skin": 0}] * 60_000
    case.expect_bake_refused(case.write_animal(document.glb()), 6, "E-LIM-DECODED")


def _empty_objects(case):
    """Three bytes of text an item, and hundreds in a parser's tree."""
    for key, count in (("nodes", 70_000), ("accessors", 2_000_000), ("materials", 2_000_000)):
        document = glb.tiny_animal()
        text = document.text()[:-1].replace(f'"{key}": ['.encode(), f'"{key}": [{"{},"*count}'.encode())
        if f'"{key}": ['.encode() not in text:
            text += f', "{key}": [{"{},"*count}{{}}]'.encode()
        case.expect_bake_refused(case.write_animal(glb.make_glb(text + b"}", bytes(document.bin))), 6,
                                 "E-LIM-COUNT")


def _work(case):
    """80,000 vertices under 70,000 keys of no grid: hours to measure, refused before that, baked without."""
    document = _duration(600.0)
    vertices, keys = 80_000, 70_000
    document.add("many_places", [value for v in range(vertices) for value in (v % 300, v // 300, 1)], "VEC3")
    document.add("many_joints", [0, 0, 0, 0] * vertices, "VEC4", glb.UBYTE)
    document.add("many_weights", [1, 0, 0, 0] * vertices, "VEC4")
    document.json["meshes"][0]["primitives"] = [{"mode": 0, "attributes": {
        "POSITION": document.names["many_places"], "JOINTS_0": document.names["many_joints"],
        "WEIGHTS_0": document.names["many_weights"]}}]
    document.add("many_times", [key * 0.008 + 0.002 * (key * key % 3) for key in range(keys)], "SCALAR")
    document.add("many_keys", [value for key in range(keys) for value in (key % 2, 0, 0)], "VEC3")
    document.json["animations"][0]["samplers"] = [{"input": document.names["many_times"],
                                                   "output": document.names["many_keys"]}]
    catalog = case.write_animal(document.glb(), clips=[{"name": "Walk", "wrap": "once"}])
    case.expect_bake_refused(catalog, 6, "E-LIM-WORK", "--rate", 1, measure=True)
    case.expect_ok(case.bake(catalog, "--rate", 1))


ROWS = [
    _row("L01", f"{MAX_BONES:,} bones", lambda: (_bones(MAX_BONES), _bones(MAX_BONES + 1)), ((), ()),
         "E-LIM-BONES"),
    _row("L02", f"nodes {MAX_NODE_DEPTH:,} deep",
         lambda: (_depth(MAX_NODE_DEPTH), _depth(MAX_NODE_DEPTH + 1)), ((), ()),
         "E-LIM-NODE-DEPTH"),
    _row("L03", f"{MAX_DURATION_S:.0f} s",
         lambda: (_duration(MAX_DURATION_S), _duration(MAX_DURATION_S + 0.125)),
         (("--rate", 1), ("--rate", 1)), "E-LIM-DURATION"),
    _row("L04", f"{MAX_ROWS:,} rows", lambda: (_duration(65.535), _duration(65.536)),
         (("--rate", 1000), ("--rate", 1000)), "E-LIM-ROWS"),
    Row("L05", "limit: names of 255 bytes", _names),
    Row("L06", "limit: textures of the named caps", _texture),
    Row("L07", "memory: channels that share an output", _shared_output),
    Row("L08", "memory: a mesh drawn by 60,000 nodes", _instances),
    Row("L09", "memory: millions of empty objects", _empty_objects),
    Row("L10", "work: what measuring may look at", _work),
]
