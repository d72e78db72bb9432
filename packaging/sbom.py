#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a build is made of, with versions and licences, as SPDX 2.3 (JSON).

usage: sbom.py --version V --out FILE [--header NAME=VERSION]... [--archive FILE]... BINARY...

A BINARY is the program or the C library. The shared libraries that it loads are asked of the dynamic linker (DYNAMIC_LINK: it asks for them itself;
DEPENDS_ON: a library of its does), whose they are and which version of dpkg, or of the file's own name where there is no dpkg. Libraries of headers alone leave no trace in a binary,
nor do the archives that the program has in itself (STATIC_LINK): the build says which it found.
A library that is not in LICENCES below is an error: somebody has to look at its licence first.
"""
import argparse
import datetime
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

# Beginning of the file's name: the project's name, its licence as its authors state it, and its home.
LICENCES = {
    "libarb": ("Arb", "LGPL-2.1-or-later", "https://arblib.org"),
    "libflint-arb": ("Arb", "LGPL-2.1-or-later", "https://arblib.org"),
    "libflint": ("FLINT", None, "https://flintlib.org"),
    "libgmp": ("GMP", "LGPL-3.0-or-later OR GPL-2.0-or-later", "https://gmplib.org"),
    "libgmpxx": ("GMP", "LGPL-3.0-or-later OR GPL-2.0-or-later", "https://gmplib.org"),
    "libmpfr": ("MPFR", "LGPL-3.0-or-later", "https://www.mpfr.org"),
    "libntl": ("NTL", "LGPL-2.1-or-later", "https://libntl.org"),
    "libgf2x": ("gf2x", "GPL-2.0-or-later", "https://gitlab.inria.fr/gf2x/gf2x"),
    "libfmt": ("fmt", "MIT", "https://fmt.dev"),
    "libcrypto": ("OpenSSL", "Apache-2.0", "https://www.openssl.org"),
    "libginac": ("GiNaC", "GPL-2.0-or-later", "https://www.ginac.de"),
    "libcln": ("CLN", "GPL-2.0-or-later", "https://www.ginac.de/CLN"),
    "libgsl": ("GSL", "GPL-3.0-or-later", "https://www.gnu.org/software/gsl"),
    "libgslcblas": ("GSL", "GPL-3.0-or-later", "https://www.gnu.org/software/gsl"),
    "libopenblas": ("OpenBLAS", "BSD-3-Clause", "https://www.openblas.net"),
    "libstdc++": ("GCC runtime", "GPL-3.0-or-later WITH GCC-exception-3.1", "https://gcc.gnu.org"),
    "libgcc_s": ("GCC runtime", "GPL-3.0-or-later WITH GCC-exception-3.1", "https://gcc.gnu.org"),
    "libasan": ("GCC runtime", "GPL-3.0-or-later WITH GCC-exception-3.1", "https://gcc.gnu.org"),
    "libubsan": ("GCC runtime", "GPL-3.0-or-later WITH GCC-exception-3.1", "https://gcc.gnu.org"),
    "libtsan": ("GCC runtime", "GPL-3.0-or-later WITH GCC-exception-3.1", "https://gcc.gnu.org"),
    "libgomp": ("GCC runtime", "GPL-3.0-or-later WITH GCC-exception-3.1", "https://gcc.gnu.org"),
    "libc": ("GNU C library", "LGPL-2.1-or-later", "https://www.gnu.org/software/libc"),
    "libm": ("GNU C library", "LGPL-2.1-or-later", "https://www.gnu.org/software/libc"),
    "libdl": ("GNU C library", "LGPL-2.1-or-later", "https://www.gnu.org/software/libc"),
    "libpthread": ("GNU C library", "LGPL-2.1-or-later", "https://www.gnu.org/software/libc"),
    "ld-linux": ("GNU C library", "LGPL-2.1-or-later", "https://www.gnu.org/software/libc"),
}
HEADERS = {
    "Boost": ("BSL-1.0", "https://www.boost.org"),
    "nlohmann_json": ("MIT", "https://json.nlohmann.me"),
    "CLI11": ("BSD-3-Clause", "https://github.com/CLIUtils/CLI11"),
}
# FLINT took its licence's later version with the release that took Arb in.
FLINT_UNTIL_3, FLINT_SINCE_3 = "LGPL-2.1-or-later", "LGPL-3.0-or-later"
# Our own parts by the name of the file: what links GSL or GiNaC is GPL.
OWN = {"touchstone": "GPL-3.0-or-later AND MIT", "libtouchstone": "MIT"}


def loaded(binary):
    """The files that the dynamic linker would load, the binary itself and the kernel's page left out."""
    listed = subprocess.run(["ldd", binary], capture_output=True, text=True, check=True, env=dict(os.environ, LC_ALL="C")).stdout
    if "not found" in listed:
        sys.exit(f"sbom.py: {binary}: " + next(line.strip() for line in listed.splitlines() if "not found" in line))
    return sorted({pathlib.Path(path) for path in re.findall(r"(?:=> |^\s+)(/\S+) \(0x", listed, re.M)})


def asked_for(binary):
    """The names that the binary itself asks for; what else is loaded, one of these asks for."""
    return set(re.findall(r"\(NEEDED\).*\[(.+)\]", subprocess.run(["readelf", "-dW", binary], capture_output=True, text=True, check=True).stdout))


def distribution():
    found = re.search(r'^ID="?([\w.-]+)"?$', pathlib.Path("/etc/os-release").read_text(), re.M) if pathlib.Path("/etc/os-release").exists() else None
    return found.group(1) if found else "debian"


def names_of(file):
    """dpkg knows a file by the name it was installed under, which a merged /usr may no longer show."""
    return list(dict.fromkeys(str(p).removeprefix(cut) for p in (file, file.resolve()) for cut in ("", "/usr")))


