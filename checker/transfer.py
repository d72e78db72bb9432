# SPDX-License-Identifier: MIT
"""The recursion (6.1)-(6.7) in partial contact, G > 2 and load <= 1, in integers; lemmas A-E are those of docs/certificate.md.

h_m(x) = G^m A_m(x)/x obeys h_{m+1}(x) = (2/pi) int h_m(y) q^(3/2) dv over all v, q = sech(v)^2, y^2 = (4/G^2) x q (1 - x + x q). With s =
-log x, h_m is analytic for Re s > 0 and |h_m| <= G exp(a Re s), a = 2^-(m+1) (A). The integral is a sum of `points` + 1 positive weights
(C, D), h_m a polynomial V_m on each of some panels low <= s <= high (B), and unknown beyond the last (E). So errors are averaged, and grow
by B alone.

Fixed point: an integer stands for that many units 2^-bits; a floor costs less than a unit, and what all of them cost is part of the error.
"""
from fractions import Fraction
from functools import cached_property
from operator import add

import intervals as iv
from intervals import Interval


FARTHEST = 1 << 14  # s: so that powers of exp(s) are numbers one can write


class Refused(Exception):
    """What is asked cannot be had from these numbers."""


def power_above(t):
    """a power of two, as an exponent, above exp(t), t >= 0 a fraction: 1/log 2 < 1.443"""
    return -(-Fraction(t) * 1443 // 1000)


def falling(t):
    """a power of two above exp(-t), t >= 0 a fraction: 1/log 2 > 1.4426"""
    return Fraction(1, 2 ** (Fraction(t) * 14426 // 10000))


def fixed(x, bits):
    """an integer within one unit 2^-bits of all of the interval"""
    low, high = x.ends()
    if (high - low) * 2 ** (bits + 1) > 1:
        raise Refused("an interval is wider than the arithmetic needs")
    return low * 2**bits // 1


class Panel:
    """low <= s <= high: Chebyshev's N points, within 2^-bits of them, and the lemma (B) about interpolation there."""

    def __init__(self, low, high, terms, rho, bits):
        self.low, self.high, self.terms, self.bits = low, high, terms, bits
        self.middle, self.half = (low + high) / 2, (high - low) / 2
        if not (0 < low < high <= FARTHEST and rho > 1 and (rho + 1 / rho) * self.half <= 2 * self.middle):
            raise Refused("a panel is too far out, or its ellipse leaves the half-plane")
        if ((self.middle * 2**bits).denominator, (self.half * 2**bits).denominator) != (1, 1):
            raise Refused("the edges of a panel are no multiples of the unit")
        self.tail = 2 * rho / ((rho - 1) * rho**terms)
        self.lebesgue = 1 + Fraction(9, 20) * terms.bit_length()

    @cached_property
    def points(self):
        Interval.bits = self.bits + 64
        return [fixed(iv.sin_pi(Fraction(2 * j + 1 + self.terms, 2 * self.terms)), self.bits) for j in range(self.terms)]

    @cached_property
    def powers(self):
        return [chebyshev(t, 1 << self.bits, self.terms, self.bits) for t in self.points]

    def size(self, a):
        """above |h| on the ellipse over G"""
        return 2 ** power_above(a * (self.low + self.high))

    def error(self, G, a, at_points):
        """(B): of the polynomial on the whole panel, from that at the points"""
        beyond = G * self.size(a) * self.tail
        return self.lebesgue * (at_points + beyond) + beyond


def chebyshev(t, weight, terms, bits):
    """weight T_i(t), i < terms: an error e made at step j counts for e U_(i-j)(t) at step i, so all of them for at most i(i + 1)/2 units"""
    before, u, t2 = weight, weight * t >> bits, 2 * t
    row = [before, u]
    for _ in range(2, terms):
        before, u = u, (t2 * u >> bits) - before
        row.append(u)
    return row[:terms]


class Logarithm:
    """-log(g) for 0 < g < 1 in units: a table by the leading bits and 2 artanh((c - f)/(c + f)); within bits + 8 units."""

    LEADING = 10

    def __init__(self, bits):
        self.bits = bits
        count, B = 1 << self.LEADING, self.LEADING
        self.table = [0] * (count // 2) + [fixed(-iv.log(Fraction(2 * i + 1, 2 * count)), bits) for i in range(count // 2, count)]
        self.odd = [(1 << bits) // (2 * j + 1) for j in range(bits // (2 * B) + 1, -1, -1)]
        self.of_two = fixed(iv.log(2), bits)

    def __call__(self, g):
        bits, e = self.bits, self.bits - g.bit_length()
        f = g << e
        i = f >> (bits - self.LEADING)
        c = (2 * i + 1) << (bits - self.LEADING - 1)
        z = ((c - f) << bits) // (c + f)
        square, total = z * z >> bits, 0
        for r in self.odd:
            total = r + (square * total >> bits)
        return self.table[i] + (z * total >> (bits - 1)) + e * self.of_two


class Rule:
    """The trapezoid rule of one G at one precision: q, -log q and weights at v = 0, step, 2 step ..."""

    def __init__(self, G, step, points, bits):
        Interval.bits = bits + 64
        self.G, self.step, self.count, self.bits = G, step, points, bits
        self.L = iv.log(G / 2)
        self.log_half_G = fixed(self.L, bits)
        self.log = Logarithm(bits)
        ratio, y, weight = iv.exp(Interval.of(-step)), Interval.of(1), 4 / iv.pi() * step
        self.nodes = []
        for k in range(points + 1):
            sech = 2 * y / (1 + y.square())
            w = weight * sech.square() * sech
            minus_log = -2 * iv.log(sech) if k else Interval.of(0)
            self.nodes.append((fixed(sech.square(), bits), fixed(minus_log, bits), fixed(w if k else w.scaled(-1), bits)))
            y = y * ratio
        least_cosine = Interval.of(max(Fraction(3, 4), (2 / G).ends()[1]))  # (C): cos^2 d
        d = iv.angle(iv.sqrt(1 - least_cosine), iv.sqrt(least_cosine))
        away = iv.exp(-2 * iv.pi() * d / step)
        self.quadrature = ((9 * away + 3 * iv.exp(Interval.of(-2 * step * points))) * G).ends()[1]  # (C) + (D)
        if away.ends()[1] > Fraction(1, 2):
            raise Refused("the step of the quadrature is too large")

    def row(self, s, x, rest, panels):
        """What T at x = exp(-s), rest = 1 - x, makes of polynomials on panels; all in units."""
        bits, half_s, log = self.bits, s + 2 * self.log_half_G, self.log
        one = (1 << bits) - 1
        edges = [(int(p.high * 2**bits), int(p.middle * 2**bits), int(p.half * 2**bits), p.terms) for p in panels]
        sums, beyond = [[0] * p.terms for p in panels], 0
        lowest = max(rest, self.nodes[-1][0])
        if lowest < 1 << 20:
            raise Refused("too few bits for this load")
        for q, log_q, w in self.nodes:
            s_y = (half_s + log_q + log(min(rest + (x * q >> bits), one))) >> 1
            for p, (high, middle, half, terms) in enumerate(edges):
                if s_y <= high:
                    break
            else:
                beyond += (w + 1) << power_above(Fraction((s_y >> bits) + 1, 2))
                continue
            if not w:
                continue
            t = ((s_y - middle) << bits) // half
            if not -one <= t <= one + 1:
                raise Refused("a point lies before the first panel")
            sums[p] = list(map(add, sums[p], chebyshev(t, w, terms, bits)))
        # (E) position: an error of s_y in units
        position = 32 + bits + 8 * (1 << bits) // lowest + int(panels[-1].high)
        return sums, beyond, position

    def apply(self, row, s, levels, a):
        """T V at the row's x with its error as T h: fractions. levels: (panel, coefficients, exponent, error, rounding) each."""
        sums, beyond, position = row
        unit, G = Fraction(1, 2**self.bits), self.G.ends()[1]
        value, error, rounding = Fraction(0), Fraction(0), 0
        for total, (_, coefficients, exponent, e, size) in zip(sums, levels):
            value += sum(map(int.__mul__, total, coefficients)) * unit * Fraction(2) ** exponent
            error += (total[0] + self.count) * unit * e
            rounding += size
        last, first = levels[-1][0].high, levels[0][0].low
        moved = 2 * position * G * 2 ** power_above(a * (last + 1)) / min(first / 2, Fraction(1, 2))
        weights = (self.count + 1) * G * 2 ** power_above(a * last)
        error += unit * (rounding * (self.count + 1) + moved + weights + beyond * G)
        return value, error + self.quadrature * 2 ** power_above(a / 2 * (s + 2 * self.L.ends()[1]))


def first_wave(s):
    """h_0 = (2/pi) arcsin(sqrt x)/x at x = exp(-s)"""
    x = iv.exp(-Interval.of(s))
    return 2 * iv.angle(iv.sqrt(x), iv.sqrt(1 - x)) / (iv.pi() * x)
