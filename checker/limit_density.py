# SPDX-License-Identifier: MIT
"""The limit of the density of the pressure at any G > 1, full contact included, by Poisson's equation with G D_1 for B_0; lemma AB of
docs/certificate.md."""
from fractions import Fraction

from full_contact import REACH, Far, lebesgue
from poisson import Poisson
from scale_one import root_of
from transfer import Refused
from two_waves import AfterTwoWaves, sign_of


class MeanDensity(Poisson):
    """E[G D_1/x], D_1 the density of the pressure after two waves (two_waves.py)."""

    def __init__(self, G, pressure, *arguments):
        super().__init__(G, pressure, *arguments)
        self.first, self.apart = AfterTwoWaves(G, pressure, self.bits, G), Fraction(0)
        if sign_of(2 * root_of(self.first.fraction(self.edges[0])) - self.first.waves.lowest) > 0:
            raise Refused("the mesh begins where there is pressure")

    def means(self):
        """(AB): and of all that was kept apart"""
        return super().means() + self.apart

    def first_on_disc(self, x1, x2, r, wanted):
        """(AA): G D_1"""
        self.first.use_bits()
        value, size, off = self.first.on_disc(x1, x2, r, wanted)
        return lambda x: [end * self.unit // 1 + k for k, end in enumerate(value(x))], -(-size // 1), off

    def hole(self, p, x1, x2):
        """(AB): |R| on J, where T V is what it is in the middle but for little; or 0, J being kept apart, if it is next to a logarithm"""
        try:
            return self.with_wave_of_middle(p, x1, x2)
        except Far:
            if x2 - x1 > self.first.deepest:
                raise
        bounded = self.c * x2 // self.one**2 + 1 + 2 * Fraction(2) ** (self.largest + 1)
        self.apart += (self.first.weight(x1, x2) + bounded) * self.share_of_one(x2 - x1) * self.above_G
        return Fraction(0)

    def with_wave_of_middle(self, p, x1, x2):
        """(AB): |R| on J = [x1, x2], T V as in its middle"""
        wanted, at, h = self.wanted(x1, x2), x1 + x2 >> 1, (x2 - x1 >> 1) + 1
        r = h * REACH.numerator // REACH.denominator + 1
        first, size, off = self.first_on_disc(x1, x2, r, wanted)
        (t, ) = self.exact_row(at)
        of_V = max(self.continued(p, at, at, (2 * at * r + r * r >> self.bits) + 1), self.largest + 1) + 1
        count, beyond = self.interpolation(self.log_size(of_V, at + r, size), wanted)
        worst = max(abs(t + f - self.rest(p, x)) for x in self.chebyshev_points(x1, x2, count) for f in first(x))
        return lebesgue(count) * (Fraction(worst, self.unit) + 4 * self.round + self.c_off + off + self.quadrature) + beyond + self.moved(h)
