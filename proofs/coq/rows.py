#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes rows of closed-form reference tables as theorems of Coq: `rows.py TABLE.txt [ROWS] [--spoil]` prints a file that proves
|true - value| <= error for ROWS rows spread over the table, its first and last among them (all rows without ROWS).
Nothing in here is trusted: Coq checks each line. --spoil moves each value by six times its error, for a control that must fail."""

import math
import pathlib
import sys
from fractions import Fraction

def coq(q):
    """An exact rational as Coq reads it."""
    n, d = q.numerator, q.denominator
    body = str(abs(n)) if d == 1 else f"({abs(n)} / {d})"
    return body if n >= 0 else f"(- {body})"


def bits(error, value):
    """Working precision: the digits of the row, and as many again for what cancels."""
    if error == 0 or value == 0:
        return 200
    return 80 + 2 * max(64, math.ceil(math.log2(float(abs(value) / error)) if error else 64))


def peaks_f(x):
    return f"f {coq(x)}", "rewrite f_full_row by lra" if x > 1 else "rewrite f_partial_row by lra"


def peaks_fixed_point(G):
    return f"x_P {coq(G)}", "rewrite x_P_partial_row by lra" if G > 2 else "rewrite x_P_full_row by lra"


def hertz_half_width(load):
    return f"hertz_half_width {coq(load)}", "unfold hertz_half_width"


def westergaard_half_width(load):
    if not 0 <= load < 1:
        return None
    return f"westergaard_half_width {coq(load)}", "rewrite westergaard_half_width_row by lra"


def westergaard_pressure(x, load):
    statement = f"westergaard_pressure {coq(x)} {coq(load)}"
    return statement, "rewrite pressure_full_row by lra" if load >= 1 else "rewrite pressure_partial_row by lra"


def westergaard_exceedance(p, load):
    if load >= 1:
        if not -1 < p - load <= 1:
            return None
        return f"exceedance_full {coq(p)} {coq(load)}", "rewrite exceedance_full_row by lra"
    if not 0 < p * p < 4 * load:
        return None
    return f"exceedance_partial {coq(p)} {coq(load)}", "erewrite exceedance_partial_row; [| reflexivity | split; INTERVAL]"


FORMS = {f.__name__: f for f in (peaks_f, peaks_fixed_point, hertz_half_width, westergaard_half_width, westergaard_pressure, westergaard_exceedance)}


def theorem(name, index, inputs, value, error):
    form = FORMS[name](*inputs)
    if form is None:
        return None
    statement, branch = form
    interval = f"interval with (i_prec {bits(error, value)})"
    branch = branch.replace("INTERVAL", interval)
    if error == 0:
        if name == "westergaard_pressure" and value == 0 and inputs[1] < 1:
            proof = f"rewrite pressure_outside_row; [lra | lra | {interval}]"
            return f"Theorem row_{index} : {statement} = 0.\nProof. {proof}. Qed.\n"
        if name not in ("peaks_f", "peaks_fixed_point") or "partial" in branch and name == "peaks_f":
            return None
        return f"Theorem row_{index} : {statement} = {coq(value)}.\nProof. {branch}; lra. Qed.\n"
    return f"Theorem row_{index} : within ({statement}) {coq(value)} {coq(error)}.\nProof. unfold within; {branch}; {interval}. Qed.\n"


def main(path, wanted, spoil):
    name = pathlib.Path(path).stem
    lines = open(path).read().splitlines()
    names = [line for line in lines if line.startswith("#")][-1][1:].split()  # inputs, value, error, and what rounded inputs force
    given = names.index("value")
    rows = [line.split() for line in lines if not line.startswith("#")]
    step = 1 if wanted is None else max(1, (len(rows) - 1) // max(1, wanted - 1))
    chosen = sorted(set(range(0, len(rows), step)) | {len(rows) - 1})
    out, left = [], 0
    for i in chosen:
        inputs, (value, error) = rows[i][:given], rows[i][given:given + 2]
        text = theorem(name, i + 1, [Fraction(float(t)) for t in inputs],
                       Fraction(value) + (6 * Fraction(error) if spoil else 0), Fraction(error))
        if text is None:
            left += 1
        else:
            out.append(text)
    print(f"(* Generated from data/reference/{name}.txt by proofs/coq/rows.py: {len(out)} rows; {left} of those chosen are 0, 1 or exact by a case"
          " that is no business of the tactic. *)")
    print("From Coq Require Import Reals Lra.\nFrom Interval Require Import Tactic.\nRequire Import Wave Peaks Rows.\nOpen Scope R_scope.\n")
    print("\n".join(out))


if __name__ == "__main__":
    plain = [a for a in sys.argv[1:] if a != "--spoil"]
    main(plain[0], int(plain[1]) if len(plain) > 1 else None, "--spoil" in sys.argv)
