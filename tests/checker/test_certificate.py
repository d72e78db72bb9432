# SPDX-License-Identifier: MIT
"""Certificates: what the program writes the checker proves, piece by piece too; what is changed in any kind of line it refuses, or proves to be true."""
import argparse
import cmath
import copy
import decimal
import functools
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
import types
import unittest
import unittest.mock
from fractions import Fraction

parser = argparse.ArgumentParser()
parser.add_argument("--checker", required=True, type=pathlib.Path)
parser.add_argument("--program", required=True)
parser.add_argument("--mutants", type=int, default=12)
parser.add_argument("--part", choices=["proofs", "others"], help="what is proved, or all other cases: each about half of the time")
parser.add_argument("--long", action="store_true", help="proofs that take minutes, and each kind of line under each kind of claim")
parser.add_argument("--seed", type=int, default=20261122)
known, rest = parser.parse_known_args()
sys.path.insert(0, str(known.checker))
import at_once  # noqa: E402
import certificate  # noqa: E402
import certificate_text  # noqa: E402
import distributions  # noqa: E402
import full_contact  # noqa: E402
import intervals as iv  # noqa: E402
import limits  # noqa: E402
import poisson  # noqa: E402
import transfer  # noqa: E402

# A rule depends on its arguments alone: a thousand replays of one certificate may share it.
plain_rule = transfer.Rule
rules = {}


def kept_rule(G, step, points, bits):
    key = (G.ends(), step, points, bits)
    if key not in rules:
        rules[key] = plain_rule(G, step, points, bits)
    return rules[key]


def program(*arguments):
    return subprocess.run([known.program, *map(str, arguments)], capture_output=True, text=True)


def check(*arguments):
    return subprocess.run([sys.executable, known.checker / "certificate.py", *map(str, arguments)], capture_output=True, text=True)


def answered(*arguments):
    return at_once.ask(certificate, *arguments)


def answered_from(line, path):
    """Of this line and those after it, given those before it: they are as they were where this is the first that has been changed."""
    last = re.search("lines=([0-9]+)", path.read_text())[1]
    return answered("--lines", f"{line}-{last}", path)


def answered_to_claim(path):
    """Of its last line alone, which proves its claim, given those before it: they are as they were where the claim has been changed."""
    last = re.search("lines=([0-9]+)", path.read_text())[1]
    return answered("--lines", f"{last}-{last}", path)


def signed(text):
    """text with the sha256 it ought to have: the mutants' author knows how to compute one"""
    body = text.rpartition("sha256 ")[0]
    return body + f"sha256 {hashlib.sha256(body.encode()).hexdigest()}\n"


DIGITS = {"contact.area": 30, "limit.area_constant": 8, "limit.gap": 8}  # of values to compare with; of other limits and of distributions:
DIGITS_OF_LIMITS, DIGITS_OF_DISTRIBUTIONS = 7, 20


@functools.lru_cache(None)
def true_value(quantity, inputs, G, digits=None):
    """by the program, which the checker knows nothing of"""
    names = certificate.CLAIMS[quantity].split()[:-3]
    digits = digits or DIGITS.get(quantity, DIGITS_OF_LIMITS if quantity.startswith("limit") else DIGITS_OF_DISTRIBUTIONS)
    said = program("eval", quantity, *(f"{name}={x}" for name, x in zip(names, inputs, strict=True)), f"G={G}", *(["--digits", digits] if quantity != "limit.scale" else []), "--json")
    return Fraction(json.loads(said.stdout)["value"])


def area(n, load, G, digits=None):
    """A_n/lambda_0"""
    return true_value("contact.area", (n, load), G, digits)


def distribution(quantity, n, at, load, G, digits=None):
    """a share above the pressure `at`, a density there, or that of segments of half-width `at`"""
    return true_value(quantity, (n, at, load), G, digits)


def limit(G, digits=None):
    """C(G)"""
    return true_value("limit.area_constant", (), G, digits)


def limiting(quantity, at, G, digits=None):
    """the limit of a share or density, which the program has from a function on a mesh"""
    return true_value(quantity, (at,), G, digits)


# What is changed in many ways, and how often: partial contact, full contact without and with a wave between, shares above a pressure, the limit.
CHANGED = {("contact.area", "n=2", "load=1/10", "G=16", "--digits", 6): 9, ("contact.area", "n=1", "load=3/2", "G=3/2", "--digits", 2): 7,
           ("contact.area", "n=2", "load=3/2", "G=4", "--digits", 2): 1, ("contact.exceedance", "n=1", "p=1/2", "load=3/2", "G=3/2", "--digits", 2): 3, ("limit.area_constant", "G=16", "--digits", 3): 3, ("limit.area_constant", "G=2", "--digits", 2 if known.long else 1): 2,
           ("contact.density", "n=3", "p=2", "load=1/10", "G=3", "--digits", 4): 6, ("limit.density", "p=1/2", "G=4", "--digits", 1): 4,
           ("limit.scale", "load=1/2", "tolerance=1/10", "G=16"): 3, ("limit.gap", "G=1000", "--digits", 2): 3}
# Its no comes only after the whole of another proof: left to ctest -R certificates_long.
MINUTE_LONG = ("contact.exceedance", "contact.density")


def complaints(stderr):
    """what is there beside progress, which a slow machine gets to see"""
    return [line for line in stderr.splitlines() if not line.startswith("line ")]


