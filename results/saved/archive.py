"""Converts motions to records and back: the data of a mechanism needed to read, draw and continue its motion.

A record holds every quantity with its rate, acceleration and force, the choices of degrees of freedom, and a
description of nodes, elements and laws; a motion restored from it has the same names and looks the same when
drawn.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.base.errors import ModelError
from flexel.base.units import rate_unit
from flexel.engine.evaluate import Evaluation
from flexel.engine.outputs import element_outputs
from flexel.integration.outcome import Integration, States
from flexel.integration.trajectory import Trajectory
from flexel.model.instances import Instance
from flexel.model.role_lists import Roles
from flexel.model.state import Energy, State
from flexel.model.structure import Structure
from flexel.results.saved.description import described, quantity_units, structure_of
from flexel.results.saved.record import Record, Variable

ENERGIES = ("kinetic", "potential", "strain")
ROLES = ("rigid", "prescribed", "zero", "dynamic", "kinematic")
TABLES = ("value", "rate", "acceleration", "force")


class StoredGeometry:
    """The structure in a file; its elements are evaluated if a state needs its J, which is not saved."""

    def __init__(self, structure: Structure) -> None:
        self.structure = structure

    def __reduce__(self) -> tuple[type[StoredGeometry], tuple[Structure]]:
        """Pickle as its structure."""
        return StoredGeometry, (self.structure,)

    @cached_property
    def _evaluation(self) -> Evaluation:
        strange = sorted(
            {
                instance.spec.name
                for instance in self.structure.instances
                if not instance.spec.kernels and instance.terms is None
            }
        )
        if strange:
            raise ModelError(
                f"the elements {', '.join(strange)} are not built in; build the model, and restore the state in it: "
                "system.restore(state)"
            )
        return Evaluation(replace(self.structure, laws=()))

    def position(self, x: Array) -> tuple[Array, Array]:
        """Return deformations as principal values (m,), and J (m + k + n, n), at coordinates x (n,)."""
        return self._evaluation.position(x)

    def outputs(self, elements: Sequence[Instance], x: Array, e: Array, stresses: Array) -> dict[str, Array]:
        """Return the outputs of some elements of one type; those that are not built in have none."""
        return element_outputs(self.structure, elements, x, e, stresses)


# -- motions --------------------------------------------------------------------------------------


def record_of(motion: Trajectory) -> Record:
    """Return all data of a motion except its dense output."""
    structure, choices = motion.structure, _Choices()
    variables = _packed(list(motion), "time", choices)
    units = quantity_units(structure)
    units["given"] = units["force"]
    labels = {"quantity": structure.names, "energy_kind": ENERGIES}
    if structure.nz:
        labels["internal_state"] = tuple(structure.internal)
        units["internal"] = structure.internal_units
        units["internal_rate"] = tuple(rate_unit(unit, 1) for unit in structure.internal_units)
    if motion.energy_terms is not None:
        labels["energy_term"] = tuple(motion.energy_terms)
        columns = np.array(list(motion.energy_terms.values())).T
        variables["energy_terms"] = Variable(
            ("time", "energy_term"), columns, "J", "stored in contacts; dissipated and supplied so far"
        )
    if motion.events:
        found = _packed([state for _, state in motion.events], "event", choices)
        variables |= {f"event_{name}": variable for name, variable in found.items()}
        units |= {f"event_{name}": unit for name, unit in units.items()}
        labels["event"] = tuple(name for name, _ in motion.events)
    header = {
        "structure": described(structure),
        "choices": choices.names,
        "statistics": motion.statistics,
        "message": motion.message,
        "rechoices": motion.rechoices,
        "warnings": motion.warnings,
        "verdict": motion.verdict,
    }
    own = {name: unit for name, unit in units.items() if name in variables}
    return Record("motion", variables, labels, own, header)


class _Choices:
    """The different roles in the order in which they occur, by name."""

    def __init__(self) -> None:
        self.roles: list[Roles] = []
        self.names: list[dict[str, list[str]]] = []

    def number(self, state: State) -> int:
        for i, roles in enumerate(self.roles):
            if roles is state.roles:
                return i
        self.roles.append(state.roles)
        self.names.append(roles_in_names(state))
        return len(self.roles) - 1


def roles_in_names(state: State) -> dict[str, list[str]]:
    """Return the roles of a state by the names of the quantities, without the prescribed functions of time."""
    names = state.structure.names
    return {key: [names[i] for i in getattr(state.roles, key)] for key in ROLES}


def _packed(states: Sequence[State], dim: str, choices: _Choices) -> dict[str, Variable]:
    """Return arrays over all states, times first."""
    m, k = states[0].structure.m, states[0].structure.k
    tables = {
        "value": [state.values for state in states],
        "rate": [state.rates for state in states],
        "acceleration": [np.concatenate([state.Phi_v[: m + k], state.a]) for state in states],
        "force": [np.concatenate([state.stresses, state.reactions]) for state in states],
    }
    found = {"time": Variable((dim,), np.array([state.t for state in states]), "s", "time")}
    driven = _driven(states[0])
    if driven.size:
        tables["given"] = [_given(state, driven) for state in states]
    found |= {name: Variable((dim, "quantity"), np.array(rows)) for name, rows in tables.items()}
    energies = np.array([[getattr(state.energy, name) for name in ENERGIES] for state in states])
    found["energy"] = Variable((dim, "energy_kind"), energies, "J")
    found["drift"] = Variable(
        (dim,), np.array([state.drift for state in states]), "", "largest violation of the constraints"
    )
    found["dissipated"] = Variable(
        (dim,), np.array([state.dissipated for state in states]), "W", "power dissipated by laws"
    )
    if states[0].structure.nz:
        found["internal"] = Variable((dim, "internal_state"), np.array([state.z for state in states]))
        found["internal_rate"] = Variable((dim, "internal_state"), np.array([state.zd for state in states]))
    numbers = np.array([choices.number(state) for state in states])
    found["choice"] = Variable(
        (dim,), numbers, "", "index of the choice of degrees of freedom that describes the state"
    )
    return found


def _driven(state: State) -> Index:
    """Return the deformations that are prescribed, or are actuators."""
    roles = state.roles
    driven = np.concatenate([roles.prescribed, roles.forces[roles.rigid.size :]])
    return np.unique(driven[driven < state.given.size])


def _given(state: State, driven: Index) -> Array:
    """Return what laws and loads give (m + k + n,) of the stresses of driven deformations; zero for others."""
    found = np.zeros(state.rates.size)
    found[driven] = state.given[driven]
    return found


def integration_of(record: Record) -> Integration:
    """Return the motion in a record, with the original names."""
    structure = structure_of(record.header["structure"])
    if structure.names != record.labels["quantity"]:
        raise ModelError(
            "load: the names in the file do not match its nodes and elements; the file is damaged"
        )
    roles = [roles_from(structure, choice) for choice in record.header["choices"]]
    states = _unpacked(
        structure, roles, {name: variable.values for name, variable in record.variables.items()}
    )
    late = {
        n.removeprefix("event_"): variable.values
        for n, variable in record.variables.items()
        if n.startswith("event_")
    }
    events = list(zip(record.labels["event"], _unpacked(structure, roles, late), strict=True)) if late else []
    energy_terms = None
    if "energy_terms" in record.variables:
        columns = record.variables["energy_terms"].values.T
        energy_terms = {
            name: column.tolist() for name, column in zip(record.labels["energy_term"], columns, strict=True)
        }
    header = record.header
    changes = [(float(t), tuple(old), tuple(new)) for t, old, new in header.get("rechoices", ())]
    said = [str(text) for text in header.get("warnings", ())]
    counts, message, verdict = (
        dict(header["statistics"]),
        str(header["message"]),
        str(header.get("verdict", "")),
    )
    return Integration(States(states), events, [], counts, message, energy_terms, changes, said, verdict)


def roles_from(structure: Structure, names: Mapping[str, Sequence[str]]) -> Roles:
    """Return roles from the names of the quantities, without functions of time."""
    rows: dict[str, Index] = {
        key: np.array([structure.find(name, "load") for name in names[key]], dtype=np.intp) for key in ROLES
    }
    return Roles(rows["rigid"], rows["prescribed"], (), rows["zero"], rows["dynamic"], rows["kinematic"])


def _unpacked(structure: Structure, roles: Sequence[Roles], arrays: Mapping[str, Any]) -> list[State]:
    m, first, geometry = structure.m, structure.m + structure.k, StoredGeometry(structure)
    value, rate, acceleration, force = (arrays[name] for name in TABLES)
    none = np.zeros((len(arrays["time"]), 0))
    z, zd = (arrays.get(name, none) for name in ("internal", "internal_rate"))
    given = arrays.get("given", np.zeros_like(force))
    return [
        State(
            t=float(t),
            x=value[i, first:],
            v=rate[i, first:],
            a=acceleration[i, first:],
            e=value[i, :m],
            evaluation=geometry,
            stresses=force[i, :first],
            given=given[i, :first],
            reactions=force[i, first:],
            roles=roles[int(arrays["choice"][i])],
            energy=Energy(*map(float, arrays["energy"][i])),
            drift=float(arrays["drift"][i]),
            z=z[i],
            zd=zd[i],
            dissipated=float(arrays["dissipated"][i]),
            Phi_v=acceleration[i],
            rates=rate[i],
        )
        for i, t in enumerate(arrays["time"])
    ]
