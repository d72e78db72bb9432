#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Change a sign or a constant in our own proofs and formulas, one at a time, and see whether a test finds it.

usage: mutate_sources.py SOURCE SCRATCH [--count 8] [--seed 1] [--only PATH-PART] [--jobs 2] [--list]

SOURCE is copied to SCRATCH/source and built in SCRATCH/source/build/test (minutes, once; of the same depth as a checkout's, so that ccache knows the objects).
Then each change is made there, built and judged. A formula of paper/*.hpp first meets the tests that are compiled with it alone, as the whole
library would take minutes; a proof meets `touchstone paper` (verdicts, controls, corrections), then the tests of proofs. A change that does not
compile counts for nothing. What nobody finds is listed, unless tests/proofs/equivalent_changes.json says why it changes nothing; exit code 1 if
there is any. With --list the changes are only shown.
"""
import argparse
import json
import pathlib
import random
import os
import re
import shutil
import subprocess
import sys

WHERE = ["lib/touchstone/paper/*.hpp", "proofs/lemmas/*.cpp", "proofs/section_*.cpp", "proofs/sentences/*.cpp", "proofs/table_1.cpp", "proofs/symbolic/symbolic.cpp"]
HEADER_TESTS = ["test_formulas", "test_double_accuracy", "test_four_arithmetics"]  # their own objects are compiled with the formulas
TESTS = "^(formulas|ledger|errata|proof_kernel|table_1|mutation)$"
TARGETS = ["touchstone_program", "test_formulas", "test_ledger", "test_errata", "test_proof_kernel", "test_table_1", "test_mutation"]
PATTERNS = [(r" \+ ", " - "), (r" - ", " + "), (r" \* ", " / "), (r" / ", " * "), (r"(?<![\w.\"\[])([1-9])(?![\w.\"\]])", None)]
# What cannot change a proof: includes, loops, what is shown, precision and sizes of searches.
NO_PROOF = re.compile(r"^\s*(#|//|/\*|\*|using|for \(|constexpr (slong|int|long) (digits|bits)|const int pieces)|to_string|WorkingPrecision|std::next|substr|size\(\)")


def changes(source):
    """(file, line number, column, old, new) for each place in code, strings and comments left out."""
    for pattern in WHERE:
        for path in sorted(source.glob(pattern)):
            for number, line in enumerate(path.read_text().splitlines()):
                code = re.sub(r'"(\\.|[^"\\])*"', lambda m: '"' + "_" * (len(m.group()) - 2) + '"', line)
                code = code.split("//")[0]
                if NO_PROOF.search(line):
                    continue
                for old, new in PATTERNS:
                    for m in re.finditer(old, code):
                        by = new if new is not None else str(int(m.group(1)) + 1)
                        yield path.relative_to(source), number, m.start(), m.group(), by


def copy(source, target):
    ignore = shutil.ignore_patterns("build*", ".git", "out", "__pycache__")
    shutil.copytree(source, target, ignore=ignore, dirs_exist_ok=True)


def quiet(*words, **options):
    return subprocess.run(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, **options).returncode


def alone(build, program):
    """The commands that compile the objects of one test program and link it, without what it links: the library stays as it was."""
    lines = subprocess.run(["ninja", "-C", build, "-t", "commands", program], capture_output=True, text=True, check=True).stdout.splitlines()
    return [line for line in lines if f"CMakeFiles/{program}.dir/" in line]


def formula_is_found(build):
    """By the tests that are compiled with the formulas: their name, 'does not compile', or None."""
    for program in HEADER_TESTS:
        commands = alone(build, program)
        # what is made here is not what ninja makes: it must not be taken for that
        made = [build / name for command in commands for name in re.findall(r" -o (\S+)", command)]
        try:
            if any(quiet("sh", "-c", command, cwd=build) for command in commands):
                return "does not compile"
            failed = quiet(build / "tests" / program, timeout=600)
        finally:
            for file in made:
                file.unlink(missing_ok=True)
        if failed:
            return program
    return None


def found_by(build, jobs, path=None):
    """Who finds it: 'does not compile', the program, a test, or nobody."""
    try:
        if path is not None and path.suffix == ".hpp" and (who := formula_is_found(build)) is not None:
            return who
        if quiet("cmake", "--build", build, f"-j{jobs}", "--target", "touchstone_program"):
            return "does not compile"
        if quiet(build / "touchstone", "paper", timeout=300):
            return "touchstone paper"
        if quiet("cmake", "--build", build, f"-j{jobs}", "--target", *TARGETS):
            return "does not compile"
        if quiet("ctest", "--test-dir", build, "-R", TESTS, timeout=3600):
            return "a test"
    except subprocess.TimeoutExpired:
        return "a test that does not end"
    return None


def excuse(source, path, line, old, new):
    """Why a change that nobody finds changes nothing that is proved, or None."""
    for e in json.loads((source / "tests/proofs/equivalent_changes.json").read_text()):
        if e["file"] == str(path) and e["line"] in line and (e["change"] == f"{old.strip()} -> {new.strip()}" or e["change"] == "any"):
            return e["reason"]
    return None


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("source", type=pathlib.Path)
    arguments.add_argument("scratch", type=pathlib.Path)
    arguments.add_argument("--count", type=int, default=8)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--only", default="")
    arguments.add_argument("--jobs", type=int, default=2)
    arguments.add_argument("--list", action="store_true")
    o = arguments.parse_args()
    everything = [c for c in changes(o.source) if o.only in str(c[0])]
    some = random.Random(o.seed).sample(everything, min(o.count, len(everything)))
    if o.list:
        for path, number, column, old, new in some:
            print(f"{path}:{number + 1}:{column + 1}: '{old}' -> '{new}'")
        print(f"{len(some)} of {len(everything)} changes, seed {o.seed}")
        return 0
    tree, build = o.scratch / "source", o.scratch / "source/build/test"
    copy(o.source, tree)
    if quiet("cmake", "-S", tree, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DTOUCHSTONE_TESTS=ON"):
        sys.exit("cannot configure " + str(build))
    if quiet("cmake", "--build", build, f"-j{o.jobs}", "--target", *TARGETS, *HEADER_TESTS):
        sys.exit("cannot build " + str(build))
    if (who := found_by(build, o.jobs)) is not None:
        sys.exit(f"without any change it fails already: {who}")
    survivors, compiled, excused = [], 0, 0
    for path, number, column, old, new in some:
        file = tree / path
        right, times = file.read_text(), file.stat()
        lines = right.splitlines(keepends=True)
        line = lines[number]
        lines[number] = line[:column] + new + line[column + len(old):]
        file.write_text("".join(lines))
        who = found_by(build, o.jobs, path)
        file.write_text(right)
        if who in HEADER_TESTS:  # nothing else was built with the change
            os.utime(file, ns=(times.st_atime_ns, times.st_mtime_ns))
        compiled += who != "does not compile"
        what = f"{path}:{number + 1}:{column + 1}: '{old}' -> '{new}'"
        why = excuse(o.source, path, line, old, new) if who is None else None
        print(f"{'found   ' if who else 'excused ' if why else 'SURVIVES'}  {what}  {who or why or line.strip()}", flush=True)
        excused += why is not None
        if who is None and why is None:
            survivors.append(what)
    print(f"{len(some)} of {len(everything)} changes, seed {o.seed}: {compiled} compile, {compiled - excused - len(survivors)} found, {excused} excused, {len(survivors)} survive")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
