"""Prints states, matrices and frequencies of a SPACAR file as lines of a report."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from flexel.apps.spacar.linear_analyses import Matrices
from flexel.apps.spacar.reading import Spacar
from flexel.base.arrays import Array
from flexel.model.state import State

MAX_SIZE_SHOWN = 8  # most rows and columns of a printed matrix


def state_lines(file: Spacar, state: State) -> list[str]:
    """List all coordinates and deformations at a state, in SPACAR's numbers and signs."""
    lines = [f"coordinates at t = {state.t:g}"]
    for n in dict.fromkeys(node for node, _ in file.coordinates):
        values = [state[name] for (node, _), name in file.coordinates.items() if node == n]
        lines.append(f"  X {n:<4} " + " ".join(f"{value: .6e}" for value in values))
    lines.append("deformations (of slips: their rates)")
    for e in dict.fromkeys(element for element, _ in file.deformations):
        values = [file.deformation(state, e, i) for element, i in file.deformations if element == e]
        lines.append(f"  E {e:<4} " + " ".join(f"{value: .6e}" for value in values))
    return lines


def matrix_lines(found: Mapping[str, Array]) -> list[str]:
    """List matrices by name; large ones by their size."""
    lines = []
    for name, A in found.items():
        if max(A.shape) > MAX_SIZE_SHOWN:
            lines.append(f"{name}: {A.shape[0]} by {A.shape[1]}, written with --out")
            continue
        rows = [" ".join(f"{value: .9e}" for value in row) for row in A]
        lines += [f"{name} =", *(f"  {row}" for row in rows or ["(empty)"])]
    return lines


def linear_lines(found: Matrices) -> list[str]:
    """List all matrices of the linearized equations, with the degrees of freedom of their rows."""
    return [f"linearized in {', '.join(found.coordinates)}", *matrix_lines(found.as_dict())]


def frequency_lines(found: Iterable[complex]) -> list[str]:
    """List natural frequencies; unstable motions are marked, with their growth."""
    lines = ["natural frequencies [rad/s]"]
    for w in found:
        if not w.imag:
            lines.append(f"  {w.real: .9e}")
        elif not w.real:
            lines.append(f"  unstable: grows as exp({abs(w.imag):.9e} t)")
        else:
            lines.append(f"  unstable: {abs(w.real):.9e}, grows as exp({abs(w.imag):.9e} t)")
    return lines
