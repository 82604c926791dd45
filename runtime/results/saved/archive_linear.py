"""Linearizations as records and back; one from a file supports the same methods.

Arrays are taken field by field from the dataclasses, so that a record contains new ones too.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np

from flexel.base.outside import DataFrame, Dataset
from flexel.engine.derivatives import Tangents
from flexel.mechanics.linearization import Linearization
from flexel.mechanics.transfer import Transfer
from flexel.results.saved.archive import ROLES, StoredGeometry, roles_from, roles_in_names
from flexel.results.saved.description import described, structure_of
from flexel.results.saved.files import write
from flexel.results.saved.record import Record, Variable, require
from flexel.structure.state import Energy, State
from flexel.structure.structure import Structure

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


def record_of_linearization(lin: Linearization) -> Record:
    """All arrays and names of a linearization, its state and its derivatives."""
    arrays = _arrays(lin) | {"state_matrix": lin.state_matrix}
    for part in PARTS:
        arrays |= {f"{part}_{name}": z for name, z in _arrays(getattr(lin, part)).items()}
    variables = {}
    for name, z in arrays.items():
        dims = DIMS.get(name, tuple(f"{name}_{axis}" for axis in range(z.ndim)))
        variables[name] = Variable(dims, z)
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
            z.name: getattr(lin, z.name) for z in fields(lin) if isinstance(getattr(lin, z.name), tuple)
        },
        "state": {
            z.name: getattr(state, z.name) for z in fields(state) if isinstance(getattr(state, z.name), float)
        },
        "energy": [state.energy.kinetic, state.energy.potential, state.energy.strain],
    }
    return Record("linearization", variables, labels, {}, header)


def _arrays(owner: Any) -> dict[str, Any]:
    """The arrays among the fields of a dataclass."""
    values = {z.name: getattr(owner, z.name) for z in fields(owner)}
    return {name: value for name, value in values.items() if isinstance(value, np.ndarray)}


def linearization_of(record: Record) -> Linearization:
    """The linearization in a record."""
    header, arrays = record.header, {name: z.values for name, z in record.variables.items()}
    structure = structure_of(header["structure"])
    names: dict[str, Any] = {name: tuple(z) for name, z in header["names"].items()}
    own: dict[str, Any] = {z.name: arrays[z.name] for z in fields(Linearization) if z.name in arrays}
    return Linearization(
        **own,
        **names,
        state=_state(structure, header, _part(arrays, "state")),
        transfer=Transfer(**_part(arrays, "transfer")),
        derivatives=Tangents(**_part(arrays, "tangents")),
    )


def _part(arrays: Mapping[str, Any], part: str) -> dict[str, Any]:
    start = f"{part}_"
    return {
        n.removeprefix(start): z for n, z in arrays.items() if n.startswith(start) and n != "state_matrix"
    }


def _state(structure: Structure, header: Mapping[str, Any], arrays: Mapping[str, Any]) -> State:
    energy = Energy(*header["energy"])
    roles = roles_from(structure, {key: header["roles"][key] for key in ROLES})
    return State(
        **arrays, **header["state"], energy=energy, roles=roles, evaluation=StoredGeometry(structure)
    )


def save(lin: Linearization, path: str | Path) -> Path:
    """See `Linearization.save`."""
    return write(record_of_linearization(lin), path)


def to_xarray(lin: Linearization) -> Dataset:
    """See `Linearization.to_xarray`."""
    require("xarray", "xarray")
    full = record_of_linearization(lin)
    own = {name: z for name, z in full.variables.items() if name in DIMS}
    found = Record(full.kind, own, full.labels, {}, {}).to_xarray()
    known = lin.units
    for dim, names in full.labels.items():
        found = found.assign_coords({f"{dim}_unit": (dim, [known[name] for name in names])})
    found["eigenvalue"] = ("eigenvalue_number", lin.eigenvalues(), {"units": "1/s"})
    modes = lin.modes()
    found["mode_eigenvalue"] = ("mode", np.array([z.eigenvalue for z in modes]), {"units": "1/s"})
    shapes = np.array([[z.shape[name] for name in lin.dofs] for z in modes]).reshape(-1, len(lin.dofs))
    found["mode_shape"] = (("mode", "dof"), shapes)
    return found


def to_pandas(lin: Linearization) -> DataFrame:
    """See `Linearization.to_pandas`."""
    pandas = require("pandas", "xarray")
    rows = [
        {
            "mode": z.name,
            "real part": z.eigenvalue.real,
            "imaginary part": z.eigenvalue.imag,
            "omega": z.omega,
            "hertz": z.hertz,
            "damping ratio": z.damping,
        }
        | z.participation
        for z in lin.modes()
    ]
    frame = pandas.DataFrame(rows).set_index("mode")
    frame.attrs["units"] = {"real part": "1/s", "imaginary part": "rad/s", "omega": "rad/s", "hertz": "Hz"}
    return frame
