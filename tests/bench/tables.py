#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""User CPU seconds of every certified table made from nothing, each by a process of its own, and whether it is the stored one.

    tests/bench/tables.py TOUCHSTONE data/reference [--only NAME ...] [--limit SECONDS]

The goal of 240 s in all was set for the tables marked "old"; those of the limit came after it.
"""
import argparse
import resource
import subprocess
from pathlib import Path

GOAL = 240
SINCE = "limit_"  # tables whose names begin so are newer than the goal


def made(program, folder, name, limit):
    """Seconds, and what there is to say of the result."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    try:
        run = subprocess.run([program, "table", name, "--check", "--out", folder, "--jobs", "1"], capture_output=True, text=True, timeout=limit, check=False)
        said = "as stored" if run.returncode == 0 else "DIFFERS"
    except subprocess.TimeoutExpired:
        said = f"stopped after {limit:g} s of wall clock"
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, said


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--limit", type=float, default=3600)
    options = parser.parse_args()
    total = {"old": 0.0, "new": 0.0}
    failed = 0
    for path in sorted(Path(options.folder).glob("*.txt")):
        if options.only and path.stem not in options.only:
            continue
        rows = sum(1 for line in path.read_text().splitlines() if line and not line.startswith("#"))
        seconds, said = made(options.program, options.folder, path.stem, options.limit)
        age = "new" if path.stem.startswith(SINCE) else "old"
        total[age] += seconds
        failed += said != "as stored"
        print(f"{path.stem:34} {age} {rows:6} rows {seconds:8.1f} s   {said}", flush=True)
    print(f"all tables: old {total['old']:.1f} s (goal <= {GOAL} s), new {total['new']:.1f} s")
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
