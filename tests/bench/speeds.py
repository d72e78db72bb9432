#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""User CPU seconds of single evaluations, by one build of the program or by two in one run, with their ratio.

    tests/bench/speeds.py NEW [OLD] [--limit SECONDS] [--only WORD]

NEW and OLD are touchstone programs. Runs alternate; the least of three is taken, of one where a run takes over 5 s. A run over the limit
(default 300 s of wall clock), or without a certified value, is shown as such and not as a time.
"""
import argparse
import json
import resource
import subprocess

ROWS = [
    ("contact.area n=1 D=1.05 gamma=5 load=0.35", 15, 0.1),
    ("contact.area n=1 D=1.05 gamma=5 load=0.35", 100, 1),
    ("contact.area n=2 D=1.05 gamma=5 load=0.35", 15, 2),
    ("contact.area n=2 D=1.05 gamma=5 load=0.35", 40, 20),
    ("contact.area n=20 D=1.05 gamma=10 load=1.5", 5, 2),
    ("contact.area n=20 D=1.05 gamma=10 load=1.5", 12, 12),
    ("contact.density n=2 p=0.9 load=1 G=3/2", 15, 5),
    ("contact.density n=5 p=0.5 load=0.1 D=1.5 gamma=10", 10, 4),
    ("contact.density n=5 p=0.5 load=0.1 D=1.5 gamma=10", 20, 4),
    ("contact.area n=20 D=1.5 gamma=10 load=0.1", 50, 1),
    ("contact.area n=20 D=1.5 gamma=10 load=0.1", 100, 6),
]


def user_seconds():
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


def timed(program, row, digits, limit):
    """Seconds, or a word that says why there are none; and the value."""
    before = user_seconds()
    try:
        run = subprocess.run([program, "eval", *row.split(), "--digits", str(digits), "--json"], capture_output=True, text=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return f"> {limit} s", None
    seconds = user_seconds() - before
    if run.returncode:
        return "undecided" if run.returncode == 2 else "failed", None
    answer = json.loads(run.stdout)
    return (seconds if answer["status"] in ("certified", "exact") else answer["status"]), answer["value"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("new")
    parser.add_argument("old", nargs="?")
    parser.add_argument("--limit", type=float, default=300)
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    names = ("old", "new") if options.old else ("new",)
    show = lambda t: f"{t:.3f}" if isinstance(t, float) else t
    print(f"{'':58} digits {'old':>10} {'new':>10} {'old/new':>8}   goal")
    differ = 0
    for row, digits, goal in ROWS:
        if options.only not in row:
            continue
        least = {}
        for _ in range(3):
            for name in names:
                time, value = timed(getattr(options, name), row, digits, options.limit)
                known = least.get(name)
                if known is None or (isinstance(known[0], float) and isinstance(time, float) and time < known[0]):
                    least[name] = (time, value)
            if any(not isinstance(t, float) or t > 5 for t, _ in least.values()):
                break
        (old, a), (new, b) = least.get("old", ("-", None)), least["new"]
        ratio = f"{old / new:.1f}" if isinstance(old, float) and isinstance(new, float) and new > 0 else "-"
        wrong = a is not None and b is not None and a != b
        differ += wrong
        print(f"{row:58} {digits:6} {show(old):>10} {show(new):>10} {ratio:>8}   <= {goal} s{'   VALUES DIFFER' if wrong else ''}", flush=True)
    return 1 if differ else 0


if __name__ == "__main__":
    raise SystemExit(main())
