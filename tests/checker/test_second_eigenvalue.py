# SPDX-License-Identifier: MIT
"""Lemma Z of docs/certificate.md, part by part, against sums and random complex points in binary64; and what the program says, and says wrongly, about limit.gap."""
import argparse
import cmath
import hashlib
import itertools
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock
from fractions import Fraction

parser = argparse.ArgumentParser()
parser.add_argument("--checker", required=True, type=pathlib.Path)
parser.add_argument("--program", required=True)
known, rest = parser.parse_known_args()
sys.path.insert(0, str(known.checker))
import certificate  # noqa: E402
import certificate_text  # noqa: E402
import full_contact  # noqa: E402
import intervals as iv  # noqa: E402
import second_eigenvalue as se  # noqa: E402
from intervals import Interval  # noqa: E402
from scale_one import Disc  # noqa: E402

G, SEED = Fraction(3), 20261125
PLACE, NOISE, STEP = 0.7, 300, 0.05  # of a rule in tau


def program(*arguments):
    return subprocess.run([known.program, *map(str, arguments)], capture_output=True, text=True)


def V(sigma):
    r = math.exp(-2 * sigma)
    return sigma - r / 2 - 3 * r**4 / 16 + 1e-4 / (2 * r)


def W(sigma):
    r = math.exp(-2 * sigma)
    return 1 + r + 1.5 * r**4 + 1e-4 / r


class Plain:
    """w and one wave in binary64, from the same coefficients"""

    def __init__(self, w):
        self.start = 2 * math.log(float(G) / 2)
        self.centre, self.radius = float(w.value.middle), float(w.value.half)
        self.last = self.start + float(w.high)
        self.c = [c * 2.0**w.value.exponent for c in w.value.coefficients]
        self.noise = [(j + 0.5) * STEP for j in range(NOISE)]  # tanh tau = u: the middle rule of what is even and analytic about the real line

    def series(self, s):
        """w and w'"""
        if s.real > self.last:
            return self.series(self.last)[0], 0.0
        t = (cmath.log(s) - self.centre) / self.radius
        T, D, U0, U1 = (1, t), (0, 1), 1, 2 * t  # T_k' = k U_(k-1)
        value, slope = self.c[0] + self.c[1] * t, self.c[1] + 0 * t
        for k in range(2, len(self.c)):
            T = T[1], 2 * t * T[1] - T[0]
            value, slope = value + self.c[k] * T[1], slope + self.c[k] * k * U1
            U0, U1 = U1, 2 * t * U1 - U0
        return value, slope / (self.radius * s)

    def mean(self, s, of):
        total = 0
        for tau in self.noise:
            q = 1 / math.cosh(tau) ** 2
            m = 1 - cmath.exp(-s) * (1 - q)
            following = (s + self.start - math.log(q) - cmath.log(m)) / 2
            psi, beta = 1 - 1 / (2 * m), (1 - m) / (2 * m * m)
            total += 4 / math.pi * q**1.5 * STEP * of(psi, beta, following)
        return total

    def slope_of_mean(self, s):
        def here(psi, beta, following):
            w, slope = self.series(following)
            return beta * w + psi**2 * slope
        return self.mean(s, here)


