#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/peers.md from docs/peers.json: python3 tests/bench/peers/page.py docs/peers.json > docs/peers.md"""
import json
import statistics
import sys
from collections import Counter

COMMAND = """    cmake --build build/test --target touchstone_program bench_peers
    python3 tests/bench/peers/peers.py build/test"""


def seconds(x):
    if x >= 100:
        return f"{x:.0f} s"
    if x >= 0.1:
        return f"{x:.3g} s"
    return f"{1e3 * x:.2g} ms"


def spread(entry, show=seconds):
    """The median, and least to most."""
    if "stopped" in entry:
        return f"more than {entry['stopped']} s"
    if "refused" in entry:
        return entry["refused"]
    runs = "" if entry.get("runs", 5) == 5 else f", {entry['runs']} run{'s' if entry['runs'] > 1 else ''}"
    return f"{show(entry['median'])} ({show(entry['least'])} to {show(entry['most'])}{runs})" if entry.get("runs", 5) > 1 else f"{show(entry['median'])} (1 run)"


def ratio(entry, ours):
    if not ours or "median" not in ours or not ours["median"]:
        return ""
    if "stopped" in entry:
        return f"more than {entry['stopped'] / ours['median']:.3g}"
    return f"{entry['median'] / ours['median']:.3g}" if "median" in entry else ""


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return lines + ["| " + " | ".join(str(cell).replace("|", "\\|") for cell in row) + " |" for row in rows] + [""]


def memory(entry):
    if "megabytes" not in entry:
        return ""
    return f"{entry['megabytes']:.0f}" if entry["megabytes"] > 20 else "small"


def right(entry):
    if "right" not in entry or "median" not in entry:
        return ""
    digits = 15 if "doubles" in entry["tool"] else entry["digits"]
    if entry["right"] >= digits - 1:  # the last one may be rounded either way
        return f"all {digits}"
    return f"{entry['right']} of {digits}" + ("" if entry["right"] >= digits - 3 else " **wrong**")


# ---- (a)
def constant(item):
    rows, lines = [], []
    for entry in item["rows"]:
        ours = next(r for r in item["rows"] if r["size"] == entry["size"] and r["tool"] == "Touchstone")
        rows.append([entry["size"], entry["tool"], spread(entry), ratio(entry, ours), right(entry), memory(entry)])
    lines += ["The program from its start against the plain product (7.13) of 3.3 factors a digit, two Gamma functions each, as one would write it with mpmath, with GP, with `arb_gamma` (in balls, what is left out bounded).", ""]
    lines += table(["digits", "tool", "user CPU", "times ours", "right digits", "MB"], rows)
    gammas = [f"{r['gammas']:.0f} at {r['size']} digits" for r in item["rows"] if "gammas" in r]
    if gammas:
        lines += [f"Limit: what Touchstone takes, start and second proof included, is as long as these many evaluations of `arb_gamma` (tables of Bernoulli numbers there already): {', '.join(gammas)}. "
                  "The plain product takes 6.6 for each digit. No way to K_∞ without a single Gamma function is known to us, so that this is how far above the limit we are.", ""]
    return lines


# ---- (b)
def points(item):
    rows = []
    for entry in item["rows"]:
        ours = next(r for r in item["rows"] if r["quantity"] == entry["quantity"] and r["tool"] == "Touchstone, library")
        per = lambda x, n=entry["points"]: f"{1e6 * x / n:.3g} µs"
        wrong = entry.get("wrong", "")
        rows.append([entry["quantity"], entry["tool"], spread(entry, per), ratio(entry, ours), f"**{wrong}**" if wrong else wrong])
    count = item["rows"][0]["points"]
    return [f"{count} points (p, load) in partial contact, binary64 numbers, a tenth of them within 10^-6 of the highest pressure; the answer is to be the nearest binary64 number. "
            "Touchstone proves each: for arrays (`touchstone_eval_rows`) in 106 bits with their error carried along, and in balls what those leave open; for `eval --rows` in balls, twice, with status, digits and text. "
            "The peers evaluate (2.17) and (2.19) as printed in so many digits and round, and prove nothing.", ""] + table(
                ["", "tool", "user CPU a point", "times ours", "not the nearest"], rows) + [
        "Near the highest pressure the printed forms lose half of their digits, so 25 are sometimes too few; how many would do is what a peer's user has to know.", ""]


