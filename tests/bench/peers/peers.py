#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Touchstone and its peers on the same work, in one run: seconds of user CPU, and how many digits are right.

    cmake --build build/test --target touchstone_program bench_peers
    python3 tests/bench/peers/peers.py build/test                 all of it: docs/peers.json and docs/peers.md, up to an hour
    python3 tests/bench/peers/peers.py build/test --only a,g      these items; the others stay as docs/peers.json has them
    python3 tests/bench/peers/peers.py build/test --quick --out DIR    a few seconds, that it runs; nothing worth reading

Medians of five runs, of fewer where they would take over 10 s (`runs` in the JSON); start of the processes included unless an item says otherwise.
Peers: mpmath (of this Python; with gmpy2 it is faster: Debian's python3-mpmath and python3-gmpy2 go with /usr/bin/python3), PARI/GP, Arb, Boost.Math on MPFR, GSL; one that is not installed is left out, and said to be.
"""
import argparse
import json
import os
import platform
import random
import re
import shutil
import subprocess
import sys
import time
from fractions import Fraction
from pathlib import Path

import measure
import page
from integrals import SIZES, integrals
from measure import exponent, repeated, right_digits, row, run

HERE = Path(__file__).resolve().parent
SOURCE = HERE.parents[2]

MPMATH_CONSTANT = """
from mpmath import mp, mpf, gamma, sqrt, pi
d = {digits}
mp.dps = d + 15
K = 2 / pi
root = sqrt(pi)
for i in range(int(3.33 * d) + 20):
    delta = 1 - mpf(2) ** (-(i + 1))
    K *= 2 ** delta * gamma(1 + delta / 2) / (root * gamma(mpf(3) / 2 + delta / 2))
mp.dps = d
print(K)
"""
PARI_CONSTANT = """
default(realprecision, {digits} + 15);
K = 2/Pi; root = sqrt(Pi);
for(i = 0, floor(3.33 * {digits}) + 20, delta = 1 - 2.^(-(i + 1)); K *= 2^delta * gamma(1 + delta/2) / (root * gamma(3/2 + delta/2)));
default(format, "g0.{digits}");
print(K);
"""

MPMATH_POINTS = """
import sys
from mpmath import mp, mpf, sqrt, asin, pi
mp.dps = {digits}
def exceedance(p, s): return 2 / pi * asin(sqrt(((s + 1) - sqrt((1 - s) ** 2 + p * p)) / 2))
def density(p, s):
    m = 1 - s; R = sqrt(m * m + p * p)
    return p / (pi * R * sqrt(2 * s * (m + R) - p * p))
f = {name}
for line in sys.stdin:
    p, s = map(float.fromhex, line.split())
    print(float(f(mpf(p), mpf(s))).hex())
"""
PARI_POINTS = """
default(realprecision, {digits});
exceedance(p, s) = 2/Pi*asin(sqrt(((s + 1) - sqrt((1 - s)^2 + p^2))/2));
density(p, s) = my(m = 1 - s, R = sqrt(m^2 + p^2)); p/(Pi*R*sqrt(2*s*(m + R) - p^2));
f(p, s) = printf("%.30e\\n", {name}(p, s));
"""

MPMATH_AREA = """
from mpmath import mp, mpf, quad, sqrt, asin, sin, cos, pi
mp.dps = {digits} + 5
G = sqrt(mpf(10))
def T(f, x):
    root = sqrt(x)
    def g(t):
        c = cos(t); d = sqrt(1 - x * sin(t) ** 2)
        return f(2 / G * root * c * d) * c / d
    return 2 / pi * root * quad(g, [0, pi / 2])
B = [lambda x: 2 / pi * asin(sqrt(x))]
for n in range({n}): B.append(lambda x, n=n: T(B[n], x))
print(mp.nstr(B[{n}](mpf(1) / 10), {digits}))
"""
PARI_AREA = """
default(realprecision, {digits} + 7);
G = sqrt(10);
T(f, x) = 2/Pi * sqrt(x) * intnum(t = 0, Pi/2, my(s = sin(t), c = cos(t), d = sqrt(1 - x*s^2)); f(2/G * sqrt(x) * c * d) * c/d);
B0(x) = 2/Pi * asin(sqrt(x));
B1(x) = T(B0, x);
B2(x) = T(B1, x);
B3(x) = T(B2, x);
default(format, "g0.{digits}");
print(B{n}(1/10));
"""

# q_2 of (6.1) by the closed forms (2.17), (2.19), two nested integrals; ends by sin^2 and v^2 so that nothing is singular
PARI_DENSITY = """
default(realprecision, 28);
load = 1/10; G = sqrt(10);
R(x, P) = sqrt((1 - x)^2 + P^2);
A(x, P) = my(r = R(x, P)); P/(Pi*r)*sqrt((1 + x + r)/(1 - x + r));
hi = 2*sqrt(load); top = 2*sqrt(hi*G);
q1(y) = my(lo = y^2/(4*G)); intnum(t = 0, Pi/2, my(z = lo + (hi - lo)*sin(t)^2); A(z/G, y/G)*A(load, z)/sqrt(hi + z))/sqrt(G);
q2(p) = my(lo = p^2/(4*G^2), w = top - lo); intnum(v = 0, 1, my(y = lo + w*v^2); q1(y)*A(y/G^2, p/G^2))*sqrt(w)/G;
{calls}
"""
MPMATH_DENSITY = """
from mpmath import mp, mpf, quad, sqrt, sin, pi
mp.dps = 22
load = mpf(1) / 10; G = sqrt(mpf(10)); hi = 2 * sqrt(load); top = 2 * sqrt(hi * G)
def A(x, P):
    R = sqrt((1 - x) ** 2 + P * P)
    return P / (pi * R) * sqrt((1 + x + R) / (1 - x + R))
def q1(y):
    lo = y * y / (4 * G)
    def f(t):
        z = lo + (hi - lo) * sin(t) ** 2
        return A(z / G, y / G) * A(load, z) / sqrt(hi + z)
    return quad(f, [0, pi / 2]) / sqrt(G)
def q2(p):
    lo = p * p / (4 * G ** 2); w = top - lo
    def f(v):
        y = lo + w * v * v
        return q1(y) * A(y / G ** 2, p / G ** 2)
    return quad(f, [0, 1]) * sqrt(w) / G
for p in [{points}]: print(mp.nstr(q2(mpf(p)), 22))
"""


class Bench:
    def __init__(self, build, quick, limit):
        self.build, self.quick, self.limit = Path(build), quick, limit
        self.touchstone = str(self.build / "touchstone")
        folder = self.build / "tests/bench/peers"
        self.values, self.integrals = str(folder / "bench_peer_values"), str(folder / "bench_peer_integrals")
        self.gp = shutil.which("gp")
        self.sizes, self.known = [15, 50] if quick else list(SIZES), {}

    def must_be_of_now(self):
        """Its programs are no part of what a build makes by itself: one of yesterday would measure yesterday's library."""
        for program in map(Path, (self.values, self.integrals)):
            if program.exists() and any(library.stat().st_mtime > program.stat().st_mtime for library in (self.build / "lib").glob("*.a")):
                sys.exit(f"peers: {program.name} is older than the library: cmake --build {self.build} --target touchstone_program bench_peers")

    def mpmath(self, text, limit):
        return repeated([sys.executable, "-c", text], limit=limit)

    def pari(self, text, limit):
        return repeated([self.gp, "-q", "-f", "-s", "2G"], "\n".join(line for line in text.splitlines() if line), limit)

    def eval_value(self, words, digits):
        done = run([self.touchstone, "eval", *words.split(), "--digits", str(digits), "--json"], limit=600)
        return json.loads(done.output)["value"] if done.output else None


def tools(bench, how, digits, limit, reference):
    """A row of each tool that is there: `how` has its name and what runs it."""
    rows = []
    for tool, runs in how.items():
        if tool == "PARI/GP" and not bench.gp:
            rows.append({"tool": tool, "refused": "not installed"})
            continue
        last, seconds = runs()
        entry = row(tool, last, seconds, limit)
        if "median" in entry and reference is not None:
            entry["right"], entry["digits"] = right_digits(last.output, reference, digits), digits
        rows.append(entry)
    return rows


def constant(bench):
    """(a)"""
    rows = []
    for digits in [30] if bench.quick else [100, 1000, 10000]:
        reference = bench.eval_value("archard.K_inf", min(digits + 20, 10000))
        here = tools(bench, {
            "Touchstone": lambda: repeated([bench.touchstone, "eval", "archard.K_inf", "--digits", str(digits)], limit=bench.limit),
            "mpmath": lambda: bench.mpmath(MPMATH_CONSTANT.format(digits=digits), bench.limit),
            "PARI/GP": lambda: bench.pari(PARI_CONSTANT.format(digits=digits), bench.limit),
            "Arb": lambda: repeated([bench.values, "product", str(digits)], limit=bench.limit)}, digits, bench.limit, reference)
        gamma = run([bench.values, "gamma", str(digits)]).output
        for entry in here:
            entry["size"] = digits
            if entry["tool"] == "Touchstone" and "median" in entry and gamma:
                entry["gammas"] = 1e3 * entry["median"] / float(gamma)
        rows += here
    return {"rows": rows, "limit": bench.limit}


def points(bench):
    """(b)"""
    source = random.Random(20261123)
    rows = []
    count = 200 if bench.quick else 100000
    lines = []
    for i in range(count):
        load = source.uniform(0, 1)
        share = 1 - 1e-6 * source.random() if i % 10 == 0 else source.random()
        lines.append(f"{(2 * load ** 0.5 * share).hex()} {load.hex()}\n")
    text = "".join(lines)
    folder = bench.build / "peers"
    folder.mkdir(exist_ok=True)
    (folder / "points.txt").write_text("# p load\n" + text)
    for name in ("exceedance", "density"):
        quantity = f"westergaard.{name}"
        last, seconds = repeated([bench.values, "points", quantity], text, limit=bench.limit)
        inside = [float(last.output.split()[0])] if last.output else []
        truth = [float.fromhex(word) for word in last.output.split()[1:]]

        def judged(entry, answers):
            entry["quantity"], entry["points"] = quantity, count
            if "median" in entry:
                entry["wrong"] = sum(a != b for a, b in zip(answers, truth)) + abs(len(answers) - len(truth))
            rows.append(entry)

        judged(row("Touchstone, library", last, seconds, bench.limit, inside=inside), truth)
        command = [bench.touchstone, "eval", quantity, "--rows", str(folder / "points.txt"), "--digits", "17", "--json", "--jobs", "1"]
        last, seconds = repeated(command, limit=bench.limit)
        judged(row("Touchstone, eval --rows", last, seconds, bench.limit),
               [float.fromhex(json.loads(line).get("binary64", "nan")) for line in last.output.splitlines() if '"row"' in line])
        for digits in (25, 40):
            last, seconds = repeated([sys.executable, "-c", MPMATH_POINTS.format(digits=digits, name=name)], text, bench.limit)
            judged(row(f"mpmath, {digits} digits", last, seconds, bench.limit), [float.fromhex(line) for line in last.output.split()])
        if bench.gp:
            def exact(word):  # a hexfloat as GP reads it
                mantissa, power = float.fromhex(word).hex().replace("0x", "").split("p")
                whole = int(mantissa.replace(".", ""), 16)
                return f"{whole}*2^{int(power) - 4 * (len(mantissa) - 2)}"
            calls = "".join(f"f({','.join(exact(word) for word in line.split())});\n" for line in lines)
            for digits in (28, 38):
                last, seconds = bench.pari(PARI_POINTS.format(digits=digits, name=name) + calls, bench.limit)
                judged(row(f"PARI/GP, {digits} digits", last, seconds, bench.limit), [float(line.replace(" ", "")) for line in last.output.splitlines()])
    return {"rows": rows, "limit": bench.limit}


def nested(bench):
    """(d)"""
    digits = 12 if bench.quick else 50
    reference = bench.eval_value("contact.area n=2 load=0.1 G=sqrt(10)", digits + 20)
    return {"rows": tools(bench, {
        "Touchstone": lambda: repeated([bench.touchstone, "eval", "contact.area", "n=2", "load=0.1", "G=sqrt(10)", "--digits", str(digits)], limit=bench.limit),
        "PARI/GP": lambda: bench.pari(PARI_AREA.format(digits=digits, n=2), bench.limit),
        "mpmath": lambda: bench.mpmath(MPMATH_AREA.format(digits=digits, n=2), bench.limit),
        "Boost on MPFR": lambda: repeated([bench.values, "nested", "2", str(digits)], limit=bench.limit),
        "GSL, doubles": lambda: repeated([bench.values, "nested", "2", "15"], limit=bench.limit)}, digits, bench.limit, reference), "limit": bench.limit}


def areas(bench):
    """(e)"""
    rows = []
    loads = ["0.001", "0.01", "0.1", "0.5", "1"]
    sets = [("3/2", 10, 8)] if bench.quick else [("3/2", 10, 50), ("3/2", 5, 50), ("3/2", 10, 15), ("3/2", 5, 15), ("1.05", 10, 6), ("1.05", 5, 6)]
    for D, gamma, digits in sets:
        words = ["contact.area", f"n=0:{2 if bench.quick else 20}:1", f"load={','.join(loads)}", f"D={D}", f"gamma={gamma}"]
        last, seconds = repeated([bench.touchstone, "eval", *words, "--digits", str(digits), "--jobs", "1"], limit=bench.limit)
        entry = row("Touchstone", last, seconds, bench.limit, what=f"all A_n, n to 20, five loads, D = {D}, gamma = {gamma}", asked=digits)
        status = [line.partition("#")[2].split()[0] for line in last.output.splitlines() if not line.startswith("#")]
        entry["proven"], entry["values"] = sum(word in ("certified", "exact") for word in status), len(status)
        rows.append(entry)
    limit = bench.limit
    for digits in (15,) if bench.quick else (15, 50):
        reference = bench.eval_value("contact.area n=3 load=0.1 G=sqrt(10)", digits + 20)
        how = {"PARI/GP": lambda: bench.pari(PARI_AREA.format(digits=digits, n=3), limit),
               "Boost on MPFR": lambda: repeated([bench.values, "nested", "3", str(digits + 1)], limit=limit)}
        if digits == 15:
            how["mpmath"] = lambda: bench.mpmath(MPMATH_AREA.format(digits=digits, n=3), limit)
            how["GSL, doubles"] = lambda: repeated([bench.values, "nested", "3", "15"], limit=limit)
        for entry in tools(bench, how, digits, limit, reference):
            rows.append({**entry, "what": "A_3 alone, load 1/10, D = 3/2, gamma = 10", "asked": digits})
    nested = [("3/2", 10, 15, "1e-13"), ("3/2", 5, 15, "1e-13"), ("1.05", 10, 6, "1e-7"), ("1.05", 5, 6, "1e-7")]  # 1e-6 leaves 5 right digits
    for D, gamma, digits, tolerance in nested[:1] if bench.quick else nested:
        G = repr(float(gamma) ** (float(Fraction(D)) - 1))
        last, seconds = repeated([bench.values, "areas", "3", G, tolerance, *loads], limit=limit)
        entry = row("GSL, doubles", last, seconds, limit, what=f"A_3 alone, five loads, D = {D}, gamma = {gamma}", asked=digits, same_loads=True)
        if "median" in entry:
            truths = [bench.eval_value(f"contact.area n=3 load={load} D={D} gamma={gamma}", digits + 10) for load in loads]
            entry["right"], entry["digits"] = min(right_digits(line, truth, digits) for line, truth in zip(last.output.splitlines(), truths, strict=True)), digits
        rows.append(entry)
    return {"rows": rows, "limit": limit, "entries": entries(bench)}


def entries(bench):
    """What the areas of one G cost at least: at each scale every node from all of the scale before, a multiplication each."""
    bits = 240
    told = run([bench.touchstone, "eval", "contact.area", "n=20", "load=0.1", "D=3/2", "gamma=10", "--digits", "50", "--explain"], limit=60).output
    nodes = re.search(r"force-weighted: (\d+) nodes", told)
    return {"nanoseconds": float(run([bench.values, "multiply", str(bits)]).output), "bits": bits, "nodes": int(nodes.group(1)) if nodes else None}


def densities(bench):
    """(f)"""
    step = "5" if bench.quick else "0.2"
    values = [f"{(i + 1) * float(step):.10g}" for i in range(int(10.4 / float(step) + 0.5))]
    command = [bench.touchstone, "eval", "contact.density", "n=2", "load=0.1", "G=sqrt(10)", f"p={','.join(values)}", "--digits", "20", "--jobs", "1"]
    last, seconds = repeated(command, limit=bench.limit)
    truth = [line.split()[4] for line in last.output.splitlines() if not line.startswith("#")]
    first = row("Touchstone", last, seconds, bench.limit)
    first["right"] = 20 if sum(line.endswith("# certified") for line in last.output.splitlines() if not line.startswith("#")) == len(values) else 0
    rows = [first]
    for tool, runs in (("PARI/GP", lambda: bench.pari(PARI_DENSITY.format(calls="\n".join(f"print(q2({p}));" for p in values)), bench.limit)),
                       ("mpmath", lambda: bench.mpmath(MPMATH_DENSITY.format(points=",".join(f"'{p}'" for p in values)), bench.limit))):
        if tool == "PARI/GP" and not bench.gp:
            continue
        last, seconds = runs()
        entry = row(tool, last, seconds, bench.limit)
        done = last.output.split("\n")[:-1]
        entry["done"] = len(done)
        if done:
            entry["right"] = min(right_digits(a.replace(" ", ""), b, 20) for a, b in zip(done, truth))
        rows.append(entry)
    return {"rows": rows, "points": len(values), "limit": bench.limit}


def doubles(bench):
    """(g)"""
    rows = []
    for line in run([bench.values, "doubles"], limit=120).output.splitlines():
        form, equation, tool, *numbers = line.split()
        nanoseconds = sorted(map(float, numbers[:5]))
        rows.append({"form": form, "equation": equation, "tool": tool, "median": nanoseconds[2], "least": nanoseconds[0], "most": nanoseconds[4], "ulps": float(numbers[5])})
    return {"rows": rows}


def costs(bench):
    """How the cost grows, and what it takes of memory."""
    series = []

    def measured(what, variable, sizes, command, of=lambda last: last.seconds):
        found = []
        for size in sizes[:2] if bench.quick else sizes:
            times, memory = [], 0
            while len(times) < 3 and sum(times) < 10:
                last = run(command(size), limit=bench.limit)
                if last.stopped or last.code:
                    break
                times.append(of(last))
                memory = last.megabytes
            if times:
                found.append((size, min(times), memory))
        if len(found) > 1:
            series.append({"what": what, "variable": variable, "sizes": [f[0] for f in found], "seconds": [f[1] for f in found],
                           "megabytes": [round(f[2], 1) for f in found], "exponent": exponent([f[0] for f in found], [f[1] for f in found])})

    evaluate = lambda *words: [bench.touchstone, "eval", *words]
    measured("archard.K_inf", "digits", [100, 300, 1000, 3000, 10000], lambda d: evaluate("archard.K_inf", "--digits", str(d)))
    measured("contact.area n=20 load=0.1 D=3/2 gamma=10", "digits", [12, 25, 50, 100, 200],
             lambda d: evaluate("contact.area", "n=20", "load=0.1", "D=3/2", "gamma=10", "--digits", str(d)))
    measured("contact.area load=0.1 D=3/2 gamma=10, 50 digits", "n", [5, 10, 20, 40, 80],
             lambda n: evaluate("contact.area", f"n={n}", "load=0.1", "D=3/2", "gamma=10", "--digits", "50"))
    folder = bench.build / "peers"
    folder.mkdir(exist_ok=True)
    for count in (1000, 10000, 100000):
        (folder / f"{count}.txt").write_text("# p load\n" + "".join(f"{(i % 997 + 1) / 1000!r} {(i % 991 + 500) / 2000!r}\n" for i in range(count)))
    rows = lambda count, jobs: evaluate("westergaard.density", "--rows", str(folder / f"{count}.txt"), "--digits", "17", "--jobs", str(jobs))
    measured("westergaard.density --rows, 17 digits", "points", [1000, 10000, 100000], lambda n: rows(n, 1))
    measured("westergaard.density --rows, 17 digits, 100 000 points, seconds of the wall's clock", "threads", list(range(1, (os.cpu_count() or 1) + 1)),
             lambda jobs: rows(1000 if bench.quick else 100000, jobs), of=lambda last: last.wall)
    measured("the integral of x^(-9/10) from 0 to 1", "digits", [50, 300, 1000, 3000], lambda d: [bench.touchstone, "integrate", "x^(-9/10)", "0", "1", "--digits", str(d)])
    return {"rows": series}


ITEMS = {"a": constant, "b": points, "c": integrals, "d": nested, "e": areas, "f": densities, "g": doubles, "cost": costs}


def versions(bench):
    def first(command):
        try:
            return subprocess.run(command, capture_output=True, text=True, timeout=20, check=True).stdout.strip().splitlines()[0]
        except (OSError, subprocess.SubprocessError, IndexError):
            return "not installed"

    import mpmath
    found = {"Touchstone": first([bench.touchstone, "--version"]).split()[-1], "mpmath": f"{mpmath.__version__} ({mpmath.libmp.BACKEND})",
             "Python": platform.python_version(), "PARI/GP": first([bench.gp, "--version-short"]) if bench.gp else "not installed"}
    for name, package in (("GSL", "gsl"), ("MPFR", "mpfr")):
        found[name] = first(["pkg-config", "--modversion", package])
    for name, package in (("Arb", "libflint-arb-dev"), ("FLINT", "libflint-dev"), ("Boost", "libboost-dev")):
        found[name] = first(["dpkg-query", "-W", "-f=${Version}", package])
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("--only", default="", help=f"of {','.join(ITEMS)}")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--limit", type=int, default=30, help="seconds of CPU for one run of a tool")
    parser.add_argument("--budget", type=float, default=measure.BUDGET, help="seconds of CPU after which a command is not run again, if it has not been five times")
    parser.add_argument("--digits", default="", help=f"of (c), some of {','.join(map(str, SIZES))}; the others stay as they are")
    parser.add_argument("--out", default=str(SOURCE / "docs"), help="folder of peers.json and peers.md")
    options = parser.parse_args()
    bench = Bench(options.build, options.quick, 3 if options.quick else options.limit)
    bench.must_be_of_now()
    measure.BUDGET = options.budget
    store = Path(options.out) / "peers.json"
    results = json.loads(store.read_text()) if store.exists() and options.only else {"items": {}}
    bench.known = results["items"]
    if options.digits:
        bench.sizes = [int(word) for word in options.digits.split(",")]
    for item in options.only.split(",") if options.only else ITEMS:
        start = time.monotonic()
        print(f"({item}) {ITEMS[item].__doc__ or ''}", file=sys.stderr, flush=True)
        results["items"][item] = {"date": time.strftime("%Y-%m-%d", time.gmtime()), **ITEMS[item](bench), "took": round(time.monotonic() - start)}
        results["machine"] = f"{os.cpu_count()} cores, {platform.machine()}"
        results["versions"] = versions(bench)
        store.write_text(json.dumps(results, indent=1) + "\n")
    (Path(options.out) / "peers.md").write_text(page.text(results))


if __name__ == "__main__":
    main()