class SecondEigenvalue(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name) / "certificate.txt"
        cls.arguments, cls.w = cls.function(G)
        cls.plain = Plain(cls.w)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def setUp(self):
        Interval.bits = 128

    @classmethod
    def make(cls, G, digits):
        made = program("certificate", "limit.gap", f"G={G}", "--digits", digits, "--out", cls.path)
        assert made.returncode == 0, made.stderr

    @classmethod
    def function(cls, G):
        """what the program writes, and the checker's reading of it"""
        cls.make(G, 2)
        words = cls.path.read_text().splitlines()[-2].split(" ")
        data = dict(word.split("=") for word in words[4:9])
        Interval.bits = 128
        arguments = (*(certificate_text.dyadic(data[name]) for name in ("high", "centre", "radius")), int(data["exponent"]), [int(c, 16) for c in words[9:]])
        return arguments, se.Eigenfunction(Interval.of(G), *arguments)

    def test_discs_hold_logarithms_and_exponentials(self):
        chosen = random.Random(SEED)
        for _ in range(300):
            c, r = chosen.uniform(0.1, 5), chosen.uniform(0, 1)
            disc = Disc(Interval.of(Fraction(c)), Interval.of(Fraction(c * r)))
            for inside, form in ((cmath.log, se.log), (cmath.exp, se.exp)):
                found = form(disc)
                for _ in range(10):
                    z = inside(c + c * r * cmath.exp(2j * math.pi * chosen.random()))
                    self.assertLessEqual(abs(z - float(found.centre.middle())), float(found.radius.ends()[1]) * (1 + 1e-9) + 1e-12)

    def test_values_are_those_of_one_wave(self):
        """(D w)(s), (D w)'(s) and lambda, by sums over the noise"""
        for sigma in (0, 0.7, 3, float(self.w.high) / 2, float(self.w.high)):
            s = self.w.start + Fraction(sigma)
            for slope, plainly in ((False, lambda psi, beta, t: psi * self.plain.series(t)[0]), (True, None)):
                rule, off = self.w.rule(Disc.of(s), slope, Fraction(1, 10**9))
                low, high = (self.w.integral(s, slope, rule) + iv.error_term(Interval.of(off)) + self.w.cut_off(slope)).ends()
                at = self.plain.start + sigma
                plain = (self.plain.slope_of_mean(at) if slope else self.plain.mean(at, plainly)).real
                self.assertLess(high - low, 1e-8)
                self.assertTrue(low - Fraction(1, 10**9) <= plain <= high + Fraction(1, 10**9), (sigma, slope, float(low), plain, float(high)))

    def test_bounds_hold_on_discs(self):
        """|f| at complex s of the disc"""
        chosen, ratio = random.Random(SEED), self.w.ratio(Fraction(1, 10**6))
        lam = float(ratio.middle())
        for sigma, r in ((0.05, 0.05), (0.4, 0.2), (3, 1)):
            found = float(self.w.size_of_defect(Disc(self.w.start + Fraction(sigma), Interval.of(Fraction(r))), ratio))
            for _ in range(3):
                s = self.plain.start + sigma + r * cmath.exp(2j * math.pi * chosen.random())
                self.assertLessEqual(abs(self.plain.slope_of_mean(s) - lam * self.plain.series(s)[1]), found * (1 + 1e-9))

    def test_bounds_are_of_the_ellipse_that_interpolation_asks_for(self):
        with unittest.mock.patch.object(self.w, "size_of_defect", side_effect=se.Outside) as bound:
            self.assertIsNone(self.w.defect_on(Fraction(1), Fraction(3), Interval.of(1), Fraction(1, 10)))
        (s, _), _ = bound.call_args
        self.assertEqual((round(float((s.centre - self.w.start).middle()), 9), s.radius.middle()), (2, Fraction(se.RHO + Fraction(1, se.RHO)) / 2))

    def test_the_defect_is_no_smaller_than_at_random_places(self):
        """where w is no eigenfunction: one of its coefficients is moved"""
        high, centre, radius, exponent, c = self.arguments
        moved = se.Eigenfunction(Interval.of(G), high, centre, radius, exponent, [*c[:3], c[3] + 2**-exponent // 100, *c[4:]])
        plain, ratio, chosen = Plain(moved), moved.ratio(Fraction(1, 10**6)), random.Random(SEED)
        found, lam = float(moved.defect(ratio, Fraction(1, 10**2), lambda part: None)), float(ratio.middle())
        largest = 0
        for _ in range(20):
            sigma = chosen.uniform(0, 1.1 * float(high)) * chosen.random()
            s = plain.start + sigma
            largest = max(largest, abs(plain.slope_of_mean(s) - lam * plain.series(s)[1]) / W(sigma))
        self.assertLessEqual(largest, found)
        self.assertGreater(largest, found / 20)

    def test_averages_of_absolute_values(self):
        """tau, and theta on narrow intervals: above sums, and by no more than boxes cost"""
        for sigma in (0, PLACE, 2, 9):
            a, b = Fraction(sigma), Fraction(sigma) + Fraction(1, 1000)
            coupling, remainder = self.w.row(a, b, 500)
            apart = lambda t: abs(V(t.real - self.plain.start) - V(PLACE))  # noqa: E731
            s = self.plain.start + sigma + 0.0005
            plain = self.plain.mean(s, lambda psi, beta, t: abs(psi) * apart(t)).real, self.plain.mean(s, lambda psi, beta, t: abs(psi)**2 * W(t.real - self.plain.start) + abs(beta) * apart(t)).real
            for above, at in zip((coupling, remainder), plain):
                self.assertTrue(at <= above <= 1.03 * at, (sigma, float(above), at))
            for boxes in (1, 3):  # wide ones, the last where V is infinite
                for above, at in zip(self.w.row(a, b, boxes), plain):
                    self.assertLessEqual(at, above)
            self.assertTrue(0.99 <= float(se.least_weight(a, b)) / W(sigma) <= 1)
            slope = abs(self.plain.series(s)[1]) / self.plain.series(self.plain.start + PLACE)[0].real
            self.assertTrue(slope <= self.w.steepness(a, b) <= 1.01 * slope + 1e-6, sigma)
            for end in (a, a + Fraction(1, 2)):  # by Taylor's formula from the middle
                slope = abs(self.plain.series(self.plain.start + float(end))[1]) / self.plain.series(self.plain.start + PLACE)[0].real
                self.assertLessEqual(slope * (1 - 1e-9), self.w.steepness(a, a + Fraction(1, 2)))

    def test_the_norm_of_what_remains(self):
        """theta: above the largest of sums, which all its three parts make, and by little"""
        coupling, largest = self.w.row(Fraction(PLACE), Fraction(PLACE), 500)[0], 0
        for sigma in (0, 0.6, 1.2, 1.25, 2, 5):
            s = self.plain.start + sigma
            apart = lambda t: abs(V(t.real - self.plain.start) - V(PLACE))  # noqa: E731
            of_row = self.plain.mean(s, lambda psi, beta, t: abs(psi)**2 * W(t.real - self.plain.start) + abs(beta) * apart(t)).real
            slope = abs(self.plain.series(s)[1]) / self.plain.series(self.plain.start + PLACE)[0].real
            largest = max(largest, (of_row + float(coupling) * slope) / W(sigma))
        self.assertTrue(self.w.remainder_is_below(Fraction(1.05 * largest), coupling, lambda part: None))
        with unittest.mock.patch.object(se, "HALVINGS", 6):
            self.assertFalse(self.w.remainder_is_below(Fraction(0.95 * largest), coupling, lambda part: None))
        with unittest.mock.patch.object(self.w, "remainder_beyond", return_value=Interval.of(1)):
            self.assertFalse(self.w.remainder_is_below(Fraction(1.05 * largest), coupling, lambda part: None))

    def test_what_is_left_out_counts(self):
        """of rules and where integrals are cut off"""
        exactly, s, zero = self.w.rule, Disc(self.w.start + 2, Interval.of(Fraction(1, 2))), Interval.of(0)
        w = self.function(G)[1]
        with unittest.mock.patch.object(w, "rule", side_effect=lambda *of: (exactly(*of)[0], Fraction(1, 10))):
            a, b = Fraction(2), Fraction(5, 2)
            self.assertGreaterEqual(w.defect_on(a, b, w.ratio(Fraction(1, 10**4)), Fraction(1, 100)) * se.least_weight(a, b), Fraction(1, 10))
        w.octaves = 2
        with unittest.mock.patch.object(se.Integrand, "__call__", lambda integrand, e: Disc.of(1)):
            self.assertGreaterEqual(w.size_of_defect(s, zero), Fraction(3, 4) + se.top(w.cut_off(True)))

    def test_what_the_defect_may_be(self):
        """gd/(3 tau), or d^2/(6 tau), d = lambda/4 here, of w(place) = 2 twice as much; and slopes are those of w/w(place)"""
        high, centre, radius, exponent, c = self.arguments
        double, tau, seen = se.Eigenfunction(Interval.of(G), high, centre, radius, exponent + 1, c), float(self.w.row(Fraction(PLACE), Fraction(PLACE), se.FINE)[0]), []
        self.assertAlmostEqual(float(double.steepness(Fraction(1), Fraction(1)) / self.w.steepness(Fraction(1), Fraction(1))), 1)
        value = self.w.ratio(Fraction(1, 10**6)).middle()
        for w, factor in ((self.w, 1), (double, 2)):
            for error in (Fraction(1, 100), Fraction(1, 3)):
                with unittest.mock.patch.object(w, "remainder_is_below", return_value=True), unittest.mock.patch.object(w, "defect", side_effect=lambda ratio, aim, *_: seen.append(aim) or 0):
                    self.assertTrue(w.is_within(value, error, lambda part: None))
                d = float(value) / 4
                self.assertLessEqual(float(seen[-1]) * se.SPARE * 3 * tau, 1.0001 * factor * min(float(error) * d, d * d / 2))

    def test_far_out(self):
        """What is said from s_0 + high on, there and further on, of w that ends soon and of w = 1 too; the mass that is cut off"""
        short = se.Eigenfunction(Interval.of(G), Fraction(1), *self.arguments[1:])
        constant = se.Eigenfunction(Interval.of(G), Fraction(1), *self.arguments[1:3], 0, [1, 0, 0])
        for w, more in itertools.product((self.w, short, constant), (0, 1, 5)):
            plain = Plain(w)
            sigma = float(w.high) + more + 1e-9
            s = plain.start + sigma
            apart = lambda t: abs(V(t.real - plain.start) - V(PLACE))  # noqa: B023,E731
            theta = plain.mean(s, lambda psi, beta, t: abs(psi)**2 * W(t.real - plain.start) + abs(beta) * apart(t)).real / W(sigma)  # noqa: B023
            self.assertLessEqual(abs(plain.slope_of_mean(s)) / W(sigma), float(se.top(w.defect_beyond())))
            self.assertLessEqual(theta, float(se.top(w.remainder_beyond())))
        w = self.function(G)[1]
        w.octaves = 2
        for slope, of in ((True, lambda psi, beta, t: abs(beta * self.plain.series(t)[0] + psi**2 * self.plain.series(t)[1])), (False, lambda psi, beta, t: abs(psi * self.plain.series(t)[0]))):
            noise, self.plain.noise = self.plain.noise, [tau for tau in self.plain.noise if tau > 2 * math.log(2)]
            left_out, self.plain.noise = self.plain.mean(self.plain.start, of).real, noise
            self.assertTrue(left_out <= float(se.top(w.cut_off(slope))) <= 20 * left_out, (slope, left_out, float(se.top(w.cut_off(slope)))))
        for s in (self.w.start, self.w.last):
            self.assertTrue(self.w.next_below(Fraction(1, 2**self.w.octaves), s))

    def test_proves_what_the_program_says(self):
        for G, digits in ((64, 2), ("10000^0.5", 3)):
            self.make(G, digits)
            read = certificate.Certificate(self.path)
            certificate.Replay(read, 1, read.count)
            (_, value, error), = read.claims.values()
            said = json.loads(program("eval", "limit.gap", f"G={G}", "--digits", digits + 3, "--json").stdout)["value"]
            self.assertLessEqual(abs(value - Fraction(said)), error)
            self.assertLess(error / value, Fraction(1, 10**digits))

    def test_functions_that_do_not_prove_it(self):
        """A claim beside the truth; w moved; w that ends beyond its polynomial, or before the place where it is 1"""
        G = 64
        (high, centre, radius, exponent, c), w = self.function(G)
        value, error = w.ratio(Fraction(1, 10**6)).middle(), Fraction(1, 100)
        self.assertTrue(w.is_within(value, error, lambda part: None))
        self.assertFalse(w.is_within(value + Fraction(3, 200), error, lambda part: None))
        moved = [*c[:3], c[3] + 2**-exponent // 10, *c[4:]]
        self.assertFalse(se.Eigenfunction(Interval.of(G), high, centre, radius, exponent, moved).is_within(value, error, lambda part: None))
        for wrong in ((2 * high, centre, radius), (Fraction(1, 2), centre, radius), (high, centre + radius / 50, radius), (high, centre, radius * Fraction(99, 100))):
            with self.subTest(wrong=[*map(float, wrong)]), self.assertRaises((full_contact.Far, ValueError)):
                se.Eigenfunction(Interval.of(G), *wrong, exponent, c)

    def test_what_would_take_forever_is_refused(self):
        """An error below what the bits give; coefficients that no rule follows; more work than any proof takes"""
        self.make(64, 1)
        text, begun = self.path.read_text(), time.process_time()
        for was, now in (("error=[0-9a-f]+:-[0-9]+", "error=1:-16384"), (r"( exponent=-64( [-0-9a-f]+)+)\n", r"\1 " + "0 " * 60 + "4" + "0" * 3000 + "\n"), (r"( exponent=-64( [-0-9a-f]+)+)\n", r"\1 -4" + "0" * 3000 + "\n")):
            changed = re.sub(was, now, text, count=1).rpartition("sha256 ")[0]
            self.assertNotEqual(changed, text.rpartition("sha256 ")[0])
            self.path.write_text(changed + f"sha256 {hashlib.sha256(changed.encode()).hexdigest()}\n")
            with self.subTest(now=now[:30]), self.assertRaises(certificate.Refused):
                certificate.Replay(certificate.Certificate(self.path), 1, 2)
        self.assertLess(time.process_time() - begun, 20)
        with unittest.mock.patch.object(se, "MOST_WORK", 100), self.assertRaises(full_contact.Far):
            self.w.defect(self.w.ratio(Fraction(1, 10**6)), Fraction(1, 10**6), lambda part: None)
        with unittest.mock.patch.object(self.w, "defect_beyond", return_value=Interval.of(1)), unittest.mock.patch.object(self.w, "defect_on") as asked:
            self.assertEqual(self.w.defect(Interval.of(1), Fraction(1), lambda part: None, Fraction(1, 2)), 1)
        asked.assert_not_called()

    def test_no_certificate_is_written_where_none_is_known_to_hold(self):
        """Below G = 2.2: next to 2.17 the second and the third eigenvalue meet, and theta is less than the second no more; beyond 2^20"""
        for G in ("2.19", "1048577"):
            said = program("certificate", "limit.gap", f"G={G}")
            self.assertEqual((said.returncode, "2.2 <= G <= 2^20" in said.stderr), (2, True), said.stderr)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *rest])
