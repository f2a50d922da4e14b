# SPDX-License-Identifier: MIT
"""Matrices that come out of a container, against arithmetic in double precision here."""

import math
import struct

import glb
from harness import Row

TOLERANCE = 2e-6  # of values up to about 4, stored as 32-bit floats


def _float32(value):
    return struct.unpack("<f", struct.pack("<f", value))[0]


def multiply(a, b):
    """Product of two 4x4 matrices, rows of rows."""
    return [[sum(a[r][k] * b[k][c] for k in range(4)) for c in range(4)] for r in range(4)]


def local_matrix(translation=(0, 0, 0), rotation=(0, 0, 0, 1), scale=(1, 1, 1)):
    """Translation x rotation x scale (glTF 2.0, section 3.5.3)."""
    length = math.sqrt(sum(part * part for part in rotation))
    x, y, z, w = (part / length for part in rotation)
    turn = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    rows = [[turn[r][c] * scale[c] for c in range(3)] + [translation[r]] for r in range(3)]
    return rows + [[0, 0, 0, 1]]


def _chain():
    """The tiny animal with plain nodes above and between its joints: node -> (parent, local transform)."""
    return {4: (None, {"translation": [0.3, 0.1, -0.2], "rotation": [0.5, 0.5, 0.5, 0.5]}),
            1: (4, {"translation": [0.0, 0.25, 0.0]}),
            5: (1, {"rotation": [0.0, 0.6, 0.0, 0.8], "scale": [1.5, 0.75, 2.0]}),
            2: (5, {"translation": [0.0, 0.5, 0.0]}),
            6: (2, {"translation": [0.1, 0.2, 0.3], "rotation": [0.28, 0.0, 0.0, 0.96],
                    "scale": [0.5, 1.25, 0.8]}),
            7: (6, {"scale": [1.0, -1.0, 1.0]}),
            3: (7, {"translation": [0.0, 0.5, 0.0]})}


def _separated_document():
    document = glb.tiny_animal()
    nodes = document.json["nodes"]
    nodes += [{"name": f"plain_{index}"} for index in (4, 5, 6, 7)]
    for node in nodes:
        node.pop("children", None)
    for index, (parent, transform) in _chain().items():
        nodes[index] = {"name": nodes[index]["name"], **transform,
                        **{"children": nodes[index].get("children", [])}}
        if parent is not None:
            nodes[parent].setdefault("children", []).append(index)
    for node in nodes:
        if not node.get("children"):
            node.pop("children", None)
    document.json["scenes"][0]["nodes"] = [0, 4]
    return document


def _expected(joint, key):
    """The bone's matrix at a key of "Walk": global transform x inverse bind."""
    bend = {2: 0.5 * glb.wave(key), 3: 0.7 * glb.wave(key, 2)}
    node, matrix = joint, local_matrix()
    while node is not None:
        parent, transform = _chain()[node]
        if node in bend:
            transform = {**transform, "rotation": [_float32(part) for part in glb.quaternion_z(bend[node])]}
        matrix = multiply(local_matrix(**transform), matrix)
        node = parent
    height = glb.JOINTS[joint - glb.FIRST_JOINT_NODE][2]
    return multiply(matrix, local_matrix(translation=(0, -height, 0)))


def _joints_apart(case):
    catalog = case.write_animal(_separated_document().glb(), clips=[{"name": "Walk", "wrap": "once"}])
    if not case.expect_ok(case.bake(catalog, "--texel-format", "rgba32f", "--space", "model", measure=True)):
        return
    shown = case.inspect("out/deer.posepack")
    case.equal([bone["name"] for bone in shown["bones"]], ["root", "spine", "head"], "bones")
    case.equal(shown["row_count"], glb.KEY_COUNT, "rows of a once clip on its key grid")
    worst = 0.0
    for key in (0, 1, 7, 15, 22, 30):
        for bone in range(3):
            found = case.matrix("out/deer.posepack", key, bone)
            expected = _expected(glb.FIRST_JOINT_NODE + bone, key)
            worst = max(worst,
                        max(abs(found[4 * r + c] - expected[r][c]) for r in range(3) for c in range(4)))
    case.check(worst < TOLERANCE,
               f"18 matrices: expected to differ by less than {TOLERANCE}, found {worst:.3g}")
    error = shown["clips"][0]["error"]["max"]
    # The head turns by up to 0.29 rad from key to key: a chord lies 1 % of the arm inside its arc.
    case.check(0.001 < error < 0.03,
               f"measured error at 30 Hz in RGBA32F: expected about 0.01 R, found {error}")


def _mesh_node_is_ignored(case):
    """glTF 2.0, section 3.7.3.3: the transform of a skinned mesh's own node does not count."""
    moved = glb.tiny_animal()
    moved.json["nodes"][0].update(translation=[5, 6, 7], rotation=[0, 1, 0, 0], scale=[2, 2, 2])
    case.write("models/deer.glb", glb.tiny_animal().glb())
    case.write("models/moved.glb", moved.glb())
    catalog = case.write_catalog({"deer": {"model": "deer.glb"}, "moved": {"model": "moved.glb"}})
    case.expect_ok(case.bake(catalog))
    plain, other = (case.matrix(f"out/{name}.posepack", 9, "head") for name in ("deer", "moved"))
    case.equal(other, plain, "head of an animal whose mesh node is moved")


ROWS = [
    Row("G39", "MUST PASS: joints separated by plain nodes", _joints_apart),
    Row("G39b", "the mesh node's transform is ignored", _mesh_node_is_ignored),
]
