# SPDX-License-Identifier: MIT
"""Certified reference tables in any Python test suite: copy this one file, nothing else is needed.

    import touchstone_reference as ref

    def test_half_width():
        table = ref.load("westergaard_half_width.txt")
        assert not table.failing(my_half_width)                            # 4 ulps, beyond what rounded inputs force
        assert not table.failing(my_half_width, rtol=1e-9, where=lambda load: load < 1)

Arithmetic is exact (fractions.Fraction), so an error in ulps is the true one to within the table's own
proven bound. If numpy is there, `table.columns()` gives arrays.
"""
import hashlib
import json
import math
import re
from fractions import Fraction


# what an exact number is made of in a table; one with a longer exponent would be millions of digits
DECIMAL = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d{1,4})?")


class CorruptTable(ValueError):
    """The file is not a canonical table, or not the one its hash says it is."""


def ulp_at(value):
    """The distance of binary64 numbers at a Fraction: 2^(e-52) for 2^e <= |value| < 2^(e+1), at least 2^-1074."""
    value = abs(value)
    if value < Fraction(2) ** -1022:
        return Fraction(2) ** -1074
    e = value.numerator.bit_length() - value.denominator.bit_length()
    if Fraction(2) ** e > value:
        e -= 1
    return Fraction(2) ** (min(e, 1023) - 52)


def ulps(answer, value, error):
    """(least, most) with least <= |answer - true value| <= most in ulps; value +- error is a table's row, as text or numbers.

    Infinite for nan, for an infinity where the value is finite, and where the true value is 0 and the answer is not.
    """
    value, error = Fraction(value), Fraction(error)
    if not math.isfinite(answer):
        try:
            right = float(value) == answer
        except OverflowError:
            right = math.copysign(1, answer) == (1 if value > 0 else -1) and not math.isnan(answer)
        return (0.0, 0.0) if right else (math.inf, math.inf)
    distance = abs(Fraction(answer) - value)
    if value == 0 and error == 0:
        return (0.0, 0.0) if distance == 0 else (math.inf, math.inf)
    unit = ulp_at(value)
    return (float(max(distance - error, 0) / unit), float((distance + error) / unit))


ulps_of = ulps


def within(answer, row, rtol, atol, ulps, forgive_inputs):
    """Whether an answer is within its tolerances, or not certainly beyond them."""
    value, error = Fraction(row.value), Fraction(row.error)
    if not math.isfinite(answer):
        return ulps_of(answer, value, error)[0] == 0
    forced = Fraction(row.forced) if forgive_inputs and row.forced else Fraction(0)
    off = max(abs(Fraction(answer) - value) - error, 0)
    if value == 0 and error == 0:
        return off <= Fraction(atol) + forced
    unit = ulp_at(value)
    return off <= max(Fraction(ulps) * unit, Fraction(atol) + Fraction(rtol) * abs(value)) + forced * unit


ESTIMATED_MARGIN = 4  # on `forced` of a table whose header says that it is estimated, as in `touchstone judge`


class Row:
    """`forced`: ulps (absolute where the value is 0) that rounding each input once can cost any code, four times the column where the
    table's header calls that estimated; None: not known."""

    def __init__(self, inputs, value, error, forced=None):
        self.inputs, self.value, self.error, self.forced = inputs, value, error, forced

    @property
    def nearest(self):
        """The value rounded to the nearest binary64 number."""
        return float(self.value)


class Worst:
    """The row on which a code is farthest off."""

    def __init__(self, row, answer, least):
        self.row, self.answer, self.ulps = row, answer, least

    def __repr__(self):
        inputs = " ".join(x.hex() for x in self.row.inputs)
        return f"inputs {inputs}, answer {float(self.answer).hex()}, error {self.ulps:.3g} ulps, true value {self.row.value}"


class Table:
    def __init__(self, header, rows):
        self.header, self.rows = header, rows
        self.name, self.quantity, self.inputs = header["name"], header["quantity"], header["inputs"]

    def worst(self, function):
        """Calls function(*inputs) for each row."""
        worst = None
        for row in self.rows:
            answer = function(*row.inputs)
            least = ulps(answer, row.value, row.error)[0]
            if worst is None or least > worst.ulps:
                worst = Worst(row, answer, least)
        return worst

    def failing(self, function, *, rtol=0.0, atol=0.0, ulps=4.0, where=None, forgive_inputs=True):
        """All rows, as Worst, on which |function(*inputs) - value| is certainly more than atol + rtol |value| and more than `ulps`
        units in the last place, each beyond what the rounding of the inputs forces. `where(*inputs)` chooses rows."""
        wrong = []
        for row in self.rows:
            if where is not None and not where(*row.inputs):
                continue
            answer = float(function(*row.inputs))
            if not within(answer, row, rtol, atol, ulps, forgive_inputs):
                wrong.append(Worst(row, answer, ulps_of(answer, row.value, row.error)[0]))
        return wrong

    def columns(self):
        """The inputs and the nearest values as numpy arrays, by name."""
        import numpy

        names = self.inputs + ["value"]
        data = [[*row.inputs, row.nearest] for row in self.rows]
        return dict(zip(names, numpy.array(data).T))


def _header(text, file):
    """The JSON of a table's header, with what is asked of it."""
    try:
        header = json.loads(text)
        right = all(isinstance(header[key], kind) for key, kind in (("name", str), ("quantity", str), ("inputs", list), ("rows", int), ("sha256", str)))
    except (ValueError, KeyError, TypeError, RecursionError):
        right = False
    if not right:
        raise CorruptTable(f"{file}: no JSON header with name, quantity, inputs, rows and sha256")
    return header


def load(file):
    """Reads a canonical table; checks its form and its SHA-256."""
    with open(file, encoding="ascii") as f:
        text = f.read()
    lines = text.splitlines(keepends=True)
    header = None
    for first, line in enumerate(lines):
        if not line.startswith("#"):
            break
        if line.startswith("# {"):
            header = _header(line[2:], file)
    else:
        raise CorruptTable(f"{file}: no rows")
    body = "".join(lines[first:])
    if header is None or hashlib.sha256(body.encode()).hexdigest() != header["sha256"]:
        raise CorruptTable(f"{file}: the rows do not have the SHA-256 that the header gives")
    given = len(header["inputs"])
    columns = given + (3 if lines[first - 1].split()[-1] == "forced" else 2)
    margin = ESTIMATED_MARGIN if header.get("forced") == "estimated" else 1
    rows = []
    for number, line in enumerate(lines[first:], first + 1):
        words = line.split()
        if len(words) != columns:
            raise CorruptTable(f"{file}:{number}: {len(words)} columns where {columns} are right")
        if not all(DECIMAL.fullmatch(w) for w in words[given : given + 2]):
            raise CorruptTable(f"{file}:{number}: value and error are not decimal numbers: {line.strip()}")
        try:
            inputs = tuple(float(w) for w in words[:given])
            value, error = Fraction(words[given]), Fraction(words[given + 1])
            forced = float(words[given + 2]) if columns == given + 3 else -1.0
        except ValueError:
            raise CorruptTable(f"{file}:{number}: not numbers: {line.strip()}") from None
        if error < 0 or not all(map(math.isfinite, (*inputs, forced))) or (forced < 0 and forced != -1):
            raise CorruptTable(f"{file}:{number}: not a row of finite numbers: {line.strip()}")
        del value
        rows.append(Row(inputs, words[given], words[given + 1], None if forced < 0 else margin * forced))
    if len(rows) != header["rows"]:
        raise CorruptTable(f"{file}: {len(rows)} rows where the header says {header['rows']}")
    return Table(header, rows)
