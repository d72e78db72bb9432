# SPDX-License-Identifier: MIT
"""The checker on the committed tables, on mutants of their rows, and on files that are no tables."""
import argparse
import contextlib
import hashlib
import io
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
from fractions import Fraction

parser = argparse.ArgumentParser()
parser.add_argument("--checker", required=True, type=pathlib.Path)
parser.add_argument("--tables", required=True, type=pathlib.Path)
parser.add_argument("--every-row", action="store_true", help="all rows of all tables, K_inf to 1000 digits too: some minutes")
parser.add_argument("--program", help="with --every-row: rows of the recursion too, by certificates that it writes: an hour")
known, rest = parser.parse_known_args()
sys.path.insert(0, str(known.checker))
import at_once  # noqa: E402
import check  # noqa: E402
import scale_one  # noqa: E402
import units  # noqa: E402

CLOSED = ["archard_K", "archard_alpha", "archard_area", "archard_delta", "archard_segments", "archard_segments_limit", "hertz_gap",
          "hertz_half_width", "hertz_pressure", "peaks_f", "peaks_fixed_point", "peaks_iterate", "segments_max_half_width",
          "weierstrass_bound", "weierstrass_profile", "westergaard_density", "westergaard_energy", "westergaard_exceedance",
          "westergaard_gap", "westergaard_half_width", "westergaard_mean_gap", "westergaard_pressure"]
ONE_INTEGRAL = ["contact_density_scale_1", "contact_exceedance_scale_1"]  # scale_one.py
SLOW = ["archard_K_inf", *ONE_INTEGRAL]  # all rows take a minute
RECURSION = ["contact_area", "contact_area_full", "contact_area_heavy", "contact_density", "contact_exceedance", "segments_count", "segments_density"]
LIMIT_LAWS = "G=3.1622776601683795", "G=2.23606797749979"  # partial contact
CERTIFIED = {"contact_area": (12, ""), "segments_count": (12, ""), "limit_ratio": (8, ""), "limit_constant": (8, ""),
             "contact_area_heavy": (8, ""), "contact_area_full": (8, ""),
             "contact_exceedance": (8, ""), "contact_density": (8, ""), "segments_density": (8, ""),
             "contact_exceedance_full": (8, ""), "contact_density_full": (8, ""), "limit_scale": (8, ""), "limit_gap": (8, ""),
             "limit_distance": (4, "G=3.1622776601683795", "limit.exceedance p=1 G=3/2 --digits 7", *(
                 f"contact.{what} load={Fraction(0.1)} G=3/2 n={n}{p} --digits 7" for n in (2, 5) for what, p in (("area", ""), ("exceedance", f" p={Fraction(3, 2) ** n}")))),
             "limit_constant_full": (8, *(f"G={G}" for G in (1.02, 1.03, 1.05, 1.0837983867343681, 1.1, 1.1220184543019633, 1.15, 1.2, 1.25, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 1.95, 2))),
             "limit_segments": (10, "G=3.1622776601683795", "G=1.5 --digits 9"), "limit_density": (8, *LIMIT_LAWS, "G=1.5 --digits 7"),
             **dict.fromkeys(("limit_exceedance", "limit_force"), (10, *LIMIT_LAWS, "G=1.5 --digits 9"))}  # to so many digits, by certificates of these rows, or of other claims


def run(*arguments, **more):
    return subprocess.run([sys.executable, known.checker / "check.py", *map(str, arguments)], capture_output=True, text=True, **more)


def comments(header, forced=False):
    """what stands above the JSON of a table, as lib/touchstone/table/format.cpp writes it"""
    estimated = header.get("status") == "estimated"
    how = "estimate (from how far the numerical methods named under routes part, no proof; 0: exact)" if estimated else "proven bound"
    lines = [f"Touchstone {'estimated' if estimated else 'certified'} reference table {header['name']}",
             f"{header.get('description')}; equation {header.get('equation')}; unit {header.get('unit')}",
             "Inputs are binary64 numbers in shortest round-trip decimal: each stands for the binary64 number it rounds to.",
             f"value: the true value rounded to nearest, {header['digits']} significant digits (fewer if exact). error: {how} of |value - true value|."]
    return "\n".join(f"# {line}" for line in lines + forced * ["forced: ulps of the value (absolute where it is 0) that rounding each real input once can cost a perfect code, to first order."])


