#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every parser under libFuzzer, with the address and undefined behaviour sanitizers or, several times as fast, without them.

usage: campaign.py SOURCE BUILD SCRATCH [--bare] [--executions 10000000] [--seconds S] [--only NAME,NAME] [--jobs 1] [--merge]

The parsers and the targets are compiled by clang with coverage and sanitizers; all else is linked from BUILD, a build of SOURCE with its tests by
any compiler (with clang before 16, which cannot compile it, the ledger's parser too: its texts are changed blindly). Each target starts from its
corpus and from what earlier campaigns left in SCRATCH. With --bare there are no sanitizers, only the assertions of ours and of the C++ library's
containers: most executions can be made so, on the texts that the sanitized ones found too. SCRATCH/state.json holds the executions of each target on
each commit, bare ones apart, so that a campaign can be made in pieces: the same command goes on until each target has had its EXECUTIONS in all, of
both kinds together, or has been given S seconds (of wall time) in this call. What ends a parser, or takes it longer than 10 s or 1 GB, is kept in
SCRATCH/NAME.finds and printed, and its target waits for the mending; exit code 1 if there is any. --merge writes the smallest texts that cover what
the corpus and SCRATCH cover back into the corpus.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import threading
import time

PARSERS = ["scalar/rational.cpp", "scalar/exact.cpp", "scalar/exact_text.cpp", "catalogue/named_inputs.cpp", "catalogue/quantity.cpp",
           "table/rows.cpp", "table/ranges.cpp", "table/own_table.cpp", "table/shard.cpp", "table/format.cpp", "oracle/baseline.cpp",
           "oracle/printed.cpp", "oracle/subject.cpp", "quadrature/expression.cpp", "quadrature/expression_tree.cpp"]
LEDGER = ["own/own_ledger.cpp", "own/own_symbols.cpp", "print.cpp", "symbols.cpp", "symbolic/units.cpp"]  # of proofs/
COMMON = ["-O2", "-g1", "-fno-omit-frame-pointer", "-D_GLIBCXX_ASSERTIONS"]
SANITIZERS = {"sanitized": ["-fsanitize=address,undefined", "-fno-sanitize=vptr", "-fno-sanitize-recover=all"], "bare": []}
TARGETS = re.compile(r'\{"(\w+)", \w+, (\d+)\}')
PIECE = 300  # seconds after which the executions made are written down
# Freed memory is held back for 16 MB instead of 256, which stay in no cache, and each allocation remembers 4 callers instead of 30.
ADDRESS_SANITIZER = "quarantine_size_mb=16:malloc_context_size=4"


def newest_clang():
    """(program, version) of the newest clang++ that has libFuzzer."""
    found = []
    for name in ("clang++", *(f"clang++-{v}" for v in range(14, 30))):
        if not shutil.which(name):
            continue
        version = re.search(r"version (\d+)", subprocess.run([name, "--version"], capture_output=True, text=True).stdout)
        runtime = subprocess.run([name, "-print-resource-dir"], capture_output=True, text=True).stdout.strip()
        if version and any(pathlib.Path(runtime).glob("lib/*/libclang_rt.fuzzer*")):
            found.append((int(version.group(1)), name))
    if not found:
        sys.exit("campaign.py: no clang++ with libFuzzer (Debian: apt-get install clang-16 libclang-rt-16-dev)")
    return max(found)[1], max(found)[0]


def words_of(build, target, pattern):
    lines = subprocess.run(["ninja", "-C", build, "-t", "commands", target], capture_output=True, text=True, check=True).stdout.splitlines()
    return shlex.split(next(line for line in lines if re.search(pattern, line)).replace("&& :", "").replace(": &&", ""))


def build_all(o, names):
    clang, version = newest_clang()
    commands = words_of(o.build, "test_parsers", "table/format.cpp$") + words_of(o.build, "test_parsers", "replay.cpp$")
    flags = list(dict.fromkeys(w for w in commands if w.startswith(("-I", "-D", "-std")) and w != "-DNDEBUG"))  # assertions are on
    link = words_of(o.build, "test_parsers", " -o tests/fuzz/test_parsers")
    libraries = [w for w in link[link.index("-o") + 2:] if not w.endswith(".o")]  # with what of the ledgers is not compiled here
    lib = o.source / "lib/touchstone"
    here = o.source / "tests/fuzz"
    sources = [lib / p for p in PARSERS] + [here / f for f in ("numbers.cpp", "files.cpp", "expressions.cpp")]
    if version >= 16 and "ledgers" in names:
        sources += [o.source / "proofs" / p for p in LEDGER] + [here / "ledgers.cpp"]
        flags += [w for w in words_of(o.build, "test_parsers", "own_ledger.cpp$") if w.startswith(("-I", "-D", "-std")) and w not in (*flags, "-DNDEBUG")]
    options = SANITIZERS[o.kind] + COMMON
    objects = o.scratch / f"objects_{o.kind}"
    objects.mkdir(parents=True, exist_ok=True)
    cache = [shutil.which("ccache")] if shutil.which("ccache") else []

    def compile(source, to, *more):
        subprocess.run([*cache, clang, *flags, *options, *more, "-c", source, "-o", to], cwd=o.build, check=True)
        return to

    with concurrent.futures.ThreadPoolExecutor(o.jobs) as pool:
        shared = list(pool.map(lambda s: compile(s, objects / (str(s.relative_to(o.source)).replace("/", "_") + ".o"), "-fsanitize=fuzzer-no-link"), sources))

        archive = objects / "parsers.a"  # so that a program has the counters of what it uses alone
        archive.unlink(missing_ok=True)
        subprocess.run(["ar", "rcs", archive, *shared], check=True)

        def program(name):
            entry = compile(here / "libfuzzer.cpp", objects / f"entry_{name}.o", f"-DTOUCHSTONE_FUZZ_TARGET={name}")
            subprocess.run([clang, "-fsanitize=fuzzer", *options, entry, archive, *libraries, "-o", program_of(o, name)], cwd=o.build, check=True)

        list(pool.map(program, names))


def program_of(o, name):
    return o.scratch / f"fuzz_{name}_{o.kind}"


def corpora(o, name):
    found = o.scratch / f"{name}.corpus"
    found.mkdir(exist_ok=True)
    return found, o.source / "tests/fuzz/corpus" / name


class State:
    """SCRATCH/state.json: {target: {commit: {kind: {executions, cpu_seconds, finds}}}}, the kinds "sanitized" and "bare"."""

    def __init__(self, o):
        git = ["git", "-C", o.source]
        commit = subprocess.run([*git, "rev-parse", "--short=10", "HEAD"], capture_output=True, text=True).stdout.strip() or "unknown"
        changed = subprocess.run([*git, "status", "--porcelain", "--untracked-files=no"], capture_output=True, text=True).stdout.strip()
        self.commit = commit + ("+" if changed else "")
        self.kind = o.kind
        self.file = o.scratch / "state.json"
        found = json.loads(self.file.read_text()) if self.file.exists() else {}
        # before there were kinds, all executions were sanitized ones
        self.of = {name: {commit: {"sanitized": made} if "executions" in made else made for commit, made in on.items()} for name, on in found.items()}
        self.lock = threading.Lock()

    def executions(self, name):
        return sum(made["executions"] for kinds in self.of.get(name, {}).values() for made in kinds.values())

    def add(self, name, executions, cpu_seconds, finds):
        with self.lock:
            kinds = self.of.setdefault(name, {}).setdefault(self.commit, {})
            c = kinds.setdefault(self.kind, {"executions": 0, "cpu_seconds": 0, "finds": 0})
            c["executions"] += executions
            c["cpu_seconds"] = round(c["cpu_seconds"] + cpu_seconds, 1)
            c["finds"] += finds
            new = self.file.with_suffix(".new")
            new.write_text(json.dumps(self.of, indent=1) + "\n")
            new.replace(self.file)


def piece(o, name, longest, executions, seconds):
    """(executions, CPU seconds) of one run of libFuzzer, which ends at a find."""
    limits = [f"-runs={executions}", f"-max_total_time={seconds}", f"-max_len={longest}", "-timeout=10", "-rss_limit_mb=1024", "-print_final_stats=1",
              f"-artifact_prefix={o.scratch / name}.finds/", "-verbosity=1"]
    (o.scratch / "leaks").write_text("leak:libcln\n")  # once, when the library is loaded
    environment = dict(os.environ, LSAN_OPTIONS=f"suppressions={o.scratch}/leaks:print_suppressions=0", ASAN_OPTIONS=ADDRESS_SANITIZER)
    with open(o.scratch / f"{name}.log", "w") as log:
        run = subprocess.Popen([program_of(o, name), *limits, *corpora(o, name)], stdout=log, stderr=log, cwd=o.scratch, env=environment)
        _, status, used = os.wait4(run.pid, 0)
        run.returncode = os.waitstatus_to_exitcode(status)
    made = re.search(r"stat::number_of_executed_units:\s*(\d+)", (o.scratch / f"{name}.log").read_text(errors="replace"))
    return int(made.group(1)) if made else 0, used.ru_utime + used.ru_stime


def hunt(o, state, name, longest):
    """(name, executions, CPU seconds, finds) of this call."""
    finds = o.scratch / f"{name}.finds"
    finds.mkdir(exist_ok=True)
    before, end = set(finds.iterdir()), time.monotonic() + o.seconds if o.seconds else float("inf")
    all_made, all_used, new = 0, 0.0, []
    while not new and (left := o.executions - state.executions(name)) > 0 and (seconds := int(min(PIECE, end - time.monotonic()))) > 0:
        made, used = piece(o, name, longest, left, seconds)
        new = sorted(set(finds.iterdir()) - before)
        state.add(name, made, used, len(new))
        all_made, all_used = all_made + made, all_used + used
        if made == 0:
            new = new or [o.scratch / f"{name}.log"]  # it did not start
    return name, all_made, all_used, new


def main():
    arguments = argparse.ArgumentParser()
    for name in ("source", "build", "scratch"):
        arguments.add_argument(name, type=lambda p: pathlib.Path(p).resolve())
    arguments.add_argument("--bare", dest="kind", action="store_const", const="bare", default="sanitized")
    arguments.add_argument("--executions", type=int, default=10_000_000)
    arguments.add_argument("--seconds", type=int)
    arguments.add_argument("--only", default="")
    arguments.add_argument("--jobs", type=int, default=1)
    arguments.add_argument("--merge", action="store_true")
    o = arguments.parse_args()
    only = o.only.split(",") if o.only else []
    longest = {n: int(size) for n, size in TARGETS.findall((o.source / "tests/fuzz/targets.hpp").read_text()) if n in only or not only}
    if not longest or set(only) - set(longest):
        sys.exit(f"campaign.py: no target {', '.join(set(only) - set(longest))}")
    names = list(longest)
    build_all(o, names)
    if o.merge:
        for name in names:
            found, corpus = corpora(o, name)
            smallest = o.scratch / f"{name}.merged"
            shutil.rmtree(smallest, ignore_errors=True)
            smallest.mkdir()
            subprocess.run([program_of(o, name), "-merge=1", "-max_len=512", smallest, corpus, found], check=True, capture_output=True)
            for text in smallest.iterdir():
                shutil.copy(text, corpus)
        return 0
    failed, state = False, State(o)
    with concurrent.futures.ThreadPoolExecutor(o.jobs) as pool:
        for name, made, used, finds in pool.map(lambda n: hunt(o, state, n, longest[n]), names):
            on = ", ".join(f"{c['executions']} {kind} on {commit}" for commit, kinds in state.of.get(name, {}).items() for kind, c in kinds.items())
            print(f"{name}: {made} executions, {made / max(used, 1e-9):.0f} a CPU second, {len(finds)} finds; in all {state.executions(name)} of {o.executions} ({on})"
                  f"{''.join(f'{chr(10)}  {f}' for f in finds)}", flush=True)
            failed = failed or bool(finds)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
