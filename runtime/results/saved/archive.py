"""Motions as records and back: the data of a mechanism needed to read, draw and continue its motion.

A record holds every quantity with its rate, acceleration and force, the choices of degrees of freedom, and a
description of nodes, elements and laws; a motion restored from it has the same names and is drawn like the saved
one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.base.errors import ModelError
from flexel.base.units import rate_unit
from flexel.engine.evaluate import Evaluation
from flexel.results.saved.description import described, quantity_units, structure_of
from flexel.results.saved.record import Record, Variable
from flexel.structure.roles import Roles
from flexel.structure.state import Energy, State
from flexel.structure.structure import Structure

if TYPE_CHECKING:
    from flexel.results.motion import Motion

ENERGIES = ("kinetic", "potential", "strain")
ROLES = ("rigid", "prescribed", "zero", "dynamic", "kinematic")
TABLES = ("value", "rate", "acceleration", "force")


class StoredGeometry:
    """The structure in a file; its elements are evaluated when a state needs its J, which is not saved."""

    def __init__(self, structure: Structure) -> None:
        self.structure = structure

    def __reduce__(self) -> tuple[type[StoredGeometry], tuple[Structure]]:
        """Pickled as its structure."""
        return StoredGeometry, (self.structure,)

    @cached_property
    def _evaluation(self) -> Evaluation:
        strange = sorted(
            {z.spec.name for z in self.structure.instances if not z.spec.kernels and z.terms is None}
        )
        if strange:
            raise ModelError(
                f"the elements {', '.join(strange)} are not built in; build the model, and restore the state in it: "
                "system.restore(state)"
            )
        return Evaluation(replace(self.structure, laws=()))

    def position(self, x: Array) -> tuple[Array, Array]:
        """Deformations as principal values (m,), and J (m + k + n, n), at coordinates x (n,)."""
        return self._evaluation.position(x)


# -- motions --------------------------------------------------------------------------------------


def record_of(motion: Motion) -> Record:
    """All data of a motion except its dense output."""
    structure, choices = motion.structure, _Choices()
    variables = _packed(list(motion), "time", choices)
    units = quantity_units(structure)
    labels = {"quantity": structure.names, "energy_kind": ENERGIES}
    if structure.nz:
        labels["internal_state"] = tuple(structure.internal)
        units["internal"] = structure.internal_units
        units["internal_rate"] = tuple(rate_unit(unit, 1) for unit in structure.internal_units)
    if motion.ledger is not None:
        labels["ledger_kind"] = tuple(motion.ledger)
        columns = np.array(list(motion.ledger.values())).T
        variables["ledger"] = Variable(
            ("time", "ledger_kind"), columns, "J", "stored in contacts; dissipated and supplied so far"
        )
    if motion.events:
        found = _packed([state for _, state in motion.events], "event", choices)
        variables |= {f"event_{name}": z for name, z in found.items()}
        units |= {f"event_{name}": z for name, z in units.items()}
        labels["event"] = tuple(name for name, _ in motion.events)
    header = {
        "structure": described(structure),
        "choices": choices.names,
        "statistics": motion.statistics,
        "message": motion.message,
        "rechoices": motion.rechoices,
        "warnings": motion.warnings,
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
        self.names.append(roles_in_names(state))
        return len(self.roles) - 1


def roles_in_names(state: State) -> dict[str, list[str]]:
    """The roles of a state by the names of the quantities; without the prescribed functions of time."""
    names = state.structure.names
    return {key: [names[i] for i in getattr(state.roles, key)] for key in ROLES}


def _packed(states: Sequence[State], dim: str, choices: _Choices) -> dict[str, Variable]:
    """Arrays over all states, times first."""
    m, k = states[0].structure.m, states[0].structure.k
    tables = {
        "value": [z.values for z in states],
        "rate": [z.rates for z in states],
        "acceleration": [np.concatenate([z.Phi_v[: m + k], z.a]) for z in states],
        "force": [np.concatenate([z.stresses, z.reactions]) for z in states],
    }
    found = {"time": Variable((dim,), np.array([z.t for z in states]), "s", "time")}
    found |= {name: Variable((dim, "quantity"), np.array(rows)) for name, rows in tables.items()}
    energies = np.array([[getattr(z.energy, name) for name in ENERGIES] for z in states])
    found["energy"] = Variable((dim, "energy_kind"), energies, "J")
    found["drift"] = Variable(
        (dim,), np.array([z.drift for z in states]), "", "largest violation of the constraints"
    )
    found["dissipated"] = Variable(
        (dim,), np.array([z.dissipated for z in states]), "W", "power dissipated by laws"
    )
    if states[0].structure.nz:
        found["internal"] = Variable((dim, "internal_state"), np.array([z.z for z in states]))
        found["internal_rate"] = Variable((dim, "internal_state"), np.array([z.zd for z in states]))
    numbers = np.array([choices.number(z) for z in states])
    found["choice"] = Variable(
        (dim,), numbers, "", "index of the choice of degrees of freedom that describes the state"
    )
    return found


def motion_of(record: Record) -> Motion:
    """The motion in a record, with the original names."""
    from flexel.integration.outcome import Integration, States
    from flexel.results.motion import Motion

    structure = structure_of(record.header["structure"])
    if structure.names != record.labels["quantity"]:
        raise ModelError(
            "load: the names in the file do not match its nodes and elements; the file is damaged"
        )
    roles = [roles_from(structure, z) for z in record.header["choices"]]
    states = _unpacked(structure, roles, {name: z.values for name, z in record.variables.items()})
    late = {n.removeprefix("event_"): z.values for n, z in record.variables.items() if n.startswith("event_")}
    events = list(zip(record.labels["event"], _unpacked(structure, roles, late), strict=True)) if late else []
    ledger = None
    if "ledger" in record.variables:
        columns = record.variables["ledger"].values.T
        ledger = {name: z.tolist() for name, z in zip(record.labels["ledger_kind"], columns, strict=True)}
    header = record.header
    changes = [(float(t), tuple(old), tuple(new)) for t, old, new in header.get("rechoices", ())]
    said = [str(text) for text in header.get("warnings", ())]
    found = Integration(
        States(states), events, [], dict(header["statistics"]), str(header["message"]), ledger, changes, said
    )
    return Motion(None, found)


def roles_from(structure: Structure, names: Mapping[str, Sequence[str]]) -> Roles:
    """Roles from the names of the quantities, without functions of time."""
    rows: dict[str, Index] = {
        key: np.array([structure.find(name, "load") for name in names[key]], dtype=np.intp) for key in ROLES
    }
    return Roles(rows["rigid"], rows["prescribed"], (), rows["zero"], rows["dynamic"], rows["kinematic"])


def _unpacked(structure: Structure, roles: Sequence[Roles], arrays: Mapping[str, Any]) -> list[State]:
    m, first, geometry = structure.m, structure.m + structure.k, StoredGeometry(structure)
    value, rate, acceleration, force = (arrays[name] for name in TABLES)
    none = np.zeros((len(arrays["time"]), 0))
    z, zd = (arrays.get(name, none) for name in ("internal", "internal_rate"))
    return [
        State(
            t=float(t),
            x=value[i, first:],
            v=rate[i, first:],
            a=acceleration[i, first:],
            e=value[i, :m],
            evaluation=geometry,
            stresses=force[i, :first],
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
