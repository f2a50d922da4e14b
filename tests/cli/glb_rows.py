# SPDX-License-Identifier: MIT
"""Broken and unusual GLB files, and the answer each must get."""

import os
import struct

import glb
from harness import OpenWatch, Row

NEARLY_2_63 = 4611686018427387904  # times a stride of 4 it wraps to 0 in 64 bits


def _changed(change, **options):
    """The tiny animal after `change(document)`."""
    document = glb.tiny_animal(**options)
    change(document)
    return document.glb()


def _good():
    return glb.tiny_animal().glb()


def _header(offset, value):
    data = bytearray(_good())
    struct.pack_into("<I", data, offset, value)
    return bytes(data)


def _chunks(*extra):
    document = glb.tiny_animal()
    return glb.glb_from_chunks([glb.chunk(glb.JSON_CHUNK, document.text(), b" "),
                                glb.chunk(glb.BIN_CHUNK, document.bin), *extra])


def _root_translation(document, values):
    document.json["nodes"][1]["translation"] = values


def _huge_number():
    document = glb.tiny_animal()
    _root_translation(document, ["HUGE", 0, 0])
    return document.glb_with_text(b'"HUGE"', b"1e999")


def _view_past_bin(document):
    document.json["bufferViews"][-1]["byteLength"] += 1 + -len(document.bin) % 4


def _no_view_millions(document):
    binds = document.accessor("binds")
    del binds["bufferView"]
    binds["count"] = 16_000_000


def _sparse(document, *indices):
    times = document.accessor("root")
    times["sparse"] = {"count": len(indices),
                       "indices": {"bufferView": document.add_view(struct.pack(f"<{len(indices)}H",
                                                                               *indices)),
                                   "componentType": glb.USHORT},
                       "values": {"bufferView": document.add_view(struct.pack(f"<{3 * len(indices)}f",
                                                                              *[0.25] * 3 * len(indices)))}}


def _require(*extensions):
    def change(document):
        document.json["extensionsUsed"] = document.json["extensionsRequired"] = list(extensions)
    return change


def _node_loop(document):
    document.json["nodes"] += [{"name": "four"}, {"name": "five", "children": [3]}]
    document.json["nodes"][3]["children"] = [5]
    document.json["nodes"][2].pop("children")


def _node_chain(document):
    first = len(document.json["nodes"])
    document.json["nodes"] += [{"children": [first + 1 + number]} for number in range(60_000)] + [{}]
    document.json["nodes"][3]["children"] = [first]


def _keys(times):
    """The clip "Walk" as a translation of the root with these key times and x = 0, 1, 5, 6."""
    def change(document):
        document.add("few_times", times, "SCALAR")
        document.add("few_values", [number for x in (0, 1, 5, 6) for number in (x, 0, 0)], "VEC3")
        document.json["animations"] = [{"name": "Walk", "channels": [glb.channel(1, "translation", 0)],
                                        "samplers": [{"input": document.names["few_times"],
                                                      "output": document.names["few_values"]}]}]
    return change


