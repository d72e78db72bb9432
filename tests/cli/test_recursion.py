#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How accurate the recursion (6.1)-(6.7) in double precision is: verify/subjects/recursion.cpp, judged scale by scale.

usage: test_recursion.py --touchstone PROGRAM --recursion PROGRAM --tables FOLDER
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import unittest

arguments = argparse.ArgumentParser()
arguments.add_argument("--touchstone", required=True)
arguments.add_argument("--recursion", required=True)
arguments.add_argument("--tables", required=True, type=pathlib.Path)
options, sys.argv[1:] = arguments.parse_known_args()


def judged(name, allowed):
    """{inputs: error in ulps} of all rows; the judge must pass it within `allowed` beyond what rounded inputs force."""
    with tempfile.TemporaryDirectory() as folder:
        reached = os.path.join(folder, "reached.json")
        r = subprocess.run([options.touchstone, "judge", options.tables / f"{name}.txt", "--ulps", str(allowed), "--absolute", "0", "--held-out", "0",
                            "--recheck", "0", "--json", "--baseline", reached, "--update-baseline", "--", options.recursion, name.replace("_", ".")],
                           capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=300)
        verdict = json.loads(r.stdout)
        if verdict["verdict"] != "pass":
            raise AssertionError((verdict.get("failed"), verdict["worst"][:2], r.stderr))
        with open(reached) as f:
            return {tuple(map(float.fromhex, k.split())): e for k, e in json.load(f)["ulps"].items()}


class Recursion(unittest.TestCase):
    def report(self, name, allowed):
        errors = judged(name, allowed)
        scales = sorted({inputs[0] for inputs in errors})
        print(f"\n{name}: ulps off\n   n  rows    worst   median")
        for n in scales:
            here = [e for inputs, e in errors.items() if inputs[0] == n]
            print(f"{n:4.0f}  {len(here):4}  {max(here):7.3g}  {statistics.median(here):7.3g}")
        return errors

    def test_area(self):
        errors = self.report("contact_area", 1000)  # 2e-13
        self.assertGreater(len(errors), 200)
        self.assertLess(statistics.median(errors.values()), 40)

    def test_exceedance(self):
        self.report("contact_exceedance", 1e5)  # at load 1 and small p, qag misses a layer of width ~ p in its variable

    def test_density(self):
        self.report("contact_density", 1000)


if __name__ == "__main__":
    unittest.main(verbosity=2)
