"""Turns tables into a model: nodes, leaf springs, rigid beams, masses, loads and prescribed motions, by name."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import numpy as np

from flexel.apps.flexures.input_tables import FlexureTables, group_owner, node_owner, read_tables
from flexel.apps.flexures.node_loads import BOTH_WAYS, ONE_WAY, Schedule, load_node
from flexel.apps.flexures.properties import ElementProperties, NodeProperties
from flexel.apps.flexures.showing import show
from flexel.apps.flexures.warping_conditions import warping_ends
from flexel.base.arguments import array, flag, names, number, whole
from flexel.base.errors import ModelError
from flexel.model.profiles import Section
from flexel.parts.beams import MODES
from flexel.parts.materials import MATERIALS, Material, material_of
from flexel.parts.model import Model
from flexel.parts.round_sections import Circle, Tube
from flexel.parts.sections import Rectangle
from flexel.results.flexure_step import element_name, frame_name, node_name


@contextmanager
def _in(owner: str) -> Iterator[None]:
    """Put the row of the table in front of the message of an error about it."""
    try:
        yield
    except ModelError as error:
        raise ModelError(f"{owner}: {error}") from error


FIXED_COMPONENTS = {"position": ("x", "y", "z"), "x": ("x",), "y": ("y",), "z": ("z",)}
ROTATION = "rotation"


def flexure_model(
    nodes: Any, elements: Any, node_properties: Any = None, element_properties: Any = (), options: Any = None
) -> Model:
    """Build the model of a flexure mechanism from tables without analysing it: to check it, draw it, or extend it.

    The arguments are those of `flexure`.  Nodes are called "node 1" and "frame 1", …, elements "element 1", …; the
    beams of a divided element "element 1 beam 1", ….  Loads and prescribed motions are functions of time: from
    -1 to 0 the initial ones grow, from 0 to 1 the others.  With `both_ways` the initial ones grow from -3 to -2; the
    others then decrease until -1 and grow until 1.

    Parameters
    ----------
    nodes, elements, node_properties, element_properties, options
        As for `flexure`; of the options, only gravity and both_ways matter.

    Raises
    ------
    ModelError
        An error in the tables; the message names the row.

    Examples
    --------
    >>> m = fx.flexure_model(nodes, elements, node_properties, element_properties)  # doctest: +SKIP
    >>> print(m.check())  # doctest: +SKIP
    """
    return declared(read_tables(nodes, elements, node_properties, element_properties, options))


def schedule_of(tables: FlexureTables) -> Schedule:
    """Return the shares of the loads over time."""
    return BOTH_WAYS if tables.options.both_ways else ONE_WAY


def declared(tables: FlexureTables) -> Model:
    """Build the model of checked tables."""
    m = Model(gravity=tables.options.gravity)
    for i, place in enumerate(tables.places, start=1):
        m.point(node_name(i), place)
        m.frame(frame_name(i))
    for node, given in tables.nodes.items():
        _hold(m, node, given)
        _inertia(m, node, given)
    for i, (p, q) in enumerate(tables.ends, start=1):
        before = set(m.instances)
        _element(m, i, (p, q), tables)
        show(m, [name for name in m.instances if name not in before], tables, i)
    for node, given in tables.nodes.items():
        load_node(m, node, given, schedule_of(tables))
    if all(np.all(m.nodes[node_name(i + 1)].fixed) for i in range(len(tables.places))):
        raise ModelError("flexure: node_properties: all nodes are fixed, so nothing can move; leave one free")
    return m


def _hold(m: Model, node: int, given: NodeProperties) -> None:
    owner, wanted = node_owner(node), given.fixed
    if isinstance(wanted, (bool, np.bool_)):
        if wanted:
            m.fix(node_name(node), frame_name(node))
        return
    for name in names([wanted] if isinstance(wanted, str) else wanted, f"{owner}: fixed"):
        if name == ROTATION:
            m.fix(frame_name(node))
        elif name in FIXED_COMPONENTS:
            m.fix(*(f"{node_name(node)}.{component}" for component in FIXED_COMPONENTS[name]))
        else:
            raise ModelError(
                f"{owner}: fixed {name!r} is unknown; give True, or some of {', '.join(FIXED_COMPONENTS)}, {ROTATION}"
            )


def _inertia(m: Model, node: int, given: NodeProperties) -> None:
    """Declare a point mass or a body; m.body reports errors of the inertia."""
    owner = node_owner(node)
    mass = number(given.mass, owner, "mass")
    if given.inertia is not None:
        if mass <= 0:
            raise ModelError(f"{owner}: an inertia without a mass; give the mass [kg] of the same body")
        with _in(owner):
            m.body(f"body {node}", node_name(node), frame_name(node), mass=mass, inertia=given.inertia)
    elif mass:
        with _in(owner):
            m.point_mass(f"mass {node}", node_name(node), mass)


def _element(m: Model, element: int, ends: tuple[int, int], tables: FlexureTables) -> None:
    """Declare an element: a leaf spring if some of its modes are flexible, otherwise a rigid beam."""
    name = element_name(element)
    bodies = [name for i in ends for name in (node_name(i), frame_name(i))]
    group = tables.group(element)
    if group is None:
        m.beam(name, *bodies, rigid=True)
        return
    owner = group_owner(tables.group_of[element])
    flexible, section = _flexible(group, owner), _section(group, owner)
    if flexible and section is None:
        raise ModelError(f"{owner}: flexible modes without a section; give section='rectangle', dimensions=…")
    material = _material(group, owner, bool(flexible))
    beams = whole(group.beams, owner, "beams")
    warps = flag(group.warping, owner, "warping")
    if warps and not flexible:
        raise ModelError(f"{owner}: a rigid element does not warp; drop warping, or name flexible modes")
    if flexible and section is not None:
        with _in(owner):
            m.leaf_spring(
                name,
                *bodies,
                section=section,
                material=material,
                elements=beams,
                direction=group.orientation,
                flexible=flexible,
                warping=warping_ends(m, element, tables) if warps else False,
            )
        return
    if beams > 1:
        raise ModelError(f"{owner}: a rigid element is one beam; drop beams={beams}, or name flexible modes")
    stuff = None if section is None else material
    with _in(owner):
        m.beam(name, *bodies, rigid=True, direction=group.orientation, section=section, material=stuff)


def _flexible(group: ElementProperties, owner: str) -> tuple[str, ...]:
    """Return the names of the flexible modes."""
    given = group.flexible
    if isinstance(given, str):
        given = MODES if given == "all" else (given,)
    elif not isinstance(given, (list, tuple, np.ndarray)):
        raise ModelError(f"{owner}: flexible {given!r:.60} is not a list; give [2, 3, 4], or 'all'")
    found = []
    for mode in given:
        if isinstance(mode, str) and mode in MODES:
            found.append(mode)
        elif isinstance(mode, (int, np.integer)) and mode is not True and 1 <= mode <= len(MODES):
            found.append(MODES[int(mode) - 1])
        else:
            raise ModelError(
                f"{owner}: flexible {mode!r} is not a mode of a beam; give numbers from 1 to 6, or {', '.join(MODES)}"
            )
    for a, b in (MODES[2:4], MODES[4:6]):
        if (a in found) != (b in found):
            one, two = MODES.index(a) + 1, MODES.index(b) + 1
            raise ModelError(f"{owner}: flexible has only one of {one} and {two} ({a}, {b}); name both")
    return tuple(dict.fromkeys(found))


SECTIONS: dict[str, tuple[Callable[..., Section], int]] = {
    "rectangle": (Rectangle, 2),
    "circle": (Circle, 1),
    "tube": (Tube, 2),
}


def _section(group: ElementProperties, owner: str) -> Section | None:
    """Return the section of a group, given by name and dimensions or as an object."""
    given, sizes = group.section, group.dimensions
    if not isinstance(given, str):
        if sizes is not None:
            raise ModelError(f"{owner}: dimensions without the name of a section; give section='rectangle'")
        return given
    if given not in SECTIONS:
        raise ModelError(
            f"{owner}: section '{given}' is unknown; give one of {', '.join(SECTIONS)}, or an object"
        )
    kind, count = SECTIONS[given]
    listed = np.atleast_1d(array(() if sizes is None else sizes, owner, "dimensions"))
    if listed.shape != (count,):
        raise ModelError(f"{owner}: dimensions {sizes!r:.60} for a {given}; give {count} number(s) [m]")
    with _in(owner):
        return kind(*listed.tolist())


def _material(group: ElementProperties, owner: str, flexible: bool) -> Material:
    """Return the material of a group; for a rigid group only the density matters."""
    numbers = {"E": group.E, "G": group.G, "nu": group.nu, "rho": group.density, "strength": group.strength}
    given = {key: number(value, owner, key) for key, value in numbers.items() if value is not None}
    if group.material is not None:
        if given:
            raise ModelError(
                f"{owner}: material and also {', '.join(given)}; drop one of them, or change a material with "
                "dataclasses.replace"
            )
        if group.section is None:
            raise ModelError(
                f"{owner}: a material without a section; give section and dimensions, or drop it"
            )
        return material_of(group.material, owner)
    if given and group.section is None:
        raise ModelError(
            f"{owner}: {', '.join(given)} without a section; give section and dimensions, or drop it"
        )
    if not flexible and "E" not in given:
        return replace(MATERIALS["steel"], rho=given.get("rho", 0.0))
    if "E" not in given:
        raise ModelError(f"{owner}: neither a material nor E; give material='spring steel', or E and nu")
    if ("nu" in given) == ("G" in given):
        raise ModelError(f"{owner}: give one of nu and G with E")
    with _in(owner):
        return Material(**given)
