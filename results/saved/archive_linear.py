"""Converts linearizations to records and back; one from a file supports the same methods.

Arrays are taken field by field from the dataclasses, so that a record also contains new fields.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np

from flexel.base.outside import DataFrame, Dataset
from flexel.engine.derivatives import Tangents
from flexel.mechanics.linearized_system import LinearizedSystem
from flexel.mechanics.transfer import GeometricTransfer
from flexel.model.state import Energy, State
from flexel.model.structure import Structure
from flexel.results.saved.archive import ROLES, StoredGeometry, roles_from, roles_in_names
from flexel.results.saved.description import described, structure_of
from flexel.results.saved.record import Record, Variable, require
from flexel.results.saved.record_files import write

# Names along rows and columns, where they are degrees of freedom.
DIMS = {
    "M": ("dynamic", "dynamic_column"),
    "C": ("dynamic", "dynamic_column"),
    "K": ("dynamic", "dof"),
    "A_k": ("kinematic", "dynamic_column"),
    "B_k": ("kinematic", "dof"),
    **dict.fromkeys(("M_u", "C_u", "K_u"), ("dynamic", "prescribed")),
    **dict.fromkeys(("A_ku", "B_ku"), ("kinematic", "prescribed")),
    "Z": ("dynamic", "internal"),
    "Z_v": ("internal", "dynamic_column"),
    "Z_q": ("internal", "dof"),
    "Z_z": ("internal", "internal_column"),
    **dict.fromkeys(("Z_vu", "Z_qu"), ("internal", "prescribed")),
    "state_matrix": ("state", "state_column"),
}
PARTS = ("state", "transfer", "tangents")


def record_of_linearization(lin: LinearizedSystem) -> Record:
    """Return all arrays and names of a linearization, its state and its derivatives."""
    arrays = _arrays(lin) | {"state_matrix": lin.state_matrix}
    for part in PARTS:
        arrays |= {f"{part}_{name}": array for name, array in _arrays(getattr(lin, part)).items()}
    variables = {}
    for name, array in arrays.items():
        dims = DIMS.get(name, tuple(f"{name}_{axis}" for axis in range(array.ndim)))
        variables[name] = Variable(dims, array)
    state = lin.state
    labels = {
        "dynamic": lin.dynamic,
        "dynamic_column": lin.dynamic,
        "kinematic": lin.kinematic,
        "dof": lin.dofs,
        "prescribed": lin.prescribed,
        "internal": lin.internal,
        "internal_column": lin.internal,
        "state": lin.states,
        "state_column": lin.states,
    }
    header = {
        "structure": described(state.structure),
        "roles": roles_in_names(state),
        "names": {
            field.name: getattr(lin, field.name)
            for field in fields(lin)
            if isinstance(getattr(lin, field.name), tuple)
        },
        "state": {
            field.name: getattr(state, field.name)
            for field in fields(state)
            if isinstance(getattr(state, field.name), float)
        },
        "energy": [state.energy.kinetic, state.energy.potential, state.energy.strain],
    }
    return Record("linearization", variables, labels, {}, header)


def _arrays(owner: Any) -> dict[str, Any]:
    """Return the arrays among the fields of a dataclass."""
    values = {field.name: getattr(owner, field.name) for field in fields(owner)}
    return {name: value for name, value in values.items() if isinstance(value, np.ndarray)}


def linearization_of(record: Record) -> LinearizedSystem:
    """Return the linearization in a record."""
    header, arrays = record.header, {name: variable.values for name, variable in record.variables.items()}
    structure = structure_of(header["structure"])
    names: dict[str, Any] = {name: tuple(listed) for name, listed in header["names"].items()}
    own: dict[str, Any] = {
        field.name: arrays[field.name] for field in fields(LinearizedSystem) if field.name in arrays
    }
    return LinearizedSystem(
        **own,
        **names,
        state=_state(structure, header, _part(arrays, "state")),
        transfer=GeometricTransfer(**_part(arrays, "transfer")),
        derivatives=Tangents(**_part(arrays, "tangents")),
    )


def _part(arrays: Mapping[str, Any], part: str) -> dict[str, Any]:
    start = f"{part}_"
    return {
        n.removeprefix(start): array
        for n, array in arrays.items()
        if n.startswith(start) and n != "state_matrix"
    }


def _state(structure: Structure, header: Mapping[str, Any], arrays: Mapping[str, Any]) -> State:
    energy = Energy(*header["energy"])
    roles = roles_from(structure, {key: header["roles"][key] for key in ROLES})
    given = {"given": np.zeros_like(arrays["stresses"])}  # of a file without it
    return State(
        **(given | dict(arrays)),
        **header["state"],
        energy=energy,
        roles=roles,
        evaluation=StoredGeometry(structure),
    )


def save(lin: LinearizedSystem, path: str | Path) -> Path:
    """Write a file, see `Linearization.save`."""
    return write(record_of_linearization(lin), path)


def to_xarray(lin: LinearizedSystem) -> Dataset:
    """Return a dataset, see `Linearization.to_xarray`."""
    require("xarray", "xarray")
    full = record_of_linearization(lin)
    own = {name: variable for name, variable in full.variables.items() if name in DIMS}
    found = Record(full.kind, own, full.labels, {}, {}).to_xarray()
    known = lin.units
    for dim, names in full.labels.items():
        found = found.assign_coords({f"{dim}_unit": (dim, [known[name] for name in names])})
    found["eigenvalue"] = ("eigenvalue_number", lin.eigenvalues(), {"units": "1/s"})
    modes = lin.modes()
    found["mode_eigenvalue"] = ("mode", np.array([mode.eigenvalue for mode in modes]), {"units": "1/s"})
    shapes = np.array([[mode.shape[name] for name in lin.dofs] for mode in modes]).reshape(-1, len(lin.dofs))
    found["mode_shape"] = (("mode", "dof"), shapes)
    return found


def to_pandas(lin: LinearizedSystem) -> DataFrame:
    """Return a table, see `Linearization.to_pandas`."""
    pandas = require("pandas", "xarray")
    rows = [
        {
            "mode": mode.name,
            "real part": mode.eigenvalue.real,
            "imaginary part": mode.eigenvalue.imag,
            "omega": mode.omega,
            "hertz": mode.hertz,
            "damping ratio": mode.damping,
        }
        | mode.participation
        for mode in lin.modes()
    ]
    frame = pandas.DataFrame(rows).set_index("mode")
    frame.attrs["units"] = {"real part": "1/s", "imaginary part": "rad/s", "omega": "rad/s", "hertz": "Hz"}
    return frame
