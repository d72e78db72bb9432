# SPDX-License-Identifier: MIT
"""The Python package as it is installed: python -m pytest (or python -m unittest) python/test_touchstone.py"""
import math
import threading
import unittest
from fractions import Fraction

import touchstone as ts


class Eval(unittest.TestCase):
    def test_digits_bounds_status(self):
        v = ts.eval("archard.K", n=3, digits=30)
        self.assertEqual((v.value, v.status, v.unit), ("0.416550371832813487722720256733", "certified", "1"))
        self.assertEqual(v.upper - v.lower, 2 * Fraction("5e-31"))
        self.assertEqual(float(v).hex(), "0x1.aa8c2e40a2612p-2")
        self.assertEqual(ts.eval("contact.area", n=3, load="1/10", G=2, digits=10).digits, 10)
        self.assertLess(Fraction(ts.eval("archard.K", n=3, digits=6, rounding="down").value), v.lower)

    def test_inputs_are_what_they_are(self):
        tenth, binary = ts.eval("hertz.half_width", load="0.1", digits=30), ts.eval("hertz.half_width", load=0.1, digits=30)
        self.assertNotEqual(tenth.value, binary.value)
        self.assertEqual(tenth, ts.eval("hertz.half_width", load=Fraction(1, 10), digits=30))
        self.assertEqual(ts.eval("peaks.fixed_point", G="sqrt(10)").value, ts.eval("peaks.fixed_point", D="3/2", gamma=10).value)
        half = ts.eval("westergaard.half_width", load=1)
        self.assertEqual((half.status, half.lower, half.upper), ("exact", Fraction(1, 2), Fraction(1, 2)))

    def test_errors(self):
        for call, kind in ((lambda: ts.eval("archard.K", n=-1), ts.Refused), (lambda: ts.eval("archard.J", n=1), ts.TouchstoneError), (lambda: ts.eval("archard.K"), ts.TouchstoneError),
                           (lambda: ts.eval("hertz.half_width", load=math.nan), ts.Refused), (lambda: ts.eval("hertz.half_width", load="1 2"), ts.Refused), (lambda: ts.eval("hertz.half_width", load=True), ts.Refused),
                           (lambda: ts.eval("hertz.half_width", load=None), ts.Refused), (lambda: ts.eval("archard.K", n=3, digits=0), ts.Refused), (lambda: ts.quantity("no"), ts.TouchstoneError)):
            with self.assertRaises(kind):
                call()

    def test_arrays(self):
        loads = [0.1, 0.25, 1.0]
        values = list(ts.eval("westergaard.half_width", load=loads))
        self.assertEqual(values, [float(ts.eval("westergaard.half_width", load=x)) for x in loads])
        values = list(ts.eval("westergaard.pressure", x=[0.0, 0.125], load=0.5))
        self.assertEqual(values[1], float(ts.eval("westergaard.pressure", x=0.125, load=0.5)))
        self.assertEqual(len(values), 2)
        with self.assertRaises(ts.Refused):
            ts.eval("westergaard.half_width", load=[0.5, -1.0])
        try:
            import numpy
        except ImportError:
            return
        grid = ts.eval("westergaard.pressure", x=numpy.array([[0.0], [0.125]]), load=numpy.array([0.25, 0.5, 2.0]))
        self.assertEqual(grid.shape, (2, 3))
        self.assertEqual(grid[1, 1], values[1])

    def test_threads(self):
        found = [None] * 4
        def work(k):
            found[k] = [ts.eval("contact.area", n=n, load="1/3", G=3, digits=12).value for n in range(4)]
        threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
        for t in threads:
            t.start()
        for t in threads:
            t.join()
        self.assertTrue(all(f == found[0] and None not in f for f in found))

    def test_names(self):
        self.assertIn("contact.area", ts.quantities())
        q = ts.quantity("contact.area")
        self.assertEqual((q.inputs, q.unit, q.equation), (("n", "load", "G"), "lambda0", "6.7"))


class Tables(unittest.TestCase):
    def test_a_table(self):
        table = ts.table("westergaard_half_width")
        self.assertEqual(len(table), table.header["rows"])
        row = table[0]
        self.assertLessEqual(abs(Fraction(ts.eval("westergaard.half_width", load=row.inputs[0], digits=40).value) - Fraction(row.value)), 2 * Fraction(row.error))
        self.assertIn("westergaard_pressure", ts.table_names())
        with self.assertRaises(KeyError):
            ts.table("no")

    def test_judge(self):
        right = lambda load: math.atan2(math.sqrt(load), math.sqrt(max(1 - load, 0))) / math.pi
        self.assertTrue(ts.judge(right, "westergaard_half_width", rtol=1e-14))
        self.assertTrue(ts.judge(right, "westergaard_half_width", ulps=4))
        wrong = ts.judge(lambda load: 2 * right(load), "westergaard_half_width", rtol=1e-3, where=lambda load: load < 0.5)
        self.assertFalse(wrong)
        self.assertIn("rows are not within rtol 0.001", repr(wrong))
        self.assertEqual(len(wrong.failing), wrong.rows)
        self.assertFalse(ts.judge(lambda load: math.nan, "westergaard_half_width", rtol=1.0))
        self.assertTrue(ts.judge(lambda load: right(load) + 1e-9, "westergaard_half_width", atol=2e-9))
        with self.assertRaises(ValueError):
            ts.judge(right, "westergaard_half_width", rtol=-1)
        with self.assertRaises(ValueError):
            ts.judge(right, "westergaard_half_width", where=lambda load: False)


if __name__ == "__main__":
    unittest.main()
