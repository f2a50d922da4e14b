# SPDX-License-Identifier: MIT
"""Random damage: whatever a byte becomes, the program answers by the book."""

import random

import glb
from harness import Row

SEED = 20_261_125
RUNS = 300
ANSWERS = {0, 3, 4, 5, 6}  # 4: the catalog names a clip that the damaged model no longer has


def _mutate(random_source, data):
    """A truncation in one of five, else one byte made another. Returns the bytes and what was done."""
    offset = random_source.randrange(len(data))
    if random_source.random() < 0.2:
        return data[:offset], f"cut at {offset}"
    changed = bytearray(data)
    changed[offset] = (changed[offset] + random_source.randrange(1, 256)) % 256
    return bytes(changed), f"byte {offset} from {data[offset]:#04x} to {changed[offset]:#04x}"


def _length_mended(data):
    """A cut file whose header and last chunk say so: it gets past the framing."""
    if len(data) < 24 or data[:4] != b"glTF":
        return data
    json_size = int.from_bytes(data[12:16], "little")
    bin_header = 20 + json_size
    data = bytearray(data[:len(data) // 4 * 4])
    data[8:12] = len(data).to_bytes(4, "little")
    if bin_header + 8 <= len(data):
        data[bin_header:bin_header + 4] = (len(data) - bin_header - 8).to_bytes(4, "little")
    return bytes(data)


def _check_one(case, number, data, what):
    case.write("models/deer.glb", data)
    output = f"out_{number}"
    result = case.bake("models/catalog.json", output=output, watched=False)
    fault_count = len(case.faults)
    case.check(result.exit_code in ANSWERS, f"exit code {result.exit_code}: {result.stderr[:300]}")
    case.expect_bounded(result, "bake")
    if result.exit_code == 0:
        verified = case.run("verify", "--strict", output, watched=False)
        case.equal(verified.exit_code, 0, f"exit code of verify ({verified.stderr})")
    else:
        case.check(len(result.stderr.splitlines()) == 1 and len(result.lines("error")) == 1,
                   f"stderr: expected one error line, found {result.stderr[:300]}")
        case.equal(case.output(output), [], "files published by a refused bake")
    for index in range(fault_count, len(case.faults)):
        case.faults[index] = f"{what}: {case.faults[index]}"
    return result.exit_code


def _mutations(case):
    random_source = random.Random(SEED)
    good = glb.tiny_animal().glb()
    case.write_catalog({"deer": {"model": "deer.glb", "clips": ["Walk", "Idle"]}})
    counts = {}
    for number in range(RUNS):
        data, what = _mutate(random_source, good)
        if number % 2 == 1:
            data, what = _length_mended(data), what + ", lengths mended"
        exit_code = _check_one(case, number, data, f"mutation {number} ({what})")
        counts[exit_code] = counts.get(exit_code, 0) + 1
    case.notes.append(f"seed {SEED}: " + ", ".join(f"exit {code} x {counts[code]}"
                                                   for code in sorted(counts)))
    case.check(len(counts) >= 3, f"expected several kinds of answers, found {counts}")


ROWS = [Row("Z01", f"{RUNS} random mutations and truncations of a GLB", _mutations)]
