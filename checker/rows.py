# SPDX-License-Identifier: MIT
"""Files of rows, which `touchstone eval` writes of inputs of one's own: inputs as they were typed, value, error, and after # the status.

What is certified has all the digits of the header and is the true value rounded as it says; what is exact has an error of 0, and no more
digits. An estimate and what is undecided promise no digits: they are open, or wrong if the value is further off than their error. A refused
row has no value. The header has to be true of its rows; its version is not looked at, nor can `complete` be: rows that are not there are
not missed.
"""
import collections
import hashlib
import json
import os
import re
from fractions import Fraction
from math import ceil, floor, isfinite, trunc

import closed_forms
import intervals as iv
import units
from exact_text import TooLarge, exact, power
from table_text import Unreadable, json_of

FIRST = "# Touchstone values of "
ROW = re.compile(r"((?:[!\"$-~]+ )+)# (exact|certified|estimated|undecided|refused)(: .*)?")
CONTROL = re.compile("[\0-\t\v-\x1f\x7f-\x9f\u2028\u2029\udc80-\udc9f]")  # what ends a line to some readers too, and such bytes where they are no UTF-8
MOST_DIGITS = 10000
BINARY64 = re.compile(r"-?[0-9]{1,400}(\.[0-9]{1,400})?(e[-+]?[0-9]{1,3})?")
STATUSES = "exact certified estimated undecided refused".split()  # the weakest last
ROUNDED = {"nearest": ("to nearest", round), "up": ("up", ceil), "down": ("down", floor), "zero": ("towards zero", trunc),
           "away": ("away from zero", lambda x: ceil(x) if x > 0 else floor(x))}  # to an integer
FORMATS = {"exact": "Inputs are exact: 0.1 is 1/10.",
           "binary64": "Inputs are binary64 numbers in shortest round-trip decimal: each stands for the binary64 number it rounds to."}
KIND = "name quantity equation unit description inputs input_format digits rounding version".split()
SUM = "rows status statuses complete sha256".split()  # in a file that was written as rows came, below them


def words(header):
    """the lines above the JSON"""
    return [FIRST + header["quantity"], f"# {header['description']}; equation {header['equation']}; unit {header['unit']}",
            f"# {FORMATS[header['input_format']]}",
            f"# value: the true value rounded {ROUNDED[header['rounding']][0]}, {header['digits']} significant digits (fewer if exact). "
            "error: bound of |value - true value|. After #: the row's status;",
            "# exact and certified are proven, estimated is not (nor is its error), undecided and refused say why."]


def read(path, text, names_of):
    """header and rows"""
    *lines, end = text.split("\n")
    try:
        if CONTROL.search(text.encode("latin-1").decode("utf-8", "surrogateescape")):
            raise ValueError("has control characters")
        if end or len(lines) < 7 or not lines[5].startswith("# {"):
            raise ValueError("lines are missing")
        header, rows = json_of(lines[5][2:]), lines[7:]
        if "sha256" not in header:
            if not rows or not rows[-1].startswith("# {"):
                raise ValueError("broken off: what sums up its rows is missing")
            said = json_of(rows.pop()[2:])
            if [*said] != SUM:
                raise ValueError("the line below its rows is no summary")
            header |= said
        if [*header] != KIND + SUM:
            raise ValueError(f"its JSON has not {' '.join(KIND + SUM)}")
        quantity, inputs = header["quantity"], header["inputs"]
        if (header["equation"], header["unit"], header["description"]) != units.SAID[quantity] or header["name"] != "own rows":
            raise ValueError(f"equation, unit and description of {quantity} are others")
        names = names_of(quantity)
        if inputs not in (names, names[:-1] + ["D", "gamma"]) or inputs != names and names[-1:] != ["G"]:
            raise ValueError(f"the inputs of {quantity} are {' '.join(names)}")
        if type(header["digits"]) is not int or not 1 <= header["digits"] <= MOST_DIGITS or type(header["complete"]) is not bool:
            raise ValueError("digits or complete are none")
        if lines[:5] != (right := words(header)) or lines[6] != f"# {' '.join(inputs)} value error":
            raise ValueError(f"the lines around its JSON are not {right}, nor its columns {' '.join(inputs)} value error")
        if hashlib.sha256("".join(row + "\n" for row in rows).encode("latin-1")).hexdigest() != header["sha256"]:
            raise ValueError("sha256 of the rows is not the header's")
        found = [ROW.fullmatch(row) for row in rows]
        for number, parts in enumerate(found, 1):
            if not parts or len(parts[1].split()) != len(inputs) + 2 or (parts[3] is not None) != (parts[2] in ("undecided", "refused")):
                raise ValueError(f"row {number} is not {len(inputs) + 2} columns, # and a status")
        count = collections.Counter(parts[2] for parts in found)
        weakest = max(count, key=STATUSES.index, default="exact")
        true, said = [len(rows), weakest, count], [header[key] for key in SUM[:3]]
        if json.dumps(true, sort_keys=True) != json.dumps(said, sort_keys=True):
            raise ValueError(f"rows, status and statuses are {json.dumps(true)}")
    except (ValueError, KeyError, TypeError, RecursionError) as reason:
        raise Unreadable(f"{path}: a file of rows: {reason}") from None
    return header, rows


