# SPDX-License-Identifier: MIT
"""Scale 1 in quadratures: its discs, its rules of Gauss, other ways to the same values, and inputs at the ends of its domain."""
import argparse
import ast
import cmath
import math
import pathlib
import random
import sys
import tokenize
import unittest
from fractions import Fraction

parser = argparse.ArgumentParser()
parser.add_argument("--checker", required=True, type=pathlib.Path)
parser.add_argument("--seed", type=int, default=20261125)
parser.add_argument("--long", action="store_true", help="every row above a pressure, more rows of the tables, densities at the ends of the domain")
known, rest = parser.parse_known_args()
sys.path.insert(0, str(known.checker))
import check  # noqa: E402
import intervals as iv  # noqa: E402
import scale_one  # noqa: E402
from intervals import Interval  # noqa: E402

# p, load, G: partial and full contact of either wave, both sides of the seams, next to where two ends meet, and in contact (p = 0).
ROWS = [("1/1000", "1/10", "3"), ("1/4", "1/2", "9/8"), ("1/3", "1/1000", "51/50"), ("1", "1", "3/2"), ("1/1000000", "999/1000", "3/2"), ("3", "3/2", "5/2"),
        ("5/2", "3/2", "5/2"), ("10", "10", "9/8"), ("1013/100", "10", "9/8"), ("987/100", "10", "9/8"), ("100", "100", "3/2"), ("0", "1/2", "5/4"), ("0", "3/2", "5/4")]


def rows():
    return [tuple(map(Fraction, row)) for row in ROWS]


