# SPDX-License-Identifier: MIT
"""Limits that are quotients of means, lemma W of docs/certificate.md: what the program writes the checker proves, and what says too much it refuses; the force of
one wave above a pressure, against sums and complex points in binary64."""
import argparse
import cmath
import collections
import functools
import hashlib
import itertools
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock
from fractions import Fraction

parser = argparse.ArgumentParser()
parser.add_argument("--checker", required=True, type=pathlib.Path)
parser.add_argument("--program", required=True)
parser.add_argument("--long", action="store_true", help="the whole proof of every quotient, that of segments too, and refusals of each kind of mean")
known, rest = parser.parse_known_args()
sys.path.insert(0, str(known.checker))
import at_once  # noqa: E402
import certificate  # noqa: E402
import certificate_text  # noqa: E402
import check  # noqa: E402
import full_contact  # noqa: E402
import limit_density  # noqa: E402
import poisson  # noqa: E402
import scale_one  # noqa: E402
from intervals import Interval  # noqa: E402

SEED, BITS = 20261126, 128


def program(*arguments):
    return subprocess.run([known.program, *map(str, arguments)], capture_output=True, text=True)


def signed(text):
    body = text.rpartition("sha256 ")[0]
    return body + f"sha256 {hashlib.sha256(body.encode()).hexdigest()}\n"


