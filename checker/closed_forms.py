# SPDX-License-Identifier: MIT
"""The closed forms of the paper as it prints them (corrected where the ledger refutes the print), for exact inputs.

Each function takes fractions and returns a Fraction where the value is rational and found to be so, else an Interval.
Units: lengths in wavelengths, pressures in p*, load = mean pressure / p*, G = gamma^(D-1). A difference of inputs is formed
exactly; where an interval is still too wide (Undecided, or digits left open) the caller doubles Interval.bits and asks again.
Written from the paper and the definitions in docs, not from the library: no form here is one of its rearranged ones.
"""
from fractions import Fraction
from functools import lru_cache
from math import isqrt

import intervals as iv
from intervals import Interval


class Undecided(Exception):
    """More bits may tell on which side of a branch an input lies."""


def root(x):
    """sqrt of what is not negative, exact for squares of fractions"""
    if isinstance(x, Fraction):
        n, d = isqrt(x.numerator), isqrt(x.denominator)
        if n * n == x.numerator and d * d == x.denominator:
            return Fraction(n, d)
    x = Interval.of(x)  # known not to be negative
    if x.high < 0:
        raise ValueError("a quantity that cannot be negative is")
    return iv.sqrt(Interval(max(x.low, 0), x.high, x.exponent))


def between(a, b):
    """contains what lies between a member of a and a larger one of b"""
    d = b - a
    return a + Interval(min(d.low, 0), max(d.high, 0), d.exponent)


def below(a, b):
    """Whether a < b, decided."""
    if isinstance(a, Fraction) and isinstance(b, Fraction):
        return a < b
    d = Interval.of(b) - a
    if d.low <= 0 < d.high:
        raise Undecided
    return d.low > 0


def arc(y, x):
    """angle of (x, y) over pi; exact on the axes and the diagonal"""
    if isinstance(y, Fraction) and isinstance(x, Fraction):
        if y == 0 or x == 0 or x == y:
            return Fraction(0) if y == 0 else Fraction(1, 2) if x == 0 else Fraction(1, 4)
    return iv.angle(y, x) / iv.pi()


def arcsin_root(s, rest):
    """arcsin(sqrt s)/pi where rest = 1 - s is known exactly or better than by subtraction"""
    return Fraction(1, 4) if isinstance(s, Fraction) and s == rest else arc(root(s), root(rest))


def sine_square(x):
    """sin^2(pi x); 0, 1/2 and 1 where they are exact"""
    quarters = 4 * x
    if quarters.denominator == 1:
        return Fraction((0, 1, 2, 1)[quarters.numerator % 4], 2)
    return iv.sin_pi(x).square()


# ---- section 2

def half_width(load):
    return arcsin_root(load, 1 - load)  # (2.5)


def pressure(x, load):
    s2 = sine_square(x)
    if load >= 1:
        return load + 1 - 2 * s2  # (2.2)
    inside = load - s2
    if not below(Fraction(0), inside):
        return Fraction(0)
    return 2 * (root(1 - s2) * root(inside))  # (2.4)


def partial_ratio(p, load):
    """(2.17): s with Q = (2/pi) arcsin sqrt s, and 1 - s, from R = sqrt((1 - load)^2 + p^2)"""
    R = root((1 - load) ** 2 + p * p)
    rest = (2 * (1 - load) + 2 * R + p * p) / (2 * (1 + load + R)) if load < 1 or p else Fraction(0)
    return (4 * load - p * p) / (2 * (1 + load + R)), rest, R


def exceedance(p, load):
    if load >= 1:
        if p <= load - 1 or p >= load + 1:
            return Fraction(p <= load - 1)
        return 2 * arcsin_root((load + 1 - p) / 2, (p - load + 1) / 2)  # (2.14), half angles
    if p * p >= 4 * load:
        return Fraction(0)
    s, rest, _ = partial_ratio(p, load)
    return 2 * arcsin_root(s, rest)


