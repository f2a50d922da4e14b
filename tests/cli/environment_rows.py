# SPDX-License-Identifier: MIT
"""The command line itself, and what the machine may do to a bake: full disks, locks, kills, other writers."""

import fcntl
import hashlib
import os
import resource
import shutil
import signal
import subprocess
import threading
import time

import glb
from harness import LOCK_NAME, MANIFEST_NAME, TEMPORARY_PREFIX, Row, Skip, mounted, read_bytes, snapshot
from herd import many_deer

NOBODY = 65534
HERD = 30
COMMANDS = ("bake", "report", "compare", "inspect", "verify", "export", "menagerie")


def _temporaries(case, folder="out"):
    return [name for name in case.output(folder) if name.startswith(TEMPORARY_PREFIX)]


# Usage


def _no_arguments(case):
    result = case.run()
    case.equal(result.exit_code, 1, "exit code")
    case.equal(result.stdout, "", "stdout")
    case.contains(result.stderr, "Usage: posepack", "stderr")
    for command in COMMANDS:
        case.contains(result.stderr, f"  {command} ", "usage")


# name, arguments, what the message must name
MISUSED = [
    ("X02a", ("bake", "catalog.json", "-o", "out", "--modles", "m"), ("'--modles'", "'--models'")),
    ("X02b", ("bake", "catalog.json", "-o", "out", "--keepgoing"), ("'--keepgoing'", "'--keep-going'")),
    ("X02c", ("veryfy", "out"), ("'veryfy'", "'verify'")),
    ("X02d", ("verify", "out", "--stric"), ("'--stric'", "'--strict'")),
    ("X02e", ("inspect", "a.posepack", "--formt", "json"), ("'--formt'", "'--format'")),
    ("X03a", ("bake",), ("catalog",)),
    ("X03b", ("bake", "catalog.json"), ("--output",)),
    ("X03c", ("bake", "catalog.json", "-o", "out", "--encoding", "mat3"), ("mat4", "affine", "mat3")),
    ("X03d", ("bake", "catalog.json", "-o", "out", "--rate", "0"), ("--rate",)),
    ("X03d2", ("bake", "catalog.json", "-o", "out", "--rate", "nan"), ("--rate", "nan", "1 to 1000")),
    ("X03d3", ("bake", "catalog.json", "-o", "out", "--rate", "inf"), ("--rate", "inf")),
    ("X03d4", ("bake", "catalog.json", "-o", "out", "--rate", "1e400"), ("--rate", "1e400")),
    ("X03d5", ("bake", "catalog.json", "-o", "out", "--lock-timeout", "nan"), ("--lock-timeout", "nan")),
    ("X03d6", ("bake", "catalog.json", "-o", "out", "--lock-timeout", "-1"), ("--lock-timeout", "-1")),
    ("X03d7", ("compare", "catalog.json", "--rate", "-nan"), ("--rate", "-nan")),
    ("X03d8", ("report", "catalog.json", "--rates", "keys,inf"), ("--rates", "inf")),
    ("X03e", ("bake", "catalog.json", "-o", "out", "--rate", "fast"), ("--rate",)),
    ("X03f", ("bake", "catalog.json", "-o", "out", "--jobs", "0"), ("--jobs",)),
    ("X03g", ("verify", "out", "--format", "csv"), ("text", "json", "csv")),
    ("X03h", ("inspect", "a.posepack", "b.posepack"), ("b.posepack",)),
    ("X03i", ("export", "a.posepack"), ("--exr",)),
    ("X03j2", ("report", "catalog.json", "-o", "report.pdf"), ("report.pdf", ".html")),
    ("X03j3", ("report", "catalog.json", "-o", "report"), ("'report'", "--format")),
    ("X03j4", ("report", "catalog.json", "--format", "pdf"), ("text, csv, json, html", "pdf")),
    ("X03j5", ("report", "catalog.json", "--heat-map", "-o", "report.csv"), ("--heat-map", "json and html")),
    ("X03j", ("report", "catalog.json", "--rates", "keys,fast"), ("fast",)),
    ("X03k", ("compare", "catalog.json", "--copies", "0"), ("--copies",)),
    ("X03l", ("menagerie", "models/m", "--only", "gaot"), ("gaot", "goat")),
    ("X03n", ("menagerie", "models/m", "--animals", "40", "--seed", "-3"), ("--seed", "-3")),
    ("X03o", ("menagerie", "models/m", "--seed", "3"), ("--seed", "--animals")),
    ("X03p", ("inspect", "a.posepack", "--clip", "Walk"), ("--clip", "--row")),
    ("X03q", ("inspect", "a.posepack", "--bone", "0"), ("--bone", "--row")),
    ("X03m", ("menagerie", "models/m", "--animals", "3001"), ("--animals", "3001")),
]


