# SPDX-License-Identifier: MIT
"""The law of the load ratio x_m = p_(m-1)/p*_m in partial contact, G > 2 and load <= 1, in intervals; lemmas N to R are those of
docs/certificate.md.

x_m has the density x phi_m(T), T = 1 - (x/Y_m)^2, on 0 < x < Y_m, where Y_1 = (2/G) sqrt(load), Y_(m+1) = (2/G) sqrt(Y_m), and with r = T'
(1 - v^2)
    phi_(m+1)(T') = (G^2/pi) sqrt(Y_m T') int_0^1 phi_m(r (2 - r)) x S/R dv,   x = Y_m (1 - r),
    R^2 = (1 - x)^2 + 4 Y_m (1 - T'),   S^2 = (1 + x + R)/(1 - x + R).
V_m is T^(power/2) times a polynomial on each of some pieces of 0 <= T <= 1, any; V_1 = phi_1 is known. What is proved is |phi_m - V_m| <=
error V_m: as all this is positive, relative errors add (N). Nothing is rounded by hand but in `Polynomial.value`.
"""
from fractions import Fraction
from math import log2

import intervals as iv
from full_contact import Far, Trigonometry, lebesgue
from intervals import Interval
from transfer import Refused, chebyshev

REACH = Fraction(5, 4)         # half axis, in half widths, of the ellipse rho = 2 about an interval J of T' on which a defect is bounded
BELOW = Fraction(1, 2)         # so many half widths below J the piece of J is continued: past that ellipse
BREAK = Fraction(4, 5), Fraction(3, 5)  # v goes from 0 to 4/5; from there on s = sqrt(1 - v^2), from 3/5 to 0
RULES = (16, 12), (4, 24)      # rho of ellipses of rules of Gauss, and the most points on one part
# Of a piece: a cut of the level below so near to its end is at its end but for rounding, and what it cuts off costs as much as a piece.
SLIVER = Fraction(1, 2**45)
MOST_POINTS, MOST_INTERVALS, MOST_HALVINGS, MOST_PARTS = 96, 2000, 32, 4000


def half_power(z, k):
    """z^(k/2)"""
    if k < 0:
        return 1 / half_power(z, -k)
    total = iv.sqrt(z) if k % 2 else Interval.of(1)
    k //= 2
    while k:
        if k % 2:
            total = total * z
        k //= 2
        z = z * z if k else z
    return total


def log2_of(x):
    """for choices, where nothing is proved"""
    return x.numerator.bit_length() - x.denominator.bit_length() if x else -10**6


def need(holds):
    if not holds:
        raise Far


def below(x, y):
    """surely x < y"""
    return (Interval.of(y) - x).low > 0


def top(x):
    return x.ends()[1]


def power_bound(z, off, k):
    """above |z^(k/2)| within `off` of z > 0"""
    need(k >= 0 and k % 2 == 0 or below(off, z))
    return half_power(z + off if k >= 0 else z - off, k)


def wave_bounds(square, rest, x, least, most):
    """(O): above |S/R|, and below Re R, R^2 = (1 - x)^2 + z, where Re (1 - x)^2 >= square, Re(1 - x) >= rest, |x| <= x, Re z >= least, |z|
    <= most"""
    low = square + least
    need(low.low > 0)
    real = iv.sqrt(low.scaled(-1))
    need(below(0, rest + real))
    return iv.sqrt((1 + x + iv.sqrt((1 + x).square() + most)) / (rest + real) / low), real


def wave_near(x, off, least, most):
    """the same for all x so far about a real one"""
    rest = 1 - x
    need(below(off, 1 + x))
    return wave_bounds(rest.square() - off * (2 * rest + off), rest - off, x + off, least, most)


def need_inside(T):
    if not below(0, T) or below(1, T):
        raise Refused("the claim is at an end of the law, or beyond")


class FirstWave:
    """V_1 = g_1/sqrt(T), (2.19) at the load"""
    low, high, power, terms = 0, 1, -1, 2

    def __init__(self, G, load):
        self.load, self.factor = load, G.square() / (2 * iv.pi() * iv.sqrt(load))

    def value(self, T):
        R = iv.sqrt((1 - self.load).square() + 4 * self.load * (1 - T))
        return self.factor * iv.sqrt((1 + self.load + R) / (1 - self.load + R)) / R

    def bound(self, T, off):
        return self.factor * wave_near(self.load, Interval.of(0), 4 * self.load * (1 - T - off), 4 * self.load * (1 - T + off))[0]

    def largest(self, T):
        """of real ones from 0 to T, since S/R increases"""
        return self.bound(Interval.of(T), Interval.of(0))


