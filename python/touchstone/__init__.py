# SPDX-License-Identifier: MIT
"""Certified reference values for the elastic contact of the Weierstrass profile.

    >>> import touchstone as ts
    >>> v = ts.eval("contact.area", n=3, load="1/10", G="5/2", digits=30)
    >>> v.value            # str: the true value correctly rounded, every digit proven
    >>> v.lower, v.upper   # Fractions with lower <= true value <= upper
    >>> float(v)           # the binary64 number nearest to the true value

Units: pressures in p*_0, lengths in lambda_0; `quantity(name).unit` says which.
"""
from ._library import Quantity, Refused, TouchstoneError, Undecided, Value, eval, quantities, quantity, version
from ._tables import Judgement, judge, table, table_names

__all__ = ["Judgement", "Quantity", "Refused", "TouchstoneError", "Undecided", "Value", "eval", "judge", "quantities", "quantity", "table",
           "table_names", "version"]
__version__ = version()
