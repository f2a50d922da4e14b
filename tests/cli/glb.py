# SPDX-License-Identifier: MIT
"""GLB files made from nothing: the container's bytes, and a tiny animal that bakes in a few milliseconds.

A Document is edited like the data it is (its JSON is a dict, its BIN chunk a bytearray), so that a test
says in a line what is wrong with its file.
"""

import json
import math
import struct

BYTE, UBYTE, SHORT, USHORT, UINT, FLOAT = 5120, 5121, 5122, 5123, 5125, 5126
COMPONENT = {BYTE: "b", UBYTE: "B", SHORT: "h", USHORT: "H", UINT: "I", FLOAT: "f"}
WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
JSON_CHUNK, BIN_CHUNK = b"JSON", b"BIN\0"

RATE_HZ = 30
KEY_COUNT = 31  # one second with both ends


def chunk(kind, data, fill=b"\0"):
    """A GLB chunk: length, type, data filled up to a multiple of four bytes (glTF 2.0, section 4.4.3)."""
    data = bytes(data) + fill * (-len(data) % 4)
    return struct.pack("<I", len(data)) + kind + data


def glb_from_chunks(chunks, version=2, length=None):
    """A GLB of ready chunks; `length` overrides the length that the header declares."""
    body = b"".join(chunks)
    return b"glTF" + struct.pack("<II", version, 12 + len(body) if length is None else length) + body


def make_glb(document, binary):
    """A GLB of a JSON value (or JSON bytes) and the bytes of the BIN chunk."""
    text = document if isinstance(document, bytes) else json.dumps(document).encode()
    chunks = [chunk(JSON_CHUNK, text, b" ")]
    if binary:
        chunks.append(chunk(BIN_CHUNK, binary))
    return glb_from_chunks(chunks)


