# SPDX-License-Identifier: MIT
"""A certificate may ask for tables as large as it likes within its limits: what needs more memory than this is refused, before the machine
is out of it."""
try:
    import resource
except ImportError:  # not a Unix: there the system's own limit holds
    resource = None

MOST = 6 << 30  # bytes of address space


def bound():
    """from here on, MemoryError is raised instead of taking more"""
    if resource:
        of_all = resource.getrlimit(resource.RLIMIT_AS)[1]
        resource.setrlimit(resource.RLIMIT_AS, (MOST if of_all == resource.RLIM_INFINITY else min(MOST, of_all), of_all))
