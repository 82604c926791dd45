"""Prepares mode shapes for the viewer: the displacement of every part, shown with adjustable amplitude and phase."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from flexel.apps.view import drawing
from flexel.apps.view.figures import caption as printable
from flexel.apps.view.page.data import common, numbers, part
from flexel.apps.view.page.modal import SUFFIX, modal_units, modal_values, packed_values
from flexel.apps.view.page.packing import packed
from flexel.apps.view.page.series import floors
from flexel.apps.view.primitives import Shape, extent
from flexel.apps.view.scene import View, view_of
from flexel.base.arrays import Array, ComplexArray
from flexel.base.errors import ModelError
from flexel.mechanics.linearized_system import LinearizedSystem
from flexel.mechanics.modes import Mode
from flexel.model.state import State, own_state
from flexel.statics.stability import BucklingMode, Vibration

SMALL_AMPLITUDE = 1e-5  # amplitude at which parts are displaced, relative to the model
AnyMode = Mode | Vibration | BucklingMode
MODES_SHOWN = 12  # number of modes of a linearization shown by default


def mode_data(
    about: LinearizedSystem | State,
    modes: Sequence[AnyMode] | None = None,
    *,
    view: View | None = None,
    title: str = "",
    caption: str = "",
) -> dict[str, Any]:
    """Return all data that the viewer needs to show modes, in a form that can be saved to a file.

    Parameters
    ----------
    about : LinearizedSystem, or State
        The origin of the modes: a linearization, or the state of rest given to `System.vibrations` or
        `System.buckling`.
    modes : sequence of Mode, Vibration or BucklingMode, optional
        By default the slowest twelve of the linearization.
    view, title, caption
        As for a motion.

    Raises
    ------
    ModelError
        If there are no modes, or one belongs to another model.
    """
    state = about.state if isinstance(about, LinearizedSystem) else own_state_of(about)
    shown = _modes_of(about, modes)
    view, title = view_of(view, "view of modes"), printable(title, "view of modes")
    base = drawing.shapes(state, view.sketches)
    buckled = all(isinstance(mode, BucklingMode) for mode in shown)
    found = common(
        state,
        base,
        view,
        title or ("Buckling modes" if buckled else "Modes of vibration"),
        printable(caption, "view of modes", "caption"),
    )
    displaced = [_displaced(state, _coordinates(about, state, mode), base, view) for mode in shown]
    found |= {
        "times": [state.t],
        "speed": 1.0,
        "digits": 2,
        "modes": [_words(i, mode) for i, mode in enumerate(shown)],
    }
    found["floors"] = floors([state], base, found["size"])
    found["units"] = found["units"] | modal_units()
    modal = found["colour"] + SUFFIX
    found["colour"] = modal if any(found["colour"] in value for value in displaced[0].values) else ""
    found["shapes"] = []
    for i, shape in enumerate(base):
        one = part(shape) | {"modes": packed_pairs([shape.rates[i] for shape in displaced])}
        one["values"] |= packed_values([shape.values[i] for shape in displaced])
        found["shapes"].append(one)
    return found


def _modes_of(about: LinearizedSystem | State, modes: Any) -> Sequence[AnyMode]:
    """Return the modes to show: those given, else the slowest of a linearization."""
    if modes is None and isinstance(about, LinearizedSystem):
        return sorted(about.modes(), key=lambda mode: mode.omega)[:MODES_SHOWN]
    listed = list(modes) if isinstance(modes, Iterable) else []
    strange = [mode for mode in listed if not isinstance(mode, AnyMode)]
    if strange or not listed:
        wrong = f"{strange[0]!r:.60} is no mode" if strange else "no modes given"
        raise ModelError(
            f"view of modes: {wrong}; give those of system.vibrations(state) or "
            "system.buckling(state), or a linearization"
        )
    return listed


@dataclass(frozen=True)
class _Displaced:
    """The motion of the parts in a mode, scaled so that the farthest vertex moves by 1.

    Attributes
    ----------
    rates : list of (ndarray, ndarray)
        Real and imaginary displacement of every part's numbers.
    values : list of dict
        Amplitudes of the values used for colouring.
    """

    rates: list[tuple[Array, Array]]
    values: list[dict[str, Array]]


def own_state_of(state: object) -> State:
    """Return the state, or raise if it is none."""
    if not isinstance(state, State):
        raise ModelError(
            f"view of modes: {type(state).__name__} is neither a linearization nor a state; give one of these"
        )
    return own_state(state.structure, state, "view of modes")


def _coordinates(about: LinearizedSystem | State, state: State, mode: AnyMode) -> ComplexArray:
    """Return the amplitudes (n,) of all coordinates in a mode."""
    s, shape = state.structure, {name: complex(amplitude) for name, amplitude in mode.shape.items()}
    found = np.zeros(s.n, dtype=complex)
    if isinstance(about, LinearizedSystem) and isinstance(mode, Mode):
        q = np.array([shape[name] for name in about.dofs])
        found[: s.nf] = about.transfer.G[:, : q.size] @ q
        return found
    if isinstance(mode, Mode):
        raise ModelError(
            "view of modes: these modes belong to a linearization; give the linearization, not the state"
        )
    for name, value in _known(shape, s.coordinate_of).items():
        found[s.coordinate_of[name]] = value
    return found


def _known(shape: Mapping[str, complex], coordinates: Mapping[str, int]) -> Mapping[str, complex]:
    strange = [name for name in shape if name not in coordinates]
    if strange:
        raise ModelError(
            f"view of modes: '{strange[0]}' is not a coordinate of this model; give modes of this model"
        )
    return shape


def _displaced(state: State, amplitude: ComplexArray, base: list[Shape], view: View) -> _Displaced:
    """Return the motion of the parts in a mode, by differences."""
    s = state.structure
    parts: list[tuple[list[Array], list[Array]]] = []
    step = SMALL_AMPLITUDE * extent(s) / max(float(np.max(np.abs(amplitude))), 1e-300)
    for direction in (amplitude.real, amplitude.imag):
        ends = [
            drawing.shapes(replace(state, x=state.x + sign * step * direction), view.sketches)
            for sign in (1, -1)
        ]
        rates = [(_same_side(numbers(a), numbers(o)) - _same_side(numbers(b), numbers(o))) / (2 * step)
                 for a, b, o in zip(*ends, base, strict=True)]  # fmt: skip
        moved = [(np.vstack(a.lines) - np.vstack(b.lines)) / (2 * step) for a, b in zip(*ends, strict=True)]
        parts.append((rates, moved))
    (re, moved_re), (im, moved_im) = parts
    farthest = max(
        float(np.max(np.sqrt(a**2 + b**2).sum(axis=1))) for a, b in zip(moved_re, moved_im, strict=True)
    )
    scale = 1 / farthest if farthest > 0 else 0.0
    values = modal_values(state, amplitude, step, view)
    return _Displaced(
        [(scale * a, scale * b) for a, b in zip(re, im, strict=True)],
        [{name: scale * x for name, x in row.items()} for row in values],
    )


def _same_side(pose: Array, base: Array) -> Array:
    """Return a pose whose quaternion has the sign nearest to that of the base."""
    if pose.size == 7 and pose[3:] @ base[3:] < 0:
        return np.concatenate([pose[:3], -pose[3:]])
    return pose


def packed_pairs(pairs: Sequence[tuple[Array, Array]]) -> str:
    """Return real and imaginary parts of every mode, one after another."""
    return packed([np.concatenate([array for pair in pairs for array in pair])])


def _words(i: int, mode: AnyMode) -> dict[str, str]:
    """Return name and description of a mode."""
    if isinstance(mode, BucklingMode):
        text = f"buckling at {mode.multiplier:.4g}"
        return {"name": f"{i + 1}: {text}", "text": text}
    if isinstance(mode, Vibration):
        hertz = abs(mode.omega) / (2 * np.pi)
        text = f"{hertz:.4g} Hz" if mode.omega >= 0 else f"unstable, {abs(mode.omega):.4g} 1/s"
        return {"name": f"{i + 1}: {text}", "text": text}
    w = mode.eigenvalue
    text = f"{w.real:.3g} ± {abs(w.imag):.4g}i 1/s" if w.imag else f"{w.real:.4g} 1/s"
    return {"name": f"{i + 1}: {mode.name}", "text": text}
