#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`touchstone integrate` as a stranger uses it: digits, JSON, exit codes, refusals in one line that says where.

usage: test_integrate.py TOUCHSTONE
"""
import cmath
import json
import subprocess
import sys
import unittest

PROGRAM = sys.argv.pop(1)
# 1/(1+x^2) as its power series, integrated term by term; the terms alternate, so the sum is within the first one left out
LOG_OVER_ROOT = sum((-1) ** k * 4.0 / (4 * k + 1) ** 2 for k in range(20000))


def integrate(*words):
    return subprocess.run([PROGRAM, "integrate", *words], capture_output=True, text=True, timeout=60)


def as_json(*words):
    answer = integrate(*words, "--json")
    return answer.returncode, json.loads(answer.stdout)


class Integrate(unittest.TestCase):
    def refused(self, code, *words):
        answer = integrate(*words)
        self.assertEqual(answer.returncode, code, answer.stdout + answer.stderr)
        self.assertEqual(answer.stdout, "")
        self.assertEqual(answer.stderr.count("\n"), 1, answer.stderr)
        return answer.stderr

    def test_the_integral_of_the_documentation(self):
        code, j = as_json("x^(-1/2)*log(1/x)/(1+x^2)", "0", "1", "--digits", "50")
        self.assertEqual((code, j["status"], j["digits"], len(j["value"].replace(".", ""))), (0, "certified", 50, 50))
        self.assertAlmostEqual(float(j["value"]), LOG_OVER_ROOT, 8)
        self.assertEqual(float.fromhex(j["binary64"]), float(j["value"]))
        self.assertEqual(j["parts"][0]["rule"], "product integration")
        self.assertIn("discretisation", j["parts"][0]["proof"])

    def test_tanh_sinh_shows_its_certificate(self):
        j = as_json("x^x", "0", "1")[1]
        self.assertEqual(j["parts"][0]["rule"], "tanh-sinh")
        self.assertIn("discretisation", j["parts"][0]["certificate"])

    def test_digits_are_the_same_at_every_precision(self):
        values = [as_json("acos(x)", "-1", "1", "--digits", str(d))[1]["value"] for d in (10, 40, 90)]
        self.assertTrue(all(abs(float(v) - 3.141592653589793) < 1e-9 for v in values), values)
        self.assertEqual(values[2][:35], "3.141592653589793238462643383279502")

    def test_ends(self):
        for words, value in ((("exp(-x^2)", "-inf", "inf"), 1.7724538509055160), (("sin(x)", "0", "pi/2"), 1.0), (("1/x", "1", "e"), 1.0), (("x", "1", "0"), -0.5), (("x", "1/3", "1/3"), 0.0),
                             (("-x", "-1", "-1/2"), 0.375), (("1/sqrt(2-x^2)", "0", "sqrt(2)"), 1.5707963267948966)):
            code, j = as_json(*words)
            self.assertEqual((code, j["status"]), (0, "certified"), words)
            self.assertAlmostEqual(float(j["value"]), value, 14, words)

    def test_break_points_lose_no_digits(self):
        code, j = as_json("exp(x)*abs(x-1/3)", "0", "1", "--at", "1/3,1/2", "--digits", "100")
        self.assertEqual((code, j["status"], j["digits"], len(j["parts"])), (0, "certified", 100, 3))

    def test_zero_needs_an_absolute_error(self):
        code, j = as_json("sin(x)", "-1", "1")
        self.assertEqual((code, j["status"], j["value"], j["digits"]), (2, "undecided", None, 0))
        self.assertIn("--tolerance", j["reason"])
        self.assertEqual(as_json("sin(x)", "-1", "1", "--tolerance", "1e-20")[1]["status"], "certified")

    def test_digits_are_enough_where_a_tolerance_is_not_reached(self):
        for formula, digits in (("exp(100*x)", 15), ("exp((100+i)*x)", 15)):
            code, j = as_json(formula, "0", "1", "--digits", str(digits), "--tolerance", "1e-3")
            self.assertEqual((code, j["status"], j["digits"]), (0, "certified", digits), j)
            self.assertEqual(j["value"], as_json(formula, "0", "1", "--digits", str(digits))[1]["value"])

    def test_parts_of_a_reversed_range_add_up_to_its_value(self):
        for words in (("x^3", "1", "0", "--at", "1/2,1/4"), ("x^3", "1", "0", "--path", "i"), ("x+i", "2", "0", "--at", "1")):
            j = as_json(*words, "--digits", "12")[1]
            for whole, of_part in (("value", "enclosure"), ("imaginary", "imaginary")):
                middles = [float(p.get(of_part, "[0 ").lstrip("[").split()[0].replace("+/-", "0")) for p in j["parts"]]
                self.assertAlmostEqual(sum(middles), float(j.get(whole, 0)), places=8, msg=(words, j))
        self.assertEqual([(p["from"], p["to"]) for p in as_json("x^3", "1", "0", "--at", "1/2")[1]["parts"]], [("1", "1/2"), ("1/2", "0")])

    def test_a_tie_is_said_to_be_one(self):
        code, j = as_json("x/2", "0", "1", "--digits", "1")
        self.assertEqual((code, j["status"]), (2, "undecided"))
        self.assertIn("middle between two numbers", j["reason"])

    def test_what_is_no_formula_is_refused_with_its_column(self):
        for text, where in (("x*(1+", "column 6"), ("2x", "column 2"), ("foo(x)", "column 1"), ("x+y", "column 3"), ("sin x", "column 1"), ("", "column 1"), ("max(x)", "column 1"), ("besselj(x,1)", "column 1"),
                            ("1+" + "sin(" * 700 + "x" + ")" * 700, "nest deeper"), ("x^" * 1900 + "x", "nest deeper"), ("x+" * 2500 + "x", "longer than")):
            self.assertIn(where, self.refused(65, text, "0", "1"), text)

    def test_what_diverges_is_refused_with_its_place(self):
        for text, ends, place in (("1/(x-1/3)", ("0", "1"), "x = 1/3"), ("1/x", ("0", "1"), "x = 0"), ("x^-1.5", ("0", "1"), "x = 0"), ("tan(x)", ("0", "2"), "pi"), ("1/(1-x)", ("0", "1"), "x = 1")):
            message = self.refused(65, text, *ends)
            self.assertIn("diverges", message)
            self.assertIn(place, message)

    def test_json_says_that_it_diverges(self):
        code, j = as_json("1/(1-x)", "0", "1")
        self.assertEqual((code, j["status"], j["value"], j["digits"], j["error"]), (65, "divergent", None, 0, None))
        self.assertIn("x = 1", j["reason"])

    def test_kinks_where_no_exact_number_is(self):
        for text, value in (("abs(exp(x)-2)", 0.49087055069882647), ("sign(cos(x)-x)", 0.4781702664303213), ("floor(exp(3*x))", 5.888127846415505), ("abs(sqrt(x)-0.3)", 0.38466666666666666), ("max(x,exp(-x))", 0.7720309536617979)):
            code, j = as_json(text, "0", "1", "--digits", "40")
            self.assertEqual((code, j["status"]), (0, "certified"), text)
            self.assertAlmostEqual(float(j["value"]), value, 9, text)

    def test_principal_values(self):
        code, j = as_json("exp(x)/x", "-1", "1", "--principal-value", "0")
        self.assertEqual((code, j["status"]), (0, "certified"))
        self.assertAlmostEqual(float(j["value"]), 2.1145017507514571, 14)
        self.assertEqual(as_json("1/x", "-1", "2", "--principal-value", "0")[1]["value"][:20], "0.693147180559945309")
        self.assertIn("--principal-value 0", self.refused(65, "1/x", "-1", "1"))
        self.assertIn("not between", self.refused(65, "1/x", "-1", "1", "--principal-value", "2"))
        self.assertIn("diverges", self.refused(65, "1/x^2", "-1", "2", "--principal-value", "0"))
        # folded to zero, which no expansion of finite length shows
        self.assertEqual(as_json("cot(x)", "-1", "2", "--principal-value", "0", "--digits", "20")[1]["value"], "0.077520710173931047270")
        self.assertEqual(as_json("tan(x)", "0", "3", "--principal-value", "pi/2", "--digits", "10")[1]["value"], "0.01005791507")

    def test_bounds_beyond_binary64_are_text(self):
        code, j = as_json("x^300*exp(-x)", "0", "inf", "--digits", "12")
        self.assertEqual((code, j["value"]), (0, "3.06057512216e+614"))
        bounds = [p["strip_integral"] for part in j["parts"] if "certificate" in part for p in part["certificate"]["panels"]]
        self.assertTrue(any(isinstance(b, str) and len(b.split("e")[1]) > 2 for b in bounds), bounds)

    def test_complex_values_have_two_parts_to_one_place(self):
        code, j = as_json("1/x", "1", "1", "--path", "i,-1,-i", "--digits", "20")
        self.assertEqual((code, j["status"], j["value"], j["imaginary"], j["error"]), (0, "certified", "0", "6.2831853071795864769", "7.1e-20"))
        code, j = as_json("1/(1000-x*i)", "0", "1", "--digits", "10")  # begins four places later, and is close to a tie
        self.assertEqual((code, j["value"], j["imaginary"]), (0, "0.0009999996667", "4.999998e-07"))
        j = as_json("exp(i*x)", "0", "5/7", "--digits", "1")[1]  # both parts nearly half a unit from what is printed
        off = abs(complex(float(j["value"]), float(j["imaginary"])) - (cmath.exp(5j / 7) - 1) / 1j)
        self.assertTrue(0.063 < off <= float(j["error"]), j)
        j = as_json("exp(i*x)", "0", "5/7", "--tolerance", "0.05")[1]  # with each part within 0.05 the same digits would do
        self.assertLessEqual(abs(complex(float(j["value"]), float(j["imaginary"])) - (cmath.exp(5j / 7) - 1) / 1j), 0.05, j)
        answer = integrate("exp(i*x)", "0", "pi", "--digits", "10")
        self.assertEqual(answer.stdout.splitlines()[0], "0 + 2.000000000*i")
        self.assertEqual(integrate("exp(-i*x)", "0", "pi", "--digits", "10").stdout.splitlines()[0], "0 - 2.000000000*i")
        self.assertEqual(as_json("exp(i*x)", "0", "2*pi", "--tolerance", "1e-9")[1]["value"], "0")

    def test_parameters(self):
        code, j = as_json("x^a", "0", "1", "--set", "a=1/2")
        self.assertEqual((code, j["value"][:8]), (0, "0.666666"))
        code, j = as_json("x^a", "0", "b", "--set", "a=0.5+/-1e-10", "--set", "b=1")
        self.assertEqual((code, j["status"], j["digits"]), (2, "undecided", 9))
        for word in ("a", "a=", "x=1", "sin=1", "a=1+/-", "a=1+/--1", "a=y", "=1"):
            self.refused(65, "x", "0", "1", "--set", word)
        self.refused(65, "x", "0", "1", "--set", "a=1", "--set", "a=2")
        self.assertIn("column 1", self.refused(65, "b*x", "0", "1", "--set", "a=1"))

    def test_inner_integrals(self):
        code, j = as_json("integral(exp(-x*y),y,0,1)", "0", "1")
        self.assertEqual((code, j["value"]), (0, "0.796599599297053134283675865543"))
        self.assertIn("inner integral", self.refused(2, "integral(abs(x-y),y,0,1)", "0", "1"))
        self.assertIn("two levels", self.refused(65, "integral(integral(y,z,0,1),y,0,1)", "0", "1"))
        self.assertIn("column 12", self.refused(65, "integral(x,x,0,1)", "0", "1"))

    def test_several_formulas(self):
        code, j = as_json("1/sqrt(x); log(x)/sqrt(x)", "0", "1")
        self.assertEqual((code, [i["status"] for i in j["integrals"]], j["integrals"][1]["value"][:8]), (0, ["certified"] * 2, "-4.00000"))
        code, j = as_json("1/x; x", "0", "1")
        self.assertEqual((code, [i["status"] for i in j["integrals"]]), (65, ["divergent", "certified"]))
        self.refused(65, "x;", "0", "1")
        self.refused(65, ";", "0", "1")

    def test_paths_that_are_none(self):
        self.refused(65, "x", "0", "1", "--path", "x")
        self.refused(65, "x", "-inf", "i*inf")
        self.refused(65, "x", "0", "i", "--at", "1/2")
        self.refused(65, "sign(x)", "0", "i")
        self.assertIn("diverges", self.refused(65, "1/x", "0", "i"))
        self.refused(2, "log(x)", "-1+i", "-1-i")

    def test_what_is_not_proved_is_undecided_with_its_place(self):
        self.assertIn("0.707", self.refused(2, "1/(x^2-1/2)", "0", "1"))
        self.assertIn("inf", self.refused(2, "exp(x)", "0", "inf"))
        self.assertIn("inf", self.refused(2, "sin(x)", "0", "inf"))
        self.assertIn("inf", self.refused(2, "cos(x)*x^0.1", "1", "inf"))
        self.refused(2, "1/(x*log(x))", "0", "1/2")

    def test_options_out_of_domain(self):
        self.refused(65, "x", "0", "1", "--digits", "0")
        self.refused(65, "x", "0", "y")
        self.refused(65, "x", "0", "1", "--at", "2")
        self.refused(65, "x", "0", "1", "--tolerance", "-1")
        self.refused(65, "x", "0", "log(-1)")
        self.refused(64, "x", "0")


if __name__ == "__main__":
    unittest.main()
