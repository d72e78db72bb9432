#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""length.py: how many lines of checker/ a reader of one kind of claim has to read, and how many rows of data/reference that kind confirms.

Lines of docstrings, comments and blank ones do not count, those of more than WIDEST columns count twice; a function or method counts for
every kind that may come to it. What belongs to which kind is said here by name (PARTS, borrowed), as methods are found by name at run
time; a name that is nowhere is an error, and test_length.py holds proofs against it. Kinds follow one another so that each next one
confirms the most rows for the lines it adds.
"""
import ast
import json
import pathlib
import tokenize

ROOT = pathlib.Path(__file__).resolve().parents[2]
CHECKER, TABLES = ROOT / "checker", ROOT / "data" / "reference"
WIDEST = 140
SMALLEST_OF_PARTIAL = 2.05  # values of G in the tables, from which on a limiting distribution is that of partial contact
FILES = tuple("certificate certificate_text density distributions full_contact limit_density limits poisson second_eigenvalue scale_one "
              "transfer two_waves intervals memory closed_forms".split())

# Of class Replay in certificate.py, what serves some kinds only.
PARTS = {
    "transfer": "grid rule panel whole row level value limit settling from_then_on at_load",
    "full_contact": "mesh polynomials all_panels share share_of made",
    "poisson": "mesh polynomials all_panels share is_mean mean quotient made",
    "density": "mesh polynomials all_panels share share_of made",
    "limit_density": "mesh polynomials all_panels is_mean mean quotient made",
    "distributions": "law laws all_pieces piece reading",
    "limits": "steady part limit_law balance tending at_scale law laws all_pieces piece reading",
    "second_eigenvalue": "steady eigenvalue",
}
TITLES = {
    "closed_forms": "closed forms, and scale 1 with full contact",
    "transfer": "areas in partial contact, their limit",
    "distributions": "distributions in partial contact",
    "full_contact": "areas and exceedances with full contact",
    "limits": "limiting distributions, G > 2",
    "poisson": "limits with full contact",
    "second_eigenvalue": "the second eigenvalue",
    "density": "densities with full contact",
    "limit_density": "limits of densities with full contact",
}
# Tables of certificates by kind: that of partial contact, and that of G below SMALLEST_OF_PARTIAL.
CONFIRMED_BY = {
    **dict.fromkeys("contact_area segments_count limit_ratio limit_constant limit_scale".split(), ("transfer", "transfer")),
    **dict.fromkeys("contact_density contact_exceedance segments_density".split(), ("distributions", "distributions")),
    **dict.fromkeys("contact_area_full contact_area_heavy contact_exceedance_full".split(), ("full_contact", "full_contact")),
    **dict.fromkeys("limit_exceedance limit_force limit_segments limit_distance".split(), ("limits", "poisson")),
    "limit_constant_full": ("poisson", "poisson"),
    "limit_density": ("limits", "limit_density"),
    "contact_density_full": ("density", "density"),
    "limit_gap": ("second_eigenvalue", "second_eigenvalue"),
}


def lines_of_code(path):
    """their numbers"""
    lines = set()
    with open(path, "rb") as file:
        before = tokenize.NEWLINE
        for token in tokenize.tokenize(file.readline):
            if token.type in (tokenize.COMMENT, tokenize.NL, tokenize.INDENT, tokenize.DEDENT, tokenize.ENCODING):
                continue
            if token.type not in (tokenize.NEWLINE, tokenize.ENDMARKER) and (token.type, before) != (tokenize.STRING, tokenize.NEWLINE):
                lines.update(range(token.start[0], token.end[0] + 1))
            before = token.type
    return lines


def owner_of_lines(name):
    """of lines of a file: "function", "Class.method" or "Class", whichever is the innermost"""
    owner = {}
    for top in ast.parse((CHECKER / f"{name}.py").read_text()).body:
        inner = [node for node in top.body if hasattr(node, "name")] if isinstance(top, ast.ClassDef) else []
        for node, part in [(top, getattr(top, "name", "")), *((node, f"{top.name}.{node.name}") for node in inner)]:
            first = min([node.lineno, *(decorator.lineno for decorator in getattr(node, "decorator_list", []))])
            owner.update(dict.fromkeys(range(first, node.end_lineno + 1), part))
    return owner


def functions(name):
    """(file, what owner_of_lines says, or "" for the rest of the file): lines of code"""
    path = CHECKER / f"{name}.py"
    owner, text, found = owner_of_lines(name), path.read_text().splitlines(), {}
    for k in lines_of_code(path):
        part = name, owner.get(k, "")
        found[part] = found.get(part, 0) + -(-len(text[k - 1]) // WIDEST)
    return found


def named(code, file, names):
    """these functions of a file, which has them, classes with all their methods, and what stands outside of functions"""
    parts = {(file, "")}
    for name in names.split():
        of_name = {part for part in code if part[0] == file and (part[1] == name or part[1].startswith(f"{name}."))}
        assert of_name, (file, name)
        parts |= of_name
    return parts


def methods(kind, names):
    return " ".join(f"{kind}.{name}" for name in names.split())


def borrowed(code):
    """for each kind, what it needs of other files than its own"""
    def but(file, names):
        return {part for part in code if part[0] == file} - (named(code, file, names) - {(file, "")})
    arithmetic = {part for part in code if part[0] in ("intervals", "memory")}
    common = arithmetic | named(code, "transfer", "Refused chebyshev fixed")
    discs = named(code, "closed_forms", "root") | named(
        code, "scale_one", "Disc Outside root_of largest off_by by_gauss log2_above points trigonometry")
    two_waves = discs | {part for part in code if part[0] == "two_waves"}
    by_levels = "jumps " + methods(
        "Mesh", "cover between first_on first_between defects errors once shares parted averaged value rises on_interval")
    of_poisson = common | but("full_contact", by_levels) | named(code, "scale_one", "log2_above")
    of_laws = common | named(code, "full_contact", "Trigonometry Far lebesgue")
    return {
        "transfer": arithmetic, "full_contact": common, "poisson": of_poisson,
        "density": common | two_waves | but(
            "full_contact", methods("Mesh", "first_wave first_disc first_on first_between between defects rises value")),
        "limit_density": of_poisson | two_waves | but("poisson", "Force"),
        "distributions": of_laws | named(code, "scale_one", "log2_above"), "limits": of_laws | but("distributions", ""),
        "second_eigenvalue": common | named(code, "full_contact", "Trigonometry lebesgue") | discs | named(
            code, "distributions", "Polynomial need top interpolated spread_of"),
    }


def needed():
    """of each kind, functions and their lines of code"""
    code = {part: count for file in FILES for part, count in functions(file).items()}
    of_some = {("certificate", f"Replay.{part}") for parts in PARTS.values() for part in parts.split()}
    common = {part for part in code if part[0] in ("certificate", "certificate_text")} - of_some
    kinds = {kind: common | {part for part in code if part[0] == kind} | named(code, "certificate", methods("Replay", PARTS[kind])) | more
             for kind, more in borrowed(code).items()}
    code.update({**functions("check"), **functions("table_text")})
    closed = {part for part in code if part[0] in ("check", "table_text", "closed_forms", "intervals", "scale_one", "memory")}
    closed |= named(code, "full_contact", "Trigonometry") | named(code, "transfer", "Refused chebyshev fixed")
    return {"closed_forms": closed, **kinds}, code


def of_rows():
    """lines of code that a reader of files of rows has to trust besides those of closed forms"""
    return sum(count for name in ("rows", "exact_text") for count in functions(name).values())


def rows():
    """confirmed rows of each kind"""
    found = dict.fromkeys(TITLES, 0)
    for entry in json.loads((TABLES / "coverage.json").read_text()):
        text = (TABLES / f"{entry['table']}.txt").read_text().splitlines()
        inputs = [line[2:].split() for line in text if line.startswith("#")][-1]
        lines = [line.split() for line in text if not line.startswith("#")]
        assert entry["rows"] == len(lines) == entry["confirmed"], entry
        partial, full = CONFIRMED_BY.get(entry["table"], ("closed_forms", "closed_forms"))
        for line in lines:
            found[partial if partial == full or float(line[inputs.index("G")]) >= SMALLEST_OF_PARTIAL else full] += 1
    return found


def owners():
    """(file, line): to what part it belongs"""
    return {(CHECKER / f"{name}.py", k): (name, part) for name in FILES for k, part in owner_of_lines(name).items()}


def page():
    """a table in Markdown"""
    kinds, code = needed()

    def lines(parts):
        return sum(code[part] for part in parts)
    confirmed, left, read, sum_of_rows = rows(), list(TITLES), set(), 0
    out = ["| kind of claim | lines to read for it alone | rows it confirms | lines for this and all above | rows |",
           "|---|---|---|---|---|"]
    while left:
        kind = max(left, key=lambda kind: confirmed[kind] / lines(kinds[kind] - read))
        left.remove(kind)
        read, sum_of_rows = read | kinds[kind], sum_of_rows + confirmed[kind]
        out.append(f"| {TITLES[kind]} | {lines(kinds[kind])} | {confirmed[kind]} | {lines(read)} | {sum_of_rows} |")
    return "\n".join(out) + "\n"


if __name__ == "__main__":
    print(page(), end="")