class Certificates(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name) / "certificate.txt"
        cls.texts = {}
        for what in CHANGED:
            cls.make(*what)
            cls.texts[what] = cls.path.read_text()
        cls.text = next(iter(cls.texts.values()))
        transfer.Rule = kept_rule

    @classmethod
    def tearDownClass(cls):
        transfer.Rule = plain_rule
        cls.folder.cleanup()

    @classmethod
    def make(cls, *arguments):
        made = program("certificate", *arguments, "--out", cls.path)
        assert made.returncode == 0, made.stderr

    def said_of(self, text, claim_only=False):
        """'proved' and the certificate, or 'no' and the reason; anything else is a crash. claim_only: its last line, given those before it"""
        path = pathlib.Path(self.folder.name) / "mutant.txt"
        path.write_text(text)
        try:
            read = certificate.Certificate(path)
            certificate.Replay(read, read.count if claim_only else 1, read.count)
        except (certificate.Malformed, certificate.Refused) as why:
            return "no", str(why)
        return "proved", read

    def test_proves_what_the_program_says(self):
        for inputs, digits in ((("1", "1", "41/20"), 7), (("3", "1/10", "3"), 20 if known.long else 12), (("2", "999999999999/1000000000000", "5^1/2"), 9), (("20", "1/1000000", "10000"), 4),
                               (("1", "1000", "3/2"), 6), (("1", "1/3", "51/50"), 4), (("2", "9/7", "7^1/2"), 2)):
            n, load, G = inputs
            self.make("contact.area", f"n={n}", f"load={load}", f"G={G.replace('^1/2', '^0.5')}", "--digits", digits)
            said = check(self.path)
            with self.subTest(inputs=inputs):
                self.assertEqual(said.returncode, 0, said.stdout + said.stderr)
                (claim,) = certificate.Certificate(self.path).claims.values()
                value, error = claim[3:]
                self.assertLessEqual(abs(value - area(n, load, G.replace("^1/2", "^0.5"), digits + 3)), error)
                self.assertLess(error / value, Fraction(1, 10**digits))

    def test_proves_limits(self):
        for G, digits in (("5/2", 5), *((("5/2", 7), ("2009/1000", 3), ("2", 2), ("1000000", 4), ("21/20", 2)) if known.long else ())):  # proved_mean has G = 2
            self.make("limit.area_constant", f"G={G}", "--digits", digits)
            said = check(self.path)
            with self.subTest(G=G):
                self.assertEqual(said.returncode, 0, said.stdout + said.stderr)
                ((_, value, error),) = certificate.Certificate(self.path).claims.values()
                self.assertLessEqual(abs(value - limit(G, digits + 3)), error)
                self.assertLess(error / value, Fraction(1, 10**digits))

    def test_proves_from_where_on_the_limit_holds(self):
        """What the program finds by other means; and no scale before, no smaller tolerance than the lines reach, no load that needs more of them."""
        for load, tolerance, G in (("1", "1/100", "9/4"), ("1/10", "1/50", "1000")):
            self.make("limit.scale", f"load={load}", f"tolerance={tolerance}", f"G={G}")
            text = self.path.read_text()
            said = check(self.path)
            with self.subTest(G=G):
                self.assertEqual(said.returncode, 0, said.stdout + said.stderr)
                ((*_, n, error),) = certificate.Certificate(self.path).claims.values()
                self.assertEqual((n, error), (int(json.loads(program("eval", "limit.scale", f"load={load}", f"tolerance={tolerance}", f"G={G}", "--json").stdout)["value"]), 0))
                for was, now, why in ((f"tolerance={tolerance}", "tolerance=9/10", "a scale before is within the tolerance"), (f"tolerance={tolerance}", "tolerance=1/1000000000000", "not near enough"),
                                      ("error=0:0", "error=1:-4", "no scale from 2"), ("value=[0-9a-f:]+", "value=5:-1", "no scale from 2"), (f"load={load}", "load=1001/1000", "a load above 1")):
                    answer, reason = self.said_of(signed(re.sub(was, now, text, count=1)), claim_only=True)
                    self.assertEqual((answer, why in reason), ("no", True), reason)
                for move, why in ((1, "a scale before is within the tolerance"), (-1, "is not within the tolerance")):
                    if n + move >= 2:
                        answer, reason = self.said_of(self.moved(text, int(n), move), claim_only=True)
                        self.assertEqual((answer, why in reason), ("no", True), reason)

    def moved(self, text, n, move):
        """the claim of scale n + move instead, resting on the levels that it needs"""
        lines = [line.split(" ") for line in text.splitlines()]
        *_, settling, _ = lines
        first, end = settling[2].split(",")[-1].split("-")
        first = int(first) + move * text.count(" panel ")
        settling[2] = f"1,{first}-{end}"
        for words in lines:
            if words[0].isdigit() and first <= int(words[0]) <= int(end):
                words[3] = settling[0]
        odd, shift = n + move, 0
        while odd % 2 == 0:
            odd, shift = odd // 2, shift + 1
        return signed(re.sub("value=[0-9a-f:]+", f"value={odd:x}:{shift}", "\n".join(" ".join(words) for words in lines) + "\n", count=1))

    def test_later_scales_are_within_the_bound(self):
        """(Y) at a load so small that the first levels are far from their limit there."""
        load, seen, at_load = "1/1000000", {}, {}
        self.make("limit.scale", f"load={load}", "tolerance=1/2", "G=3")
        ((*_, n, _),) = certificate.Certificate(self.path).claims.values()

        def look(replay, below, *_):
            for k in sorted({b[4] for b in below[1:]}):
                level = replay.whole(below[0], [b for b in below[1:] if b[4] == k], k)
                seen[k] = replay.from_then_on(below[0], Fraction(load), k, *level[:2])
                at_load[k + 1] = replay.at_load(below[0], Fraction(load), k + 1, *level)[0]
            raise certificate.Refused("looked at")
        with unittest.mock.patch.object(certificate.Replay, "settling", look):
            self.assertEqual(self.said_of(self.moved(self.path.read_text(), int(n), 3 - int(n)))[1].split(": ")[-1], "looked at")
        for k, (v, off) in seen.items():
            self.assertLessEqual(abs(limit("3", 12) - v), off + Fraction(1, 10**9))
            for M, h in at_load.items():
                if M > k:
                    self.assertLessEqual(abs(h - v), off + Fraction(1, 10**9), (k, M))
        self.assertGreater(abs(at_load[2] - seen[1][0]), seen[1][1] / 1000)

    def test_proves_shares_above_a_pressure(self):
        for inputs, digits in ((("1", "100", "395/4", "3/2"), 8), (("1", "1/1000", "1/200", "9/8"), 4), (("2", "3/2", "3", "4"), 2)):
            n, load, p, G = inputs
            self.make("contact.exceedance", f"n={n}", f"p={p}", f"load={load}", f"G={G}", "--digits", digits)
            said = check(self.path)
            with self.subTest(inputs=inputs):
                self.assertEqual(said.returncode, 0, said.stdout + said.stderr)
                ((*_, value, error),) = certificate.Certificate(self.path).claims.values()
                self.assertLessEqual(abs(value - distribution("contact.exceedance", n, p, load, G, digits + 3)), error)
                self.assertLess(error / value, Fraction(1, 10**digits))

    def test_proves_distributions_in_partial_contact(self):
        """Shares, densities and segments by the law of the load ratio; next to its ends, at load 1, and at the smallest G."""
        for quantity, n, at, load, G, digits in (("contact.density", 1, "1/1000", "1", "3", 8), ("contact.density", 3, "9/1000", "1/10", "41/20", 8), ("contact.exceedance", 1, "1/1000000000", "1", "3", 6),
                                                 ("contact.exceedance", 2, "33/10", "1/10", "3", 8), ("segments.density", 2, "1/7", "1", "3", 8), ("segments.density", 3, "1/10", "1/1000000", "7^0.5", 10)):
            self.make(quantity, f"n={n}", f"{'a' if quantity == 'segments.density' else 'p'}={at}", f"load={load}", f"G={G}", "--digits", digits)
            said = check(self.path)
            with self.subTest(quantity=quantity, n=n, at=at):
                self.assertEqual(said.returncode, 0, said.stdout + said.stderr)
                ((*_, value, error),) = certificate.Certificate(self.path).claims.values()
                self.assertLessEqual(abs(value - distribution(quantity, n, at, load, G, digits + 3)), error)
                self.assertLessEqual(error / value, Fraction(502, 1000 * 10**digits))
        said = program("certificate", "contact.area", "n=1", "load=2", "G=3", "--digits", 30)
        self.assertEqual((said.returncode, said.stdout.count("claim 1 "), "not 30" in said.stderr), (0, 1, True), said.stderr)
        self.assertEqual(program("certificate", "contact.area", "n=1", "load=1/2", "G=3", "--digits", 30).stderr, "")
        said = program("certificate", "contact.density", "n=1", "p=7", "load=1/10", "G=3")  # the largest pressure is 2 sqrt(0.1^(1/2) 6)
        self.assertEqual((said.returncode, "largest pressure" in said.stderr), (2, True), said.stderr)

    def mean(self):
        """the certificate of C(2): its text, and its lines by number"""
        text = next(text for what, text in self.texts.items() if "G=2" in what)
        return text, {int(words[0]): words for words in (line.split(" ") for line in text.splitlines()) if words[0].isdigit()}

    def poisson(self):
        """its mesh, for this test alone, and c"""
        mesh, c, iv.Interval.bits = self.proved_mean()
        mesh = copy.copy(mesh)
        mesh.found, mesh.seen = list(mesh.found), list(mesh.seen)
        return mesh, c

    @classmethod
    @functools.cache
    def proved_mean(cls):
        """the same as it is after its proof, which takes seconds and serves every test"""
        cls.path.write_text(next(text for what, text in cls.texts.items() if "G=2" in what))
        read, made = certificate.Certificate(cls.path), []

        class Kept(poisson.Poisson):
            def __init__(self, *arguments):
                super().__init__(*arguments)
                self.seen = []
                made.append(self)

            def residual(self, p, x1, x2, inner):
                bound = super().residual(p, x1, x2, inner)
                self.seen.append((x1, x2, bound))
                return bound

            def hole(self, p, x1, x2):
                bound = super().hole(p, x1, x2)
                self.seen.append((x1, x2, bound))
                return bound

        with unittest.mock.patch.object(poisson, "Poisson", Kept):
            certificate.Replay(read, 1, read.count)
        return made[0], read.claims[1][1], iv.Interval.bits

    def test_bounds_of_the_residual_hold(self):
        """(W): B_0 - c x - V/G + T V in binary64, by the rule of the midpoint in 6000 angles, on intervals that a proof looked at, and on narrow holes: some of 2 digits, and what 1 digit has to do without."""
        mesh, c = self.poisson()
        edges, one, G, chosen = [y / mesh.one for y in mesh.edges], mesh.one, 2.0, random.Random(known.seed)

        def V(y):
            p = mesh.panel(int(y * one))
            if p < 0 or y >= edges[-1]:
                return 0.0
            middle, half = mesh.places[p]
            t = (y * y * one - middle) / half
            return sum(k * math.cos(i * math.acos(t)) if abs(t) <= 1 else k for i, k in enumerate(mesh.series[p][0])) / 2.0**mesh.kept

        def R(x):
            angles = 6000
            top = math.pi if x >= 1 else math.acos(1 - 2 * x)  # in contact
            total = 0
            for k in range(angles):
                cosine = math.cos(top * (k + 0.5) / angles)
                z = (x + cosine) ** 2 if x >= 1 else max(0.0, (1 + cosine) * (2 * x - 1 + cosine))
                total += V(math.sqrt(z) / G)
            return (2 / math.pi * math.asin(math.sqrt(x)) if x < 1 else 1.0) - float(c) * x - V(x) / G + total / angles * top / math.pi

        seen, ends, width = list(mesh.seen), (mesh.edges[0], mesh.edges[mesh.farthest[-1]]), one >> 21
        if known.long:
            narrow = chosen.sample([s for s in seen if s[1] - s[0] < one >> 20], 6)
        else:
            places = [one - width, one, *(chosen.randrange(*ends) for _ in range(4))]
            narrow = [(x, x + width, mesh.hole(mesh.panel(x), x, x + width)) for x in places if mesh.panel(x) == mesh.panel(x + width - 1)]
        self.assertGreater(len(narrow), 4)
        for x1, x2, bound in [*chosen.sample(seen, 12), *narrow]:
            for part in (0.01, chosen.random(), 0.99):
                x = (x1 + part * (x2 - x1)) / one
                self.assertLessEqual(abs(R(x)), float(bound) * 1.001 + 3e-6, (x1 / one, x2 / one))
        x = edges[0] / 2
        self.assertLessEqual(abs(R(x)), float(mesh.found[0][1]))
        total = sum((b - a for a, b, _ in seen), Fraction(0)) + mesh.edges[0]
        self.assertEqual(total, mesh.edges[mesh.farthest[-1]])  # and they cover all

    def test_what_inner_panels_give_is_had_once(self):
        """(K): on intervals in one another, what is said of T V at any place is what the panels named give, to what is said."""
        bits, chosen, seen, deepest = 128, random.Random(known.seed), 0, 0
        one, edges = 1 << bits, [(1 << 128) * k // 256 for k in (*range(1, 16), *range(16, 384, 3))]
        places = [(a * a + b * b >> bits + 1, (b * b - a * a >> bits + 1) + 2) for a, b in zip(edges, edges[1:])]
        series = [[[chosen.randrange(-one, one) >> 4 * k for k in range(6)]] for _ in places]
        mesh = poisson.Poisson(transfer.Interval.of(3), Fraction(0), 3, bits, edges, places, [30] * len(places), series, bits, 30, 0)
        for _ in range(30):
            a, b = chosen.choice([(one // 64, one), (one, 3 * one)])
            a, b = sorted(chosen.randrange(a, b) for _ in "ab")
            inner = poisson.Inner()
            for _ in range(4):
                with unittest.mock.patch.object(poisson, "FEW", 1):  # the mesh is a small one
                    inner = mesh.more(a, b, inner)
                at = chosen.choice([a, b])
                a, b = max(a, at - (b - a) // 5), min(b, at + (b - a) // 5)
            deepest = max(deepest, len(inner.parts))
            for x in (a, b) if inner.panels else ():
                seen += 1
                (true, ) = mesh.row(x, -1, len(mesh.series), 60, inner.panels)
                self.assertLess(abs(mesh.inner_at(x, inner) - true), inner.off * mesh.unit, (x / one, (b - a) / one))
                self.assertLess(inner.off, Fraction(1, 2**30))
        self.assertGreater(seen, 40)
        self.assertGreater(deepest, 1)

    def test_one_level_is_summed_as_many_are(self):
        """(L): Clenshaw's recurrence and the sums of Chebyshev polynomials, in the panel and where it is continued; zeros at the end of a polynomial."""
        mesh, _ = self.poisson()
        chosen, p = random.Random(known.seed), len(mesh.series) // 2
        self.assertEqual([poisson.without_zeros(c) for c in ([3, 0, 1, 0, 0], [0, 0], [5])], [[3, 0, 1], [0], [5]])
        for reach in (1, Fraction(17, 16)):
            most = int(reach * (1 << mesh.work))
            rule = [(chosen.randrange(-most, most), chosen.randrange(1 << mesh.work)) for _ in range(200)]
            here, of_many = mesh.integral(p, rule)[0], full_contact.Mesh.integral(mesh, p, rule)[0]
            self.assertLess(abs(here - of_many), mesh.round * mesh.unit)
            self.assertGreater(abs(here), 1 << mesh.work)

    def test_a_residual_that_is_large_counts(self):
        """(X): the least of a + sum (R - a) share, by trying; c beside the truth by more than it says."""
        mesh, c = self.poisson()
        chosen = random.Random(known.seed)
        for _ in range(20):
            mesh.found = [(int(mesh.one * 10 ** chosen.uniform(-8, 0)), Fraction(chosen.randrange(1, 1000), 1000)) for _ in range(chosen.randrange(1, 60))]
            shares = [(mesh.share(width), bound) for width, bound in mesh.found]
            tried = [a + sum(max(0, bound - a) * share for share, bound in shares) for a in [0, *(bound for _, bound in mesh.found)]]
            self.assertEqual(mesh.means(), min(tried))
        for width in (10**-9, 0.001, 0.5, 2.0):
            self.assertGreaterEqual(float(mesh.share_of_one(int(width * mesh.one))), min(1, 2 / math.pi * math.asin(math.sqrt(min(1, 2 * width / 2)))))
        for off in (Fraction(1, 50), Fraction(-1, 50)):
            self.assertGreater(mesh.off_by(c + off), Fraction(1, 50))

    def test_narrow_ratios_count_for_little_after_two_waves(self):
        """(X): G^2 T^2 1_J/G^2 by sums over the second wave, J where ends of both waves meet and elsewhere, is no more than a share; that of one wave alone is more."""
        mesh, _ = self.poisson()
        G, chosen, nearest = mesh.G / mesh.one, random.Random(known.seed), 0

        def angle(x, y):
            c = G * y - x if x >= 1 else math.sqrt((G * y) ** 2 + (1 - x) ** 2) - x
            return math.acos(max(-1.0, min(1.0, c)))
        for _ in range(60):
            w, x = 10 ** chosen.uniform(-7, -1), chosen.choice([chosen.uniform(0.05, 1), chosen.uniform(1, 1 / (G - 1))])
            top = (1 + x) / G if x >= 1 else 2 * math.sqrt(x) / G
            y = chosen.choice([chosen.uniform(0, top), (1 + top) / G - w, (1 + top) / G - 2 * w, 2 * math.sqrt(min(1, top)) / G - w, abs(top - 1) / G + w])
            total, N = 0.0, 4000
            for k in range(N):  # of theta, finest at the ends, where most of it is
                theta = math.pi * (1 - math.cos(math.pi * (k + 0.5) / N)) / 2
                square = (x + math.cos(theta)) ** 2 if x >= 1 else (1 + math.cos(theta)) * (2 * x - 1 + math.cos(theta))
                if square > 0:
                    ratio = math.sqrt(square) / G
                    total += (angle(ratio, y) - angle(ratio, y + w)) / math.pi * math.sin(math.pi * (k + 0.5) / N) * math.pi / 2 / N
            said = float(mesh.share(int(w * mesh.one))) / G**2
            self.assertLessEqual(total, said * 1.01)
            nearest = max(nearest, total / said)
        self.assertGreater(nearest, 1 / 20)
        self.assertLess(mesh.share(mesh.one >> 30), mesh.above_G * mesh.share_of_one(mesh.one >> 30) / 100)

    def test_a_mean_that_says_too_much_is_refused(self):
        text, lines = self.mean()
        mesh, claim = lines[1], text.splitlines()[3]
        middle = next(n for n in sorted(lines) if lines[n][1] == "polynomials" and int(lines[n][4].split("=")[1], 16) == len(lines) // 2)
        load, half = next(w for w in mesh if w.startswith("load=")), 1 << int(mesh[9].split("=")[1], 16) - 1
        changed = {
            "a coefficient": {middle: [*lines[middle][:9], f"{int(lines[middle][9], 16) + half:x}", *lines[middle][10:]]},
            "a later coefficient": {middle: [*lines[middle][:-1], f"{int(lines[middle][-1], 16) + half:x}"]},
            "loads that end too early": {1: [w if w != load else "load=99/100" for w in mesh]},
            "another G": {1: [w.replace("G=2", "G=3") for w in mesh]}, "a pressure": {1: [w.replace("p=0", "p=1") for w in mesh]},
            "a mesh that begins where contact is full": {1: [*mesh[:12], f"{1 << (int(mesh[8].split('=')[1], 16)):x}", *mesh[13:]]},
            "a panel is missing": {max(lines): [w.replace(f"1-{max(lines) - 1}", f"1-{max(lines) - 2}") for w in lines[max(lines)]]},
        }
        for why, by_number in changed.items():
            new = text
            for number, words in by_number.items():
                new = new.replace(" ".join(lines[number]) + "\n", " ".join(words) + "\n", 1)
            self.assertNotEqual(new, text, why)
            self.path.write_text(signed(new))
            with self.subTest(why):
                said = answered_from(min(by_number), self.path)
                self.assertIn(said.returncode, (1, 65), said.stdout)
        error = claim.split("error=")[1]
        self.path.write_text(signed(text.replace(f"error={error}", "error=1:-20", 1)))
        self.assertEqual(answered_to_claim(self.path).returncode, 1)

    def test_proves_limiting_distributions(self):
        """Shares of the area, of the force and of segments, and densities, as n tends to infinity: next to no pressure; with --long to more digits, at the smallest G and next to the largest pressure too."""
        chosen = (("limit.density", "1/100", "3", 1), ("limit.force", "1/300", "100", 1))
        more = (("limit.exceedance", "1/2", "10^0.5", 3), ("limit.density", "1/100", "3", 3), ("limit.segments", "1/7", "5/2", 2), ("limit.force", "1/300", "1000", 1),
                ("limit.force", "19/10", "41/20", 2), ("limit.exceedance", "13/10", "3", 2))
        for quantity, at, G, digits in more if known.long else chosen:
            self.make(quantity, f"{'a' if quantity == 'limit.segments' else 'p'}={at}", f"G={G}", "--digits", digits)
            said = check(self.path)
            with self.subTest(quantity=quantity, at=at):
                self.assertEqual(said.returncode, 0, said.stdout + said.stderr)
                ((*_, value, error),) = certificate.Certificate(self.path).claims.values()
                self.assertLessEqual(abs(value - limiting(quantity, at, G, digits + 3)), error)
                self.assertLessEqual(error / value, Fraction(502, 1000 * 10**digits))
        for quantity, place, G, why in (("limit.density", "p=4/3", "3", "largest pressure"), ("limit.segments", "a=1/2", "3", "largest pressure")):
            said = program("certificate", quantity, place, f"G={G}")
            self.assertEqual((said.returncode, why in said.stderr), (2, True), said.stderr)
        said = program("certificate", "contact.exceedance", "n=60", "p=1/2", "load=1/10", "G=3", "--digits", 3)
        self.assertEqual((said.returncode, "below the numbers of binary64" in said.stderr), (65, True), said.stderr)

    @unittest.skipUnless(known.long, "a minute: ctest -R certificates_long")
    def test_proves_a_distance_from_the_limit(self):
        """from laws in binary64, and in pairs of it, of which one would be refused in binary64"""
        inputs = ("n=2", "p=1/10", "load=1/100", "G=10")
        true = Fraction(json.loads(program("eval", "limit.distance", *inputs, "--digits", 13, "--json").stdout)["value"])
        for digits in (4, 10):
            self.make("limit.distance", *inputs, "--digits", digits)
            said = check(self.path)
            self.assertEqual((said.returncode, "load=1/100 G=10: -" in said.stdout), (0, True), said.stdout + said.stderr)
            ((*_, value, error),) = certificate.Certificate(self.path).claims.values()
            self.assertLessEqual(abs(value - true), error)
            self.assertLess(error / abs(value), Fraction(1, 10**digits))

    def law(self):
        """the certificate of a density at scale 3: its text, its lines by number and those of level 3"""
        text = next(text for what, text in self.texts.items() if what[0] == "contact.density")
        lines = {int(words[0]): words for words in (line.split(" ") for line in text.splitlines()) if words[0].isdigit()}
        return text, lines, [number for number, words in lines.items() if words[1] == "piece" and "m=3" in words]

    def test_a_law_that_says_too_much_is_refused(self):
        text, lines, third = self.law()
        first, claim = next(n for n, words in lines.items() if words[1] == "piece"), text.splitlines()[3]
        error = next(w for w in lines[third[0]] if w.startswith("error="))
        changed = {
            "a smaller error": {n: [w if w != error else "error=1:-60" for w in lines[n]] for n in third},
            "the first piece has another power": {third[0]: [w.replace("power=1", "power=2") for w in lines[third[0]]]},
            "another coefficient": {third[-1]: [*lines[third[-1]][:-6], f"{int(lines[third[-1]][-6], 16) + (1 << 44):x}", *lines[third[-1]][-5:]]},
            "a gap": {third[0]: [w if not w.startswith("high=") else "high=1:-2" for w in lines[third[0]]]},
            "a piece beyond its polynomial": {third[0]: [w if not w.startswith("radius=") else "radius=1:-4" for w in lines[third[0]]]},
            "level 2 rests on itself": {third[0]: [w.replace("m=3", "m=2") for w in lines[third[0]]]},
            "an error less than those it rests on": {n: [w if w != error else "error=1:-99" for w in lines[n]] for n in third},
            "a piece wild between the points": {first: [*lines[first][:-1], f"{int(lines[first][-1], 16) + (1 << 45):x}"]},
            "G at its end": {1: [w.replace("G=3", "G=2") for w in lines[1]]}, "another load": {1: [w.replace("1/10", "1/11") for w in lines[1]]},
        }
        for why, by_number in changed.items():
            new = text
            for number, words in by_number.items():
                new = new.replace(" ".join(lines[number]) + "\n", " ".join(words) + "\n", 1)
            self.assertNotEqual(new, text, why)
            self.path.write_text(signed(new))
            with self.subTest(why):
                said = answered_from(min(by_number), self.path)
                self.assertEqual((said.returncode, said.stdout[:4]), (1, "no: "), said.stdout)
        for old, new in (("p=2 ", "p=3 "), ("n=3 ", "n=2 "), ("G=3 value", "G=4 value"), ("load=1/10 G=3 value", "load=1/9 G=3 value")):
            self.path.write_text(signed(text.replace(claim, claim.replace(old, new), 1)))
            with self.subTest(new):
                self.assertEqual(answered_to_claim(self.path).returncode, 1)

    def two_levels(self):
        """the laws of a certificate, and its pieces of levels 2 and 3"""
        _, lines, third = self.law()
        iv.Interval.bits = 128
        second = [words for number, words in lines.items() if words[1] == "piece" and number not in third]
        read = [[distributions.Polynomial(*certificate.fields(words[4:12], certificate.FORMS["piece"], "")[1:7], [certificate.integer(c) for c in words[12:]])
                 for words in level] for level in (second, [lines[n] for n in third])]
        return distributions.Laws(iv.Interval.of(3), Fraction(1, 10), 128), *read

    def test_pieces_are_compared_as_well_as_the_target_asks(self):
        """(K): what lies between the points is little beside it: of a piece and itself nothing else is left."""
        laws, second, _ = self.two_levels()
        V = second[-1]
        for bits in (20, 50, 70, 90):
            with self.subTest(bits=bits):
                self.assertLess(laws.mismatch(V, V, V.low, V.high, Fraction(1, 2**bits)), Fraction(1, 2**bits) / 3)

    def test_rounding_cuts_no_piece(self):
        """A cut of level 2 and a piece's end at the same place, but for rounding, are one; where a piece is not proved so, it is cut there."""
        laws, _, third = self.two_levels()
        V = third[-1]
        for at, is_one in ((V.low + Fraction(1, 2**60), True), (V.high - Fraction(1, 2**60), True), ((V.low + V.high) / 2, False)):
            below = [types.SimpleNamespace(low=low) for low in (Fraction(0), at * (2 - at))]
            cut = next(r.ends()[0] for W, r in distributions.of_ratios(below) if W.low)
            for proved in (lambda a, b: True, lambda a, b: not a < cut < b):
                tried = []
                with unittest.mock.patch.object(laws, "defect", lambda m, pieces, V, a, b, target: tried.append((a, b)) or (target if proved(a, b) else 1)):
                    laws.prove(2, below, V, Fraction(1, 2**20), lambda _: None)
                last = sorted((a, b) for a, b in tried if proved(a, b))
                with self.subTest(at=float(at), proved=len(last)):
                    self.assertEqual((last[0][0], last[-1][1], [b for _, b in last[:-1]]), (V.low, V.high, [a for a, _ in last[1:]]))
                    self.assertEqual(tried == [(V.low, V.high)], is_one and proved(V.low, V.high))
                    self.assertEqual(cut in [a for a, _ in last], not (is_one and proved(V.low, V.high)))

    def limit_law(self):
        """the certificate of a limiting density, G = 4: its text, its lines by number, and the law, parts and error of a balance in it"""
        text = next(text for what, text in self.texts.items() if what[0] == "limit.density")
        lines = {int(words[0]): words for words in (line.split(" ") for line in text.splitlines()) if words[0].isdigit()}
        iv.Interval.bits = 128
        parts = [distributions.Polynomial(*certificate.fields(words[4:10], certificate.FORMS["part"], ""), [certificate.integer(c) for c in words[10:]])
                 for words in lines.values() if words[1] == "part"]
        (error,) = {certificate_text.dyadic(words[5].partition("=")[2]) for words in lines.values() if words[1] == "balance"}
        return text, lines, limits.Limit(iv.Interval.of(4), 128), parts, error

    def test_a_limit_that_says_too_much_is_refused(self):
        text, lines, *_ = self.limit_law()
        parts, balances, claim = *([n for n, words in lines.items() if words[1] == kind] for kind in ("part", "balance")), text.splitlines()[3]

        def with_(number, old, new):
            words = [w if not w.startswith(old) else new for w in lines[number]]
            return {number: words}
        swapped = {balances[0]: [*lines[balances[0]][:4], "part=1", lines[balances[0]][5]]}
        changed = {
            "a smaller error": (with_(balances[3], "error=", "error=1:-60"), "is no approximation|further from the law"), "another coefficient": ({parts[-1]: [*lines[parts[-1]][:-2], f"{int(lines[parts[-1]][-2], 16) + (1 << 48):x}", lines[parts[-1]][-1]]}, "no: "),
            "a gap": (with_(parts[2], "high=", "high=1:-9"), "not a part of"), "a gap between": (with_(parts[-1], "low=", "low=8001:-16"), "do not follow one another|of another piece"), "an end below 1": (with_(parts[-1], "high=", "high=ffff:-16"), "do not follow one another"),
            "another power": (with_(parts[3], "power=", "power=0"), "no: "), "a part without balance": (swapped, "not all balanced"), "no such part": (with_(balances[0], "part=", f"part={len(parts)}"), "not a balance"),
            "a part from 0 on": (with_(parts[0], "low=", "low=0:0"), "not a part of"), "G at its end": (with_(1, "G=", "G=2"), "G > 2"), "another G": (with_(1, "G=", "G=5"), "no: "), "no error": (with_(balances[1], "error=", "error=0:0"), "not a balance"),
        }
        for why, (by_number, said_why) in changed.items():
            new = text
            for number, words in by_number.items():
                new = new.replace(" ".join(lines[number]) + "\n", " ".join(words) + "\n", 1)
            self.assertNotEqual(new, text, why)
            self.path.write_text(signed(new))
            with self.subTest(why):
                said = answered_from(min(by_number), self.path)
                self.assertEqual((said.returncode, said.stdout[:4]), (1, "no: "), said.stdout)
                self.assertRegex(said.stdout, said_why)
        for what, new in (("p=1/2 ", "p=1/3 "), ("p=1/2 ", "p=1 "), ("p=1/2 ", "p=3/2 "), ("G=4 value", "G=5 value")):  # 1 is the largest pressure
            self.path.write_text(signed(text.replace(claim, claim.replace(what, new), 1)))
            with self.subTest(new):
                self.assertEqual(answered_to_claim(self.path).returncode, 1)
        first = next(p for p in parts if lines[p][5] == "high=1:-1")  # a law that begins where much of the force is: nothing that leaks may be left out
        kept = [" ".join(["steady - 0", *lines[1][4:]]), *(" ".join(["part 1 0", *lines[p][4:]]) for p in parts if p > first)]
        last, count = str(2 * len(kept)), len(kept) - 1
        kept = [line.replace(" 0 ", f" {last} ", 1) for line in [*kept, *(f"balance 1-{count + 1} 0 part={k} error=1:-1" for k in range(count)), f"tending 1-{2 * count + 1} 0 claim=1"]]
        self.write("limit.exceedance", ["p=1/2 G=4 value=1:-1 error=7:-4"], kept)
        said = answered(self.path)
        self.assertEqual((said.returncode, "more is needed of a piece" in said.stdout), (1, True), said.stdout)

    def test_chains_come_together(self):
        """(S), (T): what is said of one wave holds of it, by sums over its angles in doubles."""
        chosen, n = random.Random(known.seed), 4000
        angles = [math.pi / 2 * (k + 0.5) / n for k in range(n)]  # u = sin of it
        units = [(math.sin(t), 4 / math.pi * math.cos(t) ** 2 * math.pi / 2 / n) for t in angles]

        def wave(x, w):  # (S) p_x
            R = math.sqrt((1 - x) ** 2 + 4 * w)
            return 2 / math.pi * math.sqrt((1 + x + R) / (1 - x + R)) / R * math.sqrt(w / (x - w)) / x
        self.assertAlmostEqual(sum(m for _, m in units), 1)
        for G in (2.05, math.sqrt(5), math.sqrt(10), 6):
            law = limits.Limit(iv.Interval.of(Fraction(G)), 128)
            Y, forgets = 4 / G**2, float(law.contraction().middle())
            majorant = sum(m * max(0.5, abs(1 - 2 * u * u) / (2 * (1 - u * u))) for u, m in units)
            self.assertAlmostEqual(forgets, 0.5 if Y <= 2 / 3 else majorant, 4)
            for _ in range(40):
                x = Y * 10 ** chosen.uniform(-3, 0)
                far = min(1, x * math.exp(10 ** chosen.uniform(-5, 0)) / Y) * Y
                self.assertLessEqual(sum(m * abs(1 - 2 * x * u * u) / (2 * (1 - x * u * u)) for u, m in units), forgets)
                places = [(x * (1 - u * u) * (1 - x * u * u), m) for u, m in units]
                apart = sum(m * max(0, 1 - wave(far, w) / wave(x, w)) for w, m in places)
                self.assertLessEqual(apart, 2 * math.sqrt(math.log(far / x)) + 1e-9, (G, x, far))
                self.assertLessEqual(sum(m * G / (2 * math.sqrt(w)) for w, m in places), max(1 / x, G**2))
                top, w = 2 * math.sqrt(x) / G, Y * 10 ** chosen.uniform(-2, 0)
                if w < top:
                    nodes = [(top + w) / 2 + (top - w) / 2 * math.cos(t * 2) for t in angles[::10]]
                    twice = sum(wave(x, (G * y / 2) ** 2) * math.sqrt(top - y) * wave(y, w) * math.sqrt(y - w) * G**2 / 2 * y for y in nodes) / len(nodes) * math.pi
                    self.assertLessEqual(twice, 8 / math.pi * math.sqrt(w) * top**-1.5 / (1 - Y) ** 3)

    def test_what_is_said_of_the_limit_is_the_lemma(self):
        """(T) in doubles, written again: errors of shares, forces and densities; and what leaks is less than is said."""
        _, _, law, parts, error = self.limit_law()
        G, Y, low, eta = 4, 1 / 4, float(parts[0].low), float(error)
        wide = Fraction(1, 10**6)
        leak = float(distributions.top(law.leak(parts)))
        n, leaks = 40, 0
        for k in range(n):  # T' = low t^2
            t = (k + 0.5) / n
            T = low * t * t
            if T * (2 - T) > low:
                dx = Y / (2 * math.sqrt(1 - T)) * 2 * low * t / n
                leaks += Y**2 * (1 - T) * float(law.density(0, distributions.of_ratios(parts), iv.Interval.of(Fraction(T)), Fraction(1, 10**20)).middle()) * dx
        self.assertGreater(leaks, leak / 300)
        self.assertLess(leaks, leak)
        largest = max(sum(map(abs, p.coefficients)) * 2.0**p.exponent * float(p.high) ** (p.power / 2) for p in parts if p.low < 2 * low)
        self.assertAlmostEqual(leak / (8 * Y**3 * low**1.5 * largest / (3 * math.pi * (1 - Y) ** 1.5)), 1, 9)
        area = float(law.read(0, "share", iv.Interval.of(1), parts, wide).middle())
        w = (1 / 2) ** 2 / 4

        def said(here, late, size, at_once, later, eta=eta, leak=leak, area=area):
            far, root = 6 * math.sqrt(Y) * (eta * G * area / (1 - eta) + 2 * leak / Y) * size, math.sqrt(0.5)
            offs, total = [], 0
            for k in range(400):
                if k >= late:
                    offs.append(total + far * root ** (k - late) / (1 - root))
                off = eta * here + leak * (later if k else at_once)
                total, here = total + off, here + off
            return min(offs)
        for here, late, size, at_once, later, *more in ((1, 0, 1, 4, 4, 1e-3, 1e-2, 1), (1e-4, 2, 5, 30, 9, 1e-9, 1e-2, 2), (1e-4, 1, 5, 30, 9, 1e-2, 1e-9, 2), (1, 1, 1e9, 2, 3, 1e-6, 1e-6, 3)):
            off = float(law.away(iv.Interval.of(Fraction(here)), iv.Interval.of(Fraction(more[0])), iv.Interval.of(Fraction(more[1])), iv.Interval.of(more[2]), int(size), late, at_once, later).ends()[1])
            self.assertAlmostEqual(off / said(here, late, size, at_once, later, *more), 1, 9)
        room, low_x = (1 - Y) ** 1.5, Y * (1 - low)
        of_density = 2, 8 / (math.pi * w * room**2), 2 / math.pi / room * math.sqrt(w / (low_x - w)) / low_x, 8 / math.pi / room**2 * math.sqrt(w) * (2 / Y) ** 1.5
        whole = area, said(area, 0, 1, G, G)
        T = iv.Interval.of(1 - Fraction(1, 16) / Fraction(1, 4))
        density = 2 * 0.5 / G**3 * float(law.density(0, distributions.of_ratios(parts), T, wide).middle())
        force = iv.Interval.of(Fraction(1, 2))
        for quantity, here, off, (below, off_below), twice in (
                ("limit.exceedance", float(law.read(0, "share", T, parts, wide).middle()), (0, 1, G, G), whole, 1), ("limit.density", density, of_density, whole, 2),
                ("limit.force", float(law.read(0, "force", force, parts, wide).middle()), (1, 1, 1, 1), (float(law.read(0, "force", iv.Interval.of(1), parts, wide).middle()), 0), 1)):
            off = said(here, *off)
            low_end, high_end = law.claimed(quantity, Fraction(1, 2), parts, error, Fraction(1, 10**8)).ends()
            with self.subTest(quantity):
                self.assertAlmostEqual(float(low_end) / ((here - off) / (below + off_below) / twice), 1, 5)
                self.assertAlmostEqual(float(high_end) / ((here + off) / (below - off_below) / twice), 1, 5)
                self.assertLessEqual(low_end, limiting(quantity, "1/2", "4"))
                self.assertLessEqual(limiting(quantity, "1/2", "4"), high_end)

    def test_bounds_of_a_law_hold_at_complex_places(self):
        """(O), (P), (I): of S/R, of a polynomial and of the integrand, on discs about real places."""
        text, lines, third = self.law()
        self.path.write_text(text)
        read = certificate.Certificate(self.path)
        iv.Interval.bits = 128
        laws, chosen, tried = distributions.Laws(iv.Interval.of(3), Fraction(1, 10), 128), random.Random(known.seed), 0
        words = read.lines[third[0] - 1]
        values = certificate.fields(words[4:12], certificate.FORMS["piece"], "")
        level = distributions.Polynomial(*values[1:7], [certificate.integer(c) for c in words[12:]])
        steep = [distributions.Polynomial(low, high, (low + high) / 2, (high - low) / 2, 1, 0, [0, 0, 0, 0, 0, 1]) for low, high in ((0, Fraction(1, 64)), (Fraction(1, 2), Fraction(33, 64)))]

        def wave(x, z):
            R = cmath.sqrt((1 - x) ** 2 + z)
            return cmath.sqrt((1 + x + R) / (1 - x + R)) / R

        def polynomial(V, T):
            t, T0, T1 = (T - float(V.middle)) / float(V.half), 1, (T - float(V.middle)) / float(V.half)
            total = V.coefficients[0] + V.coefficients[1] * T1
            for c in V.coefficients[2:]:
                T0, T1 = T1, 2 * t * T1 - T0
                total += c * T1
            return total * 2.0**V.exponent

        for _ in range(900):
            V = chosen.choice([level, *steep])
            low, share, T = chosen.random() < 0.5, chosen.choice(["", "", "share", "force"]), chosen.uniform(0.02, 0.98)
            u, off = chosen.uniform(0, 0.6 if low else 0.8), 10 ** chosen.uniform(-3, -0.3)
            laws.beyond = 4 * laws.top(3) * (1 - iv.Interval.of(Fraction(T)))
            try:
                bound = float(laws.bound(3, V, Fraction(u), Fraction(off), low, iv.Interval.of(Fraction(T)), share).ends()[1])
            except full_contact.Far:
                continue
            tried += 1
            Y = float(laws.top(3).middle())
            for _ in range(8):
                w = u + off * cmath.exp(1j * chosen.uniform(0, 6.2832))
                k = w * w if low else 1 - w * w
                r = T * k
                x, z = Y * (1 - r), 4 * Y * (1 - T)
                R = cmath.sqrt((1 - x) ** 2 + z)
                root = w * cmath.sqrt(T) if low else cmath.sqrt(r)  # r^(power/2), power 1
                here = root * cmath.sqrt(2 - r) * polynomial(V, r * (2 - r)) * x * (w if low else 1)
                c = cmath.sqrt(1 - k)
                here *= ((x if share == "force" else 2 / cmath.pi * cmath.asin(c * cmath.sqrt(2 * Y * T / (1 + x + R)))) * (1 if low else c)) if share else wave(x, z) / (c if low else 1)
                self.assertLessEqual(abs(here), bound * 1.000001, (low, share, T, u, off))
        self.assertGreater(tried, 200)

    def test_each_line_proves_claims_of_its_own_kinds(self):
        """Whatever kind of claim the header says it is, with that kind's names: only what is true is proved."""
        names = {"contact.area": ("n", "load"), "contact.exceedance": ("n", "p", "load"), "contact.density": ("n", "p", "load"), "segments.density": ("n", "a", "load"), "limit.area_constant": (),
                 "limit.exceedance": ("p",), "limit.force": ("p",), "limit.density": ("p",), "limit.segments": ("a",), "limit.distance": ("n", "p", "load"), "limit.scale": ("load", "tolerance"), "limit.gap": ()}
        for what, text in self.texts.items():
            words = text.splitlines()[3].split(" ")
            had = dict(w.split("=") for w in words[2:])
            at = had.get("p", had.get("a", "1/3"))
            others = [quantity for quantity in names if quantity != what[0]]
            quick = [quantity for quantity in others if (what[0], quantity) != MINUTE_LONG]
            for quantity in others if known.long else random.Random(f"{known.seed} {what}").sample(quick, 2):
                inputs = names[quantity]
                own = {"n": had.get("n", "1"), "p": at, "a": at, "load": had.get("load", "1/2"), "tolerance": "1/3"}
                claim = " ".join([*words[:2], *(f"{name}={own[name]}" for name in inputs), *(f"{name}={had[name]}" for name in ("G", "value", "error"))])
                self.path.write_text(signed(text.replace(text.splitlines()[3], claim, 1).replace(f"quantity {what[0]}", f"quantity {quantity}", 1)))
                with self.subTest(what=what, quantity=quantity):
                    said = answered_to_claim(self.path)
                    self.assertIn(said.returncode, (1, 65), said.stdout)

    def test_a_mesh_serves_one_pressure(self):
        """What is true of one pressure or scale is not proved of another, nor of areas."""
        text = next(text for what, text in self.texts.items() if what[0] == "contact.exceedance")
        for old, new in (("n=1 p=1/2", "n=1 p=1/3"), ("n=1 p=1/2", "n=2 p=1/2"), ("p=1/2 scale=1 ", "p=1/2 scale=2 "), ("p=1/2 scale=1 ", "p=1/3 scale=1 "), ("p=1/2 scale=1 ", "p=0 scale=1 ")):
            self.path.write_text(signed(text.replace(old, new, 1)))
            with self.subTest(new=new):
                said = answered(self.path)
                self.assertEqual((said.returncode, said.stdout[:4]), (1, "no: "), said.stdout)
        self.path.write_text(signed(text.replace("contact.exceedance", "contact.area", 1).replace("n=1 p=1/2", "n=1", 1)))
        self.assertEqual(answered(self.path).returncode, 1)

    def test_wrong_values_are_refused(self):
        """What is claimed beside the truth, by little more than the error, in each kind of certificate."""
        for what, text in self.texts.items():
            self.path.write_text(text)
            (claim,) = certificate.Certificate(self.path).claims.values()
            value, error = claim[-2:]
            if not error:  # a scale: test_proves_from_where_on_the_limit_holds has those beside it
                continue
            old = text.split("value=")[1].split(" ")[0]
            both = (-3 * error, 3 * error)
            for off in both if known.long else random.Random(f"{known.seed} {what}").sample(both, 1):
                wrong = value + off
                e = wrong.denominator.bit_length() - 1
                self.path.write_text(signed(text.replace(f"value={old}", f"value={wrong.numerator:x}:{-e}", 1)))
                with self.subTest(what=what, off=float(off)):
                    said = answered_to_claim(self.path)
                    self.assertEqual((said.returncode, "the claim is not proved" in said.stdout), (1, True), said.stdout)

    def test_rows_of_tables_are_confirmed(self):
        self.make("contact_area", "n=3", "load=1", "G=4", "--digits", 10)  # of the table, this row alone
        self.assertEqual(self.path.read_text().count("\nclaim "), 1)
        for p, claims in (("0.8944263380080884", 1), ("0.89442633800808837", 1), ("0.8944263380080882", 0)):  # printed there; another decimal of it; the next number
            said = program("certificate", "contact_exceedance", "n=1", f"p={p}", "load=0.001", "--digits", 4)
            self.assertEqual((said.returncode, said.stdout.count("\nclaim ")), (2 - 2 * claims, claims), said.stderr)
        table = (known.checker.parent / "data/reference/contact_area.txt").read_text()
        head, rows = ([line for line in table.splitlines() if line.startswith("#") == which] for which in (True, False))
        place = next(i for i, row in enumerate(rows) if row.split()[:3] == ["3", "1", "4"])

        def confirmed(rows):
            digest = hashlib.sha256("".join(row + "\n" for row in rows).encode()).hexdigest()
            header = json.loads(head[-2][2:]) | {"sha256": digest, "rows": len(rows)}
            path = self.path.parent / "table.txt"
            path.write_text("\n".join([*head[:-2], "# " + json.dumps(header), head[-1], *rows]) + "\n")
            return subprocess.run([sys.executable, known.checker / "check.py", "--certificate", self.path, path], capture_output=True, text=True)
        said = confirmed(rows[place:place + 1])
        self.assertEqual((said.returncode, complaints(said.stderr)), (0, []))
        name, asked, right, still_open, wrong, digits = said.stdout.splitlines()[1].split()
        self.assertEqual((asked, right, still_open, wrong), ("1", "0", "1", "0"))
        self.assertIn(int(digits), range(10, 20))
        cells = rows[place].split()
        cells[3] = cells[3][:9] + str((int(cells[3][9]) + 1) % 10) + cells[3][10:]
        said = confirmed([" ".join(cells)])
        self.assertEqual((said.returncode, said.stdout.split()[-2]), (1, "1"), said.stdout)

    def test_pieces_cover_all(self):
        self.path.write_text(self.text)
        count = certificate.Certificate(self.path).count
        reports = []
        for first, last in ((1, 7), (8, count - 1), (count, count)):
            said = check("--lines", f"{first}-{last}", self.path)
            self.assertEqual(said.returncode, 0, said.stdout)
            reports.append(pathlib.Path(self.folder.name) / f"report{first}.txt")
            reports[-1].write_text(said.stdout)
        self.assertEqual(check(self.path, "--join", *reports).returncode, 0)
        gap = check(self.path, "--join", reports[0], reports[2])
        self.assertEqual((gap.returncode, gap.stdout.count("proved by no piece")), (1, 1))
        table = known.checker.parent / "data/reference/limit_ratio.txt"
        for pieces, code in ((reports, 0), (reports[1:], 65)):  # check.py takes pieces too
            said = subprocess.run([sys.executable, known.checker / "check.py", "--certificate", ",".join(map(str, [self.path, *pieces])), table], capture_output=True, text=True)
            self.assertEqual((said.returncode, said.stderr.count("proved by no piece")), (code, code // 65), said.stderr)
        self.path.write_text(signed(self.text.replace("load=1/10", "load=1/11")))
        self.assertEqual(check(self.path, "--join", *reports).returncode, 65)
        self.assertEqual(check("--lines", f"1-{count + 1}", self.path).returncode, 65)

    def test_what_is_no_certificate_is_refused(self):
        lines = self.text.splitlines(keepends=True)
        first = next(i for i, line in enumerate(lines) if line.startswith("1 grid"))
        levels = [i for i, line in enumerate(lines) if " level " in line]
        bad = {
            "empty": "", "binary": "\x00\x7f" * 99, "cut off": self.text[: len(self.text) // 2], "a line less": "".join(lines[:-2] + lines[-1:]),
            "version": self.text.replace("CERT 1", "CERT 2"), "quantity": self.text.replace("contact.area", "contact.aura", 1), "crlf": self.text.replace("\n", "\r\n"),
            "huge bits": self.text.replace("bits=", "bits=fffffff"), "huge exponent": self.text.replace("exponent=-", "exponent=-99999"),
            "huge mantissa": self.text.replace("error=", "error=" + "7" * 10**5, 1), "huge number": self.text.replace("n=2", "n=" + "9" * 10**4, 1),
            "zero step": self.text.replace("step=", "step=0:0 step=", 1), "G below 2": self.text.replace("G=16", "G=1"),
            "cycle": "".join(lines[:levels[0]]) + lines[levels[0]].replace("level 1-2", f"level 1-2,{len(lines)}") + "".join(lines[levels[0] + 1:]),
            "itself": "".join(lines[:first]) + lines[first].replace("grid -", "grid 1") + "".join(lines[first + 1:]),
            "claim without lines": self.text.replace("counts claims=1", "counts claims=2").replace("section 1", lines[3].replace("claim 1", "claim 2") + "section 1", 1),
        }
        for name, text in bad.items():
            for text in (text, signed(text)):
                if text == self.text:
                    continue
                self.path.write_bytes(text.encode("latin-1"))
                said = answered(self.path)
                with self.subTest(name):
                    self.assertIn(said.returncode, (1, 65), said.stdout)
                    self.assertTrue(said.stdout.startswith("no: ") and len(said.stdout.splitlines()) == 1, said.stdout[:300])
                    self.assertEqual(complaints(said.stderr), [])
        self.assertEqual(check(self.path.parent / "none").returncode, 65)

    def write(self, quantity, claims, lines):
        """a certificate of these claims and lines"""
        kinds = [line.split(" ")[0] for line in lines]
        counts = " ".join(f"{name}={kinds.count(kind)}" for kind, name in certificate_text.COUNTED.items() if kind in kinds)
        head = ["TOUCHSTONE-CERT 1", f"quantity {quantity}", f"counts claims={len(claims)} sections=1 lines={len(lines)}", *(f"claim {i} {c}" for i, c in enumerate(claims, 1)),
                f"section 1 span=1-{len(lines)} {counts}", *(f"{i} {line}" for i, line in enumerate(lines, 1))]
        self.path.write_text(signed("\n".join(head) + "\nsha256 "))

    def test_what_needs_too_much_memory_is_refused(self):
        """Here with a bound of 128 MiB; a text of many short words needs more."""
        self.path.write_bytes(b"a b " * (1 << 22))
        for name, arguments, code in (("certificate", [], 1), ("check", ["--certificate", self.path, "table"], 65)):
            start = f"import sys; sys.path.insert(0, {str(known.checker)!r}); import memory, {name} as program; memory.MOST = 1 << 27; sys.exit(program.main())"
            said = subprocess.run([sys.executable, "-c", start, *map(str, arguments or [self.path])], capture_output=True, text=True)
            with self.subTest(name):
                self.assertEqual((said.returncode, (said.stdout + said.stderr).count("needs too much memory")), (code, 1), said.stdout[:300] + said.stderr[:300])

    def test_what_is_written_to_deceive_is_refused(self):
        """Lines by hand that rest on what they may not, and numbers that no arithmetic holds: an answer, never a crash."""
        area, constant, one = "n=1 load=1/2 G=3 value=1:-1 error=1:-2", "G=3 value=1:0 error=1:-1", 1 << 64
        grid, mesh = "G=3 bits=40 step=1:-3 points=40", f"G=3 p=0 scale=0 load=1/2 bits=40 kept=40 accuracy=a rise=0 {one // 100:x} "
        panel, level = "panel 1 3 low=1:-2 high={} terms=2 rho=1000001:-24", "level 1-2 4 m=0 error=1:10 exponent=0 1 0"
        V = "terms=2 aim=a 8000000000000000 4000000000000000"
        law, density = "law - {} G=3 load=1/2 bits=80", "n={} p=1 load=1/2 G=3 value=1:0 error=1:-1"
        piece = "piece 1 {last} m={m} low=0:0 high=1:0 centre=1:-1 radius={radius} power={power} exponent=0 error={error} 1 0 0"
        limit, part = "p=1/2 G=3 value=1:-1 error=1:-2", "low={low} high=1:0 centre=1:-1 radius=1:-1 power=2 exponent=0 1 0 0"
        steady, parts, balance, tending = "steady - {} G=3 bits=80", "part 1 4 " + part.format(low="1:-4"), "balance 1-2 4 part=0 error=1:-1", "tending 1-3 4 claim=1"
        distance, whole_law = "n=1 p=1/2 load=1/2 G=3 value=-1:-3 error=1:-4", [steady.format(5), parts.replace("1 4", "1 5"), balance.replace("1-2 4", "1-2 5"), "law - 5 G=3 load=1/2 bits=80", "tending 1-4 5 claim=1"]
        fair = {"last": 3, "m": 2, "radius": "1:-1", "power": 0, "error": "1:-1"}
        for why, quantity, claim, lines in (
                ("not a law", "contact.density", density.format(1), [law.format(2).replace("G=3", "G=2"), "reading 1 2 claim=1"]),
                ("not a law", "contact.density", density.format(1), [law.format(2).replace("load=1/2", "load=3/2"), "reading 1 2 claim=1"]),
                ("not a law", "contact.density", density.format(1), [law.format(2).replace("bits=80", "bits=20"), "reading 1 2 claim=1"]),
                ("the law of its load", "contact.density", density.format(1).replace("1/2 G", "1/3 G"), [law.format(2), "reading 1 2 claim=1"]),
                ("the law of its load", "segments.density", density.format(1).replace("p=1", "a=1/9"), [law.format(2), "reading 1 2 claim=1"]),
                ("does not rest on a grid of its G", "contact.density", density.format(1).replace("G=3", "G=4"), [law.format(2), "reading 1 2 claim=1"]),
                ("does not rest on level 2", "contact.density", density.format(2), [law.format(2), "reading 1 2 claim=1"]),
                ("further from the law", "contact.density", density.format(2), [law.format(3), piece.format(**fair), "reading 1-2 3 claim=1"]),
                ("errors do not get less", "contact.density", density.format(2), [law.format(3), piece.format(**fair | {"error": "0:0"}), "reading 1-2 3 claim=1"]),
                ("not a piece of a law", "contact.density", density.format(2), [law.format(3), piece.format(**fair | {"power": -1}), "reading 1-2 3 claim=1"]),
                ("not a piece of a law", "contact.density", density.format(2), [law.format(3), piece.format(**fair | {"m": 1}), "reading 1-2 3 claim=1"]),
                ("power is too large", "contact.density", density.format(2), [law.format(3), piece.format(**fair | {"power": 999}), "reading 1-2 3 claim=1"]),
                ("of another piece", "contact.density", density.format(2), [law.format(3), piece.format(**fair | {"radius": "1:-2"}), "reading 1-2 3 claim=1"]),
                ("of another piece", "contact.density", density.format(2), [law.format(3), piece.format(**fair | {"radius": "-1:0"}), "reading 1-2 3 claim=1"]),
                ("at an end of the law", "contact.density", density.format(1).replace("p=1", "p=99"), [law.format(2), "reading 1 2 claim=1"]),
                ("more is needed of a piece", "contact.density", density.format(1).replace("error=1:-1", "error=0:0"), [law.format(2), "reading 1 2 claim=1"]),
                ("at an end of the law", "segments.density", density.format(2).replace("p=1", "a=11/10"), [law.format(2), "reading 1 2 claim=1"]),
                ("at an end of the law", "contact.density", density.format(1).replace("p=1", "p=0"), [law.format(2), "reading 1 2 claim=1"]),
                ("no claim that is still to be proved", "limit.area_constant", constant, [law.format(2), "reading 1 2 claim=1"]),
                ("is no approximation", "contact.density", density.format(2), [law.format(3), piece.format(**fair | {"error": "1:-16384"}).replace("exponent=0", "exponent=-16384"), "reading 1-2 3 claim=1"]),
                ("not a law of the limit", "limit.force", limit.replace("G=3", "G=2"), [steady.format(4).replace("G=3", "G=2"), parts, balance, tending]),
                ("not a law of the limit", "limit.force", limit, [steady.format(4).replace("bits=80", "bits=20"), parts, balance, tending]),
                ("not a part of the law", "limit.force", limit, [steady.format(4), parts.replace("1:-4", "0:0"), balance, tending]),
                ("not a part of the law", "limit.force", limit, [law.format(4), parts, balance, tending]),
                ("not a balance", "limit.force", limit, [steady.format(4), parts, balance.replace("part=0", "part=1"), tending]),
                ("not a balance", "limit.force", limit, [steady.format(4), parts, balance.replace("error=1:-1", "error=1:0"), tending]),
                ("not a balance", "limit.force", limit, [steady.format(4), parts, balance.replace("1-2", "1"), tending]),
                ("up to 1", "limit.force", limit, [steady.format(4), parts.replace("high=1:0", "high=1:-1"), balance, tending]),
                ("is no approximation", "limit.force", limit, [steady.format(4), parts, balance.replace("error=1:-1", "error=1:-16384"), tending]),
                ("not all balanced", "limit.force", limit, [steady.format(3), parts.replace("1 4", "1 3"), "tending 1-2 3 claim=1"]),
                ("no claim that is still to be proved", "limit.area_constant", constant, [steady.format(2), "tending 1 2 claim=1"]),
                ("no claim that is still to be proved", "limit.force", limit, [law.format(2), "reading 1 2 claim=1"]),
                ("no claim that is still to be proved", "contact.density", density.format(1), [steady.format(2), "tending 1 2 claim=1"]),
                ("rests on the law of the limit", "limit.force", limit, [law.format(2), "tending 1 2 claim=1"]),
                ("the law of its load", "contact.density", density.format(1), [steady.format(2), "reading 1 2 claim=1"]),
                ("more or less than it may", "limit.force", limit, whole_law), ("the law of its G and load", "limit.distance", distance.replace("1/2 G", "1/3 G"), whole_law),
                ("level 2 of its law", "limit.distance", distance.replace("n=1", "n=2"), whole_law), ("more or less than it may", "limit.distance", distance, [steady.format(4), parts, balance, tending]),
                ("claim 1: is none", "limit.force", limit.replace("value=1", "value=-1"), [steady.format(4), parts, balance, tending]),
                ("claim 1: is none", "limit.distance", distance.replace("error=1:-4", "error=1:-3"), whole_law),
                ("a panel is too far out", "contact.density", density.format(1).replace("1:0 error=1:-1", "1:-5 error=1:-6"), [law.format(2), "reading 1 2 claim=1", f"grid - 5 {grid}", panel.replace("1 3", "3 5").format("1:200").replace("1000001:-24", f"{2**300 + 1:x}:-300"), "level 3-4 5 m=0 error=1:10 exponent=0 1 0"]),
                ("does not rest on levels", "limit.area_constant", constant, [f"grid - 3 {grid}", panel.format("1:0"), "limit 1-2 3 claim=1 m=0 exponent=0 1"]),
                ("does not rest on a mesh", "contact.area", area, [f"grid - 2 {grid}", "share 1 2 claim=1"]),
                ("polynomials are missing", "contact.area", area, [f"mesh - 2 {mesh.strip()}", "share 1 2 claim=1"]),
                ("a value rests on a grid", "contact.area", area, [f"mesh - 2 {mesh.strip()}", "value 1 2 claim=1"]),
                ("not a rule", "contact.area", area, [f"grid - 3 {grid.replace('-3', '-60')}", panel.format("1:2"), level, "value 1,3 4 claim=1"]),
                ("a panel is too far out", "contact.area", area, [f"grid - 3 {grid}", panel.format("1:200").replace("1000001:-24", f"{2**300 + 1:x}:-300"), level, "value 1,3 4 claim=1"]),
                ("claim 1: is none", "contact.area", area.replace("error=1:-2", "error=1:9000"), [f"grid - 3 {grid}", panel.format("1:2"), level, "value 1,3 4 claim=1"]),
                ("a polynomial is of another panel", "contact.area", area, [f"mesh - 3 {mesh}{2 * one:x}", f"polynomials 1 3 panel=0 middle={2 * one:x} half={one // 9:x} {V}", "share 1-2 3 claim=1"]),
                ("a panel is too narrow", "contact.area", area, [f"mesh - 5 {mesh.replace('load=1/2', 'load=1')}{one // 2:x} {one // 2 + (1 << 31):x} {2 * one:x}", *(
                    f"polynomials 1 5 panel={p} middle={(a * a + b * b) >> 65:x} half={((b * b - a * a) >> 65) + 4:x} {V}"
                    for p, (a, b) in enumerate([(one // 100, one // 2), (one // 2, one // 2 + (1 << 31)), (one // 2 + (1 << 31), 2 * one)])), "share 1-4 5 claim=1"]),
                ("ratios leave the mesh", "contact.area", area, [f"mesh - 3 {mesh}{one // 3:x}", f"polynomials 1 3 panel=0 middle={one // 18:x} half={one // 18:x} {V}", "share 1-2 3 claim=1"]),
                ("the mesh does not reach so far", "contact.area", area.replace("1/2 G", "2/3 G"), [f"mesh - 3 {mesh}{2 * one:x}", f"polynomials 1 3 panel=0 middle={2 * one:x} half={2 * one:x} {V}", "share 1-2 3 claim=1"]),
                ("not the polynomials of a panel", "contact.area", area, [f"mesh - 3 {mesh}{2 * one:x}", f"polynomials 1 3 panel=0 middle={2 * one:x} half={2 * one:x} {V.replace('aim=a', 'aim=b')}", "share 1-2 3 claim=1"]),
                ("not a mesh", "contact.area", area, [f"mesh - 3 {mesh}{one << 99:x}", f"polynomials 1 3 panel=0 middle={one << 197:x} half={one << 197:x} {V}", "share 1-2 3 claim=1"])):
            self.write(quantity, [claim], lines)
            with self.subTest(why):
                said = answered(self.path)
                self.assertIn(said.returncode, (1, 65), said.stderr)
                self.assertRegex(said.stdout, f"^no: .*{why}")

    def test_a_hole_has_the_errors_of_its_ends(self):
        """(G): where monotony bounds a level, T e at both ends counts on all of it. A_2(50) = 1/2 where G = 10; V_0 is right near 1/2 alone, so that 1/4 was proved."""
        one, kept = 1 << 64, 1 << 32
        edges = [one * k // 100 for k in (1, 40, 50, 60, 120, 950)]

        def first_wave(k):
            return 2 / math.pi * math.asin(math.sqrt(k / 100))
        V = [[kept // 4, 0], *([int(kept * (first_wave(k + 10) + first_wave(k)) / 2), int(kept * (first_wave(k + 10) - first_wave(k)) / 2)] for k in (40, 50)), [kept // 4, 0], [kept // 4, 0]]
        lines = [f"mesh - 7 G=10 p=0 scale=0 load=50 bits=40 kept=20 accuracy=8 rise=0 {' '.join(f'{y:x}' for y in edges)}"]
        for p, (a, b) in enumerate(zip(edges, edges[1:])):
            lines.append(f"polynomials 1 7 panel={p:x} middle={a * a + b * b >> 65:x} half={(b * b - a * a >> 65) + 4:x} terms=2 aim={6 if p in (1, 2) else 0} {V[p][0]:x} {V[p][1]:x} {kept // 4:x} 0")
        self.write("contact.area", ["n=2 load=50 G=10 value=1:-2 error=7:-5"], [*lines, "share 1-6 7 claim=1"])
        said = check(self.path)
        self.assertEqual((said.returncode, "the claim is not proved" in said.stdout), (1, True), said.stdout)

    def test_a_load_far_above_all_ratios(self):
        """(L): y = (load + c)/G is known to some units however large load and G are: T y^2 = (load^2 + 1/2)/G^2."""
        one, load, G = 1 << 64, 1 << 32, (1 << 33) + 268447801
        edges = [one // 4, one]
        middle, half = edges[0] ** 2 + edges[1] ** 2 >> 65, (edges[1] ** 2 - edges[0] ** 2 >> 65) + 2
        mesh = full_contact.Mesh(transfer.Interval.of(G), Fraction(0), load, 64, edges, [(middle, half)], [10], [[[middle, half]]], 64, 10, 0)
        said = Fraction(mesh.exact_row(load * one)[0], mesh.unit)
        self.assertLess(abs(said - (load * load + Fraction(1, 2)) / G**2), mesh.round + mesh.quadrature)
        self.assertLess(mesh.round + mesh.quadrature, Fraction(1, 10**4))

    def test_ends_of_a_wave_that_meet_at_an_edge(self):
        """Where the ends are continued from the middle of the wave (J with g = 1), rounding must not put one beyond the other: nothing would be integrated, and V_1 = 0 would hold."""
        bits, G = 64, 3
        one, tried = 1 << bits, 0
        widest = 78 * one // 100 * 8 // 17
        for at, h in itertools.product(range(18 * one, 18 * one + G), range(widest - 4, widest + 4)):  # middle and half of J
            g = (h * 17 // 8 + 1) * 100 // 78 + 1
            high, low = ((one + at - g) << bits) // (G * one), ((at - one + g) << bits) // (G * one) + 1
            if g > one or low <= high:
                continue
            edges = [4 * one, low, at - h + 1, at + h - 1, 60 * one]
            places = [(a * a + b * b >> bits + 1, (b * b - a * a >> bits + 1) + 2) for a, b in zip(edges, edges[1:])]
            series = [[[one, 0], [0 if p == 2 else one, 0]] for p in range(4)]
            mesh = full_contact.Mesh(transfer.Interval.of(G), Fraction(0), 60, bits, edges, places, [8] * 4, series, bits, 10, 0)
            tried += 1
            with self.assertRaises(full_contact.Far):
                mesh.on_interval(2, edges[2], edges[3], -8, 2)
        self.assertGreater(tried, 0)

    def test_step_functions_are_averaged_from_above(self):
        """(H): T of a step function, by its shares in doubles, is nowhere above what is said of an interval, nor far below."""
        bits, chosen, G = 64, random.Random(20261123), 3
        one, tight = 1 << bits, []
        edges = [one // 64 * k for k in range(1, 129)]
        places = [(a * a + b * b >> bits + 1, (b * b - a * a >> bits + 1) + 2) for a, b in zip(edges, edges[1:])]
        mesh = full_contact.Mesh(transfer.Interval.of(G), Fraction(0), 4, bits, edges, places, [10] * len(places), [[[one, 0]]] * len(places), bits, 10, 0)

        def share(x, y):
            c = G * y - x if x >= 1 else math.sqrt((G * y) ** 2 + (1 - x) ** 2) - x
            return math.acos(max(-1, min(1, c))) / math.pi
        for _ in range(100):
            ends = {0, *edges}
            for _ in range(chosen.choice([0, 5, 50])):  # narrow cells, some of them neighbours
                y = chosen.randrange(1, edges[-1] - (one >> 9))
                ends |= {y + (one >> chosen.randrange(10, 40)) * k for k in range(chosen.choice([2, 3]))}
            ends = sorted(ends)
            e = [chosen.randrange(1, one >> chosen.choice([0, 8, 30])) for _ in ends[1:]]
            c = chosen.randrange(len(ends) - 20)
            low, high = ends[c], ends[c + 1]
            said = mesh.averaged(mesh.parted(e, ends), mesh.shares(low, ends), mesh.shares(high, ends)) / one
            for x in (low / one, chosen.uniform(low / one, high / one), high / one):
                shares = [share(x, y / one) for y in ends]
                true = sum(v * (a - b) for v, a, b in zip(e, shares, shares[1:])) / one
                self.assertLessEqual(true, said * (1 + 1e-9) + 1e-12, (low / one, x))
            tight.append(true / said)
        self.assertGreater(sorted(tight)[50], 0.3)
        x, width = 3 * one // 2, one >> 40  # a narrow cell where the wave ends: of cos theta > 1 - G width
        spiked = sorted({*ends, mesh.most(x) - width, mesh.most(x)})
        e = [one << 24 if a == mesh.most(x) - width else one for a in spiked[:-1]]
        said = mesh.averaged(mesh.parted(e, spiked), mesh.shares(x, spiked), mesh.shares(x + width, spiked)) / one
        true = 1 + 2**24 * math.sqrt(2 * G * 2**-40) / math.pi
        self.assertLess(true, said)
        self.assertLess(said, 2 * true)

    def test_a_share_that_rounds_to_0_counts(self):
        """(H): narrow cells beyond the first ratio of a share below 2^-work are not told apart, but what is high there counts."""
        bits, G = 256, 3
        one = 1 << bits
        edges = [one // 8, one, 2 * one]
        places = [(a * a + b * b >> bits + 1, (b * b - a * a >> bits + 1) + 2) for a, b in zip(edges, edges[1:])]
        mesh = full_contact.Mesh(transfer.Interval.of(G), Fraction(0), 2, bits, edges, places, [10] * 2, [[[one, 0]]] * 2, bits, 10, 0)
        spiked = [0, one // 8, one - (one >> 118), one - (one >> 120), one, 2 * one]  # a wave of mean 2 ends at the ratio 1
        e = [one, one, one, one << 80, one]
        shares = mesh.shares(2 * one, spiked)
        self.assertEqual((len(shares), shares[-1]), (3, 0))
        said = mesh.averaged(mesh.parted(e, spiked), shares, shares) / one
        self.assertLess(1 + 2**80 * math.sqrt(2 * G * 2**-120) / math.pi, said)

    def test_levels_packed_into_one_integer_are_those_of_each(self):
        bits, chosen = 64, random.Random(20261123)
        one, terms = 1 << bits, 6
        edges = [one // 8 * k for k in (1, 3, 8, 16, 24)]
        places = [(a * a + b * b >> bits + 1, (b * b - a * a >> bits + 1) + 2) for a, b in zip(edges, edges[1:])]
        series = [[[chosen.randrange(-one, one) >> 2 * k for k in range(terms)] for _ in range(5)] for _ in places]

        def mesh(levels):
            return full_contact.Mesh(transfer.Interval.of(3), Fraction(0), 2, bits, edges, places, [9] * 4, [[p[m] for m in levels] for p in series], bits, 10, 0)
        for at in (one // 3, one // 2, 3 * one // 2, 2 * one):
            low, high = 0, len(places) - 1
            with unittest.mock.patch.object(full_contact.Mesh, "order", lambda *_: 8):  # one rule for all, whatever the level
                packed = mesh(range(5)).row(at, low, high, 20)
                self.assertEqual(packed, [mesh([m]).row(at, low, high, 20)[0] for m in range(5)])
        self.assertLess(min(packed), 0)
        with unittest.mock.patch.object(full_contact, "SPARE_BITS", -40), self.assertRaises(full_contact.Refused):
            mesh(range(5)).row(at, low, high, 20)

    def test_what_far_panels_give_is_interpolated(self):
        """The wave in shells, those far from its ends from few points, is the wave, to what is said."""
        bits, chosen = 128, random.Random(20261123)
        one, terms = 1 << bits, 12
        edges = [one // 64 * k for k in (1, 2, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 56, 64, 80, 96, 104)]
        places = [(a * a + b * b >> bits + 1, (b * b - a * a >> bits + 1) + 2) for a, b in zip(edges, edges[1:])]
        series = [[[chosen.randrange(-one, one) >> 2 * k for k in range(terms)] for _ in range(3)] for _ in places]
        mesh, seen = full_contact.Mesh(transfer.Interval.of(3), Fraction(0), 1, bits, edges, places, [30] * len(places), series, bits, 30, 0), set()
        for at, half in itertools.product((one // 3, one // 2, 9 * one // 10, one + one // 50, 3 * one // 2), (one >> 6, one >> 8, one >> 12, one >> 30)):
            x1, x2 = at - half, at + half
            low, high = -1 if x2 < one else mesh.panel(mesh.least(x2)), mesh.panel(mesh.most(x1))
            shells = mesh.shells(x1, x2, low, high)
            self.assertEqual(sorted(p for _, panels in shells for p in panels), list(range(max(low, 0), high + 1)))
            seen.update(power for power, panels in shells if panels)
            rows, off = mesh.wave(x1, x2, low, high, 7, -30)
            self.assertLess(off, Fraction(1, 2**31))
            for x, row in zip(mesh.chebyshev_points(x1, x2, 7), rows):
                whole = mesh.row(x, low, high, 60)
                self.assertLess(max(abs(a - b) for a, b in zip(row, whole)), off * mesh.unit, (at / one, half / one))
        self.assertEqual(seen, {2, *full_contact.FAR})

    def test_rules_of_gauss_are_had_at_the_precision_of_any_certificate(self):
        """Their weights add up to 2 but for roundings: no choice of bits may refuse what is true."""
        for bits in (64, 88, 98, 100, 160, 176, 208, 248, 264):
            trig = full_contact.Trigonometry(bits)
            for K in range(2, 34, 2):
                with self.subTest(bits=bits, K=K):
                    pairs = trig.gauss(K)
                    for i in (0, K, 2 * K - 2):  # the integral of t^i from -1 to 1
                        said = sum(2 * w * Fraction(t, 1 << bits) ** i for t, w in pairs) / 2**bits
                        self.assertLess(abs(said - Fraction(2, i + 1)), Fraction(64 * K * K, 2**bits))
            with self.assertRaises(full_contact.Refused), unittest.mock.patch.object(trig, "cos_sin", lambda _: (trig.one // 2, trig.one // 2)):
                trig.gauss.cache_clear()
                trig.gauss(8)

    def test_small_angles_have_their_sines(self):
        """Within two units, as many terms as there are: against sums of 64 bits more, at both ends and where another number of terms is taken."""
        chosen = random.Random(known.seed)
        for bits in (64, 97, 320):
            trig = full_contact.Trigonometry(bits)
            angles = [0, 1, trig.one // 4, *(chosen.randrange(trig.one >> k) for k in range(2, bits, 5))]
            for a in [*angles, *(-a for a in angles)]:
                term, of = trig.one << 64, [trig.one << 64, 0]
                for k in range(1, bits):
                    term = term * a // (k << bits)
                    of[k % 2] += (-1) ** (k // 2) * term
                for found, true in zip(trig.small(a), of):
                    self.assertLess(abs((found << 64) - true), 2 << 64, (bits, a))

    def test_a_row_of_too_many_points_ends_there(self):
        """A file may ask for more than anyone has time for: what is refused is refused before it is done."""
        bits, terms = 64, 64
        one = 1 << bits
        edges = [one // 64 * k for k in range(1, 193)]
        places = [(a * a + b * b >> bits + 1, (b * b - a * a >> bits + 1) + 2) for a, b in zip(edges, edges[1:])]
        mesh = full_contact.Mesh(transfer.Interval.of(3), Fraction(0), 2, bits, edges, places, [100] * len(places), [[[one << 50] * terms]] * len(places), bits, 100, 0)
        with unittest.mock.patch.object(full_contact, "MOST_NODES", full_contact.MOST_NODES // 8):
            with self.assertRaisesRegex(full_contact.Refused, "too many points"):
                mesh.exact_row(2 * one)
            self.assertLessEqual(mesh.nodes, full_contact.MOST_NODES + 32)

    def mutant(self, chosen):
        """a digit, sign, bound, index or line of one line changed, and what"""
        original = self.texts[chosen.choices(list(CHANGED), list(CHANGED.values()))[0]]
        lines = original.splitlines()
        kinds = {}
        for i, line in enumerate(lines[:-1]):
            words = line.split(" ")
            kinds.setdefault(words[1] if words[0].isdigit() else words[0], []).append(i)
        kind = chosen.choice(sorted(kinds))
        i = chosen.choice(kinds[kind])
        words = lines[i].split(" ")
        w = chosen.randrange(len(words))
        how = chosen.choice(["digit", "digit", "sign", "bound", "index", "line", "cut"])
        if how == "digit":
            places = [k for k, c in enumerate(words[w]) if c in "0123456789abcdef"]
            if places:
                k = chosen.choice(places)
                words[w] = words[w][:k] + chosen.choice("0123456789abcdef") + words[w][k + 1:]
        elif how == "sign":
            words[w] = words[w].replace("-", "", 1) if "-" in words[w] else words[w].replace("=", "=-", 1) if "=" in words[w] else "-" + words[w]
        elif how == "bound":
            name, mark, number = words[w].partition("=")
            mantissa, colon, exponent = number.partition(":")
            if colon:
                words[w] = f"{name}{mark}{mantissa}:{int(exponent) + chosen.choice([-9, -2, -1, 1, 2, 9])}"
        elif how == "index":
            numbers = [k for k, word in enumerate(words) if word.isdigit()]
            if numbers:
                k = chosen.choice(numbers)
                words[k] = str(int(words[k]) + chosen.choice([-1, 1]))
        elif how == "line":
            other = chosen.choice(kinds[kind])
            words, lines[other] = lines[other].split(" "), " ".join(words)
        else:
            words = words[:w]
        lines[i] = " ".join(words)
        return signed("\n".join(lines) + "\n"), f"{kind}, {how}: {lines[i][:120]}", original

    def true_of(self, read):
        """Whether all that an accepted mutant says is true, by the program: its claims, and its polynomials at some points."""
        for *inputs, (base, degree), value, error in read.claims.values():
            G = f"({base})^(1/{degree})"
            if abs(value - true_value(read.quantity, tuple(inputs), G)) > error:
                return False
        for words in read.lines:
            if words[1] == "piece" and not self.true_piece(words, read.lines[0]):
                return False
            if words[1] != "level":  # the polynomials of a mesh may be anything
                continue
            m, error, exponent = certificate.fields(words[4:7], "m error exponent", "")
            panel = [k for part in words[2].split(",") for k in range(certificate.span(part)[0], certificate.span(part)[1] + 1)][1]
            low, high, terms, _ = certificate.fields(read.lines[panel - 1][4:], "low high terms rho", "")
            for share in (0, Fraction(1, 3), 1):
                s = low + (high - low) * share
                with decimal.localcontext() as context:
                    context.prec = 60
                    load = Fraction((-decimal.Decimal(s.numerator) / s.denominator).exp()).limit_denominator(10**40)
                    s = -Fraction((decimal.Decimal(load.numerator) / load.denominator).ln())
                t, T = (2 * s - low - high) / (high - low), [Fraction(1)]
                T.append(t)
                while len(T) < terms:
                    T.append(2 * t * T[-1] - T[-2])
                V = sum(certificate.integer(c) * Ti for c, Ti in zip(words[7:], T)) * Fraction(2) ** exponent
                if abs(V - 16**m * area(m, load, 16) / load) > error * Fraction(101, 100):
                    return False
        return True

    def true_piece(self, words, law):
        """Whether V_m is as near phi_m as its line says, by the program's segments: (9.3) is x phi_m pi sin 2 pi a, x = sin^2(pi a)."""
        (base, degree), load, _ = certificate.fields(law[4:7], "G load bits", "")
        m, low, high, centre, radius, power, exponent, error = certificate.fields(words[4:12], certificate.FORMS["piece"], "")
        iv.Interval.bits = 128
        laws = distributions.Laws(certificate.root_of(base, degree), load, 128)
        for share in (Fraction(1, 9), Fraction(1, 2), Fraction(9, 10)):
            T, Y = float(low + (high - low) * share), float(laws.top(m).middle())
            a = Fraction(math.asin(math.sqrt(Y * math.sqrt(1 - T))) / math.pi)
            x = iv.sin_pi(a).square()
            T = 1 - (x / laws.top(m)).square()
            V = distributions.Polynomial(low, high, centre, radius, power, exponent, [certificate.integer(c) for c in words[12:]])
            here = (distributions.half_power(T, power) * V.value(T) * x * iv.pi() * iv.sin_pi(2 * a)).middle()
            if abs(distribution("segments.density", m, a, load, f"({base})^(1/{degree})") - here) > error * here * Fraction(101, 100):
                return False
        return True

    def test_no_mutant_that_changes_the_meaning_is_accepted(self):
        chosen = random.Random(known.seed)
        accepted = []
        seen = 0
        while seen < known.mutants:
            text, what, original = self.mutant(chosen)
            if text == original:
                continue
            seen += 1
            said, read = self.said_of(text)
            if said == "proved":
                accepted.append(what)
                with self.subTest(mutant=what):
                    self.assertTrue(self.true_of(read), f"seed {known.seed}: accepted, and false: {what}")
        print(f"\n{seen} mutants, {seen - len(accepted)} refused, {len(accepted)} accepted, and all they say is true:", *accepted, sep="\n  ")
        self.assertLess(len(accepted), seen / 4)


def load_tests(loader, tests, pattern):
    """Those of the part: every case is in one of the two."""
    return unittest.TestSuite(case for suite in tests for case in suite if not known.part or (known.part == "proofs") == case.id().split(".")[-1].startswith("test_proves"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *rest])
