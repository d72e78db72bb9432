# SPDX-License-Identifier: MIT
"""The checker's intervals against the decimal module of the standard library: narrow and wide ones, next to 1, tiny and huge, at several precisions."""
import argparse
import decimal
import pathlib
import random
import sys
import unittest
from fractions import Fraction

parser = argparse.ArgumentParser()
parser.add_argument("--checker", required=True, type=pathlib.Path)
parser.add_argument("--seed", type=int, default=20261125)
known, rest = parser.parse_known_args()
sys.path.insert(0, str(known.checker))
import intervals as iv  # noqa: E402
from intervals import Interval  # noqa: E402

DIGITS = 400  # of what is compared with
TRIALS = 120


def numbers(chosen):
    """positive ones: of usual size, next to 1, next to the middles of the cells of the table of logarithms, far from 1"""
    yield from (Fraction(chosen.randint(1, 10**9), chosen.randint(1, 10**9)) for _ in range(TRIALS))
    yield from (1 + Fraction(chosen.randint(-10**6, 10**6), 2**chosen.randint(21, 90)) for _ in range(TRIALS))
    yield from (Fraction(2 * cell + 1, 2 * iv.CELLS) + Fraction(chosen.randint(-1, 1), 2**60) for cell in range(iv.CELLS // 2, 2 * iv.CELLS))
    yield from (Fraction(chosen.randint(1, 200)) * Fraction(2) ** chosen.randint(-600, 600) for _ in range(TRIALS))


class Intervals(unittest.TestCase):
    def decimal(self, x):
        return decimal.Decimal(x.numerator) / decimal.Decimal(x.denominator)

    def holds(self, interval, true, bits, slack=Fraction(1, 10**(DIGITS - 20))):
        low, high = interval.ends()
        true = Fraction(true)
        self.assertTrue(low - abs(true) * slack <= true <= high + abs(true) * slack, (float(low), float(true), float(high)))
        of = abs(true) if bits <= 512 else 1 + abs(true)  # roots take from what is next to 1
        self.assertLessEqual(high - low, of * Fraction(1, 2 ** (bits - 24)))

    def test_points(self):
        for bits, of in ((64, 1), (112, 3), (512, 9), (600, 27)):  # beyond 512 logarithms are had from roots
            Interval.bits = bits
            with decimal.localcontext() as context:
                context.prec = DIGITS
                for k, x in enumerate(numbers(random.Random(known.seed))):
                    if k % of:
                        continue
                    x = Interval.of(x).ends()[0]  # exactly a number of so many bits
                    with self.subTest(bits=bits, x=float(x) if x < 2**900 else x):
                        self.holds(iv.sqrt(x), self.decimal(x).sqrt(), bits)
                        if x != 1:
                            self.holds(iv.log(x), self.decimal(x).ln(), bits)
                        for y in (x, -x):
                            if x < 700:
                                self.holds(iv.exp(Interval.of(y)), self.decimal(y).exp(), bits)

    def test_wide_intervals(self):
        """A logarithm is had from both ends: nothing of its series is known where t is next to -1."""
        Interval.bits, one = 64, Interval.of(1)
        with decimal.localcontext() as context:
            context.prec = 60
            for low, high in ((Fraction(1, 3), Fraction(1)), (Fraction(1, 2**40), Fraction(1)), (Fraction(1, 2**50), Fraction(7, 5)), (Fraction(5, 9), Fraction(2)), (Fraction(3), Fraction(2**50))):
                ends = [Fraction(self.decimal(x).ln()) for x in (low, high)]
                found = iv.log(iv.hull(Interval.of(low), Interval.of(high))).ends()
                for f, true, way in zip(found, ends, (-1, 1)):
                    self.assertTrue(0 <= way * (f - true) + Fraction(1, 10**50) <= Fraction(1, 2**44) * (1 + abs(true)), (low, high))
        self.assertEqual(iv.log(one).ends(), (0, 0))
        self.assertEqual(iv.hull(Interval.of(-3), Interval.of(Fraction(1, 2))).ends(), (-3, Fraction(1, 2)))
        for reaches_0 in (Interval.of(0), Interval(-1, 1), Interval(0, 1)):
            with self.assertRaises(ValueError):
                iv.log(reaches_0)

    def test_what_is_too_wide_for_a_series_is_refused(self):
        Interval.bits = 64
        for form, x in ((iv.arctan, Interval(1, 6400, -6)), (iv.arctan, Interval(-1, 1, 9))):
            with self.assertRaises(ValueError):
                form(x)

    def test_angles(self):
        """Angles of points on rays that are known: sin and cos of multiples of pi/96, and the other way round"""
        for bits in (64, 192):
            Interval.bits = bits
            for k in range(1, 48):
                sine, cosine = iv.sin_pi(Fraction(k, 96)), iv.sin_pi(Fraction(48 - k, 96))
                low, high = (iv.angle(sine, cosine) / iv.pi() - Fraction(k, 96)).ends()
                self.assertTrue(low <= 0 <= high and high - low < Fraction(1, 2 ** (bits - 20)), (bits, k))
                low, high = (sine.square() + cosine.square() - 1).ends()
                self.assertTrue(low <= 0 <= high, (bits, k))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *rest])
