#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The oracle attacked: tables that lie, bounds that bound nothing, subjects that cheat. Each must be caught.

usage: test_attacks.py --touchstone PROGRAM --subjects FOLDER --library LIB
"""
import argparse
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

arguments = argparse.ArgumentParser()
arguments.add_argument("--touchstone", required=True)
arguments.add_argument("--subjects", required=True)
options, sys.argv[1:] = arguments.parse_known_args()
sys.argv[1:] = []
BROKEN = os.path.join(options.subjects, "subject_broken")
LIBRARY_FORMS = os.path.join(options.subjects, "subject_library_forms")


def run(*words):
    return subprocess.run([options.touchstone, "judge", *words], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=100)


def split(text):
    """(header lines, row lines)"""
    lines = text.splitlines(keepends=True)
    first = next(i for i, line in enumerate(lines) if not line.startswith("#"))
    return lines[:first], lines[first:]


def resealed(head, rows):
    """The table with the hash and row count that belong to its rows: a forger would do that."""
    body = "".join(rows)
    digest = hashlib.sha256(body.encode()).hexdigest()
    text = re.sub(r'"sha256":"[0-9a-f]*"', f'"sha256":"{digest}"', "".join(head))
    return re.sub(r'"rows":\d+', f'"rows":{len(rows)}', text) + body


def edit(line, column, change):
    words = line.split()
    words[column] = change(words[column])
    return " ".join(words) + "\n"


def flip(number, place):
    digits = [i for i, c in enumerate(number.split("e")[0]) if c.isdigit()]
    i = digits[place]
    return number[:i] + str((int(number[i]) + 5) % 10) + number[i + 1:]


class Attacks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.table = cls.written(subprocess.run([options.touchstone, "table", "westergaard_pressure"], capture_output=True, text=True, check=True).stdout, "right")
        with open(cls.table) as f:
            cls.text = f.read()
        cls.head, cls.rows = split(cls.text)
        # at the peak, p/p* = 2 sqrt(load): no short exact number, and well conditioned
        cls.row = next(i for i, r in enumerate(cls.rows) if r.split()[:2] == ["0", "0.1"])

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def written(cls, text, name="attack"):
        path = os.path.join(cls.folder.name, name + ".txt")
        with open(path, "w") as f:
            f.write(text)
        return path

    def judged(self, table, *words):
        return run(table, "--json", "--recheck", "100000", *words, "--", LIBRARY_FORMS, "westergaard.pressure")

    def changed(self, column, change):
        rows = list(self.rows)
        rows[self.row] = edit(rows[self.row], column, change)
        return rows

    def test_the_right_table_passes(self):
        r = self.judged(self.table)
        self.assertEqual((r.returncode, json.loads(r.stdout)["verdict"]), (0, "pass"))

    def test_every_attack_on_a_table_is_caught(self):
        swapped = [" ".join([b, a, v, e, f]) + "\n" for a, b, v, e, f in (r.split() for r in self.rows)]
        other_order = [line.replace("# x load value", "# load x value").replace('"inputs":["x","load"]', '"inputs":["load","x"]') for line in self.head]
        attacks = {
            "a digit flipped": "".join(self.head + self.changed(2, lambda v: flip(v, 9))),
            "a digit flipped, hash made right": resealed(self.head, self.changed(2, lambda v: flip(v, 9))),
            "the last digit flipped, hash made right": resealed(self.head, self.changed(2, lambda v: flip(v, -1))),
            "a digit of an input flipped, hash made right": resealed(self.head, self.changed(1, lambda v: flip(v, -1))),
            "columns swapped, hash made right": resealed(self.head, swapped),
            "columns swapped in rows and header": resealed(other_order, swapped),
            "column names swapped alone": resealed([line.replace("# x load value", "# load x value") for line in self.head], self.rows),
            "cut off in a line": self.text[:-20],
            "cut off after a line": "".join(self.head + self.rows[:-1]),
            "cut off, row count made right": re.sub(r'"rows":\d+', f'"rows":{len(self.rows) - 1}', "".join(self.head)) + "".join(self.rows[:-1]),
            "no rows": "".join(self.head),
            "empty": "",
            "a row twice, hash made right": resealed(self.head, self.rows + [self.rows[self.row]]),
            "wrong hash": re.sub(r'"sha256":"....', '"sha256":"0000', self.text),
            "bound rounded inwards, hash made right": resealed(self.head, self.changed(3, lambda e: e.replace("5e", "4e"))),
            "bound made zero, hash made right": resealed(self.head, self.changed(3, lambda e: "0")),
            "bound made large, hash made right": resealed(self.head, self.changed(3, lambda e: "1e-5")),
            "bound larger than the value": resealed(self.head, self.changed(3, lambda e: "1e300")),
            "NaN bound": resealed(self.head, self.changed(3, lambda e: "nan")),
            "infinite bound": resealed(self.head, self.changed(3, lambda e: "inf")),
            "negative bound": resealed(self.head, self.changed(3, lambda e: "-" + e)),
            "what rounded inputs force made large, hash made right": resealed(self.head, self.changed(4, lambda f: "1e9")),
            "what rounded inputs force made unknown, hash made right": resealed(self.head, self.changed(4, lambda f: "-1")),
            "a NaN for what rounded inputs force": resealed(self.head, self.changed(4, lambda f: "nan")),
            "the last column cut off, hash made right": resealed(self.head, self.changed(4, lambda f: "")),
            "NaN value": resealed(self.head, self.changed(2, lambda v: "nan")),
            "infinite input": resealed(self.head, self.changed(0, lambda v: "inf")),
            "fewer digits than announced": resealed(self.head, self.changed(2, lambda v: v[:-3])),
            "input out of the domain": resealed(self.head, self.changed(0, lambda v: "0.75")),
            "another quantity's name": "".join(self.head).replace("westergaard.pressure", "hertz.pressure") + "".join(self.rows),
            "no quantity of ours": "".join(self.head).replace("westergaard.pressure", "nobody.knows") + "".join(self.rows),
        }
        for name, text in attacks.items():
            with self.subTest(name):
                self.assertNotEqual(text, self.text, "the attack changes nothing")
                r = self.judged(self.written(text))
                self.assertEqual((r.returncode, r.stdout), (65, ""), (name, r.stderr))
                self.assertEqual(r.stderr.count("\n"), 1, r.stderr)

    def test_no_code_fails_by_a_row_that_lies(self):
        table = self.written(resealed(self.head, self.changed(2, lambda v: flip(v, 9))))
        r = run(table, "--recheck", "0", "--", LIBRARY_FORMS, "westergaard.pressure")  # nothing sampled: the deciding row is certified anew
        self.assertEqual(r.returncode, 65, r.stdout)
        self.assertIn("certified is", r.stderr)

    def test_no_code_passes_by_what_one_row_says_that_inputs_force(self):
        # of the recursion, whose rows are not all certified again; of closed forms the worst rows are in any case
        with open(pathlib.Path(__file__).resolve().parents[2] / "data" / "reference" / "contact_area.txt") as f:
            head, rows = split(f.read())
        wrong = next(i for i, r in enumerate(rows) if r.split()[0] == "3" and float(r.split()[1]) < 1)
        answers = [float(r.split()[3]) for r in rows]
        answers[wrong] *= 1 + 1e-12
        file = self.written("".join(f"{a!r}\n" for a in answers), "answers")
        honest = run(self.written("".join(head + rows)), "--recheck", "0", "--answers", file)
        self.assertEqual(honest.returncode, 1, honest.stderr)
        rows[wrong] = edit(rows[wrong], 5, lambda f: "1e9")
        r = run(self.written(resealed(head, rows)), "--recheck", "0", "--answers", file)
        self.assertEqual((r.returncode, r.stdout), (65, ""), r.stderr)
        self.assertIn(f"row {wrong + 1} ", r.stderr)
        self.assertIn("ulps; it is", r.stderr)

    def test_a_subject_that_looks_its_answers_up(self):
        r = run(self.table, "--json", "--", BROKEN, "look-up", self.table)
        self.assertEqual(r.returncode, 1)
        j = json.loads(r.stdout)
        self.assertTrue(j["looked_up"])
        self.assertTrue(all(w["held_out"] for w in j["worst"]))
        self.assertIsNone(j["mixup"])

    def test_baselines(self):
        path = os.path.join(self.folder.name, "baseline.json")
        command = ("--", LIBRARY_FORMS, "westergaard.pressure")
        self.assertEqual(run(self.table, "--baseline", path, *command).returncode, 66)
        r = run(self.table, "--baseline", path, "--update-baseline", *command)
        self.assertEqual(r.returncode, 0, r.stderr)
        self.assertIn(f"{len(self.rows)} new", r.stderr)  # never silently
        self.assertEqual(run(self.table, "--baseline", path, *command).returncode, 0)
        # another code is worse somewhere
        printed = ("--", os.path.join(options.subjects, "subject_printed_formulas"), "westergaard.pressure")
        self.assertEqual(run(self.table, "--baseline", path, *printed).returncode, 1)
        with open(path) as f:
            good = f.read()
        key = next(iter(json.loads(good)["ulps"]))
        bound = re.escape(key) + r'": [^,\n]+'
        for name, text in {
            "infinite": re.sub(bound, key + '": Infinity', good), "overflowing": re.sub(bound, key + '": 1e999', good),
            "NaN": re.sub(bound, key + '": NaN', good), "null": re.sub(bound, key + '": null', good), "negative": re.sub(bound, key + '": -1', good),
            "a row gone": re.sub('"' + bound + ",\n", "", good), "another table's": good.replace('"sha256": "', '"sha256": "0'), "cut off": good[:-10], "empty": "",
        }.items():
            with self.subTest(name):
                self.assertNotEqual(text, good)
                with open(path, "w") as f:
                    f.write(text)
                r = run(self.table, "--baseline", path, *command)
                self.assertEqual((r.returncode, r.stderr.count("\n")), (65, 1), r.stderr)
        # nothing that is not finite gets into one
        with open(path, "w") as f:
            f.write(good)
        r = run(self.table, "--baseline", path, "--update-baseline", "--", sys.executable, "-c", "import sys\nfor _ in sys.stdin: print('nan')")
        self.assertEqual(r.returncode, 1)
        self.assertIn("no baseline is written", r.stderr)
        with open(path) as f:
            self.assertEqual(f.read(), good)
        # getting worse is said row by row
        r = run(self.table, "--baseline", path, "--update-baseline", *printed)
        self.assertIn("raised", r.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
