# SPDX-License-Identifier: MIT
"""Runs the program in a folder of its own and looks at all it leaves behind: exit code, streams, files and
memory.

A row is a name, a title and a function that takes a Case. Every run is watched: it must end by itself, and
touch nothing outside the paths it was given.
"""

import contextlib
import ctypes
import hashlib
import json
import os
import re
import shutil
import subprocess
import threading

LIMIT_S = 2.0  # of processor time: a busy machine stretches the clock, not the work
KILL_AFTER_S = 30.0
LIMIT_MIB = 128.0
LOCK_NAME, MANIFEST_NAME, TEMPORARY_PREFIX = ".posepack.lock", "manifest.json", ".posepack-tmp-"
IN_OPEN = 0x20


class Row:
    def __init__(self, name, title, run):
        self.name, self.title, self.run = name, title, run


class Skip(Exception):
    """Why a row cannot be run on this machine."""


class Result:
    """What one run of the program did. A negative exit code is a signal."""

    def __init__(self, status, usage, wall_s, stdout, stderr):
        self.exit_code = os.waitstatus_to_exitcode(status)
        self.cpu_s = usage.ru_utime + usage.ru_stime
        self.peak_mib = usage.ru_maxrss / 1024
        self.wall_s = wall_s
        self.stdout_bytes, self.stderr_bytes = stdout, stderr
        self.stdout = stdout.decode("utf-8", "replace")
        self.stderr = stderr.decode("utf-8", "replace")

    def lines(self, severity):
        """Lines of stderr of that severity, "error" or "warning"."""
        return [line for line in self.stderr.splitlines() if line.startswith(f"posepack: {severity}[")]

    def json(self):
        return json.loads(self.stdout)


def digest(data):
    return hashlib.sha256(data).hexdigest()


def read_bytes(path):
    with open(path, "rb") as file:
        return file.read()


def snapshot(folder, ignored=()):
    """Everything below a folder: path -> what it is. `ignored` paths are left out, with all below them."""
    found = {}
    for parent, folders, files in os.walk(folder):
        here = os.path.relpath(parent, folder)
        folders[:] = [name for name in folders if os.path.normpath(os.path.join(here, name)) not in ignored]
        for name in folders + files:
            path = os.path.join(parent, name)
            relative = os.path.normpath(os.path.join(here, name))
            if relative in ignored:
                continue
            if os.path.islink(path):
                found[relative] = "link to " + os.readlink(path)
            else:
                found[relative] = digest(read_bytes(path)) if os.path.isfile(path) else "folder"
    return found


class OpenWatch:
    """Counts how often files are opened by anybody (inotify), as a with-block."""

    def __init__(self, *paths):
        self.paths = paths

    def __enter__(self):
        libc = ctypes.CDLL(None, use_errno=True)
        try:
            self.descriptor = libc.inotify_init1(os.O_NONBLOCK | os.O_CLOEXEC)
        except AttributeError:
            raise Skip("this system has no inotify") from None
        for path in self.paths:
            if self.descriptor < 0 or libc.inotify_add_watch(self.descriptor, os.fsencode(path), IN_OPEN) < 0:
                raise Skip("inotify does not work here: " + os.strerror(ctypes.get_errno()))
        return self

    def was_opened(self):
        try:
            return bool(os.read(self.descriptor, 4096))
        except BlockingIOError:
            return False

    def __exit__(self, *_):
        os.close(self.descriptor)


