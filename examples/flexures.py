"""Two flexure mechanisms over their range of motion: the parallel leaf-spring guide and the cross-flexure pivot.

Guide: two leaf springs along x, clamped to the ground and to a rigid shuttle that moves in y.  Pivot: two
leaf springs that cross at right angles at their midpoints (through a slot) and let a body turn about z.
`reproduce` gives, along the range: compliance and stiffness in every direction, frequencies, the largest
stress, buckling multipliers of a payload along x; and what is over-constrained, by name.  At the start of the
range, and under payload, closed forms are known; the rest is reported.  The table is made in
`flexel.examples.flexures_table`, the pictures in `flexel.examples.flexures_figures`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import flexures_exact as exact
from flexel.parts.materials import MATERIALS, Profile
from flexel.results.reproduction import Report

ELEMENTS = 16  # of each leaf spring
STEEL = MATERIALS["spring steel"]
DIRECTIONS = ("x", "y", "z", "turn x", "turn y", "turn z")
IDEAL = ("torsion", "bend3", "bend4")  # what a leaf spring that is stiff in its own plane lets happen
BENDING = ("bend3", "bend4")  # the same leaf, thought stiff in torsion too


@dataclass(frozen=True)
class Design:
    """Sizes of a mechanism [m, kg, kg m²], its largest drive [N or N m], and its nodes and drive by name."""

    case: str
    length: float
    section: fx.Rectangle
    mass: float
    inertia: float
    largest_drive: float
    point: str
    frame: str
    drive: str

    @property
    def profile(self) -> Profile:
        """Section and material of the leaf springs."""
        return Profile(self.section, STEEL)

    @property
    def EI(self) -> float:  # noqa: N802
        """Bending stiffness of a leaf spring [N m²]."""
        return self.profile.stiffness()["EIz"]


GUIDE = Design(
    "guide", 0.1, fx.Rectangle(0.4e-3, 25e-3), 0.5, 2e-4, 10.0, "shuttle", "shuttle frame", "shuttle.y"
)
PIVOT = Design("pivot", 0.06, fx.Rectangle(0.3e-3, 15e-3), 0.2, 1e-4, 0.1, "axis", "body frame", "turn.angle")
SPACING = 0.06  # of the leaf springs of the guide [m]
HALF_ANGLE = np.pi / 4  # between the leaf springs of the pivot and the x axis


# -- models ---------------------------------------------------------------------------------------


def leaf(
    m: fx.Model,
    name: str,
    ends: Sequence[Array],
    body: tuple[str, str],
    section: fx.Rectangle,
    flexible: Sequence[str] | None,
    elements: int,
    material: fx.Material = STEEL,
) -> None:
    """Add a leaf spring in the plane of z from the ground to a body (point, frame), deflecting normal to that plane."""
    start, end = ends
    axis = (end - start) / np.linalg.norm(end - start)
    base, wall = m.point(f"{name} base", start, fixed=True), m.frame(f"{name} wall", fixed=True)
    m.leaf_spring(
        name,
        base,
        wall,
        *body,
        end=end,
        direction=np.array([-axis[1], axis[0], 0.0]),
        section=section,
        material=material,
        elements=elements,
        flexible=flexible,
    )


def guide(
    payload: float = 0.0, flexible: Sequence[str] | None = None, elements: int = ELEMENTS, d: Design = GUIDE
) -> fx.Model:
    """Build the parallel guide; a force in y at half its height equal to the time, payload in x [N]."""
    m = fx.Model()
    m.point(d.point, (d.length / 2, 0, 0))
    m.frame(d.frame)
    m.body("shuttle body", d.point, d.frame, mass=d.mass, inertia=(d.inertia,) * 3)
    for name, y in (("left", -SPACING / 2), ("right", SPACING / 2)):
        ends = np.array([0, y, 0.0]), np.array([d.length, y, 0.0])
        leaf(m, name, ends, (d.point, d.frame), d.section, flexible, elements)
    return _loads(m, d, payload)


def pivot(
    payload: float = 0.0, flexible: Sequence[str] | None = None, elements: int = ELEMENTS, d: Design = PIVOT
) -> fx.Model:
    """Build the cross-flexure pivot; moment about z equal to the time, payload along x on its axis [N]."""
    m = fx.Model()
    m.point(d.point, (0, 0, 0))
    m.frame(d.frame)
    m.frame("ground", fixed=True)
    m.body("turning body", d.point, d.frame, mass=d.mass, inertia=(d.inertia,) * 3)
    for name, side in (("up", 1.0), ("down", -1.0)):
        half = d.length / 2 * np.array([np.cos(HALF_ANGLE), side * np.sin(HALF_ANGLE), 0])
        leaf(m, name, (-half, half), (d.point, d.frame), d.section, flexible, elements)
    m.hinge("turn", "ground", d.frame, axis=(0, 0, 1))  # only measures: nothing of it is rigid
    m.release("turn.bend1", "turn.bend2")
    return _loads(m, d, payload)


def _loads(m: fx.Model, d: Design, payload: float) -> fx.Model:
    m.load(d.drive, fx.Polynomial((0.0, 1.0)))
    if payload:
        m.load(f"{d.point}.x", payload)
    return m


Maker = Callable[..., fx.Model]


def guided_directions(d: Design) -> list[str]:
    """Return the directions in which a mechanism should be stiff."""
    return [direction for direction in DIRECTIONS if direction != ("y" if d is GUIDE else "turn z")]


# -- analyses -------------------------------------------------------------------------------------


@dataclass(frozen=True)
class RangePoint:
    """A mechanism at one point of its range.

    Attributes
    ----------
    drive, travel : float
        Force or moment, and the displacement [m] or rotation [rad] that belongs to it.
    shift : ndarray (3,)
        Displacement of the reference point [m].
    free, held : Compliance
        With the drive's force constant, and with its travel held.
    frequencies : ndarray (6,)
        [rad/s]
    stress : fx.BeamStress
        The largest.
    buckling : (float, float)
        Smallest payload in -x and in +x [N] that buckles it here.
    """

    drive: float
    travel: float
    shift: Array
    free: fx.Compliance
    held: fx.Compliance
    frequencies: Array
    stress: fx.BeamStress
    buckling: tuple[float, float]
    state: fx.State


def station(system: fx.System, d: Design, state: fx.State) -> RangePoint:
    """Perform all analyses at a state of rest."""
    modes = system.buckling(state, increment={f"{d.point}.x": -1.0}, count=40)
    push = min((mode.multiplier for mode in modes if mode.multiplier > 0), default=np.inf)
    pull = min((-mode.multiplier for mode in modes if mode.multiplier < 0), default=np.inf)
    return RangePoint(
        drive=state.t,
        travel=state[d.drive],
        shift=state.position(d.point) - system.at_rest.position(d.point),
        free=system.compliance(d.point, d.frame, state),
        held=system.compliance(d.point, d.frame, state, hold=[d.drive]),
        frequencies=np.array([mode.omega for mode in system.vibrations(state, count=6)]),
        stress=state.largest_stress(),
        buckling=(push, pull),
        state=state,
    )


def over_range(make: Maker, d: Design, steps: int = 16) -> list[RangePoint]:
    """Compute stations from rest to the largest drive."""
    system = make().build()
    state, found = system.equilibrium(t=0.0), []
    for drive in np.linspace(0.0, d.largest_drive, steps + 1):
        state = system.equilibrium(state, t=float(drive))
        found.append(station(system, d, state))
    return found


def coarse_end(make: Maker, d: Design) -> RangePoint:
    """Compute the end of the range with half the elements, to see how far the mesh has converged."""
    system = make(elements=ELEMENTS // 2).build()
    half = system.equilibrium(t=d.largest_drive / 2)
    return station(system, d, system.equilibrium(half, t=d.largest_drive))


def small(make: Maker, d: Design) -> RangePoint:
    """Compute a station so near to rest that leading terms suffice: a thousandth of the range."""
    system = make().build()
    return station(system, d, system.equilibrium(t=d.largest_drive / 1000))


def drive_stiffness(make: Maker, d: Design, payload: float) -> float:
    """Compute the stiffness of the drive at rest under a payload."""
    system = make(payload).build()
    free = system.compliance(d.point, d.frame, system.equilibrium(t=0.0))
    return free.stiffness()["y" if make is guide else "turn z"]


@dataclass(frozen=True)
class FlexureResults:
    """All computed results, for the table and for the figures."""

    guide: list[RangePoint]
    pivot: list[RangePoint]
    small: dict[str, RangePoint]
    coarse: dict[str, RangePoint]  # at the end of the range, with half the elements
    payload: dict[str, tuple[Array, Array]]  # payloads over the buckling payload, stiffness over that without


CASES: tuple[tuple[Maker, Design], ...] = ((guide, GUIDE), (pivot, PIVOT))


def critical(d: Design) -> tuple[float, float]:
    """Return the payloads [N] in -x and +x that buckle the mechanism at rest, by the closed forms."""
    if d is GUIDE:
        return 2 * np.pi**2 * d.EI / d.length**2, np.inf
    push, pull = exact.pivot_buckling(d.EI, d.length)
    return 2 * np.cos(HALF_ANGLE) * push, 2 * np.cos(HALF_ANGLE) * pull


def expected_stiffness(d: Design, payload: float) -> float:
    """Return the stiffness of the drive at rest under a payload in x, by the closed forms."""
    if d is GUIDE:
        return 2 * exact.guided_stiffness(d.EI, d.length, payload / 2)
    return 2 * exact.pivot_stiffness(d.EI, d.length, payload / (2 * np.cos(HALF_ANGLE)))


def payloads(d: Design) -> Array:
    """Return payloads in +x over the range in which the mechanism is stable [N], without zero."""
    push, pull = critical(d)
    return np.concatenate([-push * np.array([0.8, 0.4]), min(push, pull) * np.array([0.4, 0.8])])


def analyse() -> FlexureResults:
    """Run all analyses."""
    return FlexureResults(
        guide=over_range(guide, GUIDE),
        pivot=over_range(pivot, PIVOT),
        small={d.case: small(make, d) for make, d in CASES},
        coarse={d.case: coarse_end(make, d) for make, d in CASES},
        payload={
            d.case: (payloads(d), np.array([drive_stiffness(make, d, float(p)) for p in payloads(d)]))
            for make, d in CASES
        },
    )


# -- the table ------------------------------------------------------------------------------------


def reproduce(out: Path | None = None) -> Report:
    """Compute all quantities with their closed forms; write figures to `out`, if given."""
    results = analyse()
    files: list[Path] = []
    if out is not None:
        from flexel.examples.flexures_figures import pictures

        files = pictures(results, out)
    from flexel.examples.flexures_table import rows

    return Report("flexures", rows(results), files)
