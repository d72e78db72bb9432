# SPDX-License-Identifier: MIT
"""Scale 1 of the recursion (6.1): shares in contact or above a pressure, and densities, at any load and any G, as one integral over the
pressure t of scale 0.

The share above p is int q_0(t) Q(t) dt and the density int q_0(t) d(t) dt, where Q and d are those of a wave of amplitude G and mean t:
(2.14), (2.15) where t >= G, (2.17), (2.19) where t < G; q_0 is the density of a wave of amplitude 1 and mean `load`. Between the ends of
both waves and t = G the integrand is analytic but for roots. Each such interval is cut in the middle, t = end +- v^2 takes the roots away,
and rules of Gauss on parts of v do the rest: lemmas U and V of docs/certificate.md. The integrand is written once: of an interval it is the
value, of a disc a bound. Nothing is rounded by hand.
"""
from fractions import Fraction
from functools import lru_cache

import closed_forms
import intervals as iv
from closed_forms import below, root
from full_contact import Trigonometry
from intervals import Interval

POWERS = 12, 9, 7, 6, 5, 4, 3, 2  # rho = 2^power of the ellipses on which the integrand is bounded
MOST_POINTS, MOST_PARTS = 64, 1000
GUARD = 44                        # bits of the value that the rules leave open: roundings take some of these anyway
COARSE = 64                       # bits of bounds


class Outside(Exception):
    """A disc reaches where nothing is known of the integrand."""


class Disc:
    """(U): all complex numbers that are no further than `radius` from the real `centre`; both are intervals"""
    __slots__ = ("centre", "radius")

    def __init__(self, centre, radius):
        self.centre, self.radius = centre, radius

    @staticmethod
    def of(x):
        return x if isinstance(x, Disc) else Disc(Interval.of(x), Interval.of(0))

    def __add__(self, other):
        other = Disc.of(other)
        return Disc(self.centre + other.centre, self.radius + other.radius)

    __radd__ = __add__

    def __neg__(self):
        return Disc(-self.centre, self.radius)

    def __sub__(self, other):
        return self + -Disc.of(other)

    def __rsub__(self, other):
        return -self + other

    def __mul__(self, other):
        other = Disc.of(other)
        return Disc(self.centre * other.centre, largest(self.centre) * other.radius + self.radius * other.reach())

    __rmul__ = __mul__

    def square(self):
        return self * self

    def reach(self):
        """above all moduli"""
        return largest(self.centre) + self.radius

    def least(self):
        """below all real parts, if these are positive"""
        least = self.centre - self.radius
        if least.low <= 0:
            raise Outside
        return least

    def __rtruediv__(self, one):
        product = self.least() * (self.centre + self.radius)
        return Disc(self.centre / product, self.radius / product) * one

    def __truediv__(self, other):
        return self * (1 / other)

    def root(self):
        middle = iv.sqrt(self.centre)
        return Disc(middle, self.radius / (middle + iv.sqrt(self.least())))


def largest(x):
    """a number above |x| for all x of an interval"""
    top = max(abs(x.low), abs(x.high))
    return Interval(top, top, x.exponent)


def root_of(x):
    """of what is positive for real u"""
    return x.root() if isinstance(x, Disc) else root(x)


def partial(A, x, p):
    """Of the wave of amplitude A and mean x < A: (2.19) but for (4 A x - p^2)^(-1/2)/pi, which is p S/R; and of (2.17) 1/(A + x + R) and 1
    - s."""
    R = root_of((A - x).square() + p.square())
    return p * root_of((A + x + R) / (A - x + R)) / R, 1 / (A + x + R), (A - x + R) / (2 * A)


class Half:
    """From one end of an interval of t to its middle: t = end + sign v^2, v = wide u, 0 <= u <= 1. What roots are taken of, t - place or
    place - t, is shift + sign v^2, and the shift is found to be 0 where it is."""

    def __init__(self, two, second, end, sign, length):
        self.two, self.end, self.sign, self.wide = two, end, sign, root(length / 2)
        self.first, self.second = ([(Fraction(0) if end is place else (end - place) * side, sign * side) for place, side in places]
                                   for places in (two.first, second))
        self.slope = 1 / (second[1][0] - second[0][0]) if len(second) > 1 else None  # (2.14): s = slope (t - place)


class Integrand:
    """Over u, but for a factor of 2/pi^2 for shares, 1/pi^2 for densities. All numbers are of one kind: Interval.of or Disc.of."""

    def __init__(self, half, share, of):
        self.share, self.sign, self.slope, self.partial = share, half.sign, half.slope, half.two.load < 1
        self.H, self.end, self.G, self.p, self.load, self.one = map(of, (half.wide, half.end, half.two.G, half.two.p, half.two.load, 1))
        roots = half.first if share else half.first + half.second
        self.inverse, self.own = [(of(shift), sign) for shift, sign in roots if shift != 0], sum(shift == 0 for shift, _ in roots)
        self.second = [(of(shift), sign, shift == 0) for shift, sign in half.second]

    def __call__(self, u):
        v = self.H * u
        square = v.square()
        t = self.end + square * self.sign
        total = 2 * self.H if self.own else 2 * self.H * v
        for shift, sign in self.inverse:
            total = total / root_of(shift + square * sign)
        if self.partial:
            total = total * partial(self.one, self.load, t)[0]
        if self.slope is None:
            density, slope, rest = partial(self.G, t, self.p)
            if not self.share:
                return total * density / (2 * root_of(self.G))
            return total * arcsine([*self.roots(v, square, 2 * slope), (None, rest)])
        return total * arcsine(self.roots(v, square, self.one * self.slope)) if self.share else total

    def roots(self, v, square, slope):
        """s, and 1 - s if that is linear too: as root or, where this is not at hand, square"""
        return [(v * root_of(slope), None) if own else (None, (shift + square * sign) * slope) for shift, sign, own in self.second]


