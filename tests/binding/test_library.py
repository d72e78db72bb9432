#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The shared library from outside: its name, its symbols, and the examples in other languages.

usage: test_library.py LIBRARY EXAMPLES HEADER_FOLDER TOUCHSTONE
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

LIBRARY, EXAMPLES, HEADERS, PROGRAM = (sys.argv.pop(1) for _ in range(4))
LIBRARY = pathlib.Path(LIBRARY).resolve()


def output(*words, **options):
    return subprocess.run(words, check=True, capture_output=True, text=True, **options).stdout


class Library(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name in ("libtouchstone.so", "libtouchstone.so.1"):
            (self.folder / name).symlink_to(LIBRARY)
        self.environment = {**os.environ, "LD_LIBRARY_PATH": str(self.folder)}
        self.right = json.loads(output(PROGRAM, "eval", "contact.area", "n=3", "load=1/8", "G=5/2", "--digits", "30", "--json"))

    def test_only_the_headers_functions_are_exported_and_all_of_them(self):
        symbols = {line.split()[-1].split("@")[0] for line in output("nm", "-D", "--defined-only", str(LIBRARY)).splitlines()} - {"TOUCHSTONE_1"}
        declared = set(re.findall(r"TOUCHSTONE_API .*?(touchstone_\w+)\(", (pathlib.Path(HEADERS) / "touchstone.h").read_text()))
        self.assertEqual(symbols, declared)
        self.assertIn("[libtouchstone.so.1]", output("readelf", "-d", str(LIBRARY)))

    @unittest.skipUnless(shutil.which("gfortran"), "no gfortran")
    def test_fortran(self):
        program = self.folder / "area"
        output("gfortran", "-Wall", "-o", str(program), f"{EXAMPLES}/area.f90", f"-L{self.folder}", "-ltouchstone")
        first, second = map(float, output(str(program), env=self.environment).split())
        self.assertEqual(first, float.fromhex(self.right["binary64"]))
        self.assertLess(second, first)

    @unittest.skipUnless(shutil.which("mkoctfile") and shutil.which("octave-cli"), "no octave with its headers")
    def test_octave(self):
        output("mkoctfile", "--mex", f"-I{HEADERS}", f"-L{self.folder}", "-o", str(self.folder / "touchstone_eval.mex"), f"{EXAMPLES}/touchstone_eval.c", "-ltouchstone", cwd=self.folder)
        text = output("octave-cli", "--no-init-file", "--path", str(self.folder), f"{EXAMPLES}/area.m", env=self.environment)
        self.assertEqual(text.strip(), self.right["value"])
        r = subprocess.run(["octave-cli", "--no-init-file", "--path", str(self.folder), "--eval", "touchstone_eval('contact.area', 'n=-3 load=1/8 G=5/2', 30)"], capture_output=True, text=True, env=self.environment)
        self.assertIn("n = -3: must be", r.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=1)
