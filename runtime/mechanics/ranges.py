"""Compares elements with the ranges in which they are valid, which their pages declare (`flexel.derive.ValidRange`)."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from flexel.base.arrays import Array
from flexel.base.callers import outside
from flexel.base.errors import RangeWarning
from flexel.derive.spec import OutputSpec
from flexel.engine.evaluate import Evaluation

ROUNDING = 1e-9  # of a measure relative to its limit
_part_of_another: ContextVar[bool] = ContextVar("part_of_another", default=False)


@dataclass(frozen=True)
class Compared:
    """The elements compared with their ranges.

    Attributes
    ----------
    share : float
        The largest measure, relative to its limit; not a number if no element has a range.
    texts : list of str
        What to say about the elements that are farthest beyond a limit, one for each kind of range.
    """

    share: float
    texts: list[str]


@contextmanager
def warned_together() -> Iterator[None]:
    """Suppress the warnings of analyses within another one, which warns once for all their states."""
    token = _part_of_another.set(True)
    try:
        yield
    finally:
        _part_of_another.reset(token)


def warn_beyond(evaluation: Evaluation, times: ArrayLike, e: Array, x: Array, analysis: str) -> None:
    """Warn, at the caller of an analysis, of what `compared` finds; parameters as there, and the analysis by name."""
    for text in compared(evaluation, times, e, x).texts if evaluation.ranged else ():
        warnings.warn(f"{analysis}: {text}", RangeWarning, stacklevel=outside())


def compared(evaluation: Evaluation, times: ArrayLike, e: Array, x: Array) -> Compared:
    """Compare all elements with their ranges; report nothing within another analysis.

    Parameters
    ----------
    evaluation : Evaluation
    times : array_like (states,)
    e : ndarray (states, m)
        Deformations.
    x : ndarray (states, n)
        Coordinates.
    """
    found: dict[OutputSpec, list[tuple[list[str], Array]]] = {}
    if not _part_of_another.get() and len(e):
        for table in evaluation.ranged:
            outputs = table.evaluate(x, e, np.broadcast_to(table.nothing, (len(x), table.nothing.size)))
            for output in table.spec.outputs:
                if output.limit:
                    found.setdefault(_kind(output), []).append((table.names, outputs[output.name]))
    shares, texts = [], []
    for output, parts in found.items():
        values = np.concatenate([measured for _, measured in parts], axis=1)
        shares.append(float(values[..., 0].max()) / output.limit)
        if shares[-1] > 1:
            texts.append(
                _text(output, [name for names, _ in parts for name in names], values, np.asarray(times))
            )
    return Compared(max(shares, default=np.nan), texts)


def _kind(output: OutputSpec) -> OutputSpec:
    """Return what ranges of several types of elements have in common."""
    return OutputSpec(output.name, (), (), output.unit, limit=output.limit, beyond=output.beyond)


def _text(output: OutputSpec, names: Sequence[str], values: Array, times: Array) -> str:
    """Say which element is farthest beyond a limit, from measures and errors (states, elements, 2)."""
    measures = values[..., 0]
    when, which = (int(i) for i in np.unravel_index(int(np.argmax(measures)), measures.shape))
    value, error = (float(number) for number in values[when, which])
    unit = {"°": "°", "1": ""}.get(output.unit, f" {output.unit}")
    where = (
        f" at t = {times[when]:g} s" if times.size > 1 else ""
    )  # of one state none: a loop repeats no warning
    far = int((measures.max(axis=0) > output.limit).sum())
    where += f" ({far - 1} more by more than {output.limit:g}{unit})" if far > 1 else ""
    count = int(np.ceil(value / output.limit - ROUNDING))
    digits = f"{float(f'{error:.2g}'):g}"
    told = output.beyond.format(value=value, error=error, digits=digits, where=where, count=count)
    return f"'{names[which]}' {told}"