def _misused_row(name, arguments, mentions):
    def run(case):
        result = case.run(*arguments)
        case.expect_refused(result, 1, "E-USAGE", mentions)
        for argument in arguments:
            case.check(not argument.startswith("--") or f"{argument}: {argument}: " not in result.stderr,
                       f"stderr names {argument} twice: {result.stderr}")
    return Row(name, "misuse: posepack " + " ".join(arguments), run)


# Files


def _missing_catalog(case):
    case.expect_bake_refused("nothing.json", 2, "E-IO-OPEN", mentions=("nothing.json",))


def _missing_model(case):
    catalog = case.write_catalog({"deer": {"model": "herd/deer.glb"}})
    case.expect_bake_refused(catalog, 2, "E-IO-OPEN", mentions=("deer", "herd/deer.glb"))
    case.expect_bake_refused(catalog, 2, "E-IO-OPEN", "--models", "no/such/folder",
                             mentions=("no/such/folder",))


def _folder_as_model(case):
    os.makedirs(case.path("models/deer.glb"))
    os.mkfifo(case.path("models/pipe.glb"))
    for model in ("deer.glb", "pipe.glb"):
        catalog = case.write_catalog({"deer": {"model": model}})
        case.expect_bake_refused(catalog, 2, "E-IO-OPEN", mentions=(model,))


# The model is no GLB: an exit code of 3 would say that it was baked before the folder was tried.


def _read_only_folder(case):
    catalog = case.write_animal(b"no GLB")
    os.makedirs(case.path("out"))
    os.chmod(case.path("out"), 0o555)
    other = {} if os.geteuid() != 0 else {"user": NOBODY, "group": NOBODY, "extra_groups": []}
    if other:
        try:
            case.start("--version", **other).wait()
        except PermissionError:
            raise Skip("root ignores permissions, and nobody else may run the program") from None
    case.expect_bake_refused(catalog, 2, "E-IO-WRITE", mentions=("out",), **other)


def _below_a_file(case):
    catalog = case.write_animal(b"no GLB")
    case.write("plain", b"a file")
    for output in ("plain/out", "plain"):
        case.expect_bake_refused(catalog, 2, "E-IO-WRITE", output=output, mentions=("plain",), writes=())
    case.equal(read_bytes(case.path("plain")), b"a file", "the file in the way")


def _read_only_mount(case):
    catalog = case.write_animal(b"no GLB")
    os.makedirs(case.path("out"))
    with mounted(["-t", "tmpfs", "-o", "ro,size=1m", "none"], case.path("out")):
        case.expect_bake_refused(catalog, 2, "E-IO-WRITE", mentions=("out",))


def _full_disk(case):
    """Two small bakes fit into 1 MiB; then three large ones do not, whatever is asked to keep going."""
    catalog = many_deer(case, 3)
    os.makedirs(case.path("out"))
    with mounted(["-t", "tmpfs", "-o", "size=1m", "none"], case.path("out")):
        case.expect_ok(case.bake(catalog))
        before = case.output_bytes()
        for extra in ((), ("--keep-going",), ("--jobs", "1")):
            result = case.bake(catalog, "--rate", 1000, "--texel-format", "rgba32f", "--encoding", "mat4",
                               *extra)
            case.expect_refused(result, 2, "E-IO-SPACE", ("out/",))
            case.check(case.output_bytes() == before,
                       "the old outputs are not what they were, or a temporary is left")
        case.expect_ok(case.run("verify", "--strict", "out"))


# Other processes


def _killed(case, catalog, staged):
    """Starts a bake and kills it when that many animals are staged. Returns whether it was in time."""
    process = case.start("bake", catalog, "-o", "out", "--jobs", 1, "--rate", 60)
    deadline = time.monotonic() + 20
    while process.poll() is None and time.monotonic() < deadline and len(_temporaries(case)) < staged:
        time.sleep(0.0005)
    process.send_signal(signal.SIGKILL)
    process.wait()
    return process.returncode == -signal.SIGKILL


