#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""touchstone judge from outside: subjects in every language, each mix-up, each way to break the protocol.

usage: test_judge.py --touchstone PROGRAM --subjects FOLDER --library LIB [--fortran PROGRAM --read-table PROGRAM]
"""
import argparse
import contextlib
import itertools
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock
import xml.etree.ElementTree

arguments = argparse.ArgumentParser()
arguments.add_argument("--touchstone", required=True)
arguments.add_argument("--subjects", required=True)
arguments.add_argument("--library", required=True)
arguments.add_argument("--fortran")
arguments.add_argument("--read-table")
options, sys.argv[1:] = arguments.parse_known_args()
SOURCE = pathlib.Path(__file__).resolve().parents[2] / "verify" / "subjects"


def subject(name):
    return os.path.join(options.subjects, "subject_" + name)


def run(*words):
    return subprocess.run([options.touchstone, "judge", *map(str, words)], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=100)


def judge(table, *words):
    """(exit code, JSON)"""
    r = run(table, "--json", "--seed", "7", *words)
    return r.returncode, json.loads(r.stdout), r.stderr


class Languages(unittest.TestCase):
    def passes(self, *words, bound=4):
        code, j, err = judge(*words)
        self.assertEqual((code, j["verdict"], err), (0, "pass", ""), j)
        self.assertLessEqual(j["ulps"][0], j["ulps"][1])
        return j

    def test_python(self):
        self.passes("westergaard_half_width", "--", sys.executable, SOURCE / "script.py")

    def test_fortran(self):
        if not options.fortran:
            self.skipTest("no Fortran compiler")
        self.passes("westergaard_half_width", "--", options.fortran)

    def test_c_library(self):
        self.passes("westergaard_half_width", "--library", options.library, "--symbol", "half_width")

    def test_gsl(self):
        self.assertEqual(judge("archard_delta", "--", subject("library_forms"), "archard.delta")[0], 0)
        code, j, _ = judge("westergaard_mean_gap", "--", subject("gsl"), "westergaard.mean_gap")
        self.assertEqual(code, 1, j)  # 1 - S + S log S cancels towards full contact
        self.assertGreater(j["ulps"][0], 1e9)

    def test_octave_style_answers(self):
        sys.path.insert(0, str(SOURCE.parents[1] / "lib" / "touchstone" / "client"))
        sys.dont_write_bytecode = True
        import math
        import touchstone_reference as ref

        with tempfile.TemporaryDirectory() as folder:
            table = os.path.join(folder, "westergaard_half_width.txt")
            with open(table, "wb") as f:
                f.write(subprocess.run([options.touchstone, "table", "westergaard_half_width"], capture_output=True, check=True).stdout)
            answers = os.path.join(folder, "answers.txt")
            octave = shutil.which("octave-cli")
            if octave:
                subprocess.run([octave, str(SOURCE / "answers.m"), table, answers], check=True)
            else:
                print("octave-cli is not installed: its file of answers is written by hand", file=sys.stderr)
                with open(answers, "w") as f:
                    f.write("# Created by Octave 7.3.0\n# name: answers\n# type: matrix\n# rows: 1\n# columns: 1\n")
                    for row in ref.load(table).rows:
                        f.write(f" {math.atan2(math.sqrt(row.inputs[0]), math.sqrt(1 - row.inputs[0])) / math.pi!r}\n")
                    f.write("\n\n")
            j = self.passes(table, "--answers", answers)
            self.assertEqual(j["held_out"]["rows"], 0)
            with open(answers, "a") as f:
                f.write("0.5\n")
            self.assertEqual(judge(table, "--answers", answers)[1]["fault"]["kind"], "too_many")
            self.assertEqual(run(table, "--answers", answers + ".missing").returncode, 66)


class DigitsLost(unittest.TestCase):
    """(a) the printed formulas lose digits at the edges, (b) the library's own forms do not."""

    def test_printed_and_library_forms(self):
        for quantity in ("westergaard.exceedance", "westergaard.pressure", "westergaard.mean_gap", "westergaard.gap"):
            with self.subTest(quantity):
                table = quantity.replace(".", "_")
                code, j, _ = judge(table, "--", subject("printed_formulas"), quantity)
                self.assertEqual(code, 1, j["verdict"])
                self.assertGreater(j["ulps"][0], 1e6)
                self.assertIsNone(j["mixup"])  # digits lost are no convention
                code, j, _ = judge(table, "--", subject("library_forms"), quantity)
                self.assertEqual((code, j["failed"]), (0, 0), j["worst"][:1])


