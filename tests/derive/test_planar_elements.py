"""Planar elements beside their spatial counterparts."""

import random
from typing import Any

import mpmath
import pytest
from element_numbers import (
    TINY,
    Vector,
    X,
    Y,
    Z,
    conjugate,
    equal,
    every,
    is_planar,
    named,
    numbers,
    product,
    random_coordinates,
    random_parameters,
    rotated,
    rotation,
)
from mpmath import mpf

from flexel.derive.declare import (
    Element,
)
from flexel.generated.table import ELEMENTS


def spatial(element: Element, x: Vector, rates: Vector) -> tuple[Vector, Vector]:
    """Return coordinates and rates of the spatial nodes that move in the plane as the planar ones do."""
    y: Vector = []
    w: Vector = []
    start = 0
    for node in element.nodes:
        value, rate = x[start : start + node.size], rates[start : start + node.size]
        start += node.size
        if node.kind == "planar_angle":
            lam = rotation(Z, value[0])
            y += lam
            w += [c / 2 for c in product([0, 0, 0, rate[0]], lam)]
        else:
            y += [*value, mpf(0)]
            w += [*rate, mpf(0)]
    return y, w


SPATIAL = {"planar_beam": "beam", "planar_beam_first_order": "beam_first_order", "planar_beam3": "beam3"}
SPATIAL |= {"planar_beam_logarithmic": "beam_logarithmic"}
SPATIAL |= {"planar_truss": "truss", "planar_hinge": "hinge", "planar_body": "body"}
SPATIAL |= {"planar_rotary_inertia": "rotary_inertia"}
SPATIAL |= {"planar_point_mass": "point_mass", "planar_body_velocity": "body_velocity"}
SPATIAL |= {"planar_bar_span": "bar_span", "planar_beam_span": "beam_span"}
SPATIAL |= {"planar_cable": "cable", "planar_cable_span": "cable_span", "planar_slope_clamp": "slope_clamp"}
SPATIAL |= {"planar_cable_circle": "cable_cylinder", "planar_cable_line": "cable_plane"}
SPATIAL |= {"planar_point_circle": "point_cylinder", "planar_point_line": "point_plane"}
SPATIAL |= {"planar_disc_circle": "sphere_cylinder", "planar_disc_line": "sphere_plane"}
SPATIAL |= {"planar_skate": "skate", "planar_roller_cam": "roller_cam"}
SPATIAL |= {"planar_flat_cam": "flat_cam"}
MODES = {"planar_beam": (0, 4, 5), "planar_beam_first_order": (0, 4, 5), "planar_beam3": (0, 1)}
MODES |= {"planar_beam_logarithmic": (0, 4, 5)}
MODES |= {"planar_cable": (0, 1, 2, 5, 8, 11), "planar_slope_clamp": (0,)}
MODES |= {"planar_cable_circle": (0,), "planar_cable_line": (0,)}
MODES |= {f"planar_{name}": (0,) for name in ("point_circle", "point_line", "disc_circle", "disc_line")}
MODES |= {"planar_roller_cam": (0,), "planar_flat_cam": (0,)}
MODES |= {"planar_truss": (0,), "planar_hinge": (0,), "planar_body": (), "planar_point_mass": ()}


# Quaternions from the plane's axes to those of the spatial surface: x along z; z along y with x along x.
CIRCLE_AXES = [mpf(1) / 2, mpf(-1) / 2, mpf(-1) / 2, mpf(-1) / 2]
LINE_AXES = rotation(X, -mpmath.pi / 2)


def spatial_parameters(values: dict[str, Any], turned: bool) -> dict[str, Any]:
    """Parameters of the spatial element for those of the planar one; `turned`: the hinge's axis is x, not z."""
    result = dict(values)
    in_plane = rotation(Z, values.get("alpha0", mpf(0)))
    if "offset" in values:
        x, y = values["offset"]
        circle = "radius" in values
        result["t"] = product(in_plane, CIRCLE_AXES if circle else LINE_AXES)
        result["offset"] = rotated(conjugate(CIRCLE_AXES if circle else LINE_AXES), [x, y, 0])
    elif "alpha0" in values:
        result["t"] = in_plane
    for name, angle in (("tp", values.get("alpha0", mpf(0))), ("tq", values.get("alphaq0", mpf(0)))):
        result[name] = rotation(Y, -mpmath.pi / 2) if turned else rotation(Z, angle)
    if turned:
        result["tp"] = product(rotation(Z, values["offset0"]), result["tp"])
    for name in ("gravity", "c", "d0", "centre"):
        if name in values:
            result[name] = [*values[name], 0]
    if "rhoJ" in values:
        result["rhoJ"] = [0, 0, values["rhoJ"]]
    if "EIz" in values:
        result |= {"EIy": mpf(0), "GAz": mpf(1)}
    if "J" in values:
        result["J"] = [0, 0, values["J"], 0, 0, 0]
    return result


@pytest.mark.parametrize("name", sorted(SPATIAL))
def test_planar_element_is_the_spatial_one_in_a_plane(name: str, rng: random.Random) -> None:
    planar, space = named(name), named(SPATIAL[name])
    values = random_parameters(planar, rng)
    x, v = random_coordinates(planar, rng), random_coordinates(planar, rng)
    names = {p.name for p in space.parameters}
    twin = spatial_parameters(values, turned="hinge" in name)
    if name == "planar_skate":  # its blade, on the plane z = 0
        twin |= {"blade": rotated(twin["t"], X), "normal": Z, "height": mpf(0)}
    flat, full = numbers(planar, **values), numbers(space, **{k: u for k, u in twin.items() if k in names})
    y, w = spatial(planar, x, v)
    e = full.D(y)
    modes = MODES.get(name, ())
    # the rotation vector in space is a series that is exact to the rounding of doubles
    tolerance = mpf("1e-16") if name == "planar_beam_logarithmic" else TINY
    assert equal([e[i] for i in modes], flat.D(x), tolerance)
    assert equal([e[i] for i in range(full.m) if i not in modes], [0] * (full.m - flat.m))
    assert equal(full.s(y, w)[: len(planar.slips)], flat.s(x, v))
    assert equal([full.T(y, w), full.U(y)], [flat.T(x, v), flat.U(x)])


PLANAR_ALONE = {"planar_bearing", "planar_belt", "planar_gear", "planar_wheel"}  # tested below


@every([name for name, element in ELEMENTS.items() if is_planar(element)])
def test_every_planar_element_has_its_spatial_counterpart(element: Element) -> None:
    assert (element.name in SPATIAL) != (element.name in PLANAR_ALONE)


def test_planar_bearing_measures_what_a_rigid_link_and_a_hinge_do(rng: random.Random) -> None:
    element = named("planar_bearing")
    values, x = random_parameters(element, rng), random_coordinates(element, rng)
    link = numbers(named("planar_beam3"), alpha0=values["alpha0"], d0=values["d0"]).D(x[:5])
    angle = numbers(named("planar_hinge"), offset0=values["offset0"]).D([x[2], x[5]])
    assert equal(numbers(element, **values).D(x), [*link, *angle])
