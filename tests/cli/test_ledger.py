# SPDX-License-Identifier: GPL-3.0-or-later
"""A ledger of one's own: the example's two planted misprints, what a typesetter could change, and bad input."""
import copy
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM, EXAMPLE = sys.argv.pop(1), pathlib.Path(sys.argv.pop(1))


def run(*arguments):
    return subprocess.run([PROGRAM, "paper", *map(str, arguments)], capture_output=True, text=True, timeout=300)


def example():
    return json.loads(re.sub(r"^//.*$", "", (EXAMPLE / "ledger.json").read_text(), flags=re.M))


class Example(unittest.TestCase):
    def test_the_two_misprints_and_only_they_are_refuted(self):
        r = run("--ledger", EXAMPLE, "--json")
        self.assertEqual(r.returncode, 1, r.stderr)
        entries = {e["id"]: e for e in json.loads(r.stdout)}
        self.assertEqual({i for i, e in entries.items() if e["verdict"] == "refuted"}, {"H4", "S4"})
        for misprint in ("H4", "S4"):
            self.assertIn(entries[misprint]["correction_verdict"], ("proved", "verified"))
        for right in ("H3", "H6", "S5"):
            self.assertEqual(entries[right]["verdict"], "proved", entries[right])
        self.assertEqual((entries["W4"]["verdict"], entries["W5"]["verdict"]), ("verified", "verified"))  # a root of a square; and what follows from that
        self.assertEqual(entries["T1"]["verdict"], "verified")
        self.assertFalse([e for e in entries.values() if e["failures"] or e["verdict"] == "undecided"])

    def test_nothing_a_typesetter_does_passes(self):
        r = run("--ledger", EXAMPLE, "--mutate")
        self.assertEqual(r.returncode, 0, r.stdout)
        self.assertRegex(r.stdout, r"\d{3} changes: .* 0 survive")

    def test_one_entry_and_an_unknown_one(self):
        r = run("--ledger", EXAMPLE, "H3")
        self.assertEqual((r.returncode, r.stdout.split()[0]), (0, "proved"))
        r = run("--ledger", EXAMPLE, "H99")
        self.assertEqual((r.returncode, r.stderr.count("\n")), (65, 1))


def with_changes(entry, *changes, corrected=False):
    r = run(entry, "--json", *(["--corrected"] if corrected else []), *(w for c in changes for w in ("--with", c)))
    return r.returncode, json.loads(r.stdout)["verdict"] if r.stdout else r.stderr


class PaperChanged(unittest.TestCase):
    """Misprints an editor would try, and prints that say the same in other words."""

    def test_what_the_generator_does_not_make_is_refuted_too(self):
        for entry, *changes in [
            ("7.18", "M.from=1"), ("7.18", "M.to=n"), ("7.10", "J.from=0"),
            ("2.13", "0.lhs=-lambda/(2*Pi)*acos((pbar-p)/pstar)", "1.rhs=lambda/(2*Pi)*acos((pbar-p)/pstar)"),  # letters changed places
            ("2.17", "rhs=2/Pi*asin(1/2*sqrt((pbar/pstar+1)-sqrt((1-pbar/pstar)^2+(p/pstar)^2)))"),               # a factor out of a root
            ("3.4", "rhs=g_0/1-gamma^(D-2)"),                                                                     # brackets lost
            ("6.7", "rhs=2/Pi*(J1+J2)"),
            ("7.12", "2.rhs=1/2*delta_n+1"),
            ("7.13", "1.rhs=2^delta_n*K_n/sqrt(Pi)*tgamma(3/2+1/2*delta_n)/tgamma(1+1/2*delta_n)"),              # a fraction upside down
            ("7.16", "0.lhs=beta_n", "1.lhs=delta_n"),                                                            # two lines changed places
            ("8.2", "rhs=K_nm1*gamma^((2-D)*n+2*(D-1)*(1-2^(-n)))*ptilde^((1-2)^(-n))"),
            ("9.3", "1.rhs=Pi*pstar_n/lambda_n*sin(2*Pi*lambda_n/a_n)*q_a"),
            ("table1.n07", "rhs=0.392991"),                                                                       # two digits changed places
            ("2.16", "condition=p < pbar-pstar"),                                                                 # half a condition
            ("7.20", "1.digits=0.391387..."),
        ]:
            with self.subTest(entry=entry, changes=changes):
                self.assertEqual(with_changes(entry, *changes, corrected=True), (1, "refuted"))

    def test_what_says_the_same_is_not(self):
        for entry, change in [("2.5", "rhs=lambda/Pi*acos((1-pbar/pstar)^(1/2))"), ("3.4", "rhs=g_0*gamma^2/(gamma^2-gamma^D)"),
                              ("7.16", "0.rhs=1-1/2^(n+1)"), ("8.4", "1.rhs=1/gamma^n")]:
            with self.subTest(entry=entry):
                self.assertEqual(with_changes(entry, change), (0, "proved"))
        self.assertEqual(with_changes("7.17", corrected=True), (0, "proved"))

    def test_what_cannot_be_judged_is_one_line(self):
        for entry, change, code, words in [("7.18", "foo=1", 65, "no field 'foo'"), ("7.18", "rhs", 64, "FIELD=TEXT"), ("7.18", "rhs=((", 65, "no formula"),
                                           ("7.18", "relation=maybe", 65, "no relation"), ("text.beyond-20", "rhs=1", 65, "judged by a number")]:
            with self.subTest(change=change):
                got, line = with_changes(entry, change)
                self.assertEqual(got, code)
                self.assertIn(words, line)
                self.assertEqual(line.count("\n"), 1)
        self.assertEqual(run("--with", "rhs=1").returncode, 64)


