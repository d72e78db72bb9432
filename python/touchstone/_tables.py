# SPDX-License-Identifier: MIT
"""The reference tables that come with the package, and what a test suite does with them."""
from __future__ import annotations

import math
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Any, Callable, Sequence

from . import reference

_FOLDER = Path(__file__).parent / "tables"
_SHOWN = 5  # failing rows in a message


class Table(reference.Table):
    """A reference table: `rows`, each with `inputs` (floats), `value` and `error` (str); `header`; `len`."""

    def __len__(self) -> int:
        return len(self.rows)

    def __iter__(self) -> Any:
        return iter(self.rows)

    def __getitem__(self, index: Any) -> Any:
        return self.rows[index]


def table_names() -> list[str]:
    """The names of the tables that come with the package."""
    return sorted(p.stem for p in _FOLDER.glob("*.txt"))


def table(name: str) -> Table:
    """A table by its name ("westergaard_pressure") or its file. Raises CorruptTable for a damaged one."""
    path = Path(name) if name.endswith(".txt") else _FOLDER / (name + ".txt")
    if not path.exists():
        raise KeyError(f"no table '{name}'; there are {', '.join(table_names())}")
    loaded = reference.load(path)
    loaded.__class__ = Table
    return loaded


@dataclass
class Failing:
    """A row on which the code is out of its tolerance."""

    inputs: tuple[float, ...]
    answer: float
    value: str           #: the true value
    absolute: float      #: |answer - value|, no larger than it is
    ulps: float


@dataclass
class Judgement:
    """What a code did on a table. True if it holds; `assert ts.judge(...)` shows the rows that fail."""

    table: str
    rows: int
    failing: list[Failing] = field(default_factory=list)
    tolerance: str = ""

    def __bool__(self) -> bool:
        return not self.failing

    def __repr__(self) -> str:
        if not self.failing:
            return f"{self.table}: all {self.rows} rows within {self.tolerance}"
        lines = [f"{self.table}: {len(self.failing)} of {self.rows} rows are not within {self.tolerance}; the worst:"]
        for f in sorted(self.failing, key=lambda f: -f.ulps if not math.isnan(f.ulps) else -math.inf)[:_SHOWN]:
            inputs = " ".join(x.hex() for x in f.inputs)
            lines.append(f"  inputs {inputs}: answer {f.answer!r}, true value {f.value}, off by {f.absolute:.3g} ({f.ulps:.3g} ulps)")
        return "\n".join(lines)


def judge(code: Callable[..., float], name: str, *, rtol: float = 0.0, atol: float = 0.0, ulps: float | None = None,
          where: Callable[..., bool] | None = None, forgive_inputs: bool = True) -> Judgement:
    """Calls code(*inputs) for each row of a table, binary64 numbers in the order of its columns, in the units of `quantity(...)`.

    A row fails if |answer - true value| > atol + rtol |true value| is proven (or more than `ulps` units in the last place, if that is
    given; without any tolerance: 4 ulps), beyond what the rounding of its inputs forces on any code unless `forgive_inputs` is False.
    `where(*inputs)` chooses rows; `failing` holds all rows that fail. For pytest:

        def test_pressure():
            assert ts.judge(my_pressure, "westergaard_pressure", rtol=1e-12)
    """
    if rtol < 0 or atol < 0 or (ulps is not None and ulps < 0) or math.isnan(rtol) or math.isnan(atol):
        raise ValueError("tolerances must be >= 0")
    if ulps is None and rtol == 0 and atol == 0:
        ulps = 4.0
    parts = [f"{ulps:g} ulps"] if ulps is not None else []
    parts += [f"rtol {rtol:g}"] if rtol else []
    parts += [f"atol {atol:g}"] if atol else []
    chosen = [row for row in table(name).rows if where is None or where(*row.inputs)]
    if not chosen:
        raise ValueError(f"no row of {name} is chosen")
    result = Judgement(name, len(chosen), tolerance=" + ".join(parts))
    for row in chosen:
        answer = float(code(*row.inputs))
        least = reference.ulps(answer, row.value, row.error)[0]
        off = _least_distance(answer, row)
        if not reference.within(answer, row, rtol, atol, ulps or 0.0, forgive_inputs):
            result.failing.append(Failing(row.inputs, answer, row.value, float(off) if math.isfinite(answer) else math.inf, least))
    return result


def _least_distance(answer: float, row: Any) -> Fraction:
    if not math.isfinite(answer):
        return Fraction(0)
    return max(abs(Fraction(answer) - Fraction(row.value)) - Fraction(row.error), Fraction(0))


__all__: Sequence[str] = ("Failing", "Judgement", "Table", "judge", "table", "table_names")
