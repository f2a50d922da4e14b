# SPDX-License-Identifier: MIT
"""Compressed forms of a Document's data, without a library: streams that store everything as it is, which both
formats allow.

The encoders of the libraries are at work in the unit tests; here a stream is a few lines that a test may bend.
"""

import struct

from glb import COMPONENT, WIDTH

MESHOPT, DRACO = "EXT_meshopt_compression", "KHR_draco_mesh_compression"
_DRACO_TYPE = {5120: 1, 5121: 2, 5122: 3, 5123: 4, 5125: 6, 5126: 9}
_DRACO_USE = {"POSITION": 0, "NORMAL": 1}
_GENERIC = 4


def meshopt_attributes(data, stride):
    """A stream of ATTRIBUTES, version 0: every group of 16 deltas in 8 bits each (EXT_meshopt_compression,
    "Mode 0")."""
    count = len(data) // stride
    block = min(256, 8192 // stride & ~15)
    stream, last = bytearray([0xA0]), data[:stride]
    for first in range(0, count, block):
        size = min(block, count - first)
        groups = (size + 15) // 16
        for k in range(stride):
            stream += b"\xff" * ((groups + 3) // 4)
            before = last[k]
            for i in range(groups * 16):
                value = data[(first + i) * stride + k] if i < size else before
                delta = (value - before) & 0xFF
                stream.append((delta << 1 ^ -(delta >> 7)) & 0xFF)
                before = value
        last = data[(first + size - 1) * stride:(first + size) * stride]
    return bytes(stream) + bytes(max(0, 32 - stride)) + bytes(data[:stride])


def _varint(value):
    out = bytearray()
    while value >= 0x80:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    return bytes(out) + bytes([value])


def meshopt_indices(indices):
    """A stream of INDICES, version 1: deltas to the last index, zigzag, in groups of 7 bits."""
    stream, last = bytearray([0xD1]), 0
    for index in indices:
        delta = index - last
        stream += _varint((delta << 1 if delta >= 0 else -delta * 2 - 1) << 1)
        last = index
    return bytes(stream) + bytes(4)


def add_meshopt_view(document, stream, count, stride, mode):
    """A view of a stream; its plain bytes would lie in a fallback buffer. Returns the view's index."""
    index = document.add_view(stream)
    buffers = document.json["buffers"]
    if len(buffers) < 2:
        buffers.append({"byteLength": 0, "extensions": {MESHOPT: {"fallback": True}}})
    raw = document.json["bufferViews"][index]
    document.json["bufferViews"][index] = {
        "buffer": 1, "byteOffset": buffers[1]["byteLength"], "byteLength": count * stride,
        "extensions": {MESHOPT: {"buffer": 0, "byteOffset": raw["byteOffset"], "byteLength": len(stream),
                                 "byteStride": stride, "count": count, "mode": mode}}}
    buffers[1]["byteLength"] += count * stride
    document.json["extensionsUsed"] = document.json["extensionsRequired"] = [MESHOPT]
    return index


def compress_with_meshopt(document, *names):
    """Moves accessors (all of four-byte elements, unless named) into streams. Returns their extension objects."""
    extensions = {}
    for name in names or list(document.names):
        view, count = document.view(name), document.accessor(name)["count"]
        data = bytes(document.bin[view["byteOffset"]:view["byteOffset"] + view["byteLength"]])
        stride = len(data) // count
        if stride % 4:
            continue
        document.bin[view["byteOffset"]:view["byteOffset"] + len(data)] = b"\xa5" * len(data)
        index = add_meshopt_view(document, meshopt_attributes(data, stride), count, stride, "ATTRIBUTES")
        document.accessor(name)["bufferView"] = index
        extensions[name] = document.json["bufferViews"][index]["extensions"][MESHOPT]
    return extensions


def draco_stream(attributes, points, faces=None):
    """A sequential Draco stream (bitstream 2.2) whose faces take the points in threes, the last of them padded.
    `attributes`: (unique id, use, component type, components, data). `faces` is what the header says instead."""
    real_faces = (points + 2) // 3
    faces = real_faces if faces is None else faces
    stream = bytearray(b"DRACO" + bytes([2, 2, 1, 0, 0, 0]) + _varint(faces) + _varint(points) + b"\x01")
    # Indices of a byte each: points are fewer than 256.
    stream += bytes(min(corner, points - 1) for corner in range(3 * real_faces))
    stream += bytes([1]) + _varint(len(attributes))
    for number, use, component, components, _ in attributes:
        stream += bytes([use, _DRACO_TYPE[component], components, 0]) + _varint(number)
    stream += bytes(len(attributes))  # each as it is
    for *_, data in attributes:
        stream += data
    return bytes(stream)


def compress_with_draco(document, **changes):
    """Moves the attributes of the first primitive into a Draco stream; `changes` go to draco_stream. Returns the
    view of the stream."""
    primitive = document.json["meshes"][0]["primitives"][0]
    attributes, ids = [], {}
    for number, (name, index) in enumerate(primitive["attributes"].items(), 20):
        accessor = document.json["accessors"][index]
        view = document.json["bufferViews"][accessor.pop("bufferView")]
        components = WIDTH[accessor["type"]]
        size = accessor["count"] * components * struct.calcsize(COMPONENT[accessor["componentType"]])
        data = bytes(document.bin[view["byteOffset"]:view["byteOffset"] + size])
        attributes.append((number, _DRACO_USE.get(name, _GENERIC), accessor["componentType"], components, data))
        ids[name] = number
    points = document.json["accessors"][primitive["attributes"]["POSITION"]]["count"]
    view = document.add_view(draco_stream(attributes, points, **changes))
    primitive["extensions"] = {DRACO: {"bufferView": view, "attributes": ids}}
    document.json["extensionsUsed"] = document.json["extensionsRequired"] = [DRACO]
    return document.json["bufferViews"][view]
