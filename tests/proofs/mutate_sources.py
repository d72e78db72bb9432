#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Change a sign, an operation or a constant in our own proofs and formulas, one at a time, and see whether a test finds it.

usage: mutate_sources.py SOURCE BUILD SCRATCH [--count N] [--seed 1] [--only PATH-PART] [--listed FILE] [--alone 20] [--jobs 2] [--list]

BUILD is a build of SOURCE with its tests. Every change is compiled at once, into one program of our proofs and of the tests of formulas and
proofs, and switched on at run time (source_mutants/switch.hpp); source_mutants/judge.cpp asks for each change whoever comes by it: a claim with
its controls, a lemma of our own, a test. What nobody finds is listed, unless equivalent_changes.json says why it changes nothing that is
proved; exit code 1 if there is any. What cannot be switched (a constant expression, a template argument) is compiled alone, a seeded sample of
--alone of them. Without --count all changes are judged; with --list they are only shown, and with --listed those are judged whose lines FILE has.
"""
import argparse
import concurrent.futures
import json
import pathlib
import random
import re
import shlex
import shutil
import subprocess
import sys

WHERE = ["lib/touchstone/paper/*.hpp", "lib/touchstone/wave/*.hpp", "proofs/lemmas/*.cpp", "proofs/section_*.cpp", "proofs/sentences/*.cpp", "proofs/table_1.cpp", "proofs/beyond.cpp", "proofs/consequences.cpp",
         "proofs/operator.cpp", "proofs/operator/*.cpp", "proofs/reading/*.cpp", "proofs/symbolic/*.cpp", "proofs/enclosure/enclosure.cpp"]
TESTS = {"formulas": ["paper/archard_constants.cpp", "paper/identities.cpp"], "four_arithmetics": ["scalar/four_arithmetics.cpp"], "double_accuracy": ["paper/double_accuracy.cpp"],
         "gap": ["paper/gap.cpp"], "ledger": ["proofs/ledger.cpp", "proofs/stored_values.cpp", "proofs/transcription.cpp"], "proof_kernel": ["proofs/kernel.cpp"],
         "operator": ["proofs/operator.cpp"], "errata": ["proofs/errata.cpp", "proofs/sentences.cpp"], "table_1": ["proofs/table_1.cpp"]}
PATTERNS = [(r" \+( |$)", " - "), (r" -( |$)", " + "), (r" \*( |$)", " / "), (r" /( |$)", " * "), (r"(?<![\w.\"\['])(?<!\de[-+])([1-9])(?![\w.\"\]'])", None)]
# What cannot change a proof: includes, loops, what is shown, precision and sizes of searches.
NO_PROOF = re.compile(r"^\s*(#|//|/\*|\*|using|for \(|constexpr (slong|int|long) (digits|bits)|const int pieces)|to_string|WorkingPrecision|std::next|substr|size\(\)")
OPTIONS = ["-O1", "-w", "-Wno-narrowing"]
MOST_OF_A_FILE = 1000  # switch.hpp has room for eighty files


class Change:
    def __init__(self, path, line, column, old, new, text):
        self.path, self.line, self.column, self.old, self.new, self.text = path, line, column, old, new, text

    def switched(self, number):
        if self.old.strip() in "+-":
            return f"{self.old}mutant::Sign{{{number}}} * "
        if self.old.strip() in "*/":
            return f"{self.old}mutant::Inverse{{{number}}} ->* "
        return f"mutant::number({number}, {self.old})"

    def __str__(self):
        return f"{self.path}:{self.line + 1}:{self.column + 1}: '{self.old}' -> '{self.new}'"


def changes(source):
    """(number, change) for each place in code, strings and comments left out. Numbers start anew in every file, so that a file mended makes no other be compiled again."""
    for first, path in enumerate(sorted({p for pattern in WHERE for p in source.glob(pattern)})):
        yield from enumerate(changes_in(source, path), MOST_OF_A_FILE * first)


def masked(text):
    """A line with what is no proof made blank: strings, comments, the places q(3, 7) and the scales at_surfaces({0, 2}) where a print is read (any serves)."""
    blank = lambda m: m.group()[0] + "_" * (len(m.group()) - 2) + m.group()[-1]
    return re.sub(r"\bq\(-?\d+(, \d+)?\)|\b(at_surfaces|sequences|scales)\(\{[\d, ]*\}", blank, re.sub(r'"(\\.|[^"\\])*"', blank, text).split("//")[0])


def changes_in(source, path):
    for line, text in enumerate(path.read_text().splitlines()):
        code = masked(text)
        if NO_PROOF.search(text):
            continue
        for old, new in PATTERNS:
            for m in re.finditer(old, code):
                yield Change(path.relative_to(source), line, m.start(), m.group(), new or str(int(m.group(1)) + 1), text)


def rewritten(source, path, replacements):
    """The text of a source with (line, column, old, new) replaced."""
    lines = (source / path).read_text().splitlines(keepends=True)
    for line, column, old, new in sorted(replacements, reverse=True):
        lines[line] = lines[line][:column] + new + lines[line][column + len(old):]
    return "".join(lines)


def line_with(source, path, piece, file):
    """The only line that has the piece."""
    lines = [n for n, line in enumerate((source / path).read_text().splitlines()) if piece in line]
    if len(lines) != 1:
        sys.exit(f"{file}: '{piece}' is in {len(lines)} lines of {path}, not in one")
    return lines[0]


def excuses(source, everything, file="tests/proofs/equivalent_changes.json"):
    """change -> why, though nobody finds it, it changes nothing that is proved. An excuse is for one change alone, or for as many alike as
    it says: it lies within the piece of a line that is quoted. From one line to another it is for all lines between, without a line for a whole
    file: for estimates and searches on which no proof rests."""
    found = {}
    within = lambda c, piece: piece in c.text and 0 <= c.column - c.text.index(piece) < len(piece)
    for e in json.loads((source / file).read_text()):
        if "from" in e:
            first, last = (line_with(source, e["file"], e[end], file) for end in ("from", "to"))
            found.update((str(c), e["reason"]) for c in everything if e["file"] == str(c.path) and first <= c.line <= last)
            continue
        if "line" not in e:
            found.update((str(c), e["reason"]) for c in everything if e["file"] == str(c.path))
            continue
        meant = [str(c) for c in everything if e["file"] == str(c.path) and within(c, e["line"]) and e["change"] == f"{c.old.strip()} -> {c.new.strip()}"]
        if len(meant) != e.get("times", 1):
            sys.exit(f"{file}: '{e['line']}', {e['change']}, is {len(meant)} changes, not {e.get('times', 1)}: {'; '.join(meant)}")
        found.update(dict.fromkeys(meant, e["reason"]))
    return found


class Program:
    """The judge with all that it links, made of a copy of the sources in SCRATCH."""

    def __init__(self, o):
        self.o, self.tree, self.objects = o, o.scratch / "tree", o.scratch / "objects"
        self.here = o.source / "tests/proofs/source_mutants"
        library = self.command("touchstone_proofs", "proofs/section_5.cpp")
        self.flags = [f for f in library if f.startswith(("-I", "-D", "-std", "-isystem", "-ffp"))]
        self.compiler = next(w for w in library if re.search(r"(\+\+|clang)[-\d]*$", w))
        self.libraries = self.linked("test_errata") + [w for w in self.linked("test_double_accuracy") if "gsl" in w]
        self.cache = [shutil.which("ccache")] if shutil.which("ccache") else []

    def words(self, target, pattern):
        lines = subprocess.run(["ninja", "-C", self.o.build, "-t", "commands", target], capture_output=True, text=True, check=True).stdout.splitlines()
        return shlex.split(next(line for line in lines if re.search(pattern, line)).replace("&& :", "").replace(": &&", ""))

    def linked(self, test):
        words = self.words(test, f" -o tests/{test}\\b")
        return [w for w in words[words.index("-o") + 2:] if not w.endswith(".o")]

    def command(self, target, file):
        return self.words(target, re.escape(file) + "$")

    def units(self, changed):
        """What is compiled: our proofs (where no formula is changed, only those that are; the others come from BUILD), the tests, the judge."""
        proofs = [p.relative_to(self.o.source) for p in self.o.source.glob("proofs/**/*.cpp")]
        if all(p.suffix == ".cpp" for p in changed):
            proofs = [p for p in proofs if p in changed]
        tests = [pathlib.Path("tests") / file for files in TESTS.values() for file in files]
        return sorted(proofs) + tests + [self.here.relative_to(self.o.source) / file for file in ("judge.cpp", "ledger.cpp")]

    def place(self, path):
        copied = self.tree / path
        return copied if copied.exists() else self.o.source / path

    def compile(self, path, source=None, to=None):
        to = to or self.objects / (str(path).replace("/", "_") + ".o")
        to.parent.mkdir(parents=True, exist_ok=True)
        data = f'-DTOUCHSTONE_DATA="{self.o.source}/data"'
        words = [*self.cache, self.compiler, f"-I{self.tree}", f"-I{self.tree}/lib", *self.flags, data, *OPTIONS, "-include", str(self.here / "switch.hpp"),
                 "-c", str(source or self.place(path)), "-o", str(to)]
        done = subprocess.run(words, capture_output=True, text=True)
        return to, done.returncode, done.stderr

    def link(self, objects, to):
        words = [self.compiler, *map(str, objects), *self.libraries, "-o", str(to)]
        done = subprocess.run(words, cwd=self.o.build, capture_output=True, text=True)
        if done.returncode:
            sys.exit("cannot link the judge: " + done.stderr[-2000:])
        return to

    def write(self, switched):
        """The copies, with the changes that are switched."""
        by_file = {}
        for number, c in switched.items():
            by_file.setdefault(c.path, []).append((c.line, c.column, c.old, c.switched(number)))
        for path, replacements in by_file.items():
            target, text = self.tree / path, rewritten(self.o.source, path, replacements)
            target.parent.mkdir(parents=True, exist_ok=True)
            if not target.exists() or target.read_text() != text:
                target.write_text(text)
        return set(by_file)

    def build(self, switched):
        """Compile everything; what does not compile as a switch is taken out of `switched`. The objects by unit."""
        all_units = self.units(self.write(switched))
        objects, waiting = {}, all_units
        while waiting:
            with concurrent.futures.ThreadPoolExecutor(self.o.jobs) as pool:
                done = list(pool.map(self.compile, waiting))
            wrong = {path: errors for path, (_, code, errors) in zip(waiting, done) if code}
            objects.update({path: to for path, (to, code, _) in zip(waiting, done) if not code})
            out = set()
            for path, errors in wrong.items():
                lines = {(name, int(line) - 1) for name, line in re.findall(r"/tree/([^:\s]+):(\d+)", errors)}
                here = {n for n, c in switched.items() if (str(c.path), c.line) in lines and n not in out}
                if not here:
                    sys.exit(f"{path} does not compile, with no change in the lines named:\n{errors[:3000]}")
                out |= here
            for number in out:
                del switched[number]
            changed = self.write(switched) if out else set()
            # a header's change is everybody's: what included it is made again
            headers = any(c.suffix == ".hpp" for c in changed) and any("/tree/lib/touchstone/" in e for e in wrong.values())
            waiting = all_units if headers else list(wrong)
            print(f"# {len(objects)} compiled, {len(wrong)} again without {len(out)} changes that cannot be switched", flush=True)
        return objects


def judged(program, numbers, everything):
    """number -> (found, survives or unreached; by whom). What survives is shown at once, so that it can be read while the others are judged."""
    results = {}
    with subprocess.Popen([str(program)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as judge:
        judge.stdin.write("\n".join(map(str, numbers)))
        judge.stdin.close()
        for line in judge.stdout:
            number, verdict, who = line.rstrip("\n").split(" ", 2)
            results[int(number)] = (verdict, who)
            if verdict == "survives":
                print(f"# {len(results)} of {len(numbers)}: {everything[int(number)]} survives", flush=True)
    if judge.returncode:
        sys.exit("without any change something is found already, or the judge failed")
    return results


def judged_alone(program, objects, change):
    """A change that is compiled: (does not compile, found or survives; by whom). A header's is compiled with the tests of formulas and the sections' readers."""
    text = rewritten(program.o.source, change.path, [(change.line, change.column, change.old, change.new)])
    copy = program.o.scratch / "alone" / change.path.name
    copy.parent.mkdir(parents=True, exist_ok=True)
    copy.write_text(text)
    changed = dict(objects)
    if change.path.suffix == ".hpp":
        target = program.tree / change.path
        before = target.read_text() if target.exists() else None
        target.write_text(text)
        users = [p for p in objects if re.search(r'"touchstone/(paper|wave)/', (program.o.source / p).read_text())]
        try:
            done = {p: program.compile(p, to=copy.parent / (str(p).replace("/", "_") + ".o")) for p in users}
        finally:
            target.unlink() if before is None else target.write_text(before)
    else:
        done = {change.path: program.compile(change.path, source=copy, to=copy.parent / "changed.o")}
    for path, (to, code, _) in done.items():
        if code:
            return "does not compile", "-"
        changed[path] = to
    judge = program.link(changed.values(), copy.parent / "judge")
    try:
        told = subprocess.run([str(judge), "--plain"], capture_output=True, text=True, timeout=600)
    except subprocess.TimeoutExpired:
        return "found", "a judge that does not end"
    return ("found", told.stderr.strip().splitlines()[-1] if told.stderr.strip() else "a crash") if told.returncode else ("survives", "-")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("source", "build", "scratch"):
        arguments.add_argument(name, type=lambda p: pathlib.Path(p).resolve())
    arguments.add_argument("--count", type=int)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--only", default="")
    arguments.add_argument("--listed", type=pathlib.Path)
    arguments.add_argument("--alone", type=int, default=20)
    arguments.add_argument("--jobs", type=int, default=2)
    arguments.add_argument("--list", action="store_true")
    o = arguments.parse_args()
    everything = dict(changes(o.source))
    reasons = excuses(o.source, everything.values())
    listed = {line.strip() for line in o.listed.read_text().splitlines() if line[:1] not in ("", "#")} if o.listed else None
    if listed and (unknown := listed - {str(c) for c in everything.values()}):
        sys.exit("no such change now: " + "; ".join(sorted(unknown)))
    wanted = [n for n, c in everything.items() if o.only in str(c.path) and (listed is None or str(c) in listed)]
    random_order = random.Random(o.seed)
    some = sorted(random_order.sample(wanted, min(o.count or len(wanted), len(wanted))))
    if o.list:
        print(*(str(everything[n]) for n in some), f"{len(some)} of {len(everything)} changes, seed {o.seed}", sep="\n")
        return 0
    program = Program(o)
    switched = {n: everything[n] for n in wanted}
    objects = program.build(switched)
    results = judged(program.link(objects.values(), o.scratch / "judge"), [n for n in some if n in switched], everything)
    strings = [n for n in results if results[n][0] == "unreached"]
    left = [n for n in some if n not in switched] + strings
    for n in random_order.sample(left, min(o.alone, len(left))):
        results[n] = judged_alone(program, objects, everything[n])
    counts = {"found": 0, "excused": 0, "survives": 0, "does not compile": 0}
    for n in some:
        verdict, who = results.get(n, ("unreached", "-"))
        if verdict == "unreached":
            continue
        why = reasons.get(str(everything[n])) if verdict == "survives" else None
        counts["excused" if why else verdict] += 1
        print(f"{'excused' if why else 'SURVIVES' if verdict == 'survives' else verdict:8}  {everything[n]}  {why or (who if verdict != 'survives' else everything[n].text.strip())}")
    print(f"{len(some)} of {len(everything)} changes, seed {o.seed}: {counts['found']} found, {counts['excused']} excused, {counts['survives']} survive; "
          f"{len(left)} cannot be switched, {min(o.alone, len(left))} of them compiled alone, of which {counts['does not compile']} do not compile")
    return 1 if counts["survives"] else 0


if __name__ == "__main__":
    sys.exit(main())
