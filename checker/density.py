# SPDX-License-Identifier: MIT
"""Densities of the pressure with full contact, in integers: lemma AA of docs/certificate.md, and G to L (full_contact.py).

D_n(x) = -dB_n/dP, the density at scale n and load x in units of 1/p*_n, is T^(n-1) D_1 (two_waves.py). V_0 is near D_1 here, and V_m near T
V_(m-1).
"""
from fractions import Fraction
from math import isqrt

from full_contact import REACH, Mesh, jumps, lebesgue
from intervals import Interval
from scale_one import log2_above, root_of
from transfer import Refused
from two_waves import AfterTwoWaves, sign_of

NARROWEST = 4            # bits below 2^-accuracy/sup|V|: no interval of later levels is halved beyond
MINUS = 64               # units for what 1 + c and 1 - c are rounded by, times 1 + y


class Density(Mesh):
    """Level 0 is D_1. It serves one load."""

    def __init__(self, G, pressure, load, *arguments):
        super().__init__(G, pressure, load, *arguments)
        self.first = AfterTwoWaves(G, pressure, self.bits)
        self.surface, self.load, self.at = G, load, load * self.one // 1
        self.apart, self.nearest, x = [], [], self.at  # what is large of level 0, and where; from which panel on a level matters
        for _ in range(self.levels):
            p = self.panel(self.least(x) - (x >> self.bits) - 4)
            self.nearest.insert(0, p)
            x = self.edges[p] if p >= 0 else 0

    def first_on(self, p, x1, x2, wanted):
        """(AA): |V_0 - D_1| on [x1, x2]"""
        self.first.use_bits()
        at, h = x1 + x2 >> 1, (x2 - x1 >> 1) + 1
        r = h * REACH.numerator // REACH.denominator + 1
        value, size, off = self.first.on_disc(x1, x2, r, wanted)
        log_size = max(log2_above(size), self.continued(p, at, at, (2 * at * r + r * r >> self.bits) + 1)) + 1
        count, beyond = self.interpolation(log_size, wanted)
        worst = 0
        for x in self.chebyshev_points(x1, x2, count):
            V = Fraction(self.values(p, x * x >> self.bits)[0], self.unit)
            worst = max(worst, *(abs(V - end) for end in value(x)))
        return [lebesgue(count) * (worst + off + 2 * self.round) + beyond]

    def hole(self, p, x1, x2):
        """(AA): next to a logarithm: what |V_0 - D_1| counts for on [x1, x2], times the largest share that a wave may have of it"""
        self.apart.append((x1, x2, self.first.weight(x1, x2) + Fraction(2) ** self.lg[p][0]))
        return [Fraction(0)]

    def later_hole(self, p, x1, x2, levels):
        """(AA): |V_m - T V_(m-1)| on [x1, x2], m = 1 ...: T V changes slowly where no polynomial follows it"""
        moved = self.moved((x2 - x1 >> 1) + 1)
        ends = [[0, *(v << up for v, up in zip(self.exact_row(x1 + x2 >> 1), self.up))]]
        of_levels = self.furthest(p, x1, x2, lambda z: ends)[1:levels]
        return [d + (moved + self.quadrature + self.round) * 2**up for d, up in zip(of_levels, self.up)]

    def defects(self, progress=lambda done: None):
        """(G), (AA): of each level, D_m on intervals, ascending; 0 where a level does not matter"""
        first, later, deepest = [], [], self.first.deepest
        if self.nearest[0] < 0:
            first, later = self.below()
        for p in range(max(0, self.nearest[0]), self.farthest[0]):
            progress(f"panel {p + 1} of {self.farthest[0]}")
            wanted, levels = -self.aims[p], sum(a <= p < b for a, b in zip(self.nearest, self.farthest))
            for a, b, (d, ), small in self.cover(p, lambda a, b: self.first_on(p, a, b, wanted),  # noqa: B023
                                                 lambda a, b: self.hole(p, a, b), wanted, lambda a, b: b - a > deepest):  # noqa: B023
                if not small:
                    self.apart.append((a, b, d))
                first.append((a, b, [d if small else Fraction(0)]))
            if levels > 1:
                narrowest = max(deepest, self.one >> self.accuracy + NARROWEST + max(0, self.largest))
                later += self.cover(p, lambda a, b: self.on_interval(p, a, b, wanted, levels),  # noqa: B023
                                    lambda a, b: self.later_hole(p, a, b, levels), wanted, lambda a, b: b - a > narrowest)  # noqa: B023
        return first, later

    def below(self):
        """(AA): from 0 to the first panel D_1 is 0, as V_m, and a wave has at most the share sqrt(x) in contact"""
        y = self.edges[0]
        if y >= self.one or sign_of(2 * root_of(self.first.fraction(y)) - self.first.waves.lowest) > 0:
            raise Refused("the mesh begins where there is pressure")
        reached, root = self.series[:self.panel(self.most(y) + 4) + 1], Fraction(isqrt(y << self.bits) + 1, self.one)
        sizes = [max((2 * sum(map(abs, levels[m])) for levels in reached), default=0) for m in range(len(self.up))]
        later = [root * Fraction(size, 1 << self.kept) * 2**up for size, up in zip(sizes, self.up)]
        return [(0, y, [Fraction(0)])], [(0, y, later)] if self.up else []

    def once(self, x1, x2):
        """(AA): above what waves of these means make of all that was kept apart of level 0"""
        return sum((weight * self.share_of(a, b, x1, x2) for a, b, weight in self.apart), Fraction(0))

    def share_of(self, a, b, x1, x2):
        """(H), (AA): above what such a wave has of the ratios from a to b, and of what is narrower in proportion to the root of its width
        at least: where it has a ratio grows with that and falls with the mean, also across 1"""
        one = self.one
        if a > self.most(x2) + (x2 >> self.bits) + 4 or b < self.least(x1) - (x1 >> self.bits) - 4:
            return Fraction(0)
        lower, upper = ((self.G * y >> self.bits) - x if x >= one else isqrt((self.G * y >> self.bits) ** 2 + (one - x) ** 2) - x
                        for y, x in ((a, x2), (b, x1)))
        spare = MINUS * ((b >> self.bits) + 1)
        sides, width = (one + lower - spare, one - upper - spare), (self.G * (b - a) >> self.bits) + 1
        any_one = isqrt((self.G * (b - a) >> 1) + 1) + 1
        if min(sides) > 0:
            any_one = min(any_one, width * one // (3 * isqrt(min(one, sides[0]) * min(one, sides[1]))) + 1)
        return Fraction(any_one, one)

    def value(self, n, load, errors):
        """q_n p*_0 at this load: low and high, fractions"""
        if load != self.load or n < 2:
            raise Refused("a mesh of densities serves one load, and scales from 2 on")
        (ends, errors), m = errors, n - 2
        row, e = self.exact_row(self.at)[m], errors[m]
        shares = (self.shares(x, ends) for x in (self.at, -(-load * self.one // 1)))
        error = Fraction(self.averaged((jumps(e), [0] * len(e), max(e)), *shares), self.one)
        error += self.moved(1) + 2 * self.round + self.quadrature + (0 if m else self.once(self.at, -(-load * self.one // 1)))
        self.first.use_bits()
        of_scale = Interval.of(1)
        for _ in range(n):
            of_scale = of_scale / self.surface
        ends = [(of_scale * (Fraction(row, self.unit) + off) / 2 ** self.lift[m]).ends() for off in (-error, error)]
        return min(map(min, ends)), max(map(max, ends))
