# SPDX-License-Identifier: MIT
"""Densities with full contact: lemma AA of docs/certificate.md, part by part, and what the program says, and says wrongly, about contact.density."""
import argparse
import cmath
import copy
import functools
import hashlib
import json
import math
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
parser.add_argument("--program", required=True)
parser.add_argument("--seed", type=int, default=20261125)
known, rest = parser.parse_known_args()
sys.path.insert(0, str(known.checker))
import certificate  # noqa: E402
import density  # noqa: E402
import full_contact  # noqa: E402
import scale_one  # noqa: E402
import two_waves  # noqa: E402
from intervals import Interval  # noqa: E402
from scale_one import Disc  # noqa: E402

# Few panels; a logarithm within reach of the load's own wave; two levels, of which a wave is taken.
ROWS = (("n=2", "p=12", "load=10", "G=10^0.5", 2), ("n=2", "p=10", "load=10", "G=9/8", 1), ("n=3", "p=12", "load=2", "G=3", 1))
BITS = 160
FEW_BITS = 96  # of what is compared with sums in doubles
# P and G: the second wave with the seam, p < 2G, near it, and without.
WAVES = (("1/2", "3/2"), ("9/5", "13/12"), ("6/5", "3"), ("17/2", "13/12"), ("7/2", "27/25"))


def signed(text):
    body = text.rpartition("sha256 ")[0]
    return body + f"sha256 {hashlib.sha256(body.encode()).hexdigest()}\n"


def program(*arguments):
    return subprocess.run([known.program, *map(str, arguments)], capture_output=True, text=True)


def bare(P, G):
    """what of a mesh D_1 needs"""
    mesh = object.__new__(density.Density)
    mesh.bits, mesh.one, mesh.trig = BITS, 1 << BITS, full_contact.Trigonometry(BITS)
    mesh.first = two_waves.AfterTwoWaves(Interval.of(G), Interval.of(P), BITS)
    mesh.G, mesh.apart, mesh.lg = int(G * mesh.one), [], [[-BITS]]
    return mesh


def plain(P, G, x):
    """D_1 by the integral of scale_one.py"""
    bits, Interval.bits = Interval.bits, FEW_BITS
    value = float((scale_one.density(P * G, x, G) * G).middle())
    Interval.bits = bits
    return value


def continued(half, load, G, p, ends):
    """of a complex load, pi^2 times the integral over one half by the middle rule in u, by the textbook's formulas; ends(load): end and other end of t"""
    end, other, roots = ends(load)
    L, sign, total, N = abs(other - end) / 2 if isinstance(load, float) else (other - end) * half.sign / 2, half.sign, 0, 400
    for j in range(N):
        u = math.sin(math.pi / 2 * (j + 0.5) / N)
        t = end + sign * L * u * u
        value = 2 * L * u
        for place, side in roots:
            value /= cmath.sqrt(L) * u if place == end else cmath.sqrt((t - place) * side)
        if not half.full:
            R = cmath.sqrt((1 - load) ** 2 + t * t)
            value *= t / R * cmath.sqrt((1 + load + R) / (1 - load + R))
        if half.below_seam:
            R = cmath.sqrt((G - t) ** 2 + p * p)
            value *= p / R * cmath.sqrt((G + t + R) / (G - t + R)) / (2 * math.sqrt(G))
        total += value * math.cos(math.pi / 2 * (j + 0.5) / N) * math.pi / 2 / N
    return total


