# SPDX-License-Identifier: MIT
"""The recursion (6.1)-(6.7) at any load and any G > 1, full contact included, in integers; lemmas G-L are those of docs/certificate.md.

B_m(x) = A_m at load x, B_(m+1) = T B_m, (T f)(x) = (1/pi) int f(y) dtheta over 0 < theta < pi, c = cos theta,
    y^2 = z(c) = ((x + c)/G)^2 where x >= 1,   z(c) = (1 + c)(2 x - 1 + c)/G^2 where x < 1, and f counts as 0 where that is negative.
V_m are polynomials of z = y^2 on panels of y, any; what is proved, on intervals J of x that this program chooses, is
D_m >= |V_m - T V_(m-1)|, D_0 >= |V_0 - B_0|. As T is positive, |B_m - V_m| <= e_m = D_m + T e_(m-1) (G), a step function on cells (H).

Fixed point: an integer stands for that many units 2^-bits. Bounds are fractions or integers rounded up.
"""
from bisect import bisect_left, bisect_right
from fractions import Fraction
from functools import lru_cache
from itertools import accumulate
from math import factorial, isqrt
from operator import mul, sub

import intervals as iv
from intervals import Interval
from transfer import Refused, chebyshev, fixed

RHO = 4                     # the ellipses on which the defects are bounded: their half axis is REACH half widths
REACH = Fraction(17, 8)     # (RHO + 1/RHO)/2
MOST_POINTS = 48            # on one interval J
MOST_INTERVALS = 4000       # of one panel
CONTINUED = 8               # a polynomial that is continued is at most 2^CONTINUED times sum |c_k|
HIGHEST = 1 << 16           # ratios: cos theta at an edge y is known within some y units, and (L) counts 2^8 roots of a unit for that
BEYOND = 14                 # a panel is within middle +- half but for 2^-BEYOND half, so that |T_k| <= 2 there, k < 64
SPARE_BITS = 24             # of a lane: sums of a row are that much larger than the largest coefficient at most, else the line is refused
FAR = (4, 7, 12)            # powers rho = 2^FAR of larger ellipses: what panels far from the ends of a wave give needs fewer points
WORK = 46                   # bits of Chebyshev's polynomials beyond the accuracy: 14 for MOST_NODES, 12 for terms^2, 8 for CONTINUED
MOST_NODES = 1 << 14        # in a row
SMALL = 4                   # bits: a bound so far above what is wanted has no cell of its own
FINE = 16                   # cells are no wider than 1/FINE of the ratio; below 2^-FINE they are as they come
MOST_PARTS = 64             # of one cell
NARROW = 64                 # cells of which a wave has at most 1/NARROW are narrow
DEEP = 80                   # bits more of 1/G^2, G < 2^40: it is multiplied by (1 + load)^2, a G^2-fold of the highest z
MOST_OF_A_RULE = 32         # points, of a piece of theta
RULE_POWER = 3              # log2 of the ellipses on which rules are bounded: their half axis is RULE_REACH half pieces
RULE_REACH = Fraction(65, 16)
WIDEST = 5                  # pieces of theta are at most 1/WIDEST wide, each side


QUARTERS = [isqrt(isqrt(1 << 128 + j)) for j in range(25)]  # 2^(j/4), below, in units 2^-32


class Far(Exception):
    """A polynomial is needed too far from its panel; `cuts` says where an interval is cut that is too wide, if not in the middle."""
    cuts = ()


