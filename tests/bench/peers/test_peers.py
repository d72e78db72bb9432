#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bench against peers runs, shows a wrong answer as wrong, and docs/peers.md is what its generator makes of docs/peers.json.

usage: test_peers.py PROGRAM
"""
import json
import os
import pathlib
import stat
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parents[2]
PROGRAM = os.path.abspath(sys.argv.pop(1))
sys.path.insert(0, str(HERE))

try:
    import mpmath
except ImportError:
    mpmath = None

import formulas
import page


class Page(unittest.TestCase):
    def test_the_page_is_made_from_the_results(self):
        results = json.loads((SOURCE / "docs/peers.json").read_text())
        self.assertEqual(page.text(results), (SOURCE / "docs/peers.md").read_text(), "python3 tests/bench/peers/page.py docs/peers.json > docs/peers.md")
        self.assertLessEqual(set(results["items"]), set(page.SECTIONS))

    def test_a_short_answer_is_no_right_one(self):
        wrong = {"verdict": "wrong", "right": 3, "median": 1.0}
        row = {"tools": {"Touchstone": {"verdict": "right", "right": 50, "median": 2.0}, "quick": wrong}}
        self.assertEqual(page.best(row), "Touchstone")
        self.assertIn("**wrong** (3 digits", page.cell(wrong))


class Formulas(unittest.TestCase):
    def test_constants_and_repeated_parts_are_taken_out(self):
        text = formulas.Text("sqrt(1-x)*pi/3+1/sqrt(1-x)", formulas.Gp)
        self.assertEqual(text.constants, [("c0", "Pi")])
        self.assertEqual([part for part in text.parts if "sqrt" in part[1]], [("t1", "sqrt(t0)")])
        self.assertEqual(formulas.Text("x^(-1/2)*4^(-2)", formulas.Python).constants, [("c0", "((-mpf('1'))/mpf('2'))"), ("c1", "(mpf('4')**(-2))")])


@unittest.skipIf(mpmath is None, "no mpmath")
class Turns(unittest.TestCase):
    def test_tools_that_are_close_take_turns_and_one_slow_process_decides_nothing(self):
        import integrals
        calls = []

        def process(tool, times):
            def runs():
                calls.append(tool)
                median = times[min(calls.count(tool), len(times)) - 1]
                return {"value": "1", "first": median, "median": median, "least": median, "most": median, "runs": 5}
            return runs

        how = {"a": process("a", [9.0, 2.0, 2.0, 2.0, 2.0]), "b": process("b", [4.0]), "far": process("far", [99.0]),
               "none": lambda: {"refused": "no value"}}
        found = {tool: runs() for tool, runs in how.items()}
        integrals.by_turns(how, found)
        self.assertEqual(found["a"]["median"], 2.0)  # and not 9
        self.assertEqual((found["a"]["least"], found["a"]["most"], found["a"]["runs"]), (2.0, 9.0, 5 * integrals.ROUNDS))
        self.assertEqual(found["b"]["median"], 4.0)
        self.assertEqual(calls, ["a", "b", "far"] + ["a", "b"] * (integrals.ROUNDS - 1))


@unittest.skipIf(mpmath is None, "no mpmath")
class Driver(unittest.TestCase):
    def run_quickly(self, path):
        """Item (a) with the programs that were not built left out."""
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(PROGRAM, os.path.join(folder, "touchstone"))
            done = subprocess.run([sys.executable, str(HERE / "peers.py"), folder, "--quick", "--only", "a", "--out", folder], capture_output=True, text=True,
                                  timeout=120, env=dict(os.environ, PATH=path))
            self.assertEqual(done.returncode, 0, done.stderr)
            rows = json.loads(pathlib.Path(folder, "peers.json").read_text())["items"]["a"]["rows"]
            return {row["tool"]: row for row in rows}, pathlib.Path(folder, "peers.md").read_text()

    def test_runs_and_shows_a_wrong_answer(self):
        with tempfile.TemporaryDirectory() as folder:
            liar = pathlib.Path(folder, "gp")
            liar.write_text("#!/bin/sh\necho 0.391387696312019\n")
            liar.chmod(liar.stat().st_mode | stat.S_IXUSR)
            rows, text = self.run_quickly(f"{folder}:{os.environ['PATH']}")
        self.assertEqual(rows["Touchstone"]["right"], 30)
        self.assertEqual(rows["mpmath"]["right"], 30)
        self.assertEqual(rows["PARI/GP"]["right"], 13)
        self.assertIn("| PARI/GP |", text)
        self.assertIn("13 of 30 **wrong**", text)
        self.assertEqual(rows["Arb"]["refused"], "not built")


if __name__ == "__main__":
    unittest.main()
