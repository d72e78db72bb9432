#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""pip install of the clone into a fresh virtual environment without network, then its tests.

usage: test_wheel.py SOURCE LIBRARY
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import venv

source, library = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
with tempfile.TemporaryDirectory() as folder:
    venv.create(folder, with_pip=True, system_site_packages=True)  # pytest and numpy, if the system has them
    python = f"{folder}/bin/python"
    environment = {**os.environ, "TOUCHSTONE_LIBRARY": str(library), "PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1", "PIP_CONFIG_FILE": os.devnull}
    subprocess.run([python, "-m", "pip", "install", "--quiet", "--force-reinstall", "--no-deps", str(source)], check=True, env=environment)
    del environment["TOUCHSTONE_LIBRARY"]  # the wheel has its own
    has_pytest = subprocess.run([python, "-c", "import pytest"], capture_output=True).returncode == 0
    tests = shutil.copy(source / "python/test_touchstone.py", folder)  # away from the source package, which has no library beside it
    runner = ["-m", "pytest", "-q", "-p", "no:cacheprovider", tests] if has_pytest else [tests]
    r = subprocess.run([python, "-B", *runner], cwd=folder, env=environment)
    where = subprocess.run([python, "-c", "import touchstone; print(touchstone.__file__)"], cwd=folder, env=environment, capture_output=True, text=True, check=True).stdout
    if not where.startswith(folder):
        sys.exit(f"the package that was tested is not the installed one: {where}")
sys.exit(r.returncode)
