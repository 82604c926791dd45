"""A planar model written as a spatial one."""

from dataclasses import replace

import numpy as np

from campaign.algebra import about
from campaign.calls import Call, Case, drawn_nodes
from campaign.changes import Inapplicable

Z = (0.0, 0.0, 1.0)


def in_space(case: Case) -> Case:
    """The same mechanism, each planar call by its spatial counterpart.

    Raises
    ------
    Inapplicable
        A spatial model, or a call without a counterpart.
    """
    if len(case.gravity) == 3:
        raise Inapplicable("not planar")
    calls = tuple(_in_space(z, case) for z in case.calls)
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
        case "fix":
            return call
        case "spring" | "prescribe" | "load" | "release" | "law" | "relation":
            return _same_names(call, case)
        case "body_point" | "truss" | "point_mass":
            return call
    raise Inapplicable(f"m.{call.method} has no counterpart in space")


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