def _kill(case):
    catalog = many_deer(case, HERD)
    case.expect_ok(case.bake(catalog, "--rate", 60, measure=True, output="clean"))
    clean = case.output_bytes("clean")
    in_time = 0
    for staged in (1, 2, 7, 15, 25):
        shutil.rmtree(case.path("out"), ignore_errors=True)
        case.expect_ok(case.bake(catalog, "--rate", 10))
        old = case.output_bytes()
        in_time += _killed(case, catalog, staged)
        left = case.output_bytes()
        for name, data in left.items():
            is_whole = data in (old.get(name), clean.get(name)) or name.startswith(TEMPORARY_PREFIX)
            case.check(is_whole, f"{name}: neither the old nor the new file after the kill")
        case.expect_ok(case.bake(catalog, "--rate", 60, measure=True))
        case.check(case.output_bytes() == clean, "the next bake differs from a clean one")
        case.equal(_temporaries(case), [], "temporaries after the next bake")
    case.check(in_time >= 3, f"expected most of 5 kills in mid-bake, found {in_time}")


def _locked(case):
    catalog = case.write_animal(glb.tiny_animal().glb())
    case.expect_ok(case.bake(catalog))
    before = case.output_bytes()
    with open(case.path("out", LOCK_NAME), "r+b") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        result = case.bake(catalog, "--rate", 20, "--lock-timeout", 1)
        case.expect_refused(result, 2, "E-IO-LOCKED", ("out",))
        case.check(0.9 <= result.wall_s < 5.0, f"expected to wait about 1 s, found {result.wall_s:.2f} s")
        case.check(case.output_bytes() == before, "a bake that did not get the lock changed the folder")
        started = time.monotonic()
        waiting = case.start("bake", catalog, "-o", "out", "--no-fsync", "--no-measure")
        time.sleep(0.2)
        case.equal(waiting.poll(), None, "exit code of a bake that should wait")
    waiting.wait()
    case.equal(waiting.returncode, 0, "exit code of the bake that waited for the lock")
    case.check(time.monotonic() - started < 10, "the lock was free long before the waiting bake took it")


def _replaced_model(case):
    """Two good models take turns under one name while 30 animals read it: records are of the bytes used."""
    models = {}
    for name in ("a", "b"):
        document = glb.tiny_animal()
        document.json["nodes"][1]["translation"] = [1.0 if name == "b" else 0.0, 0.0, 0.0]
        models[name] = document.glb()
        case.write(f"{name}/deer.glb", models[name])
    animals = {f"deer_{number:02}": {"model": "deer.glb"} for number in range(HERD)}
    catalog = case.write_catalog(animals)
    expected = {}
    for name, data in models.items():
        case.expect_ok(case.bake(catalog, "--models", name, output="out_" + name))
        expected[hashlib.sha256(data).hexdigest()] = case.output_bytes("out_" + name)
    _bake_while_replacing(case, catalog, models)
    used = {}
    for record in case.manifest()["records"]:
        outputs = expected.get(record["model_sha256"])
        if not case.check(outputs is not None, f"{record['id']}: its model's SHA-256 is that of no version"):
            continue
        used[record["model_sha256"]] = used.get(record["model_sha256"], 0) + 1
        case.check(case.output_bytes()[record["container"]] == outputs[record["container"]],
                   f"{record['id']}: the container is not that of the model recorded")
    case.notes.append(f"{'+'.join(str(count) for count in used.values())} animals of two versions of a model")


def _bake_while_replacing(case, catalog, models):
    stop = threading.Event()
    case.write("models/deer.glb", models["a"])

    def replace():
        turn = 0
        while not stop.is_set():
            turn += 1
            os.link(case.path("ab"[turn % 2], "deer.glb"), case.path("models", f"next_{turn}"))
            os.rename(case.path("models", f"next_{turn}"), case.path("models/deer.glb"))
            time.sleep(0.0003)

    writer = threading.Thread(target=replace)
    writer.start()
    try:
        result = case.bake(catalog, watched=False)
    finally:
        stop.set()
        writer.join()
    case.expect_ok(result)
    case.expect_ok(case.run("verify", "--strict", "out"))


