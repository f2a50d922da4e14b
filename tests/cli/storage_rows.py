# SPDX-License-Identifier: MIT
"""Animals whose data is compressed or lies outside the BIN chunk: good ones give the palette of the plain animal,
bad ones their own exit code."""

import base64
import struct

import compression
import glb
from harness import OpenWatch, Row


def _bake_like_plain(case, document, *options):
    """Bakes the document, and expects the matrices of the animal whose data is stored plainly."""
    plain = case.write_animal(glb.tiny_animal().glb())
    case.expect_ok(case.bake(plain, output="plain"))
    if not case.expect_ok(case.bake(case.write_animal(document.glb()), *options)):
        return
    for row in (0, 7, 29, 31, 45, 59):
        for bone in ("root", "spine", "head"):
            case.equal(case.matrix("out/deer.posepack", row, bone), case.matrix("plain/deer.posepack", row, bone),
                       f"row {row} of {bone}")


def _meshopt(case):
    document = glb.tiny_animal()
    streams = compression.compress_with_meshopt(document)
    case.check({"times", "spine", "root", "binds", "positions"} <= set(streams), f"compressed: {sorted(streams)}")
    _bake_like_plain(case, document)


def _fallback_uri(case):
    document = glb.tiny_animal()
    compression.compress_with_meshopt(document)
    document.json["buffers"][1]["uri"] = "fallback.bin"
    document.json["extensionsRequired"] = []
    fallback = case.write("models/fallback.bin", bytes(100_000))
    with OpenWatch(fallback) as watch:
        case.expect_ok(case.bake(case.write_animal(document.glb()), watched=False))
        case.check(not watch.was_opened(), "the fallback buffer was opened")


def _draco(case):
    document = glb.tiny_animal()
    compression.compress_with_draco(document)
    _bake_like_plain(case, document)


def _data_uri(case):
    document = glb.tiny_animal()
    uri = "data:application/octet-stream;base64," + base64.b64encode(bytes(document.bin)).decode()
    document.json["buffers"][0]["uri"] = uri
    document.bin.clear()
    case.expect_bake_refused(case.write_animal(document.glb()), 5, "E-GLB-URI", mentions=("--allow-data-uris",),
                             output="refused")
    _bake_like_plain(case, document, "--allow-data-uris")


def _meshopt_file(change, *names):
    """The file with those accessors in streams, after change(document, extension object of the first)."""
    def make():
        document = glb.tiny_animal()
        streams = compression.compress_with_meshopt(document, *names)
        change(document, streams[names[0]])
        return document.glb()
    return make


def _set_byte(document, extension, at, value):
    document.bin[extension["byteOffset"] + at] = value


def _sparse_over_count():
    """Indices whose decoded values leave the accessor; the plain bytes at the same place are harmless."""
    document = glb.tiny_animal()
    indices = [3, glb.KEY_COUNT]
    stream = compression.add_meshopt_view(document, compression.meshopt_indices(indices), 2, 2, "INDICES")
    view = document.json["bufferViews"][stream]
    view["buffer"] = 0
    view["byteOffset"] = document.json["bufferViews"][document.add_view(struct.pack("<2H", 3, 4))]["byteOffset"]
    values = document.add_view(struct.pack("<6f", *[0.25] * 6))
    document.accessor("root")["sparse"] = {"count": 2,
                                           "indices": {"bufferView": stream, "componentType": glb.USHORT},
                                           "values": {"bufferView": values}}
    return document.glb()


def _draco_file(change=None, **changes):
    def make():
        document = glb.tiny_animal()
        view = compression.compress_with_draco(document, **changes)
        if change:
            change(document, view)
        return document.glb()
    return make


def _declare_few_points(document, _):
    for index in document.json["meshes"][0]["primitives"][0]["attributes"].values():
        document.json["accessors"][index]["count"] = 5


def _cut_stream(_, view):
    view["byteLength"] -= 100


# name, title, the file, exit code, issue, what the message must name
REFUSED = [
    ("G25", "meshopt stream of version 1", _meshopt_file(lambda d, e: _set_byte(d, e, 0, 0xA1), "spine"),
     5, "E-GLB-EXTENSION", ("KHR_meshopt_compression",)),
    ("G25b", "meshopt filter of KHR_meshopt_compression", _meshopt_file(lambda d, e: e.update(filter="COLOR"), "spine"),
     5, "E-GLB-EXTENSION", ("COLOR",)),
    ("G26", "meshopt-coded sparse indices that leave their accessor", _sparse_over_count, 3, "E-GLB-SPARSE",
     ("sparse",)),
    ("G27", "meshopt stream one byte short",
     _meshopt_file(lambda d, e: e.update(byteLength=e["byteLength"] - 1), "spine"), 3, "E-GLB-MESHOPT",
     ("bufferViews/",)),
    ("G27b", "meshopt view of 2^40 elements",
     _meshopt_file(lambda d, e: (e.update(count=1 << 40), d.view("spine").update(byteLength=1 << 44)), "spine"),
     3, "E-GLB-MESHOPT", ("bufferViews/",)),
    ("G29b", "Draco stream of more points than its accessors declare", _draco_file(_declare_few_points),
     6, "E-LIM-DECODED", ("the 5 points", "found 20 ")),
    ("G29c", "Draco stream of 2^32 - 1 faces", _draco_file(faces=0xFFFFFFFF), 6, "E-LIM-DECODED",
     ("and 4294967295 in",)),
    ("G29d", "Draco stream that is cut off", _draco_file(_cut_stream), 3, "E-GLB-DRACO", ("primitives/0",)),
]


def _refused_row(name, title, make, exit_code, issue, mentions):
    def run(case):
        case.expect_bake_refused(case.write_animal(make()), exit_code, issue, mentions=("deer.glb", *mentions))
    return Row(name, title, run)


ROWS = [_refused_row(*row) for row in REFUSED] + [
    Row("G24", "MUST PASS: an animal in meshopt streams", _meshopt),
    Row("G28", "MUST PASS: a fallback buffer in a file that is not opened", _fallback_uri),
    Row("G29", "MUST PASS: a Draco primitive", _draco),
    Row("G31b", "buffer in a data URI, with and without --allow-data-uris", _data_uri),
]
