#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Time tanh-sinh quadrature against others on endpoint-singular integrals.

    python3 tests/bench/quadrature.py BUILD/tests/bench/bench_quadrature [--digits 50,300,3000] [--limit SECONDS] [--cases ...] [--tools ...]

Needs gp (PARI) and python3-mpmath for their rows; without them those rows say so. Each row is one fresh process: `cold`
is its first call, tables of nodes included, `warm` the mean of later ones (PARI: with the table of intnuminit).
`digits` counts the correct ones. PARI gets its endpoints coded; PARI, mpmath and Boost integrate the
area in the distance to the edge, without which they lose half the digits; Arb gets the bounded form of the area.
"""
import argparse
import re
import shutil
import subprocess
import sys

CASES = {
    "profile": "(1-x^2)^(3/8) on [-1,1]  (7.13)",
    "pole": "x^-0.9 on [0,1]",
    "root": "sqrt(1-x) on [0,1]",
    "area": "(6.7) n=1, load 1/10, G=4",
}

PARI = {
    "profile": "a=[-1,3/8];b=[1,3/8];f(x)=(1-x^2)^(3/8);",
    "pole": "a=[0,-9/10];b=1;f(x)=x^(-9/10);",
    "root": "a=0;b=[1,1/2];f(x)=sqrt(1-x);",
    # in t, the distance to the edge p = 2 sqrt(S)
    "area": "S=1/10;e=2*sqrt(S);a=[0,-1/2];b=[e,3/2];"
            "f(t)=my(p=e-t,R=sqrt((1-S)^2+p^2));p/(Pi*R)*sqrt((1+S+R)/((1-S+R)*t*(e+p)))*2/Pi*asin(sqrt(p/4));",
}
PARI_RUN = """
default(realprecision,DIGITS+5);BODY
t=getabstime();v=intnum(x=a,b,f(x));c=getabstime()-t;
tab=intnuminit(a,b);t=getabstime();n=0;while(getabstime()-t<400||n<1,intnum(x=a,b,f(x),tab);n++);w=1.0*(getabstime()-t)/n;
t=getabstime();m=0;while(getabstime()-t<400||m<1,intnum(x=a,b,f(x));m++);c=min(max(c,0.001),1.0*(getabstime()-t)/m);
default(format,Str("f0.",DIGITS+5));
print(strprintf("%.4f %.4f",c,w)," ",v);
"""

MPMATH_RUN = """
import sys,time
from mpmath import mp,mpf,quad,sqrt,asin,pi
mp.dps=DIGITS
S=mpf(1)/10; e=2*sqrt(S)
def area(t):
    p=e-t; R=sqrt((1-S)**2+p*p)
    return p/(pi*R)*sqrt((1+S+R)/((1-S+R)*t*(e+p)))*2/pi*asin(sqrt(p/4))
f,i={"profile":(lambda x:(1-x*x)**(mpf(3)/8),[-1,1]),"pole":(lambda x:x**(-mpf(9)/10),[0,1]),
   "root":(lambda x:sqrt(1-x),[0,1]),"area":(area,[0,e])}["CASE"]
t=time.process_time();v=quad(f,i);c=time.process_time()-t
n=0;t=time.process_time()
while n<1 or time.process_time()-t<0.4: quad(f,i);n+=1
print("%.4f %.4f %s"%(c*1e3,(time.process_time()-t)/n*1e3,mp.nstr(v,DIGITS+5)))
"""


def run(command, text, limit):
    try:
        done = subprocess.run(command, input=text, capture_output=True, text=True, timeout=limit)
    except subprocess.TimeoutExpired:
        return None
    lines = [line for line in done.stdout.splitlines() if re.match(r"[0-9.]+ [0-9.]+ ", line)]
    if done.returncode or not lines:
        return "failed: " + (done.stderr.strip().splitlines() or ["no output"])[-1][:60]
    return lines[-1]


def correct_digits(value, reference):
    """Significant digits of value that agree with reference (mpmath, if there is one)."""
    from mpmath import mp, mpf, log10
    try:
        v = mpf(re.match(r"\[?(-?[0-9.]+(?:e[-+]?[0-9]+)?)", value).group(1))
    except AttributeError:
        return 0
    if v == reference:
        return mp.dps
    return max(0, int(-log10(abs(v / reference - 1))))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--digits", default="50,300,3000")
    parser.add_argument("--limit", type=float, default=120, help="seconds for one row")
    parser.add_argument("--cases", default=",".join(CASES))
    parser.add_argument("--tools", default="ours,mpfr,boost,arb,pari,mpmath")
    options = parser.parse_args()
    try:
        from mpmath import mp, mpf, gamma, sqrt, pi
    except ImportError:
        sys.exit("quadrature.py: python3-mpmath is needed to judge the digits")
    gp = shutil.which("gp")
    for digits in map(int, options.digits.split(",")):
        mp.dps = digits + 20
        for case in options.cases.split(","):
            tools = {tool: ([options.program, tool, case, str(digits)], None) for tool in ("ours", "mpfr", "boost", "arb")}
            if gp:
                body = PARI_RUN.replace("BODY", PARI[case]).replace("DIGITS", str(digits))
                tools["pari"] = ([gp, "-q", "-f", "-s", "1G"], "\n".join(body.splitlines()))
            tools["mpmath"] = ([sys.executable, "-c", MPMATH_RUN.replace("DIGITS", str(digits)).replace("CASE", case)], None)
            wanted = options.tools.split(",")
            rows = {name: run(command, text, options.limit) for name, (command, text) in tools.items() if name in wanted}
            reference = {"profile": lambda: sqrt(pi) * gamma(mpf(11) / 8) / gamma(mpf(15) / 8), "pole": lambda: mpf(10),
                         "root": lambda: mpf(2) / 3, "area": lambda: None}[case]()
            if reference is None:  # the certified value, of 20 digits more
                better = run([options.program, "ours", case, str(digits + 20)], None, options.limit)
                reference = mpf(re.match(r"\S+ \S+ \[?([0-9.]+(?:e[-+]?[0-9]+)?)", better).group(1))
            print(f"\n{CASES[case]}, {digits} digits")
            print(f"  {'tool':8s} {'cold ms':>11s} {'warm ms':>11s} {'digits':>7s}   cold/ours  warm/ours")
            base = None
            for name, line in rows.items():
                if line is None:
                    print(f"  {name:8s} no answer in {options.limit:g} s")
                    continue
                if line.startswith("failed"):
                    print(f"  {name:8s} {line}")
                    continue
                cold, warm, value = line.split(" ", 2)
                cold, warm = float(cold), float(warm)
                if value.startswith("refused"):
                    print(f"  {name:8s} {cold:11.3f} {warm:11.3f}    none   {value}")
                    continue
                if name == "ours":
                    base = (cold, warm)
                good = min(correct_digits(value, reference), digits)
                right = "" if good >= digits - 3 else "   WRONG or short"
                ratio = f"{cold / base[0]:9.2f}x {warm / base[1]:9.2f}x" if base else ""
                print(f"  {name:8s} {cold:11.3f} {warm:11.3f} {good:7d}  {ratio}{right}")
            sys.stdout.flush()


if __name__ == "__main__":
    main()