def _keep_going(case):
    catalog = many_deer(case, HERD, bad={17})
    result = case.bake(catalog, "--keep-going")
    case.equal(result.exit_code, 9, "exit code")
    errors = result.lines("error")
    case.check(len(errors) == 1 and "deer_17" in errors[0] and "E-GLB-" in errors[0],
               f"stderr: {result.stderr}")
    good = [f"deer_{number:02}" for number in range(HERD) if number != 17]
    case.equal([record["id"] for record in case.manifest()["records"]], good, "records")
    case.equal(case.output(), [name + ".posepack" for name in good] + [MANIFEST_NAME], "files")
    case.expect_ok(case.run("verify", "--strict", "out"))
    whole = many_deer(case, HERD)
    case.expect_ok(case.bake(whole, output="whole"))
    same = case.output_bytes("whole")
    for name, data in case.output_bytes().items():
        case.check(name == MANIFEST_NAME or data == same[name],
                   f"{name}: differs from a bake without a bad animal")


def _keep_going_without_models(case):
    """A model that cannot be read is its animal's failure; a folder that cannot be written is everybody's."""
    catalog = many_deer(case, 6)
    case.expect_ok(case.bake(catalog, output="whole"))
    whole = case.output_bytes("whole")
    os.remove(case.path("models/deer_00.glb"))
    os.remove(case.path("models/deer_03.glb"))
    os.makedirs(case.path("models/deer_03.glb"))
    result = case.bake(catalog, "--keep-going")
    case.equal(result.exit_code, 9, "exit code")
    errors = result.lines("error")
    case.check(len(errors) == 2 and all("[E-IO-OPEN]" in line for line in errors) and "deer_00" in errors[0]
               and "deer_03" in errors[1], f"stderr: {result.stderr}")
    good = [f"deer_{number:02}" for number in (1, 2, 4, 5)]
    case.equal([record["id"] for record in case.manifest()["records"]], good, "records")
    for name in good:
        case.equal(case.output_bytes()[name + ".posepack"] == whole[name + ".posepack"], True, f"bytes of {name}")
    case.expect_ok(case.run("verify", "--strict", "out"))
    case.expect_bake_refused(catalog, 2, "E-IO-OPEN", output="all_or_none", mentions=("deer_00",))


def _name_in_the_way(case):
    """A folder or pipe that has the name of an output is found before anything is renamed."""
    catalog = many_deer(case, 4)
    for number, make in enumerate((os.makedirs, os.mkfifo)):
        output = f"out_{number}"
        case.expect_ok(case.bake(catalog, output=output))
        os.remove(case.path(output, "deer_02.posepack"))
        make(case.path(output, "deer_02.posepack"))
        kept = (MANIFEST_NAME, "deer_00.posepack", "deer_01.posepack", "deer_03.posepack")
        before = {name: read_bytes(case.path(output, name)) for name in kept}
        for extra in ((), ("--keep-going",)):
            result = case.bake(catalog, "--rate", 20, *extra, output=output)
            case.expect_refused(result, 2, "E-IO-WRITE", ("deer_02.posepack", "regular file"))
            case.check({name: read_bytes(case.path(output, name)) for name in kept} == before,
                       "files were replaced although one could not be")
            case.equal(_temporaries(case, output), [], "temporaries left")


# Signals


def _interrupted(case):
    """SIGINT and SIGTERM in mid-bake: exit 130, one line, no temporary, the old outputs."""
    catalog = many_deer(case, HERD)
    case.expect_ok(case.bake(catalog, "--rate", 10))
    before = case.output_bytes()
    in_time = 0
    for number in (signal.SIGINT, signal.SIGTERM):
        for staged in (1, 9):
            process = case.start("bake", catalog, "-o", "out", "--jobs", 1, "--rate", 1000, stderr=subprocess.PIPE)
            deadline = time.monotonic() + 20
            while process.poll() is None and time.monotonic() < deadline and len(_temporaries(case)) < staged:
                time.sleep(0.0005)
            process.send_signal(number)
            stderr = process.communicate()[1].decode()
            if process.returncode == 0:
                case.expect_ok(case.bake(catalog, "--rate", 10))
                continue
            in_time += 1
            case.equal(process.returncode, 130, f"exit code after signal {number} ({stderr})")
            case.check(len(stderr.splitlines()) == 1 and stderr.startswith("posepack: error[E-INTERRUPTED]: "),
                       f"stderr: expected one line, found {stderr}")
            case.check(case.output_bytes() == before, "the old outputs changed, or a temporary is left")
    case.check(in_time >= 3, f"expected most of 4 signals in mid-bake, found {in_time}")
    case.expect_ok(case.run("verify", "--strict", "out"))