class Checker(unittest.TestCase):
    def tables(self, names):
        return [known.tables / f"{name}.txt" for name in names]

    def test_no_row_is_wrong(self):
        limit = [] if known.every_row else ["--limit", 5]
        # of closed forms all rows are judged for the coverage below
        closed = self.tables([*CLOSED, *SLOW] if known.every_row else [CLOSED[0], *ONE_INTEGRAL])
        result = run(*limit, *closed, *self.tables(RECURSION))
        self.assertEqual(result.returncode, 0, result.stderr)
        lines = [line.split() for line in result.stdout.splitlines()[1:]]
        self.assertEqual(len(lines), len(closed) + len(RECURSION))
        for name, rows, right, still_open, wrong, _ in lines:
            self.assertGreater(int(right), 0, name)
            if name not in RECURSION:
                self.assertEqual((right, still_open, wrong), (rows, "0", "0"), name)

    def entries(self, path):
        return {entry["table"]: entry for entry in json.loads(path.read_text())}

    def test_coverage_is_what_the_checker_finds(self):
        """data/reference/coverage.json, which `touchstone table` shows: each entry is of the table as it stands, and what is found of it now."""
        kept, found = self.entries(known.tables / "coverage.json"), {}
        for name, entry in kept.items():
            header, rows = check.read(known.tables / f"{name}.txt")
            with self.subTest(table=name):
                self.assertEqual((entry["sha256"], entry["rows"], entry["wrong"]), (header["sha256"], len(rows), 0))
                self.assertLessEqual(entry["all_digits"], entry["confirmed"])
                self.assertTrue(name in CERTIFIED or name in CLOSED + RECURSION + SLOW)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "coverage.json"
            without = [name for name in kept if name not in CERTIFIED and (known.every_row or name not in SLOW)]
            result = run("--coverage", path, *self.tables(without))
            self.assertEqual(result.returncode, 0, result.stderr)
            for name, (digits, *parts) in CERTIFIED.items() if known.every_row and known.program else ():
                if name in kept:
                    files = [pathlib.Path(folder) / f"certificate{k}" for k in range(len(parts))]
                    for file, part in zip(files, parts):
                        what = part.split() if "." in part.partition("=")[0] else [name, *part.split()]
                        what += [] if "--digits" in what else ["--digits", str(digits)]
                        subprocess.run([known.program, "certificate", *what, "--out", file], check=True)
                    named = [word for file in files for word in ("--certificate", file)]
                    self.assertEqual(run(*named, "--coverage", path, *self.tables([name])).returncode, 0, name)
            found = self.entries(path)
        self.assertLessEqual(set(CLOSED), set(found))
        for name in CLOSED:
            self.assertEqual((found[name]["confirmed"], found[name]["wrong"]), (found[name]["rows"], 0), name)
        for name, entry in found.items():
            with self.subTest(table=name):
                self.assertEqual(entry, kept[name])

    def test_mutants_are_found(self):
        """One digit of one value changed by one, or an error bound halved twice: never confirmed."""
        seed = 20261122
        chosen = random.Random(seed)
        for name in CLOSED + ONE_INTEGRAL:
            header, rows = check.read(known.tables / f"{name}.txt")
            form, inputs = scale_one.FORMS[header["quantity"]], header["inputs"]
            for row in chosen.sample(rows, 3):
                cells = row.split()
                value = cells[len(inputs)]
                mantissa, e, exponent = value.partition("e")
                places = [i for i, c in enumerate(mantissa) if c.isdigit()]
                place = chosen.choice(places)
                digit = str((int(mantissa[place]) + chosen.choice([1, 9])) % 10)
                cells[len(inputs)] = mantissa[:place] + digit + mantissa[place + 1:] + e + exponent
                with self.subTest(seed=seed, table=name, row=row, mutant=cells[len(inputs)]):
                    self.assertIn(check.verdict(form, " ".join(cells), inputs)[0], ("wrong", "undecided"))

    def test_coq_has_the_theorems_that_the_ledger_names(self):
        """data/paper/coq.txt: each entry is in the ledger, each theorem is in its file, and Theorems.v prints what it assumes."""
        source = known.checker.parent
        entries = {line.split()[0] for line in (source / "data/paper/verdicts.txt").read_text().splitlines() if line[:1] not in "# "}
        printed = (source / "proofs/coq/Theorems.v").read_text()
        lines = [line.split(" ", 4) for line in (source / "data/paper/coq.txt").read_text().splitlines() if not line.startswith("#")]
        self.assertGreater(len(lines), 15)
        for entry, extent, theorem, file, *_ in lines:
            with self.subTest(entry=entry):
                self.assertIn(entry, entries)
                self.assertIn(extent, ("whole", "part"))
                self.assertRegex((source / file).read_text(), rf"(?m)^Theorem {theorem}\b")
                self.assertIn(f"Print Assumptions {theorem}.\n", printed)

    def test_what_is_no_table_is_refused(self):
        table = (known.tables / "westergaard_half_width.txt").read_text()
        lines = table.splitlines(keepends=True)
        first_row = next(i for i, line in enumerate(lines) if not line.startswith("#"))
        bad = {
            "empty": "", "no header": "1 2 3\n", "short": "".join(lines[:-1]), "crlf": table.replace("\n", "\r\n"),
            "digit": table.replace(lines[first_row], lines[first_row].replace("7", "8", 1)),
            "json": table.replace('"rows":', '"rows":}'), "binary": "\x00\xff" * 100,
            "unknown": table.replace("westergaard.half_width", "westergaard.nonsense"),
        }
        with tempfile.TemporaryDirectory() as folder:
            for name, text in bad.items():
                path = pathlib.Path(folder) / "t.txt"
                path.write_bytes(text.encode("latin-1"))
                result = at_once.ask(check, path)
                with self.subTest(name):
                    self.assertEqual(result.returncode, 65)
                    self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
                    self.assertNotIn("Traceback", result.stderr)
            self.assertEqual(run(pathlib.Path(folder) / "none").returncode, 65)

    def test_units_are_those_of_every_table(self):
        """Of the program's own tables, and none is missing: a quantity without one would be a KeyError."""
        self.assertEqual(set(units.SAID), set(check.with_certificates(scale_one.FORMS, [])))
        for path in known.tables.glob("*.txt"):
            header, _ = check.read(path)
            said = tuple(header[what] for what in ("equation", "unit", "description"))
            self.assertEqual(units.SAID.get(header["quantity"], said), said, path)

    def test_hostile_tables(self):
        """Well sealed, and written to crash the checker or to keep it for ever: one line a table or row, and soon."""
        header = {"name": "t", "quantity": "archard.alpha", "inputs": ["n", "D"], "input_format": "binary64", "digits": 3, "status": "certified"}
        iterate, half = {"quantity": "peaks.iterate", "inputs": ["n", "load", "G"]}, {"quantity": "westergaard.half_width", "inputs": ["load"]}
        peaks = {"quantity": "peaks.f", "inputs": ["x"]}
        area = {"quantity": "archard.area", "inputs": ["n", "load", "G"]}
        brackets = {"x": None}
        cases = {
            "brackets without end": (65, brackets, "0 1.5 0 0"), "inputs of another type": (65, {"inputs": 5}, "0 1.5 0 0"),
            "a quantity of another type": (65, {"quantity": ["a"]}, "0 1.5 0 0"), "a name of another type": (65, {"name": 5}, "0 1.5 0 0"),
            "a unit that it does not have": (65, {**half, "unit": "p*"}, "1 0.5 0"), "an equation of another": (65, {**half, "equation": ["2.7"]}, "1 0.5 0"),
            "a description of another": (65, {**half, "description": "certified by a stranger, for any wave at all"}, "0.5 0.250 5e-4"), "no description": (65, {**half, "description": ...}, "0.5 0.250 5e-4"),
            "no unit": (65, {**half, "unit": ...}, "1 0.5 0"), "no equation": (65, {**half, "equation": ...}, "1 0.5 0"),
            "no status": (65, {**half, "status": ...}, "1 0.5 0"), "exact, with an error": (65, {**half, "status": "exact"}, "0.5 0.250 1e-3"),
            "more digits than there are": (65, {**half, "digits": 40}, "0.5 0.250 1e-3"), "digits that are no number": (65, {**half, "digits": [3]}, "0.5 0.250 1e-3"), "a column too many": (65, half, "0.5 0.250 1e-3 0 wrong"),
            "no input format": (65, {**half, "input_format": ...}, "0.5 0.250 5e-4"), "inputs said to be exact": (65, {**half, "input_format": "exact"}, "0.5 0.250 5e-4"),
            "undecided, though all rows have their digits": (65, {**half, "status": "undecided"}, "0.5 0.250 5e-4"), "undecided, and one has not": (0, {**half, "status": "undecided"}, "0.5 0.25 5e-3"),
            "all is right": (0, half, "0.5 0.250 5e-4"), "certified, with an error of a unit of the last digit": (1, half, "0.5 0.250 1e-3"),
            "certified, with an error of the whole value": (1, half, "0.5 0.500 1"), "estimated, with that error": (0, {**half, "status": "estimated"}, "0.5 0.250 1e-3"),
            "inputs of another quantity": (65, {"inputs": ["n"]}, "0 1.5 0"),
            "inputs that changed places": (65, {**iterate, "inputs": ["load", "n", "G"]}, "2 1 3 0.5 0"), "an input by another name": (65, {**half, "inputs": ["gamma"]}, "1 1 0"), "a scale without end": (1, {}, "1e300 1.5 0 0"), "a long scale": (1, iterate, "1e15 0.5 2 1 0"),
            "a number of ten billion digits": (1, {}, "0 1.5 1e9999999999 0"), "a bound of as many": (1, {}, "0 1.5 1.00 1e-9999999999"), "out of the domain": (1, half, "-1 1 0"),
            "a value beyond all exponents of five digits": (0, area, "1000000 0.5 8.08240626924901 3.33e-907541 5e-907544"), "one more in its last digit": (1, area, "1000000 0.5 8.08240626924901 3.34e-907541 5e-907544"),
            "another": (0, {**area, "quantity": "archard.segments", "inputs": ["n", "load", "D", "gamma"]}, "1000000 2 1.1 5 1.09e+629073 5e+629070"),
            "a control character": (65, half, "1\x1b[2J 1 0"), "one in the header": (65, {**half, "name": "t\x7f"}, "0.5 0.250 5e-4"),
            **{f"columns parted by {blank!a}": (65, half, f"0.5{blank}0.250{blank}5e-4") for blank in "\t\v\f\x1c\x1d\x1e\x1f\x85\xa0\u2003"},
            **{f"an end of line {end!a}, to some": (65, half, f"0.5 0.250 5e-4{end}") for end in "\v\f\x1c\x85\u2028"},
            "a value that is a fraction": (1, half, "0.75 1/2 0.4"), "an error that is one": (1, half, "0.5 0.250 1/2000"),
            "digits that are a text": (65, {**half, "digits": "3", "status": "exact"}, "0.5 0.25 0"), "digits that are true": (65, {**half, "digits": True}, "0.5 0.2 5e-2"),
            **{f"{digits} digits, {status}": (65, {**half, "digits": digits, "status": status}, "0.5 0.250 5e-4") for digits in (-3, 0, 3.0) for status in ("estimated", "undecided")},
            **{f"{digits} digits, exact": (65, {**half, "digits": digits, "status": "exact"}, "0.5 0.25 0") for digits in (-3, 0)},
            **{f"rows: {rows!r}": (65, {**half, "rows": rows}, "0.5 0.250 5e-4") for rows in (1.0, True, "1", [1], None, 2, -1)},
            **{f"an error of {error}, {status}": (1, {**half, "digits": 2, "status": status}, f"0.5 0.25 {error}") for error in ("0.0", "-0", "0e0", "+0", "00", "-5e-4") for status in ("certified", "estimated")},
            "exact, with as many digits as there are": (0, {**half, "digits": 2, "status": "exact"}, "0.5 0.25 0"), "exact, in a certified table": (0, {**half, "digits": 2}, "0.5 0.25 0"),
            "exact, with more digits": (1, {**half, "digits": 1, "status": "exact"}, "0.5 0.25 0"), "more digits, in a certified table": (1, {**half, "digits": 1}, "0.5 0.25 0"),
            "no value in a table that is certified": (65, half, "0.5 nan inf"),
            "right to a unit of ten times less, and rounded": (0, {**peaks, "digits": 2}, "0.00227 0.095 5e-4"), "rounded up to a power of ten": (0, {**peaks, "digits": 2}, "0.00249 0.10 5e-3"),
            "below a power of ten, and not rounded": (1, {**peaks, "digits": 2}, "0.00227 0.10 5e-3"), "another of three digits": (1, peaks, "0.002483 0.100 5e-4"),
            "the same of an estimate, which promises no rounding": (0, {**peaks, "digits": 2, "status": "estimated"}, "0.00227 0.10 5e-3"),
            "two rows, both short of digits or right": (0, {**peaks, "digits": 2, "status": "undecided", "rows": 2}, "0.00227 0.1 5e-2\n0.00227 0.095 5e-4"),
            "undecided, but for a row with all digits and not rounded": (1, {**peaks, "digits": 2, "status": "undecided", "rows": 2}, "0.00227 0.1 5e-2\n0.00227 0.10 5e-3"),
            "undecided, and exact with more digits": (1, {**peaks, "digits": 2, "status": "undecided", "rows": 2}, "0.00227 0.1 5e-2\n0.00390625 0.125 0"),
            "a tie to the even digit": (0, {**peaks, "digits": 1}, "2.5 4 5e-1"), "a tie to the odd one": (1, {**peaks, "digits": 1}, "2.5 3 5e-1"),
        }
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "t.txt"

            def written(changes, row, **words):
                said = dict(zip(("equation", "unit", "description"), units.SAID.get(str({**header, **changes}["quantity"]), ("", "", ""))))
                sealed = {**header, **said, "rows": 1, **changes, "sha256": hashlib.sha256(f"{row}\n".encode()).hexdigest()}
                sealed = {key: value for key, value in sealed.items() if value is not ...}
                title = words.get("title", comments({**sealed, **said}, words.get("columns", "").endswith("forced")))
                columns = words.get("columns", " ".join([*map(str, sealed["inputs"] if isinstance(sealed["inputs"], list) else []), "value", "error"]))
                path.write_text(f"{title}\n# {json.dumps(sealed)}\n# {columns}\n{row}\n".replace("null", "[" * 100000 + "]" * 100000))
                return at_once.ask(check, path)

            for name, (code, changes, row) in cases.items():
                result = written(changes, row)
                with self.subTest(name):
                    self.assertEqual((result.returncode, len(result.stderr.splitlines())), (code, 1 if code else 0), result.stderr[-300:])
                    self.assertTrue((result.stderr.rstrip("\n") or " ").isprintable())
            for changes, row in ((area, "1000000 0.5 1e300 1.96e-299999701 5e-299999704"), ({}, "0 1.5 1e999999999 0"), ({}, "0 1.5 1.00 1e-999999999")):  # too long to be compared
                result = written(changes, row)
                self.assertEqual((result.returncode, result.stdout.split()[-4:], result.stderr.count(": undecided: ")), (0, ["0", "1", "0", "-"], 1), result.stderr)
            result = written({**half, "status": "undecided"}, "0.5 nan inf")  # as the program writes it where nothing is decided
            self.assertEqual((result.returncode, result.stdout.split()[-4:], result.stderr.count(": undecided: ")), (0, ["0", "1", "0", "-"], 1), result.stderr)
            for row, digits in (("0.5 0.2500 5e-4", "3"), ("0.5 0.7 1", "0")):  # a row that is right to no digit is not passed over
                self.assertEqual(written({**half, "status": "estimated"}, row).stdout.split()[-1], digits)
            self.assertEqual(written(half, "0.5 0.250 5e-4 0.5", columns="load value error forced").returncode, 0)
            true = comments({**header, **half, **dict(zip(("equation", "unit", "description"), units.SAID["westergaard.half_width"]))})
            changes = {"unit lambda": "unit metre", "table t": "table u", "to nearest": "down", "3 significant": "30 significant", "proven bound": "estimate",
                       "binary64 numbers": "exact", "shortest": "longest"}
            for words in ({"columns": "load error value"}, {"title": f"{true}\n# all of it proven"}, {"title": true.replace("\n# value", "\n# x\n# value")},
                          *({"title": true.replace(old, new)} for old, new in changes.items())):
                with self.subTest(words=words):
                    result = written(half, "0.5 0.250 5e-4", **words)
                    self.assertEqual((result.returncode, len(result.stderr.splitlines())), (65, 1), result.stderr[-300:])
            written(half, "0.5 0.250 5e-4")
            path.write_text(path.read_text().replace('"digits": 3', '"digits": 40, "digits": 3'))
            _, json_and_rest = path.read_text().replace('"digits": 40, ', "").split("# {")
            self.assertEqual(run(path).returncode, 65)  # which of both a reader takes is left open
            for text in (f"# {{{json_and_rest}"[:-1], f"{true}\n# {{{json_and_rest}"[:-1], f"{true}\n# {{{json_and_rest}"):  # only the last is whole
                path.write_text(text)
                self.assertEqual((run(path).returncode, "Traceback" in run(path).stderr), (65 if text[-1] != "\n" else 0, False))
            path.unlink()
            path.symlink_to("/dev/zero")
            self.assertEqual(run(path, timeout=60).returncode, 65)

    def test_rows_outside_of_the_domain_are_refused(self):
        """Inputs that a quantity does not take, and ends of supports, where a density has no value: never right; next to them it is."""
        cases = {
            "archard.K": ("2.75 0.42 1", "-1 1 1", "1000001 0.3 0.1"), "contact.area": ("2.5 1 3 1 1", "0 1 -7 1 0", "0 1 0.5 1 0", "0 1 1 1 0"),
            "contact.density": ("0.5 9 0.5 3 0 0", "0 3 2 3 0 0", "0 1 2 3 0 0", "0 1 0.25 3 0 0"), "contact.exceedance": ("0 -1 1 3 1 0",),
            "westergaard.density": ("1 0.25 0 0", "3 2 0 0", "1 2 0 0", "0 1 0 0", "2 1 0 0", "-1 0.5 0 0"), "westergaard.exceedance": ("-1 0.5 1 0",),
            "westergaard.half_width": ("0 0 0", "1.5 0.5 0"), "westergaard.pressure": ("1 1 2 0", "-0.75 1 1 0"), "westergaard.gap": ("1 0.5 1 1",),
            "segments.density": ("1 0.5 2 3 0 0", "1 0 1 3 0 0", "1 0.25 5 1 0 0", "0 0.5 0.5 3 0 0", "1 0.75 2 3 0 0", "1 0.25 1 4 0 0"),
            "segments.count": ("0 1 1.5 4 1 1", "1 1 2 4 4 0", "1 1 1.5 1 1 0"), "archard.segments": ("0 1 1.5 4 1 1",), "archard.alpha": ("1 2 -1.5 0",),
            "peaks.fixed_point": ("0.5 -2 0", "1 1 1"), "peaks.f": ("0 0 0",), "peaks.iterate": ("0 0 2 0 0",), "weierstrass.bound": ("3 2 -1 0",),
            "weierstrass.profile": ("0 1 2 2 1",), "hertz.half_width": ("0 0 0",),
            "limit.exceedance": ("0 3 1 0",), "limit.segments": ("0 3 1 0",), "limit.scale": ("1 1 3 0 0",)}
        right = {"westergaard.density": ("0 0.25 0 0", "1.5 0.25 0 0", "0 2 0 0", "4 2 0 0"), "contact.density": ("0 0 0.25 3 0 0", "0 0.5 2 3 0 0"),
                 "segments.density": ("1 0.5 1.5 3 0 0", "1 0 0.5 3 0 0", "1 0 2 3 0 0"), "westergaard.half_width": ("1 0.5 0",), "westergaard.pressure": ("-0.5 1 0 0",),
                 "hertz.pressure": ("7 1 0 0",), "westergaard.exceedance": ("0 1 1 0",), "contact.area": ("0 1 3 1 0",), "archard.delta": ("0 0.5 0",)}
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "t.txt"
            for code, rows_of in ((1, cases), (0, right)):
                for quantity, rows in rows_of.items():
                    equation, unit, description = units.SAID[quantity]
                    header = {"name": "t", "quantity": quantity, "equation": equation, "unit": unit, "description": description, "inputs": check.names_of(quantity), "input_format": "binary64",
                              "digits": 1, "rows": len(rows), "status": "estimated", "sha256": hashlib.sha256("".join(row + "\n" for row in rows).encode()).hexdigest()}
                    if all(row.endswith(" 0") for row in rows):
                        header["status"] = "exact"
                    path.write_text("\n".join([comments(header), "# " + json.dumps(header), "# " + " ".join([*header["inputs"], "value", "error"]), *rows]) + "\n")
                    result = at_once.ask(check, path)
                    with self.subTest(quantity):
                        self.assertEqual(result.returncode, code, result.stderr)
                        self.assertEqual(result.stdout.split()[-2 - bool(not code) * 2], str(len(rows)), result.stdout + result.stderr)

    def test_digits_are_those_that_the_error_leaves(self):
        for cell, error, digits in (("0.4199", "5e-5", 4), ("0.4199", "1e-4", 3), ("0.4199", "1e-2", 1), ("0.4199", "0.5", 0), ("4.1655E-1", "1e-30", 5), ("+4.1655e-1", "0", 5),
                                    ("-0.0041", "5e-5", 2), ("120", "0.5", 3), ("120", "5", 2), ("120", "10", 1), ("0", "0", 0)):
            self.assertEqual(check.digits_of(cell, check.Fraction(error)), digits, (cell, error))
        self.assertEqual(check.verdict(lambda: Fraction(1, 3), "0." + "3" * 10000 + " 1e-10000", [])[0], "undecided")  # as many as the program gives, of which it reads all

    def test_a_row_that_takes_too_long_stays_open(self):
        """The alarm ends the one row and no later one; those after it are judged as ever."""
        half_width, asked = scale_one.FORMS["hertz.half_width"], []

        def endless_at_first(*inputs):
            asked.append(inputs)
            while len(asked) == 1:
                pass
            return half_width(*inputs)

        def give_up(*_):
            self.fail("the alarm did not go off")

        out, table = io.StringIO(), str(known.tables / "hertz_half_width.txt")
        with unittest.mock.patch.dict(scale_one.FORMS, {"hertz.half_width": endless_at_first}), unittest.mock.patch.object(check, "PATIENCE", 1), \
                unittest.mock.patch.object(check.memory, "bound"), unittest.mock.patch.object(sys, "argv", ["check.py", "--limit", "3", table]), \
                contextlib.redirect_stdout(out), contextlib.redirect_stderr(io.StringIO()):
            check.signal.signal(check.signal.SIGVTALRM, give_up)
            check.signal.setitimer(check.signal.ITIMER_VIRTUAL, 20)
            self.assertEqual(check.main(), 0)
            check.signal.setitimer(check.signal.ITIMER_VIRTUAL, 0)
        _, rows, right, still_open, wrong, _ = out.getvalue().splitlines()[1].split()
        self.assertEqual((int(right), int(still_open), int(wrong)), (int(rows) - 1, 1, 0))
        self.assertEqual(check.signal.alarm(0), 0)  # none is left behind


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *rest])