@functools.lru_cache(None)
def mesh(kind, P, highest=3):
    """one on which V = 0"""
    one = 1 << BITS
    edges = [one * k // 8 for k in range(1, 8 * highest + 2)]
    places = [(a * a + b * b >> BITS + 1, (b * b - a * a >> BITS + 1) + 2) for a, b in zip(edges, edges[1:])]
    return kind(Interval.of(Fraction(3, 2)), P, highest, BITS, edges, places, [30] * len(places), [[[0, 0]]] * len(places), BITS, 30, 0)


def at(x, P, force):
    """F_P or B_0 at a complex x, as lemmas W and M have it"""
    if x.real >= 1:
        theta = cmath.acos(P - x)
        return (x * theta + cmath.sin(theta)) / math.pi if force else theta / math.pi
    w = cmath.sqrt((1 - x) ** 2 + P * P) - x
    if not force:
        return cmath.acos(w) / math.pi
    return (cmath.sqrt((1 - w) * (2 * x - 1 + w)) + 2 * x * cmath.atan(cmath.sqrt(1 - w * w) / P)) / math.pi


def summed(x, P, force, parts=4000):
    """the same at a real x, by a sum of pressures: of x + cos theta, or by (2.17) with u = sin(theta/2) from 0 to the root of x, in the middles of parts"""
    if x >= 1:
        pressures = (x + math.cos(math.pi * (k + 0.5) / parts) for k in range(parts))
        return sum((p if force else 1) for p in pressures if p > P) / parts
    top = math.asin(math.sqrt(x))
    pressures = (2 * math.cos(psi) * math.sqrt(x - math.sin(psi) ** 2) for psi in (top * (k + 0.5) / parts for k in range(parts)))
    return sum((p if force else 1) for p in pressures if p > P) / parts * top * 2 / math.pi


class Force(unittest.TestCase):
    def test_is_what_one_wave_carries(self):
        for P in (Fraction(1, 1024), Fraction(3, 10), Fraction(3, 2), Fraction(5, 2)):
            for kind in (poisson.Poisson, poisson.Force):
                made = mesh(kind, P)
                for x in (0.001, 0.1, 0.5625, 0.9, 0.999, 1.0, 1.3, 2.5, 2.9):
                    here = made.first_wave(int(x * made.one)) / (1 << made.work)
                    with self.subTest(P=P, x=x, kind=kind.__name__):
                        self.assertAlmostEqual(here, summed(x, float(P), kind is poisson.Force), delta=2e-3)
                        singular = min(abs(x - s) for s in (float(P) + 1, abs(float(P) - 1), float(P * P) / 4))
                        if x < 1 and x > P * P / 4 or x >= 1 and P - 1 < x < P + 1 and singular > 1e-3:
                            self.assertAlmostEqual(here, at(complex(x), float(P), kind is poisson.Force).real, delta=1e-12)

    def test_is_all_or_nothing_at_the_ends(self):
        made = mesh(poisson.Force, Fraction(1, 2))
        self.assertEqual(made.first_wave(made.one // 32), 0)
        self.assertEqual(made.first_wave(made.one // 16), 0)
        self.assertLessEqual(abs(made.first_wave(2 * made.one) - (2 << made.work)), 4)
        self.assertEqual(mesh(poisson.Force, Fraction(9, 4)).first_wave(made.one), 0)

    def test_is_bounded_on_discs(self):
        chosen, largest = random.Random(SEED), {}
        for _ in range(400):
            P, force = chosen.choice([Fraction(1, 1024), Fraction(1, 3), Fraction(6, 5), Fraction(2), Fraction(11, 4)]), chosen.random() < 0.5
            made = mesh(poisson.Force if force else poisson.Poisson, P)
            x = chosen.choice([chosen.uniform(0, 1), 1 - 10 ** chosen.uniform(-9, -1), float(P * P) / 4 + 10 ** chosen.uniform(-9, -1), chosen.uniform(1, 3)])
            r = made.first_disc(int(x * made.one), *[int(x * made.one)] * 2) / made.one
            if r <= 2e-12:  # nothing, or all, of the wave
                continue
            bound = made.first_size(int((x + r) * made.one))
            for _ in range(20):
                z = x + r * chosen.choice([1, chosen.random()]) * cmath.exp(2j * math.pi * chosen.random())
                if (z.real >= 1) != (x >= 1):
                    continue  # the other formula is meant there
                size = abs(at(z, float(P), force))
                largest[force] = max(largest.get(force, 0), size / bound)
                self.assertLessEqual(size, bound, (P, x, r, z))
        self.assertGreater(min(largest.values()), 0.05)


class DensityOfTheLimit(unittest.TestCase):
    """Lemma AB with V = 0, so that R = G D_1 - c x, D_1 from the integral of scale_one.py."""

    def made(self):
        self.G, self.P = Fraction(3, 2), Fraction(7, 5)
        made = mesh(limit_density.MeanDensity, self.P)
        made.c, made.c_off, made.apart = made.one // 3, Fraction(1, 1 << 100), Fraction(0)
        return made

    def residual_at(self, x):
        Interval.bits = 64  # as a double has fewer
        value = float((scale_one.density(self.P * self.G, x, self.G) * self.G * self.G).middle()) - float(x) / 3
        Interval.bits = BITS
        return value

    def test_bounds_are_no_less_than_what_is_left(self):
        """next to the logarithms at the ends of both waves, and elsewhere; where T V is not followed too"""
        made, chosen, seen = self.made(), random.Random(SEED), collections.Counter()
        p, G = float(self.P * self.G), float(self.G)
        ends = [p + G - 1, p - G + 1, p * p / (4 * G) + 1, (p * p / (4 * G)) ** 2 / 4]
        for k in range(14):
            at = Fraction(chosen.choice([e for e in ends if 1 / 8 < e < 3]) if k % 2 else chosen.uniform(1 / 8, 2.9))
            w = Fraction(10 ** chosen.uniform(-12, -2))
            a, b = (int((at + w * side) * made.one) for side in ((1, 2) if k % 4 < 2 else (-2, -1)))
            if a < made.one < b or made.panel(a) != made.panel(b):
                continue
            for bound in (lambda: made.residual(made.panel(a), a, b, poisson.Inner()), lambda: made.hole(made.panel(a), a, b)):  # noqa: B023
                try:
                    here = float(bound())
                except full_contact.Far:
                    seen["far"] += 1
                    continue
                seen["bounded"] += 1
                true = max(abs(self.residual_at(Fraction(a * (8 - j) + b * j, 8 * made.one))) for j in (1, 6))
                self.assertLessEqual(true, here)
                self.assertLess(here, 40 * true + 1)
        self.assertGreater(seen["bounded"], 4, seen)
        self.assertEqual(made.apart, 0)

    def test_what_is_next_to_a_logarithm_is_kept_apart_and_counts(self):
        made = self.made()
        at = int((self.P * self.G + self.G - 1) * made.one)  # where the upper ends of both waves meet
        made.found = [(made.one, Fraction(1, 100))]
        before = made.means()
        self.assertEqual(made.left_on(made.panel(at), at - made.first.deepest // 2, at + made.first.deepest // 2, poisson.Inner()), 0)
        S = math.sqrt(float(self.G) * made.first.deepest / made.one / 2)
        here = abs(self.residual_at(Fraction(at + made.first.deepest // 4, made.one)))  # a logarithm's values are as large on most of it
        self.assertGreater(float(made.apart), here * S * float(self.G))
        self.assertLess(float(made.apart), 400 * here * S * float(self.G))
        self.assertEqual(made.means(), before + made.apart)
        with self.assertRaises(full_contact.Far):
            made.left_on(made.panel(at), at - 9 * made.first.deepest, at + 9 * made.first.deepest, poisson.Inner())

    def test_a_mesh_that_begins_too_late_is_refused(self):
        with self.assertRaises(limit_density.Refused):
            mesh(limit_density.MeanDensity, Fraction(1, 2) * 2 - Fraction(1, 100))


class Quotients(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name) / "c"
        cls.texts = {}
        for quantity, inputs in (("limit.exceedance", "p=3/4"), ("limit.force", "p=3/4"), ("limit.segments", "a=1/5"), ("limit.density", "p=3/2")):
            said = program("certificate", quantity, inputs, "G=2", "--digits", 1, "--out", cls.path)
            assert said.returncode == 0, said.stderr
            cls.texts[quantity] = cls.path.read_text()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def no(self, text, lines="", codes=(1, ), why=""):
        """the checker's no to a text, of which these lines are proved"""
        self.path.write_text(signed(text))
        said = at_once.ask(certificate, *(["--lines", lines] if lines else []), self.path)
        self.assertIn(said.returncode, codes, said.stdout + said.stderr)
        self.assertIn(why, said.stdout)

    def last(self, quantity):
        number = self.texts[quantity].splitlines()[2].split("lines=")[1]
        return f"{number}-{number}"

    def test_what_the_program_writes_is_proved(self):
        # that of segments is of the same kind as the first, of which the mean in contact is that of the density
        for quantity in self.texts if known.long else ("limit.exceedance", "limit.force", "limit.density"):
            self.path.write_text(self.texts[quantity])
            read = certificate.Certificate(self.path)
            in_contact = next((n for n, words in enumerate(read.lines, 1) if words[1] == "mean"), 0)
            certificate.Replay(read, in_contact + 1 if quantity == "limit.exceedance" and not known.long else 1, read.count)
            (*inputs, G, value, error), = read.claims.values()
            names = certificate.CLAIMS[quantity].split()[:-3]
            said = program("eval", quantity, *(f"{name}={x}" for name, x in zip(names, inputs)), "G=2", "--digits", 3, "--json")
            with self.subTest(quantity):
                self.assertLessEqual(abs(value - Fraction(json.loads(said.stdout)["value"])), error)
                self.assertLess(error, abs(value) / 10)

    def test_a_claim_that_says_too_much_is_refused(self):
        for quantity, text in self.texts.items():
            head, line = text.split("\n", 4)[:3], next(line for line in text.splitlines() if line.startswith("claim"))
            value, error = line.split("value=")[1].split(" error=")
            mantissa, exponent = error.split(":")
            for new in (line.replace(error, f"{mantissa}:{int(exponent) - 3}"), line.replace(value, certificate_number(value, error)), line.replace("G=2", "G=3"),
                        line.replace("p=3/4", "p=1/4"), line.replace("a=1/5", "a=1/4")):
                if new != line:
                    with self.subTest(new, head=head[1]):
                        self.no(text.replace(line, new), self.last(quantity))

    def test_a_quotient_of_others_is_refused(self):
        for quantity, text in self.texts.items():
            line = text.splitlines()[-2].split(" ")
            self.assertEqual(line[1], "quotient")
            parts = [str(n) for part in line[2].split(",") for n in range(int(part.split("-")[0]), int(part.split("-")[-1]) + 1)]
            for fewer in [parts[:k] + parts[k + 1:] for k in range(len(parts))]:
                with self.subTest(quantity, fewer=fewer):
                    self.no(text.replace(" ".join(line), " ".join([line[0], line[1], ",".join(fewer) or "-", *line[3:]])), self.last(quantity))
        swapped = self.texts["limit.exceedance"].replace(" p=3/4 scale", " p=P scale").replace(" p=0 scale", " p=3/4 scale").replace(" p=P scale", " p=0 scale")
        self.no(swapped, self.last("limit.exceedance"))  # the mean in contact over that above the pressure

    def test_means_are_of_their_quantity(self):
        means = {quantity: [line.split(" ")[0] for line in text.splitlines() if line.split(" ")[1:2] == ["mean"]][-1] for quantity, text in self.texts.items()}
        for quantity, old, new, why in (
                ("limit.exceedance", " p=3/4 scale=0", " p=3/4 scale=1", "no mean"), ("limit.force", " p=3/4 scale", " p=1/1025 scale", "too small"),
                ("limit.force", " p=3/4 scale", " p=0 scale", "too small"), ("limit.segments", " p=1/5 scale", " p=3/5 scale", "no half-width"),
                ("limit.force", " load=", " load=1/", ""), ("limit.force", " mean ", " share ", ""),
                ("limit.force", "quantity limit.force", "quantity limit.exceedance", "not proved"),
                *((("limit.force", "quantity limit.force", "quantity limit.density", ""), ) if known.long else ())):
            with self.subTest(quantity, new=new):
                text = self.texts[quantity]
                self.assertIn(old, text)
                self.no(text.replace(old, new, 1), f"{means[quantity]}-{means[quantity]}", (1, 65), why)

    def test_a_mean_beside_the_truth_is_refused(self):
        """by more than it says; with --long of a share of the area too, which test_wrong_values_are_refused has at pressure 0"""
        for quantity in ("limit.exceedance", "limit.force") if known.long else ("limit.force", ):
            text = self.texts[quantity]
            line = next(line for line in text.splitlines() if line.split(" ")[1:2] == ["mean"])
            value, error = line.split("value=")[1].split(" error=")
            with self.subTest(quantity):
                self.no(text.replace(line, line.replace(value, certificate_number(value, error))), line.split(" ")[0] + "-" + line.split(" ")[0], why="not proved")

    def test_a_distance_is_made_of_three_claims(self):
        """0.75/0.9 - 0.8 at n = 2, p = 3, and G = 3/2, where p is 27/4 in p*_0; of two of them, or of another pressure, there is none"""
        G, load, half = (Fraction(3, 2), 1), Fraction(1, 5), Fraction(1, 1000)
        claims = {"contact.exceedance": (2, Fraction(27, 4), load, G, Fraction(3, 4), half), "contact.area": (2, load, G, Fraction(9, 10), half),
                  "limit.exceedance": (Fraction(3), G, Fraction(4, 5), half)}

        def forms(quantities):
            made = [types.SimpleNamespace(quantity=q, count=1, claims={1: claims[q]}) for q in quantities]
            with unittest.mock.patch.object(check.certificate, "Certificate", lambda path: made[int(path)]), unittest.mock.patch.object(check.certificate, "Replay"):
                return check.with_certificates(check.scale_one.FORMS, [str(k) for k in range(len(made))])["limit.distance"]
        Interval.bits = 64
        low, high = forms(claims)(Fraction(2), Fraction(3), load, Fraction(3, 2)).ends()
        self.assertTrue(low <= (Fraction(3, 4) - half) / (Fraction(9, 10) + half) - Fraction(4, 5) - half and high >= (Fraction(3, 4) + half) / (Fraction(9, 10) - half) - Fraction(4, 5) + half)
        self.assertLess(high - low, 7 * half)
        self.assertIsNone(forms(claims)(Fraction(2), Fraction(2), load, Fraction(3, 2)))
        for fewer in itertools.combinations(claims, 2):
            self.assertIsNone(forms(fewer)(Fraction(2), Fraction(3), load, Fraction(3, 2)))

    def test_what_has_no_certificate(self):
        for arguments, why in ((("limit.density", "p=1/513", "G=3/2"), "1/512"), (("limit.exceedance", "p=1", "G=101/100"), "1.02"), (("limit.force", "p=1/2000", "G=3/2"), "1/1024"),
                               (("limit.exceedance", "p=299999/100000", "G=3/2"), "means below"), (("limit.distance", "n=2", "p=1", "load=1", "G=3/2"), "check.py")):
            said = program("certificate", *arguments, "--out", self.path)
            with self.subTest(arguments):
                self.assertIn(said.returncode, (2, 65), said.stderr)  # none at all, or none that this mesh gives
                self.assertIn(why, said.stderr)


def certificate_number(value, error):
    """value + 3 error, as certificates write it"""
    total, exponent = certificate_text.dyadic(value) + 3 * certificate_text.dyadic(error), 0
    while total.denominator > 1:
        total, exponent = total * 2, exponent - 1
    mantissa = total.numerator
    while mantissa % 2 == 0:
        mantissa, exponent = mantissa // 2, exponent + 1
    return f"{mantissa:x}:{exponent}"


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *rest])
