#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A Python code under test: westergaard.half_width, with the standard library only."""
import math
import sys

for line in sys.stdin:
    load = float.fromhex(line.split()[0])
    print((math.atan2(math.sqrt(load), math.sqrt(1 - load)) / math.pi).hex())
