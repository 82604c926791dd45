"""What the calls of flexible and three-node beams mean."""

from collections.abc import Callable

import numpy as np

from campaign.algebra import conjugate, rotated
from campaign.beam_twins import Beam, PlanarBeam
from campaign.calls import Call
from campaign.oracle import STEP
from campaign.parts import Drawing, handler
from campaign.parts_bodies import Bar, Rotor, held_in_body
from campaign.parts_forces import function
from campaign.twin import Twin
from flexel.base.arrays import Array

BEAM = (
    "rigid direction EA GJ EIy EIz GAy GAz initial_strain initial_curvature damping mass_per_length "
    "inertia_per_length second_order"
)


@handler("beam", options=BEAM)
def _beam(drawing: Drawing, call: Call) -> None:
    name, *nodes = call.args
    if len(nodes) == 3:
        _link(drawing, call)
        return
    drawn = [drawing.x(z) for z in nodes]
    kind = PlanarBeam if len(drawing.gravity) == 2 else Beam
    given = {key: z for key, z in call.options.items() if key != "rigid"}
    twin = kind(name, nodes, drawn, drawing.gravity, **given)
    drawing.twins.append(twin)
    for i, mode in enumerate(twin.modes):
        held = i not in twin.elastic.flexible
        drawing.measure(f"{name}.{mode}", twin.nodes, lambda x, i=i: twin.deformations(x)[i], held)


def _link(drawing: Drawing, call: Call) -> None:
    """The rigid beam with one frame: its axis is a bar, its sections turn with the frame."""
    name, p, frame, q = call.args
    held_in_body(drawing, name, p, frame, q)
    d = drawing.x(q) - drawing.x(p)
    l0 = float(np.linalg.norm(d))
    drawing.twins.append(Bar((p, q), call.options.get("mass_per_length", 0.0) * l0, drawing.gravity))
    j = call.options.get("inertia_per_length")
    if j is None:
        return
    if len(drawing.gravity) == 2:
        drawing.twins.append(Rotor(frame, np.array([[j * l0]])))
        return
    hint = np.array(call.options["direction"], float)
    ex = d / l0
    ey = hint - (hint @ ex) * ex
    ey /= np.linalg.norm(ey)
    axes = np.array([rotated(conjugate(drawing.x(frame)), e) for e in (ex, ey, np.cross(ex, ey))])
    drawing.twins.append(Rotor(frame, l0 * axes.T @ np.diag(j) @ axes))


@handler("distributed_load")
def _distributed_load(drawing: Drawing, call: Call) -> None:
    name, value = call.args
    parts: list[Callable[[float], float]] = [function(z) for z in value]
    beam = next(z for z in drawing.twins if isinstance(z, Beam) and z.name == name)
    beam.loads.append(lambda t: np.array([z(t) for z in parts]))
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


@handler("mass_damping")
def _mass_damping(drawing: Drawing, call: Call) -> None:
    name, rate = call.args
    beam = next(z for z in drawing.twins if isinstance(z, Beam) and z.name == name)
    drawing.twins.append(Slowed(beam, rate))