def density(p, load):
    """p may be an interval; at an end of the support, where the density is infinite, it has no value"""
    if isinstance(p, Fraction) and (p in (load - 1, load + 1) if load >= 1 else p * p == 4 * load):
        raise ValueError("an end of the support")
    if load >= 1:
        if not (below(load - 1, p) and below(p, load + 1)):
            return Fraction(0)
        return 1 / (iv.pi() * root((p - load + 1) * (load + 1 - p)))  # (2.15)
    if p == 0 or not below(p * p, 4 * load):
        return Fraction(0)
    R = root((1 - load) ** 2 + p * p)
    inside = Interval.of((1 + load + R) / ((1 - load + R) * (4 * load - p * p)))  # (2.19)
    return p / (iv.pi() * R) * iv.sqrt(inside)


def hertz_half_width(load):
    return root(load) / iv.pi()


def hertz_pressure(x, load):
    inside = load - (iv.pi() * x).square() if x else load
    return 2 * root(inside) if below(Fraction(0), inside) else Fraction(0)


def gap_beyond(v2, load):
    """4 times the integral of sqrt(t^2 - load) from sqrt(load) to v"""
    inside = v2 - load
    if not below(Fraction(0), inside):
        return Fraction(0)
    v, w = root(v2), root(inside)
    return 2 * (v * w - load * iv.log((v + w) / root(load)))


def gap(x, load):
    return Fraction(0) if load >= 1 else gap_beyond(sine_square(x), load)


def hertz_gap(x, load):
    return gap_beyond((iv.pi() * x).square() if x else Fraction(0), load)


def mean_gap(load):
    return Fraction(0) if load >= 1 else 1 - load + load * iv.log(load)


def energy(load):
    return Fraction(1, 4) if load >= 1 else load * load * (1 - 2 * iv.log(load)) / 4


# ---- section 3

def weierstrass_bound(D, gamma):
    return 1 / (1 - power_of_gamma(gamma, D - 2))


def exact_power(x, exponent):
    """x**exponent as a fraction, for exponents with a power of two below; None if it is none"""
    if exponent.denominator & (exponent.denominator - 1):
        return None
    y = x ** abs(exponent.numerator)
    for _ in range(exponent.denominator.bit_length() - 1):
        y = root(y)
        if not isinstance(y, Fraction):
            return None
    return y if exponent > 0 else 1 / y


def power_of_gamma(gamma, exponent):
    """exact where the exponent is short and the power a fraction"""
    few = exponent.denominator <= 8 and abs(exponent.numerator) <= 8
    exact = exact_power(gamma, exponent) if few else None
    return exact if exact is not None else iv.power(gamma, exponent)


def weierstrass_profile(x, D, gamma):
    """(3.1), each phase exact. What follows the last term is a geometric series; so is all that follows a phase that gamma leaves where it
    is."""
    ratio = power_of_gamma(gamma, D - 2)
    amplitude, phase, total = Fraction(1), x, Fraction(0)
    while iv._magnitude(Interval.of(amplitude)) > -Interval.bits:
        cosine = 1 - 2 * sine_square(phase)
        if gamma.denominator == 1 and (phase * (gamma - 1)).denominator == 1:
            return total + amplitude * cosine / (1 - ratio)
        total = total + amplitude * cosine
        amplitude, phase = amplitude * ratio, phase * gamma
        if gamma.denominator == 1:
            phase %= 1
    return total + iv.error_term(Interval.of(amplitude / (1 - ratio)))


# ---- section 5

def f(x):
    return 1 + x if not below(x, Fraction(1)) else 2 * root(x)


def seam(x):
    """f, continuous at 1: there the hull of both branches"""
    try:
        return f(x)
    except Undecided:
        low, high = Interval(x.low, x.low, x.exponent), Interval(x.high, x.high, x.exponent)
        return between(2 * iv.sqrt(low), 1 + high)


