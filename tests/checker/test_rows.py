# SPDX-License-Identifier: MIT
"""The checker on files of rows: what `touchstone eval` writes of many kinds is right, and no forged one is."""
import argparse
import collections
import decimal
import hashlib
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

parser = argparse.ArgumentParser()
parser.add_argument("--checker", required=True, type=pathlib.Path)
parser.add_argument("--program", required=True, help="that writes files of rows")
known, rest = parser.parse_known_args()
sys.path.insert(0, str(known.checker))
import at_once  # noqa: E402
import check  # noqa: E402
import exact_text  # noqa: E402
import rows as rows_file  # noqa: E402
import units  # noqa: E402

WAYS = ("nearest", "up", "down", "zero", "away")
ASKED = {  # of each quantity ranges, and how many rows are open, for reasons that are said
    "westergaard.pressure": (["x=0,1/4,-0.3,1", "load=0.1,0x1.8p-1,7/3"], 3),  # x = 1 is refused
    "westergaard.density": (["p=0,0.25,1/3,1e-40", "load=0.1,2"], 0),
    "westergaard.half_width": (["load=1e-300,1/3,1,-1,abc"], 2),  # refused
    "archard.K": (["n=0:4:1"], 0),
    "archard.area": (["n=0,3", "load=1e-3", "G=sqrt(10),2^0.25,3"], 0),
    "archard.alpha": (["n=0:3:1", "D=1.3,5/4"], 0),
    "weierstrass.profile": (["x=0,1/3,0.8", "D=1.3", "gamma=4,2.5"], 0),
    "peaks.iterate": (["n=0,3", "load=1/2,3", "D=1.5,1.1", "gamma=4,10"], 0),
    "peaks.fixed_point": (["G=sqrt(2),9^(1/2),3/sqrt(2),1.1"], 0),
    "segments.max_half_width": (["n=0,2", "load=0.3", "G=1.5,10^(1/2)"], 0),
    "contact.area": (["n=0,1", "load=0.3,2", "G=3,sqrt(3)"], 2),  # n = 1 and a root
}


def run(*arguments, **more):
    return subprocess.run([sys.executable, known.checker / "check.py", *map(str, arguments)], capture_output=True, text=True, timeout=300, **more)


def sealed(text, instead=None, **changes):
    """a file of --out with other rows, statuses counted anew unless the changes say otherwise, and its sha256 made anew"""
    lines = text.splitlines()
    said, rows = json.loads(lines[5][2:]), lines[7:] if instead is None else instead
    count = collections.Counter(row.partition(" # ")[2].partition(":")[0] for row in rows)
    said |= {"rows": len(rows), "status": max(count, key=lambda status: (rows_file.STATUSES + [status]).index(status)), "statuses": count,
             "sha256": hashlib.sha256("".join(row + "\n" for row in rows).encode("utf-8", "surrogateescape")).hexdigest()} | changes
    said = {key: value for key, value in said.items() if value is not ...}
    return "\n".join([*lines[:5], f"# {json.dumps(said)}", lines[6], *rows]) + "\n"


