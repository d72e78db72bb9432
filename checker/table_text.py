# SPDX-License-Identifier: MIT
"""The text of a file of numbers, and JSON in it, that all readers take for the same."""
import json

LONGEST_FILE = 1 << 26


class Unreadable(Exception):
    pass


def text_of(path):
    """a character a byte"""
    try:
        with open(path, encoding="latin-1", newline="") as file:
            text = file.read(LONGEST_FILE + 1)
    except OSError as reason:
        raise Unreadable(f"{path}: {reason}") from None
    if len(text) > LONGEST_FILE:
        raise Unreadable(f"{path}: longer than any table")
    if "\r" in text:
        raise Unreadable(f"{path}: has carriage returns; its line ends were changed")
    return text


def once(pairs):
    """an object of JSON, whose readers would differ on a key that comes twice"""
    if len(dict(pairs)) < len(pairs):
        raise ValueError("a key comes twice")
    return dict(pairs)


def json_of(line):
    """no integer in it is so long that it takes a while; NaN, which some readers take, is refused as no integer"""
    return json.loads(line, object_pairs_hook=once, parse_constant=int, parse_int=lambda digits: int(digits) if len(digits) < 20 else float(digits))
