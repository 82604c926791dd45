"""Forces and stresses in the end sections of beams at a state.

The forces that a beam exerts on its nodes are De' sigma, so those in its end sections follow from virtual work,
exactly in equilibrium, for any deformations: N and V from the rows of the points, the torque and the bending
moments M = W f / 4 from the rows f of the Euler parameters, with omega = W lambda' (Besseling 1974 for the
generalized stresses); the bimoment of a beam with warping is the row of its twist per length.  Loads along the
element, including weight and inertia, are lumped at its nodes.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from flexel.base.arguments import unknown
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.quaternions import matrix, product
from flexel.declare.materials import Profile
from flexel.declare.sections import SectionForces, StressPoint
from flexel.structure.instances import Instance
from flexel.structure.state import State


@dataclass(frozen=True)
class BeamStress:
    """Largest stress in the end sections of a beam.

    Attributes
    ----------
    beam : str
    end : str
        "p" or "q": the end with the largest equivalent stress.
    forces : SectionForces
        Forces at that end.
    point : StressPoint
        Place in the section, normal and shear stress [Pa].
    strength : float or None
        Strength of the material [Pa].
    """

    beam: str
    end: str
    forces: SectionForces
    point: StressPoint
    strength: float | None

    @property
    def mises(self) -> float:
        """Equivalent stress of von Mises [Pa]."""
        return self.point.mises

    @property
    def safety(self) -> float | None:
        """Strength over equivalent stress; None without a strength."""
        return None if self.strength is None else self.strength / self.mises if self.mises else np.inf


def rotation_rows(q: Array) -> Array:
    """W (3, 4) of omega = W lambda', the angular velocity in global axes."""
    return 2 * np.array([[-q[1], q[0], -q[3], q[2]], [-q[2], q[3], q[0], -q[1]], [-q[3], -q[2], q[1], q[0]]])


def section_forces(state: State, beam: str) -> tuple[SectionForces, SectionForces]:
    """Forces in the sections at both ends of a beam; see `State.section_forces`."""
    instance = _find(state, beam)
    s = state.structure
    rows = np.array([s.index[z] for z in instance.deformations])
    f = state.J[rows].T @ state.stresses[rows]
    ends = []
    for k, (side, sign) in enumerate((("p", -1.0), ("q", 1.0))):
        force, moment, R = _end(state, instance, f, k, side)
        # the beam pulls its node with -De' sigma; the section at q transmits +De' sigma, that at p its opposite
        N, Vy, Vz = sign * (R.T @ force)
        T, My, Mz = sign * (R.T @ moment)
        B = sign * f[s.places(instance.nodes[4 + k])][0] if len(instance.nodes) > 4 else 0.0
        ends.append(SectionForces(*map(float, (N, Vy, Vz, T, My, Mz, B))))
    return ends[0], ends[1]


def _end(state: State, instance: Instance, f: Array, k: int, side: str) -> tuple[Array, Array, Array]:
    """Force and moment (3,) on one end in global axes, and the section's axes (3, 3)."""
    s, (point, frame) = state.structure, instance.nodes[2 * k : 2 * k + 2]
    force, turn = f[s.places(point)], f[s.places(frame)]
    if instance.spec.planar:
        name = "alpha0" if side == "p" else "alphaq0"
        angle = state.position(frame)[0] + float(np.ravel(instance.parameters[name])[0])
        c, z = np.cos(angle), np.sin(angle)
        R = np.array([[c, -z, 0.0], [z, c, 0.0], [0.0, 0.0, 1.0]])
        return np.append(force, 0.0), np.array([0.0, 0.0, turn[0]]), R
    q = state.position(frame)
    return force, rotation_rows(q) @ turn / 4, matrix(product(q, instance.parameters["t" + side]))


def beam_stress(state: State, beam: str) -> BeamStress:
    """Largest equivalent stress in the end sections of a beam; see `State.stress`."""
    profile = _find(state, beam).profile
    if not isinstance(profile, Profile):
        raise ModelError(f"beam '{beam}' has no section, only stiffnesses; give it section= and material=")
    found = [
        BeamStress(beam, end, forces, point, profile.material.strength)
        for end, forces in zip("pq", section_forces(state, beam), strict=True)
        for point in profile.section.stresses(forces)
    ]
    return max(found, key=lambda z: z.mises)


def largest_stress(state: State) -> BeamStress:
    """The largest equivalent stress in all beams; see `State.largest_stress`."""
    beams = [z.name for z in state.structure.instances if z.profile is not None and z.spec.family == "beam"]
    if not beams:
        raise ModelError("no beam has a section; give one to m.beam(…, section=, material=)")
    return max((beam_stress(state, z) for z in beams), key=lambda z: z.mises)


def _find(state: State, beam: str) -> Instance:
    known = {z.name: z for z in state.structure.instances if z.spec.family == "beam"}
    if not isinstance(beam, str) or beam not in known:
        raise ModelError(unknown(str(beam), known, "beam with two frames"))
    return known[beam]
