# SPDX-License-Identifier: MIT
"""The density D_1 of the pressure after two waves, in integers: lemma AA of docs/certificate.md.

D_1(x) = -dB_1/dP at load x, in units of 1/p*_1, is an integral over the mean pressure of the second wave (scale_one.py) that has but
logarithms, where an end of the one wave meets an end of the other. Fixed point: an integer stands for that many units 2^-bits.
"""
from fractions import Fraction
from functools import reduce
from operator import mul

import intervals as iv
from full_contact import Far
from intervals import Interval
from scale_one import COARSE, POWERS, Disc, Outside, by_gauss, largest, log2_above, off_by, root_of

MOST_PARTS = 400         # of the integrals on one interval of loads
MOST_POINTS = 48         # of a rule
PARTS = 8                # log2: so many parts may each be off by 2^-PARTS of what is wanted


class Event(Far):
    """An end of the one wave meets an end of the other, between these loads."""

    def __init__(self, cuts):
        super().__init__()
        self.cuts = cuts


class TwoWaves:
    """G and the pressure p in units of p*_0, intervals: of the second wave, of amplitude G and mean t, the ends. It has its density between
    `places`, and another formula on either side of t = G."""

    def __init__(self, p, G):
        self.p, self.G, self.full = p, G, sign_of(p - 2 * G) > 0
        self.seam = 0 if self.full else 1
        self.of_reals, self.of_discs = self.placed(lambda x: x), self.placed(Disc.of)
        self.lowest = self.of_reals[0][0]

    def placed(self, kind):
        """places; of the pieces between them the roots, the same objects where a piece ends at one"""
        least, bottom, top, G = map(kind, (self.p.square() / (4 * self.G), self.p - self.G, self.p + self.G, self.G))
        above = [(bottom, 1), (top, -1)]
        return ([bottom, top], [above]) if self.full else ([least, G, top], [[(least, 1)], above])

    def order(self, x):
        """of both ends of the first wave, of mean x, the signs of the distances from the places: 0 only of the seam, where it is not
        decided"""
        ends = [x - 1, x + 1] if x >= 1 else [None, 2 * root_of(x)]
        return [[-1 if end is None else sign_of(end - place, self.seam == k > 0) for k, place in enumerate(self.of_reals[0])]
                for end in ends]


def product(factors):
    return reduce(mul, factors, Interval.of(1))


def sign_of(d, or_none=False):
    d = Interval.of(d)
    if d.low <= 0 <= d.high and not or_none:
        raise Far
    return (d.low > 0) - (d.high < 0)


class Loads:
    """Two waves of all loads of a disc, or of one, that have this order: the halves of the integral over the pressure t of scale 0."""

    def __init__(self, waves, full, order, load):
        self.waves, self.load, self.full, self.halves = waves, load, full, []
        ends = [load - 1, load + 1] if full else [None, 2 * root_of(load)]
        self.first = list(zip(ends, (1, -1))) if full else [(ends[1], -1), (-ends[1], 1)]
        (low, top), (of_low, of_top), (places, roots) = ends, order, waves.of_discs if isinstance(load, Disc) else waves.of_reals
        for k, second in enumerate(roots):
            if of_low[k + 1] < 0 < of_top[k]:
                a, b = low if of_low[k] > 0 else places[k], top if of_top[k + 1] < 0 else places[k + 1]
                self.halves += [Half(self, second, a, b, 1), Half(self, second, b, a, -1)]


