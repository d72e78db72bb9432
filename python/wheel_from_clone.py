# SPDX-License-Identifier: MIT
"""The PEP 517 backend of this clone, on the standard library alone: CMake builds libtouchstone.so, a zip file is the wheel.

TOUCHSTONE_LIBRARY=/path/to/libtouchstone.so.1 takes a library that is built already.
"""
import base64
import csv
import hashlib
import io
import os
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NAME = "touchstone_contact"
LIBRARY = "libtouchstone.so.1"


def _version():
    found = re.search(r"project\(touchstone VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())
    if found is None:
        raise RuntimeError("CMakeLists.txt has no version")
    return found.group(1)


def _metadata():
    return (f"Metadata-Version: 2.1\nName: touchstone-contact\nVersion: {_version()}\n"
            "Summary: Certified reference values for the elastic contact of the Weierstrass profile\nLicense: MIT\nRequires-Python: >=3.9\n\n"
            + (ROOT / "python/README.md").read_text())


def _library(folder):
    """The shared library, built in `folder` unless one is there."""
    given = os.environ.get("TOUCHSTONE_LIBRARY")
    if given:
        return Path(given).read_bytes()
    build = Path(folder) / "build"
    ninja = ["-G", "Ninja"] if any((Path(p) / "ninja").exists() for p in os.environ.get("PATH", "").split(os.pathsep)) else []
    subprocess.run(["cmake", "-S", str(ROOT), "-B", str(build), *ninja, "-DCMAKE_BUILD_TYPE=Release", "-DTOUCHSTONE_PROGRAM=OFF", "-DTOUCHSTONE_TESTS=OFF", "-DTOUCHSTONE_C_LIBRARY=ON"],
                   check=True, stdout=sys.stderr)
    subprocess.run(["cmake", "--build", str(build), "--target", "touchstone_c", "--parallel"], check=True, stdout=sys.stderr)
    return (build / "lib" / LIBRARY).read_bytes()


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    info = f"{NAME}-{_version()}.dist-info"
    files = {}
    for path in sorted((ROOT / "python/touchstone").iterdir()):
        if path.suffix == ".py" or path.name == "py.typed":
            files[f"touchstone/{path.name}"] = path.read_bytes()
    files["touchstone/reference.py"] = (ROOT / "lib/touchstone/client/touchstone_reference.py").read_bytes()
    for path in sorted((ROOT / "data/reference").glob("*.txt")):
        files[f"touchstone/tables/{path.name}"] = path.read_bytes()
    with tempfile.TemporaryDirectory() as folder:
        files[f"touchstone/{LIBRARY}"] = _library(folder)
    files[f"{info}/METADATA"] = _metadata().encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: wheel_from_clone\nRoot-Is-Purelib: false\nTag: py3-none-{platform}\n".encode()
    files[f"{info}/licenses/MIT.txt"] = (ROOT / "LICENSES/MIT.txt").read_bytes()
    record = io.StringIO()
    rows = csv.writer(record, lineterminator="\n")
    for name, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        rows.writerow([name, f"sha256={digest}", len(data)])
    rows.writerow([f"{info}/RECORD", "", ""])
    files[f"{info}/RECORD"] = record.getvalue().encode()
    wheel = f"{NAME}-{_version()}-py3-none-{platform}.whl"
    with zipfile.ZipFile(Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            archive.writestr(zipfile.ZipInfo(name, (2026, 1, 1, 0, 0, 0)), data, zipfile.ZIP_DEFLATED)
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    base = f"{NAME}-{_version()}"
    listed = subprocess.run(["git", "-C", str(ROOT), "ls-files", "-z"], check=True, capture_output=True).stdout.decode().split("\0")
    with tarfile.open(Path(sdist_directory) / f"{base}.tar.gz", "w:gz") as archive:
        data = _metadata().encode()
        entry = tarfile.TarInfo(f"{base}/PKG-INFO")
        entry.size = len(data)
        archive.addfile(entry, io.BytesIO(data))
        for name in filter(None, listed):
            archive.add(ROOT / name, f"{base}/{name}")
    return f"{base}.tar.gz"