class Document:
    """A glTF document in the making. `names` remembers accessors by what they hold."""

    def __init__(self):
        self.json = {"asset": {"version": "2.0"}, "buffers": [{"byteLength": 0}], "bufferViews": [],
                     "accessors": []}
        self.bin = bytearray()
        self.names = {}

    def add_view(self, data):
        """Appends bytes as a buffer view of their own; returns its index."""
        self.bin += bytes(-len(self.bin) % 4)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.bin), "byteLength": len(data)})
        self.bin += data
        self.json["buffers"][0]["byteLength"] = len(self.bin)
        return len(self.json["bufferViews"]) - 1

    def add(self, name, values, kind, component=FLOAT, **fields):
        """Appends an accessor of flat `values`; returns its index and remembers it as `name`."""
        accessor = {"bufferView": self.add_view(struct.pack(f"<{len(values)}{COMPONENT[component]}",
                                                            *values)),
                    "componentType": component, "count": len(values) // WIDTH[kind], "type": kind, **fields}
        self.json["accessors"].append(accessor)
        self.names[name] = len(self.json["accessors"]) - 1
        return self.names[name]

    def accessor(self, name):
        return self.json["accessors"][self.names[name]]

    def view(self, name):
        return self.json["bufferViews"][self.accessor(name)["bufferView"]]

    def put(self, name, first, *values):
        """Overwrites numbers of an accessor, counted flat from its first one."""
        component = COMPONENT[self.accessor(name)["componentType"]]
        offset = self.view(name)["byteOffset"] + first * struct.calcsize(component)
        struct.pack_into(f"<{len(values)}{component}", self.bin, offset, *values)

    def text(self):
        return json.dumps(self.json).encode()

    def glb(self):
        return make_glb(self.json, bytes(self.bin))

    def glb_with_text(self, old, new):
        """The file with a piece of its JSON text replaced, for what no JSON writer would write."""
        text = self.text()
        if text.count(old) != 1:
            raise ValueError(f"expected {old!r} once in the JSON, found it {text.count(old)} times")
        return make_glb(text.replace(old, new), bytes(self.bin))


def quaternion_z(angle_rad):
    return [0.0, 0.0, math.sin(angle_rad / 2), math.cos(angle_rad / 2)]


def wave(key, turns=1):
    return math.sin(2 * math.pi * turns * key / (KEY_COUNT - 1))


def key_times(count=KEY_COUNT):
    return [key / RATE_HZ for key in range(count)]


# Joints of the tiny animal: name, rest translation from the parent, height of its bind pose.
JOINTS = [("root", 0.0, 0.0), ("spine", 0.5, 0.5), ("head", 0.5, 1.0)]
FIRST_JOINT_NODE = 1  # node 0 is the mesh


def _add_mesh(document):
    """Five rings of four vertices about the Y axis, each ring bound to the joints about its height."""
    positions, normals, joints, weights, triangles = [], [], [], [], []
    for ring in range(5):
        height = ring * 0.3
        lower = min(int(height / 0.5), 1)
        factor = min(max((height - 0.5 * lower) / 0.5, 0.0), 1.0)
        for x, z in ((0.2, 0.0), (0.0, 0.2), (-0.2, 0.0), (0.0, -0.2)):
            positions += [x, height, z]
            normals += [x * 5, 0.0, z * 5]
            joints += [lower, lower + 1, 0, 0]
            weights += [1.0 - factor, factor, 0.0, 0.0]
        for side in range(4 if ring < 4 else 0):
            a, b = 4 * ring + side, 4 * ring + (side + 1) % 4
            triangles += [a, b, a + 4, b, b + 4, a + 4]
    attributes = {"POSITION": document.add("positions", positions, "VEC3", min=[-0.2, 0.0, -0.2],
                                           max=[0.2, 1.2, 0.2]),
                  "NORMAL": document.add("normals", normals, "VEC3"),
                  "JOINTS_0": document.add("joints", joints, "VEC4", UBYTE),
                  "WEIGHTS_0": document.add("weights", weights, "VEC4")}
    primitive = {"attributes": attributes, "indices": document.add("indices", triangles, "SCALAR", USHORT)}
    document.json["meshes"] = [{"name": "body", "primitives": [primitive]}]


def _add_skeleton(document):
    document.json["scenes"] = [{"nodes": [0, FIRST_JOINT_NODE]}]
    document.json["scene"] = 0
    nodes = [{"name": "body", "mesh": 0, "skin": 0}]
    inverse_binds = []
    for number, (name, offset, height) in enumerate(JOINTS):
        node = {"name": name, "translation": [0.0, offset, 0.0]}
        if number + 1 < len(JOINTS):
            node["children"] = [FIRST_JOINT_NODE + number + 1]
        nodes.append(node)
        inverse_binds += [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -height, 0, 1]
    document.json["nodes"] = nodes
    joints = [FIRST_JOINT_NODE + number for number in range(len(JOINTS))]
    document.json["skins"] = [{"joints": joints,
                               "inverseBindMatrices": document.add("binds", inverse_binds, "MAT4")}]


def channel(node, path, sampler):
    return {"sampler": sampler, "target": {"node": node, "path": path}}


def _add_clips(document, clip_names):
    """The first clip bends spine and head, the others move the root; all are loops of one second at 30 Hz."""
    times = document.add("times", key_times(), "SCALAR", min=[0.0], max=[(KEY_COUNT - 1) / RATE_HZ])
    spine, head, root = [], [], []
    for key in range(KEY_COUNT):
        spine += quaternion_z(0.5 * wave(key))
        head += quaternion_z(0.7 * wave(key, 2))
        root += [0.1 * wave(key), 0.05 * wave(key, 2), 0.0]
    spine = document.add("spine", spine, "VEC4")
    head = document.add("head", head, "VEC4")
    root = document.add("root", root, "VEC3")
    document.json["animations"] = [{"name": clip_names[0],
                                    "samplers": [{"input": times, "output": spine},
                                                 {"input": times, "output": head}],
                                    "channels": [channel(2, "rotation", 0), channel(3, "rotation", 1)]}]
    for name in clip_names[1:]:
        document.json["animations"].append({"name": name, "samplers": [{"input": times, "output": root}],
                                            "channels": [channel(1, "translation", 0)]})


def tiny_animal(clip_names=("Walk", "Idle")):
    """Three joints in a chain, 20 vertices, clips of 30 rows. Node 0 is the mesh, nodes 1 to 3 the joints."""
    document = Document()
    _add_mesh(document)
    _add_skeleton(document)
    _add_clips(document, clip_names)
    return document
