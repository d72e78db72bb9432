#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The same bytes from every build, on any number of threads and cores, under any locale.

usage: same_bytes.py SOURCE PROGRAM [OTHER...] [--only WORD] [--builds-alone]

Each command of same_bytes.txt is run by PROGRAM as it comes; then with 1, 2 and 16 threads, on one core alone, and under other locales, time zones
and folders; then by each OTHER, a program of another compiler or other optimisation. An OTHER that is a library (lib*.so*) is called through its C
interface, for the values of those commands that ask for one; so is the C interface of another machine or system, by a script value*.sh that runs
value.c there. Standard output and exit code have to be the same. Exit code 1 names what differs.
With --builds-alone PROGRAM is not held against itself, only against each OTHER; another machine's program is given by a script that runs it.
"""
import argparse
import ctypes
import difflib
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

LOCALES = ("de_DE", "tr_TR", "hi_IN", "fa_IR")  # decimal comma; i without a dot; groups of two digits; other digits
LONGEST = 3600


def run(program, words, source, env=None, before=(), cwd=None):
    done = subprocess.run([*before, program, *words], capture_output=True, stdin=subprocess.DEVNULL, timeout=LONGEST, cwd=cwd or source, env=dict(os.environ, **(env or {})))
    return done.returncode, done.stdout


def made_locales(folder):
    """Locales of our own making where the sources of the C library's are installed (Debian: locales)."""
    names = ["C", "C.UTF-8", "POSIX"]
    for name in LOCALES:
        if shutil.which("localedef") and subprocess.run(["localedef", "-i", name, "-f", "UTF-8", f"{folder}/{name}.UTF-8"], capture_output=True).returncode == 0:
            names.append(f"{name}.UTF-8")
    return names


class Library:
    def __init__(self, path):
        self.path, self.library = path, ctypes.CDLL(str(path))
        self.library.touchstone_eval.argtypes = [ctypes.c_char_p, ctypes.c_char_p, ctypes.c_long, ctypes.c_char_p, ctypes.POINTER(ctypes.c_void_p), ctypes.c_char_p, ctypes.c_size_t]
        self.library.touchstone_free.argtypes = [ctypes.c_void_p]
        for name in ("touchstone_decimal", "touchstone_error"):
            getattr(self.library, name).argtypes, getattr(self.library, name).restype = [ctypes.c_void_p], ctypes.c_char_p

    def asked(self, quantity, inputs, digits, how):
        v = ctypes.c_void_p()
        self.library.touchstone_eval(quantity.encode(), inputs.encode(), int(digits), how.encode(), ctypes.byref(v), None, 0)
        text = f"{self.library.touchstone_decimal(v).decode()} {self.library.touchstone_error(v).decode()}"
        self.library.touchstone_free(v)
        return text

    def value(self, words):
        """VALUE and ERROR as `eval` has them in --json; None where the command asks for something else."""
        digits = words[words.index("--digits") + 1] if "--digits" in words else "20"
        how = words[words.index("--round") + 1] if "--round" in words else "nearest"
        inputs = [w for w in words[2:] if "=" in w]
        if words[0] != "eval" or any(c in w for w in inputs for c in ",:"):
            return None
        return self.asked(words[1], " ".join(inputs), digits, how)


class Elsewhere(Library):
    """The same by a script that runs value.c."""

    def __init__(self, path):
        self.path = path

    def asked(self, *words):
        return subprocess.run([self.path, *words], capture_output=True, text=True, timeout=LONGEST).stdout.strip()


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("source", type=lambda p: pathlib.Path(p).resolve())
    arguments.add_argument("program", type=lambda p: pathlib.Path(p).resolve())
    arguments.add_argument("others", nargs="*", type=lambda p: pathlib.Path(p).resolve())
    arguments.add_argument("--only", default="")
    arguments.add_argument("--builds-alone", action="store_true")
    o = arguments.parse_args()
    lines = (o.source / "tests/cli/same_bytes.txt").read_text().splitlines()
    commands = [shlex.split(line) for line in lines if line and not line.startswith("#") and o.only in line]
    libraries = [Library(p) for p in o.others if p.name.startswith("lib")] + [Elsewhere(p) for p in o.others if p.name.startswith("value")]
    programs = [p for p in o.others if not p.name.startswith(("lib", "value"))]
    compared, wrong = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        locales = [] if o.builds_alone else made_locales(folder)
        for words in commands:
            code, right = run(o.program, words, o.source)
            if code or not right:
                sys.exit(f"{shlex.join(words)} has exit code {code}: no command to compare by")
            variants = [] if o.builds_alone else [(f"LC_ALL={name}", o.program, words, {"LC_ALL": name, "LANG": name, "LOCPATH": folder}, ()) for name in locales]
            if not o.builds_alone:
                variants.append(("TZ, COLUMNS, TERM", o.program, words, {"TZ": "Asia/Kathmandu", "COLUMNS": "7", "TERM": "dumb"}, ()))
            if shutil.which("taskset") and not o.builds_alone:
                variants.append(("one core", o.program, words, {}, ("taskset", "-c", "0")))
            if words[0] in ("table", "eval") and not o.builds_alone:
                variants += [(f"--jobs {jobs}", o.program, [*words, "--jobs", jobs], {}, ()) for jobs in ("1", "2", "16") if words[0] == "table" or any(":" in w or "," in w for w in words[2:])]
            variants += [(str(p), p, words, {}, ()) for p in programs]
            for how, program, said, env, before in variants:
                other_code, other = run(program, said, o.source, env, before)
                compared += 1
                if (other_code, other) != (code, right):
                    wrong += 1
                    print(f"DIFFERS  {shlex.join(said)}  ({how}): exit code {code} and {other_code}")
                    print("\n".join(list(difflib.unified_diff(right.decode().splitlines(), other.decode(errors="replace").splitlines(), lineterm="", n=0))[:8]), flush=True)
            for library in libraries:
                text = library.value(words)
                if text is not None:
                    compared += 1
                    j = json.loads(run(o.program, [*[w for w in words if w != "--json"], "--json"], o.source)[1])
                    if text != f"{j['value']} {j['error']}":
                        wrong += 1
                        print(f"DIFFERS  {shlex.join(words)}  ({library.path}): {j['value']} {j['error']} and {text}", flush=True)
    print(f"{len(commands)} commands; locales {', '.join(locales) or 'left out'}; {len(programs)} other programs, {len(libraries)} libraries: {compared} outputs compared, {wrong} differ")
    return 1 if wrong or not compared else 0


if __name__ == "__main__":
    sys.exit(main())