class ScaleOne(unittest.TestCase):
    def setUp(self):
        Interval.bits = 160

    def complex_value(self, half, share, u):
        """the integrand at a complex u, by the textbook's formulas and the branches that continue those of real u"""
        two, sign = half.two, half.sign
        p, load, G = (float(x) for x in (two.p, two.load, two.G))
        v = float(Interval.of(half.wide).middle()) * u
        t = float(Interval.of(half.end).middle()) + sign * v * v

        def own_root(shift, side):
            return v if shift == 0 else cmath.sqrt(float(Interval.of(shift).middle()) + side * v * v)

        total = 2 * float(Interval.of(half.wide).middle()) * v
        for shift, side in half.first:
            total /= own_root(shift, side)
        if load < 1:
            R = cmath.sqrt((1 - load) ** 2 + t * t)
            total *= t / R * cmath.sqrt((1 + load + R) / (1 - load + R))
        if len(half.second) == 1 or p == 0:
            R = cmath.sqrt((G - t) ** 2 + p * p) if p else G - t
            if share:
                root, other = own_root(*half.second[0]), own_root(*half.second[1]) / math.sqrt(G) if p == 0 else cmath.sqrt((G - t + R) / (2 * G))
                sine = root * cmath.sqrt(2 / (G + t + R))
                return total * (cmath.asin(sine) if abs(sine) < 0.8 else math.pi / 2 - cmath.asin(other))
            return total * p / R * cmath.sqrt((G + t + R) / (G - t + R)) / (2 * math.sqrt(G)) / own_root(*half.second[0])
        low, high = (own_root(*place) for place in half.second)
        if not share:
            return total / low / high
        sine = low / math.sqrt(2 * G)
        return total * (cmath.asin(sine) if abs(sine) < 0.8 else math.pi / 2 - cmath.asin(high / math.sqrt(2 * G)))

    def test_discs_hold_the_integrand(self):
        """(U): at complex places, and that they are not empty words: some are within a hundred times of what is there."""
        chosen, tried, tight = random.Random(known.seed), 0, 0
        for p, load, G in rows():
            for half in scale_one.TwoWaves(p, load, G).halves:
                for share in (True, False) if p else (True, ):
                    integrand = scale_one.Integrand(half, share, scale_one.Disc.of)
                    for _ in range(25):
                        at, off = chosen.uniform(0, 1), 10 ** chosen.uniform(-6, -0.2)
                        try:
                            disc = integrand(scale_one.Disc(Interval.of(Fraction(at)), Interval.of(Fraction(off))))
                        except scale_one.Outside:
                            continue
                        tried += 1
                        centre, radius, worst = float(disc.centre.middle()), float(disc.radius.ends()[1]), 0
                        for k in range(12):
                            here = self.complex_value(half, share, at + off * chosen.choice((1, 1, 0.5)) * cmath.exp(2j * math.pi * (k + chosen.random()) / 12))
                            worst = max(worst, abs(here - centre))
                        self.assertLessEqual(worst, radius * 1.0000001 + 1e-9 * abs(centre), (p, load, G, share, half.sign, at, off))
                        tight += radius < 4 * worst
        self.assertGreater(tried, 300)
        self.assertGreater(tight, 100)

    def test_discs_hold_each_operation(self):
        chosen = random.Random(known.seed)

        def inside(x):
            angle, part = chosen.uniform(0, 2 * math.pi), chosen.choice((1, 1, chosen.random()))
            return float(x.centre.middle()) + float(x.radius.ends()[1]) * part * cmath.exp(1j * angle)

        for _ in range(2000):
            x, y = (scale_one.Disc(*(Interval.of(Fraction(chosen.uniform(*ends))) for ends in ((0.1, 3), (0, 2)))) for _ in "xy")
            z, w = inside(x), inside(y)
            for made, here in ((lambda: x + y, z + w), (lambda: 1 - x * y, 1 - z * w), (lambda: x / y, z / w), (lambda: 2 / x, 2 / z), (x.root, cmath.sqrt(z)), (x.square, z * z)):
                try:
                    disc = made()
                except scale_one.Outside:
                    self.assertTrue(float(x.centre.middle()) <= float(x.radius.ends()[1]) * 1.000001 or float(y.centre.middle()) <= float(y.radius.ends()[1]) * 1.000001)
                    continue
                self.assertLessEqual(abs(here - float(disc.centre.middle())), float(disc.radius.ends()[1]) * 1.0000001 + 1e-12)

    def test_rules_are_off_by_no_more(self):
        """(V): rules of few points against one of many, on the widest interval next to an end that has a disc. The bound holds, and is no empty word."""
        closest = 10**9
        for p, load, G in rows():
            for half in scale_one.TwoWaves(p, load, G).halves:
                share = p == 0
                bound, value = (scale_one.Integrand(half, share, of) for of in (scale_one.Disc.of, Interval.of))
                for k in range(1, 40):
                    b = Fraction(3, 4)**k
                    try:
                        M = bound(scale_one.Disc(Interval.of(b / 2), Interval.of(b / 2 * Fraction(17, 8)))).reach().ends()[1]
                        break
                    except scale_one.Outside:
                        pass
                best = scale_one.by_gauss(value, 0, b, 40)
                for K in (2, 4, 6):
                    off = max(map(abs, (scale_one.by_gauss(value, 0, b, K) - best).ends()))
                    said = scale_one.off_by(b / 2, M, 2, K, 160)
                    self.assertLessEqual(off, said, (p, load, G, share, K))
                    closest = min(closest, said / off)
        self.assertLess(closest, 1000)

    def test_all_in_full_contact_is_an_elliptic_integral(self):
        """load - 1 >= G: int (2/pi)/sqrt((c - a)(d - b)) K(k) = 1/AGM between the inner two of the ends a < b < c < d of both waves."""
        for p, load, G in (("10", "10", "9/8"), ("1013/100", "10", "9/8"), ("101", "100", "3/2"), ("99", "100", "3/2")):
            p, load, G = map(Fraction, (p, load, G))
            a, b, c, d = sorted((load - 1, load + 1, p - G, p + G))
            Interval.bits = 200
            x, y = iv.sqrt(Interval.of((c - a) * (d - b))), iv.sqrt(Interval.of((b - a) * (d - c)))
            for _ in range(12):
                x, y = (x + y).scaled(-1), iv.sqrt(x * y)
            low, high = (1 / (iv.pi() * x) - scale_one.density(p, load, G)).ends()
            with self.subTest(p=p, load=load, G=G):
                self.assertLess(max(abs(low), abs(high)), Fraction(1, 10**40))

    def test_shares_fall_as_densities_say(self):
        """Symmetric differences of shares against the density, which has other roots: to five digits."""
        above = [row for row in rows() if row[0]]
        for p, load, G in above if known.long else above[::2]:
            Interval.bits, h = 110, p / 2**14
            steps = [(scale_one.share(p - k * h, load, G) - scale_one.share(p + k * h, load, G)) / (2 * k * h) for k in (1, 2)]
            slope = (4 * steps[0] - steps[1]) / 3
            low, high = (slope / scale_one.density(p, load, G)).ends()
            with self.subTest(p=p, load=load, G=G):
                self.assertLess(max(abs(low - 1), abs(high - 1)), Fraction(1, 10**5))

    def test_what_is_wrong_in_the_last_digit(self):
        """Rows as printed are right, and wrong with the last digit one more or less."""
        for name in ("contact_density_scale_1", "contact_exceedance_scale_1"):
            header, all_rows = check.read(known.checker.parent / f"data/reference/{name}.txt")
            form = scale_one.FORMS[header["quantity"]]
            for row in random.Random(known.seed).sample(all_rows, 6 if known.long else 3):
                cells = row.split()
                mantissa, e, exponent = cells[4].partition("e")
                unit = Fraction(1, 10 ** len(mantissa.partition(".")[2]))
                for more, said in ((0, "right"), (unit, "wrong"), (-unit, "wrong")):
                    value = Fraction(mantissa) + more
                    digits = len(mantissa.partition(".")[2])
                    scaled = value * 10**digits
                    cells[4] = f"{scaled.numerator // 10**digits}.{scaled.numerator % 10**digits:0{digits}d}" + e + exponent
                    with self.subTest(row=row, value=cells[4]):
                        self.assertEqual(check.verdict(form, " ".join(cells), header["inputs"])[0], said)

    def test_ends_of_the_domain(self):
        for p, load, G in ((1, 0, 2), (1, -1, 2), (-1, 1, 2), (1, 1, 1), (1, 1, -2)):
            with self.assertRaises(ValueError):
                scale_one.share(*map(Fraction, (p, load, G)))
        tiny = Fraction(1, 10**300)
        self.assertIsNone(scale_one.density(Fraction(0), Fraction(1), Fraction(2)))
        self.assertIsNone(scale_one.density(Fraction(13, 2), Fraction(5), Fraction(5, 2)))  # two ends meet: t = 4 for both
        self.assertLess(scale_one.share(Fraction(13, 2), Fraction(5), Fraction(5, 2)).ends()[1], 1)
        self.assertEqual(scale_one.density(Fraction(1, 2), Fraction(10), Fraction(2)).ends(), (0, 0))
        for p, load, G in ((Fraction(1), tiny, Fraction(2)), (tiny, Fraction(1), Fraction(2)), (Fraction(1), 1 / tiny, Fraction(2)), (Fraction(1), Fraction(1), 1 / tiny), (Fraction(1), Fraction(1), 1 + tiny)):
            for form in (scale_one.share, scale_one.density) if known.long else (scale_one.share,):
                found = form(p, load, G)  # whatever it finds, it comes to an end
                self.assertTrue(found is None or found.low <= found.high)
        self.assertEqual(check.verdict(scale_one.FORMS["contact.exceedance"], "1 0 0 2 1 0", ["n", "p", "load", "G"])[0], "unreadable")

    def test_few_lines_are_to_be_believed(self):
        """What one reads for a value of scale 1: this file, closed forms, intervals, tables and the rules of Gauss it borrows."""
        total = 0
        for name in ("scale_one", "closed_forms", "intervals", "check", "full_contact"):
            path, lines = known.checker / f"{name}.py", set()
            parts = [node for top in ast.parse(path.read_text()).body for node in ([top, *top.body] if isinstance(top, ast.ClassDef) else [top])]
            wanted = {k for part in parts if getattr(part, "name", "") in ("Trigonometry", "__init__", "small", "cos_sin", "gauss") for k in range(part.lineno, part.end_lineno + 1)}
            first_class = next((part.lineno for part in parts if getattr(part, "name", "") == "Mesh"), 10**6)
            with open(path, "rb") as file:
                for token in tokenize.tokenize(file.readline):
                    if token.type not in (tokenize.COMMENT, tokenize.NL, tokenize.INDENT, tokenize.DEDENT, tokenize.ENCODING, tokenize.NEWLINE, tokenize.ENDMARKER, tokenize.STRING):
                        lines.update(range(token.start[0], token.end[0] + 1))
            total += len([k for k in lines if name != "full_contact" or (k in wanted and k < first_class)])
        self.assertLessEqual(total, 1000)
        self.assertGreater(total, 500)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *rest])
