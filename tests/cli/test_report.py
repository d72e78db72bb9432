#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The report as a reader gets it: valid HTML, nothing from the network, no figure missing, no link that leads nowhere.

usage: test_report.py PROGRAM
"""
import base64
import csv
import html.parser
import io
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

PROGRAM = sys.argv.pop(1)
FIGURES = ["figure1", "figure2", "figure3", "figure4", "figure5", "hertz-error", "apparent-dimension", "print-errors", "hertzian-share", "edge-error"]
ENTRIES = ["2.14", "2.5", "7.17", "9.4", "table1.n07"]  # a ledger in small: judging all of it has a test of its own


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300)


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.ids, self.references, self.images = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for key, value in attributes:
            if key == "id":
                self.ids.append(value)
            if key in ("href", "src", "srcset", "action", "data", "poster"):
                self.references.append((tag, key, value))


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = pathlib.Path(cls.folder.name) / "report"
        entries = [json.loads(run("paper", e, "--json").stdout) for e in ENTRIES]
        ledger = pathlib.Path(cls.folder.name) / "ledger.json"
        ledger.write_text(json.dumps(entries))
        cls.answer = run("report", "--out", cls.out, "--ledger", ledger)
        cls.text = (cls.out / "index.html").read_text() if cls.answer.returncode == 0 else ""

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_it_is_made(self):
        self.assertEqual(self.answer.returncode, 0, self.answer.stderr)
        self.assertIn("index.html", self.answer.stdout)

    def test_html_is_valid(self):
        tidy = shutil.which("tidy")
        self.assertIsNotNone(tidy, "tidy, which ./bootstrap.sh test installs, is missing")
        answer = subprocess.run([tidy, "-q", "-e", str(self.out / "index.html")], capture_output=True, text=True)
        self.assertEqual(answer.returncode, 0, answer.stderr[:2000])

    def test_nothing_comes_from_the_network(self):
        page = Page(self.text)
        for tag, key, value in page.references:
            for reference in value.split() if key == "srcset" else [value]:
                self.assertRegex(reference, r"^(#|data:)", f"<{tag} {key}>")
        self.assertNotRegex(self.text, r"@import|url\(|<link|<script src|<iframe")
        for data in re.findall(r"data:image/svg\+xml;base64,([A-Za-z0-9+/=]+)", self.text):
            drawing = base64.b64decode(data).decode()
            outside = [u for u in re.findall(r"https?://[^\"'\s<]+", drawing) if not u.startswith("http://www.w3.org/")]
            self.assertEqual(outside, [])
            ElementTree.fromstring(drawing)

    def test_links_and_ids(self):
        page = Page(self.text)
        self.assertEqual(len(page.ids), len(set(page.ids)), "an id is there twice")
        for _, _, value in page.references:
            if value.startswith("#") and not value.startswith("#entry-"):
                self.assertIn(value[1:], page.ids)
        for entry in ENTRIES:
            self.assertIn("entry-" + entry, page.ids)
            self.assertIn("touchstone paper " + entry, self.text)

    def test_equations_are_typeset(self):
        self.assertGreaterEqual(self.text.count("<math"), 4)
        self.assertNotIn('class="tex"', self.text)

    def test_every_figure_is_there(self):
        for name in FIGURES:
            drawing = (self.out / "figures" / f"{name}.svg").read_text()
            ElementTree.fromstring(drawing)
            self.assertGreater(drawing.count("<path") + drawing.count("<use"), 50, name)
            self.assertEqual((self.out / "figures" / f"{name}.pdf").read_bytes()[:5], b"%PDF-", name)
            rows = list(csv.DictReader(io.StringIO((self.out / "figures" / f"{name}.csv").read_text())))
            self.assertGreater(len(rows), 15, name)
            for row in rows:
                self.assertIn(row["status"], ("exact", "certified", "measured"), name)
                if row["status"] == "certified":
                    self.assertGreater(float(row["error"]) if row["error"] else 1, 0, name)
            self.assertIn(f'id="{name}"', self.text)
            self.assertIn(f"touchstone paper {name} --svg", self.text)

    def test_points_are_the_quantities(self):
        """What is drawn, from formulas that share nothing with the program."""
        with open(self.out / "figures" / "figure3.csv") as file:
            rows = list(csv.DictReader(file))
        for load in ("0.001", "0.01", "0.1"):
            row = next(r for r in rows if r["panel"].startswith("(d)") and r["curve"] == f"(6.7), load {load}" and r["x"] == "0")
            self.assertAlmostEqual(float(row["value"]), 2 / math.pi * math.asin(math.sqrt(float(load))), delta=1e-8)
            # (7.14): the Hertzian value at n = 0
            row = next(r for r in rows if r["panel"].startswith("(d)") and r["curve"] == f"(7.18), load {load}" and r["x"] == "0")
            self.assertAlmostEqual(float(row["value"]), 2 / math.pi * math.sqrt(float(load)), delta=1e-8)
        with open(self.out / "figures" / "figure5.csv") as file:
            rows = [r for r in csv.DictReader(file) if r["curve"] == "q_n, n = 3"]
        points = [(0.0, 0.0)] + [(float(r["x"]), float(r["value"])) for r in rows]
        area = sum((b[0] - a[0]) * (a[1] + b[1]) / 2 for a, b in zip(points, points[1:]))
        self.assertAlmostEqual(area, 1, delta=0.02)  # a density


class Alone(unittest.TestCase):
    def test_one_figure(self):
        with tempfile.TemporaryDirectory() as folder:
            answer = run("paper", "figure1", "--svg", f"{folder}/f.svg", "--pdf", f"{folder}/f.pdf", "--csv", f"{folder}/f.csv")
            self.assertEqual(answer.returncode, 0, answer.stderr)
            self.assertEqual(sorted(os.listdir(folder)), ["f.csv", "f.pdf", "f.svg"])

    def test_what_is_no_figure(self):
        answer = run("paper", "figure9", "--svg", "/nowhere/f.svg")
        self.assertEqual(answer.returncode, 65)
        self.assertIn("figure5", answer.stderr)
        self.assertEqual(len(answer.stderr.splitlines()), 1)

    def test_what_cannot_be_written(self):
        self.assertEqual(run("report", "--out", "/proc/nowhere").returncode, 73)
        with tempfile.NamedTemporaryFile("w") as file:
            file.write("[1, 2]")
            file.flush()
            with tempfile.TemporaryDirectory() as folder:
                answer = run("report", "--out", folder, "--ledger", file.name)
                self.assertEqual(answer.returncode, 65, answer.stderr)

    def test_gnuplot_missing(self):
        answer = subprocess.run([PROGRAM, "paper", "figure1", "--svg", "/nowhere/f.svg"], capture_output=True, text=True, env={"PATH": "/nowhere"})
        self.assertEqual(answer.returncode, 69)
        self.assertIn("gnuplot-nox", answer.stderr)


if __name__ == "__main__":
    unittest.main()