class Half:
    """pi^2 times the integrand of D_1/G (scale_one.py), from one end of an interval of t to its middle: t = end + sign L u^2, 2L its
    length, 0 <= u <= 1. A root that the end makes is sqrt(L) u and cancels; if the other end makes one too, sqrt(L (2 - u^2)), there is no
    L left, and L may be 0."""

    def __init__(self, loads, second, end, other, sign):
        kind, waves = Disc.of if isinstance(loads.load, Disc) else Interval.of, loads.waves
        self.L, self.sign, places = kind((other - end) * (sign * Fraction(1, 2))), sign, loads.first + second
        self.own = any(place is end for place, _ in places)
        self.both = self.own and any(place is other for place, _ in places)
        self.distances = [(kind((end - place) * side), sign * side) for place, side in places
                          if place is not end and not (self.both and place is other)]
        self.end, self.G, self.p, self.load, self.one = map(kind, (end, waves.G, waves.p, loads.load, 1))
        self.full, self.below_seam = loads.full, len(second) == 1
        start = kind(root_of(kind(2))) if self.both else 2 * root_of(self.L) if self.own else 2 * self.L
        self.start = start / (2 * root_of(self.G)) if self.below_seam else start

    def __call__(self, u):
        v = self.L * u * u
        t, total = self.end + v * self.sign, self.start if self.own else self.start * u
        above, below = [], [1 - u * u * Fraction(1, 2)] if self.both else []
        for A, x, p in [(self.one, self.load, t)] * (not self.full) + [(self.G, t, self.p)] * self.below_seam:  # (2.19)
            R = root_of((A - x).square() + p.square())
            total, above, below = total * (p / R), [*above, A + x + R], [*below, A - x + R]
        if isinstance(u, Interval):  # all is positive: one root will do
            return total * root_of(product(above) / product(below + [shift + v * sign for shift, sign in self.distances]))
        for each in above:
            total = total * root_of(each)
        for each in [*map(root_of, below), *(self.distance_root(shift, sign, u, v) for shift, sign in self.distances)]:
            total = total / each
        return total

    def distance_root(self, shift, sign, u, v):
        """sqrt(shift + sign L u^2); of a disc of u far from 0 the square would be too wide, but sqrt(L) u can be taken out"""
        try:
            return root_of(shift + v * sign)
        except Outside:
            if sign < 0:
                raise
        return root_of(self.L) * u * root_of(1 + shift / self.L * (1 / u).square())


def rules(integrand, allowed, bits):
    """(V), (AA): parts of 0 <= u <= 1 with a number of points of Gauss's rule for each, a bound of the integral, and how far the rules are
    off, for all loads of a disc"""
    Interval.bits = COARSE
    try:
        for u in (0, 1):
            integrand(Disc.of(u))
        found, size, off, stack = [], Fraction(0), Fraction(0), [(Fraction(0), Fraction(1))]
        while stack:
            a, b = stack.pop()
            if len(found) + len(stack) > MOST_PARTS:
                raise Outside
            K, M, power = rule(integrand, (a + b) / 2, (b - a) / 2, allowed)
            if K > MOST_POINTS:
                stack += [((a + b) / 2, b), (a, (a + b) / 2)]
                continue
            found.append((a, b, K))
            size += (b - a) * M
            off += off_by((b - a) / 2, M, power, K, bits)
        return found, size, off
    except Outside:
        raise Far from None
    finally:
        Interval.bits = bits


