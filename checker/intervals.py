# SPDX-License-Identifier: MIT
"""Directed arithmetic on Python's integers: an interval [low, high] * 2**exponent that contains the true value.

Nothing here is counted by hand: every operation rounds its lower end down and its upper end up, every series carries
its remainder as an interval, and an interval that is too wide only makes a check fail. Standard library only.
"""
from fractions import Fraction
from functools import lru_cache
from math import isqrt


class Interval:
    """[low, high] * 2**exponent with integers low <= high. `bits` is the precision that results are rounded to."""

    bits = 192
    __slots__ = ("low", "high", "exponent")

    def __init__(self, low, high, exponent=0):
        excess = max(low.bit_length(), high.bit_length()) - Interval.bits
        if excess > 0:
            low, high, exponent = low >> excess, -(-high >> excess), exponent + excess
        self.low, self.high, self.exponent = low, high, exponent

    @staticmethod
    def of(value):
        """The smallest interval at hand that contains an integer, a fraction or an interval."""
        if isinstance(value, Interval):
            return value
        if isinstance(value, int):
            return Interval(value, value)
        n, d = value.numerator, value.denominator
        if d & (d - 1) == 0:
            return Interval(n, n, 1 - d.bit_length())
        shift = max(0, Interval.bits + d.bit_length() - n.bit_length() + 1)
        return Interval((n << shift) // d, -((-n << shift) // d), -shift)

    def _aligned(self, other):
        e = min(self.exponent, other.exponent)
        i, j = self.exponent - e, other.exponent - e
        return self.low << i, self.high << i, other.low << j, other.high << j, e

    def __add__(self, other):
        a, b, c, d, e = self._near(Interval.of(other))
        return Interval(a + c, b + d, e)

    def _near(self, other):
        """Aligned ends; what lies far below the other's last bit becomes one unit there, so that no shift grows without bound."""
        far = 4 * Interval.bits
        x, y = self, other
        for small, large in ((x, y), (y, x)):
            size = max(abs(small.low), abs(small.high)).bit_length() + small.exponent
            if (large.low or large.high) and size < large.exponent - far:
                unit = Interval(-1 if small.low < 0 else 0, 1 if small.high > 0 else 0, large.exponent - far)
                x, y = (unit, y) if small is x else (x, unit)
                break
        return x._aligned(y)

    __radd__ = __add__

    def __neg__(self):
        return Interval(-self.high, -self.low, self.exponent)

    def __sub__(self, other):
        return self + -Interval.of(other)

    def __rsub__(self, other):
        return Interval.of(other) + -self

    def __mul__(self, other):
        other = Interval.of(other)
        ends = (self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high)
        return Interval(min(ends), max(ends), self.exponent + other.exponent)

    __rmul__ = __mul__

    def __truediv__(self, other):
        other = Interval.of(other)
        if other.low <= 0 <= other.high:
            raise ZeroDivisionError("an interval that holds 0 as divisor")
        shift = Interval.bits + max(abs(other.low), abs(other.high)).bit_length()
        ends = [(a << shift, d) for a in (self.low, self.high) for d in (other.low, other.high)]
        return Interval(min(a // d for a, d in ends), max(-(-a // d) for a, d in ends), self.exponent - other.exponent - shift)

    def __rtruediv__(self, other):
        return Interval.of(other) / self

    def square(self):
        low, high = abs(self.low), abs(self.high)
        least = 0 if self.low <= 0 <= self.high else min(low, high)
        return Interval(least * least, max(low, high) ** 2, 2 * self.exponent)

    def scaled(self, power):
        """times 2**power, exactly"""
        return Interval(self.low, self.high, self.exponent + power)

    def positive(self):
        """For a quantity known not to be negative."""
        if self.high < 0:
            raise ValueError("a quantity that cannot be negative is")
        return Interval(max(self.low, 0), self.high, self.exponent)

    def ends(self):
        unit = Fraction(2) ** self.exponent
        return self.low * unit, self.high * unit

    def middle(self):
        return (self.low + self.high) * Fraction(2) ** (self.exponent - 1)

    def certainly_positive(self):
        return self.low > 0

    def within(self, low, high):
        """Whether low <= every member <= high, for fractions."""
        mine = self.ends()
        return low <= mine[0] and mine[1] <= high


def error_term(size):
    """[-size, size] for an interval of sizes"""
    top = max(abs(size.low), abs(size.high))
    return Interval(-top, top, size.exponent)


def sqrt(x):
    x = Interval.of(x)
    if x.low < 0:
        raise ValueError("root of an interval that reaches below 0")
    shift = max(0, 2 * Interval.bits - x.low.bit_length())
    shift += (x.exponent - shift) & 1
    low, high = isqrt(x.low << shift), isqrt(x.high << shift)
    return Interval(low, high + (high * high != x.high << shift), (x.exponent - shift) // 2)


def _magnitude(x):
    """e with |x| < 2**e"""
    return max(abs(x.low), abs(x.high)).bit_length() + x.exponent


def _arctan_of_small(t):
    """arctan t for |t| < 1/4: the remainder of the alternating series is at most its next term."""
    if t.low == t.high == 0:
        return t
    square, power, total, k = t.square(), t, t, 1
    while _magnitude(power) > _magnitude(t) - Interval.bits - 4:
        power = -(power * square)
        k += 2
        total = total + power / k
    return total + error_term(power * square)


def arctan(t):
    """for 0 <= t <= 1 or so: arctan t = 2 arctan(t/(1 + sqrt(1 + t^2)))"""
    halvings = 6 if Interval.bits < 1000 else 20
    for _ in range(halvings):
        t = t / (1 + sqrt(1 + t.square()))
    return _arctan_of_small(t).scaled(halvings)


@lru_cache(maxsize=None)
def _pi(bits):
    machin = _arctan_of_small(Interval.of(Fraction(1, 5))).scaled(2) - _arctan_of_small(Interval.of(Fraction(1, 239)))
    return machin.scaled(2)


def pi():
    return _pi(Interval.bits)


def angle(y, x):
    """The angle of the point (x, y), x >= 0, y >= 0, not both 0."""
    x, y = Interval.of(x), Interval.of(y)
    if y.middle() <= x.middle():
        return arctan(y / x)
    return pi().scaled(-1) - arctan(x / y)


def _two_artanh(z):
    """2 artanh z = log((1 + z)/(1 - z)) for |z| <= 1/2: the tail is below the last power over 1 - z^2 < 4/3."""
    if z.low == z.high == 0:
        return z
    square, power, total, k = z.square(), z, z, 1
    while _magnitude(power) > _magnitude(z) - Interval.bits - 4:
        power = power * square
        k += 2
        total = total + power / k
    return (total + error_term(power * square * 2)).scaled(1)


@lru_cache(maxsize=None)
def _log_2(bits):
    return _two_artanh(Interval.of(Fraction(1, 3)))


def log(x):
    """x > 0; accurate relative to the result, next to x = 1 too."""
    x = Interval.of(x)
    if x.low <= 0:
        raise ValueError("logarithm of an interval that reaches 0")
    power = x.high.bit_length() + x.exponent  # x < 2**power
    x = x.scaled(-power)
    if x.high * 4 < 3 << -x.exponent if x.exponent < 0 else False:  # x < 3/4
        x, power = x.scaled(1), power - 1
    roots = isqrt(Interval.bits) // 2 if Interval.bits > 512 else 0  # of many digits the series is the dear part
    for _ in range(roots):
        x = sqrt(x)
    result = _two_artanh((x - 1) / (x + 1)).scaled(roots)
    return result + _log_2(Interval.bits) * power if power else result


def exp(x):
    """by x = k log 2 + r and halvings of r; the tail of the series is at most twice its last term"""
    x = Interval.of(x)
    k = round(x.middle() / Fraction(7050, 10171)) if _magnitude(x) > -2 else 0
    r = x - _log_2(Interval.bits) * k if k else x
    halvings = 8
    r = r.scaled(-halvings)
    total, term, j = Interval.of(1) + r, r, 1
    while _magnitude(term) > -Interval.bits - 16 and not (term.low == term.high == 0):
        j += 1
        term = term * r / j
        total = total + term
    total = total + error_term(term * 2)
    for _ in range(halvings):
        total = total.square()
    return total.scaled(k)


def power(x, y):
    return exp(Interval.of(y) * log(x))


def _sine(t):
    """|t| <= 1: the remainder of the alternating series is at most its next term"""
    square, term, total, k = t.square(), t, t, 1
    while _magnitude(term) > _magnitude(t) - Interval.bits - 4 and not (term.low == term.high == 0):
        term = -(term * square) / ((k + 1) * (k + 2))
        k += 2
        total = total + term
    return total + error_term(term * square)


def sin_pi(x):
    """sin(pi x) for a fraction x: reduced exactly, so that the result is accurate relative to itself."""
    x = x % 2
    sign = 1
    if x >= 1:
        x, sign = x - 1, -1
    if x > Fraction(1, 2):
        x = 1 - x
    if x > Fraction(1, 4):
        half = _sine(pi() * (Fraction(1, 2) - x).__mul__(Fraction(1, 2)))  # cos(pi r) = 1 - 2 sin^2(pi r/2)
        return (1 - half.square().scaled(1)) * sign
    return _sine(pi() * x) * sign if x else Interval.of(0)


def cos_pi(x):
    return sin_pi(x + Fraction(1, 2))
