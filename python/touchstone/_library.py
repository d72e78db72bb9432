# SPDX-License-Identifier: MIT
"""touchstone.h through ctypes: the standard library is enough."""
from __future__ import annotations

import ctypes
import math
import os
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any, Union

Number = Union[int, float, str, Fraction]

_ABI = 1
_OK, _UNDECIDED, _USAGE, _BAD_INPUT = 0, 2, 64, 65
_STATUS = ("exact", "certified", "estimated", "undecided", "refused")
_MESSAGE = 1024


class TouchstoneError(Exception):
    """An error of the library, or of the way it was called."""


class Refused(TouchstoneError, ValueError):
    """An input is no number, or out of the quantity's domain."""


class Undecided(TouchstoneError, ArithmeticError):
    """A number was asked for that is not decided."""


def _load() -> ctypes.CDLL:
    here = Path(__file__).parent
    places = [os.environ.get("TOUCHSTONE_LIBRARY"), here / "libtouchstone.so.1", "libtouchstone.so.1"]
    for place in places:
        if place is None or (isinstance(place, Path) and not place.exists()):
            continue
        library = ctypes.CDLL(str(place))
        if library.touchstone_abi() != _ABI:
            raise ImportError(f"{place} has the interface {library.touchstone_abi()} where {_ABI} is needed")
        return library
    raise ImportError("libtouchstone.so.1 is not there")


_lib = _load()
_text, _size, _handle = ctypes.c_char_p, ctypes.c_size_t, ctypes.c_void_p
_doubles, _ints = ctypes.POINTER(ctypes.c_double), ctypes.POINTER(ctypes.c_int)
for _name, _result, _arguments in (
    ("version", _text, []),
    ("eval", ctypes.c_int, [_text, _text, ctypes.c_long, _text, ctypes.POINTER(_handle), _text, _size]),
    ("eval_rows", ctypes.c_int, [_text, _doubles, _size, _size, _doubles, _ints, _text, _size]),
    ("free", None, [_handle]),
    ("decimal", _text, [_handle]),
    ("error", _text, [_handle]),
    ("status", ctypes.c_int, [_handle]),
    ("note", _text, [_handle]),
    ("double", ctypes.c_double, [_handle]),
    ("digits", ctypes.c_long, [_handle]),
    ("quantity", _text, [_size]),
    ("quantity_text", _text, [_text, _text]),
    ("quantity_input", _text, [_text, _size]),
):
    _function = getattr(_lib, "touchstone_" + _name)
    _function.restype, _function.argtypes = _result, _arguments


def version() -> str:
    """The version of the library."""
    return _lib.touchstone_version().decode()


@dataclass(frozen=True)
class Value:
    """A quantity's value. `value` is a str because no binary number holds its digits."""

    value: str      #: the true value, correctly rounded; every digit proven if `status` is exact or certified
    error: str      #: bound of |value - true value|, proven unless `status` is estimated
    status: str     #: exact, certified, estimated or undecided
    digits: int     #: significant digits in `value`
    note: str       #: why undecided, or why only estimated
    unit: str       #: p*_0, lambda_0 ...
    binary64: float  #: the binary64 number nearest to the true value, nan if not decided

    @property
    def lower(self) -> Fraction:
        """No larger than the true value (proven unless estimated)."""
        return self._decided() - Fraction(self.error)

    @property
    def upper(self) -> Fraction:
        """No smaller than the true value (proven unless estimated)."""
        return self._decided() + Fraction(self.error)

    def _decided(self) -> Fraction:
        if self.value == "nan":
            raise Undecided(self.note)
        return Fraction(self.value)

    def __float__(self) -> float:
        if math.isnan(self.binary64):
            raise Undecided(self.note or "the nearest binary64 number is not decided")
        return self.binary64

    def __str__(self) -> str:
        return self.value


@dataclass(frozen=True)
class Quantity:
    """What a name stands for."""

    name: str
    equation: str     #: number in the paper
    unit: str
    domain: str
    description: str
    inputs: tuple[str, ...]


def quantity(name: str) -> Quantity:
    """A quantity by its name. Raises TouchstoneError if there is none."""
    texts = [_lib.touchstone_quantity_text(name.encode(), what) for what in (b"equation", b"unit", b"domain", b"description")]
    if texts[0] is None:
        raise TouchstoneError(f"unknown quantity '{name}'")
    inputs = []
    while (key := _lib.touchstone_quantity_input(name.encode(), len(inputs))) is not None:
        inputs.append(key.decode())
    return Quantity(name, *(t.decode() for t in texts), tuple(inputs))


def quantities() -> list[str]:
    """The names of all quantities."""
    names: list[str] = []
    while (name := _lib.touchstone_quantity(len(names))) is not None:
        names.append(name.decode())
    return names