def iterate(n, load, G):
    """(5.6) from x_(-1) = load; two more values once rounding has taken over would change nothing, so none are skipped"""
    x = load
    for _ in range(int(n) + 1):
        x = seam(x) / G
        if isinstance(x, Fraction) and x.denominator.bit_length() > 4096:
            x = Interval.of(x)
    return x


def fixed_point(G):
    return 1 / (G - 1) if below(G, Fraction(2)) else 4 / (G * G)  # (5.8), (5.9)


# ---- section 7

@lru_cache(maxsize=None)
def stirling(bits):
    """the coefficients B_2k/(2k (2k - 1)) of Stirling's series, by tangent numbers"""
    count = bits // 6
    tangent = [0, 1]
    for k in range(2, count + 1):
        tangent.append((k - 1) * tangent[-1])
    for k in range(2, count + 1):
        for j in range(k, count + 1):
            tangent[j] = (j - k) * tangent[j - 1] + (j - k + 2) * tangent[j]
    return [Interval.of(Fraction((-1) ** (k - 1) * tangent[k], (2 * k - 1) * 4**k * (4**k - 1))) for k in range(1, count + 1)]


def log_gamma(x):
    """log(Gamma(x)/sqrt(2 pi)), x > 0, by Stirling's series at z = x + shift; its error is at most the first term left out (real z),
    and terms fall until the pi z-th, beyond the last at hand."""
    coefficients = stirling(Interval.bits)
    shift = Interval.bits // 6
    product = Interval.of(1)
    for j in range(shift):
        product = product * (x + j)
    z = Interval.of(x + shift)
    total = (z - Fraction(1, 2)) * iv.log(z) - z - iv.log(product)
    inverse, square = 1 / z, 1 / z.square()
    for c in coefficients:
        term = c * inverse
        if iv._magnitude(term) < -Interval.bits:
            break
        total = total + term
        inverse = inverse * square
    return total + iv.error_term(term)


@lru_cache(maxsize=None)
def half_log_pi(bits):
    return iv.log(iv.pi()).scaled(-1)


def log_step(delta):
    """(7.13)  log K_(n+1)/K_n at delta = delta_n"""
    return iv.log(2) * delta + log_gamma(1 + delta / 2) - log_gamma(Fraction(3, 2) + delta / 2) - half_log_pi(Interval.bits)


_log_K = {}


def log_K(n):
    """log K_n at the present precision, by the recursion (7.13) from K_0 = 2/pi"""
    known = _log_K.setdefault(Interval.bits, [iv.log(2 / iv.pi())])
    while len(known) <= n:
        known.append(known[-1] + log_step(1 - Fraction(1, 2 ** len(known))))
    return known[n]


def K(n):
    """K_n; for large n from K_inf <= K_n <= K_inf e^(2^-(n+1)), see K_inf."""
    n = int(n)
    if n <= Interval.bits:
        return iv.exp(log_K(n))
    limit = K_inf()
    return limit + iv.error_term(limit * Fraction(1, 2**Interval.bits))


def K_inf():
    """K_N e^(-2^-(N+1)) <= K_inf <= K_(N+1)^2/K_N, N >= 0. Proof: the step (7.13) at delta is phi(delta) = (1/pi) int (2 cos t)^delta cos t
    dt over |t| < pi/2, which is log-convex (Hoelder), with phi(0) = 2/pi, phi(1) = 1, phi'(1) = 1/2. So L(h) = log phi(1 - h) is convex
    with L(0) = 0 and slope -1/2 there: -h/2 <= L(h) <= 0, 0 <= h <= 1, and L(h/2) <= L(h)/2. Summed over the steps h = 2^-(N+1), 2^-(N+2),
    ... the first gives the lower bound (and K_inf <= K_N), the second log K_inf/K_N <= 2 L(2^-(N+1))."""
    N = Interval.bits // 2 + 8
    low = iv.exp(log_K(N) - Fraction(1, 2 ** (N + 1)))
    return between(low, iv.exp(log_K(N + 1).scaled(1) - log_K(N)))


def delta(n):
    return 1 - Fraction(1, 2 ** (int(n) + 1))


