#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What packaging/sbom.py says the program and the C library are made of: SPDX 2.3, complete, with the versions of pkg-config, and no GPL in the MIT part.

usage: test_sbom.py SCRIPT PROGRAM LIBRARY [ARCHIVE...]     the archives that the program has in itself

Where the package spdx-tools is installed (pip install spdx-tools), its own validation has the last word.
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

SCRIPT, PROGRAM, LIBRARY = (pathlib.Path(sys.argv.pop(1)).resolve() for _ in range(3))
ARCHIVES = [f"--archive={file}" for file in sys.argv[1:]]
del sys.argv[1:]
HEADERS = ("--header", "Boost=1.74", "--header", "nlohmann_json=3.11", "--header", "CLI11=2.3")
# What pkg-config calls a project, where its developers' files are installed.
MODULES = {"GMP": "gmp", "MPFR": "mpfr", "GSL": "gsl", "GiNaC": "ginac", "CLN": "cln", "OpenSSL": "libcrypto", "fmt": "fmt"}
LICENCE = re.compile(r"[A-Za-z0-9.-]+( WITH [A-Za-z0-9.-]+)?( (AND|OR) [A-Za-z0-9.-]+)*")
# (object, key, pattern or type): what the specification asks of every document and every package.
DOCUMENT = {"spdxVersion": r"SPDX-2\.3", "dataLicense": r"CC0-1\.0", "SPDXID": r"SPDXRef-DOCUMENT", "name": r".+", "documentNamespace": r"https?://[^#\s]+"}
PACKAGE = {"SPDXID": r"SPDXRef-[A-Za-z0-9.-]+", "name": r".+", "downloadLocation": r"NOASSERTION|\w+://\S+", "licenseDeclared": LICENCE.pattern, "versionInfo": r"[\w.+~-]+"}


def made(*binaries, env=None):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "touchstone.spdx.json"
        done = subprocess.run([sys.executable, SCRIPT, "--version", "0.1.0", "--out", out, *HEADERS, *ARCHIVES, *binaries], capture_output=True, text=True, env=dict(os.environ, **(env or {})))
        return done, out.read_text() if done.returncode == 0 else ""


class Sbom(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        done, cls.text = made(PROGRAM, LIBRARY, env={"SOURCE_DATE_EPOCH": "1700000000"})
        if done.returncode:
            raise AssertionError(done.stderr)
        cls.document = json.loads(cls.text)
        cls.packages = {p["SPDXID"]: p for p in cls.document["packages"]}

    def linked(self, own, kinds=("DYNAMIC_LINK", "STATIC_LINK", "DEPENDS_ON")):
        return {r["relatedSpdxElement"] for r in self.document["relationships"] if r["spdxElementId"] == own and r["relationshipType"] in kinds}

    def test_the_specification(self):
        for key, pattern in DOCUMENT.items():
            self.assertRegex(self.document[key], f"^({pattern})$")
        self.assertEqual(self.document["creationInfo"]["created"], "2023-11-14T22:13:20Z")
        self.assertEqual(len(self.packages), len(self.document["packages"]), "a package twice")
        for p in self.packages.values():
            for key, pattern in PACKAGE.items():
                self.assertRegex(p[key], f"^({pattern})$", p)
        for r in self.document["relationships"]:
            self.assertIn(r["relatedSpdxElement"], self.packages)
            self.assertIn(r["spdxElementId"], {"SPDXRef-DOCUMENT", *self.packages})
        described = {r["relatedSpdxElement"] for r in self.document["relationships"] if r["relationshipType"] == "DESCRIBES"}
        self.assertEqual(described, {"SPDXRef-touchstone", "SPDXRef-libtouchstone"})
        self.assertEqual(set(self.packages), described | self.linked("SPDXRef-touchstone") | self.linked("SPDXRef-libtouchstone"))

    def test_with_the_specification_s_own_tool(self):
        try:
            from spdx_tools.spdx.parser.parse_anything import parse_file
            from spdx_tools.spdx.validation.document_validator import validate_full_spdx_document
        except ImportError:
            self.skipTest("no spdx-tools")
        with tempfile.NamedTemporaryFile("w", suffix=".spdx.json") as file:
            file.write(self.text)
            file.flush()
            self.assertEqual(validate_full_spdx_document(parse_file(file.name)), [])

    def test_what_is_linked(self):
        for name in ("FLINT", "GMP", "MPFR", "GNU-C-library", "GCC-runtime"):
            self.assertIn(f"SPDXRef-{name}", self.linked("SPDXRef-touchstone", ("DYNAMIC_LINK",)))
        self.assertTrue({"SPDXRef-GiNaC", "SPDXRef-CLN", "SPDXRef-OpenSSL", "SPDXRef-CLI11"} <= self.linked("SPDXRef-touchstone"))
        self.assertTrue({"SPDXRef-Boost", "SPDXRef-nlohmann-json", "SPDXRef-FLINT"} <= self.linked("SPDXRef-libtouchstone"))

    def test_the_mit_part_links_nothing_that_is_gpl_alone(self):
        """Itself: what Debian's FLINT 2.9 loads by way of NTL (gf2x) is said in the list."""
        self.assertEqual(self.packages["SPDXRef-libtouchstone"]["licenseDeclared"], "MIT")
        needs_gpl = lambda licence: all(one.startswith("GPL-") and "WITH" not in one for one in licence.split(" OR "))
        self.assertTrue(needs_gpl(self.packages["SPDXRef-GiNaC"]["licenseDeclared"]))
        self.assertEqual([p for p in self.linked("SPDXRef-libtouchstone", ("DYNAMIC_LINK", "STATIC_LINK")) if needs_gpl(self.packages[p]["licenseDeclared"])], [])

    @unittest.skipUnless(shutil.which("pkg-config"), "no pkg-config")
    def test_versions(self):
        compared = 0
        for name, module in MODULES.items():
            known = subprocess.run(["pkg-config", "--modversion", module], capture_output=True, text=True)
            if known.returncode == 0 and f"SPDXRef-{name}" in self.packages:
                self.assertTrue(self.packages[f"SPDXRef-{name}"]["versionInfo"].startswith(known.stdout.strip()), (name, known.stdout))
                compared += 1
        self.assertGreater(compared, 3)

    def test_the_same_build_the_same_bytes(self):
        self.assertEqual(made(PROGRAM, LIBRARY, env={"SOURCE_DATE_EPOCH": "1700000000"})[1], self.text)

    def test_what_nobody_has_looked_at_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            other = pathlib.Path(folder) / "touchstone"
            library = pathlib.Path(folder) / "libnobody.so"
            subprocess.run(["cc", "-shared", "-x", "c", "-o", library, "/dev/null"], check=True)
            subprocess.run(["cc", "-x", "c", "-o", other, "-", f"-Wl,-rpath,{folder}", "-Wl,--no-as-needed", f"-L{folder}", "-lnobody"], input="int main(void) { return 0; }", text=True, check=True)
            done, _ = made(other)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
            self.assertIn("libnobody.so: whose library is that", done.stderr)
        self.assertEqual(made("/bin/sh")[0].returncode, 1)


if __name__ == "__main__":
    unittest.main()
