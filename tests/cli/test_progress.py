#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Long work says how far it is: a bar on a terminal, lines in a log with --progress, else nothing; its share never goes back.

usage: test_progress.py PROGRAM
"""
import fcntl
import os
import pty
import re
import struct
import subprocess
import sys
import tempfile
import termios
import unittest

PROGRAM = os.path.abspath(sys.argv.pop(1))
SUBJECTS = os.path.join(os.path.dirname(PROGRAM), "verify", "subjects")
# seconds of work, many times the 0.1 s between two pictures: with steps of an engine, and without
VALUE = ["eval", "contact.exceedance", "n=5", "p=1/100", "load=1/100", "G=3", "--digits", "8"]
SHORT = ["eval", "contact.area", "n=2", "load=7/20", "G=3/2", "--digits", "60"]
SUBJECT = ["--", os.path.join(SUBJECTS, "subject_library_forms"), "westergaard.gap"]
LEDGER = ["paper"]


def on_a_terminal(arguments, columns=80):
    """What the program writes to a terminal of its own on stderr; its stdout goes nowhere."""
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    process = subprocess.Popen([PROGRAM, "--progress-every", "0.1", *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=slave)
    os.close(slave)
    text = b""
    while True:
        try:
            part = os.read(master, 65536)
        except OSError:
            break
        if not part:
            break
        text += part
    os.close(master)
    process.wait()
    return text.decode()


class Progress(unittest.TestCase):
    def check_bar(self, arguments, least):
        text = on_a_terminal(arguments)
        pictures = [p for p in text.split("\r\033[K") if p]
        self.assertGreaterEqual(len(pictures), least, text)
        shares, bars = [], []
        for picture in pictures:
            self.assertLess(len(picture), 80, "wider than the terminal: " + picture)
            self.assertNotIn("\n", picture)
            if share := re.search(r" (\d+) %, ", picture):
                shares.append(int(share.group(1)))
            if bar := re.match(r"\[(#*)(\.*)\] ", picture):
                self.assertEqual(len(bar.group(1)) + len(bar.group(2)), 24)
                bars.append(len(bar.group(1)))
        self.assertEqual(shares, sorted(shares), "the share goes back")
        self.assertEqual(bars, sorted(bars), "the bar goes back")
        self.assertTrue(text.endswith("\r\033[K"), "the line is left behind")
        return pictures, shares

    def test_a_judgement(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = os.path.join(folder, "rows.txt")
            with open(rows, "w") as file:
                file.write("# x load\n" + "".join(f"0.{k:06d} 0.3\n" for k in range(200000, 202000)))
            for arguments in (["westergaard.gap", "--rows", rows], ["westergaard_gap", "--held-out", "1500"]):
                pictures, shares = self.check_bar(["judge", *arguments, *SUBJECT], 1)  # how many there are depends on the machine
                self.assertTrue(shares, pictures)

    def test_one_value(self):
        pictures, shares = self.check_bar(VALUE, 3)
        self.assertTrue(shares, pictures)

    def test_an_integral(self):
        pictures, shares = self.check_bar(["integrate", "log(1/x)/sqrt(x)/(1+x^2)", "0", "1", "--digits", "1500"], 2)
        self.assertTrue(any(" values " in p or p.startswith("[") for p in pictures), pictures)
        self.assertTrue(shares, pictures)

    @unittest.skipUnless(os.environ.get("TOUCHSTONE_SLOW"), "the whole ledger, half a minute: TOUCHSTONE_SLOW=1")
    def test_the_ledger(self):
        pictures, shares = self.check_bar(LEDGER, 20)
        self.assertGreater(shares[-1], 80)
        self.assertTrue(any("left" in p for p in pictures), pictures)

    def test_rows(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = os.path.join(folder, "rows.txt")
            with open(rows, "w") as file:
                file.write("# load\n" + "".join(f"0.{k:05d}\n" for k in range(1, 2001)))
            for source in (["--rows", rows], ["load=0.0001:0.2:0.0001"]):
                pictures, shares = self.check_bar(["eval", "westergaard.half_width", *source, "--digits", "700", "--out", os.path.join(folder, "out.txt")], 2)
                self.assertGreaterEqual(len(set(shares)), 2, pictures)
            text = subprocess.run(["sh", "-c", f"cat {rows} | {PROGRAM} eval westergaard.half_width --rows - --digits 700 --out {folder}/out2.txt --progress-every 0.1"],
                                  capture_output=True, text=True).stderr
            self.assertRegex(text, r"touchstone: rows \d+, \d+ s so far")  # how many will come cannot be known
            self.assertNotIn("%", text)

    def test_a_printed_table(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = os.path.join(folder, "printed.txt")
            with open(rows, "w") as file:
                file.write("# load a\n" + "".join(f"0.{k:05d} 0.1\n" for k in range(1, 20001)))
            pictures, shares = self.check_bar(["check", rows, "--quantity", "westergaard.half_width", "--quiet"], 2)
            self.assertGreaterEqual(len(set(shares)), 2, pictures)

    @unittest.skipUnless(os.environ.get("TOUCHSTONE_SLOW"), "every change of every print, 20 s: TOUCHSTONE_SLOW=1")
    def test_the_typesetters_changes(self):
        pictures, shares = self.check_bar(["paper", "--mutate"], 20)
        self.assertGreater(shares[-1], 80)

    def test_a_table(self):
        with tempfile.TemporaryDirectory() as folder:
            pictures, shares = self.check_bar(["table", "westergaard_density", "--digits", "1500", "--out", folder], 2)
            self.assertGreaterEqual(len(set(shares)), 2, pictures)

    def test_logs(self):
        """Nothing where stderr is no terminal; whole lines with --progress-every."""
        silent = subprocess.run([PROGRAM, *VALUE], capture_output=True, text=True)
        self.assertEqual((silent.returncode, silent.stderr), (0, ""))
        logged = subprocess.run([PROGRAM, "--progress-every", "0.1", *SHORT], capture_output=True, text=True)
        lines = logged.stderr.splitlines()
        self.assertGreater(len(lines), 1)
        for line in lines:
            self.assertRegex(line, r"^touchstone: .*(\d %, .*(left|so far) \(\d+ of \d+\)|so far)")
        self.assertNotIn("\r", logged.stderr)
        once_a_minute = subprocess.run([PROGRAM, "--progress", *SHORT], capture_output=True, text=True)
        self.assertEqual(once_a_minute.stdout, logged.stdout)
        self.assertLessEqual(len(once_a_minute.stderr.splitlines()), 2)


if __name__ == "__main__":
    unittest.main()
