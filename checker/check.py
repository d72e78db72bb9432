#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check.py [--limit N] [--certificate FILE]... [--coverage FILE] TABLE...: recomputes every row of closed form in canonical tables, and in
files of rows (rows.py), and says how many it confirms.

A row is confirmed if |true value - printed value| <= printed error is proved in the directed arithmetic of intervals.py, of a certified
one also that the true value, rounded to its digits, is what is printed, and an error of 0 only if the value is found to be exactly that.
What the recursion gives is confirmed by certificates too, which are proved first (certificate.py). `digits` are confirmed in every row
that is right or has a certificate. --coverage keeps, for `touchstone table`, what was found of each table, with the sha256 of its rows.
Exit code 0: no row is wrong; 1: one is; 65: unreadable.
"""
import argparse
import hashlib
import inspect
import json
import os
import re
import signal
import sys
import tempfile
from math import inf
from fractions import Fraction

import certificate
import certificate_text
import closed_forms
import intervals as iv
import memory
import rows as rows_file
import scale_one
import units
from intervals import Interval
from table_text import Unreadable, json_of, text_of

MOST_BITS = 16384
MOST_SCALE = 10**6  # the largest n in a table: the work grows with it
NUMBER = re.compile(r"[-+]?[0-9]{1,10010}(\.[0-9]{0,10010})?([eE][-+]?[0-9]{1,9})?")  # decimal: of a fraction no digit is the last
MOST_EXPONENT = 2 * 10**6  # in decimals: a fraction beyond takes more than seconds
DOMAIN = {  # of inputs by name, as `touchstone list` says it; what holds of one quantity only, beside that, by both names
    "n": lambda n: n.denominator == 1 and 0 <= n <= MOST_SCALE, "load": lambda load: load > 0, "G": lambda G: G > 1,
    "D": lambda D: 1 < D < 2, "gamma": lambda gamma: gamma > 1, "p": lambda p: p >= 0, "a": lambda a: 0 <= 2 * a <= 1,
    "tolerance": lambda tolerance: 0 < tolerance < 1, "westergaard.half_width load": lambda load: load <= 1, "peaks.f x": lambda x: x > 0,
    **dict.fromkeys(("archard.segments n", "archard.segments_limit n", "segments.count n", "segments.density n"), lambda n: n >= 1),
    **dict.fromkeys(("limit.exceedance p", "limit.force p", "limit.density p", "limit.distance p", "limit.segments a"), lambda x: x > 0),
    **dict.fromkeys(("westergaard.pressure x", "westergaard.gap x"), lambda x: abs(2 * x) <= 1)}
PATIENCE = 1800  # seconds for one row: a stranger's inputs may lie in the domain and be beyond all patience
sys.set_int_max_str_digits(0) if hasattr(sys, "set_int_max_str_digits") else None


def printable(text):
    """on one line of a terminal, whoever wrote the file"""
    return "".join(c if c.isprintable() else "?" for c in str(text))[:1000]


class TooLong(Exception):
    pass


def too_long(*_):
    raise TooLong


def read(path, text=None):
    """header, rows of a canonical table, its sha256 verified"""
    text = text_of(path) if text is None else text
    if not re.fullmatch("[ -~\n]*", text):
        raise Unreadable(f"{path}: not a canonical table: has other characters than printable ASCII and blanks")
    lines = text.split("\n")
    headers = [line for line in lines if line.startswith("# {")]
    if len(headers) != 1:
        raise Unreadable(f"{path}: not a canonical table: {len(headers)} lines of JSON")
    try:
        header = json_of(headers[0][2:])
        inputs, rows_promised, digest = header["inputs"], header["rows"], header["sha256"]
        texts = isinstance(inputs, list) and all(isinstance(text, str) for text in (*inputs, header["name"], header["quantity"]))
        if not texts or type(rows_promised) is not int or type(header["digits"]) is not int or header["digits"] < 1:
            raise ValueError("name, quantity or inputs are no texts, or rows or digits no whole numbers, digits above 0")
    except (ValueError, KeyError, TypeError, RecursionError) as reason:
        raise Unreadable(f"{path}: header: {reason}") from None
    rows = [line for line in lines if line and not line.startswith("#")]
    if len(rows) != rows_promised:
        raise Unreadable(f"{path}: {len(rows)} rows, {rows_promised} promised")
    if hashlib.sha256("".join(row + "\n" for row in rows).encode()).hexdigest() != digest:
        raise Unreadable(f"{path}: sha256 of the rows is not the header's")
    columns = lines[max(number for number, line in enumerate(lines) if line.startswith("#"))][1:].split()
    if columns not in ([*inputs, "value", "error"], [*inputs, "value", "error", "forced"]):
        raise Unreadable(f"{path}: the columns are said to be '{' '.join(columns)}'")
    for number, row in enumerate(rows, 1):
        if len(row.split()) != len(columns):
            raise Unreadable(f"{path}: row {number}: {len(row.split())} columns, not {len(columns)}")
    header["words"] = lines[: len(lines) - len(rows) - 1]
    return header, rows


def comments(header, forced):
    """the lines above the JSON, with which the program tells a reader what the header says"""
    estimated = header.get("status") == "estimated"
    bound = "estimate (from how far the numerical methods named under routes part, no proof; 0: exact)" if estimated else "proven bound"
    lines = [
        f"Touchstone {'estimated' if estimated else 'certified'} reference table {header['name']}",
        f"{header['description']}; equation {header['equation']}; unit {header['unit']}",
        "Inputs are binary64 numbers in shortest round-trip decimal: each stands for the binary64 number it rounds to.",
        f"value: the true value rounded to nearest, {header['digits']} significant digits (fewer if exact). "
        f"error: {bound} of |value - true value|."]
    some = ", in some rows by an estimated condition number" if header.get("forced") == "estimated" else ""
    lines += [f"forced: ulps of the value (absolute where it is 0) that rounding each real input once can cost a perfect code, to first order{some}."]
    return [f"# {line}" for line in (lines if forced else lines[:-1])]


def words_of(path, header, rows):
    """that what the table says of itself, to a reader and in JSON, is so: what its numbers are, format of inputs, digits and status"""
    for what, said in zip(("equation", "unit", "description", "input_format"), (*units.SAID[header["quantity"]], "binary64")):
        if header.get(what) != said:
            raise Unreadable(f"{path}: the {what} of {header['quantity']} is {said}, not {header.get(what, 'left out')}")
    if header["words"][:-2] != (right := comments(header, header["words"][-1].endswith(" forced"))):
        raise Unreadable(f"{path}: the lines above its JSON are not {right}")
    at = len(header["inputs"])
    approximate = [row.split()[at] for row in rows if row.split()[at + 1] != "0"]
    if header.get("status") not in ("certified", "estimated", "undecided") and (approximate or header.get("status") != "exact"):
        raise Unreadable(f"{path}: the status of its rows is not {header.get('status', 'left out')}")
    short = any(value == "nan" or len(re.sub("[eE].*|[-+.]", "", value).lstrip("0")) != header["digits"] for value in approximate)
    if header["status"] == "undecided" and not short:
        raise Unreadable(f"{path}: it says undecided, and its values have all {header['digits']} digits")
    if header["status"] == "certified" and short:
        raise Unreadable(f"{path}: its values have not the {header['digits']} digits that it says")


def with_certificates(forms, paths, known=None):
    """the forms, and what the claims of certificates say of rows without one: A_n, and with it (8.1) the number gamma^n A_(n-1) of
    segments; `known` comes to have these claims"""
    known = {} if known is None else known
    for path in paths:
        path, *reports = path.split(",")
        read = certificate.Certificate(path)
        if reports:
            certificate.join(read, reports)
        else:
            certificate.Replay(read, 1, read.count)
        for *inputs, value, error in read.claims.values():
            known[(read.quantity, *inputs)] = Interval.of(value) + iv.error_term(Interval.of(error)) if error else value

    def certified(quantity):
        return lambda *inputs: known.get((quantity, *inputs[:-1], (inputs[-1], 1)))

    def segments(n, load, D, gamma):
        if (D - 1).denominator > certificate_text.MOST_DEGREE:  # no claim's G is such a root
            return None
        G = closed_forms.exact_power(gamma, D - 1)
        below = known.get(("contact.area", n - 1, load, (gamma ** (D - 1).numerator, (D - 1).denominator) if G is None else (G, 1)))
        return None if below is None else below * gamma ** int(n)

    constant = certified("limit.area_constant")

    def ratio(G):
        return None if constant(G) is None else constant(G) / (closed_forms.K_inf() * G)

    def distance(n, p, load, G):
        """the share of A_n above p p*_n, p*_n = G^n p*_0, less that of the limit: of the table, or of three claims"""
        proved = certified("limit.distance")(n, p, load, G)
        of = ("contact.exceedance", n, p * G ** int(n), load, G), ("contact.area", n, load, G), ("limit.exceedance", p, G)
        above, area, limit = (certified(quantity)(*inputs) for quantity, *inputs in of)
        return above / area - limit if proved is None and None not in (above, area, limit) else proved

    def both(quantity, proved):
        return {quantity: lambda *inputs: proved(*inputs) if forms[quantity](*inputs) is None else forms[quantity](*inputs)}
    return {**forms, **both("segments.count", segments), **both("contact.area", certified("contact.area")),
            **both("contact.exceedance", certified("contact.exceedance")), **both("contact.density", certified("contact.density")),
            **both("segments.density", certified("segments.density")), "limit.area_constant": constant, "limit.area_ratio": ratio,
            "limit.distance": distance,
            **{f"limit.{name}": certified(f"limit.{name}") for name in "exceedance force density segments scale gap".split()}}


def with_patience(seconds):
    """TooLong after so many seconds, where the system has alarms; 0: no more"""
    if hasattr(signal, "SIGALRM"):
        signal.signal(signal.SIGALRM, too_long)
        signal.alarm(seconds)


def names_of(quantity):
    """the inputs of a quantity, as every table of it has them"""
    if quantity in certificate_text.CLAIMS:
        return certificate_text.CLAIMS[quantity].split()[:-2]
    return ["G"] if quantity == "limit.area_ratio" else [*inspect.signature(closed_forms.FORMS[quantity]).parameters]


def within_domain(quantity, form):
    """the form, which formulas alone would carry on beyond where the quantity has a meaning"""
    conditions = [[DOMAIN[key] for key in (name, f"{quantity} {name}") if key in DOMAIN] for name in names_of(quantity)]

    def inside(*inputs):
        if not all(holds(x) for x, of_x in zip(inputs, conditions) for holds in of_x):
            raise ValueError("outside the domain")
        return form(*inputs)
    return inside


def last_digit(cell):
    """how many digits a printed number has, and the unit of the last"""
    mantissa, _, exponent = cell.lower().partition("e")
    whole, _, decimals = mantissa.lstrip("+-").partition(".")
    return len((whole + decimals).lstrip("0")), Fraction(10) ** (int(exponent or 0) - len(decimals))


def digits_of(cell, error):
    """how many digits of a printed number its error leaves: those down to the last with half a unit not below it"""
    digits, unit = last_digit(cell)
    while digits and 2 * error > unit:
        digits, unit = digits - 1, 10 * unit
    return digits


def rounded(x, digits, unit, way):
    """x to so many digits, of a number that has them if its last has this unit: below its power of ten the last of them has a tenth"""
    unit /= 1 if abs(x) >= unit * 10 ** (digits - 1) else 10
    whole = x // unit
    # 0 to 3 quarters stand for what x / unit, a quotient that takes long to reduce, has above its whole
    quarters = (x > whole * unit) + (2 * x >= (2 * whole + 1) * unit) + (2 * x > (2 * whole + 1) * unit)
    return way(whole + Fraction(quarters, 4)) * unit


def verdict(form, row, names, wanted=0, way=round, all_have=True):
    """'right', 'wrong', 'not a closed form' or 'undecided' for one row, and to how many digits. A certified one has an error that leaves
    the digits wanted, and is the true value rounded to them; of rows that do not all have them, those that do. What is exact, with an
    error that is written 0, has no more. The way leads from a fraction to an integer, nearest ones with ties to even; by another the error
    may be a whole unit of the last digit."""
    cells = row.split()
    if not all(NUMBER.fullmatch(cell) for cell in cells[: len(names) + 2]):
        return "unreadable", 0
    if any(abs(int(cell.lower().partition("e")[2] or 0)) > MOST_EXPONENT for cell in cells[: len(names) + 2]):
        return "undecided", 0
    try:
        inputs = [Fraction(float(c)) for c in cells[: len(names)]]
        value, error = Fraction(cells[len(names)]), Fraction(cells[len(names) + 1])
    except (ValueError, OverflowError, ZeroDivisionError):
        return "unreadable", 0
    printed, low, high, width = digits_of(cells[len(names)], error if way is round else error / 2) if error else inf, 0, 0, inf
    wanted = wanted if all_have or printed >= wanted else 0
    if (error > 0) == (cells[len(names) + 1] == "0") or wanted and not last_digit(cells[len(names)])[0] <= wanted <= printed:
        return "wrong", 0
    Interval.bits = 64 + int(3.33 * len(cells[len(names)].lower().split("e")[0]))
    while Interval.bits <= MOST_BITS:
        try:
            true = form(*inputs)
        except (closed_forms.Undecided, ZeroDivisionError):
            Interval.bits *= 2
            continue
        except (ValueError, TypeError, IndexError):  # outside the domain, or inputs of another quantity
            return "unreadable", 0
        except (MemoryError, TooLong):
            return "undecided", 0
        if true is None:
            return "not a closed form", 0
        low, high = (true, true) if isinstance(true, Fraction) else true.ends()
        least, most = (rounded(end, *last_digit(cells[len(names)]), way) if wanted and error else value for end in (low, high))
        if value - error <= low and high <= value + error and least == value == most:
            return "right", printed
        if high < value - error or low > value + error or most < value or least > value:
            return "wrong", 0
        if high - low > width / 2:  # more bits are of no use: a certificate says no more
            break
        width = high - low
        Interval.bits *= 2
    off = max(abs(high - value), abs(low - value))
    return "undecided", len(str(int(abs(value) / off))) - 1 if off else 0


def opened(path, forms, known):
    """how a file is called, its header and rows, and what judges a row of it"""
    text = text_of(path)  # once: it may be a pipe
    if text.startswith(rows_file.FIRST):
        return rows_file.opened(path, text, forms, known, names_of, within_domain, verdict)
    header, rows = read(path, text)
    form, names = forms.get(header["quantity"]), header["inputs"]
    if form is None:
        raise Unreadable(f"{path}: no closed form is known for '{header['quantity']}'")
    if names != (right := names_of(header["quantity"])):
        raise Unreadable(f"{path}: the inputs of {header['quantity']} are {' '.join(right)}, not {' '.join(names)}")
    words_of(path, header, rows)
    form, wanted = within_domain(header["quantity"], form), header["digits"] if header["status"] != "estimated" else 0
    return header["name"], header, rows, lambda row: (  # no value: in a table that says undecided
        ("undecided", 0) if row.split()[len(names) :][:2] == ["nan", "inf"] else
        verdict(form, row, names, wanted, all_have=header["status"] != "undecided"))


def keep(path, found):
    """the entries of these tables renewed in the file of coverage, the others as they are, a line each"""
    try:
        with open(path, encoding="ascii") as file:
            known = {entry["table"]: entry for entry in json.load(file)}
    except FileNotFoundError:
        known = {}
    except (OSError, ValueError, TypeError, KeyError) as reason:
        raise Unreadable(f"{path}: not a file of coverage: {reason}") from None
    known |= {entry["table"]: entry for entry in found}
    # a new file, whoever may write there
    with tempfile.NamedTemporaryFile("w", encoding="ascii", dir=os.path.dirname(path) or ".", delete=False) as file:
        file.write("[\n" + ",\n".join(json.dumps(known[name]) for name in sorted(known)) + "\n]\n")
    os.chmod(file.name, 0o644)
    os.replace(file.name, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--limit", type=int, help="check at most N rows of a table, evenly spread")
    parser.add_argument("--certificate", action="append", default=[], metavar="FILE[,REPORT...]",
                        help="proved first, or, of a long one, what certificate.py printed for its pieces")
    parser.add_argument("--coverage", metavar="FILE", help="keep there what was found of whole tables")
    parser.add_argument("tables", nargs="+")
    arguments = parser.parse_args()
    if arguments.coverage and arguments.limit:
        parser.error("--coverage is of whole tables: no --limit")
    worst, found, known = 0, [], {}
    memory.bound()
    try:
        forms = with_certificates(scale_one.FORMS, arguments.certificate, known)
    except (certificate.Malformed, certificate.Refused, MemoryError) as why:
        print(f"check.py: a certificate says no: {str(why) or 'needs too much memory'}", file=sys.stderr)
        return 65
    print(f"{'table':30} {'rows':>6} {'right':>6} {'open':>6} {'wrong':>6} {'digits':>6}")
    for path in arguments.tables:
        try:
            name, header, rows, judge = opened(path, forms, known)
            if arguments.coverage and "statuses" in header:
                raise Unreadable(f"{path}: coverage is of canonical tables, not of files of rows")
        except (Unreadable, MemoryError) as reason:
            print(f"check.py: {printable(reason) or f'{path}: needs too much memory'}", file=sys.stderr)
            worst = max(worst, 65)
            continue
        step = max(1, -(-len(rows) // arguments.limit)) if arguments.limit else 1
        count, least, confirmed = {}, inf, 0
        for number, row in enumerate(rows[::step]):
            with_patience(PATIENCE)
            said, digits = judge(row)
            with_patience(0)
            count[said] = count.get(said, 0) + 1
            if said == "right" or digits:
                least, confirmed = min(least, digits), confirmed + 1
            if said in ("wrong", "unreadable") or said == "undecided" and not digits:
                print(f"{path}: row {number * step + 1}: {said}: {printable(row)}", file=sys.stderr)
        wrong = count.get("wrong", 0) + count.get("unreadable", 0)
        right, asked = count.get("right", 0), len(rows[::step])
        digits = "-" if not confirmed else "exact" if least == inf else least
        print(f"{printable(name):30} {asked:6} {right:6} {asked - right - wrong:6} {wrong:6} {digits:>6}", flush=True)
        worst = max(worst, min(wrong, 1))
        found.append({"table": header["name"], "rows": asked, "confirmed": confirmed, "all_digits": right, "wrong": wrong,
                      "digits": None if least == inf else least, "sha256": header["sha256"]})
    if arguments.coverage:
        try:
            keep(arguments.coverage, found)
        except (Unreadable, OSError) as reason:
            print(f"check.py: {reason}", file=sys.stderr)
            worst = max(worst, 65)
    return worst


if __name__ == "__main__":
    sys.exit(main())