# ---- (c)
def cell(entry):
    if "right" not in entry and entry.get("verdict") != "refused":
        return ""
    if entry["verdict"] == "refused":
        return "over time" if entry.get("refused", "").startswith("not done") else "no function" if entry["refused"].startswith("has no") else "refused"
    shown = f"{entry['median']:.3g}"
    return shown if entry["verdict"] == "right" else f"**wrong** ({entry['right']} digits, {shown})"


def best(row):
    times = {tool: e["median"] for tool, e in row["tools"].items() if e["verdict"] == "right"}
    return min(times, key=times.get) if times else None


def integrals(item):
    lines = ["The integrals of `tests/quadrature/public_integrals.txt` (Bailey's, Kahaner's, QUADPACK's, Boost.Math's, mpmath's, Arb's and PARI's; three with jumps or with a kink at a root without a name are left out), "
             "and (6.7) at n = 1. Touchstone gets each formula as typed, every other tool what a competent user would make of it (`tests/bench/peers/integrals.txt`): the distance to a singular end as the "
             "variable, cuts at kinks, PARI's codes for ends, `quadosc` for waves. Touchstone is asked through `integrate`, (6.7) through the header.", "",
             "Right: all but at most the last three digits agree with the closed form (where there is none: with a certified value of 20 digits more). Wrong: fewer do, and the tool does not say so. "
             "Refused: no value, or its own estimate of the error is too large. Over time: stopped after " + ", ".join(f"{s} s ({d} digits)" for d, s in item["limits"].items()) + " of CPU. Milliseconds in the process, medians of five batches after a first call; of tools within 2.5 times the fastest the medians of 21 such processes that took turns (of five where no end is singular), "
             "of fewer where they would take over 2 s; Boost at 15 digits and GSL are in doubles. All integrals at 50 digits; at other digits some of them.", ""]
    sizes = sorted({r["digits"] for r in item["rows"]})
    for digits in sizes:
        here = [r for r in item["rows"] if r["digits"] == digits]
        names = list(here[0]["tools"])
        wins = Counter(best(r) for r in here)
        end_wins = Counter(best(r) for r in here if r["kind"] == "end")
        rows = []
        for tool in names:
            found = [r["tools"][tool] for r in here]
            verdicts = Counter("over time" if e["verdict"] == "refused" and e.get("refused", "").startswith("not done") else e["verdict"] for e in found)
            both = [r["tools"][tool]["median"] / r["tools"]["Touchstone"]["median"] for r in here
                    if r["tools"][tool]["verdict"] == "right" == r["tools"]["Touchstone"]["verdict"]]
            rows.append([tool, verdicts["right"], verdicts["refused"], verdicts["over time"], f"**{verdicts['wrong']}**" if verdicts["wrong"] else 0, wins[tool], end_wins[tool],
                         f"{statistics.median(both):.3g}" if both and tool != "Touchstone" else ""])
        ends = sum(r["kind"] == "end" for r in here)
        lines += [f"**{digits} digits**, {len(here)} integrals, {ends} of them singular at an end:", ""]
        lines += table(["tool", "right", "refused", "over time", "wrong", "fastest of the right", "so at singular ends", "time over ours, median"], rows)
    wrong = [[tool, r["name"], f"`{r['formula']}`", f"{r['from']} to {r['to']}" if r["from"] else "", r["digits"], e["right"], e["value"][:12]] for r in item["rows"] for tool, e in r["tools"].items() if e["verdict"] == "wrong"]
    lines += ["### Short or wrong without a word", ""] + table(["tool", "", "formula", "range", "digits asked", "right", "its answer begins"], wrong)
    lines += ["Boost and GSL at 15 digits miss some by their last digits only: what they were asked for is the whole precision of a double.", ""] if any(w[4] == 15 for w in wrong) else []
    for digits in sizes:
        here = [r for r in item["rows"] if r["digits"] == digits and r["kind"] == "end"]
        if digits == 15:
            continue
        names = list(here[0]["tools"])
        rows = [[r["name"], f"`{r['formula']}`" if r["name"] != "area" else r["formula"], *(f"*{cell(r['tools'][t])}*" if best(r) == t else cell(r["tools"][t]) for t in names)] for r in here]
        lines += [f"### Singular ends, {digits} digits", "", "Milliseconds; the fastest of the right ones in italics.", ""] + table(["", "formula", *names], rows)
    return lines


