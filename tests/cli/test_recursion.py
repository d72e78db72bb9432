#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How accurate the recursion (6.1)-(6.7) in double precision is: verify/subjects/recursion.cpp, judged scale by scale.

usage: test_recursion.py --touchstone PROGRAM --recursion PROGRAM --tables FOLDER
"""
import argparse
import json
import math
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


def judged(name):
    """{inputs: error in ulps} of all rows; strict: what rounded inputs force is worked out below, in closed form (in balls it takes minutes a row)."""
    with tempfile.TemporaryDirectory() as folder:
        reached = os.path.join(folder, "reached.json")
        r = subprocess.run([options.touchstone, "judge", options.tables / f"{name}.txt", "--strict", "--ulps", "1e6", "--absolute", "0", "--held-out", "0",
                            "--recheck", "0", "--json", "--baseline", reached, "--update-baseline", "--", options.recursion, name.replace("_", ".")],
                           capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=300)
        verdict = json.loads(r.stdout)
        if verdict["verdict"] != "pass":
            raise AssertionError((verdict.get("failed"), verdict["worst"][:2], r.stderr))
        with open(reached) as f:
            return {tuple(map(float.fromhex, k.split())): e for k, e in json.load(f)["ulps"].items()}


def forced(power, n, p, load, G):
    """Ulps that inputs off by half an ulp may cost what falls like (p_max - p)^power; p_n^max = G^(n+1) e_(n+1), (5.6)."""
    log_edge = math.log(load)
    for _ in range(int(n) + 1):
        log_edge = math.log(2 / G) + log_edge / 2
    y = p / math.exp((n + 1) * math.log(G) + log_edge)
    return power * y / (1 - y) * (1 + 2 ** -(n + 1) + n - 1 + 2**-n) if y < 1 else 0  # p, load, G


class Recursion(unittest.TestCase):
    def report(self, name, power=None):
        """Prints the errors by scale; gives them all, and those of distributions that forced() does not explain, as (inputs, own error)."""
        errors = judged(name)
        by_edge = {inputs: forced(power(inputs[0]), *inputs) if power else 0 for inputs in errors}
        scales = sorted({inputs[0] for inputs in errors})
        print(f"\n{name}: ulps off" + (", and beyond what rounded inputs force at the upper edge" if power else ""))
        print("   n  rows    worst   median" + ("   beyond" if power else ""))
        own = {inputs: e - by_edge[inputs] for inputs, e in errors.items()}
        for n in scales:
            here = [inputs for inputs in errors if inputs[0] == n]
            print(f"{n:4.0f}  {len(here):4}  {max(errors[i] for i in here):7.3g}  {statistics.median(errors[i] for i in here):7.3g}"
                  + (f"  {max(0, *(own[i] for i in here)):7.3g}" if power else ""))
        return errors, own

    def check_beyond(self, own):
        """Measured: at most 45 ulps (n = 18)."""
        for (n, p, load, G), e in own.items():
            self.assertLess(e, 6 + 4 * n, (n, p, load, G))

    def test_area(self):
        errors, _ = self.report("contact_area")
        self.assertGreater(len(errors), 200)
        self.assertLess(max(e for (n, *_), e in errors.items() if n <= 10), 30)  # measured 18.7
        self.assertLess(max(errors.values()), 300)  # 175
        self.assertLess(statistics.median(errors.values()), 20)  # 9

    def test_exceedance(self):
        _, own = self.report("contact_exceedance", lambda n: (n + 1) / 2)
        lost = [inputs for inputs in own if inputs[0] == 1 and inputs[1] < 1e-4 and inputs[2] == 1]
        self.assertEqual(len(lost), 1)
        e = own.pop(lost[0])
        print(f"not explained by its inputs: {e:.3g} ulps at n = 1, p = {lost[0][1]:.3g}, load 1: qag misses a layer of width ~ p and says nothing")
        self.assertLess(e, 3e4)  # measured 1.6e4
        self.assertGreater(e, 1e3)  # if it is gone, say so no more
        self.check_beyond(own)

    def test_density(self):
        _, own = self.report("contact_density", lambda n: abs(n - 1) / 2)
        self.check_beyond(own)


if __name__ == "__main__":
    unittest.main(verbosity=2)
