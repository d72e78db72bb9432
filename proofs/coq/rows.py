#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes rows of closed-form reference tables as theorems of Coq: `rows.py TABLE.txt [ROWS] [--spoil]` prints a file that proves
|true - value| <= error for ROWS of the rows within reach, spread over the table, the first and last of these among them (all of them
without ROWS). Nothing in here is trusted: Coq checks each line. --spoil moves each value by six times its error, for a control that
must fail."""

import math
import pathlib
import sys
from fractions import Fraction

PI = Fraction(math.pi) + Fraction(math.sin(math.pi))  # to 100 bits: enough to see on which side of an edge a row lies; Coq proves it


def sine_of_pi_times(x):
    """sin(pi x), |x| <= 1/2, to 100 bits"""
    term = total = y = PI * x
    for k in range(1, 24):
        term = -term * y * y / (2 * k * (2 * k + 1))
        total += term
    return total


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


def lost(name, value):
    """what (2.17) loses besides: of a small share it takes the square as a difference of two numbers near 1"""
    return math.ceil(-2.2 * math.log2(value)) if name == "westergaard_exceedance" and 0 < value < 0.5 else 0


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


def westergaard_density(p, load):
    statement = f"westergaard_density {coq(p)} {coq(load)}"
    if load >= 1:
        inside = (p - load) ** 2 < 1
        return statement, "rewrite density_full_row by lra; unfold density_full" if inside else "rewrite density_above_row by lra"
    if p == 0:
        return statement, "rewrite density_at_zero_row by lra"
    inside = p * p < 4 * load
    return statement, "rewrite density_partial_row by lra; unfold density_partial" if inside else "rewrite density_outside_row by lra"


def hertz_pressure(x, load):
    outside = (PI * x) ** 2 >= load
    return f"hertz_pressure {coq(x)} {coq(load)}", "rewrite hertz_outside_row by INTERVAL" if outside else "unfold hertz_pressure"


def gap_beyond(name, inner, v, x, load):
    branch = "gap_beyond_row" if v * v > load else "gap_within_row"
    return f"{name} {coq(x)} {coq(load)}", f"unfold {name}; rewrite {branch} by INTERVAL"


def hertz_gap(x, load):
    return gap_beyond("hertz_gap", "PI * x", PI * x, x, load)


def westergaard_gap(x, load):
    return gap_beyond("westergaard_gap", "sin (PI * x)", sine_of_pi_times(x), x, load)


def westergaard_mean_gap(load):
    return f"westergaard_mean_gap {coq(load)}", f"rewrite mean_gap_{'partial' if load < 1 else 'full'}_row by lra"


def westergaard_energy(load):
    return f"westergaard_energy {coq(load)}", f"rewrite energy_{'partial' if load < 1 else 'full'}_row by lra"


def weierstrass_bound(D, gamma):
    return f"weierstrass_bound {coq(D)} {coq(gamma)}", "unfold weierstrass_bound, Rpower"


def archard_delta(n):
    if n > 1000:
        return None  # a number of a million bits
    return f"archard_delta {n}", f"unfold archard_delta; change (2 ^ ({n} + 1))%Z with {2 ** int(n + 1)}%Z"


def archard_alpha(n, D):
    if n > 1000:
        return None
    return f"archard_alpha {n} {coq(D)}", f"unfold archard_alpha; change (2 ^ {n})%Z with {2 ** int(n)}%Z"


def peaks_iterate(n, load, G):
    if n > 5:
        return None  # a nest of roots that deep is slow
    return f"peaks_iterate {n} {coq(load)} {coq(G)}", "unfold peaks_iterate; cbn [iterate]; repeat choose_branch ltac:(INTERVAL)"


def always_full(n, load, G):
    """every wave on the way is in full contact, so that x_n is rational"""
    x, full = load, True
    for _ in range(int(n) + 1):
        full = full and x > 1
        x = (1 + x) / G
    return full


def segments_max_half_width(n, load, G):
    if n > 5 or n > 1 and load < 2.0 ** -100:
        return None  # a nest of roots of a number of hundreds of digits is slow
    x = load
    for _ in range(int(n)):
        x = (1 + x if x > 1 else 2 * Fraction(math.sqrt(x)) if x > 2.0 ** -1000 else 0) / G  # only chooses a branch, which Coq then proves
    branches = "cbn [iterate]; repeat choose_branch ltac:(INTERVAL); reflexivity"
    if x >= 1:
        return f"segments_max_half_width {n} {coq(load)} {coq(G)}", f"erewrite max_half_width_full_row; [| {branches} | INTERVAL]"
    return f"segments_max_half_width {n} {coq(load)} {coq(G)}", f"erewrite max_half_width_partial_row; [| {branches} | split; INTERVAL]"


FORMS = {f.__name__: f for f in (
    peaks_f, peaks_fixed_point, hertz_half_width, westergaard_half_width, westergaard_pressure, westergaard_exceedance, westergaard_density,
    hertz_pressure, hertz_gap, westergaard_gap, westergaard_mean_gap, westergaard_energy, weierstrass_bound, archard_delta, archard_alpha,
    peaks_iterate, segments_max_half_width)}
# what `interval` has nothing to do with: rational numbers, exact or a tie of the last digit, which only `lra` decides
RATIONAL = {"archard_delta", "archard_alpha"}


def theorem(name, index, inputs, value, error):
    form = FORMS[name](*inputs)
    if form is None:
        return None
    statement, branch = form
    interval = f"interval with (i_prec {bits(error, value) + lost(name, value)})"
    branch = branch.replace("INTERVAL", interval)
    if error == 0:
        if name == "westergaard_pressure" and value == 0 and inputs[1] < 1:
            branch, last = f"rewrite pressure_outside_row; [lra | lra | {interval}]", ""
        elif name in ("westergaard_pressure", "hertz_half_width", "westergaard_half_width", "westergaard_exceedance"):
            return None
        elif name == "peaks_f" and "partial" in branch or value != 0 and name in ("hertz_gap", "hertz_pressure", "westergaard_gap"):
            return None
        elif name == "peaks_iterate" and not always_full(*inputs):
            return None
        else:
            last = "; lra"
        return f"Theorem row_{index} : {statement} = {coq(value)}.\nProof. {branch}{last}. Qed.\n"
    last = "apply Rabs_le; lra" if name in RATIONAL else interval
    return f"Theorem row_{index} : within ({statement}) {coq(value)} {coq(error)}.\nProof. unfold within; {branch}; {last}. Qed.\n"


def main(path, wanted, spoil):
    name = pathlib.Path(path).stem
    lines = open(path).read().splitlines()
    names = [line for line in lines if line.startswith("#")][-1][1:].split()  # inputs, value, error, and what rounded inputs force
    given = names.index("value")
    rows = [line.split() for line in lines if not line.startswith("#")]
    provable = []
    for i, row in enumerate(rows):
        inputs, (value, error) = row[:given], row[given:given + 2]
        if spoil and Fraction(error) == 0:
            continue  # nothing would be moved
        text = theorem(name, i + 1, [Fraction(float(t)) for t in inputs],
                       Fraction(value) + (6 * Fraction(error) if spoil else 0), Fraction(error))
        if text is not None:
            provable.append(text)
    step = 1 if wanted is None else max(1, (len(provable) - 1) // max(1, wanted - 1))
    out = [provable[i] for i in sorted(set(range(0, len(provable), step)) | {len(provable) - 1})]
    print(f"(* Generated from data/reference/{name}.txt by proofs/coq/rows.py: {len(out)} of {len(provable)} rows; the other"
          f" {len(rows) - len(provable)} are 0, 1 or exact by a case that is no business of the tactic, or beyond it. *)")
    print("From Coq Require Import Reals Lra ZArith.\nFrom Interval Require Import Tactic.\nRequire Import Wave Peaks Rows.\nOpen Scope R_scope.\n")
    print("\n".join(out))


if __name__ == "__main__":
    plain = [a for a in sys.argv[1:] if a != "--spoil"]
    main(plain[0], int(plain[1]) if len(plain) > 1 else None, "--spoil" in sys.argv)
