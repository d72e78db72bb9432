#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python module, and the Fortran and Octave examples, on a table the program has just written.

usage: test_module.py --touchstone PROGRAM --client FOLDER [--fortran PROGRAM --read-table PROGRAM]
"""
import argparse
import hashlib
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

arguments = argparse.ArgumentParser()
arguments.add_argument("--touchstone", required=True)
arguments.add_argument("--client", required=True)
arguments.add_argument("--fortran")
arguments.add_argument("--read-table")
options, sys.argv[1:] = arguments.parse_known_args()
sys.dont_write_bytecode = True
sys.path.insert(0, options.client)
import touchstone_reference as ref  # noqa: E402


def half_width(load):
    return math.atan2(math.sqrt(load), math.sqrt(1 - load)) / math.pi


class Client(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.table = pathlib.Path(cls.folder.name) / "westergaard_half_width.txt"
        cls.table.write_bytes(subprocess.run([options.touchstone, "table", "westergaard_half_width"], check=True, capture_output=True).stdout)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_one_call_judges_a_function(self):
        table = ref.load(self.table)
        self.assertEqual((table.quantity, table.inputs), ("westergaard.half_width", ["load"]))
        worst = table.worst(half_width)
        self.assertTrue(0.5 < worst.ulps <= 4, worst)
        self.assertGreater(table.worst(lambda x: 2 * half_width(x)).ulps, 1e15)

    def test_all_failing_rows_beyond_what_rounded_inputs_force(self):
        table = ref.load(self.table)
        self.assertEqual(table.failing(half_width), [])
        self.assertTrue(all(row.forced is not None for row in table.rows))
        rounded = lambda load: half_width(math.nextafter(load, 0))  # noqa: E731
        self.assertGreater(len(table.failing(rounded, forgive_inputs=False)), 20)
        self.assertLess(len(table.failing(rounded)), len(table.failing(rounded, forgive_inputs=False)))
        off = lambda load: half_width(load) * (1 + 1e-9)  # noqa: E731
        self.assertGreater(len(table.failing(off)), 0.9 * len(table.rows))
        self.assertEqual(table.failing(off, rtol=1e-6), [])
        self.assertEqual(table.failing(off, atol=1e-6), [])
        self.assertEqual(len(table.failing(lambda load: math.nan, rtol=1)), len(table.rows))
        some = table.failing(lambda load: 1.0, where=lambda load: load < 0.25)
        self.assertTrue(some and all(w.row.inputs[0] < 0.25 for w in some))

    def test_a_table_without_that_column_is_read_too(self):
        lines = self.table.read_text().splitlines(keepends=True)
        import hashlib
        import json
        rows = "".join(" ".join(line.split()[:-1]) + "\n" for line in lines if not line.startswith("#"))
        header = json.loads(next(line for line in lines if line.startswith("# {"))[2:])
        header["sha256"] = hashlib.sha256(rows.encode()).hexdigest()
        old = pathlib.Path(self.folder.name) / "old.txt"
        old.write_text("# " + json.dumps(header) + "\n# load value error\n" + rows)
        self.assertTrue(all(row.forced is None for row in ref.load(old).rows))
        if options.read_table:
            out = subprocess.run([options.read_table, str(old)], capture_output=True, text=True)
            self.assertEqual(out.returncode, 0, out.stderr)

    def test_estimates_of_what_inputs_force_are_forgiven_four_times(self):
        text = self.table.read_text()
        estimated = pathlib.Path(self.folder.name) / "estimated.txt"
        estimated.write_text(text.replace('"forced":"first order"', '"forced":"estimated"'))
        self.assertNotEqual(estimated.read_text(), text)
        for once, four in zip(ref.load(self.table).rows, ref.load(estimated).rows):
            self.assertEqual(4 * once.forced, four.forced)
        if options.read_table:  # its worst row is farther off than what is forced, whichever way that is known
            out = [subprocess.run([options.read_table, str(t)], capture_output=True, text=True, check=True).stdout.split()[-1] for t in (self.table, estimated)]
            self.assertLessEqual(float(out[1]), float(out[0]))

    def test_ulps_against_known_distances(self):
        one = "1.000000000000000000000"
        self.assertEqual(ref.ulps(1 + 2**-52, one, "0"), (1.0, 1.0))
        self.assertLess(abs(ref.ulps(1 + 2**-52, "0.9999999999999999999999", "5e-23")[0] - 2), 1e-5)
        self.assertEqual(ref.ulps(2**-1074, Fraction(3) / 2**1074, 0), (2.0, 2.0))
        self.assertEqual(ref.ulps(0.0, "0", "0"), (0.0, 0.0))
        self.assertEqual(ref.ulps(math.inf, "1e400", "0"), (0.0, 0.0))
        for wrong in (math.nan, math.inf, -math.inf):
            self.assertEqual(ref.ulps(wrong, one, "5e-22"), (math.inf, math.inf))
        least, most = ref.ulps(1.0, one, "5e-17")
        self.assertTrue(least == 0 < most)

    def test_damaged_tables_are_refused(self):
        text = self.table.read_text()
        damaged = pathlib.Path(self.folder.name) / "damaged.txt"
        rows = text.splitlines(keepends=True)
        for change in (text[:-1], "".join(rows[:-1]), text.replace("0.5 ", "0.6 ", 1), "", "# nothing\n"):
            damaged.write_text(change)
            with self.assertRaises(ref.CorruptTable):
                ref.load(damaged)

    def test_a_header_that_is_none_is_refused(self):
        text = self.table.read_text()
        header = next(line for line in text.splitlines() if line.startswith("# {"))
        damaged = pathlib.Path(self.folder.name) / "damaged.txt"
        for other in ('{"name":', "{}", '{"a":%s}' % ("[" * 100000 + "]" * 100000), header[2:].replace('"inputs":["load"]', '"inputs":5'), header[2:].replace('"sha256":"', '"sha256":5,"a":"')):
            self.assertNotEqual(other, header[2:])
            damaged.write_text(text.replace(header, f"# {other}"))
            with self.assertRaisesRegex(ref.CorruptTable, "no JSON header"):
                ref.load(damaged)

    def test_numbers_without_end_are_refused(self):
        text = self.table.read_text()
        row = text.splitlines(keepends=True)[-1]
        given, value, *more = row.split()
        for other in ("0.5E306952043666", "1e-99999", "0x1p-1", "1/3", "inf", "1_0"):
            changed = text[: -len(row)] + " ".join((given, other, *more)) + "\n"
            rows = "".join(line for line in changed.splitlines(keepends=True) if not line.startswith("#"))
            damaged = pathlib.Path(self.folder.name) / "damaged.txt"
            damaged.write_text(re.sub(r'"sha256":"[0-9a-f]+"', f'"sha256":"{hashlib.sha256(rows.encode()).hexdigest()}"', changed))
            with self.assertRaisesRegex(ref.CorruptTable, "not decimal numbers"):
                ref.load(damaged)

    def test_numpy_is_optional(self):
        try:
            import numpy  # noqa: F401
        except ImportError:
            self.skipTest("numpy is not installed")
        self.assertEqual(set(ref.load(self.table).columns()), {"load", "value"})

    def test_fortran_example(self):
        if not options.read_table:
            self.skipTest("no Fortran compiler")
        out = subprocess.run([options.read_table, str(self.table)], check=True, capture_output=True, text=True).stdout
        self.assertTrue(0 < float(out) <= 4, out)
        for words, failing in ((["1e-30"], True), (["1e-30", "1"], False)):
            out = subprocess.run([options.read_table, str(self.table), *words], check=True, capture_output=True, text=True).stdout
            self.assertEqual("fails: " in out, failing, out)
        self.assertIn("not a number", subprocess.run([options.read_table, str(self.table), "x"], capture_output=True, text=True).stderr)

    def test_examples_without_a_table_say_so_in_a_line(self):
        if options.read_table:
            for words, expected in (([], "which table?"), (["/no/such/table"], "No such file"), ([options.client], "")):
                r = subprocess.run([options.read_table, *words], capture_output=True, text=True)
                self.assertEqual((r.returncode, r.stderr.count("\n")), (1, 1), r.stderr)
                self.assertIn(expected, r.stderr)

    def test_the_matlab_example_is_matlab(self):
        text = pathlib.Path(options.client, "read_table.m").read_text()
        code = "\n".join(line for line in text.splitlines() if not line.startswith("%"))
        for octave_only in ('"', "!", "printf(", "argv", "endfunction", "endif", "#{"):
            if octave_only == "printf(":
                code = code.replace("fprintf(", "").replace("sprintf(", "")
            self.assertNotIn(octave_only, code)
        self.assertIn("function", code)

    def test_octave_example(self):
        octave = shutil.which("octave-cli")
        if octave is None:
            self.skipTest("octave-cli is not installed")
        out = subprocess.run([octave, "--path", options.client, "--eval", f"read_table('{self.table}')"], check=True, capture_output=True, text=True).stdout
        self.assertTrue(0 < float(out) <= 4, out)
        call = (f"[w, f] = read_table('{self.table}', @(x) 1 + 0 * x, 0, 0, @(x) x(:, 1) < 0.25); "
                f"[v, g] = read_table('{self.table}', @(x) 1 + 0 * x, 0, 1); printf('%d %d %d\\n', rows(f) > 20, all(f(:, 1) < 0.25), rows(g));")
        out = subprocess.run([octave, "--path", options.client, "--eval", call], check=True, capture_output=True, text=True).stdout
        self.assertEqual(out.split(), ["1", "1", "0"], out)


if __name__ == "__main__":
    unittest.main(verbosity=2)