class Changed(unittest.TestCase):
    def judge(self, change, *more):
        ledger = copy.deepcopy(example())
        change(ledger)
        return self.judge_text(json.dumps(ledger), *more)

    def judge_text(self, text, *more):
        with tempfile.TemporaryDirectory() as d:
            (pathlib.Path(d) / "ledger.json").write_text(text)
            return run("--ledger", d, *more)

    def entry(self, ledger, name):
        return next(e for e in ledger["entries"] if e["id"] == name)

    def refuses(self, change, *words):
        r = self.judge(change)
        self.assertEqual(r.returncode, 65, r.stdout + r.stderr)
        self.assertEqual(r.stderr.count("\n"), 1, r.stderr)
        for word in ("ledger.json", *words):
            self.assertIn(word, r.stderr)

    def test_a_wrong_digit_in_a_table_is_found(self):
        def change(ledger):
            self.entry(ledger, "T1")["table"]["rows"][2][1] = "0.2930"
        r = self.judge(change, "T1")
        self.assertEqual(r.returncode, 1)
        self.assertIn("zeta = 1", r.stdout)

    def test_cut_off_is_not_rounded(self):
        def change(ledger):
            self.entry(ledger, "T1")["table"]["rounding"] = "down"
        self.assertEqual(self.judge(change, "T1").returncode, 1)  # 0.30028 cut off would be 0.3002

    def test_numbers_below_zero_are_cut_off_towards_it(self):
        def verdict(at, printed):
            table = {"formula": "-y/3", "columns": ["y"], "rounding": "down", "rows": [[at, printed]]}
            ledger = {"symbols": {"y": {"dimension": "1", "sign": "real"}}, "entries": [{"id": "T", "table": table}]}
            return self.judge_text(json.dumps(ledger)).stdout.split()[0]
        for at, printed, expected in (("1", "-0.333", "verified"), ("1", "-0.334", "refuted"), ("1", "-0.332", "refuted"), ("3/10", "-0.1", "verified"),
                                      ("1/10000", "0.000", "verified"), ("-1", "0.333", "verified"), ("-1/10000", "0.000", "verified"), ("1", "0.000", "refuted")):
            self.assertEqual(verdict(at, printed), expected, (at, printed))

    def test_what_is_cut_off_by_little_is_cut_off(self):
        def judged(formula, at, printed, rounding):
            table = {"formula": formula, "columns": ["y"], "rounding": rounding, "rows": [[at, printed]]}
            ledger = {"symbols": {"y": {"dimension": "1", "sign": "positive"}}, "entries": [{"id": "T", "table": table}]}
            return self.judge_text(json.dumps(ledger))
        for formula, printed, expected in (("sqrt(y)", "0.25", "verified"), ("sqrt(y)-10^(-40)", "0.25", "refuted"), ("sqrt(y)-10^(-40)", "0.24", "verified"),
                                           ("sqrt(y)-10^(-300)", "0.25", "refuted")):
            self.assertEqual(judged(formula, "0.0625", printed, "down").stdout.split()[0], expected, (formula, printed))
        for printed in ("1/4", "0x1p-2", "0x0.ep0"):  # whose last place says nothing
            r = judged("sqrt(y)", "0.0625", printed, "nearest")
            self.assertEqual((r.returncode, len(r.stderr.splitlines())), (65, 1), printed)
            self.assertIn("row 1: what is printed is a decimal number", r.stderr)

    def test_a_bound_that_is_too_narrow_is_refuted(self):
        def change(ledger):
            self.entry(ledger, "S5")["says"] = "shear < 0.300"
        self.assertEqual(self.judge(change, "S5").returncode, 1)

    def test_a_bound_that_is_reached_is_not_refuted_where_it_may_be(self):
        for says, refuted in (("shear*(1-shear) <= 1/4", False), ("(shear-1/2)^2 >= 0", False), ("(shear-1/2)^2 > 0", True),
                              ("shear*(1-shear) <= 1/5", True)):
            def change(ledger):
                self.entry(ledger, "S5").update(says=says, over={"shear": ["0", "1"]})
            self.assertEqual(self.judge(change, "S5").stdout.split()[0] in ("refuted", "FAILED"), refuted, says)

    def test_what_is_off_by_a_number_is_refuted_however_small(self):
        for factor in ("(1+1/10^30)", "(1+1/10^60)"):
            def change(ledger):
                self.entry(ledger, "H3")["says"] += "*" + factor
            r = self.judge(change, "H3")
            self.assertEqual((r.returncode, "refuted" in r.stdout), (1, True), factor)

    def test_what_is_less_by_little_is_less_and_what_is_equal_is_not(self):
        def verdict(says, symbol):
            ledger = {"symbols": {"w": {"dimension": "1"}, "u": {"dimension": "1", "is": symbol}}, "entries": [{"id": "A", "says": says}]}
            return self.judge_text(json.dumps(ledger)).stdout.split()[0]
        for says, symbol, expected in (("u > w", "w+1/10^18", "verified"), ("u > w", "w+1/10^200", "verified"), ("u < w", "w+1/10^200", "refuted"),
                                       ("u > w", "w", "refuted"), ("u >= w", "w", "verified"), ("u > sqrt(w)", "w^(1/2)", "refuted"),
                                       ("u <= w", "w*(1+1/10^30)", "refuted"), ("u <= w", "w*(1+1/10^1000)", "refuted"), ("u >= w", "w*(1-1/10^1000)", "refuted"),
                                       ("u <= w", "w*(1-1/10^1000)", "verified"), ("u = w^2", "w^2", "verified"), ("u = w^2", "w^2+1/10^50", "refuted"),
                                       ("u = w^2", "w^2*(1+exp(w)/10^500)", "refuted")):
            self.assertEqual(verdict(says, symbol), expected, (says, symbol))

    def test_what_balls_do_not_decide_is_undecided(self):
        wild = {"c": "2+cos(10^1300*Pi*x)", "one": "10^1230*(exp(log(2)+log(3))-6)+1", "s": "2+sin(exp(exp(10*x)))"}
        symbols = {"x": {"dimension": "1"}, **{name: {"dimension": "1", "is": meaning} for name, meaning in wild.items()}}
        for says, expected in (("c <= 3", "verified"), ("c < 4", "verified"), ("s <= 3", "verified"), ("s > 3", "refuted"), ("c > 3", "refuted"),
                               ("c < 3/2", "undecided"), ("one <= 1", "undecided"), ("one < 1", "undecided")):
            r = self.judge_text(json.dumps({"symbols": symbols, "entries": [{"id": "A", "says": says}]}))
            self.assertEqual(r.stdout.split()[0], expected, says)
            self.assertEqual("balls do not decide part 0" in r.stdout, expected == "undecided", r.stdout)

    def test_formulas_that_differ_on_a_small_part_of_their_range_are_not_the_same(self):
        def verdict(says, other, **more):
            ledger = {"symbols": {"v": {"dimension": "1", "sign": "real"}, "a": {"dimension": "1", "range": ["1", "2"]}, **more},
                      "entries": [{"id": "A", "says": f"v = {says}", "follows": {"equation": "B"}},
                                  {"id": "B", "says": f"v = {other}", "is": "definition"}]}
            return self.judge_text(json.dumps(ledger)).stdout.split()[0]
        self.assertEqual(verdict("abs(19/10-a)", "19/10-a"), "refuted")
        self.assertEqual(verdict("abs(a-1001/1000)", "a-1001/1000"), "refuted")
        self.assertEqual(verdict("abs(a-3/2)+abs(a-39/25)", "abs(2*a-153/50)"), "refuted")
        self.assertEqual(verdict("a^2+(abs(a-19/10)-(19/10-a))/10^60", "a^2"), "refuted")
        self.assertEqual(verdict("abs(a-1)", "a-1"), "verified")
        self.assertEqual(verdict("a^2", "a^2+sin(a)/10^50"), "refuted")
        self.assertEqual(verdict("abs(a-1)+sin(a)/10^500", "a-1"), "refuted")
        # where the ranges do not fit together a side has no value, and that says nothing
        self.assertEqual(verdict("abs(sqrt(a^2-b^2))", "sqrt(a^2-b^2)", b={"dimension": "1", "range": ["1/2", "9/8"]}), "verified")

    def test_of_a_chain_no_more_is_proved_than_its_first_part(self):
        """What follows from another equation is the first right side; further ones are looked at all over the range."""
        def verdict(says, low="0", high="1", of="x*x", **more):
            ledger = {"symbols": {"z": {"dimension": "1", "sign": "real"}, "x": {"dimension": "1", "sign": "positive", "range": [low, high]}},
                      "entries": [{"id": "A", "says": f"z = {says}", "follows": {"equation": "B"}, **more}, {"id": "B", "says": f"z = {of}", "is": "definition"}]}
            result = self.judge_text(json.dumps(ledger))
            return result.stdout.split()[0], result.returncode
        for proved in ("x^2", "x^2 = (x+1)^2-2*x-1 = x^3/x"):
            self.assertEqual(verdict(proved), ("proved", 0), proved)
        for wrong in ("x^2 < 0.7", "x^2 <= 99/100", "x^2 > 1/1000", "x^2 = x^2+(abs(x-0.75)+x-0.75)", "x^2 = x^2+x/10^30", "x^2 < 1 < 2*z", "x^2 = x^2 < 0.7"):
            self.assertEqual(verdict(wrong), ("refuted", 1), wrong)
        for wrong in ("x^2 < 2.5", "x^2 < 3", "x^2 < 3.9", "x^2 = x^2+(abs(x-1.5)+x-1.5)"):
            self.assertEqual(verdict(wrong, "1/4", "2"), ("refuted", 1), wrong)
        for right in ("x^2 < 1", "x^2 = (x+1)^2-2*x-1 < 1", "x^2 < x", "x^2 > 0", "x^2 < 1 < 2", "x^2 < 1+z"):
            self.assertEqual(verdict(right), ("verified", 0), right)
        # where a condition is printed, it is read at the points too: the last of the range are beyond these
        for says, where in (("x^2 < 98/100", "x < 98/100"), ("x^2 = x^2+(abs(x-0.98)+x-0.98)", "0 < x < 0.98"), ("x^2 < 98/100", "z < 96/100")):
            self.assertEqual(verdict(says, where=where), ("verified", 0), says)
            self.assertEqual(verdict(says), ("refuted", 1), says)
        self.assertEqual(verdict("x^2 < 0.7", where="x < 0.98"), ("refuted", 1))

    def verdicts(self, symbols, *entries):
        """By entry, and the exit code; what is said of a symbol that has no dimension is a number."""
        ledger = {"symbols": {name: {"dimension": "1", **about} for name, about in symbols.items()}, "entries": list(entries)}
        r = self.judge_text(json.dumps(ledger), "--json")
        return {e["id"]: e["verdict"] for e in json.loads(r.stdout)} if r.stdout else r.stderr

    def test_powers_of_powers_are_as_large_as_they_are(self):
        huge = "((((((x)^65536)^4096)^2048)^2048)^1024)^16"  # x^(2^64)
        for says, verdict in ((f"{huge} < 2", "refuted"), (f"{huge}*x < 3", "refuted"), (f"1/({huge}) > 1/2", "refuted")):
            self.assertEqual(self.verdicts({"x": {}}, {"id": "B", "says": says, "over": {"x": ["1", "2"]}}), {"B": verdict}, says)
        table = {"id": "T", "table": {"formula": huge, "columns": ["x"], "rows": [["2", "1.000"]]}}
        self.assertEqual(self.verdicts({"x": {}}, table), {"T": "refuted"})

    def test_what_is_positive_is_so_wherever_a_root_or_modulus_was_simplified_by_it(self):
        real, y = {"sign": "real"}, {"sign": "real"}
        a = {"id": "A", "says": "y = abs(x)", "is": "definition"}

        def refused(answer, *words):
            self.assertIsInstance(answer, str, answer)
            for word in ("ledger.json", "is positive", *words):
                self.assertIn(word, answer)
        for says in ("abs(x) < 1", "sqrt(x^2) < 3/5", "(x^4)^(1/4) < 3/5"):
            refused(self.verdicts({"x": {}}, {"id": "B", "says": says, "over": {"x": ["-5", "1/2"]}}), "'B'", "-5")
        refused(self.verdicts({"x": {}}, {"id": "T", "table": {"formula": "abs(x)", "columns": ["x"], "rows": [["-5", "-5.0"]]}}), "'T'", "row 1")
        refused(self.verdicts({"x": {}, "z": {}, "y": y}, a, {"id": "B", "says": "y = -z", "follows": {"equation": "A", "with": {"x": "-z"}}}), "'B'")
        refused(self.verdicts({"x": {}, "y": y, "d": {"is": "x-3"}}, {"id": "B", "says": "y = sqrt(d^2)"}), "'d'")
        # said to be real, it is right as it stands
        b = {"id": "B", "says": "y = z", "follows": {"equation": "A", "with": {"x": "-z"}}}
        self.assertEqual(self.verdicts({"x": real, "z": {}, "y": y}, a, b), {"A": "definition", "B": "proved"})
        self.assertEqual(self.verdicts({"x": {"sign": "real", "range": ["-5", "1/2"]}}, {"id": "B", "says": "abs(x) < 1", "over": {"x": ["-5", "1/2"]}}), {"B": "refuted"})
        # where the condition of the entry leaves out what is negative, the sign is right
        c = {"id": "C", "says": "y = 1-z", "follows": {"equation": "A", "with": {"x": "1-z"}}}
        refused(self.verdicts({"x": {}, "z": {}, "y": y}, a, c), "'C'")
        self.assertIsInstance(self.verdicts({"x": {}, "z": {}, "y": y}, a, {**c, "where": "z < 1"}), dict)

    def test_from_a_bound_and_under_a_condition_follows_no_more_than_it_says(self):
        y = {"sign": "real"}
        for relation in ("<", ">=", "~"):
            a = {"id": "A", "says": f"y {relation} x", "is": "definition"}
            self.assertEqual(self.verdicts({"x": {}, "y": y, "z": y}, a, {"id": "B", "says": "z = 2", "follows": {"equation": "A", "with": {"x": "2"}}})["B"], "undecided")
            self.assertEqual(self.verdicts({"x": {}, "y": y}, a, {"id": "B", "says": "y = x", "follows": {"equation": "A"}})["B"], "undecided")
        a = {"id": "A", "says": "y = 1-x", "where": "x < 1", "is": "definition"}
        wide = {"x": {"range": ["0", "3"]}, "y": y, "z": y}
        self.assertEqual(self.verdicts(wide, a, {"id": "B", "says": "z = -1", "follows": {"equation": "A", "with": {"x": "2"}}})["B"], "undecided")
        self.assertEqual(self.verdicts(wide, a, {"id": "B", "says": "y = 1-x", "follows": {"equation": "A"}})["B"], "undecided")
        self.assertEqual(self.verdicts(wide, a, {"id": "B", "says": "z = 1/2", "follows": {"equation": "A", "with": {"x": "1/2"}}})["B"], "proved")
        d = {"id": "D", "says": "z = 2-w", "is": "definition"}
        self.assertEqual(self.verdicts({**wide, "w": y}, a, d, {"id": "B", "says": "z = 1+x", "follows": {"equation": "D", "with": {"w": "@A"}}})["B"], "undecided")
        # and a printed condition is read where it holds
        m = {"id": "M", "says": "y = abs(x-0.95)", "is": "definition"}
        unit = {"x": {"sign": "real", "range": ["0", "1"]}, "y": y}
        b = {"id": "B", "says": "y = 0.95-x", "where": "x < 0.9", "follows": {"equation": "M"}}
        self.assertEqual(self.verdicts(unit, m, b)["B"], "verified")
        self.assertEqual(self.verdicts(unit, m, {**b, "where": "x < 99/100"})["B"], "refuted")

    def test_what_cannot_be_read_when_it_is_written_out_is_told_by_its_entry(self):
        y = {"sign": "real"}
        symbols = {"x": {}, "b": {"is": "x-x"}, "a": {"is": "1/b"}, "y": y}
        a = {"id": "A", "says": "y = x", "is": "definition"}
        self.assertEqual(self.verdicts(symbols, a), {"A": "definition"})
        self.assertEqual(self.verdicts(symbols, a, {"id": "B", "says": "y = a", "follows": {"equation": "A"}})["B"], "refuted")
        c = {"id": "C", "says": "y = x", "where": "s < 1/(w-x)", "follows": {"equation": "A", "with": {"x": "s-9"}}}
        self.assertEqual(self.verdicts({"x": {}, "w": {"is": "x"}, "s": {}, "y": y}, a, c)["C"], "refuted")

    def test_what_follows_from_a_refuted_print_is_not_proved_by_it(self):
        y = {"sign": "real"}
        symbols = {"x": {}, "z": {"is": "2*x"}, "y": y, "w": y}
        a = {"id": "A", "says": "z = x"}
        b = {"id": "B", "says": "y = x", "follows": {"equation": "A"}}
        c = {"id": "C", "says": "w = x", "follows": {"equation": "B"}}
        self.assertEqual(self.verdicts(symbols, a, b, c), {"A": "refuted", "B": "undecided", "C": "undecided"})
        mended = {**a, "correction": {"wrong": "a factor", "edits": [{"from": "x", "to": "2*x"}]}}
        self.assertEqual(self.verdicts(symbols, mended, {**b, "says": "y = 2*x"}, {**c, "says": "w = 2*x"}), {"A": "refuted", "B": "proved", "C": "proved"})
        self.assertEqual(self.verdicts(symbols, {**a, "says": "z = 2*x"}, {**b, "says": "y = 2*x"}, c), {"A": "verified", "B": "proved", "C": "refuted"})

    def test_what_a_symbol_stands_for_is_reached_by_what_is_put_in_and_by_derivatives(self):
        y = {"sign": "real"}
        with_square = {"x": {}, "y": y, "d": y, "a": {"is": "x^2"}}
        a = {"id": "A", "says": "y = a*x", "is": "definition"}
        by_x = {"equation": "A", "derivative_by": "x"}
        for says, verdict in (("d = a", "refuted"), ("d = 3*a", "proved"), ("d = 3*x^2", "proved")):
            self.assertEqual(self.verdicts(with_square, a, {"id": "B", "says": says, "follows": by_x})["B"], verdict, says)
        with_sum = {"x": {"sign": "real"}, "y": y, "y0": y, "c": {"is": "x^2+1"}, "b": {"is": "c+1"}}
        s = {"id": "A", "says": "y = b+x", "is": "definition"}
        for says, verdict in (("y0 = b", "refuted"), ("y0 = 2", "proved")):
            self.assertEqual(self.verdicts(with_sum, s, {"id": "B", "says": says, "follows": {"equation": "A", "with": {"x": "0"}}})["B"], verdict, says)
        # the same in other words
        e = {"id": "A", "says": "y = x", "is": "definition"}
        for says in ("y = a", "y = x = a"):
            self.assertEqual(self.verdicts({"x": {}, "y": y, "a": {"is": "x"}}, e, {"id": "B", "says": says, "follows": {"equation": "A"}})["B"], "proved", says)

    def test_a_bound_is_read_over_its_own_range_and_a_chain_may_be_equal_in_between(self):
        y = {"sign": "real"}
        t = {"t": {"range": ["1", "9/4"]}, "x": {"is": "t^40"}, "z": y}
        over = {"t": ["1/4", "1/2"]}
        self.assertEqual(self.verdicts(t, {"id": "B", "says": "t < 1.5", "over": over}), {"B": "proved"})
        self.assertEqual(self.verdicts(t, {"id": "B", "says": "t < 0.4", "over": over}), {"B": "refuted"})
        self.assertEqual(self.verdicts(t, {"id": "B", "says": "x < 1", "over": {"x": ["1/4", "1/2"]}}), {"B": "proved"})
        a = {"id": "A", "says": "z = t^2", "is": "definition"}
        chain = {"id": "B", "says": "z = t^2 < 1/3", "follows": {"equation": "A"}, "over": over}
        self.assertEqual(self.verdicts(t, a, chain)["B"], "proved")
        self.assertEqual(self.verdicts(t, a, {**chain, "says": "z = t^2 = (t+1)^2-2*t-1 < 1/3"})["B"], "proved")
        for wrong in ("z = t^2 < 1/5", "z = t^2 = t^3 < 1/3", "z = t^3 < 1/3"):
            self.assertEqual(self.verdicts(t, a, {**chain, "says": wrong})["B"], "refuted", wrong)
        self.assertEqual(self.verdicts(t, {"id": "B", "says": "5.*t > 1", "over": over}), {"B": "proved"})

    def test_a_number_is_what_stands_there_and_not_the_nearest_double(self):
        """JSON's numbers with a point are doubles when they are read: they have to stand in quotes."""
        def judged(rows, **more):
            table = {"formula": "x", "columns": ["x"], "rows": "ROWS"}
            ledger = {"symbols": {"x": {"dimension": "1", "range": "RANGE"}}, "entries": [{"id": "T", "table": table}, {"id": "B", "says": "x < 9", "over": {"x": "OVER"}}]}
            text = json.dumps(ledger).replace('"ROWS"', rows)
            for name in ("RANGE", "OVER"):
                text = text.replace(f'"{name}"', more.get(name, '["1/4", "1"]'))
            return self.judge_text(text)
        for rows in ('[["1/2", 0.50000000000000000004]]', '[["2/3", 0.66666666666666666667]]', '[[0.1000000000000000000001, "0.1"]]',
                     '[[123456789012345678901234567890, "0.1"]]', '[["1/2", 5e-1]]'):
            r = judged(rows)
            self.assertEqual((r.returncode, r.stderr.count("\n")), (65, 1), r.stdout + r.stderr)
            self.assertRegex(r.stderr, "'T': table: row 1: .* in quotes")
        for name, where in (("RANGE", "'x'"), ("OVER", "'B': over x")):
            r = judged('[["1/2", "0.5"]]', **{name: "[0, 0.10000000000000000000001]"})
            self.assertEqual((r.returncode, r.stderr.count("\n")), (65, 1), r.stdout + r.stderr)
            self.assertIn(where, r.stderr)
        self.assertEqual(judged('[["1/2", "0.50000000000000000004"]]').returncode, 1)
        self.assertEqual(judged('[["2/3", "0.66666666666666666667"], [2, 2]]', OVER="[0, 1]").returncode, 0)

    def test_from_a_bound_the_bound_of_the_same_follows_within_its_range(self):
        real = {"sign": "real", "range": ["0", "1"]}
        a = {"id": "A", "says": "x^2 <= 1", "over": {"x": ["-1/2", "1/2"]}}
        b = {"id": "B", "says": "x^80*2 <= 1", "follows": {"equation": "A"}}
        self.assertEqual(self.verdicts({"x": real}, a, b), {"A": "proved", "B": "undecided"})
        side = {"id": "B", "says": "1/30 < x", "follows": {"equation": "A", "side": "lhs"}}
        self.assertEqual(self.verdicts({"x": real}, {"id": "A", "says": "x < 2", "over": {"x": ["0", "1"]}}, side), {"A": "proved", "B": "undecided"})
        c = {"id": "C", "says": "x^2 < x+3", "over": {"x": ["0", "2"]}}

        def from_c(low, high, says="x^2 < x+3", **follows):
            return self.verdicts({"x": {"range": [low, high]}, "u": {"range": [low, high]}}, c, {"id": "D", "says": says, "follows": {"equation": "C", **follows}})["D"]
        self.assertEqual(from_c("0", "12/5"), "undecided")
        self.assertEqual(from_c("1/4", "2"), "proved")
        self.assertEqual(from_c("1/4", "1", "4*u^2 < 2*u+3", **{"with": {"x": "2*u"}}), "proved")
        self.assertEqual(from_c("1/4", "11/10", "4*u^2 < 2*u+3", **{"with": {"x": "2*u"}}), "undecided")
        self.assertEqual(from_c("1/4", "1", "1 < 4", **{"with": {"x": "1"}}), "proved")
        # and further on
        d = {"id": "D", "says": "x^2 < x+3", "follows": {"equation": "C"}}
        e = {"id": "E", "says": "100*u^2 < 10*u+3", "follows": {"equation": "D", "with": {"x": "10*u"}}}
        self.assertEqual(self.verdicts({"x": {"range": ["0", "1"]}, "u": {"range": ["0", "1/4"]}}, c, d, e), {"C": "proved", "D": "proved", "E": "undecided"})
        # what stands for something that is looked at has no range of its own
        t = {"t": {"range": ["1/4", "1/2"]}, "x": {"is": "t^40"}}
        b = {"id": "B", "says": "109*10^10*x < 1", "follows": {"equation": "A", "with": {"x": "109*10^10*x"}}}
        self.assertEqual(self.verdicts(t, {"id": "A", "says": "x < 1", "over": {"t": ["1/4", "1/2"]}}, b)["B"], "undecided")

    def test_signs_hold_over_the_entrys_own_ranges(self):
        real, s = {"sign": "real", "range": ["1", "2"]}, {"is": "x-1/2"}
        symbols = {"x": real, "u": real, "s": s, "y": {"sign": "real"}, "z": {"sign": "real"}}
        b = {"id": "B", "says": "y = sqrt(s^2)", "is": "definition"}
        over = {"over": {"x": ["0", "1/4"]}}  # where s is negative
        self.assertEqual(self.verdicts(symbols, {"id": "A", "says": "sqrt(s^2) < 1/100", **over}), {"A": "undecided"})
        self.assertEqual(self.verdicts(symbols, b, {"id": "C", "says": "y = s < 0", "follows": {"equation": "B"}, **over})["C"], "undecided")
        for put, says, verdict in (("u-3", "z = u-7/2", "undecided"), ("u+3", "z = u+5/2", "proved")):
            self.assertEqual(self.verdicts(symbols, b, {"id": "C", "says": says, "follows": {"equation": "B", "with": {"x": put}}})["C"], verdict, put)
        # what is declared positive has no negative numbers, shown to be so or not
        squared = {"x": {"sign": "real", "range": ["-1", "1"]}, "s": {"is": "x^2"}}
        for entry in ({"table": {"formula": "s^3", "columns": ["s"], "rows": [["-1", "-1"]]}}, {"says": "s < 3", "over": {"s": ["-1", "1"]}}):
            self.assertIn("'s' is positive, -1 is not", self.verdicts(squared, {"id": "A", **entry}))

    def test_what_is_looked_at_at_points_alone_is_not_handed_on_as_proved(self):
        real = {"sign": "real", "range": ["0", "231/100"]}
        bound = self.verdicts({"x": real, "a": {"sign": "real", "is": "x^2"}}, {"id": "B", "says": "a < x+3"}, {"id": "C", "says": "x^2 < x+3", "follows": {"equation": "B"}})
        self.assertEqual(bound, {"B": "verified", "C": "verified"})  # false at 2.305
        b, part = {"id": "B", "says": "y = sqrt(s^2)", "is": "definition"}, {"says": "y = abs(x-1/3)-1/10^3", "where": "x < 2"}
        c = {"id": "C", **part, "follows": {"equation": "B", "with": {"s": "abs(x-1/3)-1/10^3"}}}
        self.assertEqual(self.verdicts({"x": {**real, "range": ["0", "1"]}, "s": {}, "y": {"sign": "real"}}, b, c, {"id": "D", **part, "follows": {"equation": "C"}}),
                         {"B": "definition", "C": "verified", "D": "verified"})
        symbols = {"x": {**real, "range": ["-1/100", "1"]}, "a": {"sign": "real", "is": "abs(x)"}, "y": {"sign": "real"}}
        self.assertEqual(self.verdicts(symbols, {"id": "B", "says": "a = x"}, {"id": "D", "says": "y = a^3", "is": "definition"},
                                       {"id": "C", "says": "y = x^3", "follows": {"equation": "D", "with": {"a": "@B"}}})["C"], "verified")

    def test_a_name_means_one_thing_in_all_that_an_entry_follows_from(self):
        symbols = {name: {"sign": "real", "range": ["1", "2"]} for name in "xuywz"}

        def last(*entries):
            return list(self.verdicts(symbols, *({"id": "ABC"[k], **e} for k, e in enumerate(entries))).values())[-1]
        definition, from_a = {"is": "definition"}, {"follows": {"equation": "A"}}
        slope = {"follows": {"equation": "A", "derivative_by": "x"}}
        self.assertEqual(last({"says": "2*y = x^2", **definition}, {"says": "y = x^2", **from_a}), "undecided")
        self.assertEqual(last({"says": "w = x^2 = y", **definition}, {"says": "y = 2*x", **slope}), "undecided")
        self.assertEqual(last({"says": "w = y+1", **definition}, {"says": "y = 5", "follows": {"equation": "A", "with": {"y": "4"}}}), "undecided")
        self.assertEqual(last({"says": "y = x^2", **definition}, {"says": "w = 2*x", **slope}, {"says": "x = 2", "follows": {"equation": "B", "derivative_by": "x"}}), "undecided")
        self.assertEqual(last({"says": "y = x^2", **definition}, {"says": "z = 0", "follows": {"equation": "A", "side": "lhs", "derivative_by": "x"}}), "undecided")
        self.assertEqual(last({"says": "y = x^2", **definition}, {"says": "y = 1", "follows": {"equation": "A", "with": {"x": "u/(u+1)+1/(u+1)"}}}), "undecided")
        # a variable that is scaled is the same quantity in other words
        self.assertEqual(last({"says": "y = w*sqrt(4-x^2/z^2)", **definition}, {"says": "y = w*sqrt(4-u^2)", "follows": {"equation": "A", "with": {"x": "z*u"}}}), "proved")

    def test_two_forms_of_a_root_are_not_one_times_each_other(self):
        symbols = {"p": {}, "nu": {"sign": "real", "range": ["0", "1/2"]}, "y": {"sign": "real"}, "z": {"sign": "real"}}
        for first, second in (("sqrt(p/(1-nu^2))", "sqrt(p)/sqrt(1-nu^2)"), ("sqrt(p)/sqrt(1-nu)", "sqrt(p/(1-nu))")):
            self.assertIn(self.verdicts(symbols, {"id": "B", "says": f"y = {first}", "is": "definition"}, {"id": "C", "says": f"z = {second}", "follows": {"equation": "B"}})["C"],
                          ("proved", "verified"))

    def test_a_condition_has_something_on_both_sides_in_corrections_too(self):
        a = {"id": "A", "says": "y = x", "is": "definition"}
        for where in ("x >> 0", "0 < x <", "x <= <= 1/2", "< x"):
            self.assertIn("where", self.verdicts({"x": {}, "y": {}}, {**a, "where": where}))
        for field, to in (("condition", "= 0"), ("condition", "> sqrt("), ("relation", "&&"), ("relation", "==")):
            edits = [{"field": field, "from": {"relation": "=", "condition": "> 0"}[field], "to": to}]
            said = self.verdicts({"x": {}, "y": {}}, {**a, "where": "x > 0", "correction": {"wrong": "w", "edits": edits}})
            self.assertIn("correction", str(said))
            self.assertIsInstance(said, str)

    def test_what_is_put_in_by_its_name_is_an_equation(self):
        symbols = {"a": {"range": ["1", "2"]}, "y": {"sign": "real"}, "z": {"sign": "real"}}
        b = {"id": "B", "says": "a < 4", "over": {"a": ["1", "2"]}}
        d = {"id": "D", "says": "y = a^2", "is": "definition"}
        c = {"id": "C", "says": "z = 16", "follows": {"equation": "D", "with": {"a": "@B"}}}
        self.assertEqual(self.verdicts(symbols, b, d, c), {"B": "proved", "D": "definition", "C": "undecided"})

    def test_what_follows_from_an_undecided_print_is_undecided(self):
        real = {"sign": "real"}
        symbols = {"x": {**real, "range": ["-1", "1"]}, "y": real, "z": real, "w": real}
        a = {"id": "A", "says": "y = abs(x)", "is": "definition"}
        b = {"id": "B", "says": "z = x", "where": "x > 0", "is": "definition"}
        c = {"id": "C", "says": "w = x", "follows": {"equation": "B"}}
        d = {"id": "D", "says": "y = x", "follows": {"equation": "C"}}
        self.assertEqual(self.verdicts(symbols, a, b, c, d), {"A": "definition", "B": "definition", "C": "undecided", "D": "undecided"})
        n = {"id": "N", "says": "2*y = 2*x"}
        self.assertEqual(self.verdicts(symbols, n, {"id": "C", "says": "w = 2*x", "follows": {"equation": "N"}}), {"N": "undecided", "C": "undecided"})

    def test_a_left_side_that_has_a_value_is_compared_too(self):
        real = {"sign": "real"}
        symbols = {"x": {**real, "range": ["-1/100", "1"]}, "y": real, "w": real, "a": {"is": "abs(x)"}, "b": {**real, "is": "(x+1)^2-x^2"}}
        b = {"id": "B", "says": "y = x", "is": "definition"}

        def verdict(says, *entries, **follows):
            return self.verdicts(symbols, *(entries or [b]), {"id": "C", "says": says, "follows": {"equation": "B", **follows}})["C"]
        for says in ("abs(x) = x", "a = x"):
            self.assertEqual(verdict(says), "refuted", says)
        self.assertEqual(verdict("(x+1)^2-x^2-x-1 = x"), "proved")
        self.assertEqual(verdict("b = 2*x+1", {"id": "B", "says": "y = 2*x+1", "is": "definition"}), "proved")
        self.assertEqual(verdict("abs(x) >= x"), "verified")
        # y is x^2: its derivative is something else, and so is its value at a place
        square = {"id": "B", "says": "y = x^2", "is": "definition"}
        for says, follows in (("y = 2*x", {"derivative_by": "x"}), ("y = 4*x^2", {"with": {"x": "2*x"}}), ("y = 1/4", {"with": {"x": "1/2"}})):
            self.assertEqual(verdict(says, square, **follows), "undecided", says)
            self.assertEqual(verdict(says.replace("y", "w"), square, **follows), "proved", says)
        d = {"id": "D", "says": "w = 2*x", "follows": {"equation": "B", "derivative_by": "x"}}
        self.assertEqual(self.verdicts(symbols, square, d, {"id": "C", "says": "y = 2*x", "follows": {"equation": "D"}})["C"], "undecided")
        self.assertEqual(self.verdicts({**symbols, "z": {}}, square, {"id": "C", "says": "y = z^2", "follows": {"equation": "B", "with": {"x": "z"}}})["C"], "proved")

    def test_a_power_with_a_symbol_in_its_exponent_has_the_sign_of_what_is_under_it(self):
        real = {"sign": "real"}
        symbols = {"a": {**real, "range": ["1", "2"]}, "b": {**real, "range": ["3", "4"]}, "n": {**real, "range": ["0", "92"]}, "p": {}, "y": real, "z": real}

        def verdict(of, says):
            return self.verdicts(symbols, {"id": "B", "says": f"y = {of}", "is": "definition"}, {"id": "C", "says": f"z = {says}", "follows": {"equation": "B"}})["C"]
        for of, says in (("(a-b)^n", "(b-a)^n"), ("a^n", "(-a)^n"), ("p^n", "(-p)^n"), ("((-a)^n)^(1/2)", "(-a)^(n/2)")):
            self.assertNotEqual(verdict(of, says), "proved", of)
        for of, says in (("(b-a)^n*(b-a)", "(b-a)^(n+1)"), ("(b-a)^(2*n)", "((b-a)^n)^2"), ("(1-a/b)^n*(1-a/b)", "(1-a/b)^(n+1)"), ("(5-a^2)^n", "1/(5-a^2)^(-n)"), ("(-p)^n*p^2", "(-p)^(n+2)")):
            self.assertEqual(verdict(of, says), "proved", of)

    def test_a_sign_is_shown_over_all_of_the_ranges_or_not_used(self):
        near = "abs(x-1/3)-1/10^3"  # below 0 between the points that are looked at
        symbols = {"x": {"sign": "real", "range": ["0", "1"]}, "y": {}, "z": {}}
        b = {"id": "B", "says": "y = sqrt(s^2)", "is": "definition"}
        c = {"id": "C", "says": f"z = {near}", "follows": {"equation": "B"}}
        refused = self.verdicts({**symbols, "s": {"is": near}}, b, c)
        self.assertIsInstance(refused, str)
        self.assertIn("symbol 's': is positive", refused)
        self.assertEqual(self.verdicts({**symbols, "s": {}}, b, {**c, "follows": {"equation": "B", "with": {"s": near}}})["C"], "undecided")
        # what is 0 at an end is not shown to be positive in balls: it is not simplified, and proved where that needs no sign
        zero = {"is": "x-x^2/sqrt(1+x^2)"}
        self.assertEqual(self.verdicts({**symbols, "s": zero}, b, {**c, "says": "z = x-x^2/sqrt(1+x^2)"})["C"], "verified")
        self.assertEqual(self.verdicts({**symbols, "s": zero}, {**b, "says": "y = 2*s"}, {**c, "says": "z = 2*x-2*x^2/sqrt(1+x^2)"})["C"], "proved")
        for put in ("x", "1-x", "z^2+1", "2-x^2", "0"):
            self.assertEqual(self.verdicts({**symbols, "s": {}, "w": {}}, b, {**c, "says": f"w = {put}", "follows": {"equation": "B", "with": {"s": put}}})["C"], "proved", put)

    def test_a_condition_is_read_with_its_equality_and_what_it_leaves_out_refutes_nothing(self):
        real = {"sign": "real"}
        b = {"id": "B", "says": "y = x^2", "where": "x <= 1", "is": "definition"}
        symbols = {"x": {"range": ["1/4", "3/4"]}, "y": {}, "w": {}}
        for where, verdict in (("x <= 1", "proved"), ("1 >= x", "proved"), ("x < 1", "undecided"), ("1 > x", "undecided"), ("x <= 99/100", "undecided")):
            c = {"id": "C", "says": "w = 1", "follows": {"equation": "B", "with": {"x": "1"}}}
            self.assertEqual(self.verdicts(symbols, {**b, "where": where}, c)["C"], verdict, where)
        s = {"x": {**real, "range": ["-1", "1"]}, "s": {}, "y": {}}
        root = {"id": "B", "says": "y = sqrt(s^2)", "is": "definition"}
        self.assertEqual(self.verdicts(s, root, {"id": "C", "says": "y = x", "where": "x > 0", "follows": {"equation": "B", "with": {"s": "x"}}})["C"], "verified")
        a = {"id": "B", "says": "y = abs(x)", "is": "definition"}
        c = {"id": "C", "says": "w = x", "where": "x > 0", "follows": {"equation": "B"}}
        wide = {"x": {**real, "range": ["-1", "3"]}, "y": {}, "w": {}}
        self.assertEqual(self.verdicts(wide, a, c)["C"], "verified")
        self.assertEqual(self.verdicts(wide, a, {**c, "where": "x > -1/2"})["C"], "refuted")

    def test_names_of_numbers_that_a_text_does_not_mean_are_symbols(self):
        about = {"F": "force", "L": "length", "E": "force/length^2", "I": "length^4", "w": "length", "Euler": "1", "Catalan": "1", "symbol_I": "length^4"}
        symbols = {name: {"dimension": dimension} for name, dimension in about.items()}
        beam = {"id": "1", "says": "w = F*L^3/(3*E*I)*Euler/Catalan", "is": "definition"}
        for says, verdict in (("w = 8*F*L^3/(24*E*I)/Catalan*Euler", "proved"), ("w = F*L^3/(3*E*symbol_I)*Euler/Catalan", "refuted")):
            self.assertEqual(self.verdicts(symbols, beam, {"id": "2", "says": says, "follows": {"equation": "1"}})["2"], verdict)
        gamma = {"id": "B", "says": "y = log(tgamma(x))-log(tgamma(x-2/3))", "is": "definition"}
        c = {"id": "C", "says": "z = Pi/(2*sqrt(3))+3/2*log(3)", "follows": {"equation": "B", "derivative_by": "x", "with": {"x": "1"}}}
        self.assertEqual(self.verdicts({"x": {"range": ["3/4", "2"]}, "y": {"sign": "real"}, "z": {}}, gamma, c)["C"], "verified")

    def test_long_powers_are_not_multiplied_out(self):
        for of, says, verdict in (("(x+1)^1000", "(x+2)^1000", "refuted"), ("(a+b+c+d)^30", "(a+b+2*c+d)^30", "refuted"), ("(x+1)^1000", "(x+1)^998*(x^2+2*x+1)", "verified"),
                                  ("(x+1)^1000", "(x+1)^1001/(1+x)", "proved"), ("(a+b)^900*c^n", "(b+a)^900*c^(n+1)/c", "proved")):
            symbols = {**{name: {} for name in "abcdxn"}, "y": {}}
            found = self.verdicts(symbols, {"id": "B", "says": f"y = {of}", "is": "definition"}, {"id": "C", "says": f"y = {says}", "follows": {"equation": "B"}})
            self.assertEqual(found["C"], verdict, says)

    def test_what_has_no_meaning_is_refused_when_it_is_read(self):
        symbols = {"x": {}, "y": {"is": "x"}, "s": {"sign": "real"}}
        a = {"id": "A", "says": "y = x", "is": "definition"}

        def refused(answer, *words):
            self.assertIsInstance(answer, str, answer)
            self.assertEqual(answer.count("\n"), 1, answer)
            for word in ("ledger.json", *words):
                self.assertIn(word, answer)
        for formula in ("sqrt(-4)*x", "log(-1)*x"):
            table = {"formula": formula, "columns": ["x"], "rows": [["0.5", "1.0"]]}
            refused(self.verdicts(symbols, {"id": "T", "table": table}), "'T'", "no real value")
            refused(self.verdicts({**symbols, "p": {"is": formula}}, a), "'p'", "no real value")
            refused(self.verdicts(symbols, {**a, "where": f"x < {formula}"}), "'A': where", "no real value")
            refused(self.verdicts(symbols, {"id": "B", "says": "s = x", "follows": {"equation": "A", "with": {"x": formula}}}, a), "'B': with", "no real value")
        refused(self.verdicts(symbols, {"id": "T", "table": {"formula": "Euler*x", "columns": ["x"], "rows": [["0.5", "1.0"]]}}), "'Euler' has no dimension")
        for name in ("Pi", "sin", "sqrt"):
            refused(self.verdicts({**symbols, name: {}}, a), f"'{name}'", "function or a number")
        for where in ("x - 100", "0"):
            refused(self.verdicts(symbols, {**a, "where": where}), "'A': where", "no relation")
        refused(self.verdicts(symbols, {"id": "A", "says": "y = x", "over": {"x": ["0", "1"]}}), "'A'", "over")
        for to, word in (("x*(", "parse"), ("x+q", "'q' has no dimension")):
            refused(self.verdicts(symbols, {**a, "correction": {"wrong": "a bracket", "edits": [{"from": "x", "to": to}]}}), "'A': correction", word)
        r = self.judge_text('{"symbols": {"x": {"dimension": "1"}}, "entries": [{"id": "A", "says": "x = 2", "says": "x = 1", "is": "definition"}]}')
        self.assertEqual(r.returncode, 65)
        self.assertIn("'says' comes twice", r.stderr)
        # what stands between two relations is mended on both sides
        chain = {"id": "A", "says": "y = 2*x < 3", "over": {"x": ["1/4", "9/4"]}, "correction": {"wrong": "a factor", "edits": [{"from": "2*x", "to": "x"}]}}
        ledger = {"symbols": {name: {"dimension": "1", **about} for name, about in symbols.items()}, "entries": [chain]}
        self.assertEqual(json.loads(self.judge_text(json.dumps(ledger), "--json").stdout)[0]["correction_verdict"], "proved")

    def test_a_sign_after_an_operator_binds_its_operand_alone(self):
        for formula, at_2 in (("10^-3*x", "0.002"), ("2^-x^2", "0.0625"), ("8/-x*2", "-8.0"), ("8/-x+1", "-3.0"), ("5--x+1", "8.0"), ("2^+x*3", "12"), ("5*+x+1", "11"), ("2*-x+3", "-1"),
                              ("2*-+- x ^2*2+1", "17"), ("8/-sqrt(2*x)*2", "-8"), ("2^-x^-1*2", "1.4142"), ("4*-(x-1)^2+x", "-2")):
            t = {"id": "T", "table": {"formula": formula, "columns": ["x"], "rows": [["2", at_2]]}}
            self.assertEqual(self.verdicts({"x": {}}, t), {"T": "verified"}, formula)
        real = {"sign": "real", "range": ["1", "3"]}
        symbols = {"x": real, "y": real, "z": real, "w": real, "k": {**real, "is": "10^-3*x"}}
        b = {"id": "B", "says": "y = x^-2*4", "is": "definition"}

        def from_b(says, **follows):
            return self.verdicts(symbols, b, {"id": "C", "says": says, "follows": {"equation": "B", **follows}})["C"]
        self.assertEqual((from_b("z = x^(-8)"), from_b("z = 4/x^2"), from_b("z = 4*w^2", **{"with": {"x": "w^-1*1"}})), ("refuted", "proved", "proved"))
        self.assertEqual(self.verdicts(symbols, {"id": "K", "says": "k = x/1000"}), {"K": "verified"})
        self.assertEqual(self.verdicts(symbols, {"id": "K", "says": "2*-x+3 > 0", "over": {"x": ["1", "5/2"]}}), {"K": "refuted"})
        powers = {"F": {"dimension": "force"}, "E": {"dimension": "force/length^2"}, "L": {"dimension": "length"}}
        self.assertEqual(self.verdicts(powers, {"id": "B", "says": "F = E*L^2", "is": "definition"}, {"id": "C", "says": "F = E*L^-2*L^4", "follows": {"equation": "B"}})["C"], "proved")
        for nothing in ("2*-", "x^-*2", "2*-(x"):
            self.assertIn("does not parse", self.verdicts({"x": {}, "y": {}}, {"id": "A", "says": f"y = {nothing}", "is": "definition"}))

    def test_what_has_no_value_as_it_is_written_is_not_proved(self):
        """What is simplified away while a formula is read may have no value at all, or none on a part of the range."""
        x, y = {"sign": "real", "range": ["-3", "3"]}, {"sign": "real"}
        for says, ends, verdict in (("sin(asin(x)) < 5", ["-3", "-2"], "undecided"), ("sin(asin(x)) < 5", ["-1/2", "1/2"], "proved"), ("cos(acos(x)) < 5", ["1/2", "2"], "undecided"),
                                    ("sqrt(x-5)^2 < 3", ["1", "2"], "undecided"), ("exp(log(x)) < 5", ["-2", "-1"], "undecided"), ("x+log(x)-log(x) < 5", ["-2", "2"], "undecided"),
                                    ("0*sqrt(x)+x < 5", ["-2", "2"], "undecided"), ("exp(log(x)) < 5", ["1", "2"], "proved"), ("sqrt(asin(x)^2)*0 < 5", ["2", "3"], "undecided")):
            self.assertEqual(self.verdicts({"x": x, "y": y}, {"id": "B", "says": says, "over": {"x": ends}}), {"B": verdict}, (says, ends))
        b = {"id": "B", "says": "y = x", "is": "definition"}
        hidden = {"x": {**x, "range": ["2", "3"]}, "y": y, "z": y, "s": {"sign": "real", "is": "x^2+1"}}
        for says, verdict in (("z = sin(asin(x))", "undecided"), ("z = x", "proved"), ("z = x+asin(s)-asin(s)", "undecided")):
            self.assertEqual(self.verdicts(hidden, b, {"id": "C", "says": says, "follows": {"equation": "B"}})["C"], verdict, says)
        for formula, verdict in (("sin(asin(x))", "undecided"), ("x", "verified")):
            self.assertEqual(self.verdicts(hidden, {"id": "T", "table": {"formula": formula, "columns": ["x"], "rows": [["2", "2.0"]]}}), {"T": verdict}, formula)

    def test_a_sign_is_kept_on_the_way_through_all_that_is_put_in(self):
        real, y = {"sign": "real", "range": ["1", "2"]}, {"sign": "real"}
        b = {"id": "B", "says": "y = sqrt(s^2)", "is": "definition"}
        c = {"id": "C", "says": "w = t", "follows": {"equation": "B", "with": {"s": "t"}}}
        to_v = {"equation": "C", "with": {"t": "-v"}}

        def verdicts(*more):
            free = {"s": {}, "t": real, "v": real, "y": y, "w": y, "z": y}
            return self.verdicts(free, b, c, *more)
        for further in ({"says": "z = -v"}, {"says": "z = -v < 0", "over": {"v": ["1", "2"]}}):
            self.assertEqual(verdicts({"id": "D", **further, "follows": to_v}), {"B": "definition", "C": "proved", "D": "undecided"})
        self.assertEqual(verdicts({"id": "D", "says": "z = v", "follows": {"equation": "C", "with": {"t": "v"}}})["D"], "proved")
        stands_for = {"x": real, "u": {**real, "range": ["1", "2"]}, "s": {"is": "x-1/2"}, "y": y, "w": y, "z": y}
        c = {"id": "C", "says": "w = u-1/2", "follows": {"equation": "B", "with": {"x": "u"}}}
        f = {"id": "F", "says": "z = u-1/2", "follows": {"equation": "C"}, "over": {"u": ["0", "1/4"]}}
        self.assertEqual(self.verdicts(stands_for, b, c, {**f, "says": "z = u-1/2 < 0"})["F"], "undecided")
        self.assertEqual(self.verdicts(stands_for, b, c, {**f, "says": "z = u-1/2 < 1", "over": {"u": ["1", "5/4"]}})["F"], "proved")

    def test_what_is_put_in_by_its_name_keeps_its_condition_though_it_is_the_equation_itself(self):
        real = {"sign": "real", "range": ["0", "3"]}
        b = {"id": "B", "says": "y = 1-x", "where": "x < 1", "is": "definition"}
        c = {"id": "C", "says": "w = x", "follows": {"equation": "B", "with": {"x": "@B"}}}
        self.assertEqual(self.verdicts({"x": real, "y": real, "w": real}, b, c)["C"], "undecided")

    def test_an_id_is_no_formula(self):
        for name in ("H1+1", "", "H 1", "H1\n", "(1)", "é"):
            self.assertIn("an id is of letters", self.verdicts({"x": {}, "y": {}}, {"id": name, "says": "y = x", "is": "definition"}))
        a, b = {"id": "eq:2.1-a_b", "says": "y = x^2", "is": "definition"}, {"id": "B", "says": "w = y", "is": "definition"}
        c = {"id": "C", "says": "z = x^2", "follows": {"equation": "B", "with": {"y": "@eq:2.1-a_b"}}}
        self.assertEqual(self.verdicts({name: {} for name in "xywz"}, a, b, c)["C"], "proved")

    def test_a_name_means_one_thing_in_the_whole_ledger(self):
        real = {"sign": "real", "range": ["1", "2"]}
        symbols = {name: real for name in ("x", "u", "v", "w", "y", "z", "p")}

        def verdicts(*entries):
            return "".join({"definition": "d", "proved": "p", "verified": "v", "undecided": "u", "refuted": "r"}[v]
                           for v in self.verdicts(symbols, *({"id": f"E{k}", **e} for k, e in enumerate(entries))).values())
        y = {"says": "y = x^2", "is": "definition"}

        def put(says, x, **more):
            return {"says": says, "follows": {"equation": "E0", "with": {"x": x}}, **more}
        # one symbol is not x, and half of it, and x+1
        self.assertEqual(verdicts(y, put("y = u^2", "u"), put("y = 4*u^2", "2*u"), put("y = u^2-2*u+1", "u-1")), "duuu")
        self.assertEqual(verdicts(y, {"says": "u = x", "is": "definition"}, put("y = 4*u^2", "2*u")), "ddu")
        self.assertEqual(verdicts(y, put("y = 4*u^2", "2*u"), put("y = v^2", "v"), {"says": "w = 4*u^2", "follows": {"equation": "E1"}}), "dppp")
        # nor is a constant, or what stays below 1, x
        self.assertEqual(verdicts({**y, "says": "y = x"}, put("y = 2+cos(2*u)-2*cos(u)^2", "2+cos(2*u)-2*cos(u)^2")), "du")
        self.assertEqual(verdicts({**y, "says": "y = x"}, put("y = sin(u) <= 1", "sin(u)", over={"u": ["1/4", "1"]})), "dv")
        # a name that has a meaning gets no other from elsewhere
        follows = {"follows": {"equation": "E0"}}
        self.assertEqual(verdicts(y, {"says": "w = 5", "is": "definition"}, {"says": "w = x^2", **follows}), "ddu")
        self.assertEqual(verdicts(y, {"says": "2*w = 5", "is": "definition"}, {"says": "w = x^2", **follows}), "ddu")
        self.assertEqual(verdicts(y, {"says": "w = x*x+x-x", "is": "definition"}, {"says": "w = x^2", **follows}), "ddp")
        p = {"says": "p = 2*x", "is": "definition"}
        self.assertEqual(verdicts(y, p, {"says": "p = x^2", **follows}, {"says": "p = 2*x", "follows": {"equation": "E1"}}), "ddup")
        self.assertEqual(verdicts(y, p, {"says": "w = x^2", **follows}, {"says": "w = 2*x", "follows": {"equation": "E1"}}), "ddpu")
        # a bound is of the quantity on its left side where that is
        self.assertEqual(verdicts({**y, "says": "y = x"}, {"says": "y <= x", **follows}, {"says": "y <= 1", "follows": {"equation": "E1", "with": {"x": "1"}}}), "dpu")
        a = [{"says": "y = x-1/10", "is": "definition"}, {"says": "y <= x", "is": "definition"}]
        self.assertEqual(verdicts(*a, {"says": "y <= -x^2-10^9", "follows": {"equation": "E1", "with": {"x": "-x^2-10^9"}}}), "ddu")

    def test_what_depends_on_a_symbol_by_another_entry_is_not_taken_for_a_number(self):
        real = {"sign": "real", "range": ["1", "2"]}
        symbols = {name: real for name in ("x", "a", "b", "w", "y")}
        a, y = {"id": "A", "says": "a = x^2", "is": "definition"}, {"id": "Y", "says": "y = a*x", "is": "definition"}

        def verdict(says, *entries, **follows):
            return self.verdicts(symbols, *entries, {"id": "C", "says": says, "follows": {"equation": "Y", **follows}})["C"]
        self.assertEqual(verdict("w = a", a, y, derivative_by="x"), "undecided")
        self.assertEqual(verdict("w = a", a, y, **{"with": {"x": "1"}}), "undecided")
        self.assertEqual(verdict("w = 5*x", a, y, **{"with": {"a": "5"}}), "undecided")
        self.assertEqual(verdict("w = b", {**a, "says": "b = x^2"}, {**a, "id": "B", "says": "b = a"}, {**y, "says": "y = a+x"}, **{"with": {"x": "0", "a": "b"}}), "undecided")
        for says in ("w = x^2+1", "w = 1"):  # the second one is true
            self.assertEqual(verdict(says, {**a, "says": "a = x^2+1"}, {**y, "says": "y = a+x"}, **{"with": {"x": "0", "a": "@A"}}), "undecided")
        self.assertEqual(verdict("w = x^3", a, y, **{"with": {"a": "@A"}}), "proved")

    def test_a_definition_of_what_has_a_meaning_is_judged_like_any_other_entry(self):
        real = {"sign": "real"}
        symbols = {"x": {**real, "range": ["-1/100", "1"]}, "a": {**real, "is": "abs(x)"}, "y": real, "z": real, "b": real}
        d, c = {"id": "D", "says": "y = a^3", "is": "definition"}, {"id": "C", "says": "z = x^3", "follows": {"equation": "D", "with": {"a": "@B"}}}
        b = {"id": "B", "says": "a = x", "is": "definition"}
        self.assertEqual(self.verdicts(symbols, b, d, c), {"B": "verified", "D": "definition", "C": "verified"})
        for says in ("2*a = 2*x", "b = a = x", "b = x = a"):
            self.assertEqual(self.verdicts(symbols, {**b, "says": says})["B"], "undecided", says)
        for says in ("b = a", "b = a+x = x+a", "2*b = x"):
            self.assertEqual(self.verdicts(symbols, {**b, "says": says})["B"], "definition", says)
        root = {"id": "B", "says": "y = sqrt(x^2)", "is": "definition"}
        c = {"id": "C", "says": "y = x", "is": "definition", "follows": {"equation": "B"}}
        e = {"id": "E", "says": "y = x", "follows": {"equation": "C"}}
        self.assertEqual(self.verdicts({"x": {**real, "range": ["1/4", "2"]}, "y": real}, root, c, e), {"B": "definition", "C": "verified", "E": "verified"})

    def test_what_is_true_is_not_refuted_for_saying_little(self):
        real = {"sign": "real"}
        symbols = {"x": {"range": ["0", "2"]}, "z": real, "w": real, "y": real}
        b = {"id": "B", "says": "z = x", "is": "definition"}

        def verdict(of, says, **more):
            return self.verdicts(symbols, {**b, "says": of}, {"id": "C", "says": says, "follows": {"equation": "B"}, **more})["C"]
        for of, says in (("z = x^2", "z = x^2 = x*x"), ("z = 2*x+2", "z = 2*(x+1) = 2*x+2"), ("w = x", "w = abs(x) = x"), ("w = x", "w = sqrt(x^2) = x"), ("y < x", "y < x"), ("y <= x", "y <= x")):
            self.assertEqual(verdict(of, says), "proved", says)
        self.assertEqual(verdict("w = x", "w = x < 3 = 6/2"), "verified")
        for says in ("x <= x", "x < 3 = 6/2", "x-1 < x = 2*x-x"):
            self.assertEqual(self.verdicts(symbols, {"id": "C", "says": says, "over": {"x": ["0", "2"]}})["C"], "proved", says)
        self.assertEqual(self.verdicts(symbols, {"id": "C", "says": "x < x", "over": {"x": ["0", "2"]}})["C"], "refuted")
        # it may hold outside of its condition, and this may be far from the samples
        for where in ("x < 1", "x > 3/2", "x < 10^(-2)", "x > 3"):
            self.assertIn(verdict("z = x", "z = x", where=where), ("proved", "undecided"), where)
        self.assertEqual(verdict("z = x", "z = x", where="x < 1"), "proved")
        self.assertEqual(self.verdicts(symbols, {"id": "C", "says": "x^2 < 2", "where": "x < 1/2", "over": {"x": ["0", "1"]}})["C"], "proved")

    def test_what_is_put_in_makes_no_number_that_is_too_long(self):
        real = {"sign": "real"}
        symbols = {"x": {}, "n": {}, "y": real, "z": real, "k": {"is": "10^10"}, "m": {"is": "9^9"}}

        def answer(of, **follows):
            b = {"id": "B", "says": f"y = {of}", "is": "definition"}
            return self.verdicts(symbols, b, {"id": "C", "says": "z = 2", "follows": {"equation": "B", **follows}})
        for of, put in (("2^n", {"n": "10^10"}), ("tgamma(n)", {"n": "10^8"}), ("3^k*x", {"x": "1"}), ("tgamma(m)", {})):
            self.assertIn("'C': a number of it is too long", answer(of, **{"with": put}), of)
        self.assertIn("'C': a number of it is too long", self.verdicts(symbols, {"id": "C", "says": "3^k > x", "over": {"x": ["0", "1"]}}))

    def test_what_is_not_understood_is_refused_and_not_passed_over(self):
        symbols = {"x": {}, "y": {}, "z": {}}
        a = {"id": "A", "says": "y = x", "is": "definition"}
        table = {"formula": "x", "columns": ["x"], "rows": [["1/2", "0.5"]]}

        def refused(word, *entries):
            answer = self.verdicts(symbols, *entries)
            self.assertIsInstance(answer, str, word)
            self.assertEqual(answer.count("\n"), 1, answer)
            self.assertIn(word, answer)
        refused("two columns 'x'", {"id": "T", "table": {**table, "columns": ["x", "x"], "rows": [["1/2", "1/2", "0.5"]]}})
        refused("'rows' is a list", {"id": "T", "table": {**table, "rows": {"a": ["1/2", "0.5"]}}})
        refused("a row is", {"id": "T", "table": {**table, "rows": [{"a": "1/2", "b": "0.5"}]}})
        refused("either", {"id": "T", "table": {**table, "file": "t.txt"}})
        for key, value in (("says", "y = 2*x"), ("where", "x < 1"), ("is", "definition"), ("over", {"x": ["0", "1"]})):
            refused(f"a table has no '{key}'", {"id": "T", "table": table, key: value})
        refused("'excuses' is a list", {**a, "excuses": {}})
        refused("'comment' wants a string", {**a, "comment": 5})
        refused('"over" is', {"id": "C", "says": "x < 9", "over": {}})
        for says in ("y == x", "y ~= x"):
            refused("no relation", {**a, "says": says})
        for says in ("y = {x}", "y = {x,1}", "y = [x]"):
            refused("does not parse", {**a, "says": says})
        refused("does not parse", a, {"id": "C", "says": "z = 2*x", "follows": {"equation": "A", "with": {"x": "2@A"}}})
        for says in ("y = 0^0", "y = 1/0", "y = log(x-x)", "y = tgamma(0)"):
            refused("has no value", {**a, "says": says})

    def test_an_excuse_of_a_change_that_is_not_made_is_told_with_the_changes(self):
        def change(ledger):
            self.entry(ledger, "S5")["excuses"][0]["change"] = "a slip"
        r = self.judge(change, "S5", "--mutate")
        self.assertEqual((r.returncode, r.stderr.count("\n")), (65, 1), r.stdout + r.stderr)
        self.assertIn("'S5': excuses: no change 'a slip'", r.stderr)

    def test_a_correction_that_does_not_mend_fails(self):
        def change(ledger):
            self.entry(ledger, "H4")["correction"]["edits"] = [{"from": "2*Pi*R", "to": "3*Pi*R"}]
        r = self.judge(change, "H4")
        self.assertEqual(r.returncode, 1)
        self.assertIn("FAILED H4", r.stdout)

    def test_without_anything_to_follow_from_it_is_undecided(self):
        def change(ledger):
            del self.entry(ledger, "H3")["follows"]
        self.assertEqual(self.judge(change, "H3").returncode, 2)

    def test_nothing_outside_of_its_folder_is_read(self):
        """A ledger may be a stranger's: neither a name with .. nor a link leads out, and what has no end is not begun."""
        with tempfile.TemporaryDirectory() as scratch:
            folder, secret = pathlib.Path(scratch) / "ledger", pathlib.Path(scratch) / "secret.txt"
            folder.mkdir()
            secret.write_text("0.5 0.25\n")
            os.mkfifo(folder / "pipe")
            (folder / "link").symlink_to(secret)
            (folder / "zero").symlink_to("/dev/zero")
            (folder / "inside.txt").write_text("2 2\n")
            (folder / "same").symlink_to("inside.txt")

            def judged(name):
                table = {"formula": "a", "columns": ["a"], "file": name}
                (folder / "ledger.json").write_text(json.dumps({"symbols": {"a": {"dimension": "1"}}, "entries": [{"id": "T", "table": table}]}))
                r = run("--ledger", folder)
                self.assertLessEqual(r.stderr.count("\n"), 1)
                return r.returncode, r.stderr

            for name in ("../secret.txt", "link", "zero", "../../../dev/zero", f"../{folder.name}-other/../secret.txt"):
                code, said = judged(name)
                self.assertIn(code, (65, 66))
                self.assertRegex(said, "outside of the ledger's folder|no such file")
            self.assertIn("no plain file", judged("pipe")[1])
            for name in ("inside.txt", "same", "./inside.txt"):
                self.assertEqual(judged(name)[0], 0, name)
            (folder / "ledger.json").unlink()
            (folder / "ledger.json").symlink_to("/dev/zero")
            self.assertIn("outside", run("--ledger", folder).stderr)

    def test_bad_input_is_one_line_with_file_and_entry(self):
        def no_dimension(ledger):
            ledger["symbols"]["R"].pop("dimension")
        self.refuses(no_dimension, "'R'", "dimension")

        def undeclared(ledger):
            self.entry(ledger, "H3")["says"] = "p0 = 2*P/(Pi*b)"
        self.refuses(undeclared, "'H3'", "'b'", "dimension")

        def no_formula(ledger):
            self.entry(ledger, "H3")["says"] = "p0 = 2*P/(Pi*a"
        self.refuses(no_formula, "'H3'", "parse")

        for nothing in ("sqrt()", "tgamma( )", "exp(# of nothing\n)"):  # a parser that went on would end the program
            def calls_of_nothing(ledger):
                self.entry(ledger, "H3")["says"] = f"p0 = 2*P/(Pi*a)*{nothing}"  # noqa: B023
            self.refuses(calls_of_nothing, "'H3'", "parse")

        for giant in ("9^(9^8)", "tgamma(10^9)", "2^(10^9)*x", "(1/3)^(10^7)", "sqrt(7^(10^8))"):  # each alone takes minutes, or all memory, where it is evaluated
            def too_long(ledger):
                self.entry(ledger, "H3")["says"] = f"p0 = 2*P/(Pi*a)*{giant}"  # noqa: B023
            self.refuses(too_long, "'H3'", "too long")

        def no_relation(ledger):
            self.entry(ledger, "H3")["says"] = "p0"
        self.refuses(no_relation, "'H3'", "relation")

        def unknown(ledger):
            self.entry(ledger, "H3")["follows"]["equation"] = "H77"
        self.refuses(unknown, "'H3'", "'H77'")

        def equation(ledger):
            self.entry(ledger, "H3")["where"] = "x = 1/2"
        self.refuses(equation, "'H3'", "where", "x = 1/2")

        def no_range(ledger):
            self.entry(ledger, "S5")["says"] = "shear < 0.301*z/a"
        self.refuses(no_range, "'S5'", "'Estar'")

        def no_symbol(ledger):
            self.entry(ledger, "H3")["follows"]["with"] = {"x+1": "0"}
        self.refuses(no_symbol, "'H3'", "'x+1'")

        def no_formula_in_with(ledger):
            self.entry(ledger, "H3")["follows"]["with"] = {"x": "2*"}
        self.refuses(no_formula_in_with, "'H3'", "2*")

        def cycle(ledger):
            self.entry(ledger, "H2")["follows"] = {"equation": "H4"}
        self.refuses(cycle, "cycle", "H2 -> ")

        def cycle_of_symbols(ledger):
            ledger["symbols"]["R"]["is"] = "a^2/R"
        self.refuses(cycle_of_symbols, "cycle")

        def bad_dimension(ledger):
            ledger["symbols"]["R"]["dimension"] = "length^^2"
        self.refuses(bad_dimension, "'R'", "length^^2")

        def misspelt(ledger):
            self.entry(ledger, "H3")["folows"] = {}
        self.refuses(misspelt, "'H3'", "folows")

        def twice(ledger):
            ledger["entries"].append(self.entry(ledger, "H3"))
        self.refuses(twice, "'H3'", "two entries")

        def short_row(ledger):
            self.entry(ledger, "T1")["table"]["rows"][1] = ["0.3"]
        self.refuses(short_row, "'T1'", "row 2")

    def test_no_json_and_no_file(self):
        r = self.judge_text('{"symbols": }')
        self.assertEqual((r.returncode, r.stderr.count("\n")), (65, 1))
        r = run("--ledger", "/nonexistent")
        self.assertEqual((r.returncode, r.stderr.count("\n")), (66, 1))


