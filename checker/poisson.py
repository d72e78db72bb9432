# SPDX-License-Identifier: MIT
"""The limit C(G) = lim A_n G^n/(lambda_0 load) at any G > 1, full contact included, by Poisson's equation; lemmas W and X are those of docs/certificate.md.

V = G Phi is data: polynomials of z = y^2 on the panels of a mesh (full_contact.py), 0 beside them. This program bounds R = B_0 - c x - V/G + T V on
intervals J that it chooses itself, and |C(G) - c| <= G^3 sup (T|R|)(x) follows from that.
"""
from fractions import Fraction
from math import isqrt

from full_contact import REACH, Far, Mesh, lebesgue
from transfer import Refused

MOST_INTERVALS = 20000   # in all
MANY = 8                 # log2: so many narrow intervals may each leave as much as a wide one
NARROWEST = 4            # bits below 2^-accuracy: no interval is halved beyond


class Poisson(Mesh):
    """Level 0 of the mesh is V."""

    def off_by(self, c, progress=lambda done: None):
        """(W), (X): above |C(G) - c|"""
        panels = self.farthest[-1]
        if self.levels != 1 or self.edges[0] >= self.one or self.most(self.edges[panels]) + (self.edges[panels] >> self.bits) + 4 >= self.edges[-1]:
            raise Refused("the mesh is not one of this kind, or does not reach as far as ratios do")
        self.c = -(-c * self.one // 1)
        self.c_off = Fraction(4 + (self.edges[panels] >> self.bits), self.one) + Fraction(2, self.unit)  # of c x
        self.found = [(self.edges[0], self.below())]
        for p in range(panels):
            progress(f"panel {p + 1} of {panels}")
            self.cover_panel(p)
        return Fraction(self.G + 1, self.one) ** 3 * self.averaged_once()

    def cover_panel(self, p):
        """widths, and |R|, of intervals that cover it, cut at 1"""
        a, b = self.edges[p], self.edges[p + 1]
        stack = [(self.one, b), (a, self.one)] if a < self.one < b else [(a, b)]
        while stack:
            a, b = stack.pop()
            if b - a < 1 << self.bits // 2:
                raise Refused("a panel is too narrow")  # for the rounding of points on it
            try:
                here = self.residual(p, a, b)
            except Far:
                if b - a > self.one >> self.accuracy + NARROWEST and b - a > 4 << self.bits // 2:
                    stack += [(a + b >> 1, b), (a, a + b >> 1)]
                    continue
                here = self.hole(p, a, b)
            self.found.append((b - a, here))
            if len(self.found) + len(stack) > MOST_INTERVALS:
                raise Refused("the polynomials of a mesh do not solve Poisson's equation")

    def share(self, width):
        """(H): above what a wave has of ratios between two that are so far apart"""
        return min(Fraction(1), Fraction(isqrt(((self.G + 1) * width >> 1) + 1) + 1, self.one))

    def averaged_once(self):
        """(X): a + sum (R_J - a) share_J over R_J > a, for the a with which that is least"""
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

    def residual(self, p, x1, x2):
        """(K), (W): |R| on J = [x1, x2] in the panel p"""
        wanted, at, h = self.wanted(x1, x2), x1 + x2 >> 1, (x2 - x1 >> 1) + 1
        r, radius = h * REACH.numerator // REACH.denominator + 1, self.first_disc(at, x1, x2)
        if radius and r > radius:
            raise Far
        low, high, log_size = self.disc(p, x1, x2)
        log_size = max(log_size, ((self.c * (at + r) >> 2 * self.bits) + 3).bit_length()) + 1  # |B_0| <= 1, c x, and the rest
        count, beyond = self.interpolation(log_size, wanted)
        (off, ) = self.mismatch(low, high, x1, x2)
        if off > Fraction(2) ** wanted:
            raise Far
        rows, off_by = self.wave(x1, x2, low, high, count, wanted)
        worst = max(abs(row[0] + self.rest(p, x)) for x, row in zip(self.chebyshev_points(x1, x2, count), rows))
        return lebesgue(count) * (Fraction(worst, self.unit) + 4 * self.round + off_by + self.c_off) + beyond + off

    def load_term(self, x, y):
        """B_0(x) - c y, in units 2^-(work + kept)"""
        return (self.first_wave(x) << self.kept) - (self.c * y << self.work + self.kept >> 2 * self.bits)

    def rest(self, p, x):
        """B_0 - c x - V/G at x"""
        (V, ) = self.values(p, x * x >> self.bits)
        return self.load_term(x, x) - (V << self.bits) // self.G

    def hole(self, p, x1, x2):
        """(W): |R| on J, no wider than it is and on one side of 1, where no polynomial follows T V or B_0"""
        at, h = x1 + x2 >> 1, (x2 - x1 >> 1) + 1
        (t, ) = self.exact_row(at)
        ends = [[(self.load_term(x, y) + t) * self.G >> self.bits] for x, y in ((x1, x2), (x2, x1))]
        (off, ) = self.furthest(p, x1, x2, lambda z: ends)
        moved = Fraction(2) ** (self.largest + 1) * Fraction(isqrt(32 * h << self.bits) + 1, self.one)
        return off + moved + 4 * self.round + self.quadrature + 2 * self.c_off
