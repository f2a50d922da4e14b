#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Is the printed error the true one? A search that shares no code with the compiler, many times as dense.

    dense_error.py --posepack FILE [--models DIR] [--only ID,...] [--catalog FILE] [--points 64] [--forms NAME,...]

Animals of a catalog are baked plainly (affine, dualquat) and within the bound `default` (runs, slots). Of every
clip the largest distance of a vertex from the continuous glTF curve is searched at so many points a key step, and at the time
that the manifest prints. The printed max must be
  - at least 0.97 of what was found, or where that is at most 1e-3 R at least that less 5e-4 R;
  - no more than that, and no more than the distance at the printed time, but for rounding.
Exit code 1 where a clip breaks that: clip, time, vertex and bone are printed. Needs numpy.
"""
import argparse
import dataclasses
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "reader")]

import numpy as np  # noqa: E402  # the path comes first

from dense.curves import Curves  # noqa: E402
from dense.drawn import DrawnClip  # noqa: E402
from dense.glb import Glb  # noqa: E402
from dense.search import Place, dense_times, largest, largest_at  # noqa: E402
from dense.skin import Skin  # noqa: E402
from posepack_reader import Container  # noqa: E402
from posepack_reader.values import value  # noqa: E402

ANIMALS = ("fox,khronos_fox,robot_expressive,koi,spider,frog,trex,cube_horse,cyber_flyer,godot_player,kaykit_knight,"
           "mech_leela")
FORMS = {"affine": ["--encoding", "affine"], "dualquat": ["--encoding", "dualquat"],
         "mat4": ["--encoding", "mat4"], "default": ["--max-error", "default"]}
SKIPPED = 77
SOME_FAILED = 9  # exit code of a bake
STRETCHES = "error[E-LIM-SIMILARITY]"  # what dual quaternions cannot do: such an animal is left out
INFLUENCES = 4  # that a vertex keeps where a bake says nothing else
LARGE, SHARE, SLACK = 1e-3, 0.97, 5e-4  # the rule, in fractions of R
# Rounding: a time is printed as a float, a phase and the blend are floats: some 1e-7 of a body and of its motion.
ROUNDING, ROUNDING_SHARE = 2e-6, 1e-4


@dataclasses.dataclass
class Verdict:
    """Of one clip: what was found, where, and what the manifest prints."""
    clip: str
    found: Place
    printed: float
    at_printed_time: float

    def faults(self):
        rounding = ROUNDING + ROUNDING_SHARE * self.found.error
        if self.found.error > LARGE and self.printed < SHARE * self.found.error:
            yield f"expected at least {SHARE} of what was found"
        if self.found.error <= LARGE and self.printed < self.found.error - SLACK:
            yield f"expected at least {SLACK:g} R less than what was found"
        if self.printed > self.found.error + rounding:
            yield "expected no more than what was found"
        if abs(self.printed - self.at_printed_time) > rounding:
            yield f"expected what is found at the printed time, {self.at_printed_time:.6e} R"

    def share(self):
        return self.printed / self.found.error if self.found.error > 0.0 else 1.0


def animation_of(glb, clip, clips):
    """The animation behind a clip: of equal names the one that has the same number among them."""
    wanted = [other for other in clips if other["source_name"] == clip["source_name"]].index(clip)
    named = [animation for number, animation in enumerate(glb.json["animations"])
             if plain(animation.get("name") or f"clip_{number}") == clip["source_name"].decode()]
    return named[wanted]


def plain(name):
    return "".join("_" if ord(c) < 0x20 or 0x7F <= ord(c) <= 0x9F else c for c in name)


def check_clip(glb, container, skin, number, record, points):
    clip = container.clips[number]
    printed = record["error"]
    if np.float32(printed["max"]) != np.float32(value(clip["error"][0])):
        raise ValueError(f"{record['name']}: the manifest and the container print different errors")
    curves = Curves(glb, animation_of(glb, clip, container.clips))
    start_s = curves.first_s()
    if abs(start_s - value(clip["start_s"])) > 1e-6 * max(1.0, abs(start_s)):
        raise ValueError(f"{record['name']}: expected a start at {start_s} s, found {value(clip['start_s'])}")
    drawn = DrawnClip(container, number)
    times_s = dense_times(curves, [skin.nodes[b] for b in skin.used()], start_s, drawn.period_s, points)
    at_printed = largest_at(skin, curves, drawn, start_s, printed["time_s"])
    found = largest(skin, curves, drawn, start_s, times_s, at_printed)
    return Verdict(record["name"], found, printed["max"], at_printed.error), len(times_s)


def check_animal(options, folder, record):
    """Verdicts of all clips, how many times were looked at, and how many different vertices."""
    glb = Glb(pathlib.Path(options.models) / record["model"])
    container = Container((folder / record["container"]).read_bytes())
    skin = Skin(glb, container, INFLUENCES)
    radius = skin.rest_radius()
    if abs(radius - skin.radius) > 1e-5 * radius:
        raise ValueError(f"{record['id']}: expected R = {radius} units, found {skin.radius}")
    checked = [check_clip(glb, container, skin, number, clip, options.points)
               for number, clip in enumerate(record["clips"])]
    return [verdict for verdict, _ in checked], sum(count for _, count in checked), len(skin.positions)


def table_row(animal, form, verdicts, time_count, vertex_count):
    top = max(verdicts, key=lambda verdict: verdict.found.error)
    large = [verdict.share() for verdict in verdicts if verdict.found.error > LARGE]
    missed = max(verdict.found.error - verdict.printed for verdict in verdicts)
    above = max(verdict.printed - verdict.found.error for verdict in verdicts)
    return (f"| {animal} | {form} | {len(verdicts)} | {time_count:,} | {vertex_count:,} | {top.found.error:.3e} | "
            f"{top.printed:.3e} | {f'{min(large):.4f} of {len(large)}' if large else '-'} | "
            f"{max(missed, 0.0):.1e} | {max(above, 0.0):.1e} |")


def fault_lines(animal, form, verdicts):
    for verdict in verdicts:
        for fault in verdict.faults():
            found = verdict.found
            yield (f"{animal}, {form}, clip {verdict.clip}: printed {verdict.printed:.6e} R, found {found.error:.6e} R at "
                   f"{found.time_s:.6f} s, vertex {found.vertex} of mesh {found.mesh}, bone {found.bone}: {fault}")


def bake(options, form, folder):
    command = [options.posepack, "-q", "bake", options.catalog, "--models", options.models, "--only", options.only,
               "-o", str(folder), "--no-fsync", "--keep-going", *FORMS[form]]
    done = subprocess.run(command, capture_output=True, text=True)
    refused = [line for line in done.stderr.splitlines() if "error[" in line]
    if done.returncode not in (0, SOME_FAILED) or any(STRETCHES not in line for line in refused):
        raise SystemExit(f"expected a bake, found exit code {done.returncode}: {done.stderr}")
    for line in refused:
        print(f"left out, {form}: {line}", file=sys.stderr)
    return json.loads((folder / "manifest.json").read_text())["records"]


def check_form(options, form, folder):
    """Prints the rows of the table. Returns the lines that say what is wrong, and how many clips were looked at."""
    faults, clip_count = [], 0
    for record in bake(options, form, folder):
        began = time.monotonic()
        verdicts, time_count, vertex_count = check_animal(options, folder, record)
        print(table_row(record["id"], form, verdicts, time_count, vertex_count), flush=True)
        print(f"{record['id']}, {form}: {time.monotonic() - began:.1f} s", file=sys.stderr)
        faults += fault_lines(record["id"], form, verdicts)
        clip_count += len(verdicts)
    return faults, clip_count


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--posepack", required=True)
    parser.add_argument("--models", default=os.path.join(os.environ.get("POSEPACK_ASSETS", ""), "animals"),
                        help="default: animals in the folder POSEPACK_ASSETS")
    parser.add_argument("--catalog", default=str(HERE.parent / "data/real_animals.json"))
    parser.add_argument("--only", default=ANIMALS, help="ids of the catalog, or all")
    parser.add_argument("--points", type=int, default=64)
    parser.add_argument("--forms", default="affine,dualquat,default")
    options = parser.parse_args()
    if not os.path.isdir(options.models):
        print(f"skipped: expected models in {options.models}, found no such folder", file=sys.stderr)
        sys.exit(1 if os.environ.get("CI") == "true" else SKIPPED)
    if options.only == "all":
        options.only = ",".join(json.loads(pathlib.Path(options.catalog).read_text())["animals"])

    print("| animal | form | clips | times | vertices | found max / R | printed / R | least share (clips above 1e-3 R) | "
          "most below / R | most above / R |")
    print("|---|---|" + "---:|" * 8)
    faults, clip_count = [], 0
    with tempfile.TemporaryDirectory() as folder:
        for form in options.forms.split(","):
            found, count = check_form(options, form, pathlib.Path(folder) / form)
            faults += found
            clip_count += count
    print("\n".join(faults + [f"{clip_count} clips, {len(faults)} faults"]))
    sys.exit(0 if clip_count > 0 and not faults else 1)


if __name__ == "__main__":
    main()
