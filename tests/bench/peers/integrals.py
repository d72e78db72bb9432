# SPDX-License-Identifier: GPL-3.0-or-later
"""Item (c): the integrals of the public sets by every tool. Inside the process: a first call, then five batches. Tools that are close to the fastest
take turns then, 21 or five processes each, so that what else the machine does meets them alike."""
import os
import re
import statistics
import sys

import mpmath

from formulas import Gp, Python, Text, cases
from measure import right_digits, run

# At 300 and 3000 digits, some of every set; at 15 those that are singular at an end; at 50 all
AT_300 = "area bailey-05 bailey-07 bailey-12 quadpack-1a quadpack-8a boost-06 boost-10 boost-29 arb-22 pari-03 pari-06".split()
AT_3000 = "area bailey-05 boost-08 boost-10".split()
SIZES = {15: 5, 50: 10, 300: 15, 3000: 20}  # digits, and seconds of CPU that a tool has for one
CLOSE = 2.5  # times the median of the fastest
ROUNDS, FEW_ROUNDS = 21, 5  # processes of each that is no slower, where an end is singular and elsewhere
QUICK = "boost-08 pari-03 bailey-03".split()

MPMATH = """
import time
from mpmath import *
mp.dps = {digits}
{definitions}
def once():
    total = error = mpf(0)
{calls}
    return total, error
def timed(least):
    n = 0; start = time.process_time()
    while True:
        found = once(); n += 1
        if time.process_time() - start >= least: return (time.process_time() - start) / n * 1e3, found
first, (value, error) = timed(0)
own = error <= abs(value) * mpf(10) ** (3 - {digits})
times = [first] + [timed(0.008)[0] for _ in range(min(5, int(2000 / max(first, 1))) if own else 0)]
print("times", *times)
if not own: print("refused its own estimate is", nstr(error / abs(value), 2), nstr(value, {digits} + 3))
else: print("value", nstr(value, {digits} + 3))
"""
# GP's clock ticks in milliseconds
PARI = """
default(realprecision, {digits} + 3);
{definitions}
once() = {calls};
timed(least) = my(n = 0, start = getabstime()); while(n == 0 || getabstime() - start < least, once(); n++); 1. * (getabstime() - start) / n;
start = getabstime(); value = once(); first = getabstime() - start;
batches = min(5, floor(2000/max(first, 1))); times = if(batches, vector(batches, i, timed(20)), [first]);
printf("times %.3f ", first); for(i = 1, #times, printf("%.5f ", times[i]));
default(format, Str("g0.", {digits} + 3));
print(); print("value ", value);
"""


def for_mpmath(case, digits):
    definitions, calls = [], []
    for i, piece in enumerate(case.pieces):
        text = Text(piece.formula, Python)
        definitions += [f"{word}_{i} = {body}" for word, body in text.constants]
        names = lambda body: re.sub(r"\b(c\d+)\b", rf"\1_{i}", body)
        definitions += [f"def f{i}(x):", *(f"    {word} = {names(body)}" for word, body in text.parts), f"    return {names(text.body)}"]
        ends = f"[{Text(piece.start, Python).body}, {Text(piece.stop, Python).body}]"
        if piece.omega:
            calls.append(f"    total += quadosc(f{i}, {ends}, omega={Text(piece.omega, Python).body})")
        else:
            calls.append(f"    v, e = quad(f{i}, {ends}, error=True); total += v; error += e")
    return MPMATH.format(digits=digits, definitions="\n".join(definitions), calls="\n".join(calls))


def for_pari(case, digits):
    definitions, calls = [], []
    for i, piece in enumerate(case.pieces):
        text = Text(piece.formula, Gp)
        names = lambda body: re.sub(r"\b(c\d+)\b", rf"\1_{i}", body)
        definitions += [f"{word}_{i} = {body};" for word, body in text.constants]
        parts = ", ".join(f"{word} = {names(body)}" for word, body in text.parts)
        definitions.append(f"f_{i}(x) = {f'my({parts}); ' if parts else ''}{names(text.body)};")
        calls.append(f"intnum(x = {piece.gp_start}, {piece.gp_stop}, f_{i}(x))")
    return "\n".join(line for line in PARI.format(digits=digits, definitions="\n".join(definitions), calls=" + ".join(calls)).splitlines() if line)


def closed_form(text, digits):
    """The value from its formula, or None where only decimals are known and they end too soon."""
    known = text.replace("0.915965594177219015054603514932384110774149374281672", "catalan*1.0").replace(
        "0.577215664901532860606512090082402431042159335939923598805767", "euler")
    known = re.sub(r"catalan\*1\.0\d*", "catalan", known)
    if not known or re.search(r"\d\.\d{12,}", known):
        return None
    with mpmath.workdps(digits + 40):
        names = {name: getattr(mpmath, name) for name in dir(mpmath) if not name.startswith("_")}
        names["dilog"] = lambda x: mpmath.polylog(2, x)
        body = known if known in ("catalan", "euler") else Text(known.replace("euler", "(euler)"), Python).body
        return +eval(body, names)  # our own file of formulas


