#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What misled a user once: numbers cut off, outputs that replaced devices, verdicts by chance, errors without a reason.

usage: test_complaints.py --touchstone PROGRAM --subjects FOLDER --library LIB
"""
import argparse
import json
import os
import pathlib
import re
import stat
import subprocess
import sys
import tempfile
import threading
import unittest

arguments = argparse.ArgumentParser()
arguments.add_argument("--touchstone", required=True)
arguments.add_argument("--subjects", required=True)
options, sys.argv[1:] = arguments.parse_known_args()
sys.argv[1:] = []
options.touchstone, options.subjects = os.path.abspath(options.touchstone), os.path.abspath(options.subjects)
SOURCE = pathlib.Path(__file__).resolve().parents[2]
NAN = (sys.executable, "-c", "import sys\nfor _ in sys.stdin: print('nan')")
RIGHT = (os.path.join(options.subjects, "subject_library_forms"), "westergaard.half_width")


def run(*words, **more):
    more = {"capture_output": True, "text": True, "stdin": subprocess.DEVNULL, "timeout": 1200, **more}  # ten seconds of work, under the thread sanitizer thirty times as many
    return subprocess.run([options.touchstone, *map(str, words)], **more)


def python(code):
    return sys.executable, "-c", code


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def refuses(self, code, expected, *words, stdout=""):
        r = run(*words)
        self.assertEqual((r.returncode, r.stderr.count("\n")), (code, 1), (words, r.stderr))
        self.assertTrue(r.stderr.startswith("touchstone: "), r.stderr)
        self.assertIn(expected, r.stderr)
        if stdout is not None:
            self.assertEqual(r.stdout, stdout)


class Numbers(InFolder):
    def test_no_number_is_cut_off(self):
        """Every number a report shows for a row is that row's true value, exponent included."""
        junit = self.folder / "r.xml"
        for words in (("hertz_half_width", "--held-out", "0", "--junit", junit, "--", *NAN),
                      ("hertz_half_width", "--held-out", "0", "--json", "--", *NAN),
                      ("hertz_half_width", "--held-out", "0", "--", *python("import sys\nfor _ in sys.stdin: print(7)"))):
            r = run("judge", *words)
            self.assertEqual(r.returncode, 1, r.stderr)
            text = r.stdout + (junit.read_text() if junit.exists() else "")
            junit.unlink(missing_ok=True)
            pairs = re.findall(r"load=(\S+?)[\s\"].*?(?:true value is|true) ([0-9.e+-]+)", text, re.S) if "{" not in text[:1] else [
                (float.fromhex(w["inputs"][0]), w["why"].split()[-1]) for w in json.loads(r.stdout)["worst"]]
            self.assertGreater(len(pairs), 4)
            for load, true in pairs:
                self.assertAlmostEqual(float(true) / (float(load) ** 0.5 / 3.141592653589793), 1, 5, (load, true))

    def test_a_lying_row_is_shown_whole(self):
        table = run("table", "westergaard_half_width", "--digits", "120").stdout
        rows = [line for line in table.splitlines() if not line.startswith("#")]
        row = next(r for r in rows if r.startswith("0.1 "))
        value = row.split()[1]
        lie = value[:-1] + str((int(value[-1]) + 5) % 10)
        text = table.replace(row, row.replace(value, lie))
        import hashlib
        body = "".join(line + "\n" for line in text.splitlines() if not line.startswith("#"))
        text = re.sub(r'"sha256":"[0-9a-f]*"', f'"sha256":"{hashlib.sha256(body.encode()).hexdigest()}"', text)
        path = self.folder / "lie.txt"
        path.write_text(text)
        r = run("judge", path, "--recheck", "1000", "--", *RIGHT)
        self.assertEqual(r.returncode, 65)
        self.assertIn(lie, r.stderr)
        self.assertIn(value, r.stderr)

    def test_two_figures_that_differ_look_different(self):
        """A baseline that is missed by the twentieth part of a thousandth says so."""
        path = self.folder / "b.json"
        words = ("judge", "westergaard_half_width", "--baseline", path, "--held-out", "0")
        self.assertEqual(run(*words, "--update-baseline", "--", *RIGHT).returncode, 0)
        stored = json.loads(path.read_text())
        key, bound = max(stored["ulps"].items(), key=lambda item: item[1])
        stored["ulps"][key] = bound * (1 - 1e-9)
        path.write_text(json.dumps(stored))
        why = json.loads(run(*words, "--json", "--", *RIGHT).stdout)["worst"][0]["why"]
        shown = re.findall(r"[0-9.]+(?:e[+-]?[0-9]+)?", why)
        self.assertNotEqual(shown[0], shown[1], why)