# ---- (d), (e), (f)
def nested(item):
    ours = item["rows"][0]
    rows = [[r["tool"], spread(r), ratio(r, ours), right(r), memory(r)] for r in item["rows"]]
    return ["A_2 at load 1/10, G = √10: an integral in an integral for the peers, the recursion and two proofs for Touchstone.", ""] + table(["tool", "user CPU", "times ours", "right digits", "MB"], rows)


def areas(item):
    rows = [[r["what"], r["tool"], r["asked"], spread(r), f"{r['proven']} of {r['values']} proven" if "proven" in r else right(r), memory(r)] for r in item["rows"]]
    lines = ["Loads 0.001, 0.01, 0.1, 0.5, 1; the four sets are those of figures 3 and 5 and one more. At D = 1.05 (G = 1.08 and 1.12) waves of full contact come in and the integrands have singular points inside: GSL's integrals are cut there, the other peers' A_3 is asked for where there are none.", ""]
    lines += table(["what", "tool", "digits", "user CPU", "right digits", "MB"], rows)
    limit = item["entries"]
    if limit.get("nodes"):
        floor = limit["nodes"] ** 2 * 20 * limit["nanoseconds"] * 1e-9
        first = next((r for r in item["rows"] if r.get("asked") == 50 and r["tool"] == "Touchstone" and "median" in r), None)
        lines += [f"Limit: {limit['nodes']} nodes at 50 digits, so {limit['nodes']}² entries of the operator; 20 scales with one multiplication an entry, {limit['nanoseconds']:.0f} ns each with Arb at {limit['bits']} bits, are {seconds(floor)}"
                  + (f". The 105 areas of one set take {first['median'] / floor:.1f} times that, the entries themselves, their error bounds and a second proof on another grid included." if first else "."), ""]
    return lines


def densities(item):
    ours = item["rows"][0]
    rows = []
    for r in item["rows"]:
        done = f"{r.get('done', item['points'])} of {item['points']}"
        rows.append([r["tool"], spread(r), ratio(r, ours), done, r.get("right", "")])
    return [f"q_2 at {item['points']} pressures, load 1/10, G = √10, 20 digits: two nested integrals of the closed forms for the peers, singular ends taken away by hand.", ""] + table(
        ["tool", "user CPU", "times ours", "rows", "right digits, fewest"], rows)


# ---- (g)
def doubles(item):
    rows = []
    for r in item["rows"]:
        printed = next(x for x in item["rows"] if x["form"] == r["form"] and x["tool"] == "printed")
        rows.append([f"`{r['form']}` ({r['equation']})", {"ours": "Touchstone", "printed": "as printed", "gsl": "with GSL's functions"}[r["tool"]],
                     f"{r['median']:.1f} ({r['least']:.1f} to {r['most']:.1f})", f"{r['median'] / printed['median']:.2f}", f"{r['ulps']:.1f}" if r["ulps"] < 100 else f"**{r['ulps']:.1e}**"])
    return ["One thread, loops over 70 000 points, a tenth of them within 10^-6 of an edge. Errors in ulps beyond what half an ulp of each input forces, at a thousand of the points.", ""] + table(
        ["form", "", "ns a value", "times as printed", "largest error, ulps"], rows)


