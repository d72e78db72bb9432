#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every parser under libFuzzer, with the address and undefined behaviour sanitizers.

usage: campaign.py SOURCE BUILD SCRATCH [--runs 10000000] [--seconds S] [--only NAME] [--jobs 1] [--merge]

The parsers and the targets are compiled by clang with coverage and sanitizers; all else is linked from BUILD, a build of SOURCE with its tests by
any compiler (the ledger's parser too, which clang 14 cannot compile: its texts are changed blindly). Each target starts from its corpus and from what earlier campaigns left in SCRATCH, and makes RUNS executions, or as many as S
seconds allow. What ends a parser, or takes it longer than 10 s or 1 GB, is kept in SCRATCH/NAME.finds and printed; exit code 1 if there is any.
--merge writes the smallest texts that cover what the corpus and SCRATCH cover back into the corpus.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

PARSERS = ["scalar/rational.cpp", "scalar/exact.cpp", "scalar/exact_text.cpp", "catalogue/named_inputs.cpp", "catalogue/quantity.cpp",
           "table/rows.cpp", "table/ranges.cpp", "table/own_table.cpp", "table/shard.cpp", "table/format.cpp", "oracle/baseline.cpp",
           "oracle/printed.cpp", "oracle/subject.cpp", "quadrature/expression.cpp", "quadrature/expression_tree.cpp"]
SANITIZERS = ["-fsanitize=address,undefined", "-fno-sanitize=vptr", "-fno-sanitize-recover=all", "-O1", "-g1", "-fno-omit-frame-pointer"]
NAMES = re.compile(r'\{"(\w+)", \w+\}')


def words_of(build, target, pattern):
    lines = subprocess.run(["ninja", "-C", build, "-t", "commands", target], capture_output=True, text=True, check=True).stdout.splitlines()
    return shlex.split(next(line for line in lines if re.search(pattern, line)).replace("&& :", "").replace(": &&", ""))


def build_all(o, names):
    commands = words_of(o.build, "test_parsers", "table/format.cpp$") + words_of(o.build, "test_parsers", "replay.cpp$")
    flags = list(dict.fromkeys(w for w in commands if w.startswith(("-I", "-D", "-std"))))
    link = words_of(o.build, "test_parsers", " -o tests/fuzz/test_parsers")
    libraries = [w for w in link[link.index("-o") + 2:] if not w.endswith(".o")]  # the ledgers' target with them
    lib = o.source / "lib/touchstone"
    here = o.source / "tests/fuzz"
    sources = [lib / p for p in PARSERS] + [here / f for f in ("numbers.cpp", "files.cpp", "expressions.cpp")]
    objects = o.scratch / "objects"
    objects.mkdir(parents=True, exist_ok=True)
    cache = [shutil.which("ccache")] if shutil.which("ccache") else []

    def compile(source, to, *more):
        subprocess.run([*cache, "clang++", *flags, *SANITIZERS, *more, "-c", source, "-o", to], cwd=o.build, check=True)
        return to

    with concurrent.futures.ThreadPoolExecutor(o.jobs) as pool:
        shared = list(pool.map(lambda s: compile(s, objects / (str(s.relative_to(o.source)).replace("/", "_") + ".o"), "-fsanitize=fuzzer-no-link"), sources))

        def program(name):
            entry = compile(here / "libfuzzer.cpp", objects / f"entry_{name}.o", f"-DTOUCHSTONE_FUZZ_TARGET={name}")
            subprocess.run(["clang++", "-fsanitize=fuzzer", *SANITIZERS, entry, *shared, *libraries, "-o", o.scratch / f"fuzz_{name}"], cwd=o.build, check=True)

        list(pool.map(program, names))


def corpora(o, name):
    found = o.scratch / f"{name}.corpus"
    found.mkdir(exist_ok=True)
    return found, o.source / "tests/fuzz/corpus" / name


def hunt(o, name):
    """(name, executions, finds): libFuzzer stops at a find, so it is started again until the runs are made."""
    finds = o.scratch / f"{name}.finds"
    finds.mkdir(exist_ok=True)
    before = set(finds.iterdir())
    limits = [f"-runs={o.runs}", "-timeout=10", "-rss_limit_mb=1024", "-max_len=4096", "-print_final_stats=1", f"-artifact_prefix={finds}/", "-verbosity=1"]
    if o.seconds:
        limits.append(f"-max_total_time={o.seconds}")
    words = [o.scratch / f"fuzz_{name}", *limits, *corpora(o, name)]
    (o.scratch / "leaks").write_text("leak:libcln\n")  # once, when the library is loaded
    environment = dict(os.environ, LSAN_OPTIONS=f"suppressions={o.scratch}/leaks:print_suppressions=0")
    with open(o.scratch / f"{name}.log", "w") as log:
        subprocess.run(words, stdout=log, stderr=log, cwd=o.scratch, env=environment)
    text = (o.scratch / f"{name}.log").read_text(errors="replace")
    executions = re.search(r"stat::number_of_executed_units:\s*(\d+)", text)
    return name, int(executions.group(1)) if executions else 0, sorted(set(finds.iterdir()) - before)


def main():
    arguments = argparse.ArgumentParser()
    for name in ("source", "build", "scratch"):
        arguments.add_argument(name, type=lambda p: pathlib.Path(p).resolve())
    arguments.add_argument("--runs", type=int, default=10_000_000)
    arguments.add_argument("--seconds", type=int)
    arguments.add_argument("--only", default="")
    arguments.add_argument("--jobs", type=int, default=1)
    arguments.add_argument("--merge", action="store_true")
    o = arguments.parse_args()
    if not shutil.which("clang++"):
        sys.exit("campaign.py: clang++ is missing (Debian: apt-get install clang)")
    names = [n for n in NAMES.findall((o.source / "tests/fuzz/targets.hpp").read_text()) if o.only in n]
    build_all(o, names)
    if o.merge:
        for name in names:
            found, corpus = corpora(o, name)
            smallest = o.scratch / f"{name}.merged"
            shutil.rmtree(smallest, ignore_errors=True)
            smallest.mkdir()
            subprocess.run([o.scratch / f"fuzz_{name}", "-merge=1", "-max_len=512", smallest, corpus, found], check=True, capture_output=True)
            for text in smallest.iterdir():
                shutil.copy(text, corpus)
        return 0
    failed = False
    with concurrent.futures.ThreadPoolExecutor(o.jobs) as pool:
        for name, executions, finds in pool.map(lambda n: hunt(o, n), names):
            print(f"{name}: {executions} executions, {len(finds)} finds{''.join(f'{chr(10)}  {f}' for f in finds)}", flush=True)
            failed = failed or bool(finds) or executions == 0
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
