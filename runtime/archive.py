"""Motions as records and back: what must be known of a mechanism to read, draw and continue its motion.

A record holds every quantity with its rate, acceleration and force, the choices of freedoms, and a description of
nodes, elements and laws; a motion made of it answers to the same names and is drawn like the one that was saved.
Imports numpy and the runtime rooms of records, states and structures.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.errors import ModelError
from flexel.generated.spec import (
    DeformationSpec,
    ElementSpec,
    LawSpec,
    NodeSpec,
    ParameterSpec,
    SlipSpec,
)
from flexel.record import Record, Variable
from flexel.roles import Roles
from flexel.state import Energy, State
from flexel.structure import Array, Index, Instance, LawInstance, Node, Structure, assemble_structure
from flexel.units import force_unit, rate_unit

if TYPE_CHECKING:
    from flexel.result import Motion

ENERGIES = ("kinetic", "potential", "strain")
TABLES = ("value", "rate", "acceleration", "force")


@dataclass(frozen=True, kw_only=True)
class SavedState(State):
    """A state from a file: everything by name, but no model behind it.  `System.restore` gives it one again.

    Attributes
    ----------
    rates : ndarray (m + k + n,)
        Of all quantities.
    """

    rates: Array = field(repr=False)

    @property
    def qd(self) -> Array:
        """Rates of the dynamic freedoms (nd,)."""
        return np.asarray(self.rates[self.roles.dynamic])

    def rate(self, name: str) -> float:
        """Rate of a coordinate or deformation, or a slip itself."""
        return float(self.rates[self.structure.find(name)])


# -- structures -----------------------------------------------------------------------------------


def described(structure: Structure) -> dict[str, Any]:
    """Nodes, elements and laws in text and numbers."""
    return {
        "nodes": [
            {"name": z.name, "kind": z.kind, "x0": z.x0.tolist(), "fixed": z.fixed.tolist()} for z in structure.nodes
        ],
        "elements": [_element(z) for z in structure.instances],
        "laws": [
            {
                "name": z.name,
                "type": z.spec.name,
                "deformations": z.deformations,
                "slips": z.slips,
                "parameters": _numbers(z.parameters),
            }
            for z in structure.laws
        ],
    }


def _element(z: Instance) -> dict[str, Any]:
    return {
        "name": z.name,
        "type": z.spec.name,
        "nodes": z.nodes,
        "ends": [(node.name, node.kind) for node in z.spec.nodes],
        "deformations": [(d.name, d.unit, d.angle, d.free) for d in z.spec.deformations],
        "slips": [(s.name, s.unit, s.free) for s in z.spec.slips],
        "parameters": _numbers(z.parameters),
        "mass_damping": z.mass_damping,
    }


def _numbers(parameters: Mapping[str, Array]) -> dict[str, Any]:
    return {name: np.asarray(value, dtype=float).tolist() for name, value in parameters.items()}


def structure_of(description: Mapping[str, Any]) -> Structure:
    """The structure of a description: names, units and drawing data as they were, without compiled kernels."""
    nodes = [
        Node(z["name"], z["kind"], np.array(z["x0"], dtype=float), np.array(z["fixed"], dtype=bool))
        for z in description["nodes"]
    ]
    instances = []
    for z in description["elements"]:
        values = {name: np.array(value, dtype=float) for name, value in z["parameters"].items()}
        spec = ElementSpec(
            name=z["type"],
            digest="",
            doc="",
            source="",
            nodes=tuple(NodeSpec(*end) for end in z["ends"]),
            parameters=tuple(ParameterSpec(name, value.size, "", "") for name, value in values.items()),
            deformations=tuple(DeformationSpec(*d) for d in z["deformations"]),
            slips=tuple(SlipSpec(*s) for s in z["slips"]),
            kernels={},
        )
        instances.append(Instance(z["name"], spec, tuple(z["nodes"]), values, mass_damping=z["mass_damping"]))
    return assemble_structure(nodes, instances, [_law(z) for z in description["laws"]])


def _law(z: Mapping[str, Any]) -> LawInstance:
    values = {name: np.array(value, dtype=float) for name, value in z["parameters"].items()}
    parameters = tuple(ParameterSpec(name, value.size, "", "") for name, value in values.items())
    spec = LawSpec(z["type"], "", "", len(z["deformations"]), len(z["slips"]), parameters, {})
    return LawInstance(z["name"], spec, tuple(z["deformations"]), tuple(z["slips"]), values)


def quantity_units(structure: Structure) -> dict[str, tuple[str, ...]]:
    """Units of the values, rates, accelerations and forces of all quantities; slips have no value."""
    m, first = structure.m, structure.m + structure.k
    slips = [m <= i < first for i in range(len(structure.names))]
    pairs = list(zip(structure.units, slips, strict=True))
    return {
        "value": tuple("" if slip else unit for unit, slip in pairs),
        "rate": tuple(rate_unit(unit, 0 if slip else 1) for unit, slip in pairs),
        "acceleration": tuple(rate_unit(unit, 1 if slip else 2) for unit, slip in pairs),
        "force": tuple(force_unit(unit, slip) for unit, slip in pairs),
    }


# -- motions --------------------------------------------------------------------------------------


def record_of(motion: Motion) -> Record:
    """All that a motion holds, but for its dense output."""
    structure, choices = motion.structure, _Choices()
    variables = _packed(list(motion), "time", choices)
    units = quantity_units(structure)
    labels = {"quantity": structure.names, "energy_kind": ENERGIES}
    if motion.events:
        found = _packed([state for _, state in motion.events], "event", choices)
        variables |= {f"event_{name}": z for name, z in found.items()}
        units |= {f"event_{name}": units[name] for name in TABLES}
        labels["event"] = tuple(name for name, _ in motion.events)
    header = {
        "structure": described(structure),
        "choices": choices.names,
        "statistics": motion.statistics,
        "message": motion.message,
    }
    return Record("motion", variables, labels, units, header)


class _Choices:
    """Different roles in the order in which they occur, by name."""

    def __init__(self) -> None:
        self.roles: list[Roles] = []
        self.names: list[dict[str, list[str]]] = []

    def number(self, state: State) -> int:
        for i, roles in enumerate(self.roles):
            if roles is state.roles:
                return i
        self.roles.append(state.roles)
        names = state.structure.names
        lists = {key: getattr(state.roles, key) for key in _ROLES}
        self.names.append({key: [names[i] for i in rows] for key, rows in lists.items()})
        return len(self.roles) - 1


_ROLES = ("rigid", "prescribed", "zero", "dynamic", "kinematic")


def _packed(states: Sequence[State], dim: str, choices: _Choices) -> dict[str, Variable]:
    """Arrays over all states, times first."""
    m, k = states[0].structure.m, states[0].structure.k
    tables = {
        "value": [z.values for z in states],
        "rate": [_rates(z) for z in states],
        "acceleration": [np.concatenate([z.Phi_v[: m + k], z.a]) for z in states],
        "force": [np.concatenate([z.stress, z.reactions]) for z in states],
    }
    found = {"time": Variable((dim,), np.array([z.t for z in states]), "s", "time")}
    found |= {name: Variable((dim, "quantity"), np.array(rows)) for name, rows in tables.items()}
    energies = np.array([[getattr(z.energy, name) for name in ENERGIES] for z in states])
    found["energy"] = Variable((dim, "energy_kind"), energies, "J")
    found["drift"] = Variable((dim,), np.array([z.drift for z in states]), "", "largest violation of the constraints")
    numbers = np.array([choices.number(z) for z in states])
    found["choice"] = Variable((dim,), numbers, "", "which choice of freedoms the state is described by")
    return found


def _rates(state: State) -> Array:
    if isinstance(state, SavedState):
        return state.rates
    first = state.structure.m + state.structure.k
    return np.array([*(row @ state.v for row in state.J[:first]), *state.v])  # as `State.rate`, to the last digit


def motion_of(record: Record) -> Motion:
    """The motion in a record, every name as it was."""
    from flexel.integrate import Integration
    from flexel.result import Motion

    structure = structure_of(record.header["structure"])
    if structure.names != record.labels["quantity"]:
        raise ModelError("load: the names in the file do not belong to its nodes and elements; the file is damaged")
    roles = [_roles(structure, z) for z in record.header["choices"]]
    states = _unpacked(structure, roles, {name: z.values for name, z in record.variables.items()})
    late = {n.removeprefix("event_"): z.values for n, z in record.variables.items() if n.startswith("event_")}
    events = list(zip(record.labels["event"], _unpacked(structure, roles, late), strict=True)) if late else []
    header = record.header
    return Motion(None, Integration(states, events, [], dict(header["statistics"]), str(header["message"])))


def _roles(structure: Structure, names: Mapping[str, Sequence[str]]) -> Roles:
    rows: dict[str, Index] = {
        key: np.array([structure.find(name, "load") for name in names[key]], dtype=np.intp) for key in _ROLES
    }
    return Roles(motions=(), **rows)


def _unpacked(structure: Structure, roles: Sequence[Roles], arrays: Mapping[str, Any]) -> list[State]:
    m, first = structure.m, structure.m + structure.k
    value, rate, acceleration, force = (arrays[name] for name in TABLES)
    return [
        SavedState(
            t=float(t),
            x=value[i, first:],
            v=rate[i, first:],
            a=acceleration[i, first:],
            e=value[i, :m],
            J=np.zeros((0, structure.n)),
            stress=force[i, :first],
            reactions=force[i, first:],
            roles=roles[int(arrays["choice"][i])],
            structure=structure,
            energy=Energy(*map(float, arrays["energy"][i])),
            drift=float(arrays["drift"][i]),
            Phi_v=acceleration[i],
            rates=rate[i],
        )
        for i, t in enumerate(arrays["time"])
    ]
