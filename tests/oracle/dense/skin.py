# SPDX-License-Identifier: MIT
"""Vertices of a model, and how far each is from its source: what section 11 of docs/format/posepack-1.md draws, less what
glTF 2.0 (section 3.7.3) says. A binding is a pair of mesh and joint, with the bone that the container gives it."""
import numpy as np

from dense.curves import Curves
from posepack_reader.values import NO_BONE, NONE, value


def affine(bits):
    matrix = np.eye(4)
    matrix[:3] = np.array([value(word) for word in bits]).reshape(3, 4)
    return matrix


def attributes(glb, primitive, prefix):
    """PREFIX_0, PREFIX_1, ... side by side."""
    found = []
    while f"{prefix}_{len(found)}" in primitive["attributes"]:
        found.append(glb.accessor(primitive["attributes"][f"{prefix}_{len(found)}"]))
    return np.concatenate(found, axis=1)


def largest_influences(joints, weights, positions, count):
    """The `count` largest weights of each vertex, falling, with the sum 1, and their joints. Weights that are none (NaN,
    infinite, negative) count as 0, and a vertex without weights has those of the nearest that has some: the repairs of
    E-GLB-WEIGHTS in docs/issues.md."""
    weights = np.where(np.isfinite(weights) & (weights > 0.0), weights, 0.0)
    order = np.argsort(-weights, axis=1, kind="stable")[:, :count]
    joints, weights = np.take_along_axis(joints, order, 1), np.take_along_axis(weights, order, 1)
    weighted = np.flatnonzero(weights[:, 0] > 0.0)
    if len(weighted) == 0:
        raise ValueError("expected a vertex with weights")
    for vertex in np.flatnonzero(weights[:, 0] <= 0.0):
        nearest = weighted[np.argmin(np.sum((positions[weighted] - positions[vertex])**2, axis=1))]
        joints[vertex], weights[vertex] = joints[nearest], weights[nearest]
    return joints, weights / weights.sum(axis=1, keepdims=True)


