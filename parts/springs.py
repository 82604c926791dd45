"""Springs, dampers and stops: parts that give free deformations and slips their forces."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import KW_ONLY, dataclass, replace
from typing import Any

import numpy as np

from flexel.base.arguments import array, not_negative, number, unknown, vector
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.generated.table import LAWS
from flexel.model.lowering import Lowering
from flexel.model.part import Part, part
from flexel.model.signs import refuse_negative
from flexel.parts.curves import Curve
from flexel.parts.displacements import displacement
from flexel.parts.formulas import of_all
from flexel.parts.laws import add_formula

DEFORMATIONS, SLIPS = 6, 3  # of one linear law, at most
Ranges = Mapping[str, tuple[float, float]]


@part
class Spring(Part[None]):
    """Attach a spring, a damper or both: force = preload + stiffness e + damping ė, opposing an increase of e.

    Raises
    ------
    ModelError
        A quantity that cannot carry this spring, negative stiffness or damping, both free length and preload.

    Examples
    --------
    >>> m.spring("strut.elongation", 2e4, 300.0, free_length=0.42)  # doctest: +SKIP
    >>> m.spring("A.x", 200.0)  # to the ground  # doctest: +SKIP
    >>> m.spring(("left.angle", "right.angle"), damping=0.3)  # doctest: +SKIP
    >>> m.spring(["mount.along", "mount.across"], [[800, 50], [50, 200]])  # doctest: +SKIP
    >>> m.spring("strut.elongation", fx.Curve([[0, 3e4]]), fx.Curve.through(speeds, forces))  # doctest: +SKIP
    >>> m.spring("strut.elongation", lambda e: 2e4 * e + 3e6 * e**3)  # doctest: +SKIP
    """

    on: str | tuple[str, str] | list[str] = entry(
        "A deformation; or a coordinate of a point or planar angle, counted from its drawn value, for a spring to the "
        "ground; or a slip, which takes damping alone.  A pair: the first minus the second.  A list: up to six "
        "(or three slips), coupled by matrices.  All become free."
    )
    stiffness: float | Sequence[Sequence[float]] | Array | Curve | Callable[..., Any] | None = array_quantity(
        "N/m or N m/rad",
        "A number; for a list a symmetric matrix without negative eigenvalues; a `Curve`; or a formula of e, of e "
        "and ed, or of e, ed and t, as in `law`.  None gives a damper without a spring.",
        default=None,
    )
    damping: float | Sequence[Sequence[float]] | Array | Curve | Callable[..., Any] | None = array_quantity(
        "N s/m or N m s/rad",
        "The same for the rate []; a curve must be zero at rest, a formula is one of the rate.",
        default=None,
    )
    _: KW_ONLY
    free_length: Any = array_quantity(
        "m or rad",
        "Where the spring has no force []: for the ``elongation`` of a bar or beam its length, for any other "
        "deformation its value, for a pair the difference.  Curves and formulas are functions of e minus this value, "
        "or of the length minus this length; with ``free_length=0``, of the length itself.",
        default=None,
        form="float or sequence of float, optional",
    )
    preload: Any = array_quantity(
        "N or N m",
        "Force as drawn [], instead of a free length.",
        default=None,
        form="float or sequence of float, optional",
    )
    energy: Callable[..., Any] | None = entry(
        "Stored energy [J] of a formula for the stiffness, of the same e; by default found as in `law`.",
        default=None,
    )
    ranges: Mapping[str, tuple[float, float]] | None = entry(
        "Lowest and highest ``e`` and ``ed`` of formulas, as in `law`.", default=None
    )

    @property
    def owner(self) -> str:
        """Its name in messages: by the quantities on which it acts."""
        return _target(self.on).owner

    def lower(self, to: Lowering) -> None:
        """Add its laws."""
        target = _target(self.on)
        _refuse_without_formula(self, target)
        if self.stiffness is None and self.damping is None and self.preload is None:
            raise ModelError(f"{target.owner}: neither stiffness nor damping; give one of them")
        if _on_slips(to, target):
            _damp_slips(to, self, target)
            return
        places = tuple(displacement(to, name, target.owner) for name in target.names)
        if len(places) > DEFORMATIONS:
            raise ModelError(
                f"{target.owner}: {len(places)} deformations; name 1 to {DEFORMATIONS}, each once; "
                "springs that share deformations add up"
            )
        _add_laws(to, self, replace(target, names=places), " ".join(target.names))


@dataclass(frozen=True)
class _Target:
    """Target of a spring: its names, and the weight of each name in one quantity; no weights for a list."""

    owner: str
    names: tuple[str, ...]
    shares: tuple[float, ...] | None

    def matrix(self, value: Any, what: str) -> Array:
        """Return stiffness or damping (m, m); zero for none."""
        m = len(self.names)
        if value is None:
            return np.zeros((m, m))
        if self.shares is None:
            return _symmetric(value, self.owner, what, m)
        return not_negative(value, self.owner, what) * np.outer(self.shares, self.shares)

    def forces(self, preload: Any) -> Array:
        """Return the preload (m,); zero for none."""
        if preload is None:
            return np.zeros(len(self.names))
        if self.shares is None:
            return vector(preload, self.owner, "preload", len(self.names))
        return number(preload, self.owner, "preload") * np.array(self.shares)


def _target(on: Any) -> _Target:
    """Return one name, a pair or a list, checked."""
    if isinstance(on, str):
        return _Target(f"spring on '{on}'", (on,), (1.0,))
    if not isinstance(on, (tuple, list)) or not on or not all(isinstance(name, str) for name in on):
        raise ModelError(
            f"spring: {on!r:.60} is not the name of a quantity; give one, a pair ('first', 'second') for their "
            "difference, or a list ['…', '…'] with matrices"
        )
    pair = isinstance(on, tuple)
    shown = (" and " if pair else ", ").join(f"'{name}'" for name in on)
    owner = f"spring between {shown}" if pair else f"spring on {shown}"
    if pair and len(on) != 2:
        raise ModelError(
            f"{owner}: a pair has two names, but {len(on)} are given; couple more with a list and matrices"
        )
    if len(set(on)) < len(on):
        remedy = "a quantity does not change against itself; name another one" if pair else "name each once"
        raise ModelError(f"{owner}: a name is given twice; {remedy}")
    return _Target(owner, tuple(on), (1.0, -1.0) if pair else None)


def _refuse_without_formula(spring: Spring, target: _Target) -> None:
    """Raise a ModelError for an energy or ranges where there is no formula that takes them."""
    formulas = [
        value
        for value in (spring.stiffness, spring.damping)
        if callable(value) and not isinstance(value, Curve)
    ]
    if spring.energy is not None and not any(spring.stiffness is value for value in formulas):
        raise ModelError(
            f"{target.owner}: energy belongs to a formula; give the stiffness as one, or drop it"
        )
    if spring.ranges is not None and not formulas:
        raise ModelError(f"{target.owner}: ranges belong to a formula; give one, or drop them")


def _on_slips(to: Lowering, target: _Target) -> bool:
    """Whether the names are slips of elements; a ModelError if some are and others are not."""
    found = []
    for name in target.names:
        instance = to.instances.get(name.rpartition(".")[0])
        found.append(instance is not None and name in instance.slips)
    if any(found) and not all(found):
        slip = target.names[found.index(True)]
        raise ModelError(
            f"{target.owner}: '{slip}' is a slip but not all of them are; give it a separate damper"
        )
    return any(found)


def _damp_slips(to: Lowering, spring: Spring, target: _Target) -> None:
    """Add viscous resistance to one to three slips."""
    for what in ("stiffness", "free_length", "preload"):
        value = getattr(spring, what)
        if value is not None and not (np.isscalar(value) and value == 0):
            raise ModelError(
                f"{target.owner}: a slip has only a rate and takes no {what}; give damping alone"
            )
    k = len(target.names)
    if k > SLIPS:
        raise ModelError(f"{target.owner}: {k} slips; name 1 to {SLIPS}, each once")
    if isinstance(spring.damping, Curve) or callable(spring.damping):
        raise ModelError(
            f"{target.owner}: a slip takes a number or matrix for damping; for others compile a law with "
            "fx.compile_law"
        )
    C = target.matrix(0.0 if spring.damping is None else spring.damping, "damping")
    to.law(target.owner, LAWS[f"viscous_{k}"], target.names, {"C": C[np.triu_indices(k)]})


def _add_laws(to: Lowering, spring: Spring, target: _Target, label: str) -> None:
    """Add a law for each curve or formula, and a linear one of that label for what remains."""
    stiffness, damping, preload = spring.stiffness, spring.damping, spring.preload
    free = _free(to, spring, target)
    if _shaped(target, stiffness):
        if preload is not None:
            raise ModelError(f"{target.owner}: a curve or formula contains its preload; add it there")
        _add_shaped(to, spring, target, float(free[0]))
        stiffness = None
    if _shaped(target, damping):
        _add_damper(to, target, damping, spring.ranges)
        damping = None
    if stiffness is None and damping is None and preload is None:
        return
    S, D = target.matrix(stiffness, "stiffness"), target.matrix(damping, "damping")
    force = target.forces(preload) if spring.free_length is None else -S @ free
    to.linear_law(target.owner, target.names, S, D, force, label)


def _shaped(target: _Target, value: Any) -> bool:
    """Whether a stiffness or damping is a curve or formula; on one deformation only."""
    shaped = isinstance(value, Curve) or callable(value)
    if shaped and len(target.names) > 1:
        raise ModelError(
            f"{target.owner}: a curve or formula acts on one deformation; measure the difference with an element, or "
            "compile a law with fx.compile_law"
        )
    return shaped


def _add_shaped(to: Lowering, spring: Spring, target: _Target, free: float) -> None:
    """Add a spring by a curve or formula, of the deformation less the free one."""
    shape, energy = spring.stiffness, spring.energy
    if isinstance(shape, Curve):
        to.law(target.owner, LAWS["spring_curve"], target.names, shape.parameters(-free))
        return
    force = of_all(shape)
    if not free:
        add_formula(to, target.owner, target.names, force, energy, spring.ranges)
        return
    stored = energy and (lambda e: energy(e - free))
    limits = _moved(target.owner, spring.ranges, free)
    add_formula(to, target.owner, target.names, lambda e, ed, t: force(e - free, ed, t), stored, limits)


def _add_damper(to: Lowering, target: _Target, shape: Any, ranges: Ranges | None) -> None:
    """Add a damper by a curve or formula of the rate."""
    if not isinstance(shape, Curve):
        add_formula(to, target.owner, target.names, lambda e, ed, t: shape(ed), None, ranges)
        return
    if not shape.rests():
        raise ModelError(
            f"{target.owner}: damping gives {shape(0.0):g} at rest; the force of a damper must be zero there"
        )
    values = shape.parameters(0.0)
    del values["stored"]
    to.law(target.owner, LAWS["damper_curve"], target.names, values)


def _moved(owner: str, ranges: Ranges | None, free: float) -> Ranges | None:
    """Return the ranges of the deformation, from the ranges of the deformation less the free one."""
    if not isinstance(ranges, Mapping) or "e" not in ranges:
        return ranges
    low, high = vector(ranges["e"], owner, "range of e", 2) + free
    return {**ranges, "e": (low, high)}


def _free(to: Lowering, spring: Spring, target: _Target) -> Array:
    """Return values (m,) of the deformations at which the spring has no force; the first of a pair takes all."""
    m, owner = len(target.names), target.owner
    if spring.free_length is None:
        return np.zeros(m)
    if spring.stiffness is None:
        raise ModelError(f"{owner}: free_length without a stiffness has no effect; give one, or drop it")
    if spring.preload is not None:
        raise ModelError(
            f"{owner}: free_length and preload are both given; drop one, which follows from the other"
        )
    if target.shares is None:
        given = vector(spring.free_length, owner, "free_length", m)
    else:
        given = np.concatenate([[number(spring.free_length, owner, "free_length")], np.zeros(m - 1)])
    if target.shares is not None and m > 1:
        return given
    pairs = zip(target.names, given, strict=True)
    return np.array([_deformation(to, name, free, owner) for name, free in pairs])


def _deformation(to: Lowering, name: str, free: float, owner: str) -> float:
    """Return the deformation at its free length: less the length as drawn for a bar or beam."""
    element, _, deformation = name.rpartition(".")
    instance = to.instances.get(element)
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


@part
class Stop(Part[None]):
    """Attach a one-sided stop: σ = stiffness (e - gap) (1 + damping ė) beyond the gap, never pulling."""

    name: str = entry("A deformation, which becomes free.")
    gap: float = quantity("m or rad", "any", "Deformation at which contact begins.")
    stiffness: float = quantity("N/m or N m/rad", "positive", "Stiffness of the contact.")
    damping: float = quantity(
        "s/m or s/rad",
        "not negative",
        "Dissipative force relative to the elastic force, at unit rate.",
        default=0.0,
    )

    @property
    def owner(self) -> str:
        """Its name in messages: by the deformation on which it acts."""
        return f"stop on '{self.name}'"

    @property
    def label(self) -> None:
        """That of its law."""
        return None

    def lower(self, to: Lowering) -> None:
        """Add the law."""
        values = {"gap": self.gap, "stiffness": self.stiffness, "damping": self.damping}
        to.law(self.owner, LAWS["stop"], [self.name], values)


@part
class MassDamping(Part[None]):
    """Resist the motion of an element by `rate` times its momentum: mass-proportional Rayleigh damping.

    The stiffness-proportional part is the `damping` of springs and beams.  The force is -rate M v, with M the
    element's consistent mass matrix; rigid-body motion of the whole mechanism is damped too.

    Raises
    ------
    ModelError
        An unknown element, one without mass, a negative rate.
    """

    element: str = entry("An element with mass: a body or a beam.")
    rate: float = quantity("1/s", "not negative", "Ratio of the damping force to the momentum.")

    @property
    def owner(self) -> str:
        """Its name in messages: by its element."""
        return f"mass_damping of '{self.element}'"

    @property
    def label(self) -> str:
        """By its element."""
        return f"mass_damping {self.element}"

    def lower(self, to: Lowering) -> None:
        """Note the rate in the element."""
        if not isinstance(self.element, str) or self.element not in to.instances:
            raise ModelError(f"{self.owner}: {unknown(str(self.element), to.instances, 'element')}")
        instance = to.instances[self.element]
        if "inertia" not in instance.spec.kernels:
            raise ModelError(f"{self.owner}: a {instance.spec.name} has no mass; name a body or a beam")
        to.instances[self.element] = replace(instance, mass_damping=self.rate)
