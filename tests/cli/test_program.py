#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The touchstone program from outside: output, exit codes, one line per error, nothing half-written.

usage: test_program.py TOUCHSTONE
"""
import functools
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)


def run(*words, **options):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=1800, **options)


class Program(unittest.TestCase):
    def refuses(self, code, expected, *words):
        r = run(*words)
        self.assertEqual(r.returncode, code, (words, r.stderr))
        self.assertEqual(r.stdout, "")
        self.assertEqual(r.stderr.count("\n"), 1, r.stderr)
        self.assertTrue(r.stderr.startswith("touchstone: "), r.stderr)
        self.assertIn(expected, r.stderr)

    def value(self, *words):
        r = run("eval", *words, "--json")
        self.assertIn(r.returncode, (0, 2), r.stderr)
        return json.loads(r.stdout)

    def test_the_documented_example(self):
        j = self.value("archard.K", "n=3", "--digits", "30")
        self.assertEqual(j["quantity"], "archard.K")
        self.assertEqual(j["inputs"], {"n": "3"})
        self.assertEqual(j["value"], "0.416550371832813487722720256733")
        self.assertEqual((j["digits"], j["status"]), (30, "certified"))
        self.assertEqual(j["binary64"], "0x1.aa8c2e40a2612p-2")
        self.assertEqual(j["routes"], ["interpolation", "gamma-product"])

    def test_inputs_are_exact(self):
        self.assertEqual(self.value("peaks.f", "x=0x1.8p-3")["value"], self.value("peaks.f", "x=3/16")["value"])
        self.assertNotEqual(self.value("hertz.half_width", "load=0.1", "--digits", "40")["value"],
                            self.value("hertz.half_width", "load=0x1.999999999999ap-4", "--digits", "40")["value"])
        self.assertEqual(self.value("peaks.fixed_point", "G=2")["value"], "1")
        self.assertEqual(self.value("peaks.fixed_point", "gamma=4", "D=1.5")["status"], "exact")

    def test_digits_do_not_depend_on_how_they_are_found(self):
        for q in (["archard.K_inf"], ["westergaard.density", "p=0.1", "load=0.3"], ["weierstrass.profile", "x=0.3", "D=1.5", "gamma=7"]):
            values = {self.value(*q, "--digits", "77", "--start-precision", str(b))["value"] for b in (2, 50, 500, 5000)}
            self.assertEqual(len(values), 1)

    def test_undecided_is_exit_2_and_prints_only_what_is_known(self):
        r = run("eval", "peaks.iterate", "n=900", "load=1", "G=4", "--digits", "1", "--max-precision", "256", "--json")
        self.assertEqual(r.returncode, 2)
        self.assertEqual(json.loads(r.stdout)["status"], "undecided")

    def test_only_what_is_proven_is_explained(self):
        for n, p, status in (("0", "0.9", "certified"), ("1", "0.9", "certified"), ("2", "0.9", "certified"), ("2", "0.002", "estimated")):  # with full contact
            words = ["eval", "contact.density", f"n={n}", f"p={p}", "load=1", "G=2", "--digits", "3", "--explain"]
            plain = run(*words)
            self.assertEqual((plain.returncode, plain.stderr), (0, ""))
            self.assertEqual("proves the digits" in plain.stdout, status == "certified")
            self.assertEqual("<=" in plain.stdout.splitlines()[1], status == "certified")
            j = json.loads(run(*words, "--json").stdout)
            self.assertEqual((j["status"], "explain" in j), (status, status == "certified"))
            self.assertEqual(("error" in j, "error_estimate" in j), (status == "certified", status == "estimated"))
            if status == "certified":
                self.assertEqual((j["second_look"]["kind"], j["second_look"]["agrees"]), ("witness" if n == "2" else "proof", True))
        self.assertEqual(run("eval", "contact.area", "n=2", "load=1000", "G=1.5", "--explain").returncode, 0)

    def test_digits_beyond_what_is_certified_are_not_printed(self):
        words = ["contact.density", "n=2", "p=0.9", "load=1", "G=3/2"]
        r = run("eval", *words, "--digits", "25", "--json")
        j = json.loads(r.stdout)
        few = self.value(*words, "--digits", "6")["value"]
        self.assertEqual((r.returncode, j["status"], j["digits"], j["value"][:len(few) - 1]), (2, "undecided", 22, few[:-1]))
        self.assertIn("22 digits are certified here, 25 were asked for", j["note"])
        self.assertIn("error", j)

    def test_usage_errors(self):
        self.refuses(64, "nearest is 'archard.K'", "eval", "arhcard.K", "n=3")
        self.refuses(64, "missing key 'n'", "eval", "archard.K")
        self.refuses(64, "given twice", "eval", "archard.K", "n=3", "n=4")
        self.refuses(64, "unknown key 'm'", "eval", "archard.K", "m=3")
        self.refuses(64, "not KEY=VALUE", "eval", "archard.K", "3")
        self.refuses(64, "either G or D and gamma", "eval", "peaks.fixed_point", "G=3", "D=1.5", "gamma=4")
        self.refuses(64, "D and gamma", "eval", "peaks.fixed_point", "D=1.5")
        self.refuses(64, "G does not determine", "eval", "weierstrass.bound", "G=3")
        self.refuses(64, "nearest is 'archard_K'", "table", "archrd_K")
        self.refuses(64, "--out", "table", "all")
        self.refuses(64, "xls", "table", "archard_K", "--format", "xls")
        self.refuses(64, "nearest is", "nonsense")
        self.refuses(64, "--help")

    def test_bad_input(self):
        self.refuses(65, "not a number", "eval", "archard.K", "n=three")
        self.refuses(65, "denominator", "eval", "hertz.half_width", "load=1/0")
        self.refuses(65, "empty", "eval", "hertz.half_width", "load=")
        self.refuses(65, "must be an integer", "eval", "archard.K", "n=-1")
        self.refuses(65, "must be > 0", "eval", "hertz.half_width", "load=0")
        self.refuses(65, "must be > 1", "eval", "weierstrass.bound", "D=1.5", "gamma=1")
        self.refuses(65, "must be > 1 and < 2", "eval", "weierstrass.bound", "D=2", "gamma=5")
        self.refuses(65, "from 1 to 10000", "eval", "archard.K_inf", "--digits", "0")
        self.refuses(65, "from 1 to 10000", "eval", "archard.K_inf", "--digits", "10001")
        self.refuses(65, "from 1 to 10000", "table", "archard_K", "--digits", "10001")
        self.refuses(65, "from 1 to 10000", "table", "archard_K", "--digits", "0")

    def test_list(self):
        j = json.loads(run("list", "--json").stdout)
        self.assertGreaterEqual(len(j), 19)
        for q in j:
            self.assertEqual(set(q) & {"name", "equation", "unit", "domain", "inputs", "description"},
                             {"name", "equation", "unit", "domain", "inputs", "description"})
        text = run("list").stdout
        for q in j:
            self.assertIn(q["name"], text)

    def test_one_quantity_says_what_is_proven_where_and_how(self):
        for q in json.loads(run("list", "--json").stdout):
            page = run("list", q["name"]).stdout.partition("To judge your own code")[0]
            squeezed = " ".join(page.split())
            self.assertLessEqual(max(map(len, page.splitlines()[1:])), 80, page)
            self.assertTrue(q["certified"], q["name"])
            for c in q["certified"]:
                self.assertIn(f"{c['where']}: ", squeezed)
                if c["proof"]:
                    self.assertIn(f"; proof {c['proof']}, second look: {c['second_look']}; they share {c['shares']}", squeezed)
                    self.assertTrue(c["second_look"] and c["shares"] and c["digits"], c)
                else:
                    self.assertIn("only estimated", squeezed)
        proofs = {c["proof"] for c in json.loads(run("list", "contact.area", "--json").stdout)["certified"]}
        self.assertGreaterEqual(proofs, {"arcsine", "force-weighted-chebyshev", "proven-levels", "limit-of-scales", ""})

    def test_tables_are_whole_or_absent_and_checked_byte_for_byte(self):
        with tempfile.TemporaryDirectory() as folder:
            out = os.path.join(folder, "new")
            self.assertEqual(run("table", "archard_K", "archard_delta", "--out", out).returncode, 0)
            self.assertEqual(sorted(os.listdir(out)), ["archard_K.txt", "archard_delta.txt"])
            self.assertEqual(run("table", "archard_K", "--out", out, "--check").returncode, 0)
            path = os.path.join(out, "archard_K.txt")
            with open(path) as f:
                text = f.read()
            with open(path, "w") as f:
                f.write(text.replace("0.41655", "0.41656"))
            r = run("table", "archard_K", "--out", out, "--check")
            self.assertEqual(r.returncode, 1)
            self.assertIn("archard_K.txt differs: line", r.stderr)
            with open(path, "wb") as f:
                f.write(os.urandom(100))
            r = run("table", "archard_K", "--out", out, "--check")
            self.assertEqual((r.returncode, r.stderr.count("\n")), (65, 1), r.stderr)
            self.assertEqual(run("table", "archard_delta", "--out", os.path.join(folder, "none"), "--check").returncode, 66)

    def test_tables_are_listed_with_what_the_checker_confirmed(self):
        with tempfile.TemporaryDirectory() as out:
            self.assertEqual(run("table", "archard_K", "archard_delta", "hertz_pressure", "--out", out).returncode, 0)
            listed = lambda: {line.split()[0]: " ".join(line.split()[4:]) for line in run("table", "--out", out).stdout.splitlines()}  # noqa: E731
            self.assertEqual({listed()[name] for name in ("archard_K", "hertz_pressure")}, {"not checked"})
            hashes = {}
            for name in ("archard_K", "archard_delta", "hertz_pressure"):
                with open(os.path.join(out, name + ".txt")) as f:
                    hashes[name] = json.loads(next(line for line in f if line.startswith("# {"))[2:])["sha256"]
            path = os.path.join(out, "coverage.json")
            entry = {"rows": 70, "confirmed": 69, "all_digits": 60, "wrong": 0, "digits": 12}
            with open(path, "w") as f:
                json.dump([{"table": "archard_K", "sha256": hashes["archard_K"], **entry}, {"table": "archard_delta", "sha256": "0" * 64, **entry},
                           {"table": "hertz_pressure", "sha256": hashes["hertz_pressure"], **entry}], f)
            said = listed()
            self.assertEqual([said[name] for name in ("archard_K", "archard_delta", "hertz_pressure", "hertz_gap")],
                             ["69 of 70 rows, 12 digits", "not checked since it changed", "not checked as a whole", "not stored"])
            for bad in ("{", "5", '[{"table": "archard_K"}]', '[{"table": 5}]', "[" * 100000):
                with open(path, "w") as f:
                    f.write(bad)
                self.refuses(65, "not a file of coverage", "table", "--out", out)
        self.refuses(64, "names of tables are missing", "table", "--check")

    def test_no_table_of_the_working_folder_is_believed(self):
        """Where the program has no stored tables it computes; a file that happens to lie where it is called is not one of them."""
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "bin", "touchstone")
            os.mkdir(os.path.dirname(program))
            shutil.copy(PROGRAM, program)
            for name, text in (("archard_K_inf.txt", "no table"), ("coverage.json", "no coverage"), ("answers", "0.3913876963120100\n")):
                with open(os.path.join(folder, name), "w") as f:
                    f.write(text)
            call = lambda *words: subprocess.run([program, *words], capture_output=True, text=True, cwd=folder, timeout=600)  # noqa: E731
            judged = call("judge", "archard_K_inf", "--answers", "answers")
            self.assertEqual(judged.returncode, 0, judged.stdout + judged.stderr)
            listed = call("table")
            self.assertEqual(listed.returncode, 0, listed.stderr)
            self.assertIn("not stored", listed.stdout)

    def test_a_manifest_follows_its_tables(self):
        with tempfile.TemporaryDirectory() as out:
            manifest = os.path.join(out, "manifest.txt.json")
            with open(manifest, "w") as f:
                json.dump({"version": "0", "tables": [{"name": "archard_delta", "file": "archard_delta.txt", "sha256": "0"}]}, f)
            self.assertEqual(run("table", "archard_K", "archard_K", "archard_delta", "--out", out).returncode, 0)
            with open(manifest) as f:
                entries = json.load(f)["tables"]
            self.assertEqual([e["name"] for e in entries], ["archard_delta", "archard_K"])
            self.assertNotEqual(entries[0]["sha256"], "0")

    def test_cannot_write(self):
        with tempfile.TemporaryDirectory() as folder:
            blocker = os.path.join(folder, "file")
            with open(blocker, "w") as f:
                f.write("x")
            self.refuses(73, "cannot write", "table", "archard_K", "--out", os.path.join(blocker, "sub"))
        for words in (["eval", "archard.K_inf"], ["table", "westergaard_pressure"]):
            with open("/dev/full", "w") as full:
                r = subprocess.run([PROGRAM, *words], stdout=full, stderr=subprocess.PIPE, text=True)
            self.assertEqual((r.returncode, r.stderr.count("\n")), (73, 1))

    def test_a_table_reads_with_the_standard_library_alone(self):
        rows = [line.split() for line in run("table", "westergaard_half_width").stdout.splitlines() if not line.startswith("#")]
        self.assertGreater(len(rows), 100)
        for load, value, error, forced in rows:
            self.assertTrue(0 < float(load) <= 1 and 0 < float(value) <= 0.5 and float(error) >= 0 and float(forced) >= 0)

    @staticmethod
    @functools.cache
    def ledger():
        return json.loads(run("paper", "--json").stdout)  # as a whole it takes seconds: judged once

    def test_paper(self):
        j = self.ledger()
        ids = {e["id"]: e for e in j}
        for n in range(20):
            self.assertEqual(ids[f"table1.n{n:02d}"]["verdict"], "verified")
        for e in j:
            self.assertLessEqual({"id", "verdict", "method", "statement", "reason", "correction"}, set(e))

    def test_paper_explains_one_entry_and_shows_its_controls(self):
        entry = run("paper", "7.17")
        self.assertEqual(entry.returncode, 0)
        for word in ("refuted", "misprint", "Gamma(3/2 - 2^-(i+2))", "controls", "touchstone paper 7.17"):
            self.assertIn(word, entry.stdout)
        controls = run("paper", "--controls")
        self.assertEqual(controls.returncode, 0)
        self.assertNotIn("SURVIVES", controls.stdout)
        self.assertIn(" 0 survive", controls.stdout)
        unknown = run("paper", "7.99")
        self.assertEqual((unknown.returncode, unknown.stdout, unknown.stderr.count("\n")), (65, "", 1))

    def test_paper_has_every_numbered_equation(self):
        ids = {e["id"]: e for e in self.ledger()}
        for section, last in ((2, 20), (3, 10), (5, 14), (6, 8), (7, 21), (8, 7), (9, 4)):
            for k in range(1, last + 1):
                self.assertIn(f"{section}.{k}", ids)
        for e in ids.values():
            self.assertEqual(e["failures"], [])
            if e["verdict"] == "refuted":
                self.assertTrue(e["correction"] and e["reason"])
                # what corrects a sentence may rest on a step in words; what corrects an equation may not
                self.assertIn(e["correction_verdict"], ("proved", "argued") if e["id"].startswith("text.") else ("proved",))

    def test_no_progress_when_stderr_is_not_a_terminal(self):
        self.assertEqual(run("table", "archard_K").stderr, "")


if __name__ == "__main__":
    unittest.main()
