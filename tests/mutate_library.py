#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Change a sign, an operation, a comparison or a constant in a source of the library, one at a time, and see whether its tests find it.

usage: mutate_library.py SOURCE BUILD SCRATCH [--area NAME] [--count N] [--seed 1] [--only PATH-PART] [--listed FILE] [--dearest SECONDS]
       [--seconds S] [--jobs 1] [--believe] [--list]

BUILD is a build of SOURCE with its tests. All changes drawn of an area (AREAS) are compiled at once into copies of its sources, and switched on at run
time (proofs/source_mutants/switch.hpp); these objects and the area's tests, which are compiled anew where they include a changed header, make one
program. judge.cpp asks for each change the test cases that come by it, those of least time first and none that takes more than --dearest seconds,
each with a limit of time (a change that makes a loop endless is found). A change that cannot be switched, or that nobody came by, is compiled alone:
where it compiles, and could not be switched or stands in a constant expression, all tests are run, otherwise no test reaches it and it survives.
Survivors are listed, unless library_equivalent_changes.json says why the change changes nothing that is claimed; exit code 1 if there is any. A
sample of --count is drawn from each area, or all of it, and judged in the order drawn, which the seed decides: what is done when --seconds have
passed is a fair sample too (not with --believe, where excuses come first). With --list the changes are only shown, with --listed those are judged whose
lines FILE has, with --believe no tests are run for those that are excused.