def alpha(n, D):
    return (1 - D) * (n - 1 + Fraction(1, 2 ** int(n)))


def archard_area(n, load, G):
    return K(n) * iv.exp(iv.log(G) * -(n - 1 + Fraction(1, 2 ** int(n))) + iv.log(load) * delta(n))


def archard_segments(n, load, D, gamma):
    exponent = (2 - D) * n + 2 * (D - 1) * (1 - Fraction(1, 2 ** int(n)))
    return K(n - 1) * iv.exp(iv.log(gamma) * exponent + iv.log(load) * (1 - Fraction(1, 2 ** int(n))))


def archard_segments_limit(n, load, D, gamma):
    return K_inf() * iv.exp(iv.log(gamma) * ((2 - D) * n + 2 * (D - 1))) * load


# ---- section 9

def max_half_width(n, load, G):
    x = iterate(n - 1, load, G)
    if not below(x, Fraction(1)):
        return Fraction(1, 2)
    return arcsin_root(x, 1 - x)


# ---- scale 0 of the recursion, and what is exact at every scale

def everywhere_in_contact(n, load, p, G):
    """load - (1 + G + ... + G^n) >= p"""
    total, power = Fraction(0), Fraction(1)
    for _ in range(int(n) + 1):
        total += power
        if below(load - p, total):
            return False
        power *= G
    return True


def beyond(n, p, load, G):
    """(5.6): p lies above the largest pressure of scale n, where there is none"""
    return below(seam(iterate(n - 1, load, G)) * G ** int(n), p)


def contact_area(n, load, G):
    if everywhere_in_contact(n, load, 0, G):
        return Fraction(1)
    return 2 * half_width(min(load, Fraction(1))) if n == 0 else None


def contact_exceedance(n, p, load, G):
    if everywhere_in_contact(n, load, p, G):
        return Fraction(1)
    return exceedance(p, load) if n == 0 else Fraction(0) if beyond(n, p, load, G) else None


def contact_density(n, p, load, G):
    return density(p, load) if n == 0 else Fraction(0) if beyond(n, p, load, G) else None


def segments_count(n, load, D, gamma):
    return 2 * half_width(min(load, Fraction(1))) * gamma if n == 1 else None


def segments_density(n, a, load, G):
    """(9.3) at n = 1: the pressure G sin^2(pi a) of scale 0 makes segments of half-width a in lambda_1; full contact makes none,
    and the largest pressure the widest"""
    if n != 1:
        return Fraction(0) if below(max_half_width(n, load, G), a) else None
    q = density(sine_square(a) * G, load)
    return q * (iv.pi() * iv.sin_pi(2 * a) * G) if q and a not in (0, Fraction(1, 2)) else Fraction(0)


FORMS = {
    "westergaard.half_width": half_width, "westergaard.pressure": pressure, "westergaard.exceedance": exceedance,
    "westergaard.density": density, "westergaard.gap": gap, "westergaard.mean_gap": mean_gap, "westergaard.energy": energy,
    "hertz.half_width": hertz_half_width, "hertz.pressure": hertz_pressure, "hertz.gap": hertz_gap,
    "weierstrass.bound": weierstrass_bound, "weierstrass.profile": weierstrass_profile,
    "peaks.f": f, "peaks.iterate": iterate, "peaks.fixed_point": fixed_point,
    "archard.K": K, "archard.K_inf": K_inf, "archard.delta": delta, "archard.alpha": alpha, "archard.area": archard_area,
    "archard.segments": archard_segments, "archard.segments_limit": archard_segments_limit,
    "segments.max_half_width": max_half_width,
    "contact.area": contact_area, "contact.exceedance": contact_exceedance, "contact.density": contact_density,
    "segments.count": segments_count, "segments.density": segments_density,
    **dict.fromkeys((f"limit.{name}" for name in "area_constant area_ratio gap scale exceedance force density distance segments".split()),
                    lambda *_: None),
}