class MixUps(unittest.TestCase):
    CASES = [
        ("factor-pi", "hertz.pressure", "factor pi"),
        ("factor-2", "westergaard.pressure", "peak-to-valley"),
        ("full-width", "westergaard.half_width", "full width for half width"),
        ("phase", "westergaard.pressure", "lambda"),
        ("mean-pressure-unit", "westergaard.pressure", "mean pressure"),
        ("p-in-mean-pressure", "westergaard.exceedance", "mean pressure"),
        ("peak-to-valley", "westergaard.pressure", "load taken times 1/2"),
        ("E-for-plane-strain", "westergaard.pressure", "nu = 0.3"),
        ("unlisted-nu", "westergaard.pressure", "nu = 0.27"),
        ("valley-origin", "westergaard.pressure", "valley"),
        ("sign", "westergaard.pressure", "sign"),
        ("hertz", "westergaard.half_width", "Hertzian"),
        ("printed-7.17", "archard.K", "(7.17)"),
        ("printed-9.4", "segments.max_half_width", "(9.4)"),
    ]

    def test_each_is_named(self):
        for name, quantity, expected in self.CASES:
            with self.subTest(name):
                code, j, _ = judge(quantity.replace(".", "_"), "--", subject("broken"), "mixup", name, quantity)
                self.assertEqual(code, 1)
                self.assertIsNotNone(j["mixup"], j)
                self.assertIn(expected, j["mixup"]["name"])
                self.assertGreaterEqual(j["mixup"]["explains"], 0.9)

    def test_none_is_said_where_none_explains(self):
        code, j, _ = judge("westergaard_half_width", "--", subject("broken"), "mixup", "none", "westergaard.half_width")
        self.assertEqual((code, j["verdict"], j["mixup"]), (1, "fail", None))