def costs(item):
    rows = []
    for s in item["rows"]:
        rows.append([f"`{s['what'].split(',')[0]}`{',' + ','.join(s['what'].split(',')[1:]) if ',' in s['what'] else ''}", s["variable"], ", ".join(f"{n}" for n in s["sizes"]),
                     ", ".join(seconds(t) for t in s["seconds"]), f"{s['exponent']:.2f}", ", ".join("small" if m <= 20 else f"{m:.0f}" for m in s["megabytes"])])
    return ["The least of three runs, start of the program included; the exponent is that of the power law that fits all of them best.", ""] + table(["what", "against", "", "user CPU", "exponent", "MB"], rows)


SECTIONS = {"a": ("K_∞ to 100, 1000 and 10 000 digits", constant), "b": ("Q and q correctly rounded", points), "c": ("Singular integrals", integrals), "d": ("One nested area", nested),
            "e": ("All areas, and a peer's A_3", areas), "f": ("A table of densities", densities), "g": ("Double forms", doubles), "cost": ("How cost and memory grow", costs)}


# ---- what was aimed at
def goals(items):
    rows = []

    def goal(letter, text, measured, met, why=""):
        rows.append([f"({letter})", text, measured, "met" if met else "missed" + (f": {why}" if why else "")])

    if "a" in items:
        for size, tool in ((1000, "mpmath"), (1000, "PARI/GP")):
            found = {r["tool"]: r for r in items["a"]["rows"] if r["size"] == size}
            if "median" in found.get("Touchstone", {}) and tool in found:
                r = found[tool]
                factor = r.get("median", r.get("stopped", 0)) / found["Touchstone"]["median"]
                goal("a", f"{size} digits, 500 times faster than {tool}'s plain product", ("" if "median" in r else "more than ") + f"{factor:.0f} times", factor >= 500,
                     "the start of the program, the second proof and rounding count on our side" if "median" in r else f"not decided, the peer was stopped after {r.get('stopped')} s")
        longest = next((r for r in items["a"]["rows"] if r["size"] == 10000 and r["tool"] == "Touchstone"), None)
        if longest:
            goal("a", "10 000 digits in 8 s", spread(longest), longest.get("median", 1e9) <= 8)
    if "b" in items:
        for quantity in sorted({r["quantity"] for r in items["b"]["rows"]}):
            found = {r["tool"]: r for r in items["b"]["rows"] if r["quantity"] == quantity}
            peer = next((r for t, r in found.items() if t.startswith("mpmath") and r.get("wrong") == 0), None) or found.get("mpmath, 40 digits")
            ours = found["Touchstone, library"]
            if peer and "median" in peer and "median" in ours:
                factor = peer["median"] / ours["median"]
                goal("b", f"{quantity}: 50 times faster a point than mpmath", f"{factor:.1f} times", factor >= 50,
                     "reading and writing the numbers as text, and the start of the program, count on our side")
    if "c" in items:
        for digits in sorted({r["digits"] for r in items["c"]["rows"]}):
            here = [r for r in items["c"]["rows"] if r["digits"] == digits and r["kind"] == "end"]
            ours = sum(best(r) == "Touchstone" for r in here)
            others = Counter(best(r) for r in here if best(r) != "Touchstone")
            why = "the others: " + ", ".join(f"{tool} {n}" for tool, n in others.most_common()) + (
                "; in doubles an evaluation costs nanoseconds" if digits == 15 else "")
            goal("c", f"{digits} digits, fastest of the right ones at every singular end", f"{ours} of {len(here)}", ours == len(here), why)
        for digits in sorted({r["digits"] for r in items["c"]["rows"]}):
            refused = [r["name"] for r in items["c"]["rows"] if r["digits"] == digits and r["tools"]["Touchstone"]["verdict"] != "right"]
            goal("c", f"{digits} digits, nothing refused that is analytic inside", f"{len(refused)} refused" + (f" ({', '.join(refused)})" if refused else ""), not refused)
    if "e" in items:
        ours = [r for r in items["e"]["rows"] if r["tool"] == "Touchstone" and "median" in r]
        same = [r for r in items["e"]["rows"] if r.get("same_loads")]
        if ours and same and all("median" in r for r in same):
            total, peer = (sum(r["median"] for r in rows) for rows in ([r for r in ours if r["asked"] <= 15], same))
            goal("e", "all areas of all four sets in less than a peer's A_3 at the same loads and sets takes, 15 digits (6 at D = 1.05)", f"{seconds(total)} against {seconds(peer)} of {same[0]['tool']}", total < peer)
        for digits in sorted({r["asked"] for r in items["e"]["rows"] if r["tool"] != "Touchstone" and not r.get("same_loads")}):
            peers = [r for r in items["e"]["rows"] if r["tool"] != "Touchstone" and r["asked"] == digits and not r.get("same_loads") and ("median" in r or "stopped" in r)]
            if ours and peers:
                least = min(peers, key=lambda r: r.get("median", r.get("stopped")))
                quickest = least.get("median", least.get("stopped"))
                here = [r for r in ours if r["asked"] == digits]
                all_sets = here + [r for r in ours if r["asked"] < 15] if here else ours  # those at D = 1.05 are to 6 digits in either case
                total = sum(r["median"] for r in all_sets)
                one = f"a peer's A_3 at one load of one set, {digits} digits"
                if here and digits == 15:
                    most = max(here, key=lambda r: r["median"])
                    goal("e", f"all areas of either set at D = 3/2 in less than {one}", f"{spread(most)} against {spread(least)} of {least['tool']}", most["median"] < quickest)
                why = ("in doubles and without a proof three nested sums are quick where nothing is singular; ours are 420 proven areas, " +
                       ("those at D = 1.05, with waves in full contact, take most of it" if here else "half of them to 50 digits"))
                goal("e", f"all areas of all four sets in less than {one}", f"{seconds(total)} against {spread(least)} of {least['tool']}", total < quickest,
                     why if "median" in least else f"not decided, the peers were stopped after {least['stopped']} s")
    if "g" in items:
        for r in items["g"]["rows"]:
            if r["tool"] == "ours":
                printed = next(x for x in items["g"]["rows"] if x["form"] == r["form"] and x["tool"] == "printed")
                factor = r["median"] / printed["median"]
                why = f"the printed form is {printed['ulps']:.0e} ulps off at the edges, and has fewer operations" if printed["ulps"] > 100 else "the printed form has fewer operations"
                goal("g", f"`{r['form']}` at most 1.5 times the printed form's time", f"{factor:.2f}", factor <= 1.5, why)
    return table(["", "goal", "measured", ""], rows)


