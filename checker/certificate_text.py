# SPDX-License-Identifier: MIT
"""What a TOUCHSTONE-CERT 1 is as a text (docs/certificate.md): numbers, names, claims, sections and counts. Nothing is proved here."""
import hashlib
import re
from fractions import Fraction

LONGEST_FILE, LONGEST_WORD, MOST_DEGREE = 1 << 28, 4096, 64  # the degree of a root G
INTEGER = {10: re.compile("0|-?[1-9][0-9]*"), 16: re.compile("0|-?[1-9a-f][0-9a-f]*")}  # a long certificate has millions
MOST = {"claims": 20000, "scale": 64, "sections": 1000, "lines": 200000, "bits": 2048, "points": 50000, "terms": 400, "n": 64, "m": 64,
        "exponent": 1 << 14, "kept": 1024, "accuracy": 100, "rise": 1024, "power": 200}


class Malformed(Exception):
    """Not a certificate."""


def need(holds, why, kind=Malformed):
    if not holds:
        raise kind(why)


def integer(text, base=16):
    if not (len(text) < (LONGEST_WORD if base == 16 else 10) and INTEGER[base].fullmatch(text)):
        raise Malformed(f"'{text[:40]}' is no integer")
    return int(text, base)


def decimal(text):
    return integer(text, 10)


def dyadic(text):
    """mantissa:exponent, the mantissa odd, or 0:0"""
    m, _, e = text.partition(":")
    m, e = integer(m), decimal(e)
    need((m % 2 or m == e == 0) and abs(e) <= MOST["exponent"], f"'{text[:40]}' is no dyadic number")
    return m * Fraction(2) ** e


def rational(text):
    need(re.fullmatch("[1-9][0-9]{0,999}(/[1-9][0-9]{0,999})?", text), f"'{text[:40]}' is no positive rational number")
    need(str(Fraction(text)) == text, f"'{text[:40]}' is not in lowest terms")
    return Fraction(text)


def surface(text):
    """G as base, degree: base^(1/degree)"""
    base, mark, degree = text.partition("^1/")
    degree = decimal(degree) if mark else 1
    need(1 + bool(mark) <= degree <= MOST_DEGREE, f"'{text[:40]}' is no root")
    return rational(base), degree


def span(text):
    first, mark, last = text.partition("-")
    return decimal(first), decimal(last) if mark else decimal(first)


READERS = {"G": surface, "p": lambda text: 0 if text == "0" else rational(text), "a": rational, "load": rational, "tolerance": rational,
           "span": span, **dict.fromkeys("step low high rho value error centre radius".split(), dyadic),
           **dict.fromkeys("n scale m bits points terms kept accuracy rise aim panel middle half".split(), integer)}
FORMS = {"grid": "G bits step points", "panel": "low high terms rho", "level": "m error exponent", "value": "claim",
         "limit": "claim m exponent", "mesh": "G p scale load bits kept accuracy rise", "polynomials": "panel middle half terms aim",
         "share": "claim", "law": "G load bits", "piece": "m low high centre radius power exponent error", "reading": "claim",
         "steady": "G bits", "part": "low high centre radius power exponent", "balance": "part error", "tending": "claim",
         "settling": "claim m", "eigenvalue": "claim high centre radius exponent", "mean": "value error", "quotient": "claim"}
COUNTED = dict(zip(FORMS, "grids panels levels values limits meshes polynomials shares laws pieces readings steadies parts balances "
                          "tendings settlings eigenvalues means quotients".split()))
WITH_INTEGERS = ("level", "limit", "mesh", "polynomials", "piece", "part", "eigenvalue")
PROVES_A_CLAIM = ("value", "limit", "share", "reading", "tending", "settling", "eigenvalue", "quotient")
CLAIMS = {"contact.area": "n load G value error", "contact.exceedance": "n p load G value error", "limit.area_constant": "G value error",
          "contact.density": "n p load G value error", "segments.density": "n a load G value error",
          "limit.exceedance": "p G value error", "limit.force": "p G value error", "limit.density": "p G value error",
          "limit.segments": "a G value error", "limit.distance": "n p load G value error",
          "limit.scale": "load tolerance G value error", "limit.gap": "G value error"}
QUOTIENTS = "limit.density limit.exceedance limit.force limit.segments"


def fields(words, names, what):
    """the values of NAME=TEXT, these names in this order"""
    need([w.partition("=")[0] for w in words] == names.split(), f"{what}: is not '{names}'")
    values = [READERS.get(n, decimal)(w.partition("=")[2]) for n, w in zip(names.split(), words)]
    for n, v in zip(names.split(), values):
        need(n not in MOST or abs(v) <= MOST[n], f"{what}: {n} is too large")
    return values


def text_of(path):
    try:
        with open(path, "rb") as file:
            return file.read(LONGEST_FILE).decode("ascii")
    except (OSError, UnicodeDecodeError) as reason:
        raise Malformed(str(reason)) from None


class Certificate:
    """The text, held against its own counts."""

    def __init__(self, path):
        body, _, last = text_of(path).rpartition("sha256 ")
        self.digest = hashlib.sha256(body.encode()).hexdigest()
        need(last == self.digest + "\n", "the last line is not the sha256 of the lines before it")
        lines = body.split("\n")
        need(lines.pop() == "" and len(lines) > 3, "lines are missing")
        need(lines[0] == "TOUCHSTONE-CERT 1", f"'{lines[0][:40]}' is not TOUCHSTONE-CERT 1")
        self.quantity = lines[1][len("quantity "):]
        need(lines[1][:9] == "quantity " and self.quantity in CLAIMS, f"'{lines[1][:40]}': only {' and '.join(CLAIMS)} are known")
        words = lines[2].split(" ")
        claims, sections, self.count = fields(words[1:], "claims sections lines", "counts")
        head = 3 + claims + sections
        need(words[0] == "counts" and min(claims, sections, self.count) > 0 and self.count == len(lines) - head,
             "counts: are not those of the lines")
        self.lines, self.claims, next_line, number = [line.split(" ") for line in lines[head:]], {}, 1, 0
        for line in lines[3:head]:
            kind, which, *rest = line.split(" ") if line.count(" ") > 1 else ("", "", "")
            if kind == "claim":
                *inputs, G, value, error = fields(rest, CLAIMS[self.quantity], "claim")
                self.claims[decimal(which)] = *inputs, G, value, error
                size = abs(value) if self.quantity == "limit.distance" else value
                need(list(self.claims)[-1] == len(self.claims) and (inputs or [1])[0] > 0 and size > error >= 0,
                     f"claim {which[:9]}: is none")
                continue
            (first, last), = fields(rest[:1], "span", "section")
            found = [w[1] if len(w) > 1 else "" for w in self.lines[first - 1:last]]
            number += 1
            need(kind == "section" and decimal(which) == number and first == next_line <= last, "sections: do not follow one another")
            counts = [f"{many}={found.count(reason)}" for reason, many in COUNTED.items() if reason in found]
            need(rest[1:] == counts and {*found} <= {*FORMS}, f"section {which}: counts are not those of its lines")
            next_line = last + 1
        need(len(self.claims) == claims and number == sections and next_line == self.count + 1, "sections or claims are missing")