# name, title, the file, exit code, issue, what the message must name
REFUSED = [
    ("G01", "empty file", lambda: b"", 3, "E-GLB-TRUNCATED", ()),
    ("G02", "first 11 bytes", lambda: _good()[:11], 3, "E-GLB-TRUNCATED", ()),
    ("G03", "magic glTG", lambda: b"glTG" + _good()[4:], 3, "E-GLB-MAGIC", ()),
    ("G04", "version 1", lambda: _header(4, 1), 5, "E-GLB-VERSION", ()),
    ("G06", "length one more than the file", lambda: _header(8, len(_good()) + 1), 3, "E-GLB-LENGTH", ()),
    ("G07", "4 KiB behind the end", lambda: _good() + b"\xa5" * 4096, 3, "E-GLB-TRAILING", ()),
    ("G08", "JSON chunk length that wraps", lambda: _header(12, 0xFFFFFFFC), 3, "E-GLB-CHUNK", ()),
    ("G10", "two BIN chunks", lambda: _chunks(glb.chunk(glb.BIN_CHUNK, b"more")), 3, "E-GLB-CHUNK", ()),
    ("G12", "invalid UTF-8 in a node name", lambda: glb.tiny_animal().glb_with_text(b'"head"', b'"he\xffd"'),
     3, "E-GLB-JSON", ()),
    ("G14", "key accessors twice",
     lambda: glb.tiny_animal().glb_with_text(b'{"asset"', b'{"accessors": [], "asset"'),
     3, "E-GLB-JSON-DUP", ("accessors",)),
    ("G15", "node translation 1e999", _huge_number, 3, "E-GLB-NUMBER", ()),
    ("G17", "accessor count whose bytes wrap to 0",
     lambda: _changed(lambda d: d.accessor("times").update(count=NEARLY_2_63)), 3, "E-GLB-ACCESSOR-RANGE",
     ()),
    ("G18", "animation input of no elements", lambda: _changed(lambda d: d.accessor("times").update(count=0)),
     3, "E-GLB-ACCESSOR-COUNT", ()),
    ("G19", "buffer view one byte past BIN", lambda: _changed(_view_past_bin), 3, "E-GLB-VIEW-RANGE",
     ("bufferViews/",)),
    ("G21", "accessor one byte past its view",
     lambda: _changed(lambda d: d.view("root").update(byteLength=d.view("root")["byteLength"] - 1)),
     3, "E-GLB-ACCESSOR-RANGE", ("accessors/",)),
    ("G22", "16,000,000 matrices without a view", lambda: _changed(_no_view_millions), 6, "E-LIM-DECODED",
     ()),
    ("G23", "sparse index equal to count", lambda: _changed(lambda d: _sparse(d, 3, glb.KEY_COUNT)),
     3, "E-GLB-SPARSE", ()),
    ("G30", "requires an extension that nobody knows",
     lambda: _changed(_require("KHR_lights_punctual", "ACME_x")),
     5, "E-GLB-EXTENSION", ("ACME_x",)),
    ("G33", "nodes 3 and 5 children of each other", lambda: _changed(_node_loop), 3, "E-GLB-NODE-LOOP", ()),
    ("G35", "chain of 60,000 nodes", lambda: _changed(_node_chain), 6, "E-LIM-NODE-DEPTH", ()),
    ("G36", "joint equal to the node count",
     lambda: _changed(lambda d: d.json["skins"][0].update(joints=[1, 2, 4])),
     3, "E-GLB-SKIN-JOINT", ()),
    ("G37", "one inverse bind matrix too few",
     lambda: _changed(lambda d: d.accessor("binds").update(count=2)),
     3, "E-GLB-IBM-COUNT", ()),
    ("G41b", "key times that fall", lambda: _changed(_keys([0, 0.5, 0.4, 1])), 3, "E-GLB-TIMES", ()),
    ("G43", "rotation key of zeros", lambda: _changed(lambda d: d.put("spine", 4 * 7, 0, 0, 0, 0)),
     3, "E-GLB-QUAT", ("7",)),
    ("G45", "no clip at all", lambda: _changed(lambda d: d.json.pop("animations")), 5, "E-GLB-NO-ANIMATION",
     ()),
]


def _refused_row(name, title, make, exit_code, issue, mentions):
    def run(case):
        catalog = case.write_animal(make())
        case.expect_bake_refused(catalog, exit_code, issue, mentions=("deer.glb", *mentions))
    return Row(name, title, run)


def _unknown_chunk(case):
    data = _chunks(glb.chunk(b"XTRA", b"anything"))
    case.expect_ok(case.bake(case.write_animal(data)), ["W-GLB-CHUNK"])
    plain = case.bake(case.write_animal(_good()), output="plain")
    case.expect_ok(plain)


def _sparse_good(case):
    """The last key may be named: index count - 1 is in range, and its value is the sparse one."""
    catalog = case.write_animal(_changed(lambda d: _sparse(d, 3, glb.KEY_COUNT - 1)),
                                clips=[{"name": "Idle", "wrap": "once"}])
    if case.expect_ok(case.bake(catalog, "--space", "model")):
        found = [case.matrix("out/deer.posepack", row, "root")[3] for row in (3, glb.KEY_COUNT - 1)]
        case.equal(found, [0.25, 0.25], "root x at the sparse keys")


