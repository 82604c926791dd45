"""Wheels on compliant tyres at random slip: one alone, and two on a body, on planes and on waves."""

from typing import Any

import numpy as np
from hypothesis import strategies as st

import flexel as fx
from campaign.algebra import about, product, rotated
from campaign.case import Case, declared
from campaign.numbers import Draw, number, vectors
from flexel.model.part import Part

SIDE = ("deflection", "camber", "forward", "sideways", "lateral", "spin")
MAGIC = ("deflection", "camber", "forward", "rolling", "longitudinal", "lateral", "spin")
CALSPAN = {
    "A": (2625.0, 14.47, 12930.0, 2.29, 18175.0),
    "B": (-0.464e-4, 1.216, 2.18e-11),
    "SN": 1.0274,
    "AF": (-0.171e-4, 0.171e-4),
}
RADIUS = 0.35


def _magic(draw: Draw) -> dict[str, Any]:
    """A Magic Formula, with initial slips."""
    return {
        "load0": 4000.0,
        "rolling_radius": draw(number(0.3, 0.36)),
        "friction": (draw(number(0.6, 1.2)), draw(number(-0.2, 0.0))),
        "slip_stiffness": draw(number(10, 25)),
        "cornering": (draw(number(8, 20)), draw(number(1.5, 3))),
        "camber_stiffness": draw(number(0.2, 1)),
        "shape": (draw(number(1.2, 1.6)), draw(number(-1, 0.5))),
        "trail": (draw(number(0.0, 0.05)), draw(number(2, 10))),
        "relaxation": (draw(number(0.1, 0.5)), draw(number(0.2, 0.8))),
        "initial": {"kappa": draw(number(-0.2, 0.2)), "tan_alpha": draw(number(-0.3, 0.3))},
    }


def _law(draw: Draw, tyre: str, calm: bool) -> Part[Any]:
    """A law on a tyre; `calm`: a spring alone."""
    law = (
        "vertical_tyre"
        if calm
        else draw(st.sampled_from(["vertical_tyre", "linear_tyre", "calspan_tyre", "magic_formula"]))
    )
    more: dict[str, Any] = {
        "stiffness": draw(number(3e4, 7e4, 1e3)),
        "damping": 0.0 if calm else draw(st.sampled_from([0.0, 300.0])),
    }
    if law == "vertical_tyre":
        return declared("attach", law, [f"{tyre}.{draw(st.sampled_from(['drop', 'deflection']))}"], **more)
    if law == "magic_formula":
        return declared(
            "attach",
            law,
            [f"{tyre}.{name}" for name in MAGIC],
            name=f"rubber of {tyre}",
            **more,
            **_magic(draw),
        )
    more["standstill"] = draw(number(1.5, 3))
    if law == "calspan_tyre":
        more |= CALSPAN
    else:
        more |= {
            "cornering": draw(number(1e4, 5e4, 1e3)),
            "camber_stiffness": draw(number(0, 7e3, 1e3)),
            "trail": 0.06,
        }
    return declared("attach", law, [f"{tyre}.{name}" for name in SIDE], **more)


def _road(draw: Draw) -> dict[str, Any]:
    """A plane that may be tilted, or waves."""
    kind = draw(st.sampled_from(["flat", "tilted", "waves"]))
    if kind == "flat":
        return {}
    if kind == "tilted":
        return {"normal": (*draw(vectors(2, 0.1)), 1.0), "height": draw(number(-0.01, 0.01))}
    heading = draw(number(-3, 3))
    waves: dict[str, Any] = {
        "start": -20.0,
        "count": 10.0,
        "heading": (float(np.cos(heading)), float(np.sin(heading))),
    }
    return {"road": fx.Waves(draw(number(0.005, 0.05)), 5.0, **waves)}


def _leaning(draw: Draw) -> Any:
    """Orientation of a wheel whose axle is its y axis."""
    yaw, lean = about((0, 0, 1), draw(number(-0.7, 0.7))), about((1, 0, 0), draw(number(-0.4, 0.4)))
    return product(yaw, lean)


