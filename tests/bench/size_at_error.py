#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Bytes at equal error, and at a bound, over the animals of a catalog.

    size_at_error.py --posepack FILE --models DIR [--catalog FILE] [--only ID,...] [--markdown]

Baselines: A stores 4x4 matrices in RGBA32F, round(30 d) + 1 rows spread over a clip's exact length d, all
bones; B the same in RGBA16F, half of A. Bytes of palettes count texels (closing rows too) and the tables of
runs and slots. "equal": each clip's max, p99.9 and rms are not above A's own, or 5e-4 / 3e-4 / 1e-4 of R where A's are
smaller. "default": the bound of that name. Every error is measured by `posepack bake` on the written bytes.
"""
import argparse
import json
import pathlib
import subprocess
import tempfile
import time

FLOORS = {"max": 5e-4, "p999": 3e-4, "rms": 1e-4}


def bake(options, catalog, out, *more):
    command = [options.posepack, "-q", "bake", "--jobs", "2", str(catalog), "--models", options.models, "-o", str(out),
               "--no-fsync", *more]
    if options.only:
        command += ["--only", options.only]
    start = time.monotonic()
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"expected a bake, found exit code {done.returncode}: {done.stderr}")
    manifest = json.loads((pathlib.Path(out) / "manifest.json").read_text())
    return {record["id"]: record for record in manifest["records"]}, time.monotonic() - start


def figures(error):
    return {"max": error["max"], "p999": error["p999"], "rms": error["rms"]}


def with_clips(catalog, clips_of):
    """The catalog with other clip wishes: clips_of(id) gives them."""
    out = json.loads(json.dumps(catalog))
    out.get("defaults", {}).pop("output", None)
    for name, animal in out["animals"].items():
        animal.pop("output", None)
        if clips := clips_of(name):
            animal["clips"] = clips
    return out


def row_bytes(record):
    return record["texel_bytes"] + record["row_table_bytes"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--posepack", required=True)
    parser.add_argument("--models", required=True)
    parser.add_argument("--catalog", default=str(pathlib.Path(__file__).parents[1] / "data/real_animals.json"))
    parser.add_argument("--only", default="")
    parser.add_argument("--markdown", action="store_true")
    options = parser.parse_args()
    catalog = json.loads(pathlib.Path(options.catalog).read_text())
    if options.only:
        catalog["animals"] = {k: v for k, v in catalog["animals"].items() if k in options.only.split(",")}

    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)

        def baked(name, content, *more):
            (folder / f"{name}.json").write_text(json.dumps(content))
            return bake(options, folder / f"{name}.json", folder / name, *more)

        once = with_clips(catalog, lambda _: [{"name": "*", "wrap": "once"}])
        a, _ = baked("a", once, "--encoding", "mat4", "--texel-format", "rgba32f", "--rate", "30")

        def equal_clips(name):
            wishes = []
            for clip in a[name]["clips"]:
                bound = {key: max(value, FLOORS[key]) for key, value in figures(clip["error"]).items()}
                wishes.append({"name": clip["name"], "max_error": bound["max"], "p999_error": bound["p999"],
                               "rms_error": bound["rms"]})
            return wishes

        equal, equal_s = baked("equal", with_clips(catalog, equal_clips), "--max-error", "default")
        default, default_s = baked("default", with_clips(catalog, lambda _: None), "--max-error", "default")

    rows = []
    for name in sorted(a):
        rows.append([name, a[name]["bone_count"], a[name]["texel_bytes"], row_bytes(equal[name]),
                     row_bytes(default[name]), default[name]["error"]["max"],
                     max(clip["error"]["p999"] for clip in default[name]["clips"]), default[name]["error"]["rms"]])
        for clip in equal[name]["clips"]:
            of_a = next(c for c in a[name]["clips"] if c["name"] == clip["name"])
            for key, value in figures(clip["error"]).items():
                assert value <= max(figures(of_a["error"])[key], FLOORS[key]) * (1 + 1e-6), (name, clip["name"], key)
    total = [sum(row[i] for row in rows) for i in range(2, 5)]

    bar, end = ("| ", " |") if options.markdown else ("", "")
    gap = " | " if options.markdown else "  "
    print(bar + gap.join(["animal".ljust(18), "bones", "   A KB", "equal KB", "A/equal", "default KB", "A/default",
                          "    max", "  p99.9", "    rms"]) + end)
    if options.markdown:
        print("|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|")
    for name, bones, of_a, of_equal, of_default, largest, p999, rms in rows:
        print(bar + gap.join([name.ljust(18), f"{bones:5}", f"{of_a / 1e3:7.0f}", f"{of_equal / 1e3:8.1f}",
                              f"{of_a / of_equal:7.1f}", f"{of_default / 1e3:10.1f}",
                              f"{of_a / of_default:9.1f}", f"{largest:7.1e}", f"{p999:7.1e}", f"{rms:7.1e}"]) + end)
    print(bar + gap.join(["all".ljust(18), "     ", f"{total[0] / 1e3:7.0f}", f"{total[1] / 1e3:8.1f}",
                          f"{total[0] / total[1]:7.1f}", f"{total[2] / 1e3:10.1f}", f"{total[0] / total[2]:9.1f}",
                          "       ", "       ", "       "]) + end)
    print(f"\nB is half of A: equal {total[0] / total[1] / 2:.1f} x, default {total[0] / total[2] / 2:.1f} x fewer "
          f"bytes than B. Chosen and proved in {equal_s:.1f} s and {default_s:.1f} s.")


if __name__ == "__main__":
    main()
