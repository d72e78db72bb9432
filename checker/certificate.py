#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""certificate.py FILE [--lines I-J] | --join FILE REPORT...: reads a TOUCHSTONE-CERT 1 (docs/certificate.md) and says yes or no.

Every line is read; those from I to J (all, if nothing is said) are proved again, given that the lines before them hold. The reports of
pieces, joined, cover all. Exit code 0: yes; 1: no, a line does not hold or a claim is not proved; 65: no, not a certificate.
"""
import argparse
import re
import sys
import time
from fractions import Fraction

import density
import distributions
import full_contact
import intervals as iv
import limit_density
import limits
import memory
import poisson
import second_eigenvalue
import transfer
from certificate_text import CLAIMS, FORMS, MOST, PROVES_A_CLAIM, QUOTIENTS, WITH_INTEGERS, Certificate, Malformed
from certificate_text import decimal, fields, integer, need, span, text_of
from intervals import Interval
from transfer import Refused

SMALLEST_STEP = Fraction(1, 1 << 16)  # of a rule: exp(-1/step) is a number one can write
MOST_PANELS, MOST_PANELS_OF_A_MESH = 64, 4096
PATIENCE = 20  # seconds


class Replay:
    """Proves lines one by one and forgets each after the last line that refers to it."""

    def __init__(self, certificate, first, last):
        self.certificate, self.first, self.last = certificate, first, last
        self.known, self.until, self.rules, self.rows, self.proved = {}, {}, {}, {}, set()
        self.number, self.said = 0, time.monotonic()
        for words in certificate.lines:
            self.number += 1
            self.progress()
            self.line(words)
        need(not self.known, f"line {min(self.known, default=0)}: the last line said to refer to it does not", Refused)
        need(len(self.proved) == len(certificate.claims), "a claim is proved by no line", Refused)

    def progress(self, part=""):
        """on stderr, where there was nothing to read for a while"""
        if time.monotonic() - self.said > PATIENCE:
            self.said = time.monotonic()
            print(f"line {self.number} of {self.certificate.count}", part, file=sys.stderr, flush=True)

    def line(self, words):
        need(len(words) > 4 and words[0] == str(self.number) and words[1] in FORMS, f"line {self.number}: is not a line of that number")
        reason, numbers = words[1], []
        for part in words[2].split(",") if words[2] != "-" else []:
            low, high = span(part)
            need((numbers or [0])[-1] < low <= high < self.number,
                 f"line {self.number}: rests on lines that do not come before it, or on one twice")
            numbers += range(low, high + 1)
        for r in numbers:
            need(r in self.known, f"line {self.number}: rests on line {r}, which is no longer known", Refused)
        names = FORMS[reason]
        data = fields(words[4:4 + len(names.split())], names, f"line {self.number}")
        more = words[4 + len(names.split()):]
        need(not more or reason in WITH_INTEGERS, f"line {self.number}: says more than it may")
        try:
            integers = [[integer(c) for c in more]] if reason in WITH_INTEGERS else []
            self.known[self.number] = getattr(self, reason)([self.known[r] for r in numbers], *data, *integers)
        except (Refused, full_contact.Far, ValueError, ArithmeticError) as why:
            raise Refused(f"line {self.number}: {str(why) or 'more is needed of a piece than it has'}") from None
        self.until[self.number] = decimal(words[3])
        need(self.number <= self.until[self.number] and (reason in PROVES_A_CLAIM) == (self.until[self.number] == self.number),
             f"line {self.number}: forgotten too early")
        for r in numbers + [self.number]:
            if self.until[r] == self.number:
                del self.known[r]
                self.rows.pop(r, None)

    def proving(self):
        return self.first <= self.number <= self.last

    def grid(self, below, G, bits, step, points):
        need(not below and bits >= 32 and SMALLEST_STEP <= step < 1 and points > 0 and step * points < 1000, "not a rule", Refused)
        need(G[0] > 2 ** G[1] and G[0] < 2 ** (40 * G[1]), "G is not between 2 and 2^40", Refused)
        return "grid", self.number, (G, bits, step, points)

    def rule(self, grid, bits):
        if (grid[1], bits) not in self.rules:
            self.rules = {k: v for k, v in self.rules.items() if k[0] == grid[1]}  # of one grid at a time
            Interval.bits = bits + 128
            (base, degree), _, step, points = grid[2]
            self.rules[grid[1], bits] = transfer.Rule(root_of(base, degree), step, points, bits)
        Interval.bits = bits + 64
        return self.rules[grid[1], bits]

    def panel(self, below, low, high, terms, rho):
        need([b[0] for b in below] == ["grid"] and terms > 0, "a panel rests on a grid", Refused)
        return "panel", self.number, below[0], transfer.Panel(low, high, terms, rho, below[0][2][1])

    def whole(self, grid, below, m):
        """the levels m of one grid on panels that follow one another from log(G/2) on"""
        need(below and all(b[0] == "level" and b[2] is grid and b[4] == m for b in below),
             f"does not rest on level {m} of its grid", Refused)
        panels = [b[3][3] for b in below]
        need(len(panels) <= MOST_PANELS and all(p.high == q.low for p, q in zip(panels, panels[1:])),
             "panels do not follow one another", Refused)
        if self.proving():
            need((panels[0].low + Fraction(1, 2**20)) < self.rule(grid, grid[2][1]).L.ends()[0], "panels begin beyond log(G/2)", Refused)
        return panels, [b[5] for b in below], tuple(b[3][1] for b in below)

    def row(self, grid, key, rule, s, x, panels):
        rows = self.rows.setdefault(grid[1], {})
        if key not in rows:
            rows[key] = rule.row(s, x, (1 << rule.bits) - x, panels)
        return rows[key]

    def level(self, below, m, error, exponent, coefficients):
        need([b[0] for b in below[:2]] == ["grid", "panel"] and below[1][2] is below[0] and 0 <= m,
             "a level rests on a grid and its panel", Refused)
        grid, place = below[:2]
        panel, bits, a = place[3], grid[2][1], Fraction(1, 2 ** (m + 1))
        need(len(coefficients) == panel.terms and error >= 0 and (m > 0 or len(below) == 2),
             "another number of coefficients, or level 0 rests on another", Refused)
        panels, levels, places = self.whole(grid, below[2:], m - 1) if m else (None, None, None)
        rounding = Fraction(2) ** exponent * sum(map(abs, coefficients)) * panel.terms**2  # of sums of Chebyshev polynomials, in units
        if self.proving():
            rule, worst = self.rule(grid, bits), Fraction(0)
            for j, t in enumerate(panel.points):
                s = panel.middle + panel.half * Fraction(t, 2**bits)
                if m:
                    x = transfer.fixed(iv.exp(-Interval.of(s)), bits)
                    row = self.row(grid, (place[1], j, places), rule, s * 2**bits // 1, x, panels)
                    value, off = rule.apply(row, s, levels, 2 * a)
                else:
                    value, high = transfer.first_wave(s).ends()
                    off = high - value
                here = sum(map(int.__mul__, coefficients, panel.powers[j])) * Fraction(2) ** (exponent - bits)
                worst = max(worst, abs(here - value) + off + rounding / 2**bits)
            need(panel.error(rule.G.ends()[1], a, worst) <= error, "the polynomial is further from h than it says", Refused)
        return "level", self.number, grid, place, m, (panel, coefficients, exponent, error, rounding)

    def value(self, below, claim):
        grid, (n, load), value, error = self.claimed("contact.area", below, claim)
        need(grid[0] == "grid" and load <= 1, "a value rests on a grid, load <= 1", Refused)
        panels, levels, places = self.whole(grid, below[1:], n - 1)
        if self.proving():
            h, off = self.at_load(grid, load, n, panels, levels, places)
            low, high = (Interval.of(load) / power_of(*grid[2][0], n)).ends()
            need(value - error <= low * (h - off) and high * (h + off) <= value + error and off < h, "the claim is not proved", Refused)
        return "value", self.number

    def at_load(self, grid, load, n, panels, levels, places):
        """h_n(load) from level n - 1, and how far it may be off"""
        _, bits, step, points = grid[2]
        if 1 - load <= Fraction(1, 2**16):
            bits += -(-3 * step * points // 1)
        rule = self.rule(grid, bits)
        s = -iv.log(load) if load < 1 else Interval.of(0)
        row = self.row(grid, (load, places), rule, transfer.fixed(s, bits), load * 2**bits // 1, panels)
        return rule.apply(row, s.ends()[1], levels, Fraction(1, 2**n))

    def claimed(self, quantities, below, claim):
        """the grid, inputs, value and error of a claim that is proved here"""
        need(self.certificate.quantity in quantities.split() and claim in self.certificate.claims and claim not in self.proved,
             "no claim that is still to be proved", Refused)
        *inputs, G, value, error = self.certificate.claims[claim]
        need(below and below[0][0] in ("grid", "mesh", "law", "steady", "mean") and below[0][2][0] == G,
             "does not rest on a grid of its G", Refused)
        self.proved.add(claim)
        return below[0], inputs, value, error

    def mesh(self, below, G, p, scale, load, bits, kept, accuracy, rise, edges):
        need(not below and bits >= 64 and kept > 0 and accuracy > 0 and rise >= 0 and len(edges) <= MOST_PANELS_OF_A_MESH,
             "not a mesh", Refused)
        need(101 ** G[1] < G[0] * 100 ** G[1] and G[0] < 2 ** (40 * G[1]), "G is not between 1.01 and 2^40", Refused)
        return "mesh", self.number, (G, p, scale, load, bits, kept, accuracy, rise, edges)

    def polynomials(self, below, panel, middle, half, terms, aim, coefficients):
        need([b[0] for b in below] == ["mesh"] and half > 0 and 0 <= aim <= below[0][2][-3] and 1 < terms <= 64
             and 0 < len(coefficients) <= 64 * terms and len(coefficients) % terms == 0, "not the polynomials of a panel", Refused)
        of_levels = [coefficients[i:i + terms] for i in range(0, len(coefficients), terms)]
        return "polynomials", self.number, panel, (middle, half), aim, of_levels, below[0]

    def share(self, below, claim):
        quantity = "limit.area_constant" if self.certificate.quantity[:5] == "limit" else "contact.area contact.exceedance contact.density"
        mesh, inputs, value, error = self.claimed(quantity, below, claim)
        panels = self.all_panels(below)
        need(inputs or mesh[2][1] == 0, "does not rest on a mesh in contact", Refused)
        if not inputs:
            self.is_mean(poisson.Poisson, mesh, panels, value, error)
            return "share", self.number
        n, *pressure, load = inputs
        need((pressure or [0]) == [mesh[2][1]] and (not pressure or mesh[2][2] == n), "does not rest on a mesh of its pressure", Refused)
        of_density = self.certificate.quantity == "contact.density"  # level 0 of a mesh is scale 1
        need(n <= len(panels[0][5]) + of_density and load <= mesh[2][3], "the mesh does not reach so far", Refused)
        if self.proving():
            low, high = self.share_of(mesh, panels, n, load)
            need(value - error <= low and high <= value + error, "the claim is not proved", Refused)
        return "share", self.number

    def all_panels(self, below):
        """all polynomials of the mesh, panel by panel"""
        mesh, panels = below[0] if below else (None, ), below[1:]
        need(mesh[0] == "mesh" and all(b[0] == "polynomials" and b[-1] is mesh for b in panels),
             "does not rest on a mesh and its polynomials", Refused)
        as_many = len({(len(b[5]), len(b[5][0])) for b in panels}) == 1
        need([b[2] for b in panels] == list(range(len(mesh[2][-1]) - 1)) and as_many, "polynomials are missing", Refused)
        return panels

    def is_mean(self, kind, mesh, panels, value, error):
        """(W): of B_0 or what stands for it, where loads up to 1/(G - 1) count"""
        base, degree = mesh[2][0]
        need((1 + 1 / mesh[2][3]) ** degree <= base, "the mesh does not reach so far", Refused)
        need((value / 4) ** degree < base**2, "no mean is so large", Refused)  # f <= max(1, x), E[1/x] <= G^2
        if self.proving():
            need(self.made(kind, mesh, panels).off_by(value, self.progress) <= error, "the claim is not proved", Refused)

    def mean(self, below, value, error):
        """(W), (AB): E[f/x], f the share of one wave above the pressure of a mesh, or the force, or G times the density after two waves"""
        panels, of_force, of_density = self.all_panels(below), *(self.certificate.quantity == f"limit.{of}" for of in ("force", "density"))
        (G, p, scale, *_), positive = below[0][2], value > error >= 0
        need(self.certificate.quantity in QUOTIENTS.split() and positive and scale == 0, "no mean of the limit", Refused)
        need(not (of_force and p < poisson.LEAST_PRESSURE), "the pressure is too small", Refused)
        kind = poisson.Force if of_force else limit_density.MeanDensity if of_density and p else poisson.Poisson
        self.is_mean(kind, below[0], panels, value, error)
        return "mean", self.number, (G, p), value, error

    def quotient(self, below, claim):
        """(W), (AB): the share of the force is a mean, others are one over that in contact"""
        _, (place, ), value, error = self.claimed(QUOTIENTS, below, claim)
        pressures = [place] if self.certificate.quantity == "limit.force" else [0, place]
        need([(b[0], b[2]) for b in below] == [("mean", (below[0][2][0], p)) for p in pressures],
             "does not rest on the means that it is made of", Refused)
        if self.proving():
            *under, (low, high) = [(mean - off, mean + off) for *_, mean, off in below]
            for least, most in under:
                low, high = low / most, high / least
            need(value - error <= low and high <= value + error, "the claim is not proved", Refused)
        return "quotient", self.number

    def share_of(self, mesh, below, n, load):
        key = mesh[1], tuple(b[1] for b in below)
        if key not in self.rules:
            made = self.made(density.Density if self.certificate.quantity == "contact.density" else full_contact.Mesh, mesh, below)
            self.rules = {key: (made, made.errors(self.progress))}  # of one mesh at a time
        made, errors = self.rules[key]
        return made.value(n, load, errors)

    def made(self, kind, mesh, below):
        (base, degree), p, scale, highest, bits, kept, accuracy, rise, edges = mesh[2]
        Interval.bits = bits + 128
        G = root_of(base, degree)
        if p and self.certificate.quantity == "limit.segments":  # p is the half-width
            need(2 * p <= 1, "no half-width", Refused)
            pressure = G * iv.sin_pi(p).square()
        else:
            pressure = p / power_of(base, degree, scale)  # in p*_n, whatever the scale is
        return kind(G, pressure, highest, bits, edges, *zip(*(b[3:6] for b in below)), kept, accuracy, rise)

    def limit(self, below, claim, m, exponent, weights):
        """(F): C(G) is near the value because sum w_j h_(m+j) is, on each panel"""
        grid, _, value, error = self.claimed("limit.area_constant", below, claim)
        need(m >= 0 and weights and sum(weights) * Fraction(2) ** exponent == 1, "the weights do not add up to 1", Refused)
        need(all(b[0] == "level" for b in below[1:]), "does not rest on levels", Refused)
        weights = [w * Fraction(2) ** exponent for w in weights]
        each = [self.whole(grid, [b for b in below[1:] if b[4] == m + j], m + j) for j in range(len(weights))]
        need(sum(len(panels) for panels, *_ in each) == len(below) - 1 and len({places for *_, places in each}) == 1,
             "levels of other panels", Refused)
        if self.proving():
            rule, panels = self.rule(grid, grid[2][1]), each[0][0]
            G, twice_L = rule.G.ends()[1], 2 * rule.L.ends()[0]
            off = (sum(map(abs, weights)) * G + abs(value)) * G**2 * transfer.falling((1 - Fraction(1, 2 ** (m + 1))) * panels[-1].high)
            for p, panel in enumerate(panels):
                if panel.high < twice_L:  # no ratio in the limit is above 4/G^2
                    continue
                here = [levels[p] for _, levels, _ in each]
                terms = [sum(w * c * Fraction(2) ** e for w, (_, coefficients, e, *_) in zip(weights, here) for c in coefficients[i:i + 1])
                         for i in range(panel.terms)]
                spread = abs(terms[0] - value) + sum(map(abs, terms[1:])) + sum(abs(w) * level[3] for w, level in zip(weights, here))
                off += min(1, G**2 * transfer.falling(panel.low)) * spread
            need(off <= error, "the claim is not proved", Refused)
        return "limit", self.number

    def settling(self, below, claim, m):
        """(Y): from level m on all h are near C(G), and those before are looked at one by one"""
        grid, (load, tolerance), n, error = self.claimed("limit.scale", below, claim)
        need(grid[0] == "grid" and load <= 1 and error == 0 and 2 <= n <= m and n.denominator == 1,
             "no scale from 2 to m, or a load above 1", Refused)
        need(all(b[0] == "level" for b in below[1:]), "does not rest on levels", Refused)
        each = {k: self.whole(grid, [b for b in below[1:] if b[4] == k], k) for k in range(int(n) - 2, m + 1)}
        need(sum(len(panels) for panels, *_ in each.values()) == len(below) - 1, "levels of other scales", Refused)
        if self.proving():
            middle, off = self.from_then_on(grid, load, m, *each[m][:2])
            least = middle - off  # of C(G)
            need(2 * off <= tolerance * least, "level m is not near enough to its limit", Refused)
            for k in range(int(n) - 1, m + 1):
                h, wrong = self.at_load(grid, load, k, *each[k - 1])
                apart, unsure = abs(h - middle), wrong + off
                if k < n:
                    need(apart - unsure > tolerance * (middle + off), "a scale before is within the tolerance", Refused)
                else:
                    need(apart + unsure <= tolerance * least, f"scale {k} is not within the tolerance", Refused)
        return "settling", self.number

    def from_then_on(self, grid, load, m, panels, levels):
        """v, and above |h_M(load) - v|, M > m, and |C(G) - v|"""
        G = self.rule(grid, grid[2][1]).G.ends()[1]
        _, coefficients, exponent, *_ = levels[0]
        v, inverse, total, best = coefficients[0] * Fraction(2) ** exponent, max(1 / load, G**2), Fraction(0), None
        for panel, (_, coefficients, exponent, error, _) in zip(panels, levels):
            spread = abs(coefficients[0] * Fraction(2) ** exponent - v) + sum(map(abs, coefficients[1:])) * Fraction(2) ** exponent + error
            total += min(1, inverse * transfer.falling(panel.low)) * spread
            off = total + (G + abs(v)) * inverse * transfer.falling((1 - Fraction(1, 2 ** (m + 1))) * panel.high)
            best = off if best is None else min(best, off)
        return v, best

    def law(self, below, G, load, bits):
        need(not below and 96 <= bits <= 512 and load <= 1 and 2 ** G[1] < G[0] < 2 ** (40 * G[1]), "not a law: G > 2, load <= 1", Refused)
        return "law", self.number, (G, load, bits)

    def laws(self, law):
        key = law[1],
        if key not in self.rules:
            G, load, bits = law[2]
            Interval.bits = bits
            self.rules = {key: distributions.Laws(root_of(*G), load, bits)}  # of one law at a time
        Interval.bits = self.rules[key].bits
        return self.rules[key]

    def all_pieces(self, law, below, m):
        """of level m, from T = 0 to 1, and how far they are from phi_m"""
        if m == 1:
            need(not below, "level 1 needs no pieces", Refused)
            return [self.laws(law).first], 0
        need(below and all(b[0] == "piece" and b[2] is law and b[3] == m for b in below) and len(below) <= MOST_PANELS,
             f"does not rest on level {m} of its law", Refused)
        pieces = [b[5] for b in below]
        need(all(p.high == q.low for p, q in zip(pieces, pieces[1:]))
             and (pieces[0].low, pieces[-1].high, pieces[0].power) == (0, 1, m - 2), "pieces do not cover 0 to 1", Refused)
        return pieces, max(b[4] for b in below)

    def piece(self, below, m, low, high, centre, radius, power, exponent, error, coefficients):
        need(below and below[0][0] == "law" and m > 1 and 0 <= low < high <= 1 and power >= 0 and 2 < len(coefficients) <= 64
             and 0 <= error < 1, "not a piece of a law", Refused)
        Interval.bits = below[0][2][2]
        piece = distributions.Polynomial(low, high, centre, radius, power, exponent, coefficients)
        if self.proving():
            pieces, before = self.all_pieces(below[0], below[1:], m - 1)
            need(before < error, "errors do not get less", Refused)
            self.laws(below[0]).prove(m - 1, pieces, piece, (error - before) / (1 + before), self.progress)
        return "piece", self.number, below[0], m, error, piece

    def reading(self, below, claim):
        law, (n, place, load), value, error = self.claimed("contact.exceedance contact.density segments.density", below, claim)
        segments = self.certificate.quantity == "segments.density"
        need(law[0] == "law" and law[2][1] == load and n > segments, "a reading rests on the law of its load", Refused)
        need(place > 0 and not (segments and 2 * place >= 1), "the claim is at an end of the law, or beyond", Refused)
        if self.proving():
            laws = self.laws(law)
            pieces, off = self.all_pieces(law, below[1:], n - segments)
            Interval.bits = laws.bits
            low, high = laws.claimed(self.certificate.quantity, n, place, pieces, error).ends()
            need(value - error <= low * (1 - off) and high * (1 + off) <= value + error, "the claim is not proved", Refused)
        return "reading", self.number

    def steady(self, below, G, bits):
        need(not below and 96 <= bits <= 512 and 2 ** G[1] < G[0] < 2 ** (40 * G[1]), "not a law of the limit: G > 2", Refused)
        return "steady", self.number, (G, bits)

    def part(self, below, low, high, centre, radius, power, exponent, coefficients):
        need([b[0] for b in below] == ["steady"] and 0 < low < high <= 1 and power >= 0 and 2 < len(coefficients) <= 64,
             "not a part of the law of the limit", Refused)
        Interval.bits = below[0][2][1]
        return "part", self.number, below[0], distributions.Polynomial(low, high, centre, radius, power, exponent, coefficients)

    def limit_law(self, below):
        """the law and its parts, which follow one another up to T = 1; V is 0 below the first"""
        law, parts = below[0], below[1:]
        need(law[0] == "steady" and 0 < len(parts) <= MOST_PANELS and all(b[0] == "part" and b[2] is law for b in parts),
             "does not rest on the parts of a law of the limit", Refused)
        pieces = [b[3] for b in parts]
        need(all(p.high == q.low for p, q in zip(pieces, pieces[1:])) and pieces[-1].high == 1,
             "parts do not follow one another up to 1", Refused)
        key = law[1],
        if self.proving() and key not in self.rules:
            self.rules = {key: limits.Limit(root_of(*law[2][0]), law[2][1])}  # of one law at a time
        Interval.bits = law[2][1]
        return self.rules.get(key), pieces, tuple(b[1] for b in parts)

    def balance(self, below, part, error):
        need(below and 0 <= part < len(below) - 1 and 0 < error < 1, "not a balance", Refused)
        law, pieces, places = self.limit_law(below)
        if self.proving():
            law.prove(0, pieces, pieces[part], error, self.progress)
        return "balance", self.number, places, part, error

    def tending(self, below, claim):
        law, inputs, value, error = self.claimed("limit.exceedance limit.force limit.density limit.segments limit.distance", below, claim)
        n, place, load = inputs if len(inputs) == 3 else (0, *inputs, 1)
        need(law[0] == "steady", "the limit of a distribution rests on the law of the limit", Refused)
        made, pieces, places = self.limit_law([law, *(b for b in below if b[0] == "part")])
        balances = [b for b in below if b[0] == "balance"]
        need(sorted(b[3] for b in balances) == list(range(len(pieces))) and all(b[2] == places for b in balances),
             "parts are not all balanced", Refused)
        at_scale = [b for b in below if b[0] in ("law", "piece")]
        need(1 + len(pieces) + len(balances) + len(at_scale) == len(below) and (n > 0) == bool(at_scale),
             "rests on more or less than it may", Refused)
        need(place > 0 and (self.certificate.quantity != "limit.segments" or 2 * place < 1),
             "the claim is at an end of the law, or beyond", Refused)
        if self.proving():
            here = self.at_scale(at_scale, law[2][0], n, place, load, error) if n else 0
            Interval.bits = made.bits
            limit = made.claimed(self.certificate.quantity, place, pieces, max(b[4] for b in balances), error)
            low, high = (here - limit if n else limit).ends()
            need(value - error <= low and high <= value + error, "the claim is not proved", Refused)
        return "tending", self.number

    def eigenvalue(self, below, claim, high, centre, radius, exponent, coefficients):
        """(Z)"""
        law, _, value, error = self.claimed("limit.gap", below, claim)
        need(law[0] == "steady" and len(below) == 1 and error * 2 ** law[2][1] > 1 and 0 < high <= 1000 and 0 < radius <= 64
             and 2 < len(coefficients) <= MOST["terms"], "not a function of s", Refused)
        if self.proving():
            (base, degree), Interval.bits = law[2]
            w = second_eigenvalue.Eigenfunction(root_of(base, degree), high, centre, radius, exponent, coefficients)
            need(w.is_within(value, error, self.progress), "the claim is not proved", Refused)
        return "eigenvalue", self.number

    def at_scale(self, below, G, n, place, load, error):
        """the share of A_n above `place` p*_n"""
        need(below[0][0] == "law" and below[0][2][:2] == (G, load), "does not rest on the law of its G and load", Refused)
        pieces, off = self.all_pieces(below[0], below[1:], n)
        return self.laws(below[0]).share_of_area(n, place, pieces, off, error / 64)


def root_of(base, degree):
    return iv.power(base, Fraction(1, degree)) if degree > 1 else Interval.of(base)


def power_of(base, degree, n):
    return iv.exp(iv.log(base) * Fraction(n, degree)) if degree > 1 else Interval.of(base**n)


def shown(quantity, claim):
    *inputs, (base, degree), value, error = claim
    sign, value = "-" if value < 0 else "", abs(value)
    what = "".join(f"{name}={x} " for name, x in zip(CLAIMS[quantity].split(), inputs)) + f"G={base}{f'^1/{degree}' if degree > 1 else ''}"
    if error == 0:
        return f"{quantity} {what}: {value}"
    digits = len(str(int(value / error))) - 1  # error < value
    e = len(str(int(value))) - 1 if value >= 1 else -len(str(int(1 / value)))
    return f"{quantity} {what}: {sign}{int(value * Fraction(10) ** (digits - e))}e{e - digits} to {digits} digits"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--lines", default="", help="prove lines I-J only")
    parser.add_argument("--join", nargs="+", metavar="REPORT", help="what this program printed for the pieces of FILE")
    parser.add_argument("file")
    arguments = parser.parse_args()
    memory.bound()
    if hasattr(sys, "set_int_max_str_digits"):  # numbers of a certificate are bounded by its text
        sys.set_int_max_str_digits(0)
    try:
        certificate = Certificate(arguments.file)
        first, last = span(arguments.lines) if arguments.lines else (1, certificate.count)
        need(0 < first <= last <= certificate.count, f"there are no lines {first}-{last}")
        if arguments.join:
            join(certificate, arguments.join)
            print(f"yes: the pieces cover all {certificate.count} lines, {len(certificate.claims)} claims are proved")
            return 0
        Replay(certificate, first, last)
    except (Malformed, Refused, MemoryError) as why:
        print("".join(c if c.isprintable() else "?" for c in f"no: {arguments.file}: {str(why) or 'needs too much memory'}"))
        return 65 if isinstance(why, Malformed) else 1
    if (first, last) != (1, certificate.count):
        print(f"lines {first}-{last} of {certificate.count} hold if those before them do; sha256 {certificate.digest}")
        return 0
    print(*(shown(certificate.quantity, claim) for claim in certificate.claims.values()), sep="\n")
    print(f"yes: {certificate.count} lines hold, {len(certificate.claims)} claims are proved")
    return 0


def join(certificate, reports):
    """The pieces cover all."""
    Replay(certificate, 0, 0)
    held = set()
    for report in reports:
        said = re.fullmatch(r"lines (\d{1,9})-(\d{1,9}) of \d{1,9} hold if those before them do; sha256 ([0-9a-f]{64})\n", text_of(report))
        need(said and said[3] == certificate.digest, f"{report}: is no report of this certificate")
        held.update(range(int(said[1]), min(int(said[2]), certificate.count) + 1))
    missing = sorted(set(range(1, certificate.count + 1)) - held)
    need(not missing, f"line {missing[0] if missing else 0} was proved by no piece", Refused)


if __name__ == "__main__":
    sys.exit(main())