class Densities(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name) / "certificate.txt"
        cls.texts = []
        for row in ROWS:
            said = program("certificate", "contact.density", *row[:-1], "--digits", row[-1], "--out", cls.path)
            assert said.returncode == 0, said.stderr
            cls.texts.append(cls.path.read_text())

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def answer(cls, text):
        """what the checker says of it: None, or why not"""
        cls.path.write_text(signed(text))
        try:
            read = certificate.Certificate(cls.path)
            certificate.Replay(read, 1, read.count)
        except (certificate.Malformed, certificate.Refused) as why:
            return str(why)
        return None

    @classmethod
    @functools.cache
    def proved(cls, text):
        """what the checker says of it, its mesh, the mesh's errors and the bits of both: one proof, which takes seconds, for every test that asks"""
        kept = []

        def errors(mesh, progress, plain_errors=density.Mesh.errors):
            kept.append((mesh, plain_errors(mesh, progress)))
            return kept[-1][1]
        with unittest.mock.patch.object(density.Density, "errors", errors):
            said = cls.answer(text)
        return said, *kept[-1], Interval.bits

    def test_proves_what_the_program_says(self):
        for row, text in zip(ROWS, self.texts):
            with self.subTest(row=row):
                self.assertIsNone(self.proved(text)[0])
                self.path.write_text(text)
                ((*_, value, error),) = certificate.Certificate(self.path).claims.values()
                true = Fraction(json.loads(program("eval", "contact.density", *row[:-1], "--digits", row[-1] + 2, "--json").stdout)["value"])
                self.assertLessEqual(abs(value - true), error)
                self.assertLessEqual(error / value, Fraction(502, 1000 * 10 ** row[-1]))

    def test_a_wave_across_the_seam_is_not_left_out(self):
        """Half of the ratios lie on a panel where V_0 = 0 and little is looked for: both ends of the first wave are beyond the seam there, each on its side."""
        bits, kept, G = 96, 64, 1 << 14
        D, p, edges = 1 / math.pi / math.sqrt(3 / 4), 3 * G * G // 2, [(2 * G - 1 << bits) // 2, G << bits, (2 * G + 1 << bits) // 2]
        text = (f"TOUCHSTONE-CERT 1\nquantity contact.density\ncounts claims=1 sections=1 lines=4\nclaim 1 n=2 p={p} load={G * G} G={G} "
                f"value={int(D * 2**39) | 1:x}:-68 error=1:-40\nsection 1 span=1-4 meshes=1 polynomials=2 shares=1\n"
                f"1 mesh - 4 G={G} p={p} scale=2 load={G * G} bits={bits:x} kept={kept:x} accuracy=28 rise=0 {' '.join(f'{y:x}' for y in edges)}\n")
        for panel, (a, b) in enumerate(zip(edges, edges[1:])):
            low, high = a * a >> bits, b * b >> bits
            text += (f"{panel + 2} polynomials 1 4 panel={panel} middle={low + high >> 1:x} half={(high - low >> 1) + 2:x} terms=2 aim={(16, 32)[panel]:x} "
                     f"{int(D * 2**kept) * panel:x} 0\n")
        self.assertEqual(self.answer(text + "4 share 1-3 4 claim=1\nsha256 "), "line 4: the claim is not proved")

    def test_what_a_wave_makes_of_errors_counts_where_there_are_no_others(self):
        """V_0 = V_1 = 0: below the first panel, where nothing is known but D_1 = 0, T V_0 is V_1 and still T e_0 is not 0."""
        G, P, load, bits = Fraction(7, 4), Fraction(19, 10), Fraction(27, 100), 96
        one = 1 << bits
        edges = [int((P * P * G / 8) ** 2 * one) - (1 << 40), *(one * k // 100 for k in (70, 80, 90, 95, 100, 110, 120, 140))]
        places = [(a * a + b * b >> bits + 1, (b * b - a * a >> bits + 1) + 2) for a, b in zip(edges, edges[1:])]
        true = json.loads(program("eval", "contact.density", "n=3", f"p={P * G**3}", f"load={load}", f"G={G}", "--digits", 3, "--json").stdout)["value"]
        for aim in (0, 12):  # with the second what V_0 is off by is large, and is kept apart
            Interval.bits = bits + 128
            mesh = density.Density(Interval.of(G), Interval.of(P), load, bits, edges, places, [aim] * len(places), [[[0, 0], [0, 0]]] * len(places), 40, 16, 0)
            low, high = mesh.value(3, load, mesh.errors())
            self.assertLess(low, Fraction(true))
            self.assertGreater(high, Fraction(true))

    def test_discs_that_tell_nothing_of_the_seam_cost_a_cut(self):
        """Where the discs next to t = G are too wide for a root, the order of the ends is not taken beyond it: no more than that happens."""
        for P in (Fraction(1, 2), Fraction(1), Fraction(3, 2)):
            for G in (Fraction(3, 2), Fraction(1 << 14)):
                mesh = bare(P, G)
                x = int((G + 1) * mesh.one)
                self.assertGreater(mesh.first.beyond_seam(0, x, x + (mesh.one >> 20)), 0)
                with unittest.mock.patch.object(two_waves.Disc, "root", side_effect=two_waves.Outside):
                    self.assertGreater(mesh.first.beyond_seam(0, x, x + (mesh.one >> 20)), 1 << 50)

    def test_what_says_too_much_is_refused(self):
        text = self.texts[0]
        lines = {int(words[0]): words for words in (line.split(" ") for line in text.splitlines()) if words[0].isdigit()}
        mesh, claim, unit = lines[1], text.splitlines()[3], 1 << int(lines[1][9].split("=")[1], 16)
        edges = 12
        middle = (len(mesh) - edges) // 2
        moved = f"{(int(mesh[edges + middle], 16) + 3 * int(mesh[edges + middle + 1], 16)) // 4:x}"
        wide = sorted(n for n, words in lines.items() if words[1] == "polynomials")[1]  # what the load's wave has
        changed = {
            "a coefficient": {wide: [*lines[wide][:9], f"{int(lines[wide][9], 16) + unit // 8:x}", *lines[wide][10:]]},
            "a later coefficient": {wide: [*lines[wide][:-1], f"{int(lines[wide][-1], 16) + unit // 8:x}"]},
            "an edge moved": {1: [*mesh[:edges + middle], moved, *mesh[edges + middle + 1:]]},
            "a scale": {1: [w.replace("scale=2", "scale=3") for w in mesh]}, "a pressure": {1: [w.replace("p=12", "p=11") for w in mesh]},
            "a load": {1: [w.replace("load=10", "load=11") for w in mesh]}, "a surface": {1: [w.replace("G=10^1/2", "G=9^1/2") for w in mesh]},
            "a mesh that begins too late": {1: [*mesh[:edges], f"{(int(mesh[edges], 16) + 15 * int(mesh[edges + 1], 16)) // 16:x}", *mesh[edges + 1:]]},
        }
        for why, by_number in changed.items():
            new = text
            for number, words in by_number.items():
                new = new.replace(" ".join(lines[number]) + "\n", " ".join(words) + "\n", 1)
            with self.subTest(why):
                self.assertNotEqual(new, text)
                self.assertIsNotNone(self.answer(new))
        value = next(word for word in claim.split(" ") if word.startswith("value="))
        mantissa, _, exponent = value[6:].partition(":")
        for old, new in ((value, f"value={int(mantissa, 16) * 51 // 50 | 1:x}:{exponent}"), ("n=2", "n=3"), ("load=10", "load=9"), ("p=12", "p=11")):
            with self.subTest(new=new[:20]):
                self.assertIsNotNone(self.answer(text.replace(claim, claim.replace(old, new, 1), 1)))
        self.assertIsNotNone(self.answer(text.replace("contact.density", "contact.exceedance", 1)))

    def test_the_first_level_is_what_scale_one_says(self):
        """Values and bounds on intervals of loads, against the integral of scale_one.py at one load; and of complex loads, against sums."""
        chosen, seen = random.Random(known.seed), 0
        for P, G in ((Fraction(P), Fraction(G)) for P, G in WAVES):
            mesh = bare(P, G)
            for _ in range(12):
                x = Fraction(chosen.uniform(0.01, 1)) if chosen.random() < 0.5 else Fraction(chosen.uniform(1, float(G * P + G + 3)))
                width = x * Fraction(10 ** chosen.uniform(-5, -2))
                x1, x2 = (int((x + side * width) * mesh.one) for side in (-1, 1))
                if x1 < mesh.one < x2:
                    continue
                try:
                    value, size, off = mesh.first.on_disc(x1, x2, (x2 - x1) * 17 // 16, -40)
                except full_contact.Far:
                    continue
                at = x1 + int(chosen.random() * (x2 - x1))
                low, high = value(at)
                true = plain(P, G, Fraction(at, mesh.one))
                self.assertLessEqual(max(float(low) - true, true - float(high)), float(off) + 1e-14)
                self.assertGreaterEqual(float(size), true)
                self.assertLess(off, Fraction(1, 1 << 40))
                seen += 1
        self.assertGreater(seen, 40)

    def test_bounds_hold_at_complex_loads(self):
        chosen, seen = random.Random(known.seed), 0
        for P, G in ((Fraction(P), Fraction(G)) for P, G in WAVES):
            mesh = bare(P, G)
            p, g = float(P * G), float(G)
            for x in (Fraction(chosen.uniform(0.05, 0.9)), Fraction(chosen.uniform(1.2, float(G * P + G)))):
                r = x / 50
                try:
                    order, _ = mesh.first.one_order(int((x - r) * mesh.one), int((x + r) * mesh.one), Fraction(0))
                    disc = two_waves.Loads(mesh.first.waves, x >= 1, order, Disc(Interval.of(x), Interval.of(r)))
                    bounds = [float(two_waves.rules(half, Fraction(1, 1 << 20), BITS)[1]) for half in disc.halves]
                except (full_contact.Far, scale_one.Outside):
                    continue
                for k in range(5):
                    load = complex(x) + float(r) * cmath.exp(2j * math.pi * k / 5)
                    low, top = load - 1, load + 1 if x >= 1 else 2 * cmath.sqrt(load)
                    named = {"least": p * p / (4 * g), "bottom": p - g, "top": p + g, "G": g}
                    first = [(low, 1), (top, -1)] if x >= 1 else [(top, -1), (-top, 1)]
                    for half, bound in zip(disc.halves, bounds):
                        at = float(half.end.centre.middle())
                        other = float((half.end.centre + half.L.centre * (2 * half.sign)).middle())
                        places = [*named.values(), low, top]
                        end, far = (min(places, key=lambda place: abs(place - x)) for x in (at, other))
                        second = [(named["least"], 1)] if half.below_seam else [(named["bottom"], 1), (named["top"], -1)]
                        value = continued(half, load, g, p, lambda _: (end, far, first + second))  # noqa: B023
                        self.assertLessEqual(abs(value), bound * 1.01 + 1e-9)
                        seen += 1
        self.assertGreater(seen, 30)

    def test_one_formula_serves_beyond_the_seam(self):
        """The difference is there, less than is said, and without what is said it would not be covered."""
        for P, G in (("9/5", "13/12"), ("1/2", "3/2"), ("1/4", "6/5")):
            P, G = Fraction(P), Fraction(G)
            mesh = bare(P, G)
            for at in ((G / 2) ** 2, G + 1):
                w = Fraction(1, 1 << 10)
                x1, x2 = (int((at + side * w) * mesh.one) for side in (-1, 1))
                value, _, off = mesh.first.on_disc(x1, x2, (x2 - x1) * 17 // 16, 0)
                with unittest.mock.patch.object(two_waves.AfterTwoWaves, "beyond_seam", lambda *at, plain=two_waves.AfterTwoWaves.beyond_seam: plain(*at) / 10**9):
                    value, _, without = mesh.first.on_disc(x1, x2, (x2 - x1) * 17 // 16, -30)
                differ = max(abs(float(value(x)[0]) - plain(P, G, Fraction(x, mesh.one))) for x in (x1 + 1, x2 - 1))
                self.assertLess(differ, float(off))
                self.assertGreater(differ, float(without) * 10)

    def test_next_to_a_logarithm(self):
        """What D_1 counts for, against the measure that gives most to what is next to it: S sqrt(l/w) to a length l."""
        most = 0
        for P, G in ((Fraction(17, 2), Fraction(13, 12)), (Fraction(9, 5), Fraction(13, 12)), (Fraction(1, 2), Fraction(3, 2))):
            mesh = bare(P, G)
            ends = [float(P * G - G), float(P * G + G)] if P >= 2 else [float(P * P * G / 4), float(P * G + G)]
            for at in [Fraction(e + side) for e in ends for side in (-1, 1) if e + side > 1.01] + [Fraction(e * e / 4) for e in ends if e < 1.9]:
                for w in (Fraction(1, 1 << 20), ):
                    mesh.apart.clear()
                    mesh.hole(0, int(at * mesh.one), int((at + w) * mesh.one))
                    ((_, _, weight),) = mesh.apart
                    total, N = 0.0, 6
                    for j in range(N):  # l = w u^2, so that sqrt(l/w) = u; D_1 has log u there
                        u = ((j + 0.5) / N) ** 2
                        total += plain(P, G, at + w * Fraction(u * u)) * 2 * (j + 0.5) / N / N
                    self.assertLess(total, float(weight))
                    most = max(most, total / float(weight))
        self.assertGreater(most, 1 / 400)

    def test_shares_of_narrow_ratios_are_no_less(self):
        """of one load, and of each of an interval of them"""
        chosen = random.Random(known.seed)
        for load, G in ((Fraction(1, 3), Fraction(3, 2)), (Fraction(5), Fraction(9, 8)), (Fraction(99, 100), Fraction(2)), (Fraction(1), Fraction(3, 2))):
            mesh = bare(Fraction(1), G)
            for _ in range(200):
                x1 = load
                x2 = x1 + Fraction(chosen.choice([0, 10 ** chosen.uniform(-9, -2), 0.1]))
                x = chosen.choice([x1, x2, Fraction(chosen.uniform(float(x1), float(x2)))])
                low, high = (float((x - 1) / G), float((x + 1) / G)) if x >= 1 else (0.0, float(2 * math.sqrt(x) / G))
                w = 10 ** chosen.uniform(-9, -1)
                y = chosen.choice([chosen.uniform(0.8 * low, 1.1 * high), low + 10 ** chosen.uniform(-4, -2), high - w - 10 ** chosen.uniform(-4, -2)])
                said = float(mesh.share_of(*(int(v * mesh.one) for v in (Fraction(y), Fraction(y + w), x1, x2))))

                def angle(y, x=float(x), g=float(G)):
                    c = g * y - x if x >= 1 else math.sqrt(g * g * y * y + (1 - x) ** 2) - x
                    return math.acos(max(-1.0, min(1.0, c)))
                self.assertLessEqual((angle(y) - angle(y + w)) / math.pi, said * (1 + 1e-6) + 1e-8)
                if w < 1e-4 and low + (high - low) / 9 < y < high - (high - low) / 9 and x2 - x1 < w:
                    self.assertLessEqual(said, 10 * (angle(y) - angle(y + w)) / math.pi + 1e-8)

    def test_a_small_pressure_makes_much_of_a_logarithm(self):
        """The root of 1 + 2 G/p, p in p*_0, by which the second wave may have more at its least pressure."""
        for P, G in ((Fraction(1, 50), Fraction(3, 2)), (Fraction(1, 2), Fraction(2))):
            first = bare(P, G).first
            w = Fraction(1, 1 << 20)
            c_first = math.sqrt(2) / (math.pi * float(P * P * G / 4))
            c_second = (2 + math.sqrt(1 + 2 / float(P)) / 2) / (math.pi * math.sqrt(float(G)))
            said = float(first.weight(first.one // 2, first.one // 2 + int(w * first.one)))
            self.assertGreater(said, float(G) * c_first * c_second * (12 + 2 * math.log(1 + 2 / float(w))))
            self.assertLess(said, 2 * float(G) * c_first * c_second * (12 + 2 * math.log(1 + 2 / float(w))))

    def test_what_is_kept_apart_counts(self):
        """What holes of level 0 count for is added at the load of scale 2, and to what a wave makes of level 0 where there are more levels."""
        for text, later in ((self.texts[1], False), (self.texts[2], True)):
            said, mesh, found, Interval.bits = self.proved(text)
            self.assertIsNone(said)
            mesh = copy.copy(mesh)
            n, load = mesh.levels + 1, mesh.load
            low, high = mesh.value(n, load, found)
            self.assertGreater(len(mesh.apart), 0)
            mesh.apart = [(a, b, weight * 10**12) for a, b, weight in mesh.apart]
            if later:
                self.assertGreater(max(mesh.once(a, b) for a, b in zip(found[0], found[0][1:])), 1)
            else:
                self.assertGreater(mesh.value(n, load, found)[1] - high, 10 * (high - low))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *rest])