def told(done, limit):
    """times, value or refusal."""
    entry = {}
    for line in done.output.splitlines():
        word, _, rest = line.partition(" ")
        if word == "times":
            first, *warm = map(float, rest.split())
            warm = warm or [first]
            entry.update(first=first, median=statistics.median(warm), least=min(warm), most=max(warm), runs=len(warm))
        elif word in ("value", "refused") and rest.strip() != "value":  # a name of GP that was never given a value: the line before ended in an error
            entry[word] = rest.strip()
    if "value" not in entry and "refused" not in entry:
        entry["refused"] = f"not done in {limit} s" if done.stopped else (done.error.strip().splitlines() or ["no answer"])[-1][:100]
        entry["failed"] = True
    return entry


def runs_of(bench, case, digits, limit):
    """What runs each tool."""
    environment = {"TOUCHSTONE_FORMULA": case.formula, "TOUCHSTONE_FROM": case.start, "TOUCHSTONE_TO": case.stop}

    def inside(tool):
        return lambda: told(run([bench.integrals, tool, case.name, str(digits)], limit=limit, environment=environment), limit)

    how = {"Touchstone": inside("ours")}
    if bench.gp:
        how["PARI/GP"] = lambda: told(run([bench.gp, "-q", "-f", "-s", "2G"], for_pari(case, digits), limit), limit)
    how["mpmath"] = lambda: told(run([sys.executable, "-c", for_mpmath(case, digits)], limit=limit), limit)
    how["Boost"], how["Arb"] = inside("boost"), inside("arb")
    if digits <= 15:
        how["GSL"] = inside("gsl")
    return how


def by_turns(how, found, rounds_of_each=ROUNDS):
    """The medians of the tools that are close to the fastest, from processes that take turns."""
    told_of = {tool: entry for tool, entry in found.items() if "value" in entry}
    fastest = min((entry["median"] for entry in told_of.values()), default=0)
    close = [tool for tool, entry in told_of.items() if entry["median"] <= CLOSE * fastest]
    if len(close) < 2:
        return
    rounds = {tool: [found[tool]] for tool in close}
    for _ in range(rounds_of_each - 1):
        for tool in close:
            again = how[tool]()
            if "median" in again:
                rounds[tool].append(again)
    for tool, entries in rounds.items():
        found[tool].update(median=statistics.median(e["median"] for e in entries), least=min(e["least"] for e in entries),
                           most=max(e["most"] for e in entries), runs=sum(e["runs"] for e in entries))


def integrals(bench):
    """(c)"""
    here = os.path.dirname(os.path.abspath(__file__))
    all_cases = cases(os.path.join(here, "../../quadrature/public_integrals.txt"), os.path.join(here, "integrals.txt"))
    rows = [] if set(bench.sizes) == set(SIZES) else [row for row in bench.known.get("c", {}).get("rows", []) if row["digits"] not in bench.sizes]
    for digits in bench.sizes:
        limit = min(bench.limit, SIZES[digits])
        chosen = {300: AT_300, 3000: AT_3000}.get(digits)
        for case in all_cases:
            if (chosen and case.name not in chosen) or (bench.quick and case.name not in QUICK) or (digits == 15 and case.kind != "end"):
                continue
            how = runs_of(bench, case, digits, limit)
            found = {tool: runs() for tool, runs in how.items()}
            if not bench.quick:
                by_turns(how, found, ROUNDS if case.kind == "end" else FEW_ROUNDS)
            reference, source = closed_form(case.value, digits), "closed form"
            if reference is None:
                better = runs_of(bench, case, digits + 20, 600)["Touchstone"]()
                reference, source = (better.get("value", "").lstrip("[").split(" ")[0] or None), "certified to 20 digits more"
            for entry in found.values():
                if reference is None:
                    entry["verdict"] = "refused" if "refused" in entry else "not judged"
                    continue
                entry["right"] = right_digits(entry.get("value", ""), reference, digits)
                entry["verdict"] = "refused" if "refused" in entry else "right" if entry["right"] >= digits - 3 else "wrong"
                if "value" in entry:
                    entry["value"] = entry["value"][:24]
            rows.append({"name": case.name, "kind": case.kind, "digits": digits, "formula": case.formula or "(6.7), n = 1, load 1/10, G = 4",
                         "from": case.start, "to": case.stop, "reference": source, "tools": found})
        print(f"    {digits} digits: {len(rows)} rows", file=sys.stderr, flush=True)
    return {"rows": sorted(rows, key=lambda row: row["digits"]), "limits": SIZES}
