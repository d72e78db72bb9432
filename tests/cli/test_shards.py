#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables made in shares: byte for byte the table, whatever is missing, cut off, doubled or strange is refused and named.

usage: test_shards.py TOUCHSTONE SOURCE
"""
import hashlib
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM, SOURCE = pathlib.Path(sys.argv.pop(1)).resolve(), pathlib.Path(sys.argv.pop(1)).resolve()
STORED = SOURCE / "data/reference"


def run(*words, cwd=None, env=None):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=300, cwd=cwd, env=env)


class Shards(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.scratch.name)
        self.shares = self.folder / "shares"

    def tearDown(self):
        self.scratch.cleanup()

    def make(self, table, count, indices=None):
        for i in indices or range(1, count + 1):
            r = run("table", table, "--shard", f"{i}/{count}", "--out", self.shares)
            self.assertEqual(r.returncode, 0, r.stderr)

    def file(self, table, i, count):
        return self.shares / f"{table}.shard-{i:0{len(str(count))}}-of-{count}.txt"

    def merged(self, code=0):
        r = run("merge", self.shares)
        self.assertEqual(r.returncode, code, (r.stdout, r.stderr))
        self.assertLessEqual(r.stderr.count("\n"), 1)
        return r

    def test_the_committed_table_byte_for_byte(self):
        for table, count in (("archard_alpha", 7), ("archard_K_inf", 3), ("hertz_pressure", 10)):
            self.make(table, count)
            self.merged()
            self.assertEqual((self.shares / f"{table}.txt").read_bytes(), (STORED / f"{table}.txt").read_bytes(), table)
        self.assertIn("hertz_pressure.txt", (self.shares / "manifest.txt.json").read_text())

    def test_rows_of_one_surface_stay_together(self):
        self.make("archard_area", 5)
        homes = {}
        for i in range(1, 6):
            for line in self.file("archard_area", i, 5).read_text().splitlines():
                if not line.startswith("#"):
                    homes.setdefault(line.split()[3], set()).add(i)
        self.assertGreater(len(homes), 1)
        self.assertTrue(all(len(home) == 1 for home in homes.values()), homes)
        self.assertGreater(len(set.union(*homes.values())), 1)

    def test_what_is_missing_is_an_array(self):
        self.make("archard_delta", 9, (1, 2, 4, 5, 6))
        r = self.merged(1)
        self.assertEqual(r.stdout, "--array=3,7-9\n")
        self.assertIn("--array=3,7-9", r.stderr)
        self.assertFalse((self.shares / "archard_delta.txt").exists())
        self.make("archard_delta", 9, (3, 7, 8, 9))
        self.merged()

    def test_what_is_there_is_kept(self):
        self.make("archard_delta", 3, (2,))
        file = self.file("archard_delta", 2, 3)
        before = file.stat()
        r = run("table", "archard_delta", "--shard", "2/3", "--out", self.shares)
        self.assertIn("is there already", r.stdout)
        self.assertEqual((file.stat().st_ino, file.stat().st_mtime_ns), (before.st_ino, before.st_mtime_ns))
        good = file.read_text()
        for bad in (good[:-30], good.replace("0.", "1.", 1), "", good.replace('"version":"', '"version":"9')):
            file.write_text(bad)
            self.assertEqual(run("table", "archard_delta", "--shard", "2/3", "--out", self.shares).returncode, 0)
            self.assertEqual(file.read_text(), good)

    def test_cut_off_changed_doubled_strange(self):
        self.make("archard_delta", 4)
        third = self.file("archard_delta", 3, 4)
        good = third.read_text()
        rows = good.splitlines(keepends=True)
        for bad, reason in ((good[: len(good) // 2], "cut off"), ("", "no shard"), (good[:-1] + " \n", "cut off or changed"), ("".join(rows[:-1]), "cut off or changed"),
                            (good.replace('"shard":3', '"shard":2'), "changed")):
            self.assertNotEqual(bad, good)
            third.write_text(bad)
            r = self.merged(65)
            self.assertIn(reason, r.stderr)
            self.assertEqual(r.stdout, "--array=3\n", bad[:80])
        third.write_text(good)
        shutil.copy(third, self.shares / "again.txt")
        self.assertIn("and so is", self.merged(65).stderr)
        (self.shares / "again.txt").unlink()
        run("table", "archard_delta", "--shard", "1/5", "--out", self.shares)
        self.assertIn("another number of shares (5)", self.merged(65).stderr)
        self.file("archard_delta", 1, 5).unlink()
        run("table", "archard_delta", "--digits", "30", "--shard", "3/4", "--out", self.shares)
        self.assertIn("another table", self.merged(65).stderr)
        self.assertEqual(run("table", "archard_delta", "--shard", "3/4", "--out", self.shares).returncode, 0)
        (self.shares / "slurm-17.out").write_text("not a shard\n")
        self.merged()

    def test_another_version(self):
        """A sealed shard whose head names another version: as an older program would have left it."""
        self.make("archard_delta", 2)
        file = self.file("archard_delta", 1, 2)
        first, head, rows = file.read_text().split("\n", 2)
        sealed = re.sub(r',"sha256":"[0-9a-f]+"}$', "}", head[2:])
        self.assertEqual(hashlib.sha256(f"{sealed}\n{rows}".encode()).hexdigest(), head[-66:-2])
        other = re.sub(r'"version":"[^"]+"', '"version":"0.0.1"', sealed)
        file.write_text(f"{first}\n# {other[:-1]},\"sha256\":\"{hashlib.sha256(f'{other}{chr(10)}{rows}'.encode()).hexdigest()}\"}}\n{rows}")
        self.assertIn("made by version 0.0.1", self.merged(65).stderr)

    def sealed(self, name, rows, kind="table", about=None, **changes):
        """A share that nobody made, sealed as a forger would."""
        about = about or {"quantity": "archard.K", "inputs": ["n"], "digits": 3, "forced": False}
        said = json.dumps(about, separators=(",", ":"), ensure_ascii=False)
        spec = hashlib.sha256((said + "1\n" if kind == "rows" else f"{name}{said}0 ").encode()).hexdigest()  # of a table with the one row n = 1 or n = 0
        head = {"name": name, "kind": kind, "shard": 1, "of": 1, "rows": len(rows), "total": len(rows), "version": run("--version").stdout.split()[1], "spec": spec, "about": about, **changes}
        text, body = json.dumps(head, separators=(",", ":"), ensure_ascii=False), "".join(f"{row}\n" for row in rows)
        seal = hashlib.sha256(f"{text}\n{body}".encode()).hexdigest()
        self.shares.mkdir(exist_ok=True)
        (self.shares / "share.txt").write_text(f'# Touchstone shard 1 of 1\n# {text[:-1]},"sha256":"{seal}"}}\n{body}')

    def test_hostile_shares(self):
        """A seal says that a share is whole, not that it means well: nothing is written elsewhere, no promise takes memory, no row is believed."""
        right = '1 0 0.637 5e-4 # {"status":"certified","routes":["a"]}'
        own = self.folder / "rows.txt"
        own.write_text("# n\n1\n")
        run("eval", "archard.K", "--rows", own, "--digits", "5", "--shard", "1/1", "--out", self.folder / "own")
        of_rows = json.loads(next((self.folder / "own").iterdir()).read_text().splitlines()[1][2:])["about"]
        own.unlink()
        shutil.rmtree(self.folder / "own")
        self.sealed("good", [right])
        self.merged()
        (self.shares / "good.txt").unlink()
        (self.shares / "manifest.txt.json").unlink()
        for kind, about, row in (("table", None, right), ("rows", of_rows, "1 1 0.50095 5e-06 # certified")):
            for name in ("../escaped", str(self.folder / "absolute"), "..", "a/b", "a\nb", "a\x1b[2Jb", "", "a.txt"):
                self.sealed(name, [row], kind, about)
                self.assertIn("has a name that is no table's", self.merged(65).stderr)
            for total in (2, 10**6, 10**18):
                self.sealed("t", [row], kind, about, total=total)
                self.assertIn("but not all rows: 1 of", self.merged(65).stderr)
        for kind, about, row in (("table", None, "1 x"), ("table", None, "1 0 zzz 5e-4" + right[14:]), ("table", None, "1 0 0.637 5e-4 # " + "[" * 200_000), ("table", None, "1 1e999 0.637 5e-4" + right[14:]),
                                 ("rows", of_rows, "1 1"), ("rows", of_rows, "1 1 0.50095 5e-06"), ("rows", of_rows, "1 1 0.50095 5e-06 # proven")):
            self.sealed("t", [row], kind, about)
            self.assertNotIn("internal error", self.merged(65).stderr)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["shares"])
        self.assertEqual([p.name for p in self.shares.iterdir()], ["share.txt"])
        victim = self.folder / "victim"
        for kind, about, row in (("table", None, right), ("rows", of_rows, "1 1 0.50095 5e-06 # certified")):
            for link in ("t.txt", "manifest.txt.json"):
                for there in (True, False):
                    self.sealed("t", [row], kind, about)
                    victim.write_text("theirs") if there else victim.unlink()
                    (self.shares / link).symlink_to(victim)
                    self.assertIn("leads out of the folder", self.merged(73).stderr)
                    self.assertEqual(victim.exists() and victim.read_text(), there and "theirs")
                    (self.shares / link).unlink()

    def reseal(self, file, change):
        """The rows changed, and the seal and the number of rows that belong to them: a forger would do that."""
        first, head, rows = file.read_text().split("\n", 2)
        rows = change(rows.splitlines(keepends=True))
        head = re.sub(r'"rows":\d+', f'"rows":{len(rows)}', re.sub(r',"sha256":"[0-9a-f]+"}$', "}", head[2:]))
        seal = hashlib.sha256(f"{head}\n{''.join(rows)}".encode()).hexdigest()
        file.write_text(f'{first}\n# {head[:-1]},"sha256":"{seal}"}}\n{"".join(rows)}')

    def test_forged_rows(self):
        """A share of rows whose seal is right: what cannot be a row of ours, or of this table, is refused, and the share is made anew."""
        grid = self.folder / "grid.txt"
        grid.write_text("# load\n" + "".join(f"{k}/20\n" for k in range(1, 11)))
        words = ("eval", "hertz.half_width", "--rows", grid, "--digits", "8")
        make = lambda i: run(*words, "--shard", f"{i}/2", "--out", self.shares)
        for i in (1, 2):
            self.assertEqual(make(i).returncode, 0)
        first = self.file("hertz_half_width-grid", 1, 2)
        good = first.read_text()
        self.assertEqual(good.splitlines()[2], "1 1/20 0.071176254 5e-10 # certified")
        row = re.compile(r"1 1/20 0\.071176254 5e-10 # certified\n")
        forged = {
            "1 1/20 5e5000 5e-10 # certified": "value that is none of ours", "1 1/20 0.0711762540 5e-11 # certified": "value that is none of ours",
            "1 1/20 0.07117625 5e-09 # certified": "value that is none of ours", "1 1/20 0.071176254 5e-11 # certified": "value that is none of ours",
            "1 1/20 0.071176254 0 # certified": "value that is none of ours",
            "1 1/20 7.1176254e-02 5e-10 # certified": "value that is none of ours", "1 1/20 .071176254 5e-10 # certified": "value that is none of ours",
            "1 1/20 0x1p-3 5e-10 # certified": "value that is none of ours", "1 1/20 nan inf # certified": "value that is none of ours",
            "1 1/20 inf inf # certified": "value that is none of ours", "1 1/20 1e99999999999999999999 5e-10 # certified": "value that is none of ours",
            "1 1/20 0.50 0 # exact": "value that is none of ours", "1 1/20 0.0711763 5e-08 # estimated": "value that is none of ours",
            "1 1/20 1.0 5e-01 # refused: because": "value that is none of ours", "1 1/20 0.071176254 5e-10 # proven": "the status 'proven'",
            "1 1/20 0.071176254 5e-10 # certified: truly": "has more to say", "1 1/20 0.071176254 5e-10 # undecided": "does not say why",
            "1 1/20 0.071176254 5e-10": "no status", "1 0.071176254 5e-10 # certified": "2 columns where 3", "1 1/20 1 0.071176254 5e-10 # certified": "4 columns where 3",
            "1 1/20  0.071176254 5e-10 # certified": "4 columns where 3", "1 1/20 0.071176254\t5e-10 # certified": "control character",
            "1 zebra 0.071176254 5e-10 # certified": "zebra", "1 -1 0.071176254 5e-10 # certified": "a value where there is none",
            "1 1/21 0.071176254 5e-10 # certified": "not those of the table", "2 1/20 0.071176254 5e-10 # certified": "has row 2, and so has",
        }
        for text, reason in forged.items():
            with self.subTest(text):
                first.write_text(good)
                self.reseal(first, lambda rows: [row.sub(lambda _: text + "\n", r) for r in rows])
                self.assertNotEqual(first.read_text(), good)
                r = self.merged(65)
                self.assertIn(reason, r.stderr)
                self.assertFalse((self.shares / "hertz_half_width-grid.txt").exists())
                if "value" in reason or "columns" in reason or "status" in reason:  # what is seen in one share alone
                    self.assertEqual(r.stdout, "--array=1\n")
                    self.assertEqual(make(1).returncode, 0)
                    self.assertEqual(first.read_text(), good)
        first.write_text(good)
        second = self.file("hertz_half_width-grid", 2, 2)
        rows = [line + "\n" for line in good.splitlines()[2:]]
        self.reseal(first, lambda _: rows[1:])
        before = second.read_text()
        self.reseal(second, lambda others: sorted(others + rows[:1], key=lambda r: int(r.split()[0])))
        self.assertIn("row 1 is in share 2", self.merged(65).stderr)
        first.write_text(good)
        second.write_text(before)
        for old, new in (('"digits":8', '"digits":-8'), ('"digits":8', '"digits":20000'), ('"inputs":["load"]', '"inputs":["load","load"]'), ('"kind":"rows"', '"kind":"row"')):
            for file in (first, second):
                file.write_text(file.read_text().replace(old, new))
                self.reseal(file, lambda rows: rows)
            r = self.merged(65)
            self.assertRegex(r.stderr, "another program|which is none")
            first.write_text(good)
            second.write_text(before)
        self.merged()

    def test_forged_inputs_of_a_table(self):
        """Each share says of which table it is, by a hash of all its inputs: rows with others make none, whoever has sealed them."""
        self.make("archard_delta", 2)
        file = self.file("archard_delta", 1, 2)
        number, n, rest = file.read_text().splitlines()[2].split(" ", 2)
        self.reseal(file, lambda rows: [f"{number} {n}.5 {rest}\n", *rows[1:]])
        self.assertIn("the inputs of its rows are not those of the table", self.merged(65).stderr)
        self.assertFalse((self.shares / "archard_delta.txt").exists())

    def test_every_row_that_is_written_is_taken(self):
        """Of each status, rounding and way to print: in shares, merged, and taken up again; what is refused above must not be one of these."""
        cases = (("contact.area", "n=0,1", "load=0,1e-9,0.5,1,2", "G=2.000001,16,1e300", "--digits", "3"), ("contact.area", "n=1,2", "load=0.5", "G=16", "--digits", "30", "--max-precision", "100"),
                 ("segments.count", "n=1,2", "load=0.1,0.9", "D=1.1,3/2", "gamma=2,5", "--digits", "4", "--max-precision", "300"),
                 ("archard.K", "n=0:40:8", "--digits", "1"), ("archard.delta", "n=0:60:10", "--digits", "30"), ("peaks.f", "x=0,1e-30,1/7,1,1e25,3e200", "--digits", "4"),
                 ("peaks.iterate", "n=0:3:1", "load=0,1/3,1,7,1e30", "G=2,1e200", "--digits", "3"), ("hertz.pressure", "x=0,1/2,2", "load=-1,0.1,0.25,1e300", "--digits", "6"),
                 ("westergaard.density", "p=0,1,1000", "load=0.5,1,12", "--digits", "5"), ("weierstrass.bound", "D=1.5,1.01", "gamma=100,3", "--digits", "2"))
        roundings = ((), ("--round", "up"), ("--round", "zero"), ("--binary64",))
        estimated = ("contact.density", "n=2", "p=0.002,0.9", "load=1", "G=2", "--digits")  # a second a value
        seen = set()
        for case, some in (*((case, roundings) for case in cases), ((*estimated, "7"), roundings[:2]), ((*estimated, "17"), roundings[:1])):
            for more in some:
                with self.subTest(case=case, more=more), tempfile.TemporaryDirectory() as scratch:
                    here = pathlib.Path(scratch)
                    whole = run("eval", *case, *more, "--out", here / "whole.txt")
                    self.assertIn(whole.returncode, (0, 2, 65), whole.stderr)
                    for i in (1, 2):
                        self.assertIn(run("eval", *case, *more, "--shard", f"{i}/2", "--out", here / "shares").returncode, (0, 2, 65))
                    r = run("merge", here / "shares")
                    self.assertIn(r.returncode, (0, 2), r.stderr)
                    made = next(p for p in (here / "shares").iterdir() if ".shard-" not in p.name and p.suffix == ".txt")
                    text = (here / "whole.txt").read_text()
                    self.assertEqual(made.read_text(), text)
                    resumed = run("eval", *case, *more, "--out", made, "--resume")
                    self.assertEqual((resumed.returncode, resumed.stderr), (whole.returncode, whole.stderr))
                    self.assertEqual(made.read_text(), text)
                    seen |= set(re.findall(r" # (\w+)", "\n".join(line for line in text.splitlines() if line[0] != "#")))
        self.assertEqual(seen, {"exact", "certified", "estimated", "undecided", "refused"})

    def test_killed_in_the_middle(self):
        """SIGKILL leaves no share, and a share made anew after it is right."""
        child = subprocess.Popen([PROGRAM, "table", "contact_area", "--shard", "1/2", "--jobs", "1", "--out", self.shares], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(0.3)
        child.send_signal(signal.SIGKILL)
        child.wait()
        self.assertEqual(child.returncode, -signal.SIGKILL)  # it was not done
        self.assertFalse(self.shares.exists() and any(self.shares.glob("*.shard-*.txt")))
        self.assertEqual(run("merge", self.shares).returncode, 66)
        self.make("contact_area", 2)
        self.merged()
        self.assertEqual((self.shares / "contact_area.txt").read_bytes(), (STORED / "contact_area.txt").read_bytes())

    def test_own_rows(self):
        rows = self.folder / "grid.txt"
        rows.write_text("# x load\n" + "".join(f"{x}/40 1/{load}\n" for load in (2, 3, 5) for x in range(20)) + "0.1 -1\n")
        words = ("eval", "westergaard.pressure", "--rows", rows, "--digits", "25")
        whole = run(*words, "--out", self.folder / "whole.txt")
        self.assertEqual(whole.returncode, 65)
        for i in range(1, 5):
            r = run(*words, "--shard", f"{i}/4", "--out", self.shares)
            self.assertIn(r.returncode, (0, 65))
            self.assertEqual(run(*words, "--shard", f"{i}/4", "--out", self.shares).returncode, r.returncode)
        self.merged()
        self.assertEqual((self.shares / "westergaard_pressure-grid.txt").read_bytes(), (self.folder / "whole.txt").read_bytes())
        rows.write_text(rows.read_text().replace("1/40 1/5", "2/41 1/5"))  # other rows are another table
        run(*words, "--shard", "2/4", "--out", self.folder / "other")
        shutil.copy(next((self.folder / "other").glob("*.txt")), self.shares)
        self.assertIn("another table", self.merged(65).stderr)

    def test_ranges_and_surfaces(self):
        words = ("eval", "contact.area", "n=0,1", "load=0.1:0.9:0.2", "G=3,sqrt(10),4", "--digits", "12")
        run(*words, "--out", self.folder / "whole.txt")
        for i in (1, 2, 3):
            self.assertEqual(run(*words, "--shard", f"{i}/3", "--out", self.shares).returncode, 0)
        self.merged()
        self.assertEqual((self.shares / "contact_area-ranges.txt").read_bytes(), (self.folder / "whole.txt").read_bytes())

    def test_bad_input(self):
        for words, code, reason in ((("table", "archard_delta", "--shard", "0/3"), 65, "1 <= I <= N"), (("table", "archard_delta", "--shard", "4/3"), 65, "1 <= I <= N"),
                                    (("table", "archard_delta", "--shard", "1/3/5"), 65, "such as 3/16"), (("table", "archard_delta", "--shard", ""), 64, "empty"),
                                    (("table", "archard_delta", "--shard", "1/3", "--format", "csv", "--out", "x"), 64, "txt"), (("table", "all", "--shard", "1/3"), 64, "--out"),
                                    (("eval", "peaks.f", "--rows", "-", "--shard", "1/3"), 64, "not standard input"), (("merge", self.folder / "none"), 66, "no folder"),
                                    (("merge", self.folder), 66, "no shards"), (("table", "archard_delta", "--shard", "1/3", "--out", "/proc/x"), 73, "cannot write")):
            r = run(*words, cwd=self.folder)
            self.assertEqual(r.returncode, code, (words, r.stderr))
            self.assertIn(reason, r.stderr)

    @unittest.skipUnless(shutil.which("parallel"), "no GNU parallel")
    def test_gnu_parallel(self):
        """The example, on the real engine: a worker dies, the same command again makes up for it."""
        bin = self.folder / "bin"
        bin.mkdir()
        dies_once = self.folder / "died"
        (bin / "touchstone").write_text(f"#!/bin/sh\ncase \"$*\" in *\"--shard 3/5\"*) if [ ! -e '{dies_once}' ]; then : > '{dies_once}'; kill -9 $$; fi;; esac\nexec '{PROGRAM}' \"$@\"\n")
        (bin / "touchstone").chmod(0o755)
        env = dict(os.environ, PATH=f"{bin}:{os.environ['PATH']}", HOME=str(self.folder))
        command = ["bash", SOURCE / "examples/hpc/parallel.sh", "archard_delta", "5", self.shares, "-j2"]
        first = subprocess.run(command, env=env, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=120)
        self.assertNotEqual(first.returncode, 0)
        self.assertEqual(run("merge", self.shares).stdout, "--array=3\n")
        second = subprocess.run(command, env=env, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=120)
        self.assertEqual(second.returncode, 0, second.stderr)
        self.assertNotIn("there already", second.stdout)  # --resume-failed did not even start the others
        self.assertEqual((self.shares / "archard_delta.txt").read_bytes(), (STORED / "archard_delta.txt").read_bytes())

    @unittest.skipUnless(shutil.which("snakemake"), "no snakemake")
    def test_snakemake(self):
        """The example, on the real engine: a worker dies, the same command again makes what is missing; nothing is left to do then."""
        bin = self.folder / "bin"
        bin.mkdir()
        dies_once, called = self.folder / "died", self.folder / "called"
        (bin / "touchstone").write_text(f"#!/bin/sh\necho \"$*\" >> '{called}'\ncase \"$*\" in *\"--shard 3/5\"*) if [ ! -e '{dies_once}' ]; then : > '{dies_once}'; kill -9 $$; fi;; esac\n"
                                        f"exec '{PROGRAM}' \"$@\"\n")
        (bin / "touchstone").chmod(0o755)
        env = dict(os.environ, PATH=f"{bin}:{os.environ['PATH']}", HOME=str(self.folder), XDG_CACHE_HOME=str(self.folder / "cache"))
        command = ["snakemake", "--snakefile", SOURCE / "examples/hpc/Snakefile", "--directory", self.folder, "--cores", "2", "--keep-going", "--nocolor",
                   "--config", "table=archard_delta", "shares=5", f"folder={self.shares}"]
        make = lambda: subprocess.run(command, env=env, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=900)
        first = make()
        self.assertNotEqual(first.returncode, 0, first.stderr)
        self.assertTrue(dies_once.exists(), first.stderr)
        self.assertEqual(run("merge", self.shares).stdout, "--array=3\n")
        already = len(called.read_text().splitlines())
        second = make()
        self.assertEqual(second.returncode, 0, second.stderr)
        self.assertEqual(len(called.read_text().splitlines()) - already, 2, called.read_text())  # the share that died, and merge
        self.assertEqual((self.shares / "archard_delta.txt").read_bytes(), (STORED / "archard_delta.txt").read_bytes())
        make()
        self.assertEqual(len(called.read_text().splitlines()) - already, 2)


if __name__ == "__main__":
    unittest.main(verbosity=1)
