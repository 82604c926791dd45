"""Linearizations as records and back; whatever a linearization was asked, one from a file answers too.

Arrays are taken field by field from the dataclasses, so that a record grows with them.  The functions at the end are
methods of `Linearization`.
Imports numpy and the runtime rooms of records, descriptions and states.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.errors import ModelError
from flexel.saved.archive import ROLES, StoredGeometry, roles_from, roles_in_names
from flexel.saved.description import described, structure_of
from flexel.saved.record import Record, Variable, require
from flexel.state import Energy, State
from flexel.structure import Structure
from flexel.units import rate_unit

if TYPE_CHECKING:
    from flexel.linearize import Linearization, Mode

# Names along rows and columns, where they are freedoms.
DIMS = {
    "M": ("dynamic", "dynamic_column"),
    "C": ("dynamic", "dynamic_column"),
    "K": ("dynamic", "freedom"),
    "A_k": ("kinematic", "dynamic_column"),
    "B_k": ("kinematic", "freedom"),
    **dict.fromkeys(("M_u", "C_u", "K_u"), ("dynamic", "prescribed")),
    **dict.fromkeys(("A_ku", "B_ku"), ("kinematic", "prescribed")),
    "Z": ("dynamic", "internal"),
    "Z_v": ("internal", "dynamic_column"),
    "Z_q": ("internal", "freedom"),
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
        "freedom": lin.freedoms,
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
    from flexel.evaluate import Tangents
    from flexel.linearize import Linearization, Transfer

    header, arrays = record.header, {name: z.values for name, z in record.variables.items()}
    structure = structure_of(header["structure"])
    names: dict[str, Any] = {name: tuple(z) for name, z in header["names"].items()}
    own: dict[str, Any] = {z.name: arrays[z.name] for z in fields(Linearization) if z.name in arrays}
    return Linearization(
        **own,
        **names,
        state=_state(structure, header, _part(arrays, "state")),
        transfer=Transfer(**_part(arrays, "transfer")),
        tangents=Tangents(**_part(arrays, "tangents")),
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


# -- methods of Linearization ---------------------------------------------------------------------


def save(self: Linearization, path: str | Path) -> Path:
    """Write all matrices with their names as .nc, .npz, .mat or .csv; `flexel.load` reads them back.

    For A, B, C and D alone, in Matlab's form, see `save_state_space`.
    """
    from flexel.saved.files import write

    return write(record_of_linearization(self), path)


def units(self: Linearization) -> dict[str, str]:
    """Units of the freedoms, their rates (``name'``), the prescribed motions and the laws' internal states, by name.

    A row of M, C or K is the generalized force dual to its freedom, per unit of the freedom of its column or its rates.
    """
    s = self.state.structure
    own = {name: s.units[s.index[name]] for name in (*self.freedoms, *self.prescribed)}
    rates = {f"{name}'": rate_unit(own[name], 1) for name in self.dynamic}
    return own | rates | {name: s.internal_units[s.internal[name]] for name in self.internal}


def to_xarray(self: Linearization) -> Any:
    """Matrices, eigenvalues and modes as an xarray.Dataset with names and units along rows and columns."""
    require("xarray", "xarray")
    full = record_of_linearization(self)
    own = {name: z for name, z in full.variables.items() if name in DIMS}
    found = Record(full.kind, own, full.labels, {}, {}).to_xarray()
    known = self.units
    for dim, names in full.labels.items():
        found = found.assign_coords({f"{dim}_unit": (dim, [known[name] for name in names])})
    found["eigenvalue"] = ("eigenvalue_number", self.eigenvalues(), {"units": "1/s"})
    modes = self.modes()
    found["mode_eigenvalue"] = ("mode", np.array([z.eigenvalue for z in modes]), {"units": "1/s"})
    shapes = np.array([[z.shape[name] for name in self.freedoms] for z in modes]).reshape(
        -1, len(self.freedoms)
    )
    found["mode_shape"] = (("mode", "freedom"), shapes)
    return found


def to_pandas(self: Linearization) -> Any:
    """A pandas.DataFrame of the modes: eigenvalue, frequency, damping ratio, and the freedoms that take part."""
    pandas = require("pandas", "xarray")
    rows = [
        {
            "mode": z.name,
            "real part": z.eigenvalue.real,
            "imaginary part": z.eigenvalue.imag,
            "frequency": z.frequency,
            "damping ratio": z.damping,
        }
        | z.participation
        for z in self.modes()
    ]
    frame = pandas.DataFrame(rows).set_index("mode")
    frame.attrs["units"] = {"real part": "1/s", "imaginary part": "rad/s", "frequency": "rad/s"}
    return frame


def mode_shape(self: Linearization, number: int) -> dict[str, complex]:
    """Displacements of all free coordinates in a mode of `modes`, for pictures; freedoms of amplitude 1 at most."""
    mode = _mode(self, number)
    q = np.array([mode.shape[name] for name in self.freedoms])
    structure = self.state.structure
    x = self.transfer.G[:, : q.size] @ q
    first = structure.m + structure.k
    return {structure.names[first + i]: complex(z) for i, z in enumerate(x)}


def plot(self: Linearization, path: str | Path | None = None) -> Any:
    """Eigenvalues in the complex plane (needs matplotlib)."""
    from flexel.pictures.graphs import plot_poles

    return plot_poles([self.eigenvalues()], path)


def _mode(lin: Linearization, number: int) -> Mode:
    modes = lin.modes()
    if not -len(modes) <= number < len(modes):
        raise ModelError(f"mode {number}: there are {len(modes)}, numbered from 0; list them with modes()")
    return modes[number]


def view(self: Linearization, path: str | Path, **options: Any) -> Path:
    """A page that shows the modes in any browser, with amplitude and phase; options of `flexel.view.mode_data`."""
    from flexel.view import view_modes

    return view_modes(self, path, **options)


def plot_mode(self: Linearization, number: int, path: str | Path | None = None, **options: Any) -> Any:
    """The shape of a mode of `modes`, over the state in grey; see `flexel.pictures.deflected.plot_shape`."""
    from flexel.pictures.deflected import plot_shape

    mode = _mode(self, number)
    title = f"{mode.name}: {mode.eigenvalue:.4g} 1/s"
    return plot_shape(self.state, mode_shape(self, number), path, **{"title": title, **options})