class Outputs(InFolder):
    def writes(self, path, **more):
        return run("judge", "westergaard_half_width", "--held-out", "0", "--svg", path, "--", *RIGHT, **more)

    def test_a_device_stays_a_device(self):
        device = self.folder / "null"
        try:
            os.mknod(device, stat.S_IFCHR | 0o666, os.makedev(1, 3))
        except PermissionError:
            self.skipTest("only root makes devices")
        self.assertEqual(self.writes(device).returncode, 0)
        self.assertTrue(stat.S_ISCHR(device.stat().st_mode))
        full = self.folder / "full"
        os.mknod(full, stat.S_IFCHR | 0o666, os.makedev(1, 7))
        r = self.writes(full)
        self.assertEqual(r.returncode, 73)
        self.assertIn(f"cannot write {full}: No space left on device", r.stderr)
        self.assertTrue(r.stdout.startswith("PASS"))  # the report is not lost with the picture

    def test_a_pipe_is_written_to(self):
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        got = []
        reader = threading.Thread(target=lambda: got.append(pipe.read_text()), daemon=True)
        reader.start()
        self.assertEqual(self.writes(pipe, timeout=20).returncode, 0)
        reader.join(20)
        self.assertTrue(stat.S_ISFIFO(pipe.stat().st_mode))
        self.assertTrue(got and got[0].startswith("<svg"))

    def test_links_stay_links(self):
        real, link, second = self.folder / "real.svg", self.folder / "link.svg", self.folder / "second.svg"
        real.write_text("old")
        os.link(real, second)
        link.symlink_to("real.svg")
        self.assertEqual(self.writes(link).returncode, 0)
        self.assertTrue(link.is_symlink())
        self.assertTrue(real.read_text().startswith("<svg"))
        self.assertEqual(second.read_text(), "old")  # a name that nobody gave us keeps what it had
        nowhere = self.folder / "nowhere.svg"
        nowhere.symlink_to(self.folder / "new.svg")
        self.assertEqual(self.writes(nowhere).returncode, 0)
        self.assertTrue((self.folder / "new.svg").read_text().startswith("<svg"))
        loop = self.folder / "loop"
        loop.symlink_to(loop)
        self.refuses(73, "Too many levels of symbolic links", "judge", "westergaard_half_width", "--svg", loop, "--", *RIGHT, stdout=None)

    def test_a_mode_is_kept(self):
        for mode in (0o600, 0o640, 0o666, 0o755):
            path = self.folder / f"{mode:o}.svg"
            path.write_text("old")
            path.chmod(mode)
            self.assertEqual(self.writes(path).returncode, 0)
            self.assertEqual(stat.S_IMODE(path.stat().st_mode), mode)
        fresh = self.folder / "fresh.svg"
        self.assertEqual(self.writes(fresh, umask=0o027).returncode, 0)
        self.assertEqual(stat.S_IMODE(fresh.stat().st_mode), 0o640)
        self.assertEqual(len(list(self.folder.iterdir())), 5)  # no temporary file left

    def test_standard_output_by_its_other_names(self):
        stdout = self.folder / "stdout"  # what /dev/stdout is, so that a fault here does not cost the machine its own
        stdout.symlink_to("/proc/self/fd/1")
        for name in (stdout, "/dev/fd/1", "/proc/self/fd/1"):
            path = self.folder / "out"
            with open(path, "w") as out:
                out.write("before\n")
                out.flush()
                self.assertEqual(self.writes(name, capture_output=False, stdout=out, stderr=subprocess.DEVNULL).returncode, 0)
            text = path.read_text()
            self.assertTrue(text.startswith("before\nPASS"), text[:80])
            self.assertTrue(text.endswith("</svg>\n"))

    def test_the_reason_is_given(self):
        for path, reason in ((self.folder, "Is a directory"), (self.folder / "none" / "x", "No such file or directory"),
                             (self.folder / ("x" * 300), "File name too long")):
            self.refuses(73, reason, "judge", "westergaard_half_width", "--svg", path, "--", *RIGHT, stdout=None)
        (self.folder / "file").touch()
        self.refuses(73, "Not a directory", "table", "archard_K", "--out", self.folder / "file" / "x")
        with open("/dev/full", "w") as full:
            for words in (("list",), ("table", "westergaard_pressure"), ("eval", "archard.K_inf")):
                r = run(*words, capture_output=False, stdout=full, stderr=subprocess.PIPE)
                self.assertEqual((r.returncode, r.stderr), (73, "touchstone: standard output cannot be written: No space left on device\n"))