def with_roots(quantity, form, known, domain):
    """the form of a quantity, whose last input G may be base, degree: closed forms take it as an interval, claims have it so"""
    def of(*inputs):
        if not inputs or not isinstance(inputs[-1], tuple):
            return form(*inputs)
        *others, (base, degree) = inputs
        domain(*others, base)
        try:
            true = closed_forms.FORMS[quantity](*others, iv.power(base, Fraction(1, degree)))
        except TypeError:  # what compares G, or counts with its powers, takes fractions only
            true = None
        return known.get((quantity, *inputs)) if true is None else true
    return of


def inputs_of(cells, header, within_surface):
    """fractions, but of G perhaps base, degree; ValueError: no numbers that the quantity takes"""
    if header["input_format"] == "binary64":
        if not all(BINARY64.fullmatch(cell) and isfinite(float(cell)) for cell in cells):
            raise ValueError("not a binary64 number")
        found = [(Fraction(float(cell)), 1) for cell in cells]
    else:
        found = [exact(cell) for cell in cells]
    if any(degree > 1 and name != "G" for name, (_, degree) in zip(header["inputs"], found)):
        raise TooLarge  # the program takes none, but for some that are fractions
    if within_surface:
        D, gamma = (base for base, _ in found[-2:])
        within_surface(D, gamma)
        found[-2:] = [power((gamma, 1), D - 1)]
    return [base if degree == 1 else (base, degree) for base, degree in found]


def opened(path, text, forms, known, names_of, within_domain, verdict):
    """as in check.py, whose functions the last three are"""
    header, rows = read(path, text, names_of)
    quantity, digits = header["quantity"], header["digits"]
    form = with_roots(quantity, within_domain(quantity, forms[quantity]), known, within_domain(quantity, nothing))
    within_surface = within_domain("weierstrass.bound", nothing) if header["inputs"] != names_of(quantity) else None

    def judge(row):
        parts = ROW.fullmatch(row)
        (*cells, value, error), status = parts[1].split(), parts[2]
        if status == "refused" or (status, value, error) == ("undecided", "nan", "inf"):
            return ("open" if (value, error) == ("nan", "inf") else "wrong"), 0
        if status in ("exact", "certified") and (error == "0") != (status == "exact"):
            return "wrong", 0
        if status == "certified" and len(re.sub("[eE].*|[-+.]", "", value).lstrip("0")) != digits:
            return "wrong", 0

        def of_inputs():
            try:
                return form(*inputs_of(cells, header, within_surface))
            except TooLarge:
                return None
        proven = (digits, ROUNDED[header["rounding"]][1]) if status in ("exact", "certified") else ()
        said, right_to = verdict(of_inputs, f"{value} {error}", [], *proven)
        return ("open", 0) if status in ("estimated", "undecided") and said not in ("wrong", "unreadable") else (said, right_to)
    return os.path.basename(path), header, rows, judge


def nothing(*_):
    """a form, where only the domain counts"""
