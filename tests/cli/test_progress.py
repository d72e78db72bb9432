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
# What takes seconds on one machine is over on another before the first picture is due: work is given with sizes, and grows until it lasts.
VALUE = [["eval", "contact.exceedance", "n=5", "p=1/100", "load=1/100", "G=3", "--digits", d] for d in ("8", "10", "11", "12")]
AREA = [["eval", "contact.area", "n=2", "load=7/20", "G=3/2", "--digits", d] for d in ("20", "60", "90", "120", "150")]
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
    def check_bar(self, sizes, least):
        """The pictures and shares of the first of these works, from small to large, that lasts for `least` pictures."""
        for arguments in sizes:
            text = on_a_terminal(arguments)
            pictures = [p for p in text.split("\r\033[K") if p]
            if len(pictures) >= least:
                break
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
            files = []
            for count in (2000, 20000, 200000):
                files.append(os.path.join(folder, f"rows_{count}.txt"))
                with open(files[-1], "w") as file:
                    file.write("# x load\n" + "".join(f"0.{k:06d} 0.3\n" for k in range(200000, 200000 + count)))
            for works in ([["westergaard.gap", "--rows", rows] for rows in files],
                          [["westergaard_gap", "--held-out", count] for count in ("1500", "15000", "150000")]):
                pictures, shares = self.check_bar([["judge", *work, *SUBJECT] for work in works], 1)
                self.assertTrue(shares, pictures)

    def test_one_value(self):
        pictures, shares = self.check_bar(VALUE, 3)
        self.assertTrue(shares, pictures)

    def test_an_integral(self):
        integral = ["integrate", "log(1/x)/sqrt(x)/(1+x^2)", "0", "1", "--digits"]
        pictures, shares = self.check_bar([[*integral, digits] for digits in ("1500", "3000", "6000")], 2)
        self.assertTrue(any(" values " in p or p.startswith("[") for p in pictures), pictures)
        self.assertTrue(shares, pictures)

    @unittest.skipUnless(os.environ.get("TOUCHSTONE_SLOW"), "the whole ledger, half a minute: TOUCHSTONE_SLOW=1")
    def test_the_ledger(self):
        pictures, shares = self.check_bar([LEDGER], 20)
        self.assertGreater(shares[-1], 80)
        self.assertTrue(any("left" in p for p in pictures), pictures)

    def test_rows(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = os.path.join(folder, "rows.txt")
            with open(rows, "w") as file:
                file.write("# load\n" + "".join(f"0.{k:05d}\n" for k in range(1, 2001)))
            for source in (["--rows", rows], ["load=0.0001:0.2:0.0001"]):
                work = ["eval", "westergaard.half_width", *source, "--out", os.path.join(folder, "out.txt"), "--digits"]
                pictures, shares = self.check_bar([[*work, digits] for digits in ("700", "3000", "10000")], 2)
                self.assertGreaterEqual(len(set(shares)), 2, pictures)
            text = subprocess.run(["sh", "-c", f"cat {rows} | {PROGRAM} eval westergaard.half_width --rows - --digits 700 --out {folder}/out2.txt --progress-every 0.1"],
                                  capture_output=True, text=True).stderr
            self.assertRegex(text, r"touchstone: rows \d+, \d+ s so far")  # how many will come cannot be known
            self.assertNotIn("%", text)

    def test_a_printed_table(self):
        with tempfile.TemporaryDirectory() as folder:
            works = []
            for count in (20000, 200000, 900000):
                rows = os.path.join(folder, f"printed_{count}.txt")
                with open(rows, "w") as file:
                    file.write("# load a\n" + "".join(f"0.{k:06d} 0.1\n" for k in range(1, count + 1)))
                works.append(["check", rows, "--quantity", "westergaard.half_width", "--quiet"])
            pictures, shares = self.check_bar(works, 2)
            self.assertGreaterEqual(len(set(shares)), 2, pictures)

    @unittest.skipUnless(os.environ.get("TOUCHSTONE_SLOW"), "every change of every print, 20 s: TOUCHSTONE_SLOW=1")
    def test_the_typesetters_changes(self):
        pictures, shares = self.check_bar([["paper", "--mutate"]], 20)
        self.assertGreater(shares[-1], 80)

    def test_a_table(self):
        with tempfile.TemporaryDirectory() as folder:
            work = ["table", "westergaard_density", "--out", folder, "--digits"]
            pictures, shares = self.check_bar([[*work, digits] for digits in ("1500", "6000", "10000")], 2)
            self.assertGreaterEqual(len(set(shares)), 2, pictures)

    def test_logs(self):
        """Nothing where stderr is no terminal; whole lines with --progress-every."""
        silent = subprocess.run([PROGRAM, *VALUE[0]], capture_output=True, text=True)
        self.assertEqual((silent.returncode, silent.stderr), (0, ""))
        for work in AREA:
            logged = subprocess.run([PROGRAM, "--progress-every", "0.1", *work], capture_output=True, text=True)
            lines = logged.stderr.splitlines()
            if len(lines) > 1:
                break
        self.assertGreater(len(lines), 1)
        for line in lines:
            self.assertRegex(line, r"^touchstone: .*(\d %, .*(left|so far) \(\d+ of \d+\)|so far)")
        self.assertNotIn("\r", logged.stderr)
        once_a_minute = subprocess.run([PROGRAM, "--progress", *work], capture_output=True, text=True)
        self.assertEqual(once_a_minute.stdout, logged.stdout)
        self.assertLessEqual(len(once_a_minute.stderr.splitlines()), 2)


if __name__ == "__main__":
    unittest.main()