class Repeatable(InFolder):
    def test_the_same_run_gives_the_same_report(self):
        words = ("judge", "westergaard_exceedance", "--json", "--", os.path.join(options.subjects, "subject_printed_formulas"), "westergaard.exceedance")
        self.assertEqual(run(*words).stdout, run(*words).stdout)
        a, b = (json.loads(run(*words[:3], "--seed", "random", *words[3:]).stdout)["held_out"]["seed"] for _ in range(2))
        self.assertNotEqual(a, b)
        self.assertIn(f"--seed {b}", run(*words[:2], "--seed", b, *words[3:]).stdout)

    def test_held_out_rows_do_not_count_against_a_baseline(self):
        subject = ("--", os.path.join(options.subjects, "subject_printed_formulas"), "westergaard.exceedance")  # millions of ulps off near the edge
        path = self.folder / "b.json"
        words = ("judge", "westergaard_exceedance", "--baseline", path)
        self.assertEqual(run(*words, "--update-baseline", *subject).returncode, 1)
        for seed in "1", "2", "3":
            r = run(*words, "--json", "--seed", seed, *subject)
            j = json.loads(r.stdout)
            self.assertEqual((r.returncode, j["verdict"], j["failed"]), (0, "pass", 0), j["worst"][:1])
            self.assertEqual(j["held_out"]["rows"], 32)

    def test_a_seed_is_a_number_or_random(self):
        for seed in ("-1", "1.5", "x", "", "99999999999999999999999"):
            self.refuses(64, "must be random, or an integer from 0", "judge", "westergaard_half_width", "--seed", seed, "--", *RIGHT)
        for flag in ("--recheck", "--held-out"):
            self.refuses(64, "-1", "judge", "westergaard_half_width", flag, "-1", "--", *RIGHT)


