#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""eval with rows and ranges, --round, check and own tables, from outside: output, exit codes, interrupts, damaged input.

usage: test_own_rows.py TOUCHSTONE PAPER_TABLE
"""
import json
import os
import pathlib
import re
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM, PAPER_TABLE = sys.argv.pop(1), sys.argv.pop(1)
SLOW = "contact.area", "G=3", "n=8"  # some tenths of a second a surface, then cheap


def run(*words, stdin=None, **options):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, input=stdin, timeout=300, **options)


def rows_of(text):
    return [line.split(" # ") for line in text.splitlines() if line and not line.startswith("#")]


def header_of(text):
    return json.loads(next(line for line in text.splitlines() if line.startswith("# {"))[2:])


class Scratch(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, text, name="rows.txt"):
        path = self.folder / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return str(path)


class OwnRows(Scratch):
    def test_rows_come_back_in_their_order_with_the_values_that_one_by_one_has(self):
        random.seed(3)
        asked = [(n, f"{random.randint(1, 99)}/100", G) for n in (0, 1, 3) for G in ("sqrt(10)", "5/2", "2^1.5", "3")]
        random.shuffle(asked)
        path = self.file("# load G n\n" + "".join(f"{load} {G} {n}\n" for n, load, G in asked))
        r = run("eval", "contact.area", "--rows", path, "--digits", "12")
        self.assertEqual((r.returncode, r.stderr), (0, ""))
        found = rows_of(r.stdout)
        self.assertEqual([row[0].split()[:3] for row in found], [[str(n), load, G] for n, load, G in asked])
        for row, (n, load, G) in list(zip(found, asked))[:4]:
            one = json.loads(run("eval", "contact.area", f"n={n}", f"load={load}", f"G={G}", "--digits", "12", "--json").stdout)
            self.assertEqual((row[0].split()[3], row[1]), (one["value"], one["status"]))
        self.assertEqual(header_of(r.stdout)["inputs"], ["n", "load", "G"])
        last = json.loads(r.stdout.splitlines()[-1][2:])
        self.assertEqual((last["rows"], last["complete"]), (len(asked), True))

    def test_ranges_on_the_command_line(self):
        r = run("eval", "westergaard.pressure", "x=0,1/4", "load=0.01:0.99:0.01", "--digits", "8")
        self.assertEqual(r.returncode, 0)
        found = rows_of(r.stdout)
        self.assertEqual(len(found), 2 * 99)
        self.assertEqual(found[1][0].split()[:2], ["0", "0.02"])
        one = json.loads(run("eval", "westergaard.pressure", "x=1/4", "load=0.99", "--digits", "8", "--json").stdout)
        self.assertEqual(found[-1][0].split()[2], one["value"])
        r = run("eval", "hertz.half_width", "load=log:1e-9:1:50")
        self.assertEqual(len(rows_of(r.stdout)), 50)
        objects = [json.loads(line) for line in run("eval", "hertz.half_width", "load=0.1,0.2", "--json").stdout.splitlines()]
        self.assertEqual([o["inputs"]["load"] for o in objects], ["0.1", "0.2"])
        self.assertTrue(all(o["status"] == "certified" and o["binary64"].startswith("0x") for o in objects))

    def test_what_it_writes_it_reads(self):
        first = run("eval", "peaks.fixed_point", "D=1.5", "gamma=2,10,100").stdout
        again = run("eval", "peaks.fixed_point", "--rows", "-", stdin=first).stdout
        self.assertEqual(first, again)
        table = run("table", "archard_K", "--digits", "20").stdout
        mine = run("eval", "archard.K", "--rows", "-", "--digits", "20", stdin=table)
        # inputs of one's own are exact: nothing forces an error on them, and the table's last column is not theirs
        self.assertEqual([row[0].split() for row in rows_of(mine.stdout)],
                         [line.split()[:-1] for line in table.splitlines() if not line.startswith("#")])

    def test_binary64_inputs(self):
        r = run("eval", "hertz.half_width", "load=0.1,1/3", "--binary64", "--digits", "30")
        values = [row[0].split() for row in rows_of(r.stdout)]
        one = json.loads(run("eval", "hertz.half_width", "load=0x1.999999999999ap-4", "--digits", "30", "--json").stdout)
        self.assertEqual(values[0], ["0.1", one["value"], one["error"]])
        self.assertEqual(values[1][0], "0.3333333333333333")
        self.assertEqual(header_of(r.stdout)["input_format"], "binary64")
        r = run("eval", "peaks.fixed_point", "G=sqrt(10),2", "--binary64")
        self.assertEqual(rows_of(r.stdout)[0][0].split()[0], "3.1622776601683795")

    def test_files_as_they_come(self):
        right = [row[0] for row in rows_of(run("eval", "hertz.half_width", "load=0.1,0.2,0.3").stdout)]
        for text in ("# load\n0.1\n0.2\n0.3\n", "# load\r\n0.1\r\n0.2\r0.3", "\ufeff# load\n0.1\n\n0.2\n# so\n0.3 # last\n", "load\n0.1\n0.2\n0.3", "load,answer\n0.1,5\n0.2,6\n0.3,7\n"):
            r = run("eval", "hertz.half_width", "--rows", self.file(text))
            self.assertEqual((r.returncode, [row[0] for row in rows_of(r.stdout)]), (0, right), text)

    def broken(self, text, line, reason, rows_before, *words, quantity="hertz.half_width", code=65):
        path = self.file(text)
        r = run("eval", quantity, "--rows", path, *words)
        self.assertEqual(r.returncode, code, r.stderr)
        self.assertEqual(r.stderr.count("\n"), 1, r.stderr)
        self.assertIn(f"{path}{line}", r.stderr)
        self.assertIn(reason, r.stderr)
        self.assertEqual(len([row for row in rows_of(r.stdout) if not row[1].startswith("refused")]), rows_before)
        return r

    def test_damaged_files_cost_no_row_before_or_after(self):
        self.broken("# load\n0.1\n0.2 0.3\n0.4\n", ":3: row 2", "2 columns where 1", 1)
        self.broken("# load\n0.1\nnan\n0.4\n", ":3: row 2", "not a number", 2)
        self.broken("# load\n0.1\n-1\n0.4\ninf\n", ":3: row 2", "must be > 0", 2)
        self.assertIn("2 rows have no value", self.broken("# load\n-1\n0.1\n-1\n", ":2: row 1", "must be > 0", 1).stderr)
        self.broken("# load p\n0.1 1\n", ":1", "unknown column 'p'", 0)
        self.broken("# load\n", "", "no rows", 0)
        self.broken("", "", "no rows", 0)
        self.broken("0.1\n", ":1", "names the columns", 0)
        self.broken("load,x\n0.1,\n", ":2: row 1", "empty", 0, quantity="westergaard.pressure")
        self.broken("# x\n1\n", "", "missing key 'load'", 0, quantity="westergaard.pressure", code=64)
        self.broken("# load\n1\n", "", "load=2", 0, "load=2", code=64)
        self.broken("# G gamma n load\n1 1 1 1\n", "", "either G or D and gamma", 0, quantity="contact.area", code=64)
        path = self.folder / "rows\nof a strange name.txt"  # which a row's reason names: rows stay lines all the same
        path.write_text("load\n-1\n")
        self.assertEqual([row[1][:9] for row in rows_of(run("eval", "hertz.half_width", "--rows", str(path)).stdout)], ["refused: "])
        self.assertEqual(run("eval", "hertz.half_width", "--rows", str(self.folder)).returncode, 65)
        self.assertEqual(run("eval", "hertz.half_width", "--rows", str(self.folder / "none")).returncode, 66)
        self.assertEqual(run("eval", "hertz.half_width", "load=1:2").returncode, 65)
        self.assertEqual(run("eval", "hertz.half_width", "load=1:2:3", "--resume").returncode, 64)
        self.assertEqual(run("eval", "hertz.half_width", "load=1", "--binary64").returncode, 64)
        self.assertEqual(run("eval", "hertz.half_width", "load=1:2:1", "--out", "/none/x").returncode, 73)

    @unittest.skipIf(any(mark in pathlib.Path(PROGRAM).read_bytes() for mark in (b"__asan_init", b"__tsan_init")), "sanitizers reserve more address space than this leaves")
    def test_an_endless_line_and_many_rows_take_no_memory(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30))
        endless = subprocess.Popen(["head", "-c", "1000000000", "/dev/zero"], stdout=subprocess.PIPE)
        r = subprocess.run([PROGRAM, "eval", "hertz.half_width", "--rows", "-"], stdin=endless.stdout, capture_output=True, text=True, timeout=100, preexec_fn=limit)
        endless.stdout.close()
        endless.wait()
        self.assertEqual(r.returncode, 65)
        self.assertIn("no line end", r.stderr)
        out = self.folder / "many.txt"
        r = run("eval", "westergaard.half_width", "load=1/20000:1:1/20000", "--digits", "3", "--out", str(out), preexec_fn=limit)
        self.assertEqual((r.returncode, r.stderr), (0, ""))
        self.assertEqual(header_of(out.read_text())["rows"], 20000)
        self.assertEqual(os.listdir(self.folder), ["many.txt"])

    def test_an_interrupt_leaves_a_table_and_resume_finishes_it(self):
        words = ["eval", "contact.exceedance", "n=1", "load=1/2", "G=5/2", "p=1/200:3/2:1/200", "--digits", "30"]
        whole = run(*words)
        self.assertEqual(whole.returncode, 0)
        out = self.folder / "t.txt"
        for signal_sent, code in ((signal.SIGINT, 130), (signal.SIGKILL, -9), (signal.SIGTERM, 143)):
            before = max((len(rows_of(p.read_text())) for p in self.folder.iterdir()), default=0)
            process = subprocess.Popen([PROGRAM, *words, "--out", str(out), "--resume", "--jobs", "1"], stderr=subprocess.PIPE, text=True)
            for _ in range(600):
                time.sleep(0.05)
                parts = [p for p in self.folder.glob("t.txt.part*")]
                if process.poll() is not None or (parts and max(len(rows_of(p.read_text())) for p in parts) > before + 3):
                    break
            self.assertIsNone(process.poll(), "finished before it could be interrupted")
            process.send_signal(signal_sent)
            message = process.communicate(timeout=60)[1]
            self.assertEqual(process.returncode, code, message)
            if signal_sent != signal.SIGKILL:
                self.assertIn("--resume", message)
                text = out.read_text()
                self.assertEqual((header_of(text)["rows"], header_of(text)["complete"]), (len(rows_of(text)), False))
                self.assertGreater(len(rows_of(text)), before)
                self.assertLess(len(rows_of(text)), len(rows_of(whole.stdout)))
        resumed = run(*words, "--out", str(out), "--resume")
        self.assertEqual((resumed.returncode, resumed.stdout, resumed.stderr), (0, "", ""))
        self.assertEqual(rows_of(out.read_text()), rows_of(whole.stdout))
        self.assertEqual(os.listdir(self.folder), ["t.txt"])
        self.assertTrue(header_of(out.read_text())["complete"])
        # nothing is computed again, nothing is taken for what it is not
        started = time.monotonic()
        self.assertEqual(run(*words, "--out", str(out), "--resume").returncode, 0)
        kept = out.read_text()
        self.assertEqual(run(*words[:-1], "16", "--out", str(out), "--resume").returncode, 64)
        self.assertEqual(out.read_text(), kept)

    def test_resume_believes_no_row_that_is_none(self):
        """What is taken up again was written by this program, for these rows; else one line says where it is not, and nothing is changed."""
        rows = self.file("# load\n" + "".join(f"{k}/20\n" for k in range(1, 9)) + "-1\n")
        words = ["eval", "hertz.half_width", "--rows", rows, "--digits", "8"]
        out, part = self.folder / "t.txt", self.folder / "t.txt.part"
        self.assertEqual(run(*words, "--out", str(out)).returncode, 65)  # for the last row
        whole = out.read_text()
        head, after = whole.split("1/20 ", 1)
        lines = ("1/20 " + after).splitlines(keepends=True)
        unsealed = re.sub(r',"rows":\d.*}\n', "}\n", head)  # as it grows
        self.assertNotIn("sha256", unsealed)
        line = head.count("\n")

        def resumed(text, code, reason, *more):
            with self.subTest(reason, text=text[len(head):len(head) + 80]):
                out.unlink(missing_ok=True)
                part.write_text(text)
                r = run(*words, *more, "--out", str(out), "--resume")
                self.assertEqual(r.returncode, code, r.stderr)
                self.assertEqual(r.stderr.count("\n"), 1, r.stderr)
                self.assertIn(reason, r.stderr)
                if "must be" in reason:
                    self.assertEqual(out.read_text(), whole)
                else:
                    self.assertEqual(part.read_text(), text)
                    self.assertEqual([p.name for p in self.folder.glob("t.*")], ["t.txt.part"])

        self.assertEqual(lines[1], "2/20 0.10065842 5e-09 # certified\n")
        resumed(unsealed + "".join(lines[:3]), 65, "must be > 0")
        resumed(unsealed + "".join(lines[:3]) + lines[3][:-9], 65, "must be > 0")  # killed in the middle of a line
        resumed(unsealed + lines[1] + lines[5], 65, "must be > 0")  # those between were not done
        for bad, reason in (("2/20 5e5000 5e-09 # certified", "value that is none of ours"), ("2/20 0.1006584 5e-08 # certified", "value that is none of ours"),
                            ("2/20 0.10065842 5e-09 # proven", "the status 'proven'"), ("2/20 0.10065842 5e-09", "no status"), ("2/20 1 0.10065842 5e-09 # certified", "4 columns where 3"),
                            ("", "no status"), ("# 2/20", "no status"), ("1/11 0.10065842 5e-09 # certified", "not among the rows asked for, in their order")):
            resumed(unsealed + lines[0] + bad + "\n" + lines[2], 65, f"t.txt.part:{line + 2}: ")
            resumed(unsealed + lines[0] + bad + "\n" + lines[2], 65, reason)
        resumed(unsealed + lines[2] + lines[1], 65, "in their order")
        resumed(unsealed + lines[1] + lines[1], 65, "in their order")
        resumed(head + "".join(lines[:-1]), 65, "do not have the SHA-256")
        resumed(whole.replace("0.10065842", "0.10065843"), 65, "do not have the SHA-256")
        resumed(unsealed.replace('"version":"', '"version":"9') + lines[0], 64, "was not made by version")
        resumed(unsealed.replace(',"version":"', ',"v":"') + lines[0], 64, "was not made by version")
        resumed(unsealed + lines[0], 64, "nothing to resume", "--round", "up")
        resumed(lines[0], 64, "nothing to resume")
        r = run(*words[:2], "--rows", "-", "--digits", "8", "--out", str(out), "--resume", stdin="# load\n1/20\n")
        self.assertEqual(r.returncode, 64, r.stderr)  # the table is what the last case has left
        part.write_text(unsealed + "1/20 0.071176255 5e-10 # proven\n")
        r = run(*words[:2], "--rows", "-", "--digits", "8", "--out", str(out), "--resume", stdin="# load\n1/20\n")
        self.assertEqual((r.returncode, r.stderr.count("\n")), (65, 1), r.stderr)

    def test_round(self):
        value = lambda how: json.loads(run("eval", "archard.K", "n=3", "--digits", "6", "--round", how, "--json").stdout)["value"]
        self.assertEqual([value(how) for how in ("nearest", "up", "down", "zero", "away")], ["0.416550", "0.416551", "0.416550", "0.416550", "0.416551"])
        self.assertEqual(run("eval", "archard.K", "n=3", "--round", "sideways").returncode, 64)
        r = run("eval", "archard.K", "n=0,3", "--digits", "6", "--round", "up")
        self.assertEqual([row[0].split()[1] for row in rows_of(r.stdout)], ["0.636620", "0.416551"])

    def test_roots_as_inputs(self):
        value = lambda *words: json.loads(run("eval", "peaks.fixed_point", *words, "--json").stdout)["value"]
        self.assertEqual(value("G=sqrt(10)"), value("D=1.5", "gamma=10"))
        self.assertEqual(value("G=10^(1/2)"), value("G=10^0.5"))
        r = run("eval", "hertz.half_width", "load=sqrt(2)")
        self.assertEqual((r.returncode, r.stderr), (65, "touchstone: load = 'sqrt(2)' is irrational: only G may be\n"))


class Check(Scratch):
    def test_table_1_is_one_call(self):
        r = run("check", PAPER_TABLE, "--quantity", "archard.K")
        self.assertEqual((r.returncode, r.stderr), (0, ""))
        self.assertTrue(r.stdout.endswith("20 entries of archard.K: 20 right as rounded\n"))

    def test_every_kind_of_entry(self):
        path = self.file("# n printed\n3 0.416550\n3 0.4165503\n3 0.416551\n3 0.4156\n")
        r = run("check", path, "--quantity", "archard.K")
        self.assertEqual(r.returncode, 1)
        for verdict in ("right as rounded", "right as cut off; rounded: 0.4165504", "one unit off; rounded: 0.416550", "wrong; rounded: 0.4166"):
            self.assertIn(verdict, r.stdout)
        j = json.loads(run("check", path, "--quantity", "archard.K", "--json").stdout)
        self.assertEqual((j["verdict"], len(j["entries"]), j["counts"]["wrong"], j["entries"][3]["right"]), ("fail", 4, 1, "0.4166"))
        cut = self.file("n,K\n3,0.4165503\n")
        self.assertEqual(run("check", cut, "--quantity", "archard.K").returncode, 0)
        estimated = self.file("# n p load G value\n2 0.002 1 2 0.001\n")
        self.assertEqual(run("check", estimated, "--quantity", "contact.density").returncode, 2)

    def test_what_cannot_be_checked(self):
        for text, reason in (("# n K\n3 x\n", "row 1: 'x' is not a decimal"), ("# n K\n3 nan\n", "not a decimal"), ("# n K\n-1 0.5\n", "must be"), ("# n K\n3 0.4 1\n", "3 columns")):
            r = run("check", self.file(text), "--quantity", "archard.K")
            self.assertEqual((r.returncode, r.stderr.count("\n")), (65, 1), r.stderr)
            self.assertIn(reason, r.stderr)


class OwnTable(Scratch):
    def test_a_table_of_ones_own(self):
        spec = self.file(json.dumps({"name": "mine", "quantity": "contact.area", "digits": 15, "inputs": {"n": "0:2:1", "load": [0.1, "1/3"], "G": "sqrt(10)"}}), "mine.json")
        out = self.folder / "out"
        r = run("table", spec, "--out", str(out))
        self.assertEqual((r.returncode, r.stderr), (0, ""))
        text = (out / "mine.txt").read_text()
        self.assertEqual((header_of(text)["name"], header_of(text)["rows"], header_of(text)["digits"]), ("mine", 6, 15))
        self.assertEqual(json.loads((out / "manifest.txt.json").read_text())["tables"][0]["name"], "mine")
        self.assertEqual(run("table", spec, "--out", str(out), "--check").returncode, 0)
        path = out / "mine.txt"
        path.write_text(text.replace("certified reference", "changed reference"))
        self.assertEqual(run("table", spec, "--out", str(out), "--check").returncode, 1)
        rows = self.file(json.dumps({"name": "few", "quantity": "hertz.pressure", "columns": ["x", "load"], "rows": [[0, "0.5"], ["0x1p-4", 1]]}), "few.json")
        r = run("table", rows, "--format", "csv")
        self.assertEqual((r.returncode, len(r.stdout.splitlines())), (0, 3))

    def test_bad_manifests(self):
        good = {"name": "mine", "quantity": "hertz.half_width", "inputs": {"load": "1,2"}}
        for change, reason in (({"quantity": "hertz.haf_width"}, "nearest is 'hertz.half_width'"), ({"name": "../x"}, "name"), ({"inputs": {}}, "missing key 'load'"),
                               ({"inputs": {"load": "0,1"}}, "must be > 0"), ({"inputs": {"load": "a"}}, "not a number"), ({"digits": 0}, "digits"), ({"other": 1}, "unknown key 'other'"),
                               ({"inputs": {"load": "1,1"}}, "twice"), ({"name": None}, "name")):
            r = run("table", self.file(json.dumps({**good, **change}), "bad.json"))
            self.assertIn(r.returncode, (64, 65), r.stderr)
            self.assertIn(reason, r.stderr)
            self.assertEqual(r.stderr.count("\n"), 1)
        self.assertEqual(run("table", self.file("{", "bad.json")).returncode, 65)
        self.assertEqual(run("table", str(self.folder / "no.json")).returncode, 66)


if __name__ == "__main__":
    unittest.main(verbosity=1)
