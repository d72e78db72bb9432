# SPDX-License-Identifier: MIT
"""The law of the load ratio as n tends to infinity, G > 2, in intervals; lemmas S and T are those of docs/certificate.md.

By units of force the ratios form a chain with one stationary law, on 0 < x < Y = 4/G^2, whose density is x^2 phi(T), T = 1 - (x/Y)^2, phi =
G W phi but for a factor, W as in distributions.py with Y for all Y_m. V is any polynomials by parts of low <= T <= 1, and 0 below. What is
proved is |G W V - V| <= error V: as the chain forgets where it began, what is read off V then differs little from what is read off phi.
"""
from fractions import Fraction

import intervals as iv
from distributions import Laws, half_power, need, need_inside, of_ratios, top
from full_contact import Trigonometry
from intervals import Interval

MOST_STEPS = 400
LARGEST_LOW = Fraction(1, 4)  # where the first part begins


class Limit(Laws):
    """Of one G: what is read off V, and how far it is from what is read off phi"""

    def __init__(self, G, bits):
        Interval.bits = self.bits = bits
        self.G, self.trig, self.Y, self.gain = G, Trigonometry(bits), 4 / G.square(), G.square() * G

    def top(self, _):
        return self.Y

    def contraction(self):
        """(S): by so much two chains come together in s a step"""
        if top(self.Y) <= Fraction(2, 3):
            return Interval.of(Fraction(1, 2))
        return (iv.angle(iv.sqrt(2), Interval.of(1)) + iv.sqrt(2)) / iv.pi()

    def leak(self, pieces):
        """(S): above the mass of G W V below the first part"""
        low = pieces[0].low
        need(low <= LARGEST_LOW)
        largest = max(top(V.largest(None) * half_power(Interval.of(V.high), V.power)) for V in pieces if V.low < 2 * low)
        return 8 * half_power(self.Y, 6) * half_power(Interval.of(low), 3) * largest / (3 * iv.pi() * half_power(1 - self.Y, 3))

    def away(self, here, error, leak, area, size, late, at_once, later):
        """(T): above |Z E_pi[f] - E_V[f]|, E_V[f] = here, for f whose differences after k >= late waves are below 2 size (contraction^(k -
        late) 9 Y)^1/2/x; below the first part f is at most `at_once`, and after a wave and more at most `later`"""
        root = iv.sqrt(self.contraction())
        far = 3 * iv.sqrt(self.Y) * (error * self.G * area / (1 - error) + 2 * leak / self.Y)
        total, best, tail = Interval.of(0), None, 2 * size * far / (1 - root)
        for k in range(MOST_STEPS):
            if k >= late:
                best = min(top(total + tail), best) if best is not None else top(total + tail)
                tail = tail * root
            step = error * here + leak * (later if k else at_once)
            total, here = total + step, here + step
        return iv.error_term(Interval.of(best))

    def claimed(self, quantity, place, pieces, error, wanted):
        """the limit of a claim, where |G W V - V| <= error V on all parts; `wanted`: the claim's error"""
        leak, fine = self.leak(pieces), wanted / 64
        G, one, error = self.G, Interval.of(1), Interval.of(error)
        area = self.read(0, "share", one, pieces, fine)
        P = G * iv.sin_pi(place).square() if quantity == "limit.segments" else Interval.of(place)
        if quantity == "limit.force":
            T = 1 - P / G / self.Y
            need_inside(T)
            above = self.read(0, "force", T, pieces, fine)
            return (above + self.away(above, error, leak, area, 1, 1, 1, 1)) / self.read(0, "force", one, pieces, fine)
        w = P.square() / 4
        T = 1 - w / self.Y
        need_inside(T)
        whole = area + self.away(area, error, leak, area, 1, 0, G, G)
        if quantity != "limit.density":
            share = self.read(0, "share", T, pieces, fine)
            return (share + self.away(share, error, leak, area, 1, 0, G, G)) / whole
        low, room = self.Y * (1 - pieces[0].low), half_power(1 - self.Y, 3)
        need((low - w).low > 0)
        size, later = (8 / (iv.pi() * room.square()) * z for z in (1 / w, iv.sqrt(w) * half_power(2 / self.Y, 3)))
        at_once = 2 * iv.sqrt(w) / (iv.pi() * room * low * iv.sqrt(low - w))
        factor = 2 * P / half_power(G, 6)
        here = factor * self.density(0, of_ratios(pieces), T, fine / top(factor))
        return (here + self.away(here, error, leak, area, size, 2, at_once, later)) / (2 * whole)
