"""Reads motions from SPACAR's `.sbd` files, with the names that a SPACAR input file has here.

Positions are p1, p2 ..., orientations o1, o2 ..., nodes of warping w1, w2 ..., beams in space beam1, beam2 ... with the
deformations of `m.beam`, which are SPACAR's; other elements are element1, element2 ... with the deformations e1, e2 ...
in SPACAR's signs: the file does not contain enough data to draw or to evaluate them.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.base.errors import ModelError
from flexel.base.quaternions import from_matrix
from flexel.derive.spec import DeformationSpec, ElementSpec, NodeSpec
from flexel.generated.table import ELEMENTS
from flexel.integration.outcome import Integration, States
from flexel.model.instances import Instance
from flexel.model.node import Node
from flexel.model.role_lists import Roles
from flexel.model.state import Energy, State
from flexel.model.structure import Structure, assemble_structure
from flexel.parts.beam_laws import NO_SHEAR
from flexel.results.motion import Motion
from flexel.results.saved.archive import StoredGeometry
from flexel.results.saved.spacar_entries import TaggedEntries

BEAM, NORM = 1, 4  # numbers of types in the entry IT
BEAMW_NODES = 6  # including two warping nodes
KINDS = {1: ("o", "planar_angle"), 2: ("p", "planar_point"), 3: ("p", "point"), 4: ("o", "frame")}
FIXED, DEPENDENT, PRESCRIBED, DYNAMIC, KINEMATIC = range(5)  # as counted in NXP and NEP
ORDER_X = (FIXED, DEPENDENT, PRESCRIBED, DYNAMIC, KINEMATIC)  # in the order of X, and of E
ORDER_E = (FIXED, PRESCRIBED, DYNAMIC, KINEMATIC, DEPENDENT)
UNKNOWN = float("nan")


@dataclass(frozen=True)
class _Layout:
    """Names of the model in a file, with the indices (from 0) of its quantities in X and in E."""

    structure: Structure
    x: Index
    e: Index
    roles: Roles


def motion_of_sbd(entries: TaggedEntries, path: Path) -> Motion:
    """Return the motion in the entries of an `.sbd` file, without a system.

    The reactions are SPACAR's FXT.  Energies are not in the file: they are NaN; ``motion.energy`` reports this.  Load
    steps, which all have the time zero, are counted instead.

    Raises
    ------
    ModelError
        A damaged file, or one without nodes.
    """
    missing = [
        tag for tag in ("LNP", "LE", "LN", "IT", "NXP", "NEP", "RL0", "RXYZ") if tag not in entries.constant
    ]
    missing += [
        tag for tag in ("T", "X", "XD", "XDD", "E", "ED", "EDD", "FXT", "SIG") if tag not in entries.records
    ]
    if missing:
        raise ModelError(
            f"load '{path}': the entries {', '.join(missing)} are missing; it is not a complete .sbd file"
        )
    layout = _layout(entries, path)
    records = {tag: record[:, :, 0] for tag, record in entries.records.items() if record.shape[2] == 1}
    t = records["T"][:, 0]
    counted = t.size > 1 and not np.ptp(t)
    times = np.arange(float(t.size)) if counted else t
    states = [
        _state(layout, {tag: record[i] for tag, record in records.items()}, float(times[i]))
        for i in range(t.size)
    ]
    message = "read from SPACAR's results" + ("; t counts the load steps" if counted else "")
    return Motion(None, Integration(States(states), [], [], {}, message))


def _state(layout: _Layout, record: dict[str, Array], t: float) -> State:
    """Return one record as a state."""
    s = layout.structure
    x, v, a, reactions = (record[tag][layout.x] for tag in ("X", "XD", "XDD", "FXT"))
    e, ed, edd, stresses = (record[tag][layout.e] for tag in ("E", "ED", "EDD", "SIG"))
    return State(
        t=t,
        x=x,
        v=v,
        a=a,
        e=e,
        rates=np.concatenate([ed, v]),
        stresses=stresses,
        given=np.zeros_like(stresses),
        reactions=reactions,
        roles=layout.roles,
        evaluation=StoredGeometry(s),
        energy=Energy(UNKNOWN, UNKNOWN, UNKNOWN),
        drift=UNKNOWN,
        z=np.zeros(0),
        zd=np.zeros(0),
        dissipated=UNKNOWN,
        Phi_v=np.concatenate([edd, a]),
    )


# -- the model ------------------------------------------------------------------------------------


def _layout(entries: TaggedEntries, path: Path) -> _Layout:
    constant = entries.constant
    x0 = entries.records["X"][0, :, 0]
    parts_x, parts_e = _parts(constant["NXP"], ORDER_X), _parts(constant["NEP"], ORDER_E)
    nodes: dict[int, tuple[Node, list[int]]] = {}
    warping = {int(n) for row in constant["LN"] if np.count_nonzero(row) == BEAMW_NODES for n in row}
    for n, row in enumerate(np.asarray(constant["LNP"]), 1):
        places = [int(number) - 1 for number in row if number > 0]
        if places:
            nodes[n] = _node(n, places, x0, parts_x, n in warping), places
    if not nodes:
        raise ModelError(f"load '{path}': it has no nodes")
    instances, rows = [], []
    for i, row in enumerate(np.asarray(constant["LE"])):
        instance = _instance(i, constant, nodes, path)
        if instance is not None:
            instances.append(instance)
            rows.append([int(number) - 1 for number in row if number > 0])
    # the norms last, as in a model
    order = sorted(range(len(rows)), key=lambda k: instances[k].spec is ELEMENTS["norm"])
    structure = assemble_structure([node for node, _ in nodes.values()], [instances[k] for k in order], [])
    at = {
        name: k for node, places in nodes.values() for name, k in zip(node.coordinates, places, strict=True)
    }
    x = np.array([at[name] for name in structure.coordinate_of], dtype=np.intp)
    e = np.array([place for k in order for place in rows[k]], dtype=np.intp)
    part = np.concatenate([parts_e[e], np.where(parts_x[x] == FIXED, -1, parts_x[x])])
    rigid, prescribed, dynamic, kinematic = (
        np.flatnonzero(part == role) for role in (FIXED, PRESCRIBED, DYNAMIC, KINEMATIC)
    )
    none = np.zeros(0, dtype=np.intp)
    return _Layout(structure, x, e, Roles(rigid, prescribed, (), none, dynamic, kinematic))


def _parts(counts: Any, order: tuple[int, ...]) -> Index:
    """Return the role of each quantity: fixed, dependent, prescribed, dynamic or kinematic."""
    return np.repeat(order, np.ravel(counts)[list(order)])


def _node(n: int, places: list[int], x0: Array, parts: Index, of_beamw: bool) -> Node:
    letter, kind = ("w", "warping") if of_beamw and len(places) == 1 else KINDS[len(places)]
    fixed = parts[places] == FIXED
    if kind == "frame" and fixed[1:].all():
        fixed[0] = True  # it follows from the others
    return Node(f"{letter}{n}", kind, np.array(x0[places]), fixed)


def _instance(i: int, constant: Any, nodes: dict[int, tuple[Node, list[int]]], path: Path) -> Instance | None:
    """Return an element; None for the norm of a fixed frame, which a model does not have."""
    absent = [int(n) for n in constant["LN"][i] if n > 0 and int(n) not in nodes]
    if absent:
        raise ModelError(
            f"load '{path}': element {i + 1} has the node {absent[0]}, which the file does not have; it is damaged"
        )
    ends = [nodes[int(n)][0] for n in constant["LN"][i] if n > 0]
    count = int(np.count_nonzero(constant["LE"][i]))
    kind, kinds = int(np.ravel(constant["IT"])[i]), [node.kind for node in ends]
    names = tuple(node.name for node in ends)
    if kind == NORM and kinds == ["frame"]:
        return None if ends[0].fixed.all() else Instance(ends[0].name, ELEMENTS["norm"], names, {})
    if kind == BEAM and kinds == ["point", "frame", "point", "frame"] and count == 6:
        return Instance(f"beam{i + 1}", ELEMENTS["beam"], names, _beam_parameters(i, constant))
    spec = ElementSpec(
        name="SPACAR's element",
        digest="",
        doc="",
        source="",
        nodes=tuple(NodeSpec(node.name, node.kind) for node in ends),
        parameters=(),
        deformations=tuple(DeformationSpec(f"e{k}", "", False) for k in range(1, count + 1)),
        slips=(),
        kernels={},
    )
    return Instance(f"element{i + 1}", spec, names, {})


def _beam_parameters(i: int, constant: Any) -> dict[str, Array]:
    """Return length and triads of a beam, for its shape; its mass is not in the file."""
    spec = ELEMENTS["beam"]
    t = from_matrix(np.reshape(constant["RXYZ"][i], (3, 3)).T)
    own = {"l0": np.ravel(constant["RL0"][i]), "tp": t, "tq": t}
    own |= {name: np.array([NO_SHEAR]) for name in ("GAy", "GAz")}
    return {
        parameter.name: own.get(parameter.name, np.zeros(parameter.size)) for parameter in spec.parameters
    }
