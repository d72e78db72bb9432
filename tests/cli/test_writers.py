#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whoever writes a file writes the whole new one or leaves the old one: ended by SIGKILL, failed by the kernel, or together with other writers.

usage: test_writers.py TOUCHSTONE [--kills 30] [--seed N] [--all-tables]

Half of the kills are at a random moment, half at a random call of the kernel, where strace can be used; errors (no space, quota, read-only, ...) are
put on each call that writes, and each has to be named. The seed is printed.
"""
import argparse
import contextlib
import errno
import hashlib
import json
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

arguments = argparse.ArgumentParser()
arguments.add_argument("program", type=lambda p: pathlib.Path(p).resolve())
arguments.add_argument("--kills", type=int, default=30)
arguments.add_argument("--seed", type=int, default=20261123)
arguments.add_argument("--all-tables", action="store_true")
options, sys.argv[1:] = arguments.parse_known_args()
PROGRAM = options.program
ERRORS = {name: os.strerror(getattr(errno, name)) for name in ("ENOSPC", "EDQUOT", "EROFS", "EIO", "EACCES")}
LEFTOVER = re.compile(r"\.tmp\d|\.part2?(\.whole)?$")  # what a killed writer leaves beside the file
LONGEST = 300
MOST_CALLS = 12  # of one kind in one writer, errors are put on


def run(*words, **more):
    return subprocess.run([*map(str, words)], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=LONGEST, **more)


def can_trace():
    return shutil.which("strace") is not None and run("strace", "-qq", "-e", "inject=write:error=EIO:when=1", "true").returncode == 0


class Writer:
    """A command that replaces files in a folder: `prepare` makes the old ones, `command` the new."""

    def __init__(self, name, prepare, command):
        self.name, self.prepare, self.command = name, prepare, command


def shares(folder):
    for i in (1, 2):
        run(PROGRAM, "table", "archard_delta", "--shard", f"{i}/2", "--out", folder)
    (folder / "archard_delta.txt").write_text("old\n")


def rows(folder):
    (folder / "rows").write_text("# load\n" + "".join(f"{k}/400\n" for k in range(1, 401)))
    run(PROGRAM, "eval", "westergaard.half_width", "--rows", folder / "rows", "--digits", "5", "--out", folder / "table.txt")


def baseline(folder):
    (folder / "answers").write_text("1\n" * 1000)
    (folder / "code.sh").write_text("while read -r line; do echo 1; done\n")
    run(PROGRAM, "judge", "archard_delta", "--held-out", "0", "--baseline", folder / "b.json", "--update-baseline", "--", "sh", folder / "code.sh")
    (folder / "code.sh").write_text("while read -r line; do echo 2; done\n")


WRITERS = [
    Writer("table", lambda folder: run(PROGRAM, "table", "archard_delta", "--digits", "20", "--out", folder), lambda folder: ("table", "archard_delta", "--digits", "30", "--out", folder)),
    Writer("shard", lambda folder: None, lambda folder: ("table", "archard_delta", "--shard", "1/2", "--out", folder)),
    Writer("merge", shares, lambda folder: ("merge", folder)),
    Writer("rows", rows, lambda folder: ("eval", "westergaard.half_width", "--rows", folder / "rows", "--digits", "9", "--out", folder / "table.txt", "--jobs", "1")),
    Writer("baseline", baseline, lambda folder: ("judge", "archard_delta", "--held-out", "0", "--baseline", folder / "b.json", "--update-baseline", "--", "sh", folder / "code.sh")),
]


def contents(folder):
    return {p.name: p.read_bytes() for p in folder.iterdir()}


class Writers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.root = pathlib.Path(cls.scratch.name)
        cls.random = random.Random(options.seed)
        print(f"seed {options.seed}, {options.kills} kills", flush=True)
        cls.here, cls.before, cls.after, cls.usual = cls.root / "here", {}, {}, {}
        cls.rows = next(w for w in WRITERS if w.name == "rows")
        for w in WRITERS:
            cls.here.mkdir()
            w.prepare(cls.here)
            shutil.copytree(cls.here, cls.root / w.name)
            cls.before[w.name] = contents(cls.here)
            started = time.monotonic()
            cls.written = run(PROGRAM, *w.command(cls.here))
            cls.usual[w.name] = time.monotonic() - started
            cls.after[w.name] = contents(cls.here)
            changed = [f for f, text in cls.after[w.name].items() if cls.before[w.name].get(f) != text]
            if not changed:
                raise AssertionError(f"{w.name} writes nothing: {cls.written.stderr}")
            shutil.rmtree(cls.here)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    @contextlib.contextmanager
    def old_state(self, w):
        shutil.copytree(self.root / w.name, self.here)
        try:
            yield
        finally:
            shutil.rmtree(self.here)

    def old_or_new(self, w, how):
        """Which of them: 'old', 'new', or 'both' where some files are old and others new."""
        now, seen = contents(self.here), set()
        for name, text in now.items():
            if LEFTOVER.search(name):
                continue
            kinds = {kind for kind, state in (("old", self.before), ("new", self.after)) if state[w.name].get(name) == text}
            self.assertTrue(kinds, f"{w.name}, {how}: {name} is neither the old file nor the new: {text[-200:]}")
            if len(kinds) == 1:
                seen |= kinds
        for name in self.before[w.name]:
            self.assertIn(name, now, f"{w.name}, {how}: the old file is gone")
        return "both" if len(seen) == 2 else "".join(seen) or "old"

    def traced(self, w, *inject):
        return run("strace", "-f", "-qq", "-o", "/dev/null", *(word for i in inject for word in ("-e", i)), PROGRAM, *w.command(self.here))

    def calls(self, w, names):
        """How many calls of the kernel a run makes."""
        with self.old_state(w):
            log = self.root / "calls"
            run("strace", "-f", "-qq", "-o", log, "-e", f"trace={names}", PROGRAM, *w.command(self.here))
            return len(log.read_text().splitlines())

    def test_killed(self):
        states = {"old": 0, "new": 0, "both": 0}
        tracing = can_trace()
        names = "openat,write,close,rename,unlink,fchmod,lseek"
        calls = {w.name: self.calls(w, names) for w in WRITERS} if tracing else {}
        for k in range(options.kills):
            w = self.random.choice(WRITERS)
            with self.old_state(w):
                if tracing and k % 2:
                    # strace counts each name apart: among the first calls of some are the loader's, which is no matter
                    name, at = self.random.choice(names.split(",")), self.random.randint(1, max(2, calls[w.name] // 3))
                    how = f"killed at call {at} of {name}"
                    self.traced(w, f"trace={name}", f"inject={name}:signal=KILL:when={at}")
                else:
                    moment = self.random.uniform(0, self.usual[w.name])
                    how = f"killed after {moment:.4f} s"
                    child = subprocess.Popen([PROGRAM, *w.command(self.here)], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                    time.sleep(moment)
                    child.send_signal(signal.SIGKILL)
                    child.wait()
                states[self.old_or_new(w, how)] += 1
                again = run(PROGRAM, *w.command(self.here))  # what was left behind is in nobody's way
                self.assertLessEqual({name: text for name, text in contents(self.here).items() if not LEFTOVER.search(name)}.items(), self.after[w.name].items(), (w.name, how, again.stderr))
                self.assertEqual(self.old_or_new(w, how), "new")
        print(f"killed: {states}", flush=True)

    @unittest.skipIf(b"__asan_init" in PROGRAM.read_bytes(), "AddressSanitizer ends by a call of its own that fails")
    @unittest.skipUnless(can_trace(), "strace is missing or may not trace")
    def test_errors_are_named(self):
        failed = 0
        for w in WRITERS:
            for name in ("write", "rename", "close"):
                calls = self.calls(w, name)
                for at in sorted(self.random.sample(range(1, 1 + calls), min(calls, MOST_CALLS))):
                    error, text = self.random.choice(list(ERRORS.items()))
                    with self.old_state(w):
                        r = self.traced(w, f"trace={name}", f"inject={name}:error={error}:when={at}")
                        how = f"{error} at call {at} of {name}: {r.returncode} {r.stderr}"
                        state = self.old_or_new(w, how)
                        self.assertNotIn("internal error", r.stderr, (w.name, how))
                        self.assertFalse(any(LEFTOVER.search(p.name) for p in self.here.iterdir()) and r.returncode == 0, (w.name, how))
                        if r.returncode == 73:
                            failed += 1
                            self.assertIn(text, r.stderr.splitlines()[-1], (w.name, how))
                        elif r.returncode == 0:  # closing what was read, say, is nobody's loss
                            self.assertEqual(state, "new", (w.name, how))
                        else:  # what a judged code is not told, say, is its fault; and the complaint itself may be what cannot be written
                            self.assertGreater(r.returncode, 0, (w.name, how))
        print(f"{failed} errors named", flush=True)
        self.assertGreater(failed, 10)

    def test_what_a_dead_writer_of_the_same_number_left(self):
        """In a container every run has the same process number: a temporary file that is there is another's."""
        with self.old_state(WRITERS[0]):
            script = 'for k in 0 1 2; do : > "$1/archard_delta.txt.tmp$$-$k"; done; : > "$1/archard_delta.txt.tmp$$"; d=$1; shift; exec "$@"'
            r = run("sh", "-c", script, "sh", self.here, PROGRAM, *WRITERS[0].command(self.here))
            self.assertEqual(r.returncode, 0, r.stderr)
            self.assertEqual(self.old_or_new(WRITERS[0], ""), "new")
            self.assertEqual(len([p for p in self.here.iterdir() if LEFTOVER.search(p.name)]), 4)

    def test_several_at_once(self):
        """Eight at a time, each with other digits: one of their tables is there in the end, and a manifest that reads."""
        with tempfile.TemporaryDirectory() as folder:
            whole = set()
            for digits in range(10, 18):
                run(PROGRAM, "table", "archard_delta", "--digits", digits, "--out", f"{folder}/{digits}")
                whole.add(pathlib.Path(f"{folder}/{digits}/archard_delta.txt").read_bytes())
            self.assertEqual(len(whole), 8)
            together = pathlib.Path(folder) / "together"
            for _ in range(3):
                children = [subprocess.Popen([PROGRAM, "table", "archard_delta", "--digits", str(digits), "--out", together], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
                            for digits in range(10, 18)]
                self.assertEqual([c.wait(LONGEST) for c in children], [0] * 8)
                self.assertIn((together / "archard_delta.txt").read_bytes(), whole)
                self.assertEqual([p.name for p in together.iterdir()], ["archard_delta.txt"])

    def test_the_manifest_of_several_at_once(self):
        """Four own tables made at the same time in one folder, two of them under one name: the manifest is of what is there."""
        with tempfile.TemporaryDirectory() as folder:
            here = pathlib.Path(folder)
            for i, (name, digits) in enumerate((("a", 5), ("b", 5), ("c", 5), ("c", 9))):
                (here / f"{i}.json").write_text(json.dumps({"name": name, "quantity": "westergaard.half_width", "digits": digits, "inputs": {"load": "1/10:1/2:1/10"}}))
            for k in range(20):
                out = here / f"out{k}"
                children = [subprocess.Popen([PROGRAM, "table", here / f"{i}.json", "--out", out], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL) for i in range(4)]
                self.assertEqual([c.wait(LONGEST) for c in children], [0] * 4)
                entries = json.loads((out / "manifest.txt.json").read_text())["tables"]
                self.assertEqual({e["file"]: e["sha256"] for e in entries},
                                 {p.name: hashlib.sha256(p.read_bytes()).hexdigest() for p in out.glob("*.txt")}, k)
                self.assertEqual(len(entries), 3)

    @unittest.skipUnless(options.all_tables, "takes minutes: --all-tables")
    def test_all_tables_beside_another(self):
        """A table of one's own is made while all others are, and one of the others with other digits: the manifest is of what is there."""
        with tempfile.TemporaryDirectory() as folder:
            here, own = pathlib.Path(folder) / "out", pathlib.Path(folder) / "own.json"
            own.write_text(json.dumps({"name": "own", "quantity": "westergaard.half_width", "digits": 5, "inputs": {"load": "1/10:1/2:1/10"}}))
            everything = subprocess.Popen([PROGRAM, "table", "all", "--digits", "2", "--out", here], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
            while not (here / "hertz_gap.txt").exists():
                self.assertIsNone(everything.poll())
                time.sleep(0.1)
            self.assertEqual(run(PROGRAM, "table", own, "--out", here).returncode, 0)
            self.assertEqual(run(PROGRAM, "table", "hertz_gap", "--digits", "3", "--out", here).returncode, 0)
            self.assertEqual(everything.wait(7000), 0)
            entries = json.loads((here / "manifest.txt.json").read_text())["tables"]
            self.assertEqual({e["file"]: e["sha256"] for e in entries}, {p.name: hashlib.sha256(p.read_bytes()).hexdigest() for p in here.glob("*.txt")})
            self.assertEqual({e["file"]: e["digits"] for e in entries}["hertz_gap.txt"], 3)

    def test_what_cannot_be_replaced_outlives_a_full_disk(self):
        """A file that may be written in a folder that may not: the disk is full before anything of the old one is lost."""
        with tempfile.TemporaryDirectory() as folder:
            file, old, short = f"{folder}/view/c.txt", f"{folder}/old", f"{folder}/short"
            certificate = f"{PROGRAM} certificate contact.area load=1/10 G=16 n="
            script = f"""set -e; cd {folder}; mkdir disk view; mount -t tmpfs -o size=4k none disk
                {certificate}2 --digits 2 --out disk/c.txt; cp disk/c.txt {old}; {certificate}1 --digits 2 --out {short}
                mount --bind disk view; mount -o remount,bind,ro view; mount --bind disk/c.txt {file}; set +e
                {certificate}1 --digits 20 --out {file}; echo $?; cmp {file} {old} && echo same
                {certificate}1 --digits 2 --out {file}; echo $?; cmp {file} {short} && echo shorter"""
            r = run("unshare", "--mount", "--map-root-user", "sh", "-c", script)
            if "unshare: " in r.stderr or "mount: " in r.stderr:
                self.skipTest("no mounts of one's own here: " + r.stderr.strip())
            self.assertEqual(r.stdout.split(), ["73", "same", "0", "shorter"], r.stderr)
            self.assertIn("No space left on device", r.stderr)

    def test_links_and_pipes_in_a_folder(self):
        """Who names a folder has not named what a link in it leads to; another name of a file keeps what it had; no pipe is waited for."""
        with tempfile.TemporaryDirectory() as folder:
            here, victim = pathlib.Path(folder) / "out", pathlib.Path(folder) / "victim"
            here.mkdir()
            share = run(PROGRAM, "table", "archard_delta", "--shard", "1/2", "--out", pathlib.Path(folder) / "shares")
            self.assertEqual(share.returncode, 0)
            name = next((pathlib.Path(folder) / "shares").iterdir()).name
            for words, file in ((["table", "archard_delta"], "archard_delta.txt"), (["table", "archard_delta", "--shard", "1/2"], name)):
                victim.write_text("theirs")
                (here / file).symlink_to(victim)
                r = run(PROGRAM, *words, "--out", here)
                self.assertEqual((r.returncode, victim.read_text()), (73, "theirs"))
                self.assertIn("leads out of the folder", r.stderr)
                (here / file).unlink()
                os.mkfifo(here / file)
                r = run(PROGRAM, *words, "--out", here)
                self.assertEqual(r.returncode, 73)
                self.assertIn("no plain file", r.stderr)
                (here / file).unlink()
                os.link(victim, here / file)
                self.assertEqual(run(PROGRAM, *words, "--out", here).returncode, 0)
                self.assertEqual(victim.read_text(), "theirs")
                self.assertNotEqual((here / file).read_text(), "theirs")

    def test_links_and_pipes_beside_a_table_of_rows(self):
        """Somebody else may write in the folder too: what grows beside FILE goes through no link of theirs, and into no pipe."""
        with self.old_state(self.rows):
            table, others = self.here / "table.txt", self.here / "others"
            words = ("eval", "westergaard.half_width", "--digits", "9", "--jobs", "1", "--out", table, "--rows", self.here / "rows")
            others.write_text("theirs\n")
            for end in (".part.whole", ".part2", ".part2.whole"):
                (self.here / ("table.txt" + end)).symlink_to(others)
            self.assertEqual(run(PROGRAM, *words).returncode, 0)
            self.assertEqual(table.read_bytes(), self.after["rows"]["table.txt"])
            part = self.here / "table.txt.part"  # a table cut off is taken up again: it grows in the second file then
            table.rename(part)
            (self.here / "table.txt.part2").unlink(missing_ok=True)
            (self.here / "table.txt.part2").symlink_to(others)
            self.assertEqual(run(PROGRAM, *words, "--resume").returncode, 0)
            self.assertEqual(table.read_bytes(), self.after["rows"]["table.txt"])
            self.assertEqual(others.read_text(), "theirs\n")
            part.symlink_to(others)
            self.assertEqual(run(PROGRAM, *words).returncode, 73)
            part.unlink()
            os.mkfifo(part)
            self.assertIn("is no plain file", run(PROGRAM, *words).stderr)
            self.assertEqual(others.read_text(), "theirs\n")

    def test_two_tables_of_rows_are_not_mixed(self):
        """A table that grows in FILE.part has one writer: the second is refused while the first is at it, and may when it is done."""
        with self.old_state(self.rows):
            pipe, table = self.here / "pipe", self.here / "table.txt"
            os.mkfifo(pipe)
            words = ("eval", "westergaard.half_width", "--digits", "9", "--jobs", "1", "--out", table)
            first = subprocess.Popen([PROGRAM, *words, "--rows", pipe], stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            with open(pipe, "w") as feed:
                feed.write("# load\n1/4\n")
                feed.flush()
                while not (self.here / "table.txt.part").exists():
                    self.assertIsNone(first.poll())
                    time.sleep(0.02)
                second = run(PROGRAM, *words, "--rows", self.here / "rows")
                self.assertEqual((second.returncode, second.stderr), (73, f"touchstone: cannot write {table}.part: another run is writing it\n"))
                feed.write("1/2\n")
            self.assertEqual(first.wait(LONGEST), 0, first.stderr.read())
            first.stderr.close()
            self.assertIn('"rows":2,', table.read_text())
            self.assertEqual(run(PROGRAM, *words, "--rows", self.here / "rows").returncode, 0)
            self.assertEqual(table.read_bytes(), self.after["rows"]["table.txt"])
            self.assertEqual([p for p in self.here.iterdir() if LEFTOVER.search(p.name)], [])


if __name__ == "__main__":
    unittest.main(verbosity=1)
