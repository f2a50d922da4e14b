# SPDX-License-Identifier: MIT
"""A GLB file and its accessors as numpy arrays (glTF 2.0, sections 3.6 and 4.4). Plain storage only: no Draco, no
meshopt, no sparse accessors, no other files."""
import json
import struct

import numpy as np

COMPONENTS = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
COUNTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
JSON_CHUNK, BIN_CHUNK = 0x4E4F534A, 0x004E4942


class Glb:
    def __init__(self, path):
        self.path = path
        data = path.read_bytes()
        magic, version, size = struct.unpack_from("<4sII", data)
        if (magic, version) != (b"glTF", 2) or size > len(data):
            raise ValueError(f"{path}: expected a GLB of version 2, found {magic} {version}")
        chunks = {}
        at = 12
        while at < size:
            length, kind = struct.unpack_from("<II", data, at)
            chunks.setdefault(kind, data[at + 8:at + 8 + length])
            at += 8 + length
        self.json = json.loads(chunks[JSON_CHUNK])
        self.bin = chunks.get(BIN_CHUNK, b"")
        self.nodes = self.json.get("nodes", [])
        self.parents = [None] * len(self.nodes)
        for parent, node in enumerate(self.nodes):
            for child in node.get("children", []):
                self.parents[child] = parent

    def accessor(self, index):
        """Shape (count, components): doubles, normalised integers as the shares they mean, or other integers as they are."""
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]] if "bufferView" in accessor else None
        if view is None or "sparse" in accessor or view.get("extensions"):
            raise ValueError(f"{self.path}: accessor {index}: expected plain data, found sparse or compressed data")
        kind = np.dtype(COMPONENTS[accessor["componentType"]])
        count, width = accessor["count"], COUNTS[accessor["type"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", width * kind.itemsize)
        stored = np.ndarray((count, width), kind, self.bin, start, (stride, kind.itemsize))
        if kind.kind == "f":
            return stored.astype(np.float64)
        if accessor.get("normalized"):
            return np.maximum(stored.astype(np.float64) / np.iinfo(kind).max, -1.0)
        return stored.astype(np.int64)

    def lineage(self, node):
        """The node and all above it."""
        while node is not None:
            yield node
            node = self.parents[node]