@lru_cache(maxsize=4)
class Trigonometry:
    """cos, sin and the angle, within some ten units 2^-bits."""

    def __init__(self, bits):
        self.bits, self.one, Interval.bits = bits, 1 << bits, bits + 64
        self.pi = fixed(iv.pi(), bits)
        self.arctan = [fixed(iv.arctan(Interval.of(Fraction(i, 64))), bits) for i in range(65)]
        self.of_pieces = [tuple(fixed(iv.sin_pi(Fraction(k, 96)), bits) for k in (48 + i, i)) for i in range(97)]
        f = [self.one // factorial(k) for k in range(bits + 4)]  # the sine's terms by the bits of a^2, up to where a^k/k! is below a unit
        self.sines = [[f[k + 3] for k in range(bits & -2, -2, -2) if f[k] >> max(4, bits - b) * k // 2] for b in range(bits + 1)]
        self.gauss = lru_cache(maxsize=None)(self.gauss)

    def small(self, a):
        """cos a, sin a, |a| <= 1/4"""
        bits, square, s = self.bits, a * a >> self.bits, 0
        for term in self.sines[square.bit_length()]:  # by Horner's rule
            s = term - (square * s >> bits)
        s = a - (a * (square * s >> bits) >> bits)
        return isqrt((1 << 2 * bits) - s * s), s  # off by no more than s is, and a unit, as the tangent is below 1

    def cos_sin(self, a):
        """0 <= a <= pi"""
        bits = self.bits
        i = 96 * a // self.pi
        C, S = self.of_pieces[i]
        c, s = self.small(a - i * self.pi // 96)
        return (C * c - S * s) >> bits, (S * c + C * s) >> bits

    def angle(self, y, x):
        """of the point (x, y), x >= 0, y >= 0, not both 0"""
        bits = self.bits
        if y > x:
            return (self.pi >> 1) - self.angle(x, y)
        i = (y << 6) // x
        u = ((64 * y - i * x) << bits) // (64 * x + i * y)  # tan(a - b), tan b = i/64
        square, term, total, k = u * u >> bits, u, u, 1
        while abs(term) >= k:
            term, k = -(term * square >> bits), k + 2
            total += term // k
        return self.arctan[i] + total

    def of_cosine(self, less, more):
        """arccos c from 1 - c and 1 + c in units; 0 <= c <= pi whatever they are"""
        return 2 * self.angle(*(isqrt(max(0, side) << self.bits) for side in (less, more)))

    def gauss(self, K):
        """(I): points 0 < t < 1 and weights, symmetric, that integrate polynomials of degree < 2K; found by Newton's method, and tried on
        Chebyshev's polynomials"""
        bits, pairs = self.bits, []
        for j in range(K // 2):
            t = self.cos_sin(self.pi * (4 * j + 3) // (4 * K + 2))[0]
            for _ in range(8):
                p, q = self.one, t
                for k in range(2, K + 1):
                    p, q = q, ((2 * k - 1) * (t * q >> bits) - (k - 1) * p) // k
                slope = (K * (p - (t * q >> bits)) << bits) // (self.one - (t * t >> bits))
                t -= (q << bits) // slope
            w = (2 << 3 * bits) // ((self.one - (t * t >> bits)) * slope * slope >> bits)
            pairs.append((t, w))
        moments = map(sum, zip(*(chebyshev(t, 2 * w, 2 * K, bits) for t, w in pairs)))
        for i, total in enumerate(moments):
            if i % 2 == 0 and abs(total * (1 - i * i) - (2 << bits)) > 64 * K * (i * i + 1) ** 2:
                raise Refused("a rule of Gauss does not integrate what it should")
        return pairs


def quarters(A):
    """a number of quarters of log2, rho <= 2^(quarters/4), for rho + 1/rho = 2 A, A in units 2^-32: |T_k| <= rho^k on that ellipse"""
    j = bisect_left(QUARTERS, A + isqrt(max(0, A * A - (1 << 64))) + 2)
    if j == len(QUARTERS):
        raise Far
    return j


def axis(t, d):
    """half the sum of the distances from -1 and 1, for points so far (d) from a real one of modulus t, in units 2^-32"""
    return min(max(1 << 32, t) + d, isqrt((1 << 64) + (t + d) ** 2) + 1)


def jumps(e):
    return [b - a for a, b in zip([0, *e], e)]


@lru_cache(maxsize=None)
def lebesgue(count):
    """of Chebyshev's points, a hundredth more for that they are rounded"""
    return Fraction(101, 100) * (1 + Fraction(9, 20) * count.bit_length())


class Mesh:
    """V_0 ... V_(levels-1) on panels edges[p] <= y <= edges[p+1]: 2^lift[m] V_m = sum c_k T_k((y^2 - middle)/half), lift[m] = m rise/16
    rounded down, the c_k in units 2^-kept. All values and bounds of a level are those of 2^lift V, so that late levels, small as G^-m, are
    as accurate as the first. It serves loads up to `load`. What is aimed at: defects of 2^-aims[p] on a panel, no less than 2^-accuracy."""

    def __init__(self, G, pressure, load, bits, edges, places, aims, series, kept, accuracy, rise):
        self.trig = Trigonometry(bits)
        self.bits, self.one, self.kept, self.accuracy, self.aims, self.holes = bits, 1 << bits, kept, accuracy, aims, []
        self.work = min(bits, accuracy + WORK)  # a polynomial needs fewer bits than the root at an end of a wave
        self.unit = 1 << self.work + kept
        self.cosines, self.weights = (lru_cache(maxsize=None)(f) for f in (self.cosines, self.weights))
        self.edges, self.places, self.series = edges, places, series
        self.levels, self.terms = len(series[0]), len(series[0][0])
        self.lift = [m * rise // 16 for m in range(self.levels)]
        self.up = [b - a for a, b in zip(self.lift, self.lift[1:])]
        Interval.bits, self.deep = bits + 128, bits + DEEP
        self.G, self.inverse, self.P = fixed(G, bits), fixed(1 / G.square(), self.deep), fixed(Interval.of(pressure), bits)
        if not 0 < edges[0] or sorted({*edges}) != [*edges] or edges[-1] > HIGHEST * self.one or any(half <= 0 for _, half in places):
            raise Refused("not a mesh")
        most = (1 << self.work) + (1 << self.work >> BEYOND)
        if any(abs(self.local(p, y * y >> bits)) > most for p in range(len(places)) for y in edges[p:p + 2]):
            raise Refused("a polynomial is of another panel")
        self.farthest = []  # up to which panel a level matters
        for _ in range(self.levels):
            x = max([-(-load * self.one // 1), *(edges[p] for p in self.farthest[:1])])
            p = bisect_left(edges, self.most(x) + (x >> bits) + 4)
            if p == len(edges):
                raise Refused("ratios leave the mesh")
            self.farthest.insert(0, max(p, 1))
        # The levels side by side in one integer, so that one product serves all of them (Kronecker's substitution).
        self.sizes = [[max(map(abs, c)) for c in zip(*of_panel)] for of_panel in series]
        self.lane = self.work + max(map(max, self.sizes)).bit_length() + SPARE_BITS
        self.packed = [[sum(c[k] << m * self.lane for m, c in enumerate(of_panel)) for k in range(self.terms)] for of_panel in series]
        self.lg = [[self.log_growth(p, j) for j in range(len(QUARTERS))] for p in range(len(series))]
        self.largest = max(lg[0] for lg in self.lg)
        self.round = self.rounding()
        self.quadrature = Fraction(1, 2 ** (accuracy + 6))

    def log_growth(self, p, j):
        """log2, above, of sum |c_k| 2^(k j/4), the largest of all levels"""
        powers = [((QUARTERS[j] + 1) ** k >> 32 * k) + 1 for k in range(self.terms)]
        return max(sum(map(mul, map(abs, c), powers)) for c in self.series[p]).bit_length() - self.kept

    def rounding(self):
        """(L): of V where it is evaluated, in one row, and of the ends of pieces"""
        wide = (self.edges[-1] >> self.bits) + 2
        slope = max(Fraction(2) ** lg[0] * (64 * wide * wide + 1) / half for lg, (_, half) in zip(self.lg, self.places))
        floors = Fraction(2) ** (max(0, self.largest) - self.work) * MOST_NODES
        ends = Fraction(len(self.series) + 2, 2 ** (self.bits // 2 - 8)) * 2**max(0, self.largest)
        return (4 * slope + floors) * self.terms**2 * 2**CONTINUED + ends

    def panel(self, y):
        """the panel of y, -1 below the first"""
        return min(bisect_right(self.edges, y), len(self.edges) - 1) - 1

    def local(self, p, z):
        middle, half = self.places[p]
        return ((z - middle) << self.work) // half

    def values(self, p, z):
        """V_m there, all m, in units 2^-(work + kept)"""
        T = chebyshev(self.local(p, z), 1 << self.work, self.terms, self.work)
        return [sum(map(mul, c, T)) for c in self.series[p]] if p >= 0 else [0] * self.levels

    # ---- T V at a point

    def theta(self, x, y):
        """where the wave of mean x has the ratio y"""
        Gy = self.G * y >> self.bits
        c = Gy - x if x >= self.one else isqrt(Gy * Gy + (self.one - x) ** 2) - x
        return self.trig.of_cosine(self.one - c, self.one + c)

    def least(self, x):
        return ((x - self.one) << self.bits) // self.G if x > self.one else 0

    def most(self, x):
        return ((x + self.one) << self.bits) // self.G if x >= self.one else (2 * isqrt(x << self.bits) << self.bits) // self.G

    def row(self, x, low, high, aim, panels=None):
        """T V_m at x, all m, in units 2^-(work + kept), with the polynomials of the panels low and high continued to the ends of the wave;
        low = -1: 0 there. Off by 2^-(aim + 6) beside roundings. If panels are named: what these give of it"""
        total = most = self.nodes = 0
        before = None
        for p in range(max(low, 0), high + 1) if panels is None else panels:
            if before != p - 1:
                a = self.trig.pi if x >= self.one and p == low else self.theta(x, self.edges[p])
            before, b = p, self.theta(x, self.edges[p + 1]) if p < high else 0
            if b < a:
                here, size = self.integral(p, self.rule(x, p, b, a, aim, len(self.series)))
                total, most, a = total + here, most + size, b
        if most >> self.lane - 1:
            raise Refused("the sums of a row are too large")
        return [(t << self.bits) // self.trig.pi for t in self.unpacked(total)]

    def unpacked(self, total):
        """sum t_m 2^(m lane), |t_m| < 2^(lane - 1)"""
        lane, half = self.lane, 1 << self.lane - 1
        total += sum(half << m * lane for m in range(self.levels))
        return [(total >> m * lane & 2 * half - 1) - half for m in range(self.levels)]

    def exact_row(self, x):
        low = self.panel(self.least(x)) if x > self.one else -1
        return self.row(x, low, self.panel(self.most(x)), self.accuracy)

    def integral(self, p, rule):
        """of V_m, all m, packed; and a bound of each"""
        sums = list(map(sum, zip(*(chebyshev(at, weight, self.terms, self.work) for at, weight in rule))))
        return sum(map(mul, self.packed[p], sums)), sum(map(mul, self.sizes[p], map(abs, sums)))

    def rule(self, x, p, a, b, aim, parts):
        """places on the panel and weights, in units 2^-work, for the integral over a <= theta <= b, one of so many parts of a wave"""
        bits, one, trig, (middle, half), work = self.bits, self.one, self.trig, self.places[p], self.work
        eta, at = (b - a) >> 1, (a + b) >> 1
        K = MOST_OF_A_RULE + 1
        if eta * WIDEST <= one:
            cosine_at, sine_at = trig.cos_sin(at)
            K = self.order(x, p, eta, cosine_at, sine_at, aim, parts)
        if K > MOST_OF_A_RULE:
            if eta < one >> 40:
                raise Refused("a panel's polynomial grows too fast")
            return self.rule(x, p, a, at, aim, 2 * parts) + self.rule(x, p, at, b, aim, 2 * parts)
        full, inverse, deep, places = x >= one, self.inverse, self.deep, []
        self.nodes += K
        if self.nodes > MOST_NODES:
            raise Refused("a row has too many points")
        for t, w in trig.gauss(K):
            ct, st = trig.small(eta * t >> bits)
            wide = eta * w >> 2 * bits - work
            even, odd = cosine_at * ct, sine_at * st
            for c in ((even - odd) >> bits, (even + odd) >> bits):
                square = (x + c) ** 2 if full else (one + c) * (2 * x - one + c)
                places.append(((((square >> bits) * inverse >> deep) - middle << work) // half, wide))
        return places

    def order(self, x, p, eta, cosine_at, sine_at, aim, parts):
        """(I): a number of points, an even one, with which Gauss's rule is good enough on one of so many parts; by
        |cos(t + d) - cos t| <= |cos t| (cosh |d| - 1) + sin t sinh |d|"""
        one, middle, half = self.one, *self.places[p]
        square = (x + cosine_at) ** 2 if x >= one else (one + cosine_at) * (2 * x - one + cosine_at)
        z = (square >> self.bits) * self.inverse >> self.deep
        slope = 2 * abs(x + cosine_at) * self.inverse >> self.deep
        accuracy = aim + 8 - max(0, (one // (2 * eta * parts + 1)).bit_length() - 1)
        d = eta * RULE_REACH.numerator // RULE_REACH.denominator + 1  # below 1, as eta is at most 1/WIDEST
        square = d * d >> self.bits
        k = abs(cosine_at) * square // (2 * one - square // 6) + sine_at * d // (one - square // 6) + 2
        off = (slope * k >> self.bits) + ((k * k >> self.bits) * self.inverse >> self.deep) + 2
        try:
            j = quarters(axis((abs(z - middle) << 32) // half + 1, (off << 32) // half + 1))
        except Far:
            return MOST_OF_A_RULE + 1
        K = -(-(self.lg[p][j] + accuracy) // (2 * RULE_POWER))
        return max(2, K + (K & 1))

    # ---- the defects

    def chebyshev_points(self, a, b, count):
        """of a <= x <= b"""
        return [(a + b >> 1) + ((b - a) * t >> self.bits + 1) for t in self.cosines(count)]

    def cosines(self, count):
        return [self.trig.cos_sin(self.trig.pi * (2 * j + 1) // (2 * count))[0] for j in range(count)]

    def furthest(self, p, a, b, others):
        """|V_m - W_m| on a <= y <= b in the panel p, for each polynomial W_m whose values others(z) gives, m = 0, 1 ...: fractions"""
        worst = [0] * self.levels
        for z in self.chebyshev_points(a * a >> self.bits, b * b >> self.bits, self.terms):
            here = self.values(p, z)
            for other in others(z):
                worst = [max(w, abs(u - v)) for w, u, v in zip(worst, here, other)]
        return [lebesgue(self.terms) * (Fraction(w, self.unit) + 2 * self.round) for w in worst]

    def interpolation(self, log_size, wanted):
        """(K): with how many points a function that is below 2^log_size on the ellipse is bounded, and what that leaves open"""
        count = max(3, -(-(log_size - wanted + 3) // 2) + 1)
        if count > MOST_POINTS:
            raise Far
        return count, (1 + lebesgue(count)) * 2 * Fraction(2) ** (log_size - 2 * (count - 1)) / 3

    def mismatch(self, low, high, x1, x2):
        """(J): what T V and its continuation differ by on J, at most"""
        off = [Fraction(0)] * self.levels
        pieces = []
        top = self.most(x2) + 1
        for q in range(high + 1, self.panel(top) + 1):
            pieces.append((high, q, self.edges[q], min(top, self.edges[q + 1])))
        if x1 >= self.one:
            bottom = self.least(x1)
            for q in range(self.panel(bottom), low):
                pieces.append((low, q, max(bottom, self.edges[q] if q >= 0 else 0), self.edges[q + 1]))
        if len(pieces) > 8:
            raise Far
        for p, q, a, b in pieces:
            if a < b:
                share = min(1, Fraction(isqrt((self.G * (b - a) >> 1) + 1) + 1, self.one))  # (H): above what a wave has of these ratios
                for m, d in enumerate(self.furthest(p, a, b, lambda z: [self.values(q, z)])):  # noqa: B023
                    off[m] += d * share
        return off

    def continued(self, p, y1, y2, moved):
        """log2 of the bound of the polynomials of p near y1 <= y <= y2, z moved by so much"""
        if p < 0:
            return -self.kept
        t = max(abs(self.local(p, y * y >> self.bits)) for y in (y1, y2))
        size = self.lg[p][quarters(axis((t >> self.work - 32) + 1, (moved << 32) // self.places[p][1] + 1))]
        if size > self.lg[p][0] + CONTINUED:
            raise Far
        return size

    def inner(self, x1, x2, r):
        """(J): the ratios y_e at both ends, for the disc r about the middle of [x1, x2]"""
        one, bits, at = self.one, self.bits, x1 + x2 >> 1
        if x1 >= one:
            g = r * 100 // 78 + 1
            if g > one:
                raise Far
            return ((at - one + g) << bits) // self.G + 1, ((one + at - g) << bits) // self.G
        g = 3 * r + 1  # 2.36/0.79 < 3
        if g > one or r * 100 > 24 * (one - at) or g >= 2 * at:
            raise Far
        z = ((2 * one - g) * (2 * at - g) >> bits) * self.inverse >> self.deep
        return 0, isqrt(z << bits)

    def shells(self, x1, x2, low, high):
        """(J), (K): powers and panels: of the ellipse 2^power about [x1, x2] these are far enough from the ends of the wave"""
        h, power, outer, found = (x2 - x1 >> 1) + 1, 2, range(max(low, 0), high + 1), []
        for larger in FAR:
            try:
                y_low, y_high = self.inner(x1, x2, (h * (4**larger + 1) >> larger + 1) + 1)
            except Far:
                break
            inner = range(max(outer.start, self.panel(y_low) + 1), min(outer.stop, self.panel(y_high)))
            if not inner:
                break
            found.append((power, [p for p in outer if p not in inner]))
            power, outer = larger, inner
        return [*found, (power, list(outer))]

    def weights(self, count, more):
        """of the interpolation from so many Chebyshev points to more of them: (1 + 2 sum T_k(t_i) T_k(t_j))/count"""
        T, S = ([chebyshev(t, self.one, count, self.bits) for t in self.cosines(c)] for c in (count, more))
        return [[((sum(map(mul, t, s)) >> self.bits - 1) - self.one) // count for t in T] for s in S]

    def disc(self, p, x1, x2):
        """(J), (K): the panels low, high that are continued, log2 of the bound on the disc"""
        bits, G = self.bits, self.G
        at, h = x1 + x2 >> 1, (x2 - x1 >> 1) + 1
        r = h * REACH.numerator // REACH.denominator + 1
        y_low, y_high = self.inner(x1, x2, r)
        if x1 >= self.one:
            moved = 2 * self.most(at) * r // G + (r * r << bits) // (G * G) + 4
            low = self.panel(y_low)
            if low > self.panel(y_high):  # g = 1, and an edge where rounding puts one end beyond the other: there is no W
                raise Far
            size = [self.continued(low, self.least(at), y_low, 2 * y_low * r // G + (r * r << bits) // (G * G) + 4)]
        else:
            if y_high < self.edges[0]:
                raise Far
            moved = ((9 * r + (3 * r * (2 * at + 5 * r) >> bits)) * self.inverse >> self.deep) + 4
            low, size = -1, [-self.kept]
        high = self.panel(y_high)
        size.append(self.continued(high, y_high, self.most(at), moved))
        size.append(self.continued(p, at, at, (2 * at * r + r * r >> bits) + 1))
        return low, high, max([self.largest, *size]) + 4  # 5 sup|V| + 2 A + 2 A + A <= 10 times the largest

    def fewer(self, size, wanted, power):
        """(K): how many points are enough for what is below 2^size on the ellipse 2^power"""
        return max(3, -(-(size - wanted + 6) // power) + 1)

    def wave(self, x1, x2, low, high, count, wanted, but=range(0)):
        """(K): T V_m, all m, at so many points of J = [x1, x2], in units 2^-(work + kept), but for what some panels give, and how far off:
        what panels far from the ends of the wave give is interpolated from fewer points"""
        (_, near), *shells = [(power, [p for p in panels if p not in but]) for power, panels in self.shells(x1, x2, low, high)]
        rows = [self.row(x, low, high, -wanted, near) for x in self.chebyshev_points(x1, x2, count)]
        one = self.round + Fraction(2) ** (wanted - 6)
        each, beyond = one, Fraction(0)
        for power, panels in shells:
            size = self.largest + 3  # 5 sup |V|
            fewer = self.fewer(size + max(self.up, default=0), wanted, power)
            levels = list(zip(*(self.row(x, low, high, -wanted, panels) for x in self.chebyshev_points(x1, x2, fewer))))
            for row, weights in zip(rows, self.weights(fewer, count)):
                row[:] = [a + (sum(map(mul, weights, level)) >> self.bits) for a, level in zip(row, levels)]
            each += lebesgue(fewer) * one
            beyond += (1 + lebesgue(fewer)) * 2 * Fraction(2) ** (size - power * (fewer - 1)) / (2**power - 1)
        return rows, each + beyond

    def on_interval(self, p, x1, x2, wanted, levels):
        """(K): |V_m - T V_(m-1)| on J = [x1, x2] in the panel p, 0 < m < levels: fractions. wanted: log2"""
        low, high, log_size = self.disc(p, x1, x2)
        count, beyond = self.interpolation(log_size + max(self.up, default=0), wanted)
        ups = self.up[:levels - 1]
        off = [o * 2**up for o, up in zip(self.mismatch(low, high, x1, x2), ups)]
        if max(off) > Fraction(2) ** wanted:
            raise Far
        rows, off_by = self.wave(x1, x2, low, high, count, wanted)
        worst = [0] * len(ups)
        for x, row in zip(self.chebyshev_points(x1, x2, count), rows):
            here = self.values(p, x * x >> self.bits)
            worst = [max(w, abs((t << up) - v)) for w, t, up, v in zip(worst, row, ups, here[1:])]
        return [lebesgue(count) * (Fraction(w, self.unit) + self.round + off_by * 2**up) + beyond + o for w, o, up in zip(worst, off, ups)]

    def moved(self, h):
        """(W): above what T V changes by on one side of 1 if the load does by so many units"""
        return Fraction(isqrt(32 * h << self.bits) + 1, self.one) * Fraction(2) ** (self.largest + 1)

    def between(self, p, x1, x2):
        """|V_m - v| for any v between T V_(m-1)(x1) and T V_(m-1)(x2), m = 1 ... levels: with (G) and monotony a bound of |V_m - B_m|"""
        self.holes.append((x1, x2))
        ends = [[0, *(v << up for v, up in zip(self.exact_row(x), self.up))] for x in (x1, x2)]
        of_levels = self.furthest(p, x1, x2, lambda z: ends)[1:]
        return [d + (self.quadrature + self.round) * 2**up for d, up in zip(of_levels, self.up)]

    def cover(self, p, bound, hole, wanted, too_wide):
        """bound(x1, x2) on intervals that cover the panel, cut at 1, or hole(x1, x2) on one that is not too wide for that. Returns (x1, x2,
        bounds), ascending; neighbours that have what is wanted are put together"""
        a, b = self.edges[p], self.edges[p + 1]
        stack, found = [(self.one, b), (a, self.one)] if a < self.one < b else [(a, b)], []
        for _ in range(MOST_INTERVALS):
            if not stack:
                return found
            a, b = stack.pop()
            if b - a < 1 << self.bits // 2:
                raise Refused("a panel is too narrow")  # for the rounding of points on it
            try:
                here = bound(a, b)
            except Far as why:
                if too_wide(a, b):
                    cuts = [a, *(why.cuts or [a + b >> 1]), b]
                    stack += reversed(list(zip(cuts, cuts[1:])))
                    continue
                here = hole(a, b)
            small = max(here) <= Fraction(2) ** (wanted + SMALL)
            if found and small and found[-1][3]:
                a, here = found[-1][0], list(map(max, here, found.pop()[2]))
            found.append((a, b, here, small))
        raise Refused("the polynomials of a panel are no approximations")

    def rises(self, p, a, b, levels):
        """whether V_m, m < levels, tells of the ends of an interval that may still be halved: how far it does is what a hole would leave"""
        rises = map(sub, *(self.values(p, y * y >> self.bits)[:levels] for y in (b, a)))
        return b - a > self.one >> self.accuracy and max(map(abs, rises)) > Fraction(2) ** -self.aims[p] * self.unit

    def first_wave(self, x):
        """B_0, the share of one wave above the pressure P, in units 2^-work"""
        w = self.P - x if x >= self.one else isqrt((self.one - x) ** 2 + self.P**2) - x
        return (self.trig.of_cosine(self.one - w, self.one + w) << self.work) // self.trig.pi

    def first_disc(self, at, x1, x2):
        """(M): 0 where B_0 is 0 or 1 on [x1, x2]; else a radius about `at`, below which it is analytic"""
        one, P = self.one, self.P
        below, above = (P - one, P + one) if x1 >= one else (P * P >> self.bits + 2, self.one)
        if x2 <= below or x1 >= above:
            return 0
        beyond = above - at if x1 >= one or not P else isqrt((one - at) ** 2 + P * P)
        return max(1, 99 * min(at - below, beyond) // 100)

    def first_on(self, p, x1, x2, wanted):
        """(M): |V_0 - B_0| on [x1, x2]"""
        at, h = x1 + x2 >> 1, (x2 - x1 >> 1) + 1
        r, radius = h * REACH.numerator // REACH.denominator + 1, self.first_disc(at, x1, x2)
        if not radius:
            return self.first_between(p, x1, x2)
        if r > radius:
            raise Far
        large = 2 + ((self.P + 4 * at >> self.bits) + 2).bit_length() // 4  # |arccos w|/pi <= 1 + log(2|w| + 1)/pi, |w| <= 1 + 2|x| + P
        log_size = max(large.bit_length(), self.continued(p, at, at, (2 * at * r + r * r >> self.bits) + 1)) + 1
        count, beyond = self.interpolation(log_size, wanted)
        worst = max(abs(self.values(p, x * x >> self.bits)[0] - (self.first_wave(x) << self.kept))
                    for x in self.chebyshev_points(x1, x2, count))
        return [lebesgue(count) * (Fraction(worst, self.unit) + 2 * self.round) + beyond]

    def first_between(self, p, x1, x2):
        """|V_0 - v| for any v between B_0(x1) and B_0(x2)"""
        ends = [[self.first_wave(x) << self.kept] for x in (x1, x2)]
        return self.furthest(p, x1, x2, lambda z: ends)

    def defects(self, progress=lambda done: None):
        """(G): of each level, D_m on intervals, ascending"""
        first = [(0, self.edges[0], self.first_between(-1, 0, self.edges[0]))]
        later = [(0, self.edges[0], self.between(-1, 0, self.edges[0]))] if self.levels > 1 else []
        for p in range(self.farthest[0]):
            progress(f"panel {p + 1} of {self.farthest[0]}")
            wanted, levels = -self.aims[p], sum(p < farthest for farthest in self.farthest)
            first += self.cover(p, lambda a, b: self.first_on(p, a, b, wanted), lambda a, b: self.first_between(p, a, b),  # noqa: B023
                                wanted, lambda a, b: self.rises(p, a, b, 1))  # noqa: B023
            if levels > 1:
                later += self.cover(p, lambda a, b: self.on_interval(p, a, b, wanted, levels),  # noqa: B023
                                    lambda a, b: self.between(p, a, b)[:levels - 1], wanted,  # noqa: B023
                                    lambda a, b: self.rises(p, a, b, levels))  # noqa: B023
        return first, later

    def errors(self, progress=lambda done: None):
        """(G), (H): the ends of cells and e_m >= |B_m - V_m| on each, all m, in units 2^-bits"""
        first, later = self.defects(progress)
        ends = sorted({y for a, b, *_ in first + later for y in (a, b)})
        for a, b in zip(ends[:], ends[1:]):  # a step function is larger than what it is above by as much as that rises on a cell
            parts = min(MOST_PARTS, 1 + FINE * (b - a) // max(a, self.one >> FINE))
            ends += [a + (b - a) * i // parts for i in range(1, parts)]
        ends.sort()
        defects = [[None] * (len(ends) - 1) for _ in range(self.levels)]  # where a level does not matter
        for start, parts in ((0, first), (1, later)):
            for a, b, of_levels, *_ in parts:
                for c in range(bisect_left(ends, a), bisect_left(ends, b)):
                    for m, d in enumerate(of_levels):
                        defects[start + m][c] = -(-d * self.one // 1)
        shares = [self.shares(y, ends) for y in ends] if self.levels > 1 else []
        errors = []
        for m, D in enumerate(defects):
            if m:
                parts = self.parted(errors[-1], ends)
                apart = [-(-self.once(x1, x2) * self.one // 1) if m == 1 else 0 for x1, x2 in zip(ends, ends[1:])]
                carried = [self.averaged(parts, shares[c], shares[c + 1]) + apart[c] << self.up[m - 1] if d is not None else 0
                           for c, d in enumerate(D)]
                for a, b in self.holes:  # there monotony brings the error from the ends
                    i, j = bisect_right(ends, a) - 1, bisect_left(ends, b)
                    carried[i:j] = [max(carried[i:j])] * (j - i)
                D = [d + e if d is not None else 0 for d, e in zip(D, carried)]
            errors.append([d or 0 for d in D])
        return ends, errors

    def once(self, x1, x2):
        """what waves of these means, which may cross 1, make of errors of level 0 that are no step function (AA)"""
        return 0

    def shares(self, x, ends):
        """(H): of a wave of mean x above each of these ratios, in units 2^-work, up to the first that rounds to 0; their last end lies
        beyond all"""
        found = []
        for y in ends[:-1]:
            found.append((self.theta(x, y) << self.work) // self.trig.pi)
            if not found[-1]:
                break
        return found

    def parted(self, e, ends):
        """(H): a step function as one without what stands out on narrow cells, by its jumps; what T makes of the rest, summed from the
        first cell on; and its largest"""
        wide = [isqrt((self.G * (b - a) >> 1) + 1) + 1 for a, b in zip(ends, ends[1:])]
        low = [*e, e[-1]]
        for c in reversed(range(len(e))):
            low[c] = min(e[c], low[c + 1]) if wide[c] * NARROW < self.one else e[c]
        return jumps(low[:-1]), list(accumulate(((v - u) * w >> self.bits) + (v > u) for v, u, w in zip(e, low, wide))), max(e)

    def averaged(self, parts, less, more):
        """(H): above T e for a step function e, from the shares at the ends of an interval of x"""
        (steps, beyond, most), ends = parts, 1 + (1 << max(0, self.work - self.bits // 2 + 10))
        total = sum(max(0, j) * s for j, s in zip(steps, more)) + ends * (most + sum(max(0, j) for j in steps))
        total += sum(min(0, j) * max(0, s - ends) for j, s in zip(steps, less))
        return min(most, (total >> self.work) + 1 + beyond[min(len(more), len(beyond)) - 1])

    def value(self, n, load, errors):
        """B_n at this load: low and high, fractions"""
        (ends, errors), at = errors, (load * self.one // 1, -(-load * self.one // 1))
        rows, e = [self.exact_row(x)[n - 1] for x in set(at)], errors[n - 1]  # B_n increases
        parts = jumps(e), [0] * len(e), max(e)  # nothing taken out: at one load the shares are what they are
        error = Fraction(self.averaged(parts, *(self.shares(x, ends) for x in at)), self.one) + 2 * self.round + self.quadrature
        return tuple((Fraction(row, self.unit) + off) / 2 ** self.lift[n - 1] for row, off in ((min(rows), -error), (max(rows), error)))
