# SPDX-License-Identifier: MIT
"""The largest distance of a vertex from its source over many times of a clip.

All times and all vertices are compared, but for those that cannot have the largest: a vertex is never further off than
the weighted sum of how far each matrix misplaces some corner of the box about its vertices.
"""
import dataclasses

import numpy as np

from dense.curves import EQUAL_TIMES_S

WINDOW = 4096  # times whose matrices are held at once
BATCH = 32  # times that are skinned at once


@dataclasses.dataclass
class Place:
    error: float = -1.0
    time_s: float = 0.0
    mesh: int = 0
    vertex: int = 0
    bone: int = 0


def dense_times(curves, nodes, start_s, period_s, points):
    """From the first key to the last: keys, `points` a key step, and both sides of every jump. Seconds of the clip."""
    channels = list(curves.moving(nodes))
    end_s = curves.last_s() - start_s
    keys = np.unique(np.concatenate([[0.0, end_s]] + [channel.times - start_s for channel in channels]))
    keys = keys[np.concatenate([[True], np.diff(keys) >= EQUAL_TIMES_S])]
    shares = np.arange(points) / points
    times = np.append((keys[:-1, None] + np.diff(keys)[:, None] * shares).ravel(), keys[-1])
    jumps = np.concatenate([np.zeros(0)] + [channel.jumps() - start_s for channel in channels])
    if len(jumps):  # beside a jump, by more than the phase is rounded
        beside = max(2 * EQUAL_TIMES_S, period_s * 2.0**-22)
        times = times[np.min(np.abs(times[:, None] - jumps), axis=1) >= beside]
        times = np.concatenate([times, jumps - beside, jumps + beside])
    return np.unique(times[(times >= 0.0) & (times <= end_s)])


def distances(skin, differences, rows, times):
    """Shape (vertices of `rows`, times): `times` selects those of the differences."""
    shift = np.zeros((len(rows), len(times) * 3))
    bindings, weights, positions = skin.bindings[rows], skin.weights[rows], skin.positions[rows]
    for binding, difference in differences.items():
        matrix = difference[times].reshape(-1, 4).T
        for k in range(bindings.shape[1]):
            own = np.flatnonzero((bindings[:, k] == binding) & (weights[:, k] > 0.0))
            if len(own):
                shift[own] += (weights[own, k, None] * positions[own]) @ matrix
    return np.linalg.norm(shift.reshape(len(rows), len(times), 3), axis=2)


def blamed_binding(skin, differences, row, time):
    """The binding that contributes most to the distance of a vertex."""
    def contribution(k):
        return skin.weights[row, k] * np.linalg.norm(differences[skin.bindings[row, k]][time] @ skin.positions[row])
    return skin.bindings[row, max(np.flatnonzero(skin.weights[row] > 0.0), key=contribution)]


def reaches(skin, differences, time_count):
    """How far each binding misplaces a corner of its box at most: shape (bindings, times)."""
    out = np.zeros((len(skin.nodes), time_count))
    for binding, difference in differences.items():
        corners = difference @ skin.boxes[binding].T
        out[binding] = np.sqrt(np.sum(corners * corners, axis=1)).max(axis=1)
    return out


def search_window(skin, differences, times_s, best):
    reach = reaches(skin, differences, len(times_s))
    bound = reach.max(axis=0)
    order = np.argsort(-bound, kind="stable")
    for first in range(0, len(order), BATCH):
        times = order[first:first + BATCH]
        if bound[times[0]] <= best.error:
            break
        reach_now = reach[:, times].max(axis=1)
        rows = np.flatnonzero(np.sum(skin.weights * reach_now[skin.bindings], axis=1) > best.error)
        if len(rows) == 0:
            continue
        found = distances(skin, differences, rows, times)
        at = np.unravel_index(np.argmax(found), found.shape)
        if found[at] > best.error:
            row, time = rows[at[0]], times[at[1]]
            binding = blamed_binding(skin, differences, row, time)
            best = Place(found[at], times_s[time], *skin.places[row], skin.bones[binding])
    return best


def largest(skin, curves, drawn, start_s, times_s, best):
    """The largest of `best` and all that is found at these times."""
    for first in range(0, len(times_s), WINDOW):
        window = times_s[first:first + WINDOW]
        best = search_window(skin, skin.differences(curves, drawn, start_s, window), window, best)
    return best


def largest_at(skin, curves, drawn, start_s, time_s):
    """The largest at one time."""
    times_s = np.array([time_s])
    return search_window(skin, skin.differences(curves, drawn, start_s, times_s), times_s, Place())