def _wheel(draw: Draw, hub: str, frame: str, turn: Any, road: dict[str, Any], calm: bool) -> list[Part[Any]]:
    """The tyre of a wheel and its law."""
    axle = tuple(rotated(turn, np.array([0.0, 1.0, 0.0])).tolist())
    crown = draw(st.sampled_from([0.0, 0.05]))
    name = f"{frame} tyre"
    return [
        declared("tyre", name, hub, frame, radius=RADIUS, axle=axle, crown=crown, **road),
        _law(draw, name, calm),
    ]


def _velocity(draw: Draw, turn: Any) -> tuple[float, ...]:
    """Of a wheel's centre: ahead or back, faster than laws fade out or well below, with a slip angle."""
    ahead = draw(st.sampled_from((-1, 1))) * draw(st.one_of(number(4, 15), number(0.2, 0.8)))
    aside = draw(number(-0.4, 0.4)) * ahead
    x, y, _ = rotated(turn, np.array([ahead, aside, 0.0]))
    return float(x), float(y), draw(number(-0.3, 0.3))


@st.composite
def wheels(draw: Draw) -> Case:
    """A wheel alone."""
    turn = _leaning(draw)
    moment = number(1.0, 1.5)
    height = (
        draw(number(0.26, 0.3)) if draw(st.integers(0, 5)) else 0.45
    )  # pressed all the time, or in the air
    parts = [
        declared("point", "hub", (draw(number(-0.3, 0.3)), draw(number(-0.3, 0.3)), height)),
        declared("frame", "wheel", tuple(turn.tolist())),
        declared(
            "body",
            "rim",
            "hub",
            "wheel",
            mass=draw(number(20, 60)),
            inertia=draw(st.tuples(moment, moment, moment)),
        ),
        *_wheel(draw, "hub", "wheel", turn, _road(draw), draw(st.integers(0, 3)) == 0),
    ]
    speeds = dict(zip(("hub.x", "hub.y", "hub.z"), _velocity(draw, turn), strict=True))
    return Case("tyres", (0.0, 0.0, -9.81), tuple(parts), draw(vectors(4, 5.0)), 0.01, speeds=speeds)


@st.composite
def carts(draw: Draw) -> Case:
    """A body on two wheels, one behind the other, that turn on hinges."""
    road, calm = _road(draw), draw(st.integers(0, 3)) == 0
    turn = _leaning(draw)
    height = draw(number(0.26, 0.3))
    parts = [
        declared("point", "C", (0.0, 0.0, height)),
        declared("frame", "chassis", tuple(turn.tolist())),
        declared(
            "body", "frame", "C", "chassis", mass=60.0, inertia=(8.0, 9.0, 10.0), offset=draw(vectors(3, 0.2))
        ),
    ]
    axle = tuple(rotated(turn, np.array([0.0, 1.0, 0.0])).tolist())
    for name, x in (("front", draw(number(0.5, 0.8))), ("rear", draw(number(-0.8, -0.5)))):
        hub = rotated(turn, np.array([x, 0.0, 0.0])) + [0.0, 0.0, height]
        parts += [
            declared("point", f"{name} hub", tuple(hub.tolist())),
            declared("frame", name, tuple(turn.tolist())),
            declared("body_point", f"{name} arm", "C", "chassis", f"{name} hub"),
            declared("hinge", f"{name} axle", "chassis", name, axis=axle),
            declared("body", f"{name} rim", f"{name} hub", name, mass=15.0, inertia=(0.6, 1.0, 0.6)),
            *_wheel(draw, f"{name} hub", name, turn, road, calm),
        ]
    ahead, aside = draw(number(4, 12)), draw(number(-1, 1))
    speeds = {f"{point}.x": ahead for point in ("C", "front hub", "rear hub")} | {"C.y": aside}
    speeds |= {"front axle.angle": draw(number(10, 40)), "rear axle.angle": draw(number(10, 40))}
    return Case("carts", (0.0, 0.0, -9.81), tuple(parts), draw(vectors(3, 0.5)), 0.01, speeds=speeds)


TYRES = {
    "tyres": wheels(),
    "carts": carts(),
}