def _interrupted_while_waiting(case):
    catalog = case.write_animal(glb.tiny_animal().glb())
    case.expect_ok(case.bake(catalog))
    with open(case.path("out", LOCK_NAME), "r+b") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        process = case.start("bake", catalog, "-o", "out", "--lock-timeout", "20", stderr=subprocess.PIPE)
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        stderr = process.communicate(timeout=10)[1].decode()
    case.equal(process.returncode, 130, f"exit code of a bake that waited for the lock ({stderr})")


def _file_size_limit(case):
    """Over the limit of file sizes (ulimit -f) a write fails and is told; the program does not die of it."""
    catalog = many_deer(case, 3)
    case.expect_ok(case.bake(catalog))
    before = case.output_bytes()

    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

    for extra in ((), ("--keep-going",)):
        result = case.bake(catalog, "--rate", 20, *extra, preexec_fn=limit)
        case.expect_refused(result, 2, "E-IO-WRITE", ("out/",))
        case.check(case.output_bytes() == before, "the old outputs changed, or a temporary is left")


def _closed_pipe(case):
    """Whoever reads the results goes away: an error, not a signal."""
    catalog = many_deer(case, 3)
    reader, writer = os.pipe()
    os.close(reader)
    process = case.start("bake", catalog, "-o", "out", "--no-measure", stdout=writer, stderr=subprocess.PIPE)
    os.close(writer)
    stderr = process.communicate()[1].decode()
    case.equal(process.returncode, 2, f"exit code ({stderr})")
    case.contains(stderr, "error[E-IO-WRITE]: stdout: ", "stderr")


def _first_failure(case):
    """Several bad animals: the first in the order of ids speaks, whatever the number of threads."""
    catalog = many_deer(case, 12, bad={3, 4, 9})
    case.write("models/deer_03.glb", b"glTG")
    for jobs in (1, 2, 8):
        for _ in range(3):
            case.expect_bake_refused(catalog, 3, "E-GLB-MAGIC", "--jobs", jobs, mentions=("deer_03",))


def _failure_keeps_the_old(case):
    catalog = many_deer(case, 3)
    case.expect_ok(case.bake(catalog))
    before = snapshot(case.path("out"))
    case.write("models/deer_01.glb", b"")
    result = case.bake(catalog, "--rate", 20)
    case.expect_refused(result, 3, "E-GLB-TRUNCATED", ("deer_01",))
    case.equal(snapshot(case.path("out")), before, "the folder after a bake that failed")
    for name in ("deer_00", "deer_01", "deer_02"):
        case.write(f"models/{name}.glb", b"glTG")
    every_one = case.bake(catalog, "--keep-going")
    case.equal(every_one.exit_code, 3, "exit code where every animal fails, with --keep-going")
    case.equal(every_one.stderr.count("error["), 3, "failures that are named")
    case.equal(snapshot(case.path("out")), before, "the folder after a bake in which every animal failed")
    all_bad = case.bake(case.write_animal(b""), "--keep-going", output="nothing")
    case.equal(all_bad.exit_code, 3, "exit code where no animal is good, with --keep-going")
    case.equal(case.output("nothing"), [], "files where no animal is good")


ROWS = [Row("X01", "no arguments", _no_arguments)] + [_misused_row(*row) for row in MISUSED] + [
    Row("X04", "catalog missing", _missing_catalog),
    Row("X04b", "model or models folder missing", _missing_model),
    Row("X04c", "a folder and a pipe in place of a model", _folder_as_model),
    Row("X05", "output folder without write permission", _read_only_folder),
    Row("X05b", "output folder below a plain file", _below_a_file),
    Row("X05c", "output folder on a read-only mount", _read_only_mount),
    Row("X07", "the disk fills in mid-bake", _full_disk),
    Row("X09", "kill -9 in mid-bake, then again", _kill),
    Row("X11", "the folder is locked by another bake", _locked),
    Row("X13", "a model replaced while it is baked", _replaced_model),
    Row("X16", "one bad animal of 30 with --keep-going", _keep_going),
    Row("X16b", "models missing with --keep-going", _keep_going_without_models),
    Row("X19", "a folder or pipe has the name of an output", _name_in_the_way),
    Row("X20", "SIGINT and SIGTERM in mid-bake", _interrupted),
    Row("X20b", "SIGINT while waiting for the lock", _interrupted_while_waiting),
    Row("X21", "the limit of file sizes", _file_size_limit),
    Row("X22", "stdout is a pipe that nobody reads", _closed_pipe),
    Row("X17", "of several failures the first id's is told", _first_failure),
    Row("X18", "a failed bake leaves the old outputs", _failure_keeps_the_old),
]
