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
        excess = (high if low >= 0 or high > -low else low).bit_length() - Interval.bits
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

    def __add__(self, other):
        x, y = self, other if type(other) is Interval else Interval.of(other)
        if x.exponent > y.exponent:
            x, y = y, x
        up, most = y.exponent - x.exponent, 4 * Interval.bits
        if up > most and (y.low or y.high):  # x is far below the last bit of y: it is rounded there, so that no shift grows without bound
            x, up = Interval(x.low >> up - most, -(-x.high >> up - most), y.exponent - most), most
        return Interval(x.low + (y.low << up), x.high + (y.high << up), x.exponent)

    __radd__ = __add__

    def __neg__(self):
        return Interval(-self.high, -self.low, self.exponent)

    def __sub__(self, other):
        other = other if type(other) is Interval else Interval.of(other)
        return self + Interval(-other.high, -other.low, other.exponent)

    def __rsub__(self, other):
        return Interval.of(other) + -self

    def __mul__(self, other):
        other = other if type(other) is Interval else Interval.of(other)
        if self.low >= 0 and other.low >= 0:
            return Interval(self.low * other.low, self.high * other.high, self.exponent + other.exponent)
        ends = (self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high)
        return Interval(min(ends), max(ends), self.exponent + other.exponent)

    __rmul__ = __mul__

    def __truediv__(self, other):
        other = other if type(other) is Interval else Interval.of(other)
        if other.low <= 0 <= other.high:
            raise ZeroDivisionError("an interval that holds 0 as divisor")
        shift = Interval.bits + max(abs(other.low), abs(other.high)).bit_length()
        if self.low >= 0 and other.low > 0:
            exponent = self.exponent - other.exponent - shift
            return Interval((self.low << shift) // other.high, -((-self.high << shift) // other.low), exponent)
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

    def ends(self):
        up, unit = max(0, self.exponent), 1 << max(0, -self.exponent)
        return Fraction(self.low << up, unit), Fraction(self.high << up, unit)

    def middle(self):
        return (self.low + self.high) * Fraction(2) ** (self.exponent - 1)


def hull(x, y):
    e = min(x.exponent, y.exponent)
    (a, b), (c, d) = ((z.low << z.exponent - e, z.high << z.exponent - e) for z in (x, y))
    return Interval(min(a, c), max(b, d), e)


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


def _series(first, following):
    """first + following(first, 1) + following of that and 2 + ...: of each series here what is left out is at most twice the last term"""
    total, term, k = first, first, 0
    while (term.low or term.high) and _magnitude(term) > _magnitude(first) - Interval.bits - 16:
        k += 1
        term = following(term, k)
        total = total + term
    return total + error_term(term.scaled(1))


def _arctan_or_artanh(t, sign):
    """t + sign t^3/3 + t^5/5 + sign t^7/7 ...: artanh t, or with sign = -1 arctan t, |t| <= 1/2"""
    if (t.low or t.high) and _magnitude(t) > -1:
        raise ValueError("an interval too wide for a series")
    square = t.square() * sign
    return _series(t, lambda term, k: term * square * (2 * k - 1) / (2 * k + 1))


def _sine(t):
    """|t| <= 1"""
    square = -t.square()
    return _series(t, lambda term, k: term * square / (2 * k * (2 * k + 1)))


def arctan(t):
    """for 0 <= t <= 1 or so: arctan t = 2 arctan(t/(1 + sqrt(1 + t^2)))"""
    halvings = 6 if Interval.bits < 1000 else 20
    for _ in range(halvings):
        t = t / (1 + sqrt(1 + t.square()))
    return _arctan_or_artanh(t, -1).scaled(halvings)


@lru_cache(maxsize=None)
def _pi(bits):
    of_fifth, rest = (_arctan_or_artanh(Interval.of(Fraction(1, n)), -1) for n in (5, 239))
    return (of_fifth.scaled(2) - rest).scaled(2)


def pi():
    return _pi(Interval.bits)


def angle(y, x):
    """The angle of the point (x, y), x >= 0, y >= 0, not both 0."""
    x, y = Interval.of(x), Interval.of(y)
    if y.middle() <= x.middle():
        return arctan(y / x)
    return pi().scaled(-1) - arctan(x / y)


@lru_cache(maxsize=None)
def _log_2(bits):
    return _arctan_or_artanh(Interval.of(Fraction(1, 3)), 1).scaled(1)


CELLS = 64  # of the table of logarithms


@lru_cache(maxsize=None)
def _log_of_cell(bits, cell):
    return _log_of_ratio(Interval.of(cell), CELLS) if cell != CELLS else Interval.of(0)


def _log_of_ratio(x, c):
    """log(x/c) = 2 artanh((x - c)/(x + c)), c/3 <= x <= 3c"""
    return _arctan_or_artanh((x - c) / (x + c), 1).scaled(1)


def log(x):
    """x > 0; accurate relative to the result, to 512 bits next to x = 1 too."""
    x = Interval.of(x)
    if x.low <= 0:
        raise ValueError("logarithm of an interval that reaches 0")
    if 2 * x.low < x.high:  # so wide that the series would end too soon; log increases
        return hull(*(log(Interval(end, end, x.exponent)) for end in (x.low, x.high)))
    power = x.high.bit_length() + x.exponent  # x < 2**power
    x = x.scaled(-power)
    if x.high * 4 < 3 << -x.exponent if x.exponent < 0 else False:  # x < 3/4
        x, power = x.scaled(1), power - 1
    if Interval.bits > 512:  # of many digits the series is the dear part
        roots = isqrt(Interval.bits) // 2
        for _ in range(roots):
            x = sqrt(x)
        result = _log_of_ratio(x, 1).scaled(roots)
    else:
        x = x.scaled(CELLS.bit_length() - 1)
        cell = (2 * x.high >> -x.exponent if x.exponent < 0 else 2 * x.high << x.exponent) + 1 >> 1  # the nearest: next to 1 it is CELLS
        result = _log_of_ratio(x, cell) + _log_of_cell(Interval.bits, cell)
    return result + _log_2(Interval.bits) * power if power else result


def exp(x):
    """by x = k log 2 + r and halvings of r"""
    x = Interval.of(x)
    k = round(x.middle() / Fraction(7050, 10171)) if _magnitude(x) > -2 else 0
    halvings = 8
    r = (x - _log_2(Interval.bits) * k if k else x).scaled(-halvings)
    total = _series(Interval.of(1), lambda term, j: term * r / j)
    for _ in range(halvings):
        total = total.square()
    return total.scaled(k)


def power(x, y):
    return exp(Interval.of(y) * log(x))


def sin_pi(x):
    """sin(pi x) for a fraction x: reduced exactly, so that the result is accurate relative to itself."""
    x = x % 2
    sign = 1
    if x >= 1:
        x, sign = x - 1, -1
    if x > Fraction(1, 2):
        x = 1 - x
    if x > Fraction(1, 4):
        half = _sine(pi() * (Fraction(1, 2) - x) / 2)  # cos(pi r) = 1 - 2 sin^2(pi r/2)
        return (1 - half.square().scaled(1)) * sign
    return _sine(pi() * x) * sign if x else Interval.of(0)
