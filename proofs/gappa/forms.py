#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`forms.py quotes ROOT FILE.g...`: each file quotes the C++ lines whose operations it lists, after a line `# path:` lines `#   code`. Each
must still stand in that header, blanks apart, so that a change of the code makes the proof about the old one fail. Ends with 1 where one
does not.
`forms.py tighter FILE.g`: the same statement with every bound lowered by a quarter, for a control that Gappa must refuse."""

import pathlib
import re
import sys


def stale(root, path):
    """what the quotes of one .g file have that the code has not"""
    header, code, quotes, wrong = None, "", 0, []
    for line in path.read_text().splitlines():
        if re.fullmatch(r"# \S+\.[hc]pp:", line):
            header = line[2:-1]
            code = "".join((root / header).read_text().split())
        elif line.startswith("#   "):
            quotes += 1
            if "".join(line[1:].split()) not in code:
                wrong.append(f"{path.name}: {header} has no line '{line[4:].strip()}'")
    return wrong if quotes else [f"{path.name} quotes no line of the code it is about"]


def tighter(text):
    start = text.index("->", text.index("\n{"))
    end = text.index("}", start)

    def lowered(match):
        number = match[1]
        if "b" in number:
            mantissa, exponent = number.split("b")
            number = f"{int(mantissa):#x}p{exponent}"
        return f"<= {(float.fromhex(number) * 0.75).hex()}"
    return text[:start] + re.sub(r"<= (0x[0-9a-f.]+p-\d+|\d+b-\d+)", lowered, text[start:end]) + text[end:]


def main(what, *rest):
    if what == "tighter":
        print(tighter(pathlib.Path(rest[0]).read_text()))
        return 0
    wrong = [w for f in rest[1:] for w in stale(pathlib.Path(rest[0]), pathlib.Path(f))]
    for w in wrong:
        print(w, file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