def text(results):
    items = {key: results["items"][key] for key in SECTIONS if key in results["items"]}
    lines = ["# Side by side with the peers", "",
             "This page is written by a program from what it measured ([peers.json](peers.json)); `tests/bench/peers/page.py docs/peers.json` writes it again without measuring.", "", COMMAND, "",
             f"Machine: {results['machine']}, shared with other work, so only times of the same run compare. User CPU; medians of five runs (least to most), of as few as are named where they take seconds (since 2026-11-27 each of the five is a mean of twenty where one takes less than 0.1 s: CPU is counted in ticks), and never the wall's clock unless it is said. "
             "Processes with their start, unless it is said. Memory is the largest resident set; `small` is no more than that of the measuring program, which hides it.", "",
             "; ".join(f"{name} {version}" for name, version in results["versions"].items()) + ".", "", "## What was aimed at", ""] + goals(items)
    absent = [f"({key}) {SECTIONS[key][0]}" for key in SECTIONS if key not in items]
    if absent:
        lines += ["Not measured on this page: " + "; ".join(absent) + ".", ""]
    for key, item in items.items():
        title, section = SECTIONS[key]
        lines += [f"## {title}", "", f"Measured on {item['date']}.", ""] + section(item)
    return "\n".join(lines).rstrip() + "\n"


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as stored:
        sys.stdout.write(text(json.load(stored)))