class Protocol(unittest.TestCase):
    LIMITS = ("--start-limit", "0.8", "--row-limit", "0.3", "--time-limit", "1.2", "--held-out", "4")
    WIDE_LIMITS = ("--start-limit", "8", "--row-limit", "4", "--time-limit", "12", "--held-out", "4")
    FAULTS = {
        "segfault": ("killed", "signal 11"), "abort": ("killed", "signal 6"), "crash-at-exit": ("killed", "signal 8"),
        "exit-3": ("exit_status", "status 3"), "hang": ("hang", "silent"), "ignore-term": ("hang", "silent"),
        "silent-start": ("hang", "of its start"), "trickle": ("hang", "limit in all"), "too-few": ("too_few", "20 of"),
        "too-many": ("too_many", "more answers"), "garbage": ("garbage", "apples"), "binary": ("garbage", "\\x01"),
        "two-numbers": ("garbage", "0x"), "endless-line": ("endless_line", "without a line end"),
        "close-input": ("too_few", "0 of"), "child-holds-pipe": ("hang", "start"),
    }

    def fault(self, *words, limits=LIMITS):
        start = time.monotonic()
        # A folder of its own: other tests that run meanwhile leave and take away theirs in the common one.
        # What kills the judged code is to kill it, though a sanitizer would rather report it and exit.
        with tempfile.TemporaryDirectory() as own, unittest.mock.patch.dict(os.environ, TMPDIR=own, TSAN_OPTIONS="handle_segv=0:handle_sigfpe=0"):
            code, j, err = judge("westergaard_half_width", *limits, *words)
            self.assertEqual(os.listdir(own), [])
        self.assertLess(time.monotonic() - start, 30)  # a hang, not a busy machine
        self.assertEqual((code, j["verdict"]), (69, "protocol"))
        self.assertEqual(err.count("\n"), 1, err)
        self.assertTrue(err.startswith("touchstone: "))
        return j["fault"]

    def test_each_fault_is_reported_as_what_it_is(self):
        for name, (kind, detail) in self.FAULTS.items():
            with self.subTest(name):
                fault = self.fault("--", subject("broken"), "fault", name)
                if name == "close-input":  # whether the pipe took all rows first is a race
                    self.assertIn(fault["kind"], ("too_few", "closed_input"))
                    continue
                self.assertEqual(fault["kind"], kind, fault)
                self.assertIn(detail, fault["detail"])

    def test_no_process_is_left(self):
        self.fault("--", subject("broken"), "fault", "child-holds-pipe")
        deadline = time.monotonic() + 2
        while time.monotonic() < deadline:
            left = [p for p in pathlib.Path("/proc").glob("[0-9]*/cmdline") if b"child-holds-pipe" in self.bytes_of(p)]
            if not left:
                return
            time.sleep(0.05)
        self.fail(f"still running: {left}")

    @staticmethod
    def bytes_of(path):
        try:
            return path.read_bytes() if str(os.getpid()) not in str(path) else b""
        except OSError:
            return b""

    def test_no_file_of_others_is_left_open(self):
        """What whoever started the judge had open is none of the judged code's business."""
        with open("/etc/hostname") as secret:
            os.set_inheritable(secret.fileno(), True)
            script = "import os, sys; assert len(os.listdir('/proc/self/fd')) == 4; exec(open(sys.argv[1]).read())"  # the fourth is the folder's
            words = ("judge", "westergaard_half_width", "--json")
            r = subprocess.run([options.touchstone, *words, "--", sys.executable, "-c", script, SOURCE / "script.py"], capture_output=True, text=True, pass_fds=[secret.fileno()])
            self.assertEqual(r.returncode, 0, r.stdout)
            r = subprocess.run([options.touchstone, *words, "--library", options.library, "--symbol", "open_files"], capture_output=True, text=True, pass_fds=[secret.fileno()])
            self.assertEqual(r.returncode, 0, r.stdout)

    def test_memory_has_a_limit(self):
        limits = ("--start-limit", "30", "--time-limit", "40", "--held-out", "4")
        hog = "b = bytearray(700 << 20); import time; time.sleep(1000)"
        for script in (hog, f"import os, time; pid = os.fork()\nif pid == 0:\n  {hog}\ntime.sleep(1000)"):
            start = time.monotonic()
            code, j, err = judge("westergaard_half_width", *limits, "--memory-limit", "0.5", "--", sys.executable, "-c", script)
            self.assertEqual((code, j["fault"]["kind"]), (69, "memory"), j)
            self.assertIn("(the limit is 0.5)", err)
            self.assertLess(time.monotonic() - start, 25)
        # memory that is reserved and not held is not counted
        reserves = "import mmap, sys\nm = mmap.mmap(-1, 4 << 30)\nexec(open(sys.argv[1]).read())"
        code, j, err = judge("westergaard_half_width", *limits, "--memory-limit", "0.5", "--", sys.executable, "-c", reserves, SOURCE / "script.py")
        self.assertEqual((code, err), (0, ""), j)
        self.assertEqual(run("westergaard_half_width", "--memory-limit", "0", "--", "cat").returncode, 64)

    def test_what_is_no_fault(self):
        for name in ("slow-start", "chatter"):
            code, j, err = judge("westergaard_half_width", *self.LIMITS, "--", subject("broken"), "fault", name)
            self.assertEqual((code, err), (0, ""), j)
        self.assertIn("thank you", j["stderr"])

    def test_not_started(self):
        self.assertEqual(self.fault("--", "./no-such-program")["kind"], "not_started")
        self.assertEqual(self.fault("--", "/")["kind"], "not_started")
        self.assertEqual(self.fault("--library", "/no/such.so", "--symbol", "f")["kind"], "not_started")
        self.assertIn("nowhere", self.fault("--library", options.library, "--symbol", "nowhere")["detail"])

    def test_libraries_misbehave_too(self):
        self.assertEqual(self.fault("--library", options.library, "--symbol", "crashes")["kind"], "killed")
        # which takes its time where a sanitizer looks for leaks first
        ends = self.fault("--library", options.library, "--symbol", "ends", limits=self.WIDE_LIMITS)
        self.assertEqual(ends["kind"], "too_few")
        code, j, _ = judge("westergaard_half_width", "--library", options.library, "--symbol", "prints")
        self.assertEqual(code, 0, j)


