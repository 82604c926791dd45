"""A planar model written as a spatial one."""

from dataclasses import replace

import numpy as np

from campaign.algebra import about
from campaign.calls import Call, Case, drawn_nodes
from campaign.changes import Inapplicable

Z = (0.0, 0.0, 1.0)
CHOICES = ("independent", "initial")  # of coordinates and a state, which the property gives itself


def in_space(case: Case) -> Case:
    """The same mechanism, each planar call by its spatial counterpart.

    Raises
    ------
    Inapplicable
        A spatial model, or a call without a counterpart.
    """
    if len(case.gravity) == 3:
        raise Inapplicable("not planar")
    calls = tuple(_in_space(z, case) for z in case.calls if z.method not in CHOICES)
    known = case.known | {"redundant"}  # a planar loop has conditions in space that follow from others
    return replace(case, gravity=(*case.gravity, 0.0), calls=calls, known=known)


def _in_space(call: Call, case: Case) -> Call:
    args, z = call.args, call.options
    match call.method:
        case "point":
            return replace(call, args=(args[0], (*args[1], 0.0)))
        case "angle":
            lam = about(np.array(Z), args[1] if len(args) > 1 else 0.0)
            return Call("frame", (args[0], tuple(lam.tolist())), z)
        case "hinge" | "bearing":
            return replace(call, options={**z, "axis": Z})
        case "body":
            J = z["inertia"]
            thick = {"inertia": (0.7 * J, 0.6 * J, J)}
            flat = {"offset": (*z["offset"], 0.0)} if "offset" in z else {}
            return replace(call, options={**z, **thick, **flat})
        case "rotary_inertia":
            return replace(call, args=(*args[:2], (0.7 * args[2], 0.6 * args[2], args[2], 0.0, 0.0, 0.0)))
        case "beam" if len(args) == 5:
            j = z.get("inertia_per_length", 0.0)
            bent = (
                {"initial_curvature": (0.0, 0.0, z["initial_curvature"])} if "initial_curvature" in z else {}
            )
            aside = {
                "GJ": 3.0,
                "EIy": 5.0,
                "inertia_per_length": (0.7 * j, 0.6 * j, j),
                "direction": _side(call, case),
            }
            return replace(call, options={**z, **aside, **bent})
        case "slope" | "distributed_load":
            return replace(call, args=(args[0], (*args[1], 0.0)))
        case "sheave":
            return replace(call, options={**z, "axle": Z})
        case "rope_contact":
            if args[2].options.get("bristle_stiffness"):
                raise Inapplicable("bristles bend in two directions in space")
            return call
        case "fix" | "mass_damping" | "cable" | "clamp" | "anchor":
            return call
        case "release":
            return _same_names(replace(call, args=tuple(_bending(z) for z in args)), case)
        case "spring" | "prescribe" | "load" | "law" | "relation":
            return _same_names(call, case)
        case "body_point" | "truss" | "point_mass":
            return call
    raise Inapplicable(f"m.{call.method} has no counterpart in space")


def _bending(name: str) -> str:
    """A deformation: the plane of a planar beam is that of bend3 and bend4 of the spatial one."""
    return name.replace(".bend2", ".bend4").replace(".bend1", ".bend3")


def _side(call: Call, case: Case) -> tuple[float, float, float]:
    """The direction in the plane across a beam."""
    nodes = drawn_nodes(case)
    d = nodes[call.args[3]].drawn - nodes[call.args[1]].drawn
    return -float(d[1]), float(d[0]), 0.0


def _same_names(call: Call, case: Case) -> Call:
    """Names of angles of nodes do not exist in space; a vector of a load gets its third component."""
    nodes = drawn_nodes(case)
    given = call.args[0]
    if call.method == "load" and given in nodes:
        return replace(call, args=(given, (*call.args[1], 0.0)))
    listed = [*call.args[1]] if call.method == "relation" else [given] if isinstance(given, str) else [*given]
    if any(z.rpartition(".")[0] in nodes for z in listed):
        raise Inapplicable("a coordinate of the plane is named")
    return call
