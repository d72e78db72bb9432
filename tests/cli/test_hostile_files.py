#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""JSON that nobody would write, wherever a file is read: one line and the right exit code, never a signal or an internal error.

usage: test_hostile_files.py PROGRAM
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv.pop(1))
DEEP = "[" * 300_000 + "]" * 300_000  # deeper than a stack


class HostileFiles(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.scratch.name)

    def tearDown(self):
        self.scratch.cleanup()

    def refuses(self, *words, code=65):
        r = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=120)
        self.assertEqual(r.returncode, code, (words, r.stderr[:300]))
        self.assertEqual(r.stderr.count("\n"), 1, r.stderr[:300])
        self.assertNotIn("internal error", r.stderr)
        self.assertLess(len(r.stderr), 600)

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def test_brackets_without_end(self):
        self.refuses("table", self.file("mine.json", '{"name":%s}' % DEEP))
        self.refuses("merge", self.file("s.txt", '# Touchstone shard 1 of 2\n# {"a":%s,"sha256":"x"}\n' % DEEP).parent)
        self.refuses("judge", self.file("t.txt", '# {"name":%s}\n# value error\n1 0\n' % DEEP), "--", "cat")
        self.refuses("judge", "archard_K", "--baseline", self.file("b.json", '{"table":"a","sha256":"b","ulps":{"k":%s}}' % DEEP), "--", "cat")
        self.refuses("report", "--out", self.folder / "r", "--ledger", self.file("l.json", '[{"id":"a","verdict":"proved","steps":%s}]' % DEEP))
        for text in (DEEP, '{"symbols":{"a":%s},"entries":[1]}' % DEEP):
            self.file("ledger.json", text)
            self.refuses("paper", "--ledger", self.folder)

    def test_texts_without_end(self):
        long = "a" * 500_000
        entry = {"id": "1", "says": "a = b"}
        symbols = {"a": {"dimension": "1"}, "b": {"dimension": "1"}}
        for ledger in ({"symbols": {long: {"dimension": "1"}}, "entries": [entry]}, {"symbols": symbols, "entries": [dict(entry, says="a = " + "(" * 100_000 + "b")]},
                       {"symbols": symbols, "entries": [entry, {"id": "2", "says": "a = b", "follows": {"equation": "1", "with": {"b": "@" + long}}}]}):
            self.file("ledger.json", json.dumps(ledger))
            self.refuses("paper", "--ledger", self.folder)

    def test_what_is_no_manifest(self):
        for manifest in ({"tables": 5}, {"tables": [1]}, {"tables": {"a": {"file": "b"}}}, [1], {"tables": [{"name": "a"}]}):
            self.file("manifest.txt.json", json.dumps(manifest))
            r = subprocess.run([PROGRAM, "table", "archard_K_inf", "--digits", "20", "--out", self.folder], capture_output=True, text=True)
            self.assertEqual((r.returncode, r.stderr.count("\n")), (65, 1), r.stderr)
            self.assertIn("manifest.txt.json: not a manifest", r.stderr)

    def test_a_ledger_of_other_types(self):
        for key, value in (("steps", [1]), ("steps", 1), ("rests_on", [None]), ("lemmas", "a"), ("rows", [[]]), ("controls", ["a"])):
            self.refuses("report", "--out", self.folder / "r", "--ledger", self.file("l.json", json.dumps([{"id": "a", "verdict": "proved", key: value}])))

    def test_a_header_of_other_types(self):
        for key in ('"forced":3', '"status":[1]', '"digits":"x"', '"inputs":{}'):
            head = '"name":"t","quantity":"archard.K_inf","inputs":[],"digits":2,"sha256":"0"'
            kept = ",".join(k for k in head.split(",") if k.split(":")[0] != key.split(":")[0])
            self.refuses("judge", self.file("t.txt", "# {%s,%s}\n# value error\n1.5 0.05\n" % (kept, key)), "--", "cat")


if __name__ == "__main__":
    unittest.main()
