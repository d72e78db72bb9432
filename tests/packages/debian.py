#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The Debian packages are built from a copy of the clone, accepted by lintian, unpacked where nothing else is, and used.

usage: debian.py SOURCE [--built FOLDER]   the second form looks at packages that were built before, in a minute and not an hour
Needs dpkg-dev, debhelper, help2man and lintian; nothing is installed on the system: the packages are unpacked into a folder.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile


def run(*words, **options):
    r = subprocess.run([str(w) for w in words], capture_output=True, text=True, **options)
    if r.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}\n{r.stdout[-4000:]}\n{r.stderr[-4000:]}")
    return r.stdout


def build(source, scratch):
    tree = scratch / "touchstone"
    tree.mkdir()
    for name in run("git", "-C", source, "ls-files", "-z").split("\0"):
        if name and (source / name).exists():
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(source / name, tree / name)
    options = {"cwd": tree, "env": {**os.environ, "DEB_BUILD_OPTIONS": "nocheck parallel=2"}}
    run("dpkg-buildpackage", "-us", "-uc", "-b", "-d", **options)


arguments = argparse.ArgumentParser()
arguments.add_argument("source", type=pathlib.Path)
arguments.add_argument("--built", type=pathlib.Path)
given = arguments.parse_args()
for tool in ("dpkg-buildpackage", "dh", "lintian", "help2man"):
    if shutil.which(tool) is None:
        sys.exit(f"{tool} is not there: apt-get install dpkg-dev debhelper help2man lintian")
with tempfile.TemporaryDirectory() as scratch:
    if given.built is None:
        build(given.source.resolve(), pathlib.Path(scratch))
    packages = sorted((given.built or pathlib.Path(scratch)).glob("*.deb"))
    names = {p.name.split("_")[0] for p in packages} - {n for n in (p.name.split("_")[0] for p in packages) if n.endswith("-dbgsym")}
    if names != {"touchstone", "touchstone-data", "libtouchstone1", "libtouchstone-dev"}:
        sys.exit(f"the packages are {sorted(names)}")
    # a first package has no bug number to close, and its maintainer no address yet
    said = run("lintian", "--fail-on", "error", "--suppress-tags", "initial-upload-closes-no-bugs,bogus-mail-host-in-debian-changelog,bogus-mail-host", *packages)
    print(said)
    root = pathlib.Path(scratch) / "root"
    for p in packages:
        run("dpkg-deb", "-x", p, root)
    library = next(root.glob("usr/lib/*/libtouchstone.so.1")).parent
    program = root / "usr/bin/touchstone"
    if "0.416550371832813487722720256733" not in run(program, "eval", "archard.K", "n=3", "--digits", "30"):
        sys.exit("the program that was packed gives another value")
    for page in ("touchstone.1.gz", "touchstone-eval.1.gz"):
        if not (root / "usr/share/man/man1" / page).exists():
            sys.exit(f"no manual page {page}")
    completion = root / "usr/share/bash-completion/completions/touchstone"
    offered = run("bash", "-c", f'source "{completion}"; COMP_WORDS=(touchstone ev); COMP_CWORD=1; _touchstone; echo "${{COMPREPLY[@]}}"')
    if offered.split() != ["eval"]:
        sys.exit(f"completion offers {offered}")
    if '"spdxVersion": "SPDX-2.3"' not in (root / "usr/share/doc/touchstone/touchstone.spdx.json").read_text():
        sys.exit("no list of what the program is made of")
    use = pathlib.Path(scratch) / "use.c"
    use.write_text('#include <touchstone.h>\n#include <stdio.h>\nint main(void) { touchstone_value* v; if (touchstone_eval("archard.K", "n=3", 9, 0, &v, 0, 0)) return 1; puts(touchstone_decimal(v)); touchstone_free(v); return 0; }\n')
    run("cc", "-o", f"{scratch}/use", use, f"-I{root}/usr/include", f"-L{library}", "-ltouchstone")
    if run(f"{scratch}/use", env={**os.environ, "LD_LIBRARY_PATH": str(library)}) != "0.416550372\n":
        sys.exit("the library that was packed gives another value")
    if not (root / "usr/share/touchstone/reference/contact_area.txt").exists():
        sys.exit("the tables are not in touchstone-data")
print("packages built, accepted and used:", ", ".join(sorted(names)))
