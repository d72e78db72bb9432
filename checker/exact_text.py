# SPDX-License-Identifier: MIT
"""A number as somebody typed it, read exactly: 0.1 is 1/10, and 0x1.8p-3, 2/3, 2^-5, 10^(1/2) and 3/sqrt(2) are what they say.

    product = ["-" | "+"] power {("*" | "/") power}
    power   = base ["^" exponent]        exponent = ["-" | "+"] power (so that 2^3^2 = 2^9)
    base    = number | "(" product ")" | "sqrt(" product ")"

A number is base, degree, and means base^(1/degree); the base of a root is positive. Degrees are brought down by square roots alone: what is
left may be a fraction all the same, as 8^(1/3), and is then worked with as if it were none.
"""
import re
from fractions import Fraction
from math import lcm

from closed_forms import root

DECIMAL = re.compile(r"([0-9]*)(?:\.([0-9]*))?(?:[eE]([-+]?[0-9]{1,7}))?")
HEXADECIMAL = re.compile(r"0[xX]([0-9a-fA-F]*)(?:\.([0-9a-fA-F]*))?(?:[pP]([-+]?[0-9]{1,7}))?")
DEEPEST = 50          # as the program has it
MOST_BITS = 1 << 19   # of a fraction: beyond, arithmetic on it takes seconds
MOST_DEGREE = 64
LONGEST = 20000        # characters


class TooLarge(Exception):
    """A number that is one, and more than is worked with here."""


def power(number, exponent):
    """of what is not negative, or of a fraction to the power of an integer"""
    base, degree = number
    exponent = Fraction(exponent)
    if base == 0 and exponent > 0:
        return base, 1
    if base <= 0 and (exponent.denominator > 1 or base == 0):
        raise ValueError("a power that is none")
    degree *= exponent.denominator
    if degree > MOST_DEGREE or abs(exponent.numerator) * max(base.numerator.bit_length(), base.denominator.bit_length()) > MOST_BITS:
        raise TooLarge
    base **= exponent.numerator
    while degree % 2 == 0 and isinstance(root(base), Fraction):
        base, degree = root(base), degree // 2
    return base, 1 if base == 1 else degree


def times(x, y):
    common = lcm(x[1], y[1])
    if sum(part.bit_length() for base, _ in (x, y) for part in (base.numerator, base.denominator)) > MOST_BITS:
        raise TooLarge
    if common == 1:
        return x[0] * y[0], 1
    if min(x[0], y[0]) <= 0:
        raise TooLarge  # the negative of a root, or 0
    product = power((x[0], 1), common // x[1])[0] * power((y[0], 1), common // y[1])[0]
    return power((product, 1), Fraction(1, common))


class Reader:
    def __init__(self, text):
        self.text, self.at, self.depth = text, 0, 0

    def take(self, word):
        found = self.text.startswith(word, self.at)
        self.at += len(word) if found else 0
        return found

    def sign(self):
        return -1 if self.take("-") else self.take("+") or 1

    def product(self):
        sign, value = self.sign(), self.power()
        while True:
            if self.take("*"):
                value = times(value, self.power())
            elif self.take("/"):
                value = times(value, power(self.power(), -1))
            else:
                return value if sign > 0 else times((Fraction(-1), 1), value)

    def power(self):
        self.depth += 1
        if self.depth > DEEPEST:
            raise ValueError("too deep")
        value = self.base()
        if self.take("^"):
            sign, (exponent, degree) = self.sign(), self.power()
            if degree > 1:
                raise ValueError("an exponent that is no fraction")
            value = power(value, sign * exponent)
        self.depth -= 1
        return value

    def base(self):
        of_root = self.take("sqrt(")
        if not of_root and not self.take("("):
            return self.number(), 1
        value = self.product()
        if not self.take(")"):
            raise ValueError("a bracket is open")
        return value if not of_root or value[0] == 0 else power(value, Fraction(1, 2))

    def number(self):
        hexadecimal = HEXADECIMAL.match(self.text, self.at)
        whole, decimals, exponent = (found := hexadecimal or DECIMAL.match(self.text, self.at)).groups(default="")
        if not whole + decimals:
            raise ValueError("not a number")
        self.at, exponent = found.end(), int(exponent or 0)
        radix, unit, digits = (16, 2, 4 * len(decimals)) if hexadecimal else (10, 10, len(decimals))
        if 4 * (abs(exponent) + len(whole + decimals)) > MOST_BITS:
            raise TooLarge
        return int(whole + decimals, radix) * Fraction(unit) ** (exponent - digits)


def exact(text):
    """base, degree; ValueError: it is no number"""
    if len(text) > LONGEST:
        raise TooLarge
    reader = Reader(text)
    value = reader.product()
    if reader.at < len(text):
        raise ValueError("not a number")
    return value
