#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Change a sign, an operation, a comparison or a constant in a source of the library, one at a time, and see whether its tests find it.

usage: mutate_library.py SOURCE BUILD SCRATCH [--count 100] [--seed 1] [--only PATH-PART] [--list]

BUILD is a build of SOURCE with its tests. A changed source is compiled to an object of its own and linked before the library, which then does not
give its own; a changed header is compiled into the tests named here. The tests run until their first failure, with a limit of time (a change that
makes a loop endless is found). Survivors are listed, unless library_equivalent_changes.json says why the change changes nothing that is claimed;
exit code 1 if there is any. What a change of the formulas in paper/ and of proofs/ does: proofs/mutate_sources.py.
"""
import argparse
import json
import pathlib
import random
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "proofs"))
import mutate_sources  # noqa: E402

# source -> the tests that are to find a change, quickest first
FINDERS = {
    "lib/touchstone/rounding/decimal.cpp": ["rounding", "catalogue"],
    "lib/touchstone/rounding/ulp.cpp": ["rounding", "catalogue", "table"],
    "lib/touchstone/scalar/ball.cpp": ["scalar", "rounding", "catalogue"],
    "lib/touchstone/scalar/exact.cpp": ["scalar", "catalogue"],
    "lib/touchstone/scalar/rational.cpp": ["scalar", "rounding", "catalogue"],
    "lib/touchstone/scalar/pair_ball.cpp": ["westergaard_nearest"],
    "lib/touchstone/recursion/from_the_edge/boxes.cpp": ["boxes", "transfer"],
    "lib/touchstone/recursion/from_the_edge/far_end.cpp": ["boxes", "transfer"],
    "lib/touchstone/recursion/from_the_edge/rows.cpp": ["boxes", "transfer"],
    "lib/touchstone/recursion/from_the_edge/values.cpp": ["boxes", "transfer"],
    "lib/touchstone/recursion/from_the_edge/whole_support.cpp": ["transfer"],
    "lib/touchstone/paper/archard_constants.cpp": ["formulas", "catalogue"],
    "lib/touchstone/paper/weierstrass_profile.cpp": ["formulas", "catalogue"],
    "lib/touchstone/paper/westergaard_nearest.cpp": ["westergaard_nearest"],
}
OF_QUADRATURE = ["public_integrals", "typed_formulas", "quadrature"]
# header -> tests that are compiled anew with it
HEADERS = {
    "lib/touchstone/transfer/disc.hpp": {"binary64": "transfer/binary64.cpp"},
    "lib/touchstone/scalar/double_double.hpp": {"double_double": "transfer/double_double.cpp"},
    "lib/touchstone/scalar/pair_ball.hpp": {"westergaard_nearest": "paper/westergaard_nearest.cpp"},
}
COMPARISONS = [(r" <( |$)", " <= "), (r" >( |$)", " >= "), (r" <=( |$)", " < "), (r" >=( |$)", " > "), (r"&&", "||"), (r"\|\|", "&&")]
SECONDS = 240


def changes(source):
    quadrature = {str(p.relative_to(source)) for p in source.glob("lib/touchstone/quadrature/*.cpp")}
    for path in sorted({*FINDERS, *HEADERS, *quadrature}):
        for line, text in enumerate((source / path).read_text().splitlines()):
            code = mutate_sources.masked(text)
            if mutate_sources.NO_PROOF.search(text) or "template" in text or "static_assert" in text:
                continue
            for old, new in mutate_sources.PATTERNS + COMPARISONS:
                for m in re.finditer(old, code):
                    yield mutate_sources.Change(pathlib.Path(path), line, m.start(), m.group(), new or str(int(m.group(1)) + 1), text)


def from_compiler(words):
    """A command without what stands before the compiler's name (a cache, a launcher)."""
    return words[next(i for i, w in enumerate(words) if re.search(r"(\+\+|clang)[-\d]*$", w)):]


class Program(mutate_sources.Program):
    """What compiles one source and links one test, with the commands of BUILD."""

    def __init__(self, o):
        self.o = o

    def compiled(self, file, target, to, source=None, include=None):
        """The command that compiles `file` for `target` in BUILD, or `source` in its place, with what is in `include` before all else."""
        words = from_compiler(self.command(target, file))
        words[words.index("-o") + 1] = str(to)
        if source:
            words[words.index("-c") + 1] = str(source)
        for flag, made in (("-MF", f"{to}.d"), ("-MT", str(to))):
            if flag in words:
                words[words.index(flag) + 1] = made
        return [words[0], *([f"-I{include}"] if include else []), *words[1:]]

    def run(self, words):
        return subprocess.run(words, cwd=self.o.build, capture_output=True, text=True)

    def found_by(self, change):
        """The first test that fails, "the compiler", or nothing."""
        tree, scratch = self.o.scratch / "tree", self.o.scratch
        target = tree / change.path.relative_to("lib")
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(mutate_sources.rewritten(self.o.source, change.path, [(change.line, change.column, change.old, change.new)]))
        try:
            return self.judged(change, target, tree, scratch)
        finally:
            target.unlink()

    def judged(self, change, target, tree, scratch):
        header = HEADERS.get(str(change.path))
        mutant = scratch / "mutant.o"
        if not header:
            library = "touchstone_quadrature" if change.path.parts[2] in ("scalar", "quadrature") else "touchstone"
            if self.run(self.compiled(str(change.path).removeprefix("lib/"), library, mutant, target)).returncode:
                return "the compiler"
        for test in header or FINDERS.get(str(change.path), OF_QUADRATURE):
            link = from_compiler(self.words(f"test_{test}", f" -o tests/(quadrature/)?test_{test}\\b"))
            program = scratch / f"test_{test}"
            link[link.index("-o") + 1] = str(program)
            if header:
                if self.run(self.compiled("tests/" + header[test], f"test_{test}", mutant, include=tree)).returncode:
                    return "the compiler"
                link = [str(mutant) if w.endswith(header[test] + ".o") else w for w in link]
            else:
                first = next(i for i, w in enumerate(link) if w.endswith(".a"))
                link.insert(first, str(mutant))
            done = self.run(link)
            if done.returncode:
                sys.exit(f"cannot link {test}: {done.stderr[-1000:]}")
            try:
                if subprocess.run([str(program), "-aa", "1"], cwd=self.o.build / "tests", capture_output=True, timeout=SECONDS).returncode:
                    return test
            except subprocess.TimeoutExpired:
                return f"{test}, by its time"
        return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("build", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("scratch", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="")
    parser.add_argument("--list", action="store_true")
    o = parser.parse_args()
    everything = list(changes(o.source))
    excused = mutate_sources.excuses(o.source, everything, "tests/library_equivalent_changes.json")
    asked = [c for c in everything if o.only in str(c.path)]
    chosen = random.Random(o.seed).sample(asked, min(o.count, len(asked)))
    if o.list:
        print("\n".join(map(str, chosen)))
        return 0
    print(f"# {len(asked)} changes, {len(chosen)} of them tried, seed {o.seed}", flush=True)
    program, counted = Program(o), {"found": 0, "excused": 0, "survived": 0, "not compiled": 0}
    o.scratch.mkdir(parents=True, exist_ok=True)
    for c in chosen:
        if str(c) in excused:
            counted["excused"] += 1
            continue
        by = program.found_by(c)
        counted["not compiled" if by == "the compiler" else "found" if by else "survived"] += 1
        if not by:
            print(f"survives: {c}\n    {c.text.strip()}", flush=True)
    print(json.dumps(counted))
    return 1 if counted["survived"] else 0


if __name__ == "__main__":
    sys.exit(main())
