# SPDX-License-Identifier: MIT
"""Global transforms of nodes on the continuous curves of an animation (glTF 2.0, section 3.11 and appendix C), in double
precision."""
import numpy as np

PATHS = {"translation": (0.0, 0.0, 0.0), "rotation": (0.0, 0.0, 0.0, 1.0), "scale": (1.0, 1.0, 1.0)}
EQUAL_TIMES_S = 1e-6  # keys closer than this are one moment: docs/numerical_contract.md


def unit(q):
    return q / np.linalg.norm(q, axis=-1, keepdims=True)


def slerp(a, b, u):
    """Spherical interpolation along the shorter arc (appendix C.4)."""
    a, b = unit(a), unit(b)
    b = np.where(np.sum(a * b, axis=-1, keepdims=True) < 0.0, -b, b)
    angle = 2.0 * np.arctan2(np.linalg.norm(b - a, axis=-1), np.linalg.norm(a + b, axis=-1))[:, None]
    small = angle < 1e-8
    sine = np.where(small, 1.0, np.sin(angle))
    return (np.where(small, 1.0 - u, np.sin((1.0 - u) * angle) / sine) * a +
            np.where(small, u, np.sin(u * angle) / sine) * b)


class Channel:
    """The keys of one property of one node."""

    def __init__(self, glb, sampler, path):
        self.path = path
        self.kind = sampler.get("interpolation", "LINEAR")
        self.times = glb.accessor(sampler["input"])[:, 0]
        self.values = glb.accessor(sampler["output"])
        self.tangents = None
        if self.kind == "CUBICSPLINE":
            keys = self.values.reshape(len(self.times), 3, -1)
            self.values, self.tangents = keys[:, 1], (keys[:, 0], keys[:, 2])

    def jumps(self):
        """Times at which the value changes from one moment to the next."""
        sudden = np.diff(self.times) < EQUAL_TIMES_S
        if self.kind == "STEP":
            sudden[:] = True
        return self.times[1:][sudden & np.any(np.diff(self.values, axis=0) != 0.0, axis=1)]

    def at(self, times):
        """Values at times; rotations of unit length."""
        value = self.between_keys(times)
        return unit(value) if self.path == "rotation" else value

    def between_keys(self, times):
        key = np.clip(np.searchsorted(self.times, times, side="right") - 1, 0, len(self.times) - 1)
        following = np.minimum(key + 1, len(self.times) - 1)
        if self.kind == "STEP":
            return self.values[key]
        span = (self.times[following] - self.times[key])[:, None]
        u = np.clip((times - self.times[key])[:, None] / np.where(span < EQUAL_TIMES_S, 1.0, span), 0.0, 1.0)
        u = np.where(span < EQUAL_TIMES_S, 0.0, u)
        a, b = self.values[key], self.values[following]
        if self.kind == "CUBICSPLINE":
            into, out = self.tangents
            return ((2 * u**3 - 3 * u**2 + 1) * a + span * (u**3 - 2 * u**2 + u) * out[key] +
                    (3 * u**2 - 2 * u**3) * b + span * (u**3 - u**2) * into[following])
        return slerp(a, b, u) if self.path == "rotation" else a + (b - a) * u


def local_matrices(translation, rotation, scale):
    """T x R x S of lists of each, shape (count, 4, 4)."""
    x, y, z, w = rotation.T
    out = np.zeros((len(rotation), 4, 4))
    out[:, 0, 0], out[:, 0, 1], out[:, 0, 2] = 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)
    out[:, 1, 0], out[:, 1, 1], out[:, 1, 2] = 2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)
    out[:, 2, 0], out[:, 2, 1], out[:, 2, 2] = 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)
    out[:, :3, :3] *= scale[:, None, :]
    out[:, :3, 3] = translation
    out[:, 3, 3] = 1.0
    return out


class Curves:
    """The nodes of a file under one of its animations, or at rest where `animation` is None."""

    def __init__(self, glb, animation=None):
        self.glb = glb
        self.channels = {}  # (node, path): the last channel counts
        for channel in animation["channels"] if animation else []:
            node, path = channel["target"].get("node"), channel["target"]["path"]
            if node is not None and path in PATHS:
                self.channels[node, path] = Channel(glb, animation["samplers"][channel["sampler"]], path)

    def first_s(self):
        return min(channel.times[0] for channel in self.channels.values())

    def last_s(self):
        return max(channel.times[-1] for channel in self.channels.values())

    def moving(self, nodes):
        """Channels that move one of these nodes by more than nothing."""
        above = {ancestor for node in nodes for ancestor in self.glb.lineage(node)}
        for (node, _), channel in self.channels.items():
            changes = np.any(channel.values != channel.values[0]) or \
                channel.tangents is not None and any(np.any(tangent != 0.0) for tangent in channel.tangents)
            if node in above and changes:
                yield channel

    def local(self, node, times):
        """Shape (times or 1, 4, 4)."""
        description = self.glb.nodes[node]
        if "matrix" in description:
            return np.array(description["matrix"], np.float64).reshape(1, 4, 4).transpose(0, 2, 1)
        parts = []
        for path, rest in PATHS.items():
            channel = self.channels.get((node, path))
            value = channel.at(times) if channel else np.array([description.get(path, rest)], np.float64)
            parts.append(unit(value) if path == "rotation" else value)
        count = max(len(part) for part in parts)
        return local_matrices(*(np.broadcast_to(part, (count, part.shape[1])) for part in parts))

    def poses(self, nodes, times):
        """Global transforms, node: shape (times or 1, 4, 4)."""
        found = {}

        def pose(node):
            if node not in found:
                parent = self.glb.parents[node]
                local = self.local(node, times)
                found[node] = local if parent is None else pose(parent) @ local
            return found[node]

        return {node: pose(node) for node in nodes}