def _exact(key: str, x: Number) -> str:
    """A number as the library reads it, exactly: a float is the binary number it is, not the decimal it prints as."""
    if isinstance(x, str):
        if any(c.isspace() for c in x.strip()) or not x.strip():
            raise Refused(f"{key} = '{x}' is not a number")
        return x.strip()
    if hasattr(x, "item"):  # a numpy scalar
        x = x.item()
    if isinstance(x, float):
        if not math.isfinite(x):
            raise Refused(f"{key} = {x}: must be finite")
        return x.hex()
    if isinstance(x, (int, Fraction)) and not isinstance(x, bool):
        return str(x)
    raise Refused(f"{key} = {x!r}: give an int, a float, a Fraction or a str such as '1/10' or 'sqrt(10)'")


def _is_array(x: Any) -> bool:
    return isinstance(x, (list, tuple, range)) or getattr(x, "ndim", 0) > 0


def eval(name: str, *, digits: int = 20, rounding: str = "nearest", **inputs: Any) -> Any:
    """The true value of a quantity at exact inputs, correctly rounded to `digits` significant digits.

    Inputs are int, float (the binary64 number that it is), Fraction or str ("1/10", "0.1" = 1/10, "0x1.8p-3", "sqrt(10)").
    Pressures are in p*_0, lengths in lambda_0. `rounding`: nearest, up, down, zero, away.

    If any input is a list, tuple or numpy array, all of them are taken together as arrays (single numbers for every place) and as
    binary64 numbers, and the result is an array of the nearest binary64 numbers (a numpy array if numpy is there, of the shape of the
    inputs, else a list), nan where a value is not decided.

    Raises Refused for an input that is out of domain, TouchstoneError for a wrong name.
    """
    if any(_is_array(x) for x in inputs.values()):
        if rounding != "nearest":
            raise TouchstoneError("arrays are rounded to the nearest binary64 numbers")
        return _eval_rows(name, inputs)
    words = " ".join(f"{key}={_exact(key, x)}" for key, x in inputs.items())
    handle, message = _handle(), ctypes.create_string_buffer(_MESSAGE)
    code = _lib.touchstone_eval(name.encode(), words.encode(), digits, rounding.encode(), ctypes.byref(handle), message, _MESSAGE)
    if code not in (_OK, _UNDECIDED):
        _raise(code, message)
    try:
        return Value(_lib.touchstone_decimal(handle).decode(), _lib.touchstone_error(handle).decode(), _STATUS[_lib.touchstone_status(handle)],
                     _lib.touchstone_digits(handle), _lib.touchstone_note(handle).decode(),
                     _lib.touchstone_quantity_text(name.encode(), b"unit").decode(), _lib.touchstone_double(handle))
    finally:
        _lib.touchstone_free(handle)


def _raise(code: int, message: Any) -> None:
    raise (Refused if code == _BAD_INPUT else TouchstoneError)(message.value.decode())


def _eval_rows(name: str, given: dict[str, Any]) -> Any:
    order = quantity(name).inputs
    for key in given:
        if key not in order:
            raise TouchstoneError(f"unknown key '{key}'; {name} takes {', '.join(order)}")
    for key in order:
        if key not in given:
            raise TouchstoneError(f"missing key '{key}'; {name} takes {', '.join(order)}")
    columns, shape = _columns([given[key] for key in order])
    rows = len(columns[0])
    flat = (ctypes.c_double * (rows * len(order)))(*(x for row in zip(*columns) for x in row))
    values, how, message = (ctypes.c_double * rows)(), (ctypes.c_int * rows)(), ctypes.create_string_buffer(_MESSAGE)
    code = _lib.touchstone_eval_rows(name.encode(), flat, rows, len(order), values, how, message, _MESSAGE)
    if code not in (_OK, _UNDECIDED):
        _raise(code, message)
    if shape is None:
        return list(values)
    import numpy

    return numpy.array(values).reshape(shape)


def _columns(given: list[Any]) -> tuple[list[list[float]], Any]:
    """The inputs as columns of equal length, and the shape of the result if numpy is there."""
    try:
        import numpy
    except ImportError:
        lengths = {len(x) for x in given if _is_array(x)}
        if len(lengths) != 1:
            raise Refused(f"arrays of different lengths: {sorted(lengths)}") from None
        rows = lengths.pop()
        return [[float(y) for y in x] if _is_array(x) else [_double(x)] * rows for x in given], None
    arrays = numpy.broadcast_arrays(*[numpy.asarray(x, dtype=float) if _is_array(x) else _double(x) for x in given])
    return [a.ravel().tolist() for a in arrays], arrays[0].shape


def _double(x: Number) -> float:
    try:
        return float(Fraction(x)) if isinstance(x, str) else float(x)
    except ValueError:
        raise Refused(f"'{x}' is not a number for an array") from None