def arcsine(both):
    """arcsin sqrt s"""
    if not any(isinstance(x, Disc) for x in both[0]):
        return iv.angle(*(w or root_of(square) for w, square in both))
    for upper, (w, square) in enumerate(both):
        try:
            w = w or root_of(square)
        except Outside:
            continue
        if (1 - w.reach()).low > 0:  # |arcsin w| <= (pi/2) |w| < 2 |w|, and |pi/2 - arcsin w| <= pi
            return Disc(Interval.of(1), Interval.of(3)) if upper else Disc(w.centre, 3 * w.reach())
    raise Outside


class TwoWaves:
    """One row: G and load are fractions, p too."""

    def __init__(self, p, load, G):
        if not (p >= 0 and load > 0 and G > 1):
            raise ValueError("outside the domain")
        self.p, self.load, self.G, self.halves = p, load, G, []
        low, top = (load - 1, load + 1) if load >= 1 else (Fraction(0), 2 * root(load))
        # (2.15), (2.19): where q_0 has roots, and to which side they are real
        self.first = [(low, 1), (top, -1)] if load >= 1 else [(top, -1), (-top, 1)]
        least = p * p / (4 * G)                                                      # (2.17), (2.19)
        up_to_G = [(least, 1)] if p else [(least, 1), (G, -1)]                       # in contact: s = t/G
        for a, b, second in ((max(least, low), G, up_to_G), (max(G, p - G, low), p + G, [(p - G, 1), (p + G, -1)])):
            b = top if below(top, b) else b
            if below(a, b):
                self.halves += [Half(self, second, end, sign, b - a) for end, sign in ((a, 1), (b, -1))]

    def integral(self, share):
        """None where it is infinite, or takes too many parts"""
        total, bits, parts = Interval.of(0), Interval.bits, 0
        for half in self.halves:
            value = Integrand(half, share, Interval.of)
            Interval.bits = COARSE
            bound = Integrand(half, share, Disc.of)
            Interval.bits = bits
            stack = [(Fraction(0), Fraction(1))]
            while stack:
                a, b = stack.pop()
                parts += 1
                if parts > MOST_PARTS or value.own > 1:
                    return None
                K, off = best_rule(bound, a, b, total, bits)
                if K:
                    total = total + by_gauss(value, a, b, K) + iv.error_term(Interval.of(off))
                else:
                    stack += [((a + b) / 2, b), (a, (a + b) / 2)]
        return total


def best_rule(integrand, a, b, before, bits):
    """(V): how many points from a to b are enough, and how far off these are at most; 0 where the interval is to be halved"""
    at, half = (a + b) / 2, (b - a) / 2
    Interval.bits = COARSE
    try:
        allowed = max(integrand(Disc.of(at)).centre.ends()[0] * half, before.ends()[0] / 64) / 2**(bits - GUARD)
        for power in POWERS if allowed > 0 else ():
            try:
                M = integrand(Disc(Interval.of(at), Interval.of(half * Fraction(4**power + 1, 2**(power + 1))))).reach().ends()[1]
            except Outside:
                continue
            K = 2 * max(1, -(-log2_above(6 * half * M / allowed) // (4 * power)))
            if K <= MOST_POINTS:
                return K, off_by(half, M, power, K, bits)
    except Outside:
        pass
    finally:
        Interval.bits = bits
    return 0, None


def off_by(half, M, power, K, bits):
    """(V)"""
    return half * M * (Fraction(6, 2**(2 * K * power)) + Fraction(1, 2**(bits - 15)))


def by_gauss(integrand, a, b, K):
    middle, half, total = Interval.of((a + b) / 2), Interval.of((b - a) / 2), Interval.of(0)
    for t, w in points(Interval.bits, K):
        off = half * Interval(t, t, -Interval.bits)
        total = total + (integrand(middle - off) + integrand(middle + off)) * w
    return total.scaled(-Interval.bits) * half


def log2_above(x):
    return max(0, x.numerator.bit_length() - x.denominator.bit_length() + 1)


@lru_cache(maxsize=4)
def trigonometry(bits):
    return Trigonometry(bits)


def points(bits, K):
    """(I): of a rule of Gauss, and weights, in units 2^-bits"""
    found = trigonometry(bits).gauss(K)
    Interval.bits = bits  # who makes one leaves others
    return found


def share(p, load, G):
    found = TwoWaves(p, load, G).integral(True)
    return None if found is None else found * 2 / iv.pi().square() + closed_forms.exceedance(p + G, load)


def density(p, load, G):
    found = TwoWaves(p, load, G).integral(False) if p else None
    return None if found is None else found / iv.pi().square()


def at_scale_one(quantity, integral):
    def form(n, *inputs):
        known = closed_forms.FORMS[quantity](n, *inputs)
        return integral(*inputs) if known is None and n == 1 else known
    return form


FORMS = {**closed_forms.FORMS, "contact.area": at_scale_one("contact.area", lambda load, G: share(Fraction(0), load, G)),
         "contact.exceedance": at_scale_one("contact.exceedance", share), "contact.density": at_scale_one("contact.density", density)}
