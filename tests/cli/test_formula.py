#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Emitted formulas are compiled, run and judged by the oracle: they reach the library's own accuracy.

usage: test_formula.py TOUCHSTONE LIBRARY_FORMS
"""
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

try:
    import sympy
except ImportError:
    sympy = None

PROGRAM, LIBRARY_FORMS = sys.argv.pop(1), sys.argv.pop(1)
# quantities whose formula takes the inputs of a table, and how many those are
INPUTS = {"westergaard.half_width": 1, "westergaard.pressure": 2, "hertz.pressure": 2, "westergaard.exceedance": 2, "westergaard.density": 2, "westergaard.energy": 1,
          "hertz.half_width": 1, "westergaard.gap": 2, "westergaard.mean_gap": 1, "hertz.gap": 2, "weierstrass.bound": 2, "peaks.f": 1, "peaks.fixed_point": 1}
TABLES = pathlib.Path(__file__).resolve().parents[2] / "data/reference"
# The emitted code does what the library does; only another libm or a fused product made of two plain ones may differ in the last bits. Measured: 2 ulps
# at most (westergaard.mean_gap), and beside a density's edge 5 where rounding the inputs alone forces 1.5e9. An ulp is that of the larger of the two answers:
# they may lie on either side of a power of two, as at westergaard.exceedance, p = load = 1 - 2^-53, where Python's stand-in for fma rounds 3 - 2^-52 - 2^-106
# the other way than fma does and the answers are 1/2 + 2^-53 and 1/2 - 2^-54, each one ulp from the value, 1/2 - 2e-38.
SAME_ULPS, SAME_SHARE_OF_FORCED = 2, 1e-8


def run(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=300)


def formula(quantity, language, *words):
    r = run("formula", quantity, *words, "--as", language)
    assert r.returncode == 0, r.stderr
    return r.stdout


def name_of(quantity):
    return quantity.replace(".", "_")


def fpcore_value(source, inputs):
    """The first FPCore of a text at binary64 inputs: just enough of the standard to know what was written."""
    words = re.findall(r'"[^"]*"|[()\[\]]|[^\s()\[\]]+', re.sub(r"^;.*$", "", source, flags=re.M))

    def read():
        word = words.pop(0)
        if word not in "([":
            return word
        group = []
        while words[0] not in ")]":
            group.append(read())
        words.pop(0)
        return group

    def value(e, at):
        if isinstance(e, str):
            return at[e] if e in at else math.pi if e == "PI" else float(Fraction(e))
        operation, *rest = e
        if operation == "if":
            return value(rest[1 if value(rest[0], at) else 2], at)
        if operation == "let*":
            at = dict(at)
            for name, bound in rest[0]:
                try:
                    at[name] = value(bound, at)
                except (ValueError, ZeroDivisionError):
                    at[name] = math.nan
            return value(rest[1], at)
        a = [value(x, at) for x in rest]
        if operation == "-" and len(a) == 1:
            return -a[0]
        known = {"+": lambda x, y: x + y, "-": lambda x, y: x - y, "*": lambda x, y: x * y, "/": lambda x, y: x / y, "<": lambda x, y: x < y, "fmin": min, "fmax": max, "tgamma": math.gamma}
        return known.get(operation, getattr(math, operation, None))(*a)

    _, names, *_, body = read()
    assert len(names) == len(inputs), (names, inputs)
    return value(body, dict(zip(names, inputs)))


class Formula(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def worst(self, quantity, *command, expected=0):
        r = run("judge", name_of(quantity), "--ulps", "4", "--json", "--", *command)
        self.assertEqual(r.returncode, expected, (quantity, command, r.stdout[:400], r.stderr))
        return json.loads(r.stdout)["ulps"][1]

    def rows(self, quantity):
        """Of a stored table: the inputs as a judged program reads them, and what rounding them forces."""
        lines = [line.split() for line in (TABLES / f"{name_of(quantity)}.txt").read_text().splitlines() if not line.startswith("#")]
        return "".join(" ".join(float(w).hex() for w in row[:INPUTS[quantity]]) + "\n" for row in lines), [float(row[-1]) for row in lines]

    def answers(self, inputs, *command):
        r = subprocess.run(command, input=inputs, capture_output=True, text=True, timeout=60)
        self.assertEqual(r.returncode, 0, (command, r.stderr))
        return [float.fromhex(w) if "x" in w else float(w) for w in r.stdout.split()]

    def judge_all(self, command):
        """The oracle passes it, and row by row it answers what the library's own double forms answer."""
        for quantity in INPUTS:
            with self.subTest(quantity=quantity):
                emitted = command(quantity)
                self.worst(quantity, *emitted)
                inputs, forced = self.rows(quantity)
                mine, library = self.answers(inputs, *emitted), self.answers(inputs, LIBRARY_FORMS, quantity)
                self.assertEqual((len(mine), len(library)), (len(forced), len(forced)))
                for row, f, a, b in zip(inputs.splitlines(), forced, mine, library):
                    self.assertLessEqual(abs(a - b), max(SAME_ULPS, SAME_SHARE_OF_FORCED * f) * math.ulp(max(abs(a), abs(b))), (row, a, b))

    def test_c_reaches_the_library(self):
        def command(quantity):
            source, binary = self.folder / f"{quantity}.c", self.folder / f"{quantity}_c"
            count = INPUTS[quantity]
            main = ("#include <stdio.h>\nint main(void)\n{\n  double x[2];\n" + f"  while (scanf(\"%lf\", x) == 1{' && scanf(' + chr(34) + '%lf' + chr(34) + ', x + 1) == 1' if count == 2 else ''})\n"
                    + f"    printf(\"%a\\n\", {name_of(quantity)}({', '.join(f'x[{k}]' for k in range(count))}));\n  return 0;\n}}\n")
            source.write_text(formula(quantity, "c") + main)
            subprocess.run(["cc", "-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", "-o", binary, source, "-lm"], check=True)
            return [str(binary)]
        self.judge_all(command)

    def test_c_as_printed_loses_digits(self):
        source, binary = self.folder / "printed.c", self.folder / "printed"
        source.write_text(formula("westergaard.pressure", "c") + '#include <stdio.h>\nint main(void) { double x, s; while (scanf("%lf %lf", &x, &s) == 2) printf("%a\\n", westergaard_pressure_as_printed(x, s)); return 0; }\n')
        subprocess.run(["cc", "-O2", "-o", binary, source, "-lm"], check=True)
        self.assertGreater(self.worst("westergaard.pressure", str(binary), expected=1), 100)

    @unittest.skipUnless(shutil.which("gfortran"), "no gfortran")
    def test_fortran_reaches_the_library(self):
        def command(quantity):
            source, binary = self.folder / f"{quantity}.f90", self.folder / f"{quantity}_f"
            count = INPUTS[quantity]
            arguments = ", ".join(f"x({k + 1})" for k in range(count))
            main = (f"program answers\n  use {name_of(quantity)}_formula\n  implicit none\n  character(len=400) :: line\n  real(dp) :: x({count})\n  integer :: status\n  do\n"
                    f"    read (*, '(a)', iostat=status) line\n    if (status /= 0) exit\n    read (line, *) x\n    write (*, '(es25.17e3)') {name_of(quantity)}({arguments})\n  end do\nend program\n")
            source.write_text(formula(quantity, "fortran") + main)
            subprocess.run(["gfortran", "-std=f2018", "-O2", "-Wall", "-Wno-unused-function", "-ffp-contract=off", "-J", self.folder, "-o", binary, source], check=True)
            # list-directed READ knows no hexadecimal: the pipe in between writes shortest decimals, which read back as the same numbers
            bridge = self.folder / "bridge.py"
            bridge.write_text("import subprocess, sys\nrows = [[float.fromhex(w) for w in line.split()] for line in sys.stdin]\n"
                              "r = subprocess.run(sys.argv[1:], input=''.join(' '.join(map(repr, x)) + '\\n' for x in rows), capture_output=True, text=True)\nsys.stdout.write(r.stdout)\nsys.exit(r.returncode)\n")
            return [sys.executable, str(bridge), str(binary)]
        self.judge_all(command)

    def test_python_reaches_the_library(self):
        def command(quantity):
            source = self.folder / f"{name_of(quantity)}.py"
            source.write_text(formula(quantity, "python") + f"\nimport sys\nfor line in sys.stdin:\n    print(float({name_of(quantity)}(*map(float.fromhex, line.split()))).hex())\n")
            return [sys.executable, str(source)]
        self.judge_all(command)

    @unittest.skipUnless(shutil.which("octave-cli"), "no octave")
    def test_octave_agrees(self):
        scope = {}
        exec(formula("westergaard.pressure", "python"), scope)
        (self.folder / "westergaard_pressure.m").write_text(formula("westergaard.pressure", "octave"))
        points = [(x / 16, load / 8) for x in range(8) for load in (1, 3, 7, 8, 12)]
        r = subprocess.run(["octave-cli", "--no-init-file", "--eval", f"cd('{self.folder}'); " + "".join(f"printf('%.17g\\n', westergaard_pressure({x!r}, {load!r}));" for x, load in points)],
                           capture_output=True, text=True, timeout=120)
        self.assertEqual(r.returncode, 0, r.stderr)
        for answer, point in zip(map(float, r.stdout.split()), points):
            expected = scope["westergaard_pressure"](*point)
            self.assertLessEqual(abs(answer - expected), 4e-16 * abs(expected), point)

    def test_scales_written_out(self):
        for quantity, words, inputs in (("archard.K", ("n=3",), {}), ("peaks.iterate", ("n=4",), {"load": 0.5, "G": 3.0}), ("archard.area", ("n=2",), {"load": 0.25, "G": 4.0}),
                                        ("segments.max_half_width", ("n=2",), {"load": 0.5, "G": 3.0}), ("archard.alpha", ("n=2",), {"D": 1.5}), ("archard.delta", ("n=5",), {}), ("archard.segments", ("n=3",), {"load": 0.25, "D": 1.5, "gamma": 4.0}),
                                        ("archard.segments_limit", ("n=3",), {"load": 0.25, "D": 1.5, "gamma": 4.0})):
            scope = {}
            exec(formula(quantity, "python", *words), scope)
            found = scope[name_of(quantity)](**inputs)
            right = json.loads(run("eval", quantity, *words, *(f"{k}={v.hex()}" for k, v in inputs.items()), "--json").stdout)
            self.assertLessEqual(abs(found - float.fromhex(right["binary64"])), 8e-16 * abs(found), quantity)

    def test_mathematics(self):
        text = formula("westergaard.half_width", "latex")
        self.assertIn("\\frac{\\operatorname{arctan2}\\left(\\sqrt{\\tilde p}", text)
        self.assertIn("\\arcsin", text)
        for quantity in INPUTS:
            for language in ("latex", "fpcore", "sympy", "julia", "octave"):
                text = formula(quantity, language)
                for opening, closing in ("()", "{}", "[]"):
                    if not (language == "octave" and opening == "["):
                        self.assertEqual(text.count(opening), text.count(closing), (quantity, language))
        self.assertTrue(formula("peaks.f", "fpcore").splitlines()[1].startswith("(FPCore (x)"))

    def telling_rows(self, quantity):
        """A few rows of a stored table away from edges, where a form that only mathematics makes right keeps most of its digits in binary64 too."""
        lines = [line.split() for line in (TABLES / f"{name_of(quantity)}.txt").read_text().splitlines() if not line.startswith("#")]
        count = INPUTS[quantity]
        good = [(list(map(float, row[:count])), row[count]) for row in lines if float(row[-1]) < 100 and all(0.02 <= abs(float(w)) <= 50 for w in row[:count])]
        self.assertGreater(len(good), 5, quantity)
        return good[::len(good) // 5]

    SCALES = ("peaks.iterate", "segments.max_half_width", "archard.area")

    def scale_30(self, quantity):
        point = {"load": 0.625, "G": 3.0}
        r = run("eval", quantity, "n=30", *(f"{k}={v!r}" for k, v in point.items()), "--digits", "30", "--json")
        return point, json.loads(r.stdout)["value"]

    def test_size_grows_with_the_operations(self):
        """Each part used twice would double the text at each scale: 3^30 of them."""
        for quantity in self.SCALES:
            for language in ("latex", "fpcore", "sympy", "c", "fortran", "python", "julia", "octave"):
                six, nine, twelve = (len(formula(quantity, language, f"n={n}")) for n in (6, 9, 12))
                self.assertLess(twelve - nine, 1.3 * (nine - six), (quantity, language))
                self.assertLess(len(formula(quantity, language, "n=30")), 11000, (quantity, language))

    def test_fpcore_means_the_quantity(self):
        for quantity in INPUTS:
            for inputs, value in self.telling_rows(quantity):
                found = fpcore_value(formula(quantity, "fpcore"), inputs)
                self.assertTrue(math.isclose(found, float(value), rel_tol=1e-9), (quantity, inputs, found, value))
        for quantity in self.SCALES:
            point, value = self.scale_30(quantity)
            self.assertTrue(math.isclose(fpcore_value(formula(quantity, "fpcore", "n=30"), list(point.values())), float(value), rel_tol=1e-12), quantity)

    @unittest.skipUnless(sympy, "no SymPy")
    def test_sympy_means_the_quantity(self):
        def close(quantity, scope, point, value):
            known = {scope[k]: sympy.Float(v, 60) for k, v in point.items() if k in scope}
            for part, expression in scope.get(f"{name_of(quantity)}_parts", []):
                known[part] = expression.xreplace(known).evalf(60)
            found = scope[name_of(quantity)].xreplace(known).evalf(60)
            self.assertLessEqual(abs(found - sympy.Rational(value)), 1e-18 * abs(sympy.Rational(value)), (quantity, point, found, value))
        for quantity in INPUTS:
            scope = {}
            exec(formula(quantity, "sympy"), scope)
            names = [q["inputs"] for q in json.loads(run("list", "--json").stdout) if q["name"] == quantity][0]
            for inputs, value in self.telling_rows(quantity):
                close(quantity, scope, dict(zip(names, inputs)), value)
        for quantity in self.SCALES:
            scope = {}
            exec(formula(quantity, "sympy", "n=30"), scope)
            close(quantity, scope, *self.scale_30(quantity))

    @unittest.skipUnless(shutil.which("blahtexml"), "no blahtexml")
    def test_latex_is_read(self):
        for quantity, words in [(q, ()) for q in INPUTS] + [(q, ("n=10",)) for q in self.SCALES]:
            for text in formula(quantity, "latex", *words).split("% ")[1:]:
                r = subprocess.run(["blahtexml", "--mathml"], input=text.partition("\n")[2], capture_output=True, text=True)
                self.assertNotIn("<error>", r.stdout, (quantity, text))
                self.assertIn("<mathml>", r.stdout)

    def test_brackets_open_at_once(self):
        """C99 promises 63, CPython takes 100, clang and Octave 256: a sum of many terms must not nest them all."""
        for quantity, words in [(q, ()) for q in INPUTS] + [(q, ("n=30",)) for q in ("archard.K", "archard.area", "archard.segments", "peaks.iterate", "segments.max_half_width")]:
            for language in ("c", "fortran", "python", "julia", "octave"):
                depth = deepest = 0
                for c in formula(quantity, language, *words):
                    depth += (c == "(") - (c == ")")
                    deepest = max(deepest, depth)
                self.assertLessEqual(deepest, 20, (quantity, language))

    def test_what_has_no_formula(self):
        for words, code, reason in ((("contact.area",), 65, "no closed formula"), (("archard.K",), 65, "give n=0"), (("archard.K", "n=31"), 65, "from 0 to 30"), (("archard.K", "n=x"), 65, "not an integer"),
                                    (("archard.K", "m=1"), 64, "only n"), (("peaks.f", "n=1"), 65, "has no n"), (("peaks.g",), 64, "nearest is 'peaks.f'")):
            r = run("formula", *words, "--as", "c")
            self.assertEqual((r.returncode, r.stdout), (code, ""), (words, r.stderr))
            self.assertIn(reason, r.stderr)
        self.assertEqual(run("formula", "peaks.f", "--as", "cobol").returncode, 64)
        self.assertEqual(run("formula", "peaks.f").returncode, 64)


if __name__ == "__main__":
    unittest.main(verbosity=1)