class Case:
    """One row at work: a scratch folder, runs of the program in it, and the faults found."""

    def __init__(self, settings, folder):
        self.settings = settings
        self.folder = folder
        self.faults = []
        self.notes = []
        for name in ("models", "home", "tmp"):
            os.makedirs(os.path.join(folder, name))

    # Files

    def path(self, *parts):
        return os.path.join(self.folder, *parts)

    def write(self, name, data):
        path = self.path(name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as file:
            file.write(data if isinstance(data, bytes) else data.encode())
        return path

    def write_catalog(self, animals, name="models/catalog.json", **fields):
        return self.write(name, json.dumps({"schema": 1, "animals": animals, **fields}))

    def write_animal(self, glb, **fields):
        """A catalog of one animal "deer" with that model."""
        self.write("models/deer.glb", glb)
        return self.write_catalog({"deer": {"model": "deer.glb", **fields}})

    def output(self, folder="out"):
        """Names of a folder's files, without the lock; empty where there is no folder."""
        path = self.path(folder)
        return sorted(set(os.listdir(path)) - {LOCK_NAME}) if os.path.isdir(path) else []

    def output_bytes(self, folder="out"):
        return {name: read_bytes(self.path(folder, name)) for name in self.output(folder)}

    def manifest(self, folder="out"):
        return json.loads(read_bytes(self.path(folder, MANIFEST_NAME)))

    # Runs

    def command(self, *arguments):
        return [self.settings.binary, *map(str, arguments)]

    def environment(self, extra=None):
        kept = {key: value for key, value in os.environ.items() if not key.startswith(("LC_", "LANG", "TZ"))}
        return {**kept, "HOME": self.path("home"), "TMPDIR": self.path("tmp"), **(extra or {})}

    def start(self, *arguments, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=None, env=None,
              **options):
        """Starts the program and does not wait for it."""
        return subprocess.Popen(self.command(*arguments), stdin=subprocess.DEVNULL, stdout=stdout,
                                stderr=stderr,
                                cwd=cwd or self.folder, env=self.environment(env), **options)

    def run(self, *arguments, writes=("out",), watched=True, **options):
        """Runs the program to its end. Anything changed in the scratch folder but `writes` is a fault."""
        before = snapshot(self.folder, writes) if watched else None
        result = self._wait(*arguments, **options)
        shown = "posepack " + " ".join(map(str, arguments))
        if watched:
            after = snapshot(self.folder, writes)
            changed = sorted(path for path in before.keys() | after.keys()
                             if before.get(path) != after.get(path))
            self.check(not changed, f"{shown}: expected no change outside {list(writes)}, found {changed}")
        self.check(result.exit_code >= 0,
                   f"{shown}: ended by signal {-result.exit_code}: {result.stderr[-300:]}")
        return result

    def _wait(self, *arguments, **options):
        out, err = (open(self.settings.scratch + name, "w+b") for name in ("/stdout", "/stderr"))
        with out, err:
            start = os.times().elapsed
            process = self.start(*arguments, stdout=out, stderr=err, **options)
            timer = threading.Timer(KILL_AFTER_S, process.kill)
            timer.start()
            _, status, usage = os.wait4(process.pid, 0)
            timer.cancel()
            process.returncode = os.waitstatus_to_exitcode(status)
            wall_s = os.times().elapsed - start
            for file in (out, err):
                file.seek(0)
            return Result(status, usage, wall_s, out.read(), err.read())

    def bake(self, catalog, *options, output="out", fsync=False, measure=False, **keywords):
        """Bakes quickly: without fsync and measurement unless they are asked for."""
        quick = ([] if fsync else ["--no-fsync"]) + ([] if measure else ["--no-measure"])
        keywords.setdefault("writes", (os.path.relpath(self.path(output), self.folder),))
        result = self.run("bake", catalog, "-o", output, *quick, *options, **keywords)
        if result.exit_code == 0:
            self.check(MANIFEST_NAME in self.output(output), f"exit code 0, but {output} holds no manifest")
        return result

    def inspect(self, container, *options):
        """What `inspect` says of a container, as JSON."""
        result = self.run("inspect", container, "--format", "json", *options)
        self.equal(result.exit_code, 0, "exit code of inspect")
        return result.json()

    def matrix(self, container, row, bone):
        """One bone-row as twelve numbers, row by row."""
        rows = self.inspect(container, "--row", row, "--bone", bone)["matrix"]
        return [number for matrix_row in rows for number in matrix_row]

    # Checks

    def check(self, is_right, fault):
        if not is_right:
            self.faults.append(fault)
        return is_right

    def equal(self, found, expected, what):
        return self.check(found == expected, f"{what}: expected {_cut(expected)}, found {_cut(found)}")

    def contains(self, text, part, what):
        return self.check(part in text, f"{what}: expected {part!r} in it, found {_cut(text)}")

    def expect_bounded(self, result, what):
        if self.settings.sanitized:
            return
        self.check(result.cpu_s < LIMIT_S,
                   f"{what}: expected under {LIMIT_S} s of work, found {result.cpu_s:.2f} s")
        self.check(result.peak_mib < LIMIT_MIB,
                   f"{what}: expected a peak under {LIMIT_MIB:.0f} MiB, found {result.peak_mib:.0f} MiB")

    def expect_ok(self, result, warnings=()):
        """Exit 0, no error on stderr, and exactly these warnings (ids, sorted)."""
        self.equal(result.exit_code, 0, f"exit code (stderr {_cut(result.stderr)})")
        self.equal(result.lines("error"), [], "errors of a good run")
        ids = sorted(re.match(r"posepack: warning\[([^]]*)\]", line).group(1)
                     for line in result.lines("warning"))
        self.equal(ids, sorted(warnings), "warnings")
        self.equal(len(result.stderr.splitlines()), len(ids), "lines on stderr")
        self.expect_bounded(result, "run")
        return result.exit_code == 0

    def expect_refused(self, result, exit_code, issue, mentions=()):
        """The exit code, and one clean line on stderr with the id, what to try, and the `mentions`."""
        self.equal(result.exit_code, exit_code, f"exit code (stderr {_cut(result.stderr)})")
        lines = result.stderr.split("\n")
        self.check(len(lines) == 2 and lines[1] == "",
                   f"stderr: expected one line, found {_cut(result.stderr)}")
        self.check(lines[0].startswith(f"posepack: error[{issue}]: "),
                   f"stderr: expected error[{issue}], found {_cut(lines[0])}")
        for part in ("expected ", "found", "; try: "):
            self.contains(lines[0], part, "stderr")
        self.check(not re.search(rb"[\x00-\x09\x0b-\x1f\x7f]", result.stderr_bytes),
                   "stderr holds control characters")
        for mention in mentions:
            self.contains(lines[0], mention, "stderr")
        self.equal(result.stdout, "", "stdout of a refusal")
        self.expect_bounded(result, "refusal")

    def expect_bake_refused(self, catalog, exit_code, issue, *options, mentions=(), **keywords):
        """Bakes, and expects a refusal that leaves the output folder without any file."""
        result = self.bake(catalog, *options, **keywords)
        self.expect_refused(result, exit_code, issue, mentions)
        self.equal(self.output(keywords.get("output", "out")), [], "files published by a refused bake")
        return result


def _cut(value, limit=400):
    text = value if isinstance(value, str) else repr(value)
    return text if len(text) <= limit else text[:limit] + f"... ({len(text)} characters)"


@contextlib.contextmanager
def mounted(arguments, target):
    """A mount for the length of a with-block; skips the row where this user or system may not mount."""
    if shutil.which("mount") is None or os.geteuid() != 0:
        raise Skip("mounting needs root and mount(8)")
    done = subprocess.run(["mount", *arguments, target], capture_output=True, check=False)
    if done.returncode != 0:
        raise Skip("mount: " + done.stderr.decode("utf-8", "replace").strip())
    try:
        yield
    finally:
        subprocess.run(["umount", target], check=True)