The operands of && and || stay those they are: a && b && c becomes (a && b) || c and (a || b) && c. What a change of the formulas in
lib/touchstone/paper/*.hpp and wave/*.hpp and of proofs/ does: proofs/mutate_sources.py.
"""
import argparse
import bisect
import collections
import concurrent.futures
import functools
import itertools
import json
import math
import os
import pathlib
import random
import re
import shlex
import shutil
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "proofs"))
import mutate_sources  # noqa: E402


class Area:
    """Sources that are changed, users compiled with their changed headers, the test programs that are to find the changes."""

    def __init__(self, sources, tests, users=()):
        self.sources, self.tests, self.users = sources, tests, users


AREAS = {
    "scalar": Area(["scalar/*"], ["scalar", "rounding", "double_double", "four_arithmetics", "formulas", "double_accuracy", "westergaard_nearest", "binary64"],
                   ["paper/westergaard_nearest.cpp"]),
    "rounding": Area(["rounding/*"], ["rounding", "named_inputs", "table", "catalogue"]),
    "paper": Area(["paper/*.cpp"], ["formulas", "gap", "double_accuracy", "westergaard_nearest", "catalogue"]),
    "quadrature": Area(["quadrature/*"], ["quadrature", "typed_formulas", "public_integrals", "quadrature_second_routes"]),
    "first_steps": Area(["recursion/first_steps/*", "recursion/light_load.cpp"], ["first_steps", "methods"]),
    "from_the_edge": Area(["recursion/from_the_edge/*"], ["boxes", "transfer"]),
    "levels": Area(["transfer/proven_levels*", "transfer/two_waves*", "transfer/three_waves*", "transfer/arc.hpp",
                    "transfer/ellipse_cover.hpp", "transfer/level_bounds.hpp", "wave/*.cpp"], ["proven_levels", "three_waves"]),
    # the discretised operator of partial contact, and the first scales of heavy loads
    "operator": Area(["transfer/carried_errors*", "transfer/chain*", "transfer/coefficients*", "transfer/contact*", "transfer/discretisation*",
                      "transfer/fixed*", "transfer/gauss.hpp", "transfer/heavy_load*", "transfer/moments*", "transfer/row_budget*", "transfer/rule*",
                      "transfer/series*", "transfer/wide_balls.hpp"], ["transfer", "heavy_load"]),
    # what proves levels on meshes with full contact; how these are found (collocation, piecewise) and estimates (graded, full_contact) prove nothing
    "defects": Area(["transfer/defects*", "transfer/layer*", "transfer/level_zero*", "transfer/step_defect*", "transfer/wave_kernel*"],
                    ["layer", "proven_levels", "three_waves"]),
    # one wave of the estimates with full contact, which no proof uses
    "estimates": Area(["transfer/wave.hpp"], ["full_contact"], ["transfer/full_contact.cpp", "transfer/graded.cpp", "transfer/piecewise.cpp"]),
    "limit": Area(["limit/*"], ["limit", "rows"]),
    "disc": Area(["transfer/disc.hpp"], ["binary64"]),
}
COMPARISONS = [(r" <( |$)", " <= "), (r" >( |$)", " >= "), (r" <=( |$)", " < "), (r" >=( |$)", " > "), (r" &&( |$)", " || "), (r" \|\|( |$)", " && ")]
# What changes no value: includes, comments, names of types, precisions of balls.
NO_VALUE = re.compile(r"^\s*(#|//|/\*|\*|using)|template|requires|static_assert|WorkingPrecision|constexpr (slong|int|long) (digits|bits)")
CONSTANT = re.compile(r"\bconstexpr\b|\bcase\b|\benum\b|^\s*(static |inline )*const\b|<[^<>]*\d[^<>]*>")
OPTIONS = ["-O1", "-w", "-Wno-narrowing", "-D_GLIBCXX_ASSERTIONS"]  # an element beyond the last is an end, not a number
ALONE_SECONDS = 1800


class Change(mutate_sources.Change):
    """A change with its operands' places in the whole text, where it is one of && and ||."""

    def pieces(self, text, start, number=None):
        """What to put in the place of what: (first, last, new) in the text of the whole file, switched by `number` or made for good."""
        at = start + self.column
        end = at + len(self.old)
        plain = self.old.strip()
        if plain in ("&&", "||"):
            left, right = operands(text, at, end, plain)
            if number is None:
                return [(left, left, "(("), (at, end, ")" + self.new + "("), (right, right, "))")]
            on = f"mutant::on({number})"
            then, last = ("? bool(", f") : {on})") if plain == "&&" else (f"? !{on} : bool(", "))")
            return [(left, left, "(bool("), (at, end, f") != {on} {then}"), (right, right, last)]
        if number is None:
            return [(at, end, self.new)]
        if plain in ("<", ">", "<=", ">="):
            return [(at, end, f" {plain} mutant::Compared{{{number}}} {plain} ")]
        return [(at, end, self.switched(number))]


def bare(text):
    """The text with comments blank and strings one word, every character in its place."""
    return re.sub(r'//[^\n]*|"(\\.|[^"\\\n])*"|\'(\\.|[^\'\\\n])\'', lambda m: (" " if m.group().startswith("//") else "_") * len(m.group()), text)


def operands(text, at, end, operation):
    """Where the operands of the && or || at [at, end) begin and end."""
    code = bare(text)
    bounds = r"[;,?]|(?<!:):(?!:)|(?<![=!<>])=(?!=)|\breturn\b"
    before = re.compile(bounds + (r"|\|\|" if operation == "&&" else ""))
    after = re.compile(bounds + r"|\|\|" + ("|&&" if operation == "&&" else ""))
    depth, left = 0, at
    while left > 0:
        c = code[left - 1]
        depth += (c in ")]}") - (c in "([{")
        if depth < 0 or (depth == 0 and any((m := before.match(code, left - n)) and m.end() == left for n in (1, 2, 6))):
            break
        left -= 1
    depth, right = 0, end
    while True:
        c = code[right]
        depth += (c in "([{") - (c in ")]}")
        if depth < 0 or (depth == 0 and after.match(code, right)):
            break
        right += 1
    return left + len(code[left:at]) - len(code[left:at].lstrip()), end + len(code[end:right].rstrip())


def put(text, pieces):
    """The text with pieces (first, last, new, order at one place) put in."""
    out, done = [], 0
    for first, last, new, _ in sorted(pieces, key=lambda p: (p[0], p[3])):
        out += [text[done:first], new]
        done = last
    return "".join(out) + text[done:]


def line_starts(text):
    return list(itertools.accumulate((len(line) for line in text.splitlines(keepends=True)), initial=0))


def rewritten(text, changes):
    """The text of a source with changes (number, change) made: switched, or for good where number is None."""
    starts, pieces = line_starts(text), []
    for number, c in changes:
        made = c.pieces(text, starts[c.line], number)
        if len(made) == 1:
            pieces.append((*made[0], (1, 0)))
            continue
        # at one place what ends is closed before anything opens, the innermost first; what begins opens the outermost first
        (left, _, _), middle, (right, _, _) = made
        pieces += [(*made[0], (0, -right)), (*middle, (1, 0)), (*made[2], (-1, -left))]
    return put(text, pieces)


def lines_of(text, change):
    """The lines that a change is written into."""
    starts = line_starts(text)
    return {bisect.bisect_right(starts, first) - 1 for first, _, _ in change.pieces(text, starts[change.line])}


def in_constant_expression(text, change):
    """Whether the change stands in what the compiler computes: on a line that says so, or in the block that a constant's definition begins."""
    lines = text.splitlines()
    depth = lambda line: len(line) - len(line.lstrip())
    if CONSTANT.search(lines[change.line]):
        return True
    least = depth(lines[change.line])
    for line in reversed(lines[:change.line]):
        if line.strip() and depth(line) < least:
            least = depth(line)
            if re.search(r"\bconstexpr\b[^(]*=|\benum\b", line):
                return True
    return False


def files_of(source, area):
    return sorted({p.relative_to(source) for pattern in AREAS[area].sources for p in source.glob("lib/touchstone/" + pattern) if p.suffix in (".cpp", ".hpp")})


def changes_in(source, path):
    for line, text in enumerate((source / path).read_text().splitlines()):
        if NO_VALUE.search(text):
            continue
        code = mutate_sources.masked(text)
        for old, new in mutate_sources.PATTERNS + COMPARISONS:
            for m in re.finditer(old, code):
                yield Change(path, line, m.start(), m.group(), new or str(int(m.group(1)) + 1), text)


class Program:
    """The judge with what it links, made of an area's changed sources and its tests."""

    def __init__(self, o, area):
        self.o, self.area = o, AREAS[area]
        self.tree, self.objects = o.scratch / area / "tree", o.scratch / area / "objects"
        self.objects.mkdir(parents=True, exist_ok=True)
        self.here = o.source / "tests/proofs/source_mutants"
        self.known = {}
        for c in json.loads(subprocess.run(["ninja", "-C", o.build, "-t", "compdb"], capture_output=True, text=True, check=True).stdout):
            if c["output"].endswith(".o"):
                self.known[c["output"]] = (pathlib.Path(c["file"]), c["command"])
        self.cache = [shutil.which("ccache")] if shutil.which("ccache") else []

    def library(self, path):
        """The object of BUILD made of a source of the library."""
        return next(out for out, (file, _) in self.known.items() if file == self.o.source / path and out.startswith("lib/"))

    def tests(self):
        return [out for out, (file, _) in self.known.items() for test in self.area.tests if f"/test_{test}.dir/" in out and file.name != "doctest_main.cpp"]

    def includes(self, output):
        deps = subprocess.run(["ninja", "-C", self.o.build, "-t", "deps", output], capture_output=True, text=True, check=True).stdout
        return {os.path.normpath(self.o.build / line.strip()) for line in deps.splitlines()[1:]}

    def compiled(self, output, to, tree, source=None):
        """Compile an object of BUILD anew, from `source` or its own, with the headers of `tree` before all others."""
        file, command = self.known[output]
        words = shlex.split(command)
        words = words[next(i for i, w in enumerate(words) if re.search(r"(\+\+|clang)[-\d]*$", w)):]
        kept, skip = [], False
        for w in words[1:]:
            if skip:
                skip = False
            elif w in ("-o", "-c", "-MF", "-MT"):
                skip = True
            elif w != "-MD":
                kept.append(w)
        copy = tree / file.relative_to(self.o.source)
        source = source or (copy if copy.exists() else file)
        words = [*self.cache, words[0], f"-I{tree}/lib", *kept, *OPTIONS, "-include", str(self.here / "switch.hpp"), "-c", str(source), "-o", str(to)]
        # a header that is new, and found before the one that was, is not seen by a cache that looks at the old one alone
        done = subprocess.run(words, cwd=self.o.build, capture_output=True, text=True, env={**os.environ, "CCACHE_NODIRECT": "1"})
        return done.returncode, done.stderr

    def libraries(self):
        """What the tests' programs are linked with."""
        words = []
        for test in self.area.tests:
            done = subprocess.run(["ninja", "-C", self.o.build, "-t", "commands", f"test_{test}"], capture_output=True, text=True, check=True)
            lines = done.stdout.splitlines()
            link = shlex.split(next(line for line in lines if re.search(rf" -o tests/(\w+/)?test_{test}( |$)", line)).replace("&& :", "").replace(": &&", ""))
            words += [w for w in link[link.index("-o") + 2:] if not w.endswith(".o") and w not in words]
        return words

    def link(self, objects, to):
        compiler = next(w for w in shlex.split(next(iter(self.known.values()))[1]) if re.search(r"(\+\+|clang)[-\d]*$", w))
        done = subprocess.run([compiler, *map(str, objects), "-Wl,--start-group", *self.libraries(), "-Wl,--end-group", "-o", str(to)], cwd=self.o.build,
                              capture_output=True, text=True)
        if done.returncode:
            sys.exit("cannot link the judge: " + done.stderr[-2000:])
        return to

    def judge_object(self):
        to = self.objects / "judge.o"
        code, errors = self.compiled(self.tests()[0], to, self.tree, self.here / "judge.cpp")
        if code:
            sys.exit("the judge does not compile: " + errors[:2000])
        return to

    @functools.cache
    def text(self, path):
        return (self.o.source / path).read_text()

    def write(self, switched):
        by_file = collections.defaultdict(list)
        for number, c in switched.items():
            by_file[c.path].append((number, c))
        for path, changes in by_file.items():
            target, text = self.tree / path, rewritten(self.text(path), changes)
            target.parent.mkdir(parents=True, exist_ok=True)
            if not target.exists() or target.read_text() != text:
                target.write_text(text)
        return set(by_file)

    def units(self, changed):
        """What is compiled, by its object in BUILD: the changed sources, and who includes a changed header. Other tests' objects are BUILD's."""
        headers = {str(self.o.source / p) for p in changed if p.suffix == ".hpp"}
        sources = {p for p in self.everywhere() if p.suffix == ".cpp"}
        library = [self.library(p) for p in sorted(sources)]
        return [u for u in library if self.known[u][0].relative_to(self.o.source) in changed or headers & self.includes(u)] + [
            u for u in self.tests() if headers & self.includes(u)]

    def everywhere(self):
        users = {p.relative_to(self.o.source) for pattern in self.area.users for p in self.o.source.glob("lib/touchstone/" + pattern)}
        return users | {p.relative_to(self.o.source) for pattern in self.area.sources for p in self.o.source.glob("lib/touchstone/" + pattern)}

    def build(self, switched):
        """Compile everything; what does not compile as a switch is taken out of `switched`, and remembered. The objects to link, by unit."""
        memory = self.objects.parent / "cannot_be_switched"
        remembered = set(memory.read_text().splitlines()) if memory.exists() else set()
        for n in [n for n, c in switched.items() if f"{c} in {c.text}" in remembered]:
            del switched[n]
        all_units = self.units(self.write(switched))
        place = lambda u: self.objects / u.replace("/", "_")
        waiting = all_units
        while waiting:
            with concurrent.futures.ThreadPoolExecutor(self.o.jobs) as pool:
                done = list(pool.map(lambda u: self.compiled(u, place(u), self.tree), waiting))
            wrong = [u for u, (code, _) in zip(waiting, done) if code]
            out = set()
            for u in wrong:
                errors = dict(zip(waiting, done))[u][1]
                named = {(name, int(line) - 1) for name, line in re.findall(rf"{re.escape(str(self.tree))}/([^:\s]+):(\d+)", errors)}
                here = {n for n, c in switched.items() if any((str(c.path), line) in named for line in lines_of(self.text(c.path), c))}
                if not here:
                    sys.exit(f"{u} does not compile, with no change in the lines named:\n{errors[:3000]}")
                out |= here
            with memory.open("a") as known:
                known.writelines(f"{switched[n]} in {switched[n].text}\n" for n in out)
            changed = {switched.pop(n).path for n in out}
            self.write(switched)
            for path in changed - {c.path for c in switched.values()}:
                (self.tree / path).unlink()
            waiting = all_units if any(p.suffix == ".hpp" for p in changed) else wrong
            print(f"# {len(all_units) - len(wrong)} of {len(all_units)} compiled, again without {len(out)} changes that cannot be switched", flush=True)
        return {**{u: self.o.build / u for u in self.tests()}, **{u: place(u) for u in all_units}}

    def alone(self, objects, change, compiles):
        """A change that is compiled: (verdict, by whom). What compiles as a switch and is no constant is not asked again whether it does, but for
        operations: a switch leaves as it is what has no other, as texts that are added."""
        scratch = self.objects.parent / "alone"
        shutil.rmtree(scratch, ignore_errors=True)
        copy = scratch / "tree" / change.path
        copy.parent.mkdir(parents=True)
        copy.write_text(rewritten(self.text(change.path), [(None, change)]))
        header = change.path.suffix == ".hpp"
        users = [u for u in {*objects, *map(self.library, sorted(p for p in self.everywhere() if p.suffix == ".cpp"))}
                 if (str(self.o.source / change.path) in self.includes(u) if header else self.known[u][0] == self.o.source / change.path)]
        made = dict(objects)
        constant = in_constant_expression(self.text(change.path), change)
        if compiles and not constant and change.old.strip() not in ("+", "-", "*", "/"):
            return "survives", "no test reaches it"
        for u in users[:1] if compiles and not constant else users:
            made[u] = scratch / u.replace("/", "_")
            code, _ = self.compiled(u, made[u], scratch / "tree")
            if code:
                return "does not compile", "-"
        if not constant and compiles:
            return "survives", "no test reaches it"
        judge = self.link([self.objects / "judge.o", *made.values()], scratch / "judge")
        try:
            told = subprocess.run([str(judge), "--plain"], cwd=self.o.build / "tests", capture_output=True, text=True, timeout=ALONE_SECONDS)
        except subprocess.TimeoutExpired:
            return "found", "a judge that does not end"
        return ("found", told.stderr.strip().splitlines()[-1] if told.stderr.strip() else "a crash") if told.returncode else ("survives", "-")

    def judged(self, objects, numbers, switched, everything):
        """(number, (verdict, by whom)) for one after the other, until --seconds have passed: by the judge, or alone where it cannot say."""
        judge = self.link([self.judge_object(), *objects.values()], self.objects.parent / "judge")
        environment = {**os.environ, "TOUCHSTONE_DEAREST": str(self.o.dearest)}
        end = math.inf  # until the first answer: before it, who comes by what is asked
        with subprocess.Popen([str(judge)], cwd=self.o.build / "tests", env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as running:
            for n in numbers:
                if time.monotonic() > end:
                    break
                result = ("unreached", "-")
                if n in switched:
                    try:
                        print(n, file=running.stdin, flush=True)
                    except BrokenPipeError:
                        break
                    if not (line := running.stdout.readline()):
                        break
                    result = tuple(line.rstrip("\n").split(" ", 2)[1:])
                end = min(end, time.monotonic() + self.o.seconds)
                yield n, self.alone(objects, everything[n], n in switched) if result[0] == "unreached" else result
            try:
                running.stdin.close()
            except BrokenPipeError:
                pass
        if running.returncode:
            sys.exit("without any change something is found already, or the judge failed")


def numbered(source, area):
    """number -> change; numbers start anew in every file, so that a file mended makes no other be compiled again."""
    return {mutate_sources.MOST_OF_A_FILE * first + k: c for first, path in enumerate(files_of(source, area)) for k, c in enumerate(changes_in(source, path))}


def judge_area(o, area, excused, listed):
    everything = numbered(o.source, area)
    wanted = [n for n, c in everything.items() if o.only in str(c.path) and (listed is None or str(c) in listed)]
    some = random.Random(o.seed).sample(wanted, min(o.count or len(wanted), len(wanted)))
    if o.list:
        print(*(str(everything[n]) for n in some), sep="\n")
        return 0
    if not some:
        return 0
    print(f"# {area}: {len(wanted)} changes, {len(some)} of them drawn, seed {o.seed}", flush=True)
    program = Program(o, area)
    switched = {n: everything[n] for n in some}
    objects = program.build(switched)
    counts = dict.fromkeys(("found", "excused", "survives", "does not compile"), 0)
    believed = {n for n in some if o.believe and str(everything[n]) in excused}
    judged = itertools.chain(((n, ("survives", "-")) for n in believed),
                             program.judged(objects, [n for n in some if n not in believed], switched, everything))
    for n, (verdict, who) in judged:
        why = excused.get(str(everything[n])) if verdict == "survives" else None
        counts["excused" if why else verdict] += 1
        print(f"{'excused' if why else 'SURVIVES' if verdict == 'survives' else verdict:8}  {everything[n]}  {why or who}", flush=True)
        if verdict == "survives" and not why:
            print("    " + everything[n].text.strip(), flush=True)
    tried = sum(counts.values())
    compiled = tried - counts["does not compile"]
    print(f"{area}: {len(wanted)} changes, seed {o.seed}, {tried} tried of {len(some)} drawn: {counts['found']} found, {counts['excused']} excused, "
          f"{counts['survives']} survive, {counts['does not compile']} do not compile; "
          f"{100 * (compiled - counts['survives']) / max(compiled, 1):.1f} % found or excused", flush=True)
    return counts["survives"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("source", "build", "scratch"):
        parser.add_argument(name, type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("--area", choices=AREAS)
    parser.add_argument("--count", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="")
    parser.add_argument("--listed", type=pathlib.Path)
    parser.add_argument("--dearest", type=float, default=600)
    parser.add_argument("--seconds", type=float, default=math.inf)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--believe", action="store_true", help="no test is run for what is excused")
    parser.add_argument("--list", action="store_true")
    o = parser.parse_args()
    everything = [c for area in AREAS for c in numbered(o.source, area).values()]
    excused = mutate_sources.excuses(o.source, everything, "tests/library_equivalent_changes.json")
    listed = {line.strip() for line in o.listed.read_text().splitlines() if line[:1] not in ("", "#")} if o.listed else None
    if listed and (unknown := listed - {str(c) for c in everything}):
        sys.exit("no such change now: " + "; ".join(sorted(unknown)))
    survive = [judge_area(o, area, excused, listed) for area in ([o.area] if o.area else AREAS)]
    return 1 if any(survive) else 0


if __name__ == "__main__":
    sys.exit(main())
