# SPDX-License-Identifier: MIT
"""Catalogs of tiny animals, written into the models folder of a case. Each returns the catalog's path."""

import glb


def deer(case, **fields):
    """One animal, "deer": clips Walk and Idle."""
    return case.write_animal(glb.tiny_animal().glb(), **fields)


def deer_and_elk(case):
    """Two animals; the elk also runs."""
    elk = glb.tiny_animal(("Walk", "Idle", "Run"))
    elk.json["nodes"][1]["translation"] = [0.5, 0.0, 0.0]
    case.write("models/deer.glb", glb.tiny_animal().glb())
    case.write("models/elk.glb", elk.glb())
    return case.write_catalog({"deer": {"model": "deer.glb"}, "elk": {"model": "elk.glb"}})


def many_deer(case, count, bad=()):
    """Animals deer_00, deer_01... that differ a little; those of the numbers `bad` are no GLB."""
    animals = {}
    for number in range(count):
        document = glb.tiny_animal()
        document.json["nodes"][1]["translation"] = [number / 8, 0.0, 0.0]
        name = f"deer_{number:02}"
        case.write(f"models/{name}.glb", document.glb() if number not in bad else b"glTF and no more")
        animals[name] = {"model": name + ".glb"}
    return case.write_catalog(animals)