class Skin:
    """All meshes of a container with their vertices in the file."""

    def __init__(self, glb, container, influence_count):
        self.glb = glb
        self.model_from_palette = affine(container.model_from_palette)
        self.radius = value(container.header["radius_m"]) / value(container.metres_per_unit)
        self.nodes, self.bones, self.inverse_binds, self.spaces = [], [], [], []  # of every binding
        parts = [self.add_mesh(number, mesh, influence_count) for number, mesh in enumerate(container.meshes)]
        self.places = np.concatenate([places for places, _, _, _ in parts])  # mesh and vertex
        self.bindings, self.weights, self.positions = (
            np.concatenate([padded(part[i], influence_count) if i < 3 else part[i] for part in parts])
            for i in (1, 2, 3))
        rows = np.concatenate([self.bindings, self.weights, self.positions], axis=1)
        kept = np.sort(np.unique(rows, axis=0, return_index=True)[1])
        self.places, self.bindings, self.weights = self.places[kept], self.bindings[kept], self.weights[kept]
        self.positions = np.concatenate([self.positions[kept], np.ones((len(kept), 1))], axis=1)
        self.boxes = [self.box(binding) for binding in range(len(self.nodes))]

    def add_mesh(self, number, mesh, influence_count):
        node = self.glb.nodes[mesh["node"]]
        if node.get("mesh") != mesh["mesh"] or node.get("skin", NONE) != mesh["skin"]:
            raise ValueError(f"node {mesh['node']}: expected mesh {mesh['mesh']} and skin {mesh['skin']}")
        first = len(self.nodes)
        joints = [mesh["node"]]
        inverse_binds = np.eye(4)[None]
        if mesh["skin"] != NONE:
            skin = self.glb.json["skins"][mesh["skin"]]
            joints = skin["joints"]
            inverse_binds = np.tile(np.eye(4), (len(joints), 1, 1))
            if "inverseBindMatrices" in skin:
                stored = self.glb.accessor(skin["inverseBindMatrices"])
                inverse_binds = stored.reshape(-1, 4, 4).transpose(0, 2, 1)[:len(joints)]
        self.nodes += joints
        self.bones += mesh["joints"]
        self.inverse_binds += list(inverse_binds)
        self.spaces += [affine(mesh["palette_from_mesh"])] * len(joints)
        primitives = self.glb.json["meshes"][mesh["mesh"]]["primitives"]
        positions = [self.glb.accessor(p["attributes"]["POSITION"]).astype(np.float64) for p in primitives]
        if sum(map(len, positions)) != mesh["vertex_count"]:
            raise ValueError(f"mesh {number}: expected {mesh['vertex_count']} vertices, found others")
        places = np.array([[number, vertex] for vertex in range(mesh["vertex_count"])])
        if mesh["skin"] == NONE:
            ones = np.ones((len(places), 1))
            return places, first * ones.astype(np.int64), ones, np.concatenate(positions)
        chosen = [largest_influences(attributes(self.glb, p, "JOINTS"), attributes(self.glb, p, "WEIGHTS"), own,
                                     influence_count) for p, own in zip(primitives, positions)]
        bindings = np.concatenate([padded(joints, influence_count) for joints, _ in chosen]) + first
        weights = np.concatenate([padded(weights, influence_count) for _, weights in chosen])
        if np.any((np.array(self.bones)[bindings] == NO_BONE) & (weights > 0.0)):
            raise ValueError(f"mesh {number}: expected a bone for every joint with a weight")
        return places, np.where(weights > 0.0, bindings, first), weights, np.concatenate(positions)

    def box(self, binding):
        """Eight corners about the vertices that a binding moves, in its mesh space; None where it moves none."""
        own = self.positions[np.any((self.bindings == binding) & (self.weights > 0.0), axis=1)]
        if len(own) == 0:
            return None
        low, high = own.min(axis=0), own.max(axis=0)
        corners = [[(low, high)[corner >> axis & 1][axis] for axis in range(3)] + [1.0] for corner in range(8)]
        return np.array(corners)

    def used(self):
        return [binding for binding, box in enumerate(self.boxes) if box is not None]

    def source(self, curves, times_s):
        """The skinning matrices of glTF, binding: shape (times, 4, 4)."""
        used = self.used()
        globals_ = curves.poses({self.nodes[binding] for binding in used}, times_s)
        return {b: np.broadcast_to(globals_[self.nodes[b]] @ self.inverse_binds[b], (len(times_s), 4, 4)) for b in used}

    def differences(self, curves, drawn, start_s, times_s):
        """Drawn less source in fractions of R, binding: shape (times, 3, 4)."""
        source = self.source(curves, start_s + times_s)
        bones = drawn.poses(times_s).astype(np.float64)
        linear, shift = self.model_from_palette[:3, :3], self.model_from_palette[:3, 3]
        out = {}
        for binding, exact in source.items():
            found = linear @ (bones[self.bones[binding]] @ self.spaces[binding])
            found[:, :, 3] += shift
            out[binding] = (found - exact[:, :3]) / self.radius
        return out

    def rest_radius(self):
        """R, from the rest pose alone."""
        rest = self.source(Curves(self.glb), np.zeros(1))
        points = np.zeros((len(self.positions), 3))
        for k in range(self.bindings.shape[1]):
            for binding, matrix in rest.items():
                own = (self.bindings[:, k] == binding) & (self.weights[:, k] > 0.0)
                points[own] += self.weights[own, k, None] * (self.positions[own] @ matrix[0, :3].T)
        center = (points.min(axis=0) + points.max(axis=0)) / 2
        return np.linalg.norm(points - center, axis=1).max()


def padded(columns, count):
    """As many columns, the added ones zero."""
    return np.pad(columns, ((0, 0), (0, max(0, count - columns.shape[1]))))
