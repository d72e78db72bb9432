# SPDX-License-Identifier: MIT
"""Integrals as text, and the same formula in the language of each peer: GP, Python with mpmath, C++ (a template over the number type).

What does not depend on x is computed once, outside the integrand, and what occurs twice once, as a competent user would have it.

    formulas.py public_integrals.txt integrals.txt      writes the C++ functions of all of them to standard output
"""
import ast
import sys
from collections import Counter, namedtuple

Piece = namedtuple("Piece", "formula start stop gp_start gp_stop omega")
Case = namedtuple("Case", "name kind formula start stop value pieces")

LEFT_OUT = {"kahaner-02", "arb-05", "arb-06"}  # jumps, and a kink at a root that has no name: nothing that a formula at points could tell


def rows(path):
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            if line.strip() and not line.startswith("#"):
                yield [field.strip() for field in line.split(";")]


def cases(public, peers):
    """Every integral of the public sets that is not left out, and (6.7) at n = 1."""
    pieces = {}
    for name, kind, formula, start, stop, gp_start, gp_stop, *omega in rows(peers):
        pieces.setdefault(name, (kind, []))[1].append(Piece(formula, start, stop, gp_start, gp_stop, omega[0] if omega else ""))
    known = [Case("area", "end", "", "", "", "", pieces["area"][1])]
    for name, formula, start, stop, value, *_ in rows(public):
        if name not in LEFT_OUT:
            as_typed = [Piece(formula, start, stop, Text(start, Gp).body, Text(stop, Gp).body, "")]
            kind, how = pieces.get(name, ("smooth", as_typed))
            known.append(Case(name, kind, formula, start, stop, value, how))
    unknown = set(pieces) - {case.name for case in known}
    if unknown:
        raise SystemExit(f"formulas.py: no such public integral: {sorted(unknown)}")
    return known


def depends(node):
    return any(isinstance(part, ast.Name) and part.id == "x" for part in ast.walk(node))


def is_integer(node):
    return isinstance(node, ast.Constant) and isinstance(node.value, int)


class Text:
    """A formula in a dialect: `constants` and `parts` are (name, text), `body` is what is left."""

    def __init__(self, formula, dialect):
        self.source = formula.replace("^", "**")
        self.dialect = dialect
        self.constants, self.parts, self.names = [], [], {}
        tree = ast.parse(self.source, mode="eval").body
        self.constant_only = not depends(tree)
        self.seen = Counter(ast.dump(node) for node in ast.walk(tree) if isinstance(node, (ast.BinOp, ast.Call)))
        self.body = self.write(tree)

    def named(self, node, where, letter):
        key = ast.dump(node)
        if key not in self.names:
            text = self.plain(node)
            self.names[key] = f"{letter}{len(where)}"
            where.append((self.names[key], text))
        return self.names[key]

    def write(self, node):
        if is_integer(node) and node.value < 1000 and not self.constant_only:
            return str(node.value)
        if not self.constant_only and not depends(node):
            return self.named(node, self.constants, "c")
        if self.seen[ast.dump(node)] > 1 and not self.constant_only:
            return self.named(node, self.parts, "t")
        return self.plain(node)

    def plain(self, node):
        d = self.dialect
        inner = self.write if self.constant_only or depends(node) else self.plain
        if isinstance(node, ast.Constant):
            return d.number(ast.get_source_segment(self.source, node))
        if isinstance(node, ast.Name):
            return d.name(node.id)
        if isinstance(node, ast.UnaryOp):
            return f"(-{inner(node.operand)})"
        if isinstance(node, ast.Call):
            return d.call(node.func.id, [inner(a) for a in node.args])
        if isinstance(node.op, ast.Pow):
            exponent, sign = node.right, 1
            if isinstance(exponent, ast.UnaryOp) and is_integer(exponent.operand):
                exponent, sign = exponent.operand, -1
            whole = sign * exponent.value if is_integer(exponent) else None
            return d.power(inner(node.left), whole, None if whole is not None else inner(node.right))
        sign = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}[type(node.op)]
        return d.binary(inner(node.left), sign, inner(node.right))


