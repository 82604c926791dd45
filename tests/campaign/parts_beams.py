"""What flexible and three-node beams mean."""

from collections.abc import Callable
from typing import Any

import numpy as np

from campaign.algebra import conjugate, rotated
from campaign.beam_twins import Beam, PlanarBeam
from campaign.oracle import STEP
from campaign.parts import Drawing, handler, options_of
from campaign.parts_bodies import Bar, Rotor, held_in_body
from campaign.parts_forces import function
from campaign.twin import Twin
from flexel.base.arrays import Array
from flexel.parts import beams
from flexel.parts.loads import DistributedLoad
from flexel.parts.springs import MassDamping

BEAM = (
    "frame_q rigid direction EA GJ EIy EIz GAy GAz initial_strain initial_curvature damping mass_per_length "
    "inertia_per_length second_order"
)


@handler(beams.Beam, options=BEAM)
def _beam(drawing: Drawing, part: beams.Beam) -> None:
    if part.frame_q is None:
        _link(drawing, part)
        return
    name, *nodes = map(str, (part.name, part.p, part.frame_p, part.q, part.frame_q))
    drawn = [drawing.x(node) for node in nodes]
    kind = PlanarBeam if len(drawing.gravity) == 2 else Beam
    given = {key: value for key, value in options_of(part).items() if key not in ("rigid", "frame_q")}
    twin = kind(name, nodes, drawn, drawing.gravity, **given)
    drawing.twins.append(twin)
    for i, mode in enumerate(twin.modes):
        held = i not in twin.elastic.flexible
        drawing.measure(f"{name}.{mode}", twin.nodes, lambda x, i=i: twin.deformations(x)[i], held)


def _link(drawing: Drawing, part: beams.Beam) -> None:
    """The rigid beam with one frame: its axis is a bar, its sections turn with the frame."""
    name, p, frame, q = map(str, (part.name, part.p, part.frame_p, part.q))
    held_in_body(drawing, name, p, frame, q)
    d = drawing.x(q) - drawing.x(p)
    l0 = float(np.linalg.norm(d))
    drawing.twins.append(Bar((p, q), part.mass_per_length * l0, drawing.gravity))
    j: Any = part.inertia_per_length
    if j is None:
        return
    if len(drawing.gravity) == 2:
        drawing.twins.append(Rotor(frame, np.array([[j * l0]])))
        return
    hint = np.array(part.direction, float)
    ex = d / l0
    ey = hint - (hint @ ex) * ex
    ey /= np.linalg.norm(ey)
    axes = np.array([rotated(conjugate(drawing.x(frame)), e) for e in (ex, ey, np.cross(ex, ey))])
    drawing.twins.append(Rotor(frame, l0 * axes.T @ np.diag(j) @ axes))


@handler(DistributedLoad)
def _distributed_load(drawing: Drawing, part: DistributedLoad) -> None:
    given: Any = part.value
    values: list[Callable[[float], float]] = [function(component) for component in given]
    beam = next(twin for twin in drawing.twins if isinstance(twin, Beam) and twin.name == part.beam)
    beam.loads.append(lambda t: np.array([value(t) for value in values]))
    beam.conserves = False


class Slowed(Twin):
    """A force of `rate` times the momentum of another twin, against its motion."""

    conserves = False

    def __init__(self, twin: Twin, rate: float) -> None:
        self.nodes, self._twin, self._rate = twin.nodes, twin, rate

    def force(self, x: Array, v: Array, z: Array, t: float) -> Array:  # noqa: ARG002 (momentum alone)
        n = x.size
        moved = v[:, None] + 1j * STEP * np.eye(n)
        return np.asarray(
            -self._rate * np.imag(self._twin.kinetic(np.repeat(x[:, None], n, axis=1), moved)) / STEP
        )


@handler(MassDamping)
def _mass_damping(drawing: Drawing, part: MassDamping) -> None:
    beam = next(twin for twin in drawing.twins if isinstance(twin, Beam) and twin.name == part.element)
    drawing.twins.append(Slowed(beam, part.rate))
