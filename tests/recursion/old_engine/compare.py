#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The recursion of today held against the seven engines it came from, area by area at random points of the domain.

    tests/recursion/old_engine/compare.py SCRATCH --build build/test [--seed 20261123] [--surfaces 100] [--spoil]

The library of the commit before the recursion was written anew is checked out and built in SCRATCH; areas.cpp is compiled against it and
against the build given. For each of so many values of G a hundred areas, n from 1 to 20, loads from 1e-5 to 10, are asked of both, to eight
digits. Two balls that are both proven must overlap, and a value that was certified must still be. What was answered is kept in SCRATCH, so
that a second call goes on where the first was stopped. --spoil moves the new answers by 1e-6 of themselves and has to fail.
"""
import argparse
import math
import random
import resource
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path

OLD = "0e2db64"  # the last commit of the engines as they were
SOURCE = Path(__file__).resolve().parents[3]
CLIENT = Path(__file__).resolve().parent / "areas.cpp"
AREAS_OF_A_SURFACE = 100


def run(*words, **more):
    subprocess.run([str(w) for w in words], check=True, **more)


def compiled(scratch, name, tree, build):
    """areas.cpp against the library of one build."""
    client = scratch / f"areas_{name}"
    archives = sorted((build / "lib").glob("libtouchstone*.a"))  # one in either commit, or two that need each other
    arb = ["-lflint-arb"] if Path("/usr/include/arb.h").exists() else []
    run("g++", "-std=c++20", "-O1", f"-I{tree}/lib", CLIENT, "-o", client, "-Wl,--start-group", *archives, "-Wl,--end-group",
        *arb, "-lflint", "-lmpfr", "-lgmpxx", "-lgmp", "-lfmt", "-lcrypto", "-lpthread")
    return client


def old_client(scratch):
    tree, build = scratch / "tree", scratch / "tree/build"
    if not tree.exists():
        run("git", "-C", SOURCE, "worktree", "add", "--detach", tree, OLD)
    if not (scratch / "areas_old").exists():
        run("cmake", "-S", tree, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DTOUCHSTONE_PROGRAM=OFF", "-DTOUCHSTONE_TESTS=OFF", stdout=subprocess.DEVNULL)
        run("cmake", "--build", build, "--target", "touchstone")
        compiled(scratch, "old", tree, build)
    return scratch / "areas_old"


def rational(x):
    return f"{int(x * 10**6) + 1}/1000000"


def rows_of(seed, surface):
    """Half the surfaces have regions of full contact at every scale, G from 1.02 to 2; the others' G is from 2.001 to 1002."""
    draw = random.Random(f"{seed}/{surface}")
    low, high, base = (0.02, 1, 1) if draw.random() < 0.5 else (1e-3, 1e3, 2)
    G = rational(base + math.exp(draw.uniform(math.log(low), math.log(high))))
    return [f"{draw.randint(1, 20)} {rational(math.exp(draw.uniform(math.log(1e-5), math.log(10))))} {G}" for _ in range(AREAS_OF_A_SURFACE)]


def answers(client, rows, kept):
    """The client's lines, from the file where an earlier run left them whole, and the seconds of this call."""
    if kept.exists() and len(lines := kept.read_text().splitlines()) == len(rows):
        return lines
    done = subprocess.run([str(client)], input="\n".join(rows) + "\n", stdout=subprocess.PIPE, text=True, check=True)
    kept.write_text(done.stdout)
    return done.stdout.splitlines()


def ball(words):
    """(lower end, upper end), exactly, of arb_dump_str's four integers in hexadecimal: mantissa and exponent of midpoint and radius."""
    m, e, r, f = (int(w, 16) for w in words)
    power = lambda a, b: Fraction(a) * Fraction(2) ** b
    return power(m, e) - power(r, f), power(m, e) + power(r, f)


def judged(row, old, new, spoil, counts):
    """A sentence where the two contradict each other."""
    (was, old_digits, _, *old_ball), (now, new_digits, _, *new_ball) = old.split(), new.split()
    proven = ("certified", "exact")
    counts[f"{was} then, {now} now"] = counts.get(f"{was} then, {now} now", 0) + 1
    if was in proven and now not in proven:
        return f"{row}: was {was} to {old_digits} digits, is {now} to {new_digits}"
    if was not in proven or now not in proven:
        return None
    (a, b), (c, d) = ball(old_ball), ball(new_ball)
    if spoil:
        c, d = c * (1 + Fraction(1, 10**6)), d * (1 + Fraction(1, 10**6))
    counts["pairs of proven balls"] = counts.get("pairs of proven balls", 0) + 1
    return None if a <= d and c <= b else f"{row}: {float(a)!r} to {float(b)!r} then, {float(c)!r} to {float(d)!r} now"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scratch", type=Path)
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--seed", default="20261123")
    parser.add_argument("--surfaces", type=int, default=100)
    parser.add_argument("--spoil", action="store_true")
    options = parser.parse_args()
    scratch = options.scratch.resolve()
    scratch.mkdir(parents=True, exist_ok=True)
    old = old_client(scratch)
    new = compiled(scratch, "new", SOURCE, options.build.resolve())
    counts, faults, areas = {}, [], 0
    with ThreadPoolExecutor(2) as both:
        for surface in range(options.surfaces):
            rows = rows_of(options.seed, surface)
            kept = [scratch / f"{options.seed}_{surface}_{name}.txt" for name in ("old", "new")]
            was, now = both.map(answers, (old, new), (rows, rows), kept)
            faults += filter(None, (judged(*three, options.spoil, counts) for three in zip(rows, was, now, strict=True)))
            areas += len(rows)
            print(f"G = {rows[0].split()[2]}: {areas} areas, {len(faults)} contradictions", file=sys.stderr, flush=True)
    for what, count in sorted(counts.items()):
        print(f"{count:7} {what}")
    print("\n".join(faults[:20]))
    print(f"{areas} areas, seed {options.seed}, {len(faults)} contradictions, {resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime:.0f} s of user CPU in this call")
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main())