class Rows(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "t.txt"

    def evaluated(self, *arguments, out=True, stdin=None):
        words = [known.program, "eval", *map(str, arguments), *(["--out", self.path] if out else [])]
        result = subprocess.run(words, capture_output=True, text=True, input=stdin)
        if not out:
            self.path.write_text(result.stdout)
        return self.path.read_text()

    def found(self, text, code, *numbers, said=""):
        """exit code, and numbers of rows right, open and wrong"""
        self.path.write_text(text)
        result = at_once.ask(check, self.path)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(len(result.stderr.splitlines()), 0 if not code else 1, result.stderr)
        self.assertIn(said, result.stderr)
        if numbers:
            self.assertEqual(tuple(map(int, result.stdout.splitlines()[1].split()[2:5])), numbers, result.stderr)
        else:
            self.assertEqual(len(result.stdout.splitlines()), 1)

    def test_what_the_program_writes_is_right(self):
        for quantity, (ranges, still_open) in ASKED.items():
            for k, way in enumerate(WAYS):
                with self.subTest(quantity, way=way):
                    text = self.evaluated(quantity, *ranges, "--round", way, "--digits", (20, 1, 7, 3, 60)[k], out=k % 2)
                    rows = sum(" # " in line for line in text.splitlines() if line[0] != "#")
                    self.assertGreater(rows, 3)
                    self.found(text, 0, rows - still_open, still_open, 0)

    def test_quantities_are_said_to_be_what_the_program_says(self):
        listed = json.loads(subprocess.run([known.program, "list", "--json"], capture_output=True, check=True).stdout)
        said = {quantity["name"]: (quantity["equation"], quantity["unit"], quantity["description"]) for quantity in listed}
        self.assertEqual(said, units.SAID)

    def test_binary64_and_resumed_and_interrupted(self):
        self.found(self.evaluated("archard.area", "n=1", "load=0.1,1/3", "G=sqrt(10),2.5", "--binary64"), 0, 4, 0, 0)
        # a row of four columns ends the table after those before it
        broken = self.evaluated("archard.area", "--rows", "-", stdin="# n load G\n1 0.1 3\n1 0.2 3\n1 2 3 4\n1 0.3 3\n")
        self.assertIn('"complete":false', broken)
        self.found(broken, 0, 2, 0, 0)
        rows = self.path.with_name("rows.txt")
        rows.write_text("# n load G\n1 0.1 3\n1 0.2 3\n1 1D-3 3\n")
        self.found(self.evaluated("archard.area", "--rows", rows, "--resume"), 0, 3, 0, 0)
        self.found(self.evaluated("archard.area", "--rows", "-", stdin="# n load G\n", out=False), 0, 0, 0, 0)

    def test_what_is_undecided_is_open(self):
        text = self.evaluated("archard.K", "n=1:3:1", "--max-precision", 8)
        self.assertIn("undecided: ", text)
        self.found(text, 0, 0, 3, 0)

    def test_claims_of_certificates_are_found_for_roots(self):
        certificate = self.path.with_name("certificate")
        subprocess.run([known.program, "certificate", "contact.area", "n=2", "load=1/10", "G=10^(1/2)", "--digits", "6", "--out", certificate], check=True)
        for surface in (["G=sqrt(10)"], ["D=1.5", "gamma=10"]):
            self.evaluated("contact.area", "n=2", "load=0.1,0.2", *surface, "--digits", 5)
            result = run("--certificate", certificate, self.path)
            self.assertEqual((result.returncode, result.stdout.split()[-5:]), (0, ["2", "1", "1", "0", "5"]), result.stderr)

    def test_forged_rows_are_wrong(self):
        text = self.evaluated("archard.area", "n=1", "load=0.1,0.2", "G=3", "--digits", 5)
        first, second = text.splitlines()[7:]
        self.assertEqual(first, "1 0.1 3 0.051432 5e-07 # certified")
        for row in ("1 0.1 3 0.051433 5e-07 # certified", "1 0.1 3 0.051431 5e-07 # certified",  # a digit
                    "1 0.1 3 0.051432 6e-07 # certified", "1 0.1 3 0.0514 5e-05 # certified",  # fewer digits
                    "1 0.1 3 0.05143226 5e-09 # certified", "1 0.1 3 0.051432 0 # exact", "1 0.1 3 0.051432 5e-07 # exact",
                    "1 0.1 3 0.051432 0 # certified", "1 0.1 3 0 5e-7 # certified", "1 0.1 3 nan inf # certified", "1 0.1 3 nan inf # estimated",
                    "1 0.1 3 0.051432 -5e-07 # certified",
                    "1 0.1 3 0.051433 5e-07 # estimated", "1 0.1 3 0.051433 5e-07 # undecided: why", "1 0.1 3 0.051432 5e-07 # refused: why",
                    "1.5 0.1 3 0.051432 5e-07 # certified", "1 -0.1 3 0.051432 5e-07 # certified", "1 0.1 1 0.051432 5e-07 # certified",
                    "1 0.1 sqrt(1/2) 0.051432 5e-07 # certified", "1 .. 3 0.051432 5e-07 # certified", "1 0.1- 3 0.051432 5e-07 # certified",
                    "1 1/0 3 0.051432 5e-07 # certified"):
            with self.subTest(row):
                self.found(sealed(text, [row, second]), 1, 1, 0, 1, said="t.txt: row 1: ")
        for row in ("1 0.1 3 0.051432 5e-07 # estimated", "1 0.1 3 0.051432 5e-07 # undecided: why", "1 0.1 3 nan inf # undecided: why",
                    "1 0.1 3 nan inf # refused: why", "1 0.1 2^(1/99) 0.051432 5e-07 # certified", "1 1e999999 3 0.051432 5e-07 # certified",
                    "1 sqrt(2) 3 0.051432 5e-07 # certified", "1 9^9^9 3 0.051432 5e-07 # certified",
                    "1 " + "7*" * 30000 + "7 3 0.051432 5e-07 # certified"):
            with self.subTest(row[:50]):
                self.found(sealed(text, [row, second]), 0, 1, 1, 0)
        for row in ("1 0.1 3 0.051432 5e-07 # certified: why", "1 0.1 3 nan inf # refused", "1 0.1 3 nan inf # unknown", "1 0.1 3 0.051432 5e-07",
                    "1 0.1 0.051432 5e-07 # certified", "1 0.1 3  0.051432 5e-07 # certified", "1 0.1 3\xa00.051432 5e-07 # certified",
                    "1 0.1 3 4 # 0.051432 5e-07 # certified", "x", "# 1 0.1 3 0.051432 5e-07 # certified"):
            with self.subTest(row):
                self.found(sealed(text, [row, second], status="certified"), 65, said="row 1 is not 5 columns")

    def test_only_what_is_exact_has_no_error(self):
        """An error of 0 is written 0, and no value has more digits than the file says."""
        text = self.evaluated("peaks.f", "x=0.0625,0.01,119", "--digits", 2)
        exact = text.splitlines()[7:]
        self.assertEqual(exact, ["0.0625 0.5 0 # exact", "0.01 0.2 0 # exact", "119 1.2e+02 0 # exact"])
        self.found(text, 0, 3, 0, 0)
        for row in (*(f"0.0625 0.50 {error} # {status}" for error in ("0.0", "-0", "0e0", "+0", "00", "-0.0") for status in ("certified", "exact", "estimated")),
                    "0.015625 0.250 0 # exact", "0.00390625 0.125 0 # exact", "1000 1001 0 # exact", "0.0625 0.50 -5e-3 # estimated"):
            with self.subTest(row):
                self.found(sealed(text, [row, exact[1]]), 1, 1, 0, 1)

    def test_no_row_hides_in_a_reason(self):
        """Behind characters that end a line to some readers; a name of a file, that reasons have, may be of any others."""
        text = self.evaluated("archard.area", "n=1", "load=0.1,0.2", "G=3", "--digits", 5)
        for code, between in ((65, "\t"), (65, "\v"), (65, "\f"), (65, "\x1c"), (65, "\x1d"), (65, "\x1e"), (65, "\x85"), (65, "\u2028"), (65, "\u2029"), (65, "\0"), (65, "\x7f"), (65, "\x1b[2J"),
                              (65, "\x9b2J"), (65, "\udc85"), (0, "größe Å \u2027 "), (0, " \xa0"), (0, "gr\udcf6\udcdfe ")):
            row = f"1 0.1 3 nan inf # refused: why{between}1 0.1 3 0.061432 5e-07 # certified"
            with self.subTest(row):
                self.path.write_bytes(sealed(text, [row], status="refused", statuses={"refused": 1}).encode("utf-8", "surrogateescape"))
                result = at_once.ask(check, self.path)
                self.assertEqual((result.returncode, len(result.stderr.splitlines())), (code, bool(code)), result.stderr)

    def test_a_bound_is_on_its_side(self):
        for quantity, where, down, up in (("archard.area", ["n=1,1", "load=0.1", "G=3"], "0.051432", "0.051433"),
                                          ("archard.alpha", ["n=2,2", "D=1.23456789"], "-0.29321", "-0.29320")):
            negative = down.startswith("-")
            for way in WAYS[1:]:
                text = self.evaluated(quantity, *where, "--round", way, "--digits", 5)
                right, wrong = (up, down) if way == "up" or way == ("zero" if negative else "away") else (down, up)
                self.assertIn(f" {right} ", text)
                row, _ = text.splitlines()[7:]
                with self.subTest(quantity, way=way):
                    self.found(sealed(text, [row]), 0, 1, 0, 0)
                    self.found(sealed(text, [row.replace(right, wrong)]), 1, 0, 0, 1)
                    unit = "1e-05" if negative else "1e-06"
                    self.found(sealed(text, [row.replace(unit, f"2{unit[1:]}")]), 1, 0, 0, 1)  # more than a unit

    def test_a_certified_value_is_the_rounded_one(self):
        """Next to powers of ten, where the last digit counts ten times less on the side of zero; at ties; and where a value has no more digits."""
        for way, digits, right, wrong in (
                ("nearest", 2, ("0.00248004 0.10 5e-3", "0.0025 0.10 5e-3", "0.00275625 0.10 5e-3", "0.0024800401 0.10 4e-4", "0.00227 0.095 5e-4", "0.00247506249 0.099 5e-4",
                                "0.00247506251 0.10 5e-3", "0.0024750625 0.10 5e-3", "98.5 1.0e+2 5", "98.4 99 5e-1"),
                 ("0.00227 0.10 5e-3", "0.00227 0.096 5e-4", "0.00247506249 0.10 5e-3", "0.0024750625 0.099 5e-4", "0.00275625 0.11 5e-3", "0.0025 0.099 1e-3", "98.5 99 5e-1",
                  "98.4 1.0e+2 5", "98.49999 100 5e-1")),
                ("nearest", 1, ("2.5 4 5e-1", "3.5 4 5e-1", "8.5 1e1 5", "14 2e1 5", "24 2e1 5"), ("2.5 3 5e-1", "3.5 5 5e-1", "8.5 9 5e-1", "14 1e1 5", "24 3e1 5", "8.4 1e1 5")),
                ("nearest", 3, ("0.002483 0.0997 5e-5",), ("0.002483 0.100 5e-4",)),
                ("up", 2, ("0.01 0.20 1e-2", "0.0021 0.092 1e-3", "0.0025 0.10 1e-2", "0.00249 0.10 1e-2", "0.0026 0.11 1e-2", "0.0100000001 0.21 1e-2"),
                 ("0.01 0.21 1e-2", "0.0021 0.10 1e-2", "0.0025 0.11 1e-2", "0.0024 0.10 1e-2", "0.0100000001 0.20 1e-2")),
                ("away", 2, ("0.01 0.20 1e-2", "0.0021 0.092 1e-3"), ("0.01 0.21 1e-2", "0.0021 0.10 1e-2", "0.01 0.19 1e-2")),
                ("down", 2, ("0.01 0.20 1e-2", "0.0025 0.10 1e-2", "0.0024 0.097 1e-3", "0.0030 0.10 1e-2"),
                 ("0.01 0.19 1e-2", "0.0025 0.099 1e-3", "0.0024 0.10 1e-2", "0.003025 0.10 1e-2", "0.01 0.20 2e-2")),
                ("zero", 2, ("0.01 0.20 1e-2", "0.0025 0.10 1e-2"), ("0.01 0.19 1e-2", "0.0025 0.099 1e-3", "0.003025 0.10 1e-2"))):
            text = self.evaluated("peaks.f", "x=3,4", "--round", way, "--digits", digits)
            for code, rows in ((0, right), (1, wrong)):
                for row in rows:
                    with self.subTest(row, way=way, digits=digits):
                        self.found(sealed(text, [f"{row} # certified"]), code, 1 - code, 0, code)

    def test_rounding_is_that_of_another_library(self):
        """Python's decimal, on values of both signs, exact ones and roots, many of them next to a power of ten or a tie: never another digit."""
        seed = 20261127
        chosen = random.Random(seed)
        of_library = dict(zip(WAYS, (decimal.ROUND_HALF_EVEN, decimal.ROUND_CEILING, decimal.ROUND_FLOOR, decimal.ROUND_DOWN, decimal.ROUND_UP)))
        for way in WAYS:
            for quantity, inputs in (("peaks.f", ["x=3,4"]), ("archard.alpha", ["n=2,2", "D=1.5"])):
                digits, right, wrong = chosen.randint(1, 4), [], []
                for _ in range(60):
                    near = Fraction(chosen.choice((1, 1, 10, 10, chosen.randrange(1, 10**digits))), 10**digits)  # tenths, or some digits
                    value = near + chosen.choice((-1, 0, 0, 1)) * Fraction(chosen.choice((1, 5, 10, chosen.randrange(1, 100))), 10 ** (digits + chosen.randint(1, 3)))
                    if not 0 < value < 1:
                        continue
                    if quantity == "archard.alpha":
                        value, typed = -value, f"2 {1 + value * Fraction(4, 5)}"  # (1 - D) 5/4
                    else:
                        typed = str(value * value / 4)
                    numerator, denominator = decimal.Decimal(value.numerator), decimal.Decimal(value.denominator)
                    if quantity == "peaks.f" and chosen.random() < 0.3:  # a root that is no fraction
                        square = value * value + Fraction(chosen.choice((-4, 4)), 10**17 + 1)
                        many, typed = decimal.Context(prec=80), str(square / 4)
                        numerator, denominator = many.sqrt(many.divide(decimal.Decimal(square.numerator), decimal.Decimal(square.denominator))), decimal.Decimal(1)
                    few = decimal.Context(prec=digits, rounding=of_library[way])
                    rounded = few.divide(numerator, denominator)
                    below, above = rounded.next_minus(few), rounded.next_plus(few)
                    for cell, rows in ((rounded, right), (below, wrong), (above, wrong)):
                        unit = decimal.Decimal(1).scaleb(cell.adjusted() - digits + 1)
                        rows.append(f"{typed} {cell:.{digits - 1}e} {unit / (2 if way == 'nearest' else 1)} # certified")
                self.assertGreater(len(right), 20)
                text = self.evaluated(quantity, *inputs, "--round", way, "--digits", digits)
                with self.subTest(quantity, way=way, digits=digits, seed=seed):
                    self.found(sealed(text, right), 0, len(right), 0, 0)
                    self.path.write_text(sealed(text, wrong))
                    result = at_once.ask(check, self.path)
                    said = {line.split(": ")[-1] for line in result.stderr.splitlines()}
                    self.assertEqual((result.returncode, [row for row in wrong if row not in said]), (1, []))

    def test_what_a_file_says_of_itself_is_so(self):
        text = self.evaluated("archard.area", "n=1", "load=0.1,-1", "G=3", "--digits", 5)
        self.found(sealed(text), 0, 1, 1, 0)
        for key, value in (("rows", 1), ("rows", True), ("status", "certified"), ("statuses", {"certified": 2}), ("statuses", {"certified": 1, "refused": True}),
                           ("complete", 1), ("complete", ...), ("sha256", "0" * 64), ("digits", 6), ("digits", "5"), ("digits", 5.0), ("rounding", "up"), ("rounding", ["up"]),
                           ("input_format", "binary64"), ("equation", "7.13"), ("unit", "1"), ("description", "x"), ("quantity", "archard.K"), ("quantity", ["x"]),
                           ("inputs", ["load", "n", "G"]), ("inputs", ["n", "load", "D", "gamma"]), ("inputs", 3), ("name", "x"), ("version", ...), ("more", 1)):
            with self.subTest(key, value=value):
                self.found(sealed(text, **{key: value}), 65)
        said = "contact area in the Hertzian approximation"
        self.assertEqual(text.count(said), 2)
        self.found(text.replace(said, "contact area of any surface"), 65, said="description")
        for old, new in (("values of", "value of"), ("archard.area\n", "archard.areas\n"), ("0.1 is 1/10", "0.1 is 0.1"), ("to nearest", "up"), ("5 significant", "15 significant"),
                         ("is not (nor", "is (and"), ("# n load G value error", "# load n G value error"), ("# n load G value error", "# n load G error value"),
                         ("# n load", "# note\n# n load"), ('"digits":5', '"digits":6,"digits":5'), ('"complete":true', '"complete":' + "[" * 100000),
                         ('"digits":5', '"digits":' + "9" * 10**6), (re.search('"version":"[0-9.]+"', text)[0], '"version":NaN'), ("\n", "\r\n"), (" # certified\n", " # certified\n# {}\n")):
            with self.subTest(old, new=new[:30]):
                self.found(text.replace(old, new, -1 if old == "\n" else 1), 65)
        self.found(text[:-1], 65)
        self.found("\n".join(text.split("\n")[:5]) + "\n", 65)

    def test_a_file_that_was_written_through(self):
        text = self.evaluated("archard.K", "n=1,2", out=False)
        *lines, last = text.splitlines()
        self.found(text, 0, 2, 0, 0)
        for rest in ([], [last, last], ["# {}"], [last.replace('"complete"', '"digits":20,"complete"')], [last.replace('"complete":true', '"sha256":""')]):
            self.found("\n".join([*lines, *rest]) + "\n", 65)

    def test_where_else_files_come_from(self):
        rows = self.path.with_name("größe.txt")
        rows.write_text("# n load G\n1 0.1 3\n1 -1 3\n")
        self.found(self.evaluated("archard.area", "--rows", rows, "--digits", 5), 0, 1, 1, 0)
        coverage = self.path.with_name("coverage.json")
        result = run("--coverage", coverage, self.path)
        self.assertEqual((result.returncode, coverage.read_text()), (65, "[\n\n]\n"))
        with open(self.path) as file:
            self.assertEqual(run("/dev/stdin", stdin=file).returncode, 0)
        # 1.1 as a binary64 number: gamma^(D-1) is no fraction, and no power of such a size is taken
        self.found(self.evaluated("segments.count", "n=1,2", "load=0.1", "D=1.1", "gamma=4", "--binary64", "--digits", 5), 0, 1, 1, 0)

    def test_numbers_are_read_exactly(self):
        for text, number in (("0.1", "1/10"), ("+.5", "1/2"), ("5.", "5"), ("-1/3", "-1/3"), ("1e-3", "1/1000"), ("0x1.8p-3", "3/16"), ("0XfF", "255"), ("2^-5", "1/32"), ("-2^2", "-4"),
                             ("2^3^2", "512"), ("(1/3)*6", "2"), ("9^(1/2)", "3"), ("sqrt(2)*sqrt(8)", "4"), ("4^0.25*sqrt(2)", "2"), ("0.5/0.25/4", "1/2"), ("sqrt(0)", "0"), ("0^(1/16)", "0"), ("0^2", "0"), ("0^-(1/2)", None), ("-(1-0)", None),
                             ("(-2)^3", "-8"), ("2^-(-1)", "2"), ("10e2p", None), ("", None), ("1..2", None), ("1e", None), ("1/0", None), ("0^0", None), ("0^-1", None), ("sqrt(-1)", None), ("2^sqrt(2)", None),
                             ("1_0", None), ("inf", None), ("0x", None), ("0x.p1", None), ("1/-3", None), ("--1", None), ("(1", None), ("(" * 99 + "1" + ")" * 99, None), ("²", None)):
            with self.subTest(text):
                if number is None:
                    self.assertRaises(ValueError, exact_text.exact, text)
                else:
                    self.assertEqual(exact_text.exact(text), (Fraction(number), 1))
        for text, root in (("sqrt(10)", (10, 2)), ("10^(2/4)", (10, 2)), ("2^0.25", (2, 4)), ("3/sqrt(2)", (Fraction(9, 2), 2)), ("2^(1/3)*sqrt(2)", (32, 6))):
            self.assertEqual(exact_text.exact(text), root, text)
        for text in ("1e1000000", "9^9^9", "2^(1/65)", "7*" * 20000 + "7", "-sqrt(2)", "*".join(["3^300000"] * 3)):
            self.assertRaises(exact_text.TooLarge, exact_text.exact, text)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *rest])
