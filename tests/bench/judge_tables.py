# SPDX-License-Identifier: MIT
"""How long judging takes, for every stored table: python3 judge_tables.py TOUCHSTONE DATA/reference [TABLE...]

Three fast subjects: one that answers with the nearest binary64 numbers to the table's values (and 1 to rows held out), one that is
8 ulps off everywhere, so that for every row the judge must know what rounded inputs force, and one that always says 1.
Seconds of wall time and of processor time each; the last line says the worst. Nothing here passes or fails.
"""
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time


def rows_of(table):
    return [line.split() for line in table.read_text().splitlines() if not line.startswith("#")]


def inputs_of(table):
    return len([line for line in table.read_text().splitlines() if line.startswith("#")][-1].split("value")[0].split()) - 1


def measure(command):
    before, start = os.times(), time.monotonic()
    code = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=900).returncode
    after = os.times()
    return time.monotonic() - start, after.children_user + after.children_system - before.children_user - before.children_system, code


def main():
    program, folder, *names = sys.argv[1:]
    tables = sorted(pathlib.Path(folder).glob("*.txt"))
    worst = (0, "")
    with tempfile.TemporaryDirectory() as scratch:
        answers = pathlib.Path(scratch, "answers")
        for table in tables:
            if names and table.stem not in names:
                continue
            column = inputs_of(table)
            values = [float(row[column]) for row in rows_of(table)]
            line = f"{table.stem:<28}{len(values):>6} rows"
            for subject, off in (("right", 0), ("8 ulps off", 8), ("always 1", None)):
                command = [program, "judge", str(table)]
                if off is None:
                    command += ["--", "awk", '{print 1; fflush()}']
                else:
                    answers.write_text("".join(f"{(v + off * math.ulp(v)).hex()}\n" for v in values))
                    command += ["--answers", str(answers)]
                wall, processor, code = measure(command)
                worst = max(worst, (wall, f"{table.stem}, {subject}"))
                line += f"   {subject}: {wall:6.2f} s, {processor:6.2f} s of processor, exit {code}"
            print(line, flush=True)
    print(f"slowest: {worst[0]:.2f} s ({worst[1]})")


main()
