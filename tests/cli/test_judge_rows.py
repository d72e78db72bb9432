#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""touchstone judge as the author of a boundary element code meets it: own rows, tolerances, noise, and adapters.

usage: test_judge_rows.py --touchstone PROGRAM --subjects FOLDER --tables FOLDER
"""
import argparse
import json
import math
import os
import pathlib
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import threading
import unittest

arguments = argparse.ArgumentParser()
arguments.add_argument("--touchstone", required=True)
arguments.add_argument("--subjects", required=True)
arguments.add_argument("--tables", required=True)
options, sys.argv[1:] = arguments.parse_known_args()
PROGRAM = os.path.abspath(options.touchstone)


def run(*words, **more):
    more = {"capture_output": True, "text": True, "stdin": subprocess.DEVNULL, "timeout": 100, **more}
    return subprocess.run([PROGRAM, "judge", *map(str, words)], **more)


def pressure(x, load):
    """p/p* (2.2), (2.4)"""
    if load >= 1:
        return load - 1 + 2 * math.cos(math.pi * x) ** 2
    return 2 * math.cos(math.pi * x) * math.sqrt(max(load - math.sin(math.pi * x) ** 2, 0))


def half_width(load):
    return math.atan2(math.sqrt(load), math.sqrt(1 - load)) / math.pi


def single(v):
    return struct.unpack("f", struct.pack("f", v))[0]


GRID = [((k + 0.5) / 64 / 2, load) for load in (0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 1.5, 4.0) for k in range(-32, 32)]
INSIDE = [(x, load) for x, load in GRID if pressure(x, load) > 0]


class Rows(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.noise = random.Random(7)

    def rows(self, answer, grid=INSIDE, columns="x load"):
        path = self.folder / "rows.txt"
        with open(path, "w") as f:
            f.write(f"# {columns} answer\n")
            for inputs in grid:
                f.write(" ".join(map(repr, inputs)) + f" {answer(*inputs)}\n")
        return path

    def judged(self, quantity, path, *words):
        r = run(quantity, "--rows", path, "--json", *words)
        self.assertEqual(r.stderr, "")
        return r.returncode, json.loads(r.stdout)

    def mixup(self, answer, *words, quantity="westergaard.pressure", **more):
        code, j = self.judged(quantity, self.rows(answer, **more), *words)
        self.assertEqual((code, j["verdict"]), (1, "fail"))
        return j

    def noisy(self, part):
        return 1 + part * (2 * self.noise.random() - 1)

    def test_a_tolerance_passes_what_ulps_do_not(self):
        path = self.rows(lambda x, load: pressure(x, load) * self.noisy(1e-3))
        self.assertEqual(self.judged("westergaard.pressure", path)[0], 1)
        code, j = self.judged("westergaard.pressure", path, "--rtol", "1e-3")
        self.assertEqual((code, j["verdict"], j["failed"], j["rtol"]), (0, "pass", 0, 1e-3))
        self.assertEqual(self.judged("westergaard.pressure", path, "--rtol", "5e-4")[0], 1)
        path = self.rows(lambda x, load: pressure(x, load) + 1e-3 * (2 * self.noise.random() - 1), GRID)  # also where the truth is 0
        self.assertEqual(self.judged("westergaard.pressure", path, "--rtol", "1e-6")[0], 1)
        self.assertEqual(self.judged("westergaard.pressure", path, "--atol", "1e-3")[0], 0)

    def test_rows_in_other_dresses(self):
        (self.folder / "a.csv").write_bytes(b"\xef\xbb\xbfload,answer\r\n0.5,0.25\r\n1/4,0.16666666666666666\r\n")
        self.assertEqual(self.judged("westergaard.half_width", self.folder / "a.csv")[0], 0)
        (self.folder / "b.txt").write_text("# answer x\n2.0D0 0\n")
        self.assertEqual(self.judged("westergaard.pressure", self.folder / "b.txt", "load=1")[0], 0)
        r = run("westergaard_pressure", "--rows", "-", "--json", input="# x load answer\n0 1 2\n", stdin=None)
        self.assertEqual(json.loads(r.stdout)["verdict"], "pass")
        (self.folder / "c.txt").write_text("# D gamma answer\n1.5 16 0.25\n")  # G = 4: x_P = 1/4
        self.assertEqual(self.judged("peaks.fixed_point", self.folder / "c.txt")[0], 0)
        (self.folder / "d.txt").write_text("# load\n0.5\n0.25\n")  # no answers: a subject gives them
        self.assertEqual(run("westergaard.half_width", "--rows", self.folder / "d.txt", "--", os.path.join(options.subjects, "subject_library_forms"),
                             "westergaard.half_width").returncode, 0)

    def test_where(self):
        path = self.rows(lambda load: half_width(load) if load < 0.5 else 7, [(k / 100,) for k in range(1, 100)], "load")
        self.assertEqual(self.judged("westergaard.half_width", path)[0], 1)
        code, j = self.judged("westergaard.half_width", path, "--where", "load=1e-6..0.49")
        self.assertEqual((code, j["rows"]), (0, 49))
        self.assertEqual(self.judged("westergaard.half_width", path, "--where", "load=0.5")[1]["rows"], 1)
        r = run("westergaard_half_width", "--where", "load=0.1..0.2", "--json", "--", os.path.join(options.subjects, "subject_library_forms"), "westergaard.half_width")
        self.assertTrue(all(0.1 <= float.fromhex(w["inputs"][0]) <= 0.2 for w in json.loads(r.stdout)["worst"]))
        for bad, expected in (("lod=1", "INPUT=LOW..HIGH"), ("load", "INPUT=LOW..HIGH"), ("load=2..1", "above"), ("load=x", "not a number"), ("load=1..", "empty")):
            r = run("westergaard.half_width", "--rows", path, "--where", bad)
            self.assertEqual((r.returncode, r.stderr.count("\n")), (64, 1))
            self.assertIn(expected, r.stderr)
        self.assertEqual(run("westergaard.half_width", "--rows", path, "--where", "load=2..3").returncode, 65)

    def test_named_factors_survive_noise(self):
        factors = {"factor 2:": 2, "factor 1/2": 0.5, "factor pi": math.pi, "factor 1/pi": 1 / math.pi, "factor 2 pi": 2 * math.pi, "nu = 0.3": 0.91}
        for name, factor in factors.items():
            for part in (0, 1e-9, 1e-5, 3e-4, 3e-3, 1e-2):
                with self.subTest(name, noise=part):
                    j = self.mixup(lambda x, load: factor * pressure(x, load) * self.noisy(part))
                    self.assertIsNotNone(j["mixup"], j["ratio"])
                    self.assertIn(name, j["mixup"]["name"])
                    self.assertLess(j["mixup"]["to"], 20 * max(part, 1e-6))
                    self.assertAlmostEqual(j["ratio"]["median"] / factor, 1, 2)

    def test_units_of_the_inputs_and_combinations(self):
        for name, answer in {
            "load taken times 1/2": lambda x, load: 2 * pressure(x, load / 2),
            "mean pressure": lambda x, load: pressure(x, load) / load,
            "lambda": lambda x, load: pressure(x / (2 * math.pi), load),
            "valley": lambda x, load: pressure(0.5 - abs(x), load),
        }.items():
            for part in (0, 1e-4):
                with self.subTest(name, noise=part):
                    self.assertIn(name, self.mixup(lambda x, load: answer(x, load) * self.noisy(part))["mixup"]["name"])
                    # most rows of a real grid lie outside the contact, where every unit gives the right 0
                    outside = [(0.45, load) for _, load in INSIDE if load < 0.5] * 8
                    j = self.mixup(lambda x, load: answer(x, load) * self.noisy(part), grid=INSIDE + outside)
                    if name == "mean pressure":
                        self.assertIsNotNone(j["mixup"], j["ratio"])
                        self.assertIn(name, j["mixup"]["name"])
        both = self.mixup(lambda x, load: math.pi * pressure(x, load * 2))["mixup"]["name"]
        self.assertTrue("load taken times 2" in both and "pi" in both, both)

    def test_factors_that_no_list_has(self):
        j = self.mixup(lambda x, load: 0.9998 * pressure(x, load) * self.noisy(1e-6))
        self.assertIn("factor 0.999800 throughout", j["mixup"]["name"])
        self.assertNotIn("nu", j["mixup"]["name"])
        self.assertAlmostEqual(j["ratio"]["median"], 0.9998, 5)
        self.assertIn("nu = 0.27", self.mixup(lambda x, load: (1 - 0.27**2) * pressure(x, load))["mixup"]["name"])
        self.assertIn("constant offset 0.125", self.mixup(lambda x, load: pressure(x, load) + 0.125)["mixup"]["name"])
        self.assertIsNone(self.mixup(lambda x, load: pressure(x, load) * self.noisy(0.5))["mixup"])

    def test_half_of_the_rows(self):
        """What is explained in part is named, with what is left."""
        j = self.mixup(lambda x, load: (2 if load > 0.8 else 1.37 * math.cos(x)) * pressure(x, load))
        self.assertIn("factor 2", j["mixup"]["name"])
        self.assertTrue(0.4 < j["mixup"]["explains"] < 0.9)
        self.assertGreater(j["mixup"]["remains"], 10)
        self.assertIn("wrong even with that put right", run("westergaard.pressure", "--rows", self.folder / "rows.txt").stdout)

    def test_a_factor_seen_away_from_the_edge_alone(self):
        """The gap as twice the gap by its textbook form, which has no digit right beside the edge: most rows of the table lie there."""
        def gap(x, load):
            square = math.sin(math.pi * abs(x)) ** 2
            if load >= 1 or square <= load:
                return 0.0
            root = math.sqrt(square - load)
            return 2 * (math.sqrt(square) * root - load * math.log((math.sqrt(square) + root) / math.sqrt(load)))
        table = pathlib.Path(options.tables, "westergaard_gap.txt")
        rows = [line.split() for line in table.read_text().splitlines() if not line.startswith("#")]
        path = self.folder / "answers.txt"
        path.write_text("".join(f"{2 * gap(float(x), float(load))!r}\n" for x, load, *_ in rows))
        r = run(table, "--answers", path)
        self.assertEqual(r.returncode, 1)
        self.assertIn("likely mistake: factor 2", r.stdout)
        self.assertRegex(r.stdout, "explains 100 % of the ordinary rows")
        self.assertIn("not ordinary are wrong in another way", r.stdout)
        # three rows of four beside the edge, and noise there: a sample of every fourth row would see one kind alone
        grid = [(half_width(load) * (1 + 1e-3 * (k + 0.5) / 64) if k % 4 else half_width(load) + (0.5 - half_width(load)) * (k + 0.5) / 64, load)
                for load in (0.02, 0.1, 0.3, 0.5, 0.7, 0.9) for k in range(64)]
        beside = {g for i, g in enumerate(grid) if i % 4}
        m = self.mixup(lambda x, load: 2 * gap(x, load) * (self.noisy(0.5) + 0.5 if (x, load) in beside else 1), quantity="westergaard.gap", grid=grid)["mixup"]
        self.assertEqual((m["name"].split(":")[0], m["of"]), ("factor 2", "ordinary rows"))
        self.assertEqual(self.mixup(lambda x, load: 2 * gap(x, load), quantity="westergaard.gap", grid=[g for g in grid if g not in beside])["mixup"]["of"], "all rows")

    def test_numbers_by_their_looks(self):
        j = self.mixup(lambda x, load: repr(single(pressure(x, load))))
        self.assertIn("float32", " ".join(j["findings"]))
        self.assertIsNone(j["mixup"])
        j = self.mixup(lambda x, load: f"{pressure(x, load):.6g}")
        self.assertIn("6 significant digits", " ".join(j["findings"]))
        j = self.mixup(lambda x, load: repr(2 * single(pressure(x, load))))
        self.assertIn("factor 2", j["mixup"]["name"])
        self.assertEqual(self.mixup(lambda x, load: pressure(x, load) * self.noisy(1e-12))["findings"], [])

    def test_one_answer_to_everything(self):
        """A plateau of some other load would seem to explain a constant."""
        grid = [(0.1 * k, load) for load in (0.2, 0.5, 0.9, 1.5) for k in range(1, 20)]
        j = self.mixup(lambda p, load: 0.5, quantity="westergaard.exceedance", grid=grid, columns="p load")
        self.assertIsNone(j["mixup"])
        self.assertEqual(j["findings"], ["all 76 answers are 0.5, whatever is asked"])

    def test_tension_outside_the_contact(self):
        grid = [(2 * x, load) for x, load in GRID]  # to the valleys
        j = self.mixup(lambda x, load: load - 1 + 2 * math.cos(math.pi * x) ** 2, grid=grid)
        self.assertIn("nothing keeps the pressure from tension", j["mixup"]["name"])
        self.assertEqual((j["mixup"]["of"], j["mixup"]["remains"]), ("all rows", 0))
        j = self.mixup(lambda x, load: max(load - 1 + 2 * math.cos(math.pi * x) ** 2, 0), grid=grid)
        self.assertIn("cut off at zero", j["mixup"]["name"])

    def test_regimes(self):
        j = self.mixup(lambda x, load: 0 if load >= 1 else pressure(x, load))
        full = next(r for r in j["regimes"] if r["name"] == "full contact")
        self.assertEqual(full["faults"], [f"{full['rows']} of {full['rows']} answers are 0"])
        self.assertEqual((full["worst_relative"], full["right_digits"]), (1.0, 0))
        ordinary = next(r for r in j["regimes"] if r["name"] == "ordinary")
        self.assertEqual((ordinary["failed"], ordinary["faults"]), (0, []))
        self.assertGreater(ordinary["right_digits"], 12)
        self.assertIn("full contact: 128 of 128 answers are 0", run("westergaard.pressure", "--rows", self.folder / "rows.txt").stdout)
        names = set()
        for load in (5e-324, 1e-9, 0.5, 0.9999, 1.0):
            j = self.judged("westergaard.mean_gap", self.rows(lambda load: 1, [(load,)], "load"))[1]
            names |= {r["name"] for r in j["regimes"]}
        self.assertEqual(names, {"subnormal", "tiny load", "ordinary", "nearly full contact", "true value zero"})
        j = self.mixup(lambda x, load: 1, grid=[(half_width(0.3) * (1 - 1e-5), 0.3)])
        self.assertEqual([r["name"] for r in j["regimes"]], ["near the edge"])
        self.assertGreater(j["regimes"][0]["forced_relative"], 1e-13)

    def test_a_series_cut_off(self):
        def profile(x, D, gamma):
            return sum(gamma ** ((D - 2) * n) * math.cos(2 * math.pi * gamma**n * x) for n in range(5))
        grid = [(x / 37, 1.5, 5.0) for x in range(1, 18)]
        j = self.mixup(profile, quantity="weierstrass.profile", grid=grid, columns="x D gamma")
        self.assertIn("after 5 terms", j["mixup"]["name"])

    def test_the_stable_form_is_named(self):
        r = run("westergaard_mean_gap", "--", os.path.join(options.subjects, "subject_printed_formulas"), "westergaard.mean_gap")
        self.assertEqual(r.returncode, 1)
        self.assertIn("the library computes load > 1/4, e = 1 - load", r.stdout)

    def test_contact_area_takes_seconds(self):
        """A code that is right to a part in a thousand, on the certified table of the recursion."""
        table = pathlib.Path(options.tables, "contact_area.txt")
        path = self.folder / "answers.txt"
        with open(path, "w") as f:
            for line in table.read_text().splitlines():
                if not line.startswith("#"):
                    f.write(f"{float(line.split()[3]) * self.noisy(1e-3)!r}\n")
        import resource
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        self.assertEqual(run(table, "--answers", path, "--recheck", "0", "--rtol", "1e-3").returncode, 0)
        r = run(table, "--answers", path, "--recheck", "0", "--rtol", "1e-4", "--where", "n=0..3")
        self.assertEqual(r.returncode, 1, r.stderr)
        self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, 20)

    def test_bad_rows(self):
        for text, expected in (("# load answer\n0.5\n", "rows.txt:2: row 1: 1 columns"), ("# load answer\n0.5 x\n", "the answer 'x' is not one number"),
                               ("# load answer\nnan 1\n", "load = 'nan'"), ("# lod answer\n1 1\n", "unknown column 'lod'"), ("# load answer\n2 1\n", "row 1: load = 2"),
                               ("# load answer\n-1 1\n", "row 1: load = -1"), ("# load answer\n1e400 1\n", "row 1"), ("", "no rows"), ("# answer load load\n1 1 1\n", "twice"),
                               ("load;answer\n1;1\n", "not by ';'")):
            path = self.folder / "rows.txt"
            path.write_text(text)
            r = run("westergaard.half_width", "--rows", path)
            self.assertEqual((r.returncode, r.stdout, r.stderr.count("\n")), (65, "", 1), (text, r.stderr))
            self.assertIn(expected, r.stderr)
        path.write_text("# load\n0.5\n")
        for words, code, expected in ((("westergaard.half_width", "--rows", path), 64, "one subject"), (("westergaard.pressure", "--rows", path), 64, "no column 'x'"),
                                      (("westergaard.half_width", "--rows", path, "load=1"), 64, "is a column and given"),
                                      (("westergaard.half_width", "--rows", self.folder), 65, "Is a directory"), (("westergaard.half_width", "--rows", "/none"), 66, "no such file"),
                                      (("nothing", "--rows", path), 64, "nearest is"), (("westergaard.half_width", "--rtol", "-1", "--", "true"), 64, "--rtol"),
                                      (("westergaard.half_width", "--atol", "nan", "--", "true"), 64, "--atol")):
            r = run(*words)
            self.assertEqual((r.returncode, r.stderr.count("\n")), (code, 1), (words, r.stderr))
            self.assertIn(expected, r.stderr)

    def test_an_endless_file_of_rows_ends(self):
        for bytes_ in (b"1", b"0.5 0.25\n"):
            pipe = self.folder / "pipe"
            os.mkfifo(pipe)

            def feed():
                try:
                    with open(pipe, "wb") as f:
                        f.write(b"# load answer\n")
                        while True:
                            f.write(bytes_ * 10000)
                except BrokenPipeError:
                    pass

            threading.Thread(target=feed, daemon=True).start()
            r = run("westergaard.half_width", "--rows", pipe)
            self.assertEqual((r.returncode, r.stderr.count("\n")), (65, 1), r.stderr)
            self.assertRegex(r.stderr, "no line end within|more than 1000000 rows")
            pipe.unlink()


class Adapters(unittest.TestCase):
    HERE = {"python": "(math.atan2(math.sqrt(load), math.sqrt(1 - load)) / math.pi)", "c": "atan2(sqrt(load), sqrt(1 - load)) / 3.14159265358979323846",
            "fortran": "atan2(sqrt(x(1)), sqrt(1 - x(1))) / acos(-1.0_c_double)", "octave": "atan2(sqrt(load), sqrt(1 - load)) / pi"}
    NOTHING = {"python": 'float("nan")', "c": "NAN", "fortran": "ieee_value(x(1), ieee_quiet_nan)", "octave": "NaN"}

    def build(self, language, source, folder):
        """The words that run it."""
        ending = {"python": "py", "c": "c", "fortran": "f90", "octave": "m"}[language]
        path, program = folder / f"adapter.{ending}", folder / f"adapter_{language}"
        path.write_text(source)
        if language == "python":
            return [sys.executable, str(path)]
        if language == "octave":
            return [shutil.which("octave-cli"), str(path)]
        compiler = ["cc", "-Wall", "-Wextra", "-Werror"] if language == "c" else ["gfortran", "-Wall"]
        subprocess.run([*compiler, "-O2", "-o", str(program), str(path), "-lm"], check=True, capture_output=True)
        return [str(program)]

    def verdict(self, language, words, folder):
        if language != "octave":
            return run("westergaard_half_width", "--json", "--", *words)
        table, answers = folder / "t.txt", folder / "answers.txt"
        table.write_text(subprocess.run([PROGRAM, "table", "westergaard_half_width"], check=True, capture_output=True, text=True).stdout)
        subprocess.run([*words, str(table), str(answers)], check=True, capture_output=True)
        return run(table, "--json", "--answers", answers)

    def test_each_runs_as_it_is_and_passes_when_filled_in(self):
        tools = {"python": sys.executable, "c": shutil.which("cc"), "fortran": shutil.which("gfortran"), "octave": shutil.which("octave-cli")}
        for language, tool in tools.items():
            with self.subTest(language), tempfile.TemporaryDirectory() as folder:
                if tool is None:
                    print(f"{language} is not installed: its adapter is not run", file=sys.stderr)
                    continue
                folder = pathlib.Path(folder)
                source = run("--emit", language, "westergaard.half_width").stdout
                j = json.loads(self.verdict(language, self.build(language, source, folder), folder).stdout)
                self.assertEqual(j["verdict"], "fail")
                self.assertEqual(j["special"], j["rows"])
                self.assertEqual(source.count(self.NOTHING[language]), 1)
                filled = source.replace(self.NOTHING[language], self.HERE[language]).replace("import sys\n", "import math\nimport sys\n")
                r = self.verdict(language, self.build(language, filled, folder), folder)
                self.assertEqual((r.returncode, json.loads(r.stdout)["verdict"]), (0, "pass"), r.stdout[:2000])

    def test_every_quantity_has_one(self):
        names = [q["name"] for q in json.loads(subprocess.run([PROGRAM, "list", "--json"], check=True, capture_output=True, text=True).stdout)]
        for name in names:
            compile(run("--emit", "python", name).stdout, name, "exec")
        self.assertEqual(run("--emit", "cobol", "archard.K").returncode, 64)
        self.assertEqual(run("--emit", "c", "nobody").returncode, 64)


if __name__ == "__main__":
    unittest.main(verbosity=2)