class Gp:
    """A decimal is read at the precision in force."""
    number = str
    WORDS = {"airyai": "airy({0})[1]", "ellipe": "ellE(sqrt({0}))", "erf": "(1-erfc({0}))", "lgamma": "lngamma({0})", "sech": "(1/cosh({0}))",
             "atan2": "arg({1}+I*{0})", "si": "imag(eint1(I*{0}))"}

    @staticmethod
    def name(word):
        return {"pi": "Pi", "e": "exp(1)", "inf": "oo"}.get(word, word)

    @staticmethod
    def binary(a, sign, b):
        return f"({a}{sign}{b})"

    @staticmethod
    def power(base, whole, other):
        return f"({base})^({other if whole is None else whole})"

    @staticmethod
    def call(word, args):
        return Gp.WORDS[word].format(*args) if word in Gp.WORDS else f"{word}({','.join(args)})"


class Python:
    """For a module that has imported everything from mpmath."""

    @staticmethod
    def number(text):
        return f"mpf('{text}')"

    @staticmethod
    def name(word):
        return word

    @staticmethod
    def binary(a, sign, b):
        return f"({a}{sign}{b})"  # a number divided by a number is a constant, and there every integer is an mpf

    @staticmethod
    def power(base, whole, other):
        return f"({base}**({other if whole is None else whole}))"

    @staticmethod
    def call(word, args):
        word = {"lgamma": "loggamma", "abs": "fabs"}.get(word, word)
        return f"{word}({','.join(args)})"


class Cpp:
    """For a template over the number type T; peer_integrals.cpp has the functions."""

    @staticmethod
    def number(text):
        return f'number<T>("{text}")'

    @staticmethod
    def name(word):
        return {"pi": "pi_of<T>()", "e": "exp(T(1))"}.get(word, word)

    @staticmethod
    def binary(a, sign, b):
        return f'T(number<T>("{a}") {sign} {b})' if a.isdigit() and b.isdigit() else f"T({a} {sign} {b})"

    @staticmethod
    def power(base, whole, other):
        if whole is None:
            return f"power(T({base}), T({other}))"
        return f"integer_power(T({base}), {whole})" if whole >= 0 else f"T(1 / integer_power(T({base}), {-whole}))"

    @staticmethod
    def call(word, args):
        if word.startswith("bessel"):
            return f"{word}({args[0]}, T({args[1]}))"
        word = {"gamma": "gamma_of", "lgamma": "lgamma_of", "erf": "erf_of", "zeta": "zeta_of"}.get(word, word)
        return f"{word}({', '.join(f'T({a})' for a in args)})"


def cpp(all_cases):
    """A struct for each piece and each of its ends, and a function that finds the pieces by name."""
    table = []
    for case in all_cases:
        calls = []
        for index, piece in enumerate(case.pieces):
            name = f"{case.name.replace('-', '_')}_{index}"
            text = Text(piece.formula, Cpp)
            lines = [f"    static const T {word} = {body};" for word, body in text.constants] + [f"    const T {word} = {body};" for word, body in text.parts]
            print(f"struct {name} {{ template <class T> static T of([[maybe_unused]] const T& x)\n{{\n" + "\n".join(lines) + f"\n    return {text.body};\n}} }};")
            ends = []
            for side, end in (("from", piece.start), ("to", piece.stop)):
                if "inf" in end:
                    ends.append("Infinite")
                else:
                    ends.append(f"{name}_{side}")
                    print(f"struct {ends[-1]} {{ template <class T> static T of() {{ return T({Text(end, Cpp).body}); }} }};")
            calls.append(f"tool.template piece<{name}, {ends[0]}, {ends[1]}>();")
        table.append(f'    if (name == "{case.name}") {{ {" ".join(calls)} return true; }}')
    print("template <class Tool> bool run(const std::string& name, Tool& tool)\n{\n" + "\n".join(table) + "\n    return false;\n}")


if __name__ == "__main__":
    cpp(cases(*sys.argv[1:3]))
