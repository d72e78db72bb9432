# SPDX-License-Identifier: MIT
"""The checker's programs without a process of their own: a start of Python takes longer than most answers, of which there are hundreds."""
import contextlib
import io
import subprocess
import sys
import unittest.mock


def ask(program, *arguments):
    """What the module check or certificate says as a program, and its exit code; an exception that it does not know how to say goes on to the test."""
    out, err = io.StringIO(), io.StringIO()
    with (unittest.mock.patch.object(sys, "argv", [f"{program.__name__}.py", *map(str, arguments)]), unittest.mock.patch("memory.bound"),
          contextlib.redirect_stdout(out), contextlib.redirect_stderr(err)):
        try:
            code = program.main()
        except SystemExit as end:
            code = end.code
    return subprocess.CompletedProcess(arguments, code or 0, out.getvalue(), err.getvalue())
