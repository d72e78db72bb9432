# SPDX-License-Identifier: MIT
"""The checker without a process of its own, whose start takes longer than most of its answers."""
import contextlib
import io
import subprocess
import sys
import unittest.mock


def check(*arguments):
    """What `check.py ARGUMENTS` says, and with which exit code; an exception that it does not know how to say goes on to the test."""
    import check as checker  # of the folder that the test has put into sys.path
    out, err = io.StringIO(), io.StringIO()
    with (unittest.mock.patch.object(sys, "argv", ["check.py", *map(str, arguments)]), unittest.mock.patch("memory.bound"),
          contextlib.redirect_stdout(out), contextlib.redirect_stderr(err)):
        try:
            code = checker.main()
        except SystemExit as end:
            code = end.code
    return subprocess.CompletedProcess(arguments, code or 0, out.getvalue(), err.getvalue())