class Polynomial:
    """V_m = T^(power/2) 2^exponent sum c_k T_k((T - middle)/half) for low <= T <= high"""

    def __init__(self, low, high, middle, half, power, exponent, coefficients):
        if half <= 0 or max(abs(low - middle), abs(high - middle)) > half:
            raise Refused("a polynomial is of another piece")
        self.low, self.high, self.middle, self.half = low, high, middle, half
        self.power, self.exponent, self.coefficients = power, exponent, coefficients
        self.sizes, self.terms = [abs(c) for c in coefficients], len(coefficients)
        self.rounding, self.inverse = sum(map(abs, coefficients)) * self.terms**2, 1 / Interval.of(half)

    def value(self, T):
        """of the polynomial: an error of t by a unit and the roundings of the recurrence are less than terms^2 units for each |c_k|, |t| <=
        1"""
        bits, t = Interval.bits, (T - self.middle) * self.inverse
        up, down = t.exponent + bits, -t.exponent - bits
        low, high = (t.low << up, t.high << up) if up >= 0 else (t.low >> down, -(-t.high >> down))
        need(-1 <= low >> bits and high <= 1 << bits)
        off = self.rounding * (high - low + 2)
        total = sum(map(int.__mul__, self.coefficients, chebyshev(low, 1 << bits, self.terms, bits)))
        return Interval(total - off, total + off, self.exponent - bits)

    def largest(self, _):
        """of those on the piece"""
        return Interval.of(sum(self.sizes)).scaled(self.exponent)

    def bound(self, T, off):
        """|T_k| <= rho^k on the ellipse rho; points so far from a real one of modulus t are within those of half axes max(1, t) + off and
        ((t + off)^2 + 1)^(1/2) (I)"""
        t, off = (T - self.middle) * self.inverse, off * self.inverse
        far = Interval.of(max(map(abs, t.ends())))
        axis = Interval.of(max(1, top(min(Interval.of(max(1, top(far))) + off, iv.sqrt((far + off).square() + 1), key=top))))
        rho, total = -(-top(axis + iv.sqrt(axis.square() - 1)) * 2**32 // 1), 0
        for size in reversed(self.sizes):
            total = (total * rho >> 32) + 1 + size
        return Interval.of(total).scaled(self.exponent)


def interpolated(values, size, rho):
    """(K): above |f| on an interval, from its values at Chebyshev points there and a bound of it on the ellipse rho"""
    count, (middle, spread) = len(values), spread_of(values)
    return abs(middle) + spread + (1 + lebesgue(count)) * 2 * size * Fraction(rho) ** (1 - count) / (rho - 1)


def spread_of(values):
    """(K): the polynomial of these values at Chebyshev points is so near to a middle there"""
    low, high = min(v.ends()[0] for v in values), max(v.ends()[1] for v in values)
    return (low + high) / 2, lebesgue(len(values)) * (high - low) / 2


def least(values):
    """(K): below a polynomial of fewer terms than values at Chebyshev points, there"""
    middle, spread = spread_of(values)
    return middle - spread


class Laws:
    """Of one G and one load: the largest ratios Y_m, and what follows from V_m for phi_(m+1) and for shares"""

    def __init__(self, G, load, bits):
        self.bits, self.G, self.trig, self.gain = bits, G, Trigonometry(bits), G.square()
        Interval.bits, self.tops = bits, [Interval.of(load)]
        self.first = FirstWave(G, self.tops[0])

    def top(self, m):
        while len(self.tops) <= m:
            self.tops.append(2 * iv.sqrt(self.tops[-1]) / self.G)
        return self.tops[m]

    # ---- the integrand, in u = v or, with `low`, in u = s: of a density, a "share" above a pressure or, of the limit, the "force" at
    # ratios above Y (1 - T)

    def at(self, m, V, u, low, T, kind):
        """its value at u for one piece V"""
        Y, square = self.top(m), u.square()
        k, c2 = (square, 1 - square) if low else (1 - square, square)
        r = T * k
        t, x = r * (2 - r), Y - Y * r
        R = iv.sqrt((1 - x).square() + self.beyond)
        here = half_power(t, V.power) * V.value(t) * x
        if kind == "force":
            return here * x * u
        if kind:
            s = 2 * Y * T * c2 / (1 + x + R)
            return here * u * iv.angle(iv.sqrt(s), iv.sqrt(1 - s)) * 2 / iv.pi()
        under = (1 + x + R) / (1 - x + R)
        return here * u * iv.sqrt(under / c2) / R if low else here * iv.sqrt(under) / R

    def bound(self, m, V, u, off, low, T, kind):
        """above its modulus so far about u"""
        Y, u, off = self.top(m), Interval.of(u), Interval.of(off)
        moved = off * (2 * u + off)
        k = u.square() if low else 1 - u.square()
        r, off_r, first = T * k, T * moved, low and V.low == 0
        root, real = wave_near(Y * (1 - r), Y * off_r, self.beyond, self.beyond)
        size = self.size(V, r, off_r, first) * Y * (1 - r + off_r)
        if first:
            size = size * half_power(T, V.power)
        if low:
            size = size * half_power((u + off).square(), V.power + 1 if first else 1)
        need(not low or below(u + off, 1))
        if kind == "force":
            return size * Y * (1 - r + off_r) * (1 if low else u + off)
        if kind:
            need(below(2 * Y * T * (1 - k + moved), 1 + Y * (1 - r - off_r) + real))  # |arcsin z| <= pi/2 for |z| <= 1
            return size * (1 if low else u + off)
        return size * root / (iv.sqrt(1 - (u + off).square()) if low else 1)

    def size(self, V, r, off, rootless=False):
        """above |V| at T = r (2 - r) so far about r; of the piece at 0, if so told, without its r^(power/2)"""
        T, off_T = r * (2 - r), off * (2 * (1 - r) + off)
        if V.low > 0:
            return power_bound(T, off_T, V.power) * V.bound(T, off_T)
        need(below(off, 2 - r))
        size = V.bound(T, off_T) * (half_power(2 - r + off, V.power) if V.power >= 0 else 1 / iv.sqrt(2 - r - off))
        return size if rootless else size * power_bound(r, off, V.power)

    # ---- integrals

    def integral(self, m, pieces, T, allowed, kind=""):
        """(P): over 0 <= v <= 1; pieces (V, r) from the first one up, each from its r on; `allowed`: what an error may be"""
        total, self.parts, self.beyond = Interval.of(0), 0, 4 * self.top(m) * (1 - T)  # G^2 y^2
        starts = [(Interval.of(r) / T, V) for V, r in pieces if not below(T, r)]
        for (k, V), (upper, _) in zip(starts, [*starts[1:], (Interval.of(1), None)]):
            for low, ends in ((False, (1 - upper, 1 - k)), (True, (k, upper))):
                (a, near_a), (b, near_b) = map(self.root, ends)
                if a - near_a < BREAK[low]:
                    total = total + self.part(m, V, (min(a, BREAK[low]), near_a), (min(b, BREAK[low]), near_b), low, T, allowed, kind)
        return total

    def root(self, x):
        """a number near sqrt(x), and how near"""
        low, high = (max(Fraction(0), e) for e in x.ends())
        low, high = iv.sqrt(Interval.of(low)).ends()[0], top(iv.sqrt(Interval.of(high)))
        number = (low + high) / 2 * 2**self.bits // 1 * Fraction(1, 2**self.bits)
        return number, max(high - number, number - low)

    def part(self, m, V, a, b, low, T, allowed, kind):
        """from a to b, (number, how near) each: by one rule of Gauss, by none where it is little, or by halves"""
        (a, near_a), (b, near_b) = a, b
        slivers, half, at = near_a + near_b, (b - a) / 2, (a + b) / 2
        self.parts += 1
        if self.parts > MOST_PARTS:
            raise Refused("an integral has too many parts")
        if half <= 0:
            if not slivers - half:
                return Interval.of(0)
            return iv.error_term(self.bound(m, V, a, slivers - 2 * half, low, T, kind) * (slivers - 2 * half))
        need(half * 2**self.bits > 1)
        bits, found = self.bits, None
        for rho, most in RULES:
            try:
                size = self.bound(m, V, at, half * (rho + Fraction(1, rho)) / 2 + slivers, low, T, kind)
            except Far:
                continue
            M, K = top(size), 0 if 2 * half * top(size) < allowed * half else 2
            room = log2_of(6 * M) - log2_of(allowed)
            K = K and max(2, 2 * -(-room // (4 * int(log2(rho)))))
            if K <= most:
                found = K, M, rho
                break
        if not found:
            c = (at, Fraction(0))
            return self.part(m, V, (a, near_a), c, low, T, allowed, kind) + self.part(m, V, c, (b, near_b), low, T, allowed, kind)
        K, M, rho = found
        if not K:
            return Interval.of(2 * half * M + slivers * M) * Interval(0, 1)
        total, middle, wide = Interval.of(0), Interval.of(at), Interval.of(half)
        for t, w in self.trig.gauss(int(K)):
            t = wide * Interval(t, t, -bits)
            total = total + (self.at(m, V, middle - t, low, T, kind) + self.at(m, V, middle + t, low, T, kind)) * w
        off = 6 * half * Fraction(rho) ** (-2 * K) + half * Fraction(1, 2 ** (bits - 15)) + slivers
        return total.scaled(-bits) * half + iv.error_term(Interval.of(off * M))

    # ---- what follows from V_m

    def density(self, m, pieces, T, allowed):
        """phi_(m+1)(T) of V_m"""
        factor = self.gain / iv.pi() * iv.sqrt(self.top(m) * T)
        return factor * self.integral(m, pieces, T, allowed / top(factor))

    def read(self, m, kind, T, pieces, allowed):
        """the share of the next wave above a pressure that V_m makes, or its force"""
        factor = 2 * self.top(m) * T
        return factor * self.integral(m, of_ratios(pieces), T, allowed / top(factor), kind)

    def share_of_area(self, n, P, pieces, off, allowed):
        """of A_n above P p*_n, where V_n is within `off` of itself of phi_n"""
        T, off = 1 - Interval.of(P).square() / (4 * self.top(n)), Interval.of(off)
        need_inside(T)
        allowed = allowed * (self.tops[0] / half_power(self.G, 2 * n)).ends()[0]  # A_n is some load/G^n
        parts = [self.read(n, "share", T, pieces, allowed) for T in (T, Interval.of(1))]
        return parts[0] / parts[1] * (1 + iv.error_term(2 * off / (1 - off)))

    def claimed(self, quantity, n, place, pieces, error):
        """what V_n makes of a claim; its own error is of no account beside the claim's"""
        fine = error / 16
        if quantity == "segments.density":  # (9.3): x = sin^2(pi a)
            x = iv.sin_pi(place).square()
            T = 1 - (x / self.top(n)).square()
            need_inside(T)
            factor = x * iv.pi() * iv.sin_pi(2 * place)
            return factor * self.density(n - 1, of_ratios(pieces), T, fine / top(factor))
        power = half_power(self.G, 2 * n)
        P = place / power
        T = 1 - P.square() / (4 * self.top(n))
        need_inside(T)
        if quantity == "contact.density":
            factor = P / power / self.G.square()
            return factor * self.density(n, of_ratios(pieces), T, fine / top(factor))
        return self.read(n, "share", T, pieces, fine)

    # ---- defects

    def mismatch(self, official, used, low, high, target):
        """(K): above |V - W|/V for two pieces V and W on low <= T <= high, from so many points that what lies between them makes little of
        the target"""
        at, half, more = (low + high) / 2, (high - low) / 2, used.power - official.power
        off, count = Interval.of(half * Fraction(17, 8)), max(30, used.terms, official.terms)
        size = top(power_bound(Interval.of(at), off, more) * used.bound(at, off) + official.bound(at, off))
        aim = target * official.value(Interval.of(at)).ends()[0] / 8
        while count < MOST_POINTS and (1 + lebesgue(count)) * size > aim * 4**(count - 1):
            count += 1
        points = [at + half * Fraction(t, 2**self.bits) for t in self.cosines(count)]
        here = [official.value(Interval.of(T)) for T in points]
        floor = least(here)
        need(floor > 0)
        apart = [half_power(Interval.of(T), more) * used.value(Interval.of(T)) - v for T, v in zip(points, here)]
        return interpolated(apart, size, 4) / floor

    def cosines(self, count):
        return [self.trig.cos_sin(self.trig.pi * (2 * j + 1) // (2 * count))[0] for j in range(count)]

    def continued(self, m, pieces, used, a, half, V, target):
        """(Q): what it changes at most that the piece of J is continued, and a bound on the ellipse about J of what follows then"""
        p, W, Y, at, reach, start = len(used) - 1, used[-1][0], self.top(m), a + half, REACH * half, a - BELOW * half
        bottom, z = Interval.of(at - reach), (4 * Y * (1 - at - reach), 4 * Y * (1 - at + reach))
        changed, beyond = Fraction(0), (at + half) * (2 - at - half)
        if beyond > W.high:
            need(p + 1 < len(pieces) and beyond <= pieces[p + 1].high)
            changed += self.mismatch(pieces[p + 1], W, W.high, beyond, target)
        factor = self.gain * iv.sqrt(Y) / (2 * iv.pi())
        if start <= 0:
            need(p == 0 and W.low == 0)
            off = Interval.of(max(at, reach))
            size = self.size(W, Interval.of(at), off, True) * Y * (1 - at + off) * wave_near(Y * (1 - at), Y * off, *z)[0]
            size = size * (iv.pi() if W.power < 0 else 2)
            if V.power != W.power + 1:
                for power in (W.power + 1, -V.power):
                    size = size * power_bound(Interval.of(at), Interval.of(reach), power)
            return changed, factor * size
        if start * (2 - start) < W.low:
            need(p > 0 and start * (2 - start) >= pieces[p - 1].low)
            changed += self.mismatch(pieces[p - 1], W, start * (2 - start), W.low, target)
        total = self.size(W, Interval.of(at), Interval.of(at - start)) * Y * (1 - start + 2 * half)
        total = total * iv.sqrt(Interval.of(at + reach - start))
        total = total * wave_near(Y * (1 - at), Y * (at - start), *z)[0]
        for U, r in used:
            if not below(start, r):
                rest = 1 - Y * (1 - r)
                weight = half_power(Interval.of(U.high), U.power) * iv.sqrt(bottom) if U.power >= 0 else iv.pi().scaled(-1)
                total = total + weight * U.largest(start * (2 - start)) * Y * wave_bounds(rest.square(), rest, Y, *z)[0]
        return changed, 2 * factor * total * power_bound(Interval.of(at), Interval.of(reach), -V.power)

    def defect(self, m, pieces, V, a, b, target):
        """(Q), (R): above |phi - V|/V on a <= T' <= b, where phi is what follows from the pieces of level m"""
        half, at = (b - a) / 2, (a + b) / 2
        start, used = a - BELOW * half, of_ratios([U for U in pieces if U.low < at * (2 - at)])
        if 0 < start and start * (2 - start) < used[-1][0].low:
            used[-1] = used[-1][0], Interval.of(start)
        changed, size = self.continued(m, pieces, used, a, half, V, target)
        size = top(size + V.bound(at, Interval.of(REACH * half)))
        floor = V.value(Interval.of(at)).ends()[0]
        need(floor > 0 and changed < target)
        count = V.terms + 1
        while count <= MOST_POINTS and (1 + lebesgue(count)) * 16 * size > target * floor * 2**(count - 1):
            count += 1
        need(count <= MOST_POINTS)
        points = [Interval.of(at + half * Fraction(t, 2**self.bits)) for t in self.cosines(count)]
        here = [V.value(T) for T in points]
        floor = least(here)
        need(floor > 0)
        roots = [half_power(T, V.power) for T in points]
        off = [self.density(m, used, T, target * floor * root.ends()[0] / 16) / root - v for T, root, v in zip(points, roots, here)]
        if any(min(map(abs, o.ends())) > target * v.ends()[1] and not o.low < 0 < o.high for o, v in zip(off, here)):
            raise Refused("a piece is further from the law than it says")
        d = interpolated(off, size, 2) / floor
        return changed * (1 + d) / (1 - changed) + d

    def prove(self, m, pieces, V, target, progress):
        """|phi_(m+1) - V| <= target V on V's piece, where the pieces of level m are taken for phi_m"""
        cuts = [r for r in (r.ends()[0] for _, r in of_ratios(pieces)) if V.low < r < V.high]
        sliver = (V.high - V.low) * SLIVER
        ends = [V.low, *(r for r in cuts if V.low + sliver < r < V.high - sliver), V.high]
        stack = [(Fraction(a), Fraction(b), 0) for a, b in zip(ends, ends[1:])]
        for _ in range(MOST_INTERVALS):
            if not stack:
                return
            a, b, halvings = stack.pop()
            if halvings > MOST_HALVINGS:
                break
            progress(f"from T = {float(a):.6f} on")
            try:
                if self.defect(m, pieces, V, a, b, target) <= target:
                    continue
            except Far:
                pass
            c = next((r for r in cuts if a < r < b), (a + b) / 2)
            stack += [(c, b, halvings + 1), (a, c, halvings + 1)]
        raise Refused("a piece is no approximation")


def of_ratios(pieces):
    """each with the r, r (2 - r) = T, from which on it counts"""
    return [(V, Interval.of(V.low) / (1 + iv.sqrt(1 - Interval.of(V.low)))) for V in pieces]
