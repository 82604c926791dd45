"""Springs, dampers and stops: the methods of `Model` that give free deformations and slips their forces."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from flexel.base.arguments import array, not_negative, number, positive, unknown, vector
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.transactions import whole_or_nothing
from flexel.declare.curves import Curve
from flexel.declare.declarations import Declarations
from flexel.declare.displacements import displacement
from flexel.declare.formulas import of_both
from flexel.declare.laws import Laws
from flexel.declare.signs import refuse_negative
from flexel.generated.table import LAWS

DEFORMATIONS, SLIPS = 6, 3  # of one linear law, at most
Given = float | Sequence[Sequence[float]] | Array | Curve | Callable[..., Any]


class Springs(Laws):
    """Springs, dampers and stops."""

    @whole_or_nothing
    def spring(
        self,
        on: str | tuple[str, str] | list[str],
        stiffness: Given | None = None,
        damping: Given | None = None,
        *,
        free_length: Any = None,
        preload: Any = None,
        energy: Callable[..., Any] | None = None,
        ranges: Mapping[str, tuple[float, float]] | None = None,
    ) -> None:
        """Attach a spring, a damper or both: force = preload + stiffness e + damping ė, opposing growth of e.

        Parameters
        ----------
        on : str, tuple of two str, or list of str
            A deformation; or a coordinate of a point or planar angle, counted from its drawn value, for a spring to
            the ground; or a slip, which takes damping alone.  A pair: the first less the second.  A list: up to six
            (or three slips) that matrices couple.  All become free.
        stiffness : float, matrix, Curve or callable, optional
            A number [N/m or N m/rad]; for a list a symmetric matrix without negative eigenvalues; a `Curve`; or a
            formula of e, or of e and ed, as in `law`.  None gives a damper without a spring.
        damping : float, matrix, Curve or callable, optional
            The same for the rate: a curve that is zero at rest, or a formula of the rate.
        free_length : float or sequence of float, optional
            Where the spring has no force: for the ``elongation`` of a bar or beam its length [m], for any other
            deformation its value, for a pair the difference.  Curves and formulas are functions of e less this value,
            or of the length less this length; with ``free_length=0`` of the length itself.
        preload : float or sequence of float, optional
            Force as drawn [N or N m], in place of a free length.
        energy : callable(e), optional
            Stored energy [J] of a formula for the stiffness, of the same e; found as in `law` by default.
        ranges : mapping of str to (float, float), optional
            Lowest and highest ``e`` and ``ed`` of formulas, as in `law`.

        Raises
        ------
        ModelError
            A quantity that cannot carry this spring, negative stiffness or damping, free length and preload together.

        Examples
        --------
        >>> m.spring("strut.elongation", 2e4, 300.0, free_length=0.42)  # doctest: +SKIP
        >>> m.spring("A.x", 200.0)  # to the ground  # doctest: +SKIP
        >>> m.spring(("left.angle", "right.angle"), damping=0.3)  # doctest: +SKIP
        >>> m.spring(["mount.along", "mount.across"], [[800, 50], [50, 200]])  # doctest: +SKIP
        >>> m.spring("strut.elongation", fx.Curve([[0, 3e4]]), fx.Curve.through(speeds, forces))  # doctest: +SKIP
        >>> m.spring("strut.elongation", lambda e: 2e4 * e + 3e6 * e**3)  # doctest: +SKIP
        """
        target = _target(on)
        _refuse_without_formula(target, stiffness, damping, energy, ranges)
        if stiffness is None and damping is None and preload is None:
            raise ModelError(f"{target.owner}: neither stiffness nor damping; give one of them")
        if _on_slips(self, target):
            for what, value in (("stiffness", stiffness), ("free_length", free_length), ("preload", preload)):
                if value is not None and not (np.isscalar(value) and value == 0):
                    raise ModelError(
                        f"{target.owner}: a slip has only a rate and takes no {what}; give damping alone"
                    )
            self._damp_slips(target, 0.0 if damping is None else damping)
            return
        places = tuple(displacement(self, z, target.owner) for z in target.names)
        named, target = target.names, replace(target, names=places)
        if len(places) > DEFORMATIONS:
            raise ModelError(
                f"{target.owner}: {len(places)} deformations; name 1 to {DEFORMATIONS}, each once; "
                "several springs on some of them add up"
            )
        free = _free(self, target, free_length, stiffness, preload)
        if _shaped(target, stiffness):
            if preload is not None:
                raise ModelError(f"{target.owner}: a curve or formula holds its own preload; add it there")
            self._add_shaped(target, stiffness, float(free[0]), energy, ranges)
            stiffness = None
        if _shaped(target, damping):
            self._add_damper(target, damping, ranges)
            damping = None
        if stiffness is None and damping is None and preload is None:
            return
        S, D = target.matrix(stiffness, "stiffness"), target.matrix(damping, "damping")
        force = target.forces(preload) if free_length is None else -S @ free
        self._add_linear(target.owner, places, S, D, force, " ".join(named))

    def _add_shaped(
        self,
        target: _Target,
        shape: Any,
        free: float,
        energy: Callable[..., Any] | None,
        ranges: Mapping[str, tuple[float, float]] | None,
    ) -> None:
        """A spring by a curve or formula, of the deformation less the free one."""
        if isinstance(shape, Curve):
            self._add_law(target.owner, LAWS["spring_curve"], target.names, shape.parameters(-free))
            return
        force = of_both(shape)
        if not free:
            self._add_formula(target.owner, target.names, force, energy, ranges)
            return
        stored = energy and (lambda e: energy(e - free))
        limits = _moved(target.owner, ranges, free)
        self._add_formula(target.owner, target.names, lambda e, ed: force(e - free, ed), stored, limits)

    def _add_damper(
        self, target: _Target, shape: Any, ranges: Mapping[str, tuple[float, float]] | None
    ) -> None:
        """A damper by a curve or formula of the rate."""
        if not isinstance(shape, Curve):
            self._add_formula(target.owner, target.names, lambda e, ed: shape(ed), ranges=ranges)
            return
        if not shape.rests():
            raise ModelError(
                f"{target.owner}: damping gives {shape(0.0):g} at rest; the force of a damper must be zero there"
            )
        values = shape.parameters(0.0)
        del values["stored"]
        self._add_law(target.owner, LAWS["damper_curve"], target.names, values)

    def _damp_slips(self, target: _Target, damping: Any) -> None:
        """Viscous resistance to one to three slips."""
        k = len(target.names)
        if k > SLIPS:
            raise ModelError(f"{target.owner}: {k} slips; name 1 to {SLIPS}, each once")
        if isinstance(damping, Curve) or callable(damping):
            raise ModelError(
                f"{target.owner}: a slip takes a number or matrix for damping; for more compile a law with "
                "fx.compile_law"
            )
        C = target.matrix(damping, "damping")
        self._add_law(target.owner, LAWS[f"viscous_{k}"], target.names, {"C": C[np.triu_indices(k)]})

    def mass_damping(self, element: str, rate: float) -> None:
        """Resist the motion of an element by `rate` [1/s] times its momentum: mass-proportional Rayleigh damping.

        The stiffness-proportional part is the `damping` of springs and beams.  The force is -rate M v, with M the
        element's own consistent mass matrix; rigid-body motion of the whole mechanism is damped too.

        Raises
        ------
        ModelError
            An unknown element, one without mass, a negative rate.
        """
        owner = f"mass_damping of '{element}'"
        if not isinstance(element, str) or element not in self.instances:
            raise ModelError(f"{owner}: {unknown(str(element), self.instances, 'element')}")
        if "inertia" not in self.instances[element].spec.kernels:
            raise ModelError(
                f"{owner}: a {self.instances[element].spec.name} has no mass; name a body or a beam"
            )
        share = not_negative(rate, owner, "rate")
        self.instances[element] = replace(self.instances[element], mass_damping=share)

    def stop(self, name: str, gap: float, stiffness: float, damping: float = 0.0) -> None:
        """Attach a one-sided stop: σ = stiffness (e - gap) (1 + damping ė) beyond the gap, never pulling.

        Parameters
        ----------
        name : str
            A deformation, which becomes free.
        gap : float
            Deformation at which contact begins.
        stiffness : float
            [N/m or N m/rad]
        damping : float
            Loss relative to the elastic force, for unit rate [s/m or s/rad].
        """
        owner = f"stop on '{name}'"
        values = {
            "gap": number(gap, owner, "gap"),
            "stiffness": positive(stiffness, owner, "stiffness"),  # a stop needs a stiffness
            "damping": number(damping, owner, "damping"),
        }
        self._add_law(owner, LAWS["stop"], [name], values)


@dataclass(frozen=True)
class _Target:
    """Target of a spring: its names, and the weight of each name in one quantity; no weights for a list."""

    owner: str
    names: tuple[str, ...]
    shares: tuple[float, ...] | None

    def matrix(self, value: Any, what: str) -> Array:
        """Stiffness or damping (m, m); zero for none."""
        m = len(self.names)
        if value is None:
            return np.zeros((m, m))
        if self.shares is None:
            return _symmetric(value, self.owner, what, m)
        return not_negative(value, self.owner, what) * np.outer(self.shares, self.shares)

    def forces(self, preload: Any) -> Array:
        """Preload (m,); zero for none."""
        if preload is None:
            return np.zeros(len(self.names))
        if self.shares is None:
            return vector(preload, self.owner, "preload", len(self.names))
        return number(preload, self.owner, "preload") * np.array(self.shares)


def _target(on: Any) -> _Target:
    """One name, a pair or a list, checked."""
    if isinstance(on, str):
        return _Target(f"spring on '{on}'", (on,), (1.0,))
    if not isinstance(on, (tuple, list)) or not on or not all(isinstance(z, str) for z in on):
        raise ModelError(
            f"spring: {on!r:.60} is not the name of a quantity; give one, a pair ('first', 'second') for their "
            "difference, or a list ['…', '…'] with matrices"
        )
    pair = isinstance(on, tuple)
    shown = " and ".join(f"'{z}'" for z in on) if pair else ", ".join(f"'{z}'" for z in on)
    owner = f"spring between {shown}" if pair else f"spring on {shown}"
    if pair and len(on) != 2:
        raise ModelError(
            f"{owner}: a pair has two names and {len(on)} are given; couple more by a list and matrices"
        )
    if len(set(on)) < len(on):
        remedy = "a quantity does not change against itself; name another one" if pair else "name each once"
        raise ModelError(f"{owner}: a name is given twice; {remedy}")
    return _Target(owner, tuple(on), (1.0, -1.0) if pair else None)


def _on_slips(model: Declarations, target: _Target) -> bool:
    """Whether the names are slips of elements; a ModelError if some are and others are not."""
    found = []
    for name in target.names:
        instance = model.instances.get(name.rpartition(".")[0])
        found.append(instance is not None and name in instance.slips)
    if any(found) and not all(found):
        slip = target.names[found.index(True)]
        raise ModelError(
            f"{target.owner}: '{slip}' is a slip but not all of them are; give it a separate damper"
        )
    return any(found)


def _refuse_without_formula(target: _Target, stiffness: Any, damping: Any, energy: Any, ranges: Any) -> None:
    """Raise a ModelError for an energy or ranges where there is no formula that takes them."""
    formulas = [value for value in (stiffness, damping) if callable(value) and not isinstance(value, Curve)]
    if energy is not None and not any(stiffness is value for value in formulas):
        raise ModelError(
            f"{target.owner}: energy is that of a formula; give the stiffness as one, or drop it"
        )
    if ranges is not None and not formulas:
        raise ModelError(f"{target.owner}: ranges are those of a formula; give one, or drop them")


def _moved(
    owner: str, ranges: Mapping[str, tuple[float, float]] | None, free: float
) -> Mapping[str, tuple[float, float]] | None:
    """Ranges of the deformation, from those of the deformation less the free one."""
    if not isinstance(ranges, Mapping) or "e" not in ranges:
        return ranges
    low, high = vector(ranges["e"], owner, "range of e", 2) + free
    return {**ranges, "e": (low, high)}


def _shaped(target: _Target, value: Any) -> bool:
    """Whether a stiffness or damping is a curve or formula; on one deformation only."""
    shaped = isinstance(value, Curve) or callable(value)
    if shaped and len(target.names) > 1:
        raise ModelError(
            f"{target.owner}: a curve or formula acts on one deformation; measure the difference by an element, or "
            "compile a law with fx.compile_law"
        )
    return shaped


def _free(model: Declarations, target: _Target, free_length: Any, stiffness: Any, preload: Any) -> Array:
    """Values (m,) of the deformations at which the spring has no force; for a pair, the first takes the whole value."""
    m, owner = len(target.names), target.owner
    if free_length is None:
        return np.zeros(m)
    if stiffness is None:
        raise ModelError(f"{owner}: free_length without a stiffness has no effect; give one, or drop it")
    if preload is not None:
        raise ModelError(
            f"{owner}: free_length and preload are both given; drop one, it follows from the other"
        )
    if target.shares is None:
        given = vector(free_length, owner, "free_length", m)
    else:
        given = np.concatenate([[number(free_length, owner, "free_length")], np.zeros(m - 1)])
    if target.shares is not None and m > 1:
        return given
    return np.array([_deformation(model, *z, owner) for z in zip(target.names, given, strict=True)])


def _deformation(model: Declarations, name: str, free: float, owner: str) -> float:
    """The value of a deformation at its free length: less the length as drawn for a bar or beam."""
    element, _, deformation = name.rpartition(".")
    instance = model.instances.get(element)
    if deformation != "elongation" or instance is None or "l0" not in instance.parameters:
        return free
    return not_negative(free, owner, "free_length") - float(instance.parameters["l0"][0])


def _symmetric(value: Any, owner: str, what: str, m: int) -> Array:
    A = array(value, owner, what)
    if A.shape != (m, m):
        raise ModelError(f"{owner}: {what} has shape {A.shape}; give ({m}, {m})")
    size = float(np.max(np.abs(A)))
    if np.max(np.abs(A - A.T)) > 1e-12 * size:
        raise ModelError(
            f"{owner}: {what} {A.tolist()} is not symmetric and has no energy; make it symmetric"
        )
    refuse_negative(A, owner, what)
    return (A + A.T) / 2
