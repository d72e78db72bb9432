# SPDX-License-Identifier: MIT
"""The limit C(G) = lim A_n G^n/(lambda_0 load) at any G > 1, full contact included, by Poisson's equation; lemmas W and X are those of
docs/certificate.md.

V = G Phi is data: polynomials of z = y^2 on the panels of a mesh (full_contact.py), 0 beside them. This program bounds R = B_0 - c x - V/G
+ T V on intervals J that it chooses itself, and |C(G) - c| <= E[|R|/x], a mean in the limit, follows from that.
"""
from bisect import bisect_left
from fractions import Fraction
from math import isqrt
from operator import mul
from typing import NamedTuple

from full_contact import MOST_POINTS, REACH, Far, Mesh, lebesgue
from scale_one import log2_above
from transfer import Refused, chebyshev

MOST_INTERVALS = 20000   # in all
MANY = 8                 # log2: so many narrow intervals may each leave as much as a wide one
NARROWEST = 4            # bits below 2^-accuracy/sup|V|, as a hole has R in proportion: no interval is halved beyond
INNER = 3                # an ellipse 2^INNER about an interval: what panels far from the ends of its waves give is had once for all in it
FEW = 8                  # panels for which that is not worth while
LEAST_PRESSURE = Fraction(1, 1024)  # of a force: its angle at a small pressure is less accurate
AFTER_TWO = Fraction(3121, 10000)  # above 2^(1/2) log 2/pi
DEEPER = 4               # bits that it is more accurate, as it is added up over intervals in one another


def without_zeros(c):
    """but for those at its end; one is kept"""
    return c[:max((k + 1 for k, a in enumerate(c) if a), default=1)]


class Inner(NamedTuple):
    """Of T V on an interval: what the panels give that are named, sums of polynomials about a middle, on so much either side, off by so
    much at most."""
    panels: range = range(0)
    parts: list = []
    off: Fraction = Fraction(0)