class WhatTheProgramRestsOn(unittest.TestCase):
    def test_every_lemma_holds_and_every_perturbed_constant_is_refuted(self):
        r = run("--own", "--json")
        self.assertEqual((r.returncode, r.stderr), (0, ""))
        lemmas = json.loads(r.stdout)
        self.assertGreater(len(lemmas), 50)
        self.assertEqual(len({e["id"] for e in lemmas}), len(lemmas))
        for e in lemmas:
            self.assertIn(e["verdict"], ("proved", "verified"), e)
            self.assertFalse(e["failures"], e)
            self.assertTrue(e["statement"] and e["method"] and e["steps"], e)
            self.assertTrue(e["controls"], e["id"] + " has no control")
            self.assertEqual({c["verdict"] for c in e["controls"]}, {"refuted"}, e)
            for constant in e["constants"]:
                self.assertTrue([c for c in e["controls"] if constant in c["what"]], f"{e['id']}: {constant} is never perturbed")
        text = run("--own").stdout
        self.assertIn(f"{len(lemmas)} lemmas and constants: ", text)
        for e in lemmas:
            self.assertIn(e["id"], text)

    def test_one_lemma_and_an_unknown_one(self):
        r = run("--own", "wave::place", "--json")
        self.assertEqual([e["id"] for e in json.loads(r.stdout)], ["wave::place"])
        self.assertIn("steps", run("--own", "wave::place").stdout)
        r = run("--own", "wave::nowhere", "--json")
        self.assertEqual((r.returncode, r.stdout, r.stderr.count("\n")), (65, "", 1))


if __name__ == "__main__":
    unittest.main()