def _outside_buffer(case):
    secret = case.write("secret.bin", bytes(100_000))
    document = glb.tiny_animal()
    models = "models/a/b/c/d"
    document.json["buffers"][0]["uri"] = "../../../../secret.bin"
    case.write("models/secret.bin", bytes(100_000))
    case.write(models + "/deer.glb", document.glb())
    catalog = case.write_catalog({"deer": {"model": "a/b/c/d/deer.glb"}})
    with OpenWatch(secret, case.path("models/secret.bin")) as watch:
        result = case.bake(catalog, watched=False)
        case.check(not watch.was_opened(), "the buffer's uri was opened")
    case.expect_refused(result, 5, "E-GLB-URI", ("secret.bin",))
    case.equal(case.output(), [], "files published by a refused bake")


def _image_uris(case):
    neighbour = case.write("models/picture.png", b"no picture")
    document = glb.tiny_animal()
    document.json["images"] = [{"uri": "a`touch x`"}, {"uri": "file:///etc/hostname"}, {"uri": "picture.png"},
                               {"uri": "$(touch y)"}, {"uri": "data:image/png;base64,AAAA"}]
    document.json["textures"] = [{"source": index} for index in range(5)]
    catalog = case.write_animal(document.glb())
    watched = [neighbour] + [path for path in ("/etc/hostname",) if os.path.isfile(path)]
    with OpenWatch(*watched) as watch:
        result = case.bake(catalog, watched=False)
        case.check(not watch.was_opened(), "an image's uri was opened")
    case.expect_ok(result)
    made = [name for name in ("x", "y") for folder in (".", "models", "home")
            if os.path.exists(case.path(folder, name))]
    case.equal(made, [], "files made by commands in a uri")


def _equal_times(case):
    """Keys 0, 0.5, 0.5, 1 with x = 0, 1, 5, 6: up to 0.5 s towards 1, from 0.5 s on 5 and more."""
    catalog = case.write_animal(_changed(_keys([0, 0.5, 0.5, 1])), clips=[{"name": "Walk", "wrap": "once"}])
    result = case.bake(catalog, "--rate", 10, "--texel-format", "rgba32f", "--space", "model")
    if case.expect_ok(result, ["W-GLB-TIMES"]):
        case.contains(result.stderr, " 1 ", "the warning's count")
        found = [case.matrix("out/deer.posepack", row, "root")[3] for row in (0, 4, 5, 10)]
        expected = [0.0, 0.8, 5.0, 6.0]
        case.check(all(abs(a - b) < 1e-6 for a, b in zip(found, expected)),
                   f"root x at 0, 0.4, 0.5 and 1 s: expected {expected}, found {found}")
    case.expect_bake_refused(catalog, 3, "E-GLB-TIMES", "--strict", output="strict")


def _half_range(case):
    def change(document):
        _root_translation(document, [70_000, 0, 0])
    catalog = case.write_animal(_changed(change), clips=["Walk"])
    case.expect_bake_refused(catalog, 6, "E-LIM-HALF-RANGE", "--space", "model", mentions=("deer", "Walk", "'root'", "row 0"))
    case.expect_ok(case.bake(catalog, "--texel-format", "rgba32f", "--space", "model"))
    found = case.matrix("out/deer.posepack", 0, "root")[3]
    case.equal(found, 70_000.0, "root x in RGBA32F")
    case.expect_ok(case.bake(catalog, output="normalised"))  # the place of the animal is no part of its rows


ROWS = [_refused_row(*row) for row in REFUSED] + [
    Row("G11", "MUST PASS: unknown chunk behind BIN", _unknown_chunk),
    Row("G23b", "MUST PASS: sparse index one below count", _sparse_good),
    Row("G31", "buffer uri outside the file", _outside_buffer),
    Row("G32", "MUST PASS: image uris with commands and paths", _image_uris),
    Row("G41", "equal key times, with and without --strict", _equal_times),
    Row("G44", "root at 70,000 in half and in float", _half_range),
]