class Poisson(Mesh):
    """Level 0 of the mesh is V."""

    def __init__(self, *arguments):
        super().__init__(*arguments)
        self.above_G = Fraction(self.G + 1, self.one)
        self.falling = [[k << self.work for k in reversed(without_zeros(levels[0]))] for levels in self.series]

    def off_by(self, c, progress=lambda done: None):
        """(W), (X): above |C(G) - c|"""
        panels = self.farthest[-1]
        next_ratio = self.most(self.edges[panels]) + (self.edges[panels] >> self.bits) + 4
        if self.levels != 1 or self.edges[0] >= self.one or next_ratio >= self.edges[-1]:
            raise Refused("the mesh is not one of this kind, or does not reach as far as ratios do")
        self.c = -(-c * self.one // 1)
        self.c_off = Fraction(4 + (self.edges[panels] >> self.bits), self.one) + Fraction(2, self.unit)  # of c x
        self.found, self.progress = [(self.edges[0], self.below())], lambda p: progress(f"panel {p + 1} of {panels}")
        self.cover(panels)
        return self.above_G**2 * self.means()

    def cover(self, panels):
        """widths, and |R|, of intervals that cover the first so many panels, cut at 1; what is known on all of an interval serves its
        parts"""
        cuts = sorted({self.edges[0], self.edges[panels], *([self.one] if self.edges[panels] > self.one else [])})
        stack = [(a, b, Inner()) for a, b in zip(cuts, cuts[1:])]
        while stack:
            a, b, inner = stack.pop()
            if b - a < 1 << self.bits // 2:
                raise Refused("a panel is too narrow")  # for the rounding of points on it
            if len(self.found) + len(stack) > MOST_INTERVALS:
                raise Refused("the polynomials of a mesh do not solve Poisson's equation")
            inner, p, q = self.more(a, b, inner), self.panel(a), self.panel(b - 1)
            if p < q:
                at = self.edges[min(max(bisect_left(self.edges, a + b >> 1), p + 1), q)]
                stack += [(at, b, inner), (a, at, inner)]
                continue
            self.progress(p)
            try:
                here = self.left_on(p, a, b, inner)
            except Far as why:
                cuts = [a, *(why.cuts or [a + b >> 1]), b]
                stack += [(*ends, inner) for ends in reversed(list(zip(cuts, cuts[1:])))]
                continue
            self.found.append((b - a, here))

    def left_on(self, p, a, b, inner):
        """|R| on [a, b], which is to be cut if it is far from what polynomials can follow and not narrow"""
        try:
            return self.residual(p, a, b, inner)
        except Far:
            if b - a > max(self.one >> self.accuracy + NARROWEST + max(0, self.largest), 4 << self.bits // 2):
                raise
        return self.hole(p, a, b)

    def integral(self, p, rule):
        """(L): by Clenshaw's recurrence, there being one level, which needs no bound to be told from others; in units 2^-(work + kept)"""
        work, (*later, first), total = self.work, self.falling[p], 0
        for at, weight in rule:
            twice, u, before = 2 * at, 0, 0
            for c in later:
                u, before = c + (twice * u >> work) - before, u
            total += weight * (first + (at * u >> work) - before) >> work
        return total, 0

    def unpacked(self, total):
        return [total]

    def more(self, a, b, inner):
        """(K): `inner`, and what more panels give that are far from the ends of all waves on J = [a, b]"""
        h, middle = (b - a >> 1) + 1, a + b >> 1
        try:
            y_low, y_high = self.inner(a, b, (h * (4**INNER + 1) >> INNER + 1) + 1)
        except Far:
            return inner
        first, last = self.panel(y_low) + 1, self.panel(y_high)
        panels = [p for p in range(first, last) if p not in inner.panels]
        if len(panels) < FEW or not first <= inner.panels.start <= inner.panels.stop <= last and inner.panels:
            return inner
        size, wanted = self.largest + 3, self.wanted(a, b) - DEEPER  # 5 sup |V|
        count, one = self.fewer(size, wanted, INNER), self.round + Fraction(2) ** (wanted - 6)
        if count > MOST_POINTS:
            return inner
        values = [self.row(x, -1, len(self.series), -wanted, panels)[0] for x in self.chebyshev_points(a, b, count)]
        off = lebesgue(count) * one + (1 + lebesgue(count)) * 2 * Fraction(2) ** (size - INNER * (count - 1)) / (2**INNER - 1)
        return Inner(range(first, last), [*inner.parts, (middle, h, self.coefficients(values))], inner.off + off)

    def coefficients(self, values):
        """of the polynomial in Chebyshev's T_k with these values at as many Chebyshev points"""
        T = [chebyshev(t, self.one, len(values), self.bits) for t in self.cosines(len(values))]
        return [(sum(map(mul, values, column)) << (k > 0)) // (len(values) << self.bits) for k, column in enumerate(zip(*T))]

    def inner_at(self, x, inner):
        """what it says of T V at x, in units 2^-(work + kept)"""
        return sum(sum(map(mul, c, chebyshev(((x - middle) << self.bits) // h, self.one, len(c), self.bits))) >> self.bits
                   for middle, h, c in inner.parts)

    def share_of_one(self, width):
        """(H): above what a wave has of ratios between two that are so far apart"""
        return Fraction(isqrt((self.G + 1) * width >> 1) + 1, self.one)

    def share(self, width):
        """(X): above E[1_J/x]/G^2 for these ratios: anyhow, after one wave, or after two"""
        w, root_of_G = Fraction((self.G + 1) * width, self.one**2), Fraction(isqrt(self.G + 1 << self.bits) + 1, self.one)
        of_two = w * (1 + root_of_G * (2 + log2_above(1 / (2 * w)) * AFTER_TWO))
        return min(Fraction(1), self.above_G * self.share_of_one(width), self.above_G**2 * of_two)

    def means(self):
        """(X): above E[|R|/x]/G^2: a + sum (R_J - a) share_J over R_J > a, for the a with which that is least"""
        each, weight, a = sorted(((bound, self.share(width)) for width, bound in self.found), reverse=True), Fraction(0), Fraction(0)
        for bound, share in each:
            weight += share
            if weight >= 1:
                a = bound
                break
        return a + sum((bound - a) * share for bound, share in each if bound > a)

    def wanted(self, a, b):
        """log2 of what R may be on an interval: more on a narrow one, of which a wave has little"""
        share = self.share(b - a)
        return -self.accuracy + max(0, share.denominator.bit_length() - share.numerator.bit_length() - MANY)

    def below(self):
        """(W): |R| from 0 to the first panel, where V = 0, and of the wave at most the share sqrt(x) has ratios, up to most(x)"""
        y = self.edges[0]
        size = max(Fraction(2) ** (self.lg[p][0] + 1) for p in range(max(0, self.panel(self.most(y) + 4)) + 1))
        return Fraction(isqrt(y << self.bits) + 1, self.one) * (1 + size) + Fraction((y * self.c >> self.bits) + 2, self.one)

    def residual(self, p, x1, x2, inner):
        """(K), (W): |R| on J = [x1, x2] in the panel p"""
        wanted, at, h = self.wanted(x1, x2), x1 + x2 >> 1, (x2 - x1 >> 1) + 1
        r = h * REACH.numerator // REACH.denominator + 1
        first, size, first_off = self.first_on_disc(x1, x2, r, wanted)
        low, high, log_size = self.disc(p, x1, x2)
        count, beyond = self.interpolation(self.log_size(log_size, at + r, size), wanted)
        (off, ) = self.mismatch(low, high, x1, x2)
        if off > Fraction(2) ** wanted:
            raise Far
        if inner.panels and not low < inner.panels.start <= inner.panels.stop <= high:
            inner = Inner()
        rows, off_by = self.wave(x1, x2, low, high, count, wanted, inner.panels)
        points = self.chebyshev_points(x1, x2, count)
        worst = max(abs(row[0] + self.inner_at(x, inner) + f - self.rest(p, x)) for x, row in zip(points, rows) for f in first(x))
        return lebesgue(count) * (Fraction(worst, self.unit) + 4 * self.round + off_by + inner.off + self.c_off + first_off) + beyond + off

    def log_size(self, of_waves, x, size):
        """log2 of what B_0, at most `size`, c x and the rest, at most 2^of_waves, may come to on a disc that is nowhere beyond x"""
        return max(of_waves, ((self.c * x >> 2 * self.bits) + 2 + size).bit_length()) + 1

    def first_on_disc(self, x1, x2, r, wanted):
        """(M): B_0 on [x1, x2], between some values, in units 2^-(work + kept), as a function of x; what it is at most on the disc r; how
        far it is off"""
        radius = self.first_disc(x1 + x2 >> 1, x1, x2)
        if radius and r > radius:
            raise Far
        return lambda x: [self.first_wave(x) << self.kept], self.first_size((x1 + x2 >> 1) + r), 0

    def first_size(self, x):
        """(M): above |B_0| on a disc where it is analytic, whose points are no larger than x"""
        return 1 + (((2 * self.P + 4 * x >> self.bits) + 4).bit_length() // 4 + 1 if self.P else 0)

    def load_term(self, x):
        """c x, in units 2^-(work + kept)"""
        return self.c * x << self.work + self.kept >> 2 * self.bits

    def rest(self, p, x):
        """c x + V/G at x"""
        (V, ) = self.values(p, x * x >> self.bits)
        return self.load_term(x) + (V << self.bits) // self.G

    def hole(self, p, x1, x2):
        """(W): |R| on J, no wider than it is and on one side of 1, where no polynomial follows T V or B_0"""
        at, h = x1 + x2 >> 1, (x2 - x1 >> 1) + 1
        (t, ) = self.exact_row(at)
        ends = [[((self.first_wave(x) << self.kept) - self.load_term(y) + t) * self.G >> self.bits] for x, y in ((x1, x2), (x2, x1))]
        (off, ) = self.furthest(p, x1, x2, lambda z: ends)
        return off + self.moved(h) + 4 * self.round + self.quadrature + 2 * self.c_off


class Force(Poisson):
    """The force F_P that one wave carries above the pressure P for B_0."""

    def first_wave(self, x):
        """(W): in units 2^-work"""
        one, bits, trig, P = self.one, self.bits, self.trig, self.P
        if x >= one:
            less, more = max(0, one - P + x), max(0, one + P - x)
            total = (x * trig.of_cosine(less, more) >> bits) + isqrt(less * more)
        else:
            w = isqrt((one - x) ** 2 + P**2) - x
            less, more = max(0, one - w), max(0, 2 * x - one + w)
            total = isqrt(less * more) + 2 * (x * trig.angle(isqrt(less * (one + w)), P) >> bits)
        return (total << self.work) // trig.pi

    def first_size(self, x):
        """(W)"""
        return (2 * self.P + (6 + super().first_size(x)) * x >> self.bits) + 5

    def rounding(self):
        """(W)"""
        return super().rounding() * 16 * (3 + (self.edges[-1] >> self.bits))