def rule(integrand, at, half, allowed):
    """the fewest points, with a bound on the ellipse 2^power for which they are"""
    best = MOST_POINTS + 2, None, None
    for power in POWERS:
        try:
            M = integrand(Disc(Interval.of(at), Interval.of(half * Fraction(4**power + 1, 2 ** (power + 1))))).reach().ends()[1]
        except Outside:
            continue
        K = 2 * max(1, -(-log2_above(6 * half * M / allowed) // (4 * power)))
        if K >= best[0]:
            break
        best = K, M, power
    return best


class AfterTwoWaves:
    """D_1 at the pressure P, in units of p*_1, so many times."""

    def __init__(self, G, P, bits, times=1):
        self.bits, self.one = bits, 1 << bits
        self.use_bits()
        self.waves, self.times = TwoWaves(P * G, G), Interval.of(times)
        self.of_integral = self.times * G / iv.pi().square()  # what it is of one
        self.deepest = 4 << bits // 2  # no interval is halved beyond

    def use_bits(self):
        Interval.bits = self.bits

    def on_disc(self, x1, x2, r, wanted):
        """(AA): D_1 on [x1, x2] as an interval of x, its bound on the disc r about the middle, and how far it is off"""
        full, at = x1 >= self.one, self.fraction(x1 + x2 >> 1)
        order, seam = self.one_order(x1, x2, Fraction(2) ** wanted)
        top = self.of_integral.ends()[1]
        try:
            disc = Loads(self.waves, full, order, Disc(Interval.of(at), Interval.of(self.fraction(r))))
        except Outside:
            raise Far from None
        each = [rules(half, Fraction(2) ** (wanted - PARTS) / top, self.bits) for half in disc.halves]

        def value(x):
            halves, total = Loads(self.waves, full, order, self.fraction(x)).halves, Interval.of(0)
            for half, (parts, *_) in zip(halves, each):
                for a, b, K in parts:
                    total = total + by_gauss(half, a, b, K)
            return (total * self.of_integral).ends()
        return value, sum(size for _, size, _ in each) * top, sum(off for *_, off in each) * top + seam

    def one_order(self, x1, x2, allowed):
        """(AA): of the ends of the waves on all of [x1, x2], as if none were beyond the seam where that may be, and what this costs"""
        seam, (at_1, at_2), off = self.waves.seam, map(self.waves.order, map(self.fraction, (x1, x2))), Fraction(0)
        for end, beyond in ((0, -1), (1, 1)) if seam and x1 >= self.one else ((1, 1),) if seam else ():
            if {at_1[1 - end][seam], at_2[1 - end][seam]} != {-beyond}:
                continue  # the other end has to be on its own side: else nothing of the wave might be left
            signs = {at_1[end][seam], at_2[end][seam]}
            here = self.beyond_seam(end, x1, x2) if signs != {-beyond} else allowed + 1
            if off + here <= allowed:
                off += here
                at_1[end][seam] = at_2[end][seam] = -beyond
        if at_1 != at_2 or 0 in [ends[seam] for ends in at_1 if seam]:
            raise Event(self.bracket(x1, x2))
        return at_1, off

    def beyond_seam(self, end, x1, x2):
        """(AA): above what the two formulas of the second wave's density give that differs from t = G to the end of the first wave, the
        lower (0) or upper (1)"""
        G, p, least = self.waves.G, self.waves.p, Disc.of(self.waves.lowest)
        ends = [(x + 2 * end - 1) if x1 >= self.one else 2 * root_of(x) for x in map(self.fraction, (x1, x2))]
        delta = Interval.of(max(largest(each - G).ends()[1] for each in ends))
        r = Interval.of(min(p.ends()[0], (2 * G - p).ends()[0]) / 4)
        if (r - 2 * delta).low <= 0:
            return Fraction(1 << 60)
        t, G, p = Disc(G, r), Disc.of(G), Disc.of(p)
        try:
            R = ((G - t).square() + p.square()).root()
            both = (p * (G + t + R).root() / ((G - t + R).root() * (t - least).root() * R * (2 * G.root())),
                    1 / ((t - (p - G)).root() * (p + G - t).root()))
        except Outside:  # these discs tell nothing
            return Fraction(1 << 60)
        return (sum(d.reach() for d in both) * self.times * self.waves.G * root_of(delta) * (delta / r).square() / 2).ends()[1]

    def bracket(self, x1, x2):
        """ends of a narrow interval in which the order changes, within [x1, x2]"""
        low, high = x1, x2
        while high - low > self.deepest:
            middle = low + high >> 1
            try:
                same = self.waves.order(self.fraction(low)) == self.waves.order(self.fraction(middle))
            except Far:
                same = False
            low, high = (middle, high) if same else (low, middle)
        return [x for x in (low, high) if x1 < x < x2]

    def fraction(self, x):
        return Fraction(x, self.one)

    def weight(self, x1, x2):
        """(AA): above what D_1 on [x1, x2] counts for, next to a logarithm, times the largest share that a wave may have of it"""
        self.use_bits()
        w, G, p = Interval.of(self.fraction(x2 - x1)), self.waves.G, self.waves.p
        of_first = 2 if x1 >= self.one else root_of(2) / self.waves.lowest
        of_second = 2 + (0 if self.waves.full else root_of(1 + 2 * G / p) / 2)
        return (self.times * of_first * of_second * root_of(G) / 9 * (12 + 2 * log2_above((1 + 2 / w).ends()[1]))).ends()[1]