class LeftBehind(unittest.TestCase):
    """A code that leaves its session and its parents is ended with all the others, and nobody else is."""
    LIMITS = ("--start-limit", "20", "--row-limit", "1.5", "--time-limit", "20", "--held-out", "4")
    marks = itertools.count()

    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.renew_mark()

    def tearDown(self):
        self.end_those_left()
        self.scratch.cleanup()

    def renew_mark(self):
        self.mark = f"{self.scratch.name}/left-{next(self.marks)}"

    def end_those_left(self):
        for process in self.living():
            with contextlib.suppress(ProcessLookupError):
                os.kill(process, signal.SIGKILL)

    def words(self, name):
        return ("judge", "westergaard_half_width", "--json", "--seed", "7", *self.LIMITS, "--memory-limit", "0.5", "--", subject("broken"), "fault", name, self.mark)

    def living(self):
        found = []
        for p in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                if self.mark.encode() in (p / "cmdline").read_bytes() and int(p.name) != os.getpid() and "\nState:\tZ" not in (p / "status").read_text():
                    found.append(int(p.name))
            except OSError:
                pass
        return found

    def judged(self, name):
        self.end_those_left()  # what another one has left is no fault of this
        self.renew_mark()
        start = time.monotonic()
        r = subprocess.run([options.touchstone, *self.words(name)], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=100)
        self.assertEqual(self.living(), [], name)
        return r, time.monotonic() - start

    def test_its_daemons_end_with_it(self):
        for name in ("daemon-sleeps", "daemon-writes", "many-flee"):
            with self.subTest(name):
                r, seconds = self.judged(name)
                self.assertEqual((r.returncode, r.stderr), (0, ""), r.stdout)
                self.assertLess(seconds, 15)  # and nobody waits for the pipe that they hold open
        trace = pathlib.Path(self.mark)  # of those that flee, which no look into /proc meets
        steps = trace.stat().st_size
        self.assertGreater(steps, 0)
        time.sleep(0.5)
        self.assertEqual(trace.stat().st_size, steps)
        for name, kind in (("daemon-and-hang", "hang"), ("daemon-and-crash", "killed")):
            with self.subTest(name):
                r, seconds = self.judged(name)
                self.assertEqual((r.returncode, json.loads(r.stdout)["fault"]["kind"]), (69, kind))
                self.assertLess(seconds, 15)

    def test_memory_of_daemons_counts(self):
        r, _ = self.judged("daemon-holds-memory")
        self.assertEqual((r.returncode, json.loads(r.stdout)["fault"]["kind"]), (69, "memory"))

    def test_its_supervisor_is_no_way_out(self):
        for name, kind in (("ends-its-supervisor", "killed"), ("stops-its-supervisor", "hang")):
            with self.subTest(name):
                r, seconds = self.judged(name)
                self.assertEqual((r.returncode, json.loads(r.stdout)["fault"]["kind"]), (69, kind), r.stderr)
                self.assertLess(seconds, 10)  # not only once its judge has lost patience

    def test_the_judge_is_ended(self):
        """By whatever signal: what it was judging goes with it."""
        for end in (signal.SIGKILL, signal.SIGTERM, signal.SIGINT):
            with self.subTest(end):
                process = subprocess.Popen([options.touchstone, *self.words("daemon-at-silent-start")], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                deadline = time.monotonic() + 20
                while len(self.living()) < 4 and time.monotonic() < deadline:  # the judge, its supervisor, the code, its daemon
                    time.sleep(0.02)
                self.assertGreaterEqual(len(self.living()), 3)
                process.send_signal(end)
                self.assertEqual(process.wait(20), -end)
                while self.living() and time.monotonic() < deadline:
                    time.sleep(0.02)
                self.assertEqual(self.living(), [])

    def test_children_of_others_live_on(self):
        """A shell becomes the judge, and its children the judge's: they are nobody's but their own."""
        script = 'sleep 100 >/dev/null 2>&1 & echo $! >&2; exec "$@" 2>/dev/null'
        r = subprocess.run(["sh", "-c", script, "sh", options.touchstone, *self.words("daemon-sleeps")], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, stdin=subprocess.DEVNULL, timeout=100)
        sleeper = int(r.stderr)
        try:
            self.assertEqual(r.returncode, 0, r.stdout)
            os.kill(sleeper, 0)
            self.assertIn("sleep", pathlib.Path(f"/proc/{sleeper}/cmdline").read_text())
        finally:
            os.kill(sleeper, signal.SIGKILL)


class Output(unittest.TestCase):
    def test_summary_junit_svg_and_replay(self):
        with tempfile.TemporaryDirectory() as folder:
            junit, svg = os.path.join(folder, "r.xml"), os.path.join(folder, "r.svg")
            r = run("westergaard_pressure", "--junit", junit, "--svg", svg, "--", subject("broken"), "mixup", "factor-2", "westergaard.pressure")
            self.assertEqual(r.returncode, 1)
            self.assertTrue(r.stdout.startswith("FAIL: "))
            self.assertLess(len(r.stdout.splitlines()), 40)
            suite = xml.etree.ElementTree.parse(junit).getroot().find("testsuite")
            self.assertEqual(int(suite.get("tests")), len(suite.findall("testcase")))
            self.assertEqual(int(suite.get("failures")), len(suite.findall("testcase/failure")))
            self.assertGreater(int(suite.get("failures")), 100)
            self.assertGreater(len(list(xml.etree.ElementTree.parse(svg).iter())), 100)
            self.assertEqual(sorted(os.listdir(folder)), ["r.svg", "r.xml"])
            _, j, _ = judge("westergaard_pressure", "--", subject("broken"), "mixup", "factor-2", "westergaard.pressure")
            worst = j["worst"][0]
            again = subprocess.run([subject("broken"), "mixup", "factor-2", "westergaard.pressure"], input=" ".join(worst["inputs"]) + "\n",
                                   capture_output=True, text=True, check=True)
            self.assertEqual(float.fromhex(again.stdout), float.fromhex(worst["answer"]))
            self.assertEqual(run("westergaard_pressure", "--junit", "/no/such/folder/r.xml", "--", subject("library_forms"), "westergaard.pressure").returncode, 73)

    def test_the_seed_decides_the_held_out_rows(self):
        command = ("westergaard_half_width", "--json", "--held-out", "5", "--", sys.executable, str(SOURCE / "script.py"))
        same = [run(*command[:2], "--seed", "3", *command[2:]).stdout for _ in range(2)]
        self.assertEqual(same[0], same[1])
        self.assertNotEqual(same[0], run(*command[:2], "--seed", "4", *command[2:]).stdout)

    def test_usage(self):
        for code, words in ((64, ("westergaard_half_width",)), (64, ("no_such_table", "--", "true")), (64, ("westergaard_half_width", "--library", "l.so")),
                            (64, ("westergaard_half_width", "--ulps", "-1", "--", "true")), (64, ("westergaard_half_width", "--ulps", "inf", "--", "true")),
                            (64, ("westergaard_half_width", "--update-baseline", "--", "true")), (66, ("./none.txt", "--", "true"))):
            r = run(*words)
            self.assertEqual((r.returncode, r.stderr.count("\n"), r.stdout), (code, 1, ""), (words, r.stderr))


if __name__ == "__main__":
    unittest.main(verbosity=2)