class Words(InFolder):
    def test_a_load_has_no_width(self):
        code = "import sys\nfrom math import *\nfor l in sys.stdin:\n x = min(1, 2*float.fromhex(l)); print(atan2(sqrt(x), sqrt(1-x))/pi)"
        j = json.loads(run("judge", "westergaard_half_width", "--json", "--", *python(code)).stdout)
        self.assertRegex(j["mixup"]["name"], "^load taken times 2")
        self.assertNotIn("width", j["mixup"]["name"])

    def test_what_a_subject_wrote_is_shown_as_it_wrote_it_and_once(self):
        r = run("judge", "westergaard_half_width", "--", *python("import sys; sys.exit('a < b & \"c\" > d \\x1b[31m')"))
        self.assertEqual(r.returncode, 69)
        self.assertIn('a < b & "c" > d \\x1b[31m', r.stdout)
        self.assertEqual((r.stdout + r.stderr).count("exit status 1"), 1, r.stdout + r.stderr)
        noise = python("import sys\nfor i in range(200): print('line', i, file=sys.stderr)\nsys.exit(1)")
        self.assertIn("line 199", run("judge", "westergaard_half_width", "--", *noise).stdout)

    def test_an_endless_file_of_answers_ends(self):
        for bytes_, kind in ((b"1\n", "too_many"), (b"1 ", "endless_line"), (b"\n", "endless_line"), (b"# again\n", "endless_line"), (b"\0", "endless_line")):
            pipe = self.folder / "pipe"
            os.mkfifo(pipe)

            def feed():
                try:
                    with open(pipe, "wb") as f:
                        while True:
                            f.write(bytes_ * 10000)
                except BrokenPipeError:
                    pass

            threading.Thread(target=feed, daemon=True).start()
            r = run("judge", "westergaard_half_width", "--json", "--answers", pipe, timeout=20)
            self.assertEqual((r.returncode, json.loads(r.stdout)["fault"]["kind"]), (69, kind), r.stderr)
            pipe.unlink()

    def test_what_cannot_be_read_says_why(self):
        self.refuses(65, "Is a directory", "judge", "westergaard_half_width", "--answers", self.folder)
        self.refuses(65, "Is a directory", "judge", str(self.folder) + "/", "--", *RIGHT)
        (self.folder / "tables").mkdir()
        r = run("judge", "tables", "--", *RIGHT, cwd=self.folder)
        self.assertEqual((r.returncode, r.stdout), (65, ""))
        self.assertIn("tables is a directory", r.stderr)
        self.refuses(65, "longer than", "judge", "/dev/zero", "--", *RIGHT)
        self.refuses(66, "no such file", "judge", "./none.txt", "--", *RIGHT)
        self.refuses(65, "Is a directory", "judge", "westergaard_half_width", "--baseline", self.folder, "--", *RIGHT)

    def test_no_certificate_reaches_it(self):
        self.refuses(65, "shares below 1e-14 have no certificate", "certificate", "contact.area", "n=60", "load=3", "G=2", "--out", self.folder / "f")
        self.refuses(65, "so near to pressure 0 at a load so near to 1", "certificate", "contact.density", "n=1", "p=1e-99", "load=1", "G=3", "--out", self.folder / "f")
        self.refuses(65, "below the numbers of binary64", "certificate", "contact.density", "n=1", "p=1e-999", "load=1/2", "G=3", "--out", self.folder / "f")
        for why, *at in (("loads up to 1 - 10^-6", "n=2", "p=1", "load=1"), ("needs none with full contact", "n=1", "p=1", "load=2"), ("largest pressure", "n=1", "p=7", "load=0.1"), ("is of closed form", "n=0", "p=1", "load=0.1")):
            self.refuses(2, why, "certificate", "contact.density", *at, "G=3", "--out", self.folder / "f")
        for code, why, *rows in ((2, "there is no such row", "n=77"), (64, "has no column 'm'", "m=1"), (65, "n=x: is not a number", "n=x"), (64, "'n' is given twice", "n=1", "n=1")):
            self.refuses(code, why, "certificate", "contact_exceedance", *rows, "--out", self.folder / "f")
        self.assertFalse((self.folder / "f").exists())

    def test_numbers_that_are_none(self):
        for text, why in (("1/0", "has 0 as its denominator"), ("1e-999999999999", "has an exponent beyond 1000000"), ("1e99999999", "has an exponent beyond 1000000"),
                          ("1/-3", "has a negative denominator"), ("", "is empty"), ("1e", "is not a number"), ("x/2", "is not a number"),
                          ("1/1e9999999", "has an exponent beyond 1000000"), ("0x1p99999999", "has an exponent beyond 1000000"),
                          ("nan", "is not a number"), ("-inf", "is not a number"), ("/", "is not a number"), ("3/", "is not a number")):
            self.refuses(65, f"load = '{text}' {why}", "eval", "hertz.half_width", f"load={text}")

    def test_nothing_is_no_name(self):
        self.refuses(64, "is empty", "paper", "")
        for words in (("table", "archard_K", "--out", ""), ("judge", "archard_K", "--junit", "", "--", "true"), ("judge", "archard_K", "--answers", ""),
                      ("judge", "archard_K", "--baseline", "", "--", "true"), ("judge", "archard_K", "--svg", "", "--", "true")):
            self.refuses(64, "empty", *words)
        self.refuses(64, "nearest is", "nonsense", "--help")
        self.refuses(64, "nearest is 'eval'", "evl", "archard.K", "--help")
        self.assertEqual(run("eval", "--help").returncode, 0)
        self.assertEqual(run("--help").returncode, 0)

    def test_a_list_fits_80_columns(self):
        text = run("list").stdout
        self.assertLessEqual(max(map(len, text.splitlines())), 80)
        for q in json.loads(run("list", "--json").stdout):
            squeezed = " ".join(text.split())
            self.assertIn(" ".join(q["domain"].split()), squeezed)
            self.assertIn(" ".join(q["description"].split()), squeezed)

    def test_carriage_returns_are_named(self):
        table = run("table", "westergaard_half_width").stdout
        path = self.folder / "westergaard_half_width.txt"
        path.write_bytes(table.replace("\n", "\r\n").encode())
        self.refuses(65, "CR LF", "judge", path, "--", *RIGHT)
        r = run("table", "westergaard_half_width", "--check", "--out", self.folder)
        self.assertEqual(r.returncode, 1)
        self.assertIn("CR LF where LF is right", r.stderr)
        self.assertRegex((SOURCE / ".gitattributes").read_text(), r"(?m)^\* .*eol=lf")

    def test_a_changed_digit_far_to_the_right_is_shown(self):
        words = ("table", "archard_K_inf", "--digits", "2000", "--out", self.folder)
        self.assertEqual(run(*words).returncode, 0)
        path = self.folder / "archard_K_inf.txt"
        text = path.read_text()
        at = text.rindex("\n", 0, -1) + 1500
        path.write_text(text[:at] + str((int(text[at]) + 1) % 10) + text[at + 1:])
        r = run(*words, "--check")
        regenerated, stored = re.findall(r"'([^']*)'", r.stderr.split("differs: line")[-1])[:2]
        self.assertNotEqual(regenerated, stored, r.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
