# SPDX-License-Identifier: MIT
"""The second eigenvalue of one wave over the first, 1/G, for G > 2: theorem 8 of docs/limit.md with a function w that is data; lemma Z of
docs/certificate.md.

w is a polynomial in log s up to s_0 + high, s_0 = log(G^2/4), and constant from there on. The noise is u = tanh tau; with e = exp(-tau) q =
1 - u^2 is (2e/(1 + e^2))^2, and E[f] = (4/pi) int_0^1 8 e^2/(1 + e^2)^3 f de. With m = 1 - exp(-s) u^2 the next s is s' = (s + s_0 - log q
- log m)/2, psi = ds'/ds is 1 - 1/(2m), and beta = dpsi/ds is (1 - m)/(2m^2). Integrands are written once: of intervals they are values, of
discs bounds (U, Z).
"""
from fractions import Fraction

import intervals as iv
from distributions import Polynomial, interpolated, need, top
from intervals import Interval
from scale_one import Disc, Outside, by_gauss, largest, off_by

PLACE = Fraction(7, 10)         # sigma = s - s_0 where w is 1 and k is 0 (theorem 8)
GROWING = Fraction(1, 10000)    # of the weight W = 1 + r + 3/2 r^4 + GROWING/r, r = exp(-2 sigma)
COARSE = 64                     # bits of bounds
POWERS = 9, 6, 4, 3, 2          # rho = 2^power of the ellipses on which integrands are bounded
RHO = 4                         # of the ellipse about an interval of sigma
DISC = Fraction(RHO * RHO + 1, 2 * RHO)  # that it is in, in half widths
MOST_POINTS, MOST_PARTS, DEEPEST = 64, 1000, 14
MOST_WORK = 1 << 21             # points in all: some five times what G = 2.2 takes
BOXES, FINE = 24, 500           # of the noise's angle: on the first intervals of sigma, for tau
FIRST, HALVINGS = 16, 12        # intervals of sigma for theta; how often one is halved
APART = 4, 8, 16, 32, 64, 128   # lambda/(lambda - theta): the first that is had
SPARE = 8                       # so much less is aimed at than the defect may be: Lebesgue's constant counts too


def log(x):
    """(Z): of a disc too"""
    return Disc(iv.log(x.centre), iv.log(x.centre / x.least())) if isinstance(x, Disc) else iv.log(x)


def exp(x):
    """(Z): of a disc too"""
    if not isinstance(x, Disc):
        return iv.exp(x)
    middle = iv.exp(x.centre)
    return Disc(middle, middle * (iv.exp(x.radius) - 1))


def at(polynomial, place):
    return Disc(Interval.of(0), polynomial.bound(place.centre, place.radius)) if isinstance(place, Disc) else polynomial.value(place)


