"""How the calls of each method change with the model; see `changes`."""

from dataclasses import replace
from typing import Any

import numpy as np

from campaign.calls import Call, Case, drawn_nodes
from campaign.changes import Change, Inapplicable, changer, options


def _numbers(values: Any) -> tuple[float, ...]:
    return tuple(np.asarray(values).tolist())


BENDING = (
    ".torsion",
    ".bend1",
    ".bend2",
)  # of a spatial beam: those that a reflection of its z axis turns over


def unit_of(case: Case, name: str) -> str:
    """Unit of a deformation or coordinate; an angle has none."""
    return "" if name.endswith((".angle", ".relation", ".mesh")) else "L"


def sign_of(change: Change, case: Case, name: str) -> float:
    """Of a deformation under a reflection: one about an axis of the plane or along an axis of turn changes its own."""
    turned_over = (".angle", ".mesh", ".bend1", ".bend2") if len(case.gravity) == 2 else (".axial", *BENDING)
    return change.sign if name.endswith(turned_over) else 1.0


def deformation(case: Case, name: str) -> str:
    """The name of a deformation; that of a coordinate has another meaning after a turn."""
    node = name.rpartition(".")[0]
    nodes = drawn_nodes(case)
    if node in nodes and nodes[node].kind != "angle":
        raise Inapplicable("a coordinate in global axes is named")
    return name


@changer("point")
def _point(change: Change, call: Call, case: Case) -> Call:
    return replace(call, args=(call.name, _numbers(change.place(call.args[1]))))


@changer("frame")
def _frame(change: Change, call: Call, case: Case) -> Call:
    lam = call.args[1] if len(call.args) > 1 else (1.0, 0.0, 0.0, 0.0)
    return replace(call, args=(call.name, _numbers(change.frame(lam))))


@changer("angle")
def _angle(change: Change, call: Call, case: Case) -> Call:
    value = call.args[1] if len(call.args) > 1 else 0.0
    return replace(call, args=(call.name, change.heading + change.sign * value))


@changer("fix")
def _fix(change: Change, call: Call, case: Case) -> Call:
    if any(z not in drawn_nodes(case) for z in call.args):
        raise Inapplicable("a coordinate in global axes is named")
    return call


@changer("independent", "release")
def _names(change: Change, call: Call, case: Case) -> Call:
    for name in call.args:
        deformation(case, name)
    return call


@changer("body_point")
def _same(change: Change, call: Call, case: Case) -> Call:
    return call


@changer("hinge", "bearing")
def _hinge(change: Change, call: Call, case: Case) -> Call:
    return options(call, axis=change.axial(call.options["axis"])) if "axis" in call.options else call


@changer("truss")
def _truss(change: Change, call: Call, case: Case) -> Call:
    return options(call, mass_per_length=change.size("M L-1", call.options.get("mass_per_length", 0.0)))


@changer("point_mass")
def _point_mass(change: Change, call: Call, case: Case) -> Call:
    return replace(call, args=(*call.args[:2], change.size("M", call.args[2])))


@changer("rotary_inertia")
def _rotary_inertia(change: Change, call: Call, case: Case) -> Call:
    return replace(call, args=(*call.args[:2], change.tensor(call.args[2])))


@changer("body")
def _body(change: Change, call: Call, case: Case) -> Call:
    z = call.options
    offset = change.body(z.get("offset", (0.0,) * len(case.gravity)))
    return options(call, mass=change.size("M", z["mass"]), inertia=change.tensor(z["inertia"]), offset=offset)


@changer("spring")
def _spring(change: Change, call: Call, case: Case) -> Call:
    name = call.args[0]
    slip = name.endswith((".lateral", ".longitudinal", ".sideways"))
    unit = "L" if slip else unit_of(case, deformation(case, name))
    length2 = " L2" if not unit else ""  # a moment by an angle
    k, c = f"M T-2{length2}", f"M T-1{length2}"
    sign = sign_of(change, case, name)
    z = call.options
    new = options(
        call,
        stiffness=change.size(k, z.get("stiffness") or 0.0),
        damping=change.size(c, z.get("damping") or 0.0),
        preload=sign * change.size(f"M T-2 {'L2' if not unit else 'L'}", z.get("preload") or 0.0),
        free_length=sign * change.size(unit, z.get("free_length") or 0.0),
    )
    if len(call.args) > 1:
        numbers = (change.size(u, value) for u, value in zip((k, c), call.args[1:], strict=False))
        new = replace(new, args=(name, *numbers))
    return new


@changer("load")
def _load(change: Change, call: Call, case: Case) -> Call:
    target, value = call.args
    if target in drawn_nodes(case):
        new = change.mass * change.length / change.time**2 * change.vector(value)
        return replace(call, args=(target, _numbers(new)))
    unit = "M T-2 L" if unit_of(case, deformation(case, target)) else "M T-2 L2"
    new = change.size(unit, value)
    return replace(call, args=(target, _signed(new, sign_of(change, case, target))))


@changer("prescribe")
def _prescribe(change: Change, call: Call, case: Case) -> Call:
    name, value = call.args
    node = deformation(case, name).rpartition(".")[0]
    if node in drawn_nodes(case):
        raise Inapplicable("a coordinate in global axes is named")
    sign = sign_of(change, case, name)
    new = change.size(unit_of(case, name), value)
    return replace(call, args=(name, _signed(new, sign)))


def _signed(value: Any, sign: float) -> Any:
    return value if sign > 0 else Change().factored(value, sign)


@changer("planar_gear")
def _gear(change: Change, call: Call, case: Case) -> Call:
    sizes = {z: change.size("L", call.options[z]) for z in ("radius_p", "radius_q")}
    return options(call, **sizes)


@changer("relation")
def _relation(change: Change, call: Call, case: Case) -> Call:
    name, terms = call.args
    for z in terms:
        deformation(case, z)
    new = {z: c / change.size(unit_of(case, z), 1.0) * sign_of(change, case, z) for z, c in terms.items()}
    return replace(call, args=(name, new))


@changer("wheel")
def _wheel(change: Change, call: Call, case: Case) -> Call:
    z = call.options
    normal = change.vector(z.get("normal", (0.0, 0.0, 1.0)))
    height = change.length * z.get("height", 0.0) + normal @ np.array(change.shift)
    new = {
        "radius": change.size("L", z["radius"]),
        "axle": _numbers(change.vector(z["axle"])),
        "normal": _numbers(normal),
        "height": float(height),
        "crown": change.size("L", z.get("crown", 0.0)),
    }
    return replace(call, options=new)


@changer("planar_wheel")
def _planar_wheel(change: Change, call: Call, case: Case) -> Call:
    direction = _numbers(change.vector(call.options.get("direction", (1.0, 0.0))))
    radius = change.size("L", call.options["radius"]) * change.sign
    if radius < 0:
        raise Inapplicable("an upright wheel turns about one side of the plane")
    return replace(call, options={"radius": radius, "direction": direction})


@changer("element")
def _element(change: Change, call: Call, case: Case) -> Call:
    side = change.body(call.options["side"]) / change.length if "side" in call.options else ()
    sizes = {z: change.size("L", call.options[z]) for z in ("l0", "base", "lift") if z in call.options}
    return options(call, mass=change.size("M", call.options.get("mass", 0.0)), side=np.array(side), **sizes)


@changer("law")
def _law(change: Change, call: Call, case: Case) -> Call:
    z = call.options
    unit = "M T-2" if unit_of(case, call.args[0][0]) else "M T-2 L2"
    return options(call, k=change.size(unit, z["k"]), lag=change.size("T", z["lag"]))
