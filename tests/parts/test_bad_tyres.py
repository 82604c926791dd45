"""Tyres and wheels that are refused, by name."""

from typing import Any

import pytest
from wheels import CALSPAN, MAGIC, MAGIC_ON, SIDE, K, R, wheel

import flexel as fx


def test_wheels_that_cannot_be_are_refused_by_name() -> None:
    m = fx.Model()
    m.point("hub", (0, 0, R))
    m.point("contact", (0, 0, 0))
    m.frame("wheel")
    with pytest.raises(fx.ModelError, match=r"tyre 'A': its axle .* normal to the road.*tilt it"):
        m.tyre("A", "hub", "wheel", radius=R, axle=(0, 0, 1))
    with pytest.raises(fx.ModelError, match=r"wheel 'B': crown 0.4 m reaches the axle"):
        m.wheel("B", "hub", "wheel", "contact", radius=R, axle=(0, 1, 0), crown=0.4)
    with pytest.raises(fx.ModelError, match=r"tyre 'C': a plane and waves are both given"):
        m.tyre("C", "hub", "wheel", radius=R, axle=(0, 1, 0), height=0.1, road=fx.Waves(0.1, 5.0))
    with pytest.raises(fx.ModelError, match=r"tyre 'D': wavelength -1 is not positive"):
        m.tyre("D", "hub", "wheel", radius=R, axle=(0, 1, 0), road=fx.Waves(0.1, -1.0))
    with pytest.raises(fx.ModelError, match=r"tyre 'E': count of waves 0.5 is not whole.*give a whole"):
        m.tyre("E", "hub", "wheel", radius=R, axle=(0, 1, 0), road=fx.Waves(0.1, 5.0, count=0.5))
    for normal in (None, 1.0):
        with pytest.raises(fx.ModelError, match=r"tyre 'F': road normal .*; give"):
            m.tyre("F", "hub", "wheel", radius=R, axle=(0, 1, 0), normal=normal, road=fx.Waves(0.1, 5.0))


@pytest.mark.parametrize(
    ("road", "below"),
    [
        ({"height": R + 0.1}, "0.1"),
        ({"normal": (0, 0, -1)}, "0.36"),
        ({"road": fx.Waves(1.0, 4.0, start=-2.0)}, "0.64"),
    ],
)
def test_a_tyre_whose_hub_lies_below_the_road_is_refused(road: dict[str, Any], below: str) -> None:
    m = fx.Model()
    m.point("hub", (0, 0, R))
    m.frame("wheel")
    with pytest.raises(fx.ModelError, match=f"tyre 'A': its hub lies {below} m below the road.*put it above"):
        m.tyre("A", "hub", "wheel", radius=R, axle=(0, 1, 0), **road)


@pytest.mark.parametrize("left", [("hub",), None, "hub"])
def test_an_axle_slip_between_anything_but_two_wheels_is_refused(left: Any) -> None:
    m = fx.Model()
    m.point("hub", (0, 0, R))
    m.frame("wheel")
    with pytest.raises(fx.ModelError, match=r"axle slip 'A': left .* is not a hub and its frame; give"):
        m.axle_slip("A", left, ("hub", "wheel"), axle=(0, 1, 0))


@pytest.mark.parametrize(
    ("law", "change", "message"),
    [
        ("vertical_tyre", {"stiffness": -1e5}, "stiffness -100000 is negative"),
        ("vertical_tyre", {"damping": -1.0}, "damping -1 is negative"),
        ("linear_tyre", {"standstill": -1.0}, "standstill -1 is not positive"),
        ("linear_tyre", {"cornering": -1.0}, "cornering -1 is negative"),
        ("calspan_tyre", {"A": (2625.0, 14.47, 0.0, 2.29, 18175.0)}, "A, entry 3, 0 is not positive"),
        ("calspan_tyre", {"A": (2625.0, 14.47, 12930.0, 2.29, 0.0)}, "A, entry 5, is zero"),
        ("calspan_tyre", {"SN": 0.0}, "SN 0 is not positive"),
        ("magic_formula", {"relaxation": (0, 0)}, "relaxation, entry 1, 0 is not positive"),
        ("magic_formula", {"cornering": (12, 0)}, "cornering, entry 2, 0 is not positive"),
        ("magic_formula", {"load0": -4000.0}, "load0 -4000 is not positive"),
    ],
)
def test_parameters_of_tyres_without_physical_sense_are_refused(
    law: str, change: dict[str, Any], message: str
) -> None:
    linear = {"cornering": 1e4, "camber_stiffness": 0.0, "trail": 0.0, "standstill": 0.1}
    own: dict[str, Any] = {
        "vertical_tyre": {},
        "linear_tyre": linear,
        "calspan_tyre": CALSPAN,
        "magic_formula": MAGIC,
    }
    on = {"vertical_tyre": ["tyre.deflection"], "magic_formula": MAGIC_ON}.get(law, SIDE)
    values = {"stiffness": K, "damping": 0.0, **own[law], **change}
    with pytest.raises(fx.ModelError, match=f"law '{law}' on 'tyre.deflection'.*: parameter {message}"):
        wheel().attach(law, on, **values)


def test_arguments_of_a_law_are_compared_with_the_units_of_quantities() -> None:
    m = wheel()
    on = ["tyre.camber", "tyre.deflection", *MAGIC_ON[2:]]
    with pytest.raises(
        fx.ModelError,
        match=r"'tyre.camber' is in rad, which does not fit argument deflection \[m\]; give them in this "
        r"order: deflection \[m\], camber \[rad\], forward \[m/s\], rolling \[rad/s\]",
    ):
        m.attach("magic_formula", on, **MAGIC)
    with pytest.raises(
        fx.ModelError, match=r"6 names; give 2 deformations, then 5 slips.*: deflection \[m\], camber"
    ):
        m.attach("magic_formula", MAGIC_ON[:-1], **MAGIC)


def test_arguments_of_a_law_are_named() -> None:
    m = wheel()
    on = {"deflection": "tyre.deflection", "camber": "tyre.camber"}
    with pytest.raises(
        fx.ModelError, match=r"law 'linear_tyre': arguments are missing: forward \[m/s\], .*name a quantity"
    ):
        m.attach("linear_tyre", on, stiffness=K)
    with pytest.raises(fx.ModelError, match=r"law 'linear_tyre': unknown argument 'cambre'.*camber\?"):
        m.attach("linear_tyre", on | {"cambre": "tyre.camber"}, stiffness=K)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"law": "linear_tire"}, r"tyre 'A': unknown law 'linear_tire'.*linear_tyre"),
        (
            {"law": "friction", "limit": 1.0, "speed": 1.0},
            r"tyre 'A': law 'friction' acts on e; a tyre has deflection",
        ),
        ({"stiffness": K}, r"tyre 'A': stiffness given without a law; name one"),
        ({"law": "vertical_tyre", "stiffness": K}, r"parameters are missing: damping"),
    ],
)
def test_a_law_that_is_not_that_of_a_tyre_is_refused_and_the_model_is_as_before(
    options: dict[str, Any], message: str
) -> None:
    m = fx.Model()
    m.point("hub", (0, 0, R))
    m.frame("wheel")
    with pytest.raises(fx.ModelError, match=message):
        m.tyre("A", "hub", "wheel", radius=R, axle=(0, 1, 0), **options)
    assert not m.instances and not m.laws