def twice_the_slope(c):
    """of sum c_k T_k: c'_(k-1) = c'_(k+1) + 2k c_k, half of c'_0"""
    d = [0] * (len(c) + 1)
    for k in range(len(c) - 1, 0, -1):
        d[k - 1] = d[k + 1] + 4 * k * c[k]
    return [d[0] // 2, *d[1:-2]]


def at_coarse_bits(bound):
    def coarsely(*arguments):
        bits, Interval.bits = Interval.bits, COARSE
        try:
            return bound(*arguments)
        finally:
            Interval.bits = bits
    return coarsely


class Integrand:
    """With the density of e: psi w(s'), or beta w(s') + psi^2 w'(s'), whose integral is the slope of that of psi w(s') by s"""

    def __init__(self, of, s, slope, w):
        self.s, self.slope, self.w, self.x, self.factor = s, slope, w, exp(-s), of(32 / iv.pi())

    def __call__(self, e):
        square = e.square()
        c = 1 / (1 + square)
        q = 4 * square * c.square()
        m = 1 - self.x + self.x * q
        half = 1 / (2 * m)
        psi, s = 1 - half, (self.s + self.w.start - log(q) - log(m)) * Fraction(1, 2)
        density, place = self.factor * square * c * c.square(), log(s)
        if not self.slope:
            return density * psi * at(self.w.value, place)
        return density * (half * (2 * half - 1) * at(self.w.value, place) + psi.square() * at(self.w.slope, place) / (s * self.w.radius))


class Eigenfunction:
    """w, or what is to be near one: what theorem 8 asks about it, lambda, delta, tau and theta"""

    def __init__(self, G, high, centre, radius, exponent, coefficients):
        self.start, self.high, self.radius, self.bits = 2 * iv.log(G / 2), high, Interval.of(radius), Interval.bits
        need(self.start.low > 0 and high > PLACE and radius > 0)
        low, end = iv.log(self.start).ends()[0], top(iv.log(self.start + high))
        need(centre - radius <= low and end <= centre + radius)
        self.derivatives = []  # by the place t, -1 <= t <= 1
        for k in range(4):
            self.derivatives.append(Polynomial(centre - radius, centre + radius, centre, radius, 0, exponent - k, coefficients))
            coefficients = twice_the_slope(coefficients)
        self.value, self.slope = self.derivatives[:2]
        self.xi, self.last = iv.exp(-self.start), self.start + high
        self.most, self.steepest = self.value.largest(None), self.slope.largest(None) / (self.start * self.radius)
        self.at_place, self.here = self.value.value(iv.log(self.start + PLACE)), integral_of_weight(iv.exp(Interval.of(-2 * PLACE)))
        need(self.at_place.low > 0)
        self.octaves, self.work = self.cut(), 0

    def derivative(self, s):
        return self.slope.value(iv.log(s)) / (s * self.radius)

    def cut(self):
        """(Z): s' <= s_0 + high if e >= 2^-octaves"""
        found = 0
        while all(self.next_below(Fraction(1, 2**(found + 1)), s) for s in (self.start, self.last)):
            found += 1
        need(0 < found)
        return found

    def next_below(self, e, s):
        q = (2 * Interval.of(e) / (1 + e**2)).square()
        return (2 * self.last - (s + self.start - iv.log(q) - iv.log(1 - iv.exp(-s) * (1 - q)))).low > 0

    def cut_off(self, slope):
        """(Z): of an integral, what e < 2^-octaves makes"""
        half = 1 / (2 * (1 - self.xi))
        psi = max(top(half - 1), Fraction(1, 2))
        mass = 32 / (3 * iv.pi()) / 8**self.octaves
        return iv.error_term(mass * (half * (2 * half - 1) * self.most + psi * psi * self.steepest if slope else psi * self.most))

    # ---- integrals over e

    @at_coarse_bits
    def rule(self, s, slope, allowed):
        """Parts of e, and how many points of Gauss each takes for all real s of the disc; how far off these are all together (V)"""
        bound, found, off = Integrand(Disc.of, s, slope, self), [], Fraction(0)
        stack = [(Fraction(1, 2**k), Fraction(2, 2**k)) for k in range(self.octaves, 0, -1)]
        while stack:
            a, b = stack.pop()
            need(len(found) < MOST_PARTS and (b - a) * 2**DEEPEST >= a)
            K, error = self.order(bound, a, b, allowed / (2 * self.octaves))
            off += error
            if K:
                found.append((a, b, K))
            else:
                stack += [((a + b) / 2, b), (a, (a + b) / 2)]
        return found, off

    def order(self, bound, a, b, allowed):
        middle, half = (a + b) / 2, (b - a) / 2
        for power in POWERS:
            try:
                M = top(bound(Disc(Interval.of(middle), Interval.of(half * Fraction(4**power + 1, 2**(power + 1))))).reach())
            except Outside:
                continue
            for K in range(2, MOST_POINTS + 1, 2):
                if off_by(half, M, power, K, self.bits) <= allowed:
                    return K, off_by(half, M, power, K, self.bits)
        return 0, 0

    def integral(self, s, slope, rule):
        """but for what is cut off, and the rule's error"""
        self.work += sum(K for *_, K in rule)
        need(self.work < MOST_WORK)
        f = Integrand(Interval.of, s, slope, self)
        return sum((by_gauss(f, *part) for part in rule), Interval.of(0))

    def ratio(self, allowed):
        """lambda = (D w)/w at the place"""
        s = self.start + PLACE
        rule, off = self.rule(Disc.of(s), False, allowed)
        return (self.integral(s, False, rule) + iv.error_term(Interval.of(off)) + self.cut_off(False)) / self.at_place

    # ---- delta: f = (D w)' - lambda w'

    def defect(self, ratio, aim, progress, most=None):
        """above |f|/W, or some number beyond `most` if that is"""
        worst, stack = top(self.defect_beyond()), [(Fraction(0), self.high)]
        while stack and (most is None or worst < most):
            a, b = stack.pop()
            progress(f"sigma from {float(a):.3f}")
            found = self.defect_on(a, b, ratio, aim)
            if found is None:
                need((b - a) * 2**DEEPEST > self.high)
                stack += [((a + b) / 2, b), (a, (a + b) / 2)]
            else:
                worst = max(worst, found)
        return worst

    def defect_beyond(self):
        """(Z): from s_0 + high on"""
        x, rho = self.far_out()
        return (2 * x * self.most + self.steepest / 4) * rho.square() / GROWING

    def far_out(self):
        """x and exp(-sigma); x < exp(-PLACE) < 1/2"""
        rho = iv.exp(-Interval.of(self.high))
        return self.xi * rho, rho

    def defect_on(self, a, b, ratio, aim):
        """above |f|/W from a to b; None if more points would be needed than are taken"""
        middle, half, W = (a + b) / 2, (b - a) / 2, least_weight(a, b)
        try:
            size = self.size_of_defect(Disc(self.start + middle, Interval.of(half * DISC)), ratio)
            if size <= aim * W:
                return size / W
            count = next((n for n in range(4, MOST_POINTS) if interpolated([Interval.of(0)] * n, size, RHO) <= aim * W), 0)
            if not count:
                return None
            rule, off = self.rule(Disc(self.start + middle, Interval.of(half)), True, aim * W / 4)
        except Outside:
            return None
        off, values = iv.error_term(Interval.of(off)) + self.cut_off(True), []
        for j in range(count):
            s = self.start + middle + half * iv.sin_pi(Fraction(2 * j + 1 - count, 2 * count))
            values.append(self.integral(s, True, rule) - ratio * self.derivative(s) + off)
        return interpolated(values, size, RHO) / W

    @at_coarse_bits
    def size_of_defect(self, s, ratio):
        """above |f| on the disc"""
        bound, total = Integrand(Disc.of, s, True, self), Interval.of(0)
        stack = [(Fraction(1, 2**k), Fraction(2, 2**k), 0) for k in range(self.octaves, 0, -1)]
        while stack:
            a, b, depth = stack.pop()
            try:
                total = total + bound(Disc(Interval.of((a + b) / 2), Interval.of((b - a) / 2))).reach() * (b - a)
            except Outside:
                if depth == DEEPEST:
                    raise
                stack += [(a, (a + b) / 2, depth + 1), ((a + b) / 2, b, depth + 1)]
        return top(total + self.cut_off(True) + largest(ratio) * (at(self.slope, log(s)) / (s * self.radius)).reach())

    # ---- tau and theta: boxes of the noise's angle phi, u = sin phi, E[f] = (4/pi) int cos^2(phi) f dphi

    @at_coarse_bits
    def row(self, a, b, boxes):
        """(Z): above E[|psi| |V - V(place)|] and E[psi^2 W] + E[beta |V - V(place)|] at s' for all sigma from a to b"""
        rho = iv.hull(iv.exp(Interval.of(-b)), iv.exp(Interval.of(-a)))
        x, coupling, remainder, edge = self.xi * rho, Interval.of(0), Interval.of(0), Interval.of(0)
        for j in range(1, boxes + 1):
            before, edge = edge, iv.sin_pi(Fraction(j, 2 * boxes)).square()
            square = iv.hull(before, edge)
            cosine = 1 - square if j < boxes else iv.hull(Interval.of(0), 1 - before)
            m = 1 - x * square
            half, r, growing = 1 / (2 * m), rho * cosine * m, GROWING / (rho * m)  # cos^2/r = 1/(rho m)
            psi, beta = 1 - half, half * (2 * half - 1)
            if j < boxes:
                apart = cosine * largest(integral_of_weight(r) - self.here)
            else:
                apart = iv.sqrt(cosine / (rho * m)) + cosine * (1 + largest(self.here)) + growing.scaled(-1)
            coupling = coupling + largest(psi) * largest(apart)
            remainder = remainder + psi.square() * (cosine * (1 + r + 3 * r.square().square() / 2) + growing)
            remainder = remainder + largest(beta) * largest(apart)
        return top(coupling * 2 / boxes), top(remainder * 2 / boxes)

    def remainder_is_below(self, goal, coupling, progress):
        """is theta <= goal?"""
        if top(self.remainder_beyond()) > goal:
            return False
        stack = [(self.high * k / FIRST, self.high * (k + 1) / FIRST, 0) for k in range(FIRST - 1, -1, -1)]
        while stack:
            a, b, depth = stack.pop()
            progress(f"sigma from {float(a):.3f}")
            if self.row(a, b, BOXES << (depth + 1) // 2)[1] + coupling * self.steepness(a, b) > goal * least_weight(a, b):
                if depth == HALVINGS:
                    return False
                stack += [((a + b) / 2, b, depth + 1), (a, (a + b) / 2, depth + 1)]
        return True

    def remainder_beyond(self):
        """(Z): from s_0 + high on"""
        x, rho = self.far_out()
        y = rho * (1 - x)
        of_psi = (Fraction(7, 2) + 2 * GROWING / y) / 4
        of_beta = 2 * x * (largest(self.here) + 1 + 4 / (iv.pi() * iv.sqrt(y)) + GROWING / y)
        return (of_psi + of_beta) * rho.square() / GROWING

    def steepness(self, a, b):
        """above |w'|/w(place) from a to b, by Taylor's formula"""
        place = iv.hull(iv.log(self.start + a), iv.log(self.start + b))
        middle = Interval.of(place.middle())
        off = largest(place - middle) / self.radius
        first, second = (largest(p.value(middle)) for p in self.derivatives[1:3])
        slope = first + off * second + off.square() / 2 * self.derivatives[3].largest(None)
        return top(slope / ((self.start + a) * self.radius * self.at_place))

    # ---- theorem 8

    def is_within(self, value, error, progress):
        """is the second eigenvalue so near to the value?"""
        ratio = self.ratio(error / 16)
        room, coupling, least = error - top(largest(ratio - value)), self.row(PLACE, PLACE, FINE)[0], ratio.ends()[0]
        if min(room, least) <= 0:
            return False
        apart = next((least / n for n in APART if self.remainder_is_below(least - least / n, coupling, progress)), 0)
        allowed = min(room * apart, apart**2 / 2) / (3 * coupling) * self.at_place.ends()[0]  # eta <= room, and < apart/2
        return allowed > 0 and self.defect(self.ratio(allowed / SPARE**2), allowed / SPARE, progress, allowed) < allowed


def integral_of_weight(r):
    """V, which falls with r"""
    return GROWING / (2 * r) - (iv.log(r) + r).scaled(-1) - 3 * r.square().square() / 16


def least_weight(a, b):
    """below W from a to b: r falls"""
    less, more = (iv.exp(Interval.of(-2 * x)) for x in (b, a))
    return (1 + less + 3 * less.square().square() / 2 + GROWING / more).ends()[0]