def owners(files):
    """file -> (version, Debian's package), of all files at once: dpkg reads its lists anew each time it is asked."""
    if not shutil.which("dpkg-query"):
        return {}
    listed = subprocess.run(["dpkg-query", "-S", *(name for file in files for name in names_of(file))], capture_output=True, text=True, env=dict(os.environ, LC_ALL="C")).stdout
    owner = {path: package.split(",")[0] for package, path in (line.split(": ", 1) for line in listed.splitlines() if ": /" in line)}
    known = subprocess.run(["dpkg-query", "-W", "-f=${binary:Package}|${source:Package}|${Version}\n", *sorted(set(owner.values()))], capture_output=True, text=True).stdout
    versions = {name: (source, full) for name, source, full in (line.split("|") for line in known.splitlines())}
    found = {}
    for file in files:
        for name in (n for n in names_of(file) if n in owner):
            package = owner[name]
            source, full = versions.get(package) or versions[package.split(":")[0]]
            purl = f"pkg:deb/{distribution()}/{package.split(':')[0]}@{urllib.parse.quote(full)}?upstream={source}"
            found[file] = re.sub(r"^\d+:|-[^-]*$", "", full), purl
    return found


def version_in_name(file):
    found = re.search(r"\.so\.([\d.]+)$", file.resolve().name)
    return (found.group(1) if found else None), None


def package(name, licence, home, number, purl=None):
    entry = {"SPDXID": "SPDXRef-" + re.sub(r"[^A-Za-z0-9.]", "-", name), "name": name, "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
             "licenseConcluded": "NOASSERTION", "licenseDeclared": licence, "copyrightText": "NOASSERTION"}
    if home:
        entry["homepage"] = home
    if number:
        entry["versionInfo"] = number
    if purl:
        entry["externalRefs"] = [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl", "referenceLocator": purl}]
    return entry


def component(file, owned):
    stem = re.match(r"(.+?)(-x86-64|-\d[\d.]*)?\.(so|a$)", file.name)
    known = LICENCES.get(stem.group(1)) if stem else None
    if known is None:
        sys.exit(f"sbom.py: {file}: whose library is that, and under which licence? LICENCES in packaging/sbom.py has to say so")
    name, licence, home = known
    number, purl = owned.get(file) or version_in_name(file)
    if licence is None:
        licence = FLINT_SINCE_3 if number and int(number.split(".")[0]) >= 3 else FLINT_UNTIL_3
    return package(name, licence, home, number, purl)


def document(binaries, headers, archives, number):
    packages, relations = {}, []
    files = {binary: loaded(binary) for binary in binaries if binary.name.split(".so")[0] in OWN}
    owned = owners(sorted({file for some in files.values() for file in some}.union(archives)))

    def relate(a, kind, b):
        relation = {"spdxElementId": a, "relationshipType": kind, "relatedSpdxElement": b}
        if relation not in relations:  # a project may have several libraries
            relations.append(relation)

    for binary in binaries:
        name = binary.name.split(".so")[0]
        if name not in OWN:
            sys.exit(f"sbom.py: {binary} is none of {', '.join(OWN)}")
        own = package(name, OWN[name], None, number)
        own["checksums"] = [{"algorithm": "SHA256", "checksumValue": hashlib.sha256(binary.read_bytes()).hexdigest()}]
        packages[own["SPDXID"]] = own
        relate("SPDXRef-DOCUMENT", "DESCRIBES", own["SPDXID"])
        direct = asked_for(binary)
        for file in files[binary]:
            entry = component(file, owned)
            packages.setdefault(entry["SPDXID"], entry)
            relate(own["SPDXID"], "DYNAMIC_LINK" if file.name in direct else "DEPENDS_ON", entry["SPDXID"])
        for file in archives if name == "touchstone" else ():
            entry = component(file, owned)
            packages.setdefault(entry["SPDXID"], entry)
            relate(own["SPDXID"], "STATIC_LINK", entry["SPDXID"])
        for library, found in headers:
            if library not in HEADERS:
                sys.exit(f"sbom.py: HEADERS in packaging/sbom.py has to say under which licence {library} is")
            if library == "CLI11" and name != "touchstone":
                continue  # options of the command line: the program's alone
            entry = package(library, *HEADERS[library], found)
            packages.setdefault(entry["SPDXID"], entry)
            relate(own["SPDXID"], "STATIC_LINK", entry["SPDXID"])
    content = {"packages": list(packages.values()), "relationships": relations}
    digest = hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()
    when = datetime.datetime.fromtimestamp(int(os.environ.get("SOURCE_DATE_EPOCH") or datetime.datetime.now().timestamp()), datetime.timezone.utc)
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"touchstone-{number}",
            "documentNamespace": f"https://spdx.org/spdxdocs/touchstone-{number}-{digest}",
            "creationInfo": {"created": when.strftime("%Y-%m-%dT%H:%M:%SZ"), "creators": [f"Tool: touchstone-sbom-{number}"]}, **content}


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("binaries", metavar="BINARY", nargs="+", type=pathlib.Path)
    arguments.add_argument("--version", required=True)
    arguments.add_argument("--out", required=True, type=pathlib.Path)
    arguments.add_argument("--header", action="append", default=[], metavar="NAME=VERSION")
    arguments.add_argument("--archive", action="append", default=[], type=pathlib.Path, help="in the program itself")
    o = arguments.parse_args()
    o.out.write_text(json.dumps(document(o.binaries, [tuple(h.split("=", 1)) for h in o.header], o.archive, o.version), indent=1) + "\n")


if __name__ == "__main__":
    main()
