#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""README and docs/ do what they say: commands print what stands below them, Python runs, links lead somewhere.

usage: test_documents.py PROGRAM SOURCE_FOLDER
"""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv.pop(1))
SOURCE = pathlib.Path(sys.argv.pop(1)).resolve()
PAGES = [SOURCE / "README.md", *sorted((SOURCE / "docs").glob("*.md"))]


def blocks(page):
    """(language, text) of each fenced block."""
    return re.findall(r"^```(\w*)\n(.*?)^```$", page.read_text(), re.S | re.M)


def touchstone(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=120, cwd=SOURCE)


class Documents(unittest.TestCase):
    def test_commands_print_what_is_shown(self):
        shown = 0
        for page in PAGES:
            for _, text in blocks(page):
                if not text.startswith("$ touchstone "):
                    continue
                command, _, expected = text.partition("\n")
                printed = touchstone(*shlex.split(command)[2:]).stdout
                pattern = re.escape(expected).replace(re.escape("...\n"), "(?:.*\n)*")
                self.assertRegex(printed, "^" + pattern + r"\Z", f"{page.name}: {command}")
                shown += 1
        self.assertGreaterEqual(shown, 3)

    def test_python_runs(self):
        for page in PAGES:
            names = {}
            for language, text in blocks(page):
                if language == "python" and "numpy" not in text:
                    exec(compile(text, page.name, "exec"), names)  # assertions are in the text

    def test_the_three_lines_of_the_readme(self):
        text = next(t for language, t in blocks(SOURCE / "README.md") if language == "sh" and "mycode.py" in t)
        expected = next(t for _, t in blocks(SOURCE / "README.md") if t.startswith("FAIL: "))
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(PROGRAM, os.path.join(folder, "touchstone"))
            environment = dict(os.environ, PATH=f"{folder}:{os.environ['PATH']}")
            answer = subprocess.run(["sh", "-c", text], cwd=folder, env=environment, capture_output=True, text=True, timeout=300)
            self.assertEqual(answer.returncode, 1, answer.stderr)
            self.assertTrue(answer.stdout.startswith(expected), answer.stdout[:600])
            self.assertTrue(os.path.getsize(os.path.join(folder, "errors.svg")) > 1000)
            with open(os.path.join(folder, "mycode.py"), "w") as code:  # the way out that the page names
                code.write("import sys, math\nfor line in sys.stdin:\n    load = float.fromhex(line); s = math.sqrt(load)\n"
                           "    print(math.atan2(s, math.sqrt(1 - load)) / math.pi)\n")
            answer = subprocess.run([PROGRAM, "judge", "westergaard_half_width", "--", sys.executable, os.path.join(folder, "mycode.py")], capture_output=True, text=True, timeout=300)
            self.assertEqual(answer.returncode, 0, answer.stdout)

    def test_what_the_readme_does_without_a_build(self):
        text = next(t for language, t in blocks(SOURCE / "README.md") if language == "sh" and "touchstone_reference" in t)
        answer = subprocess.run(["sh", "-c", text], cwd=SOURCE, capture_output=True, text=True, timeout=300, env=dict(os.environ, PYTHONDONTWRITEBYTECODE="1"))
        self.assertEqual((answer.returncode, answer.stderr), (0, ""))
        value, rest = answer.stdout.split("\n", 1)
        self.assertEqual(value, "3 0.4165503718328134877227202567332557025482 5e-41 0")
        self.assertRegex(rest, r"^[1-9]\d* of \d{3} rows fail; the worst: inputs 0x1\.ff\S+, .* ulps, true value 0\.4999\d+\n\Z")

    def test_markdown_shows_what_is_written(self):
        """A bar ends a cell and two asterisks in a line make italics of what lies between them, unless they are escaped."""
        for page in PAGES:
            text = re.sub(r"^```.*?^```$|`[^`\n]*`", lambda m: "\n" * m.group().count("\n"), page.read_text(), flags=re.S | re.M)
            columns = None
            for number, line in enumerate(text.split("\n"), 1):
                bars = len(re.findall(r"(?<!\\)\|", line))
                if not line.startswith("|"):
                    columns = None
                elif columns is None:
                    columns = bars
                else:
                    self.assertEqual(bars, columns, f"{page.name}:{number}: {line}")
                for cell in re.split(r"(?<!\\)\|", line):
                    self.assertLess(len(re.findall(r"(?<![\\*])\b[pE]\*(?!\*)", cell)), 2, f"{page.name}:{number}: {cell}")

    def test_links_resolve(self):
        for page in PAGES:
            text = re.sub(r"^```.*?^```$", "", page.read_text(), flags=re.S | re.M)
            for target in re.findall(r"\]\(([^)#]+)", text):
                if not target.startswith("http"):
                    self.assertTrue((page.parent / target).exists(), f"{page.name}: {target}")

    def test_readme_is_short(self):
        self.assertLessEqual(len((SOURCE / "README.md").read_text().splitlines()), 120)

    def test_quantities_are_up_to_date(self):
        self.assertEqual(touchstone("list", "--markdown").stdout, (SOURCE / "docs/quantities.md").read_text(), "touchstone list --markdown > docs/quantities.md")

    def test_site(self):
        if not shutil.which("mkdocs"):
            self.skipTest("no mkdocs")
        with tempfile.TemporaryDirectory() as folder:
            answer = subprocess.run(["mkdocs", "build", "--strict", "--quiet", "--site-dir", folder], cwd=SOURCE, capture_output=True, text=True)
            self.assertEqual(answer.returncode, 0, answer.stdout + answer.stderr)
            for page in pathlib.Path(folder).glob("*.html"):
                text = page.read_text()
                self.assertNotRegex(text, r"<(script|img|iframe)[^>]*src=\"(https?:)?//|<link[^>]*href=\"(https?:)?//", page.name)


class Reference(unittest.TestCase):
    """The API from the docstrings, without a warning; and a docstring that is wrong is a failure."""

    def doxygen(self, *more):
        if not shutil.which("doxygen"):
            self.skipTest("no doxygen")
        with tempfile.TemporaryDirectory() as folder:
            settings = (SOURCE / "Doxyfile").read_text() + f"OUTPUT_DIRECTORY = {folder}\n" + "".join(line + "\n" for line in more)
            answer = subprocess.run(["doxygen", "-"], input=settings, cwd=SOURCE, capture_output=True, text=True)
            pages = list(pathlib.Path(folder, "api").glob("*.html"))
            text = pathlib.Path(folder, "api", "westergaard_8hpp.html")
            return answer, len(pages), text.read_text() if text.exists() else ""

    def test_without_warnings(self):
        answer, pages, text = self.doxygen()
        self.assertEqual((answer.returncode, answer.stderr), (0, ""))
        self.assertGreater(pages, 100)
        self.assertIn("half_width", text)

    def test_a_wrong_docstring_fails(self):
        with tempfile.TemporaryDirectory() as folder:
            header = pathlib.Path(folder) / "wrong.hpp"
            header.write_text("/// \\file\n\n/// \\ref nowhere\nint f(int x);\n")
            answer, _, _ = self.doxygen(f"INPUT = {header}", "USE_MDFILE_AS_MAINPAGE =")
            self.assertNotEqual(answer.returncode, 0)
            self.assertIn("wrong.hpp", answer.stderr)


class Adapters(unittest.TestCase):
    """What `list QUANTITY` shows compiles, speaks the protocol, and is right once the function is put in."""

    def adapter(self, quantity, language):
        text = touchstone("list", quantity).stdout
        return re.search(rf"^-- {re.escape(language)} --\n(.*?)(?=^-- |\Z)", text, re.S | re.M).group(1)

    def judge(self, *command):
        return subprocess.run([PROGRAM, "judge", "westergaard_half_width", "--held-out", "0", "--", *command], capture_output=True, text=True, timeout=300)

    def test_python(self):
        with tempfile.TemporaryDirectory() as folder:
            code = self.adapter("westergaard.half_width", "Python")
            path = pathlib.Path(folder) / "code.py"
            path.write_text(code)
            self.assertEqual(self.judge(sys.executable, str(path)).returncode, 1)  # nan everywhere
            path.write_text("import math\n" + code.replace('float("nan")', "math.atan2(math.sqrt(load), math.sqrt(1 - load)) / math.pi"))
            self.assertEqual(self.judge(sys.executable, str(path)).returncode, 0)

    def compiled(self, language, compiler, suffix, hole, right, *libraries):
        if not shutil.which(compiler[0]):
            self.skipTest(f"no {compiler[0]}")
        with tempfile.TemporaryDirectory() as folder:
            for quantity in ("westergaard.pressure", "archard.K_inf", "segments.count"):  # two, none, four inputs
                source = pathlib.Path(folder) / f"other{suffix}"
                source.write_text(self.adapter(quantity, language))
                subprocess.run([*compiler, str(source), "-o", f"{folder}/other", *libraries], check=True, capture_output=True)
            source = pathlib.Path(folder) / f"code{suffix}"
            code = self.adapter("westergaard.half_width", language)
            self.assertIn(hole, code)
            source.write_text(code.replace(hole, right))
            subprocess.run([*compiler, str(source), "-o", f"{folder}/code", *libraries], check=True, capture_output=True)
            answer = self.judge(f"{folder}/code")
            self.assertEqual(answer.returncode, 0, answer.stdout)

    def test_cpp(self):
        self.compiled("C and C++", ["g++", "-std=c++17", "-Wall", "-Werror"], ".cpp", "return NAN", "return atan2(sqrt(load), sqrt(1 - load)) / acos(-1.0)")

    def test_c(self):
        self.compiled("C and C++", ["gcc", "-std=c99", "-Wall", "-Werror"], ".c", "return NAN", "return atan2(sqrt(load), sqrt(1 - load)) / acos(-1.0)", "-lm")

    def test_fortran(self):
        self.compiled("Fortran", ["gfortran"], ".f90", "ieee_value(x(1), ieee_quiet_nan)", "atan2(sqrt(x(1)), sqrt(1 - x(1))) / acos(-1.0_c_double)")


if __name__ == "__main__":
    unittest.main()
