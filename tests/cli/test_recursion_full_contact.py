#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How accurate the recursion in double precision is where full contact occurs: verify/subjects/recursion_full_contact.cpp against the
reference tables, scale by scale. The tables have 10 to 30 digits: half a unit of the last one is taken off.

usage: test_recursion_full_contact.py --recursion PROGRAM --tables FOLDER
"""
import argparse
import math
import pathlib
import statistics
import subprocess
import sys
import unittest
from fractions import Fraction

arguments = argparse.ArgumentParser()
arguments.add_argument("--recursion", required=True)
arguments.add_argument("--tables", required=True, type=pathlib.Path)
options, sys.argv[1:] = arguments.parse_known_args()


def answers(quantity, rows):
    sent = "".join(" ".join(x.hex() for x in row) + "\n" for row in rows)
    r = subprocess.run([options.recursion, quantity], input=sent, capture_output=True, text=True, timeout=300, check=True)
    return [float.fromhex(line) for line in r.stdout.split()]


def ulps(answer, value, error):
    """At least so many ulps of the true value is the answer off."""
    return float(max(Fraction(0), abs(Fraction(answer) - Fraction(value)) - Fraction(error)) / Fraction(math.ulp(float(value)))) if float(value) else 0.0


class Recursion(unittest.TestCase):
    def report(self, quantity, *tables, wanted=lambda inputs: True):
        """{inputs: ulps}, printed by scale."""
        rows = [line.split() for name in tables for line in (options.tables / f"{name}.txt").read_text().splitlines() if not line.startswith("#")]
        rows = [(tuple(map(float, fields[:-3])), fields[-3], fields[-2]) for fields in rows]
        rows = [row for row in rows if wanted(row[0])]
        given = answers(quantity, [inputs for inputs, _, _ in rows])
        self.assertEqual(len(given), len(rows))
        self.assertTrue(all(map(math.isfinite, given)))
        errors = {inputs: ulps(a, value, error) for a, (inputs, value, error) in zip(given, rows)}
        print(f"\n{quantity}, {', '.join(tables)}: ulps off\n   n  rows    worst   median")
        for n in sorted({inputs[0] for inputs in errors}):
            here = [e for inputs, e in errors.items() if inputs[0] == n]
            print(f"{n:4.0f}  {len(here):4}  {max(here):7.3g}  {statistics.median(here):7.3g}")
        return errors

    def test_area(self):
        errors = self.report("contact.area", "contact_area_full", "contact_area_heavy")
        self.assertGreater(len(errors), 200)
        self.assertLess(max(errors.values()), 20000)  # 2e-12; measured 6600
        self.assertLess(max(e for (n, *_), e in errors.items() if n <= 4), 200)

    def test_exceedance(self):
        errors = self.report("contact.exceedance", "contact_exceedance_scale_1")
        lines = [line.split() for line in (options.tables / "contact_density_scale_1.txt").read_text().splitlines() if not line.startswith("#")]
        density = {tuple(map(float, fields[:-3])): float(fields[-3]) for fields in lines}
        share = dict(zip(errors, answers("contact.exceedance", errors)))
        # p q/Q is what a relative change of p costs: 10^6 next to the end of the support; load and G cost about the same
        own = {inputs: e - 4 * inputs[1] * density[inputs] / share[inputs] for inputs, e in errors.items()}
        # beside a logarithm of the density the ends of both waves nearly meet: qag stops at some 1e-10 and says nothing
        beside = {(n, p, load, G) for n, p, load, G in own if load > 1 and min(abs(p - load - 1 + G), abs(p - load + 1 - G)) < 1e-7 * p}
        print(f"beyond what rounded inputs force: {max(e for i, e in own.items() if i not in beside):.3g}; next to a logarithm: {max(own[i] for i in beside):.3g}")
        self.assertLess(max(e for i, e in own.items() if i not in beside), 1e5)  # measured 2e4, at 1e-3 from a logarithm
        self.assertLess(max(own[i] for i in beside), 1e7)
        errors = self.report("contact.exceedance", "contact_exceedance_full", wanted=lambda inputs: inputs[0] == 2)
        self.assertLess(max(errors.values()), 20000)

    def test_inputs_of_all_sizes_have_an_answer(self):
        rows = [(n, load, G) for n in (0.0, 1.0, 3.0) for load in (1e-300, 0.5, 1.0, 1 + 1e-9, 100.0, 1e6) for G in (1.01, 1.5, 2.0, 2 + 1e-9, 16.0)]
        for (n, load, G), a in zip(rows, answers("contact.area", rows)):
            self.assertTrue(0 <= a <= 1 + 1e-12, (n, load, G, a))


if __name__ == "__main__":
    unittest.main(verbosity=2)
