# SPDX-License-Identifier: GPL-3.0-or-later
"""Processes under a limit: seconds of user CPU, memory, what they printed; and what their numbers are worth."""
import math
import os
import re
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import threading
from collections import namedtuple
from time import monotonic

Run = namedtuple("Run", "seconds wall megabytes output error code stopped")


def run(command, text="", limit=60, environment=None):
    """`limit` is in seconds of CPU; ten times as much of the wall's clock ends a run too."""
    if not shutil.which(command[0]):
        return Run(0, 0, 0, "", "not built", 127, False)
    with tempfile.TemporaryFile("w+") as out, tempfile.TemporaryFile("w+") as error, tempfile.TemporaryFile("w+") as source:
        source.write(text)
        source.seek(0)
        start = monotonic()
        process = subprocess.Popen(command, stdin=source, stdout=out, stderr=error, env=dict(os.environ, **(environment or {})),
                                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(limit), math.ceil(limit) + 1)))
        timer = threading.Timer(10 * limit, process.kill)
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        error.seek(0)
        # a child begins as a copy of this process: what is not clearly larger than it says nothing of the child
        own = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        megabytes = usage.ru_maxrss / 1024 if usage.ru_maxrss > 1.1 * own else 0
        return Run(usage.ru_utime, monotonic() - start, megabytes, out.read(), error.read(), process.returncode, process.returncode < 0)


BUDGET = 10  # seconds of CPU after which a command is not run again
SHORT = 0.1  # seconds: below, a run is a mean of several, since the kernel counts CPU in ticks of some milliseconds
RUNS_OF_A_MEAN = 20


def repeated(command, text="", limit=60, environment=None):
    """Up to five runs, until the budget is used; the last run, and the seconds of all. Of short ones each of the five is a mean."""
    last = run(command, text, limit, environment)
    if last.stopped or last.code:
        return last, []
    several = RUNS_OF_A_MEAN if last.seconds < SHORT else 1
    seconds = [] if several > 1 else [last.seconds]
    while len(seconds) < 5 and sum(seconds) < BUDGET:
        of_mean = []
        for _ in range(several):
            last = run(command, text, limit, environment)
            if last.stopped or last.code:
                return last, seconds
            of_mean.append(last.seconds)
        seconds.append(statistics.mean(of_mean))
    return last, seconds


def row(tool, last, seconds, limit, **more):
    """What the page shows of it."""
    entry = {"tool": tool, **more}
    if last.stopped:
        return {**entry, "stopped": limit}
    if last.code:
        return {**entry, "refused": (last.error.strip().splitlines() or ["no answer"])[-1][:80]}
    return {**entry, **times(seconds), "megabytes": round(last.megabytes, 1)}


def times(seconds):
    """Median, least, largest, and how many."""
    return {"median": statistics.median(seconds), "least": min(seconds), "most": max(seconds), "runs": len(seconds)}


def right_digits(text, reference, digits):
    """How many significant digits agree with the reference (an mpf, or decimals with digits to spare); at most `digits`."""
    import mpmath
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)  # mpmath reads 10 000 digits as an integer
    with mpmath.workdps(digits + 20):
        found = re.search(r"-?[0-9.]+(?:\s?[eE][-+]?[0-9]+)?", text)
        if not found:
            return 0
        value, truth = mpmath.mpf(found.group(0).replace(" ", "")), mpmath.mpf(reference)
        if value == truth:
            return digits
        error = abs(value - truth) / abs(truth) if truth else abs(value)
        return max(0, min(digits, int(mpmath.floor(-mpmath.log10(error)))))


def exponent(xs, ys):
    """Of the power law that fits best."""
    pairs = [(math.log(x), math.log(y)) for x, y in zip(xs, ys) if y > 0]
    mean_x, mean_y = (statistics.fmean(p[i] for p in pairs) for i in (0, 1))
    return sum((x - mean_x) * (y - mean_y) for x, y in pairs) / sum((x - mean_x) ** 2 for x, y in pairs)
