"""Gears, racks and belts between joints: ratios and senses from the drawing, over many turns."""

import numpy as np
import pytest

import flexel as fx


def shafts(
    first: tuple[float, ...], second: tuple[float, ...], at: tuple[float, ...], axes: tuple[object, object]
) -> fx.Model:
    """Two bodies on pins at places of the ground; the first is turned at 2 rad/s over many turns."""
    m = fx.Model()
    for name, place, axis in (("p", first, axes[0]), ("q", second, axes[1])):
        m.rigid_body(name, place, mass=1.0, inertia=(0.2, 0.2, 0.2) if len(place) == 3 else 0.2)
        m.revolute(f"pin_{name}", "ground", name, at=place, axis=axis)
    m.prescribe("pin_p.angle", lambda t: 2 * t)
    return m


def turned(m: fx.Model) -> float:
    """Turn of the second gear for a unit turn of the first, after three turns."""
    end = m.build().simulate(3 * np.pi)[-1]
    return float(end["pin_q.angle"] / end["pin_p.angle"])


X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


def test_spur_gears_turn_against_each_other_and_internal_ones_together() -> None:
    for first, second, at in (((0, 0), (0.3, 0), (0.1, 0)), ((0, 0, 0), (0.3, 0, 0), (0.1, 0, 0.02))):
        m = shafts(first, second, at, (Z, Z) if len(at) == 3 else (None, None))
        m.gear("mesh", "pin_p", "pin_q", at=at, teeth=(20, 40))
        assert turned(m) == pytest.approx(-0.5, rel=1e-12)
    m = shafts((0, 0), (0.2, 0), (-0.1, 0), (None, None))
    m.gear("mesh", "pin_p", "pin_q", at=(-0.1, 0))
    assert turned(m) == pytest.approx(1 / 3, rel=1e-12)


def test_axes_drawn_the_other_way_turn_the_sense() -> None:
    m = shafts((0, 0, 0), (0.3, 0, 0), (0.1, 0, 0), (Z, (0, 0, -1)))
    m.gear("mesh", "pin_p", "pin_q", at=(0.1, 0, 0))
    assert turned(m) == pytest.approx(0.5, rel=1e-12)


def test_bevel_gears_turn_in_the_ratio_of_their_radii() -> None:
    """Axes that meet at right angles at the origin; at the pitch point both have the velocity of the other."""
    m = shafts((-1, 0, 0), (0, -1, 0), (0, 0, 0), (X, Y))
    m.gear("mesh", "pin_p", "pin_q", at=(-0.2, -0.1, 0), teeth=(10, 20))
    assert turned(m) == pytest.approx(-0.5, rel=1e-12)


@pytest.mark.parametrize(("lead", "sense"), [(0.05, 1.0), (-0.05, -1.0)])
def test_a_worm_advances_its_wheel_by_the_lead(lead: float, sense: float) -> None:
    """A right-handed worm along x below a wheel of radius 0.2 about y: its thread pushes the teeth backwards."""
    m = shafts((0, 0, 0), (0, 0, 0.23), (0, 0, 0), (X, Y))
    m.gear("worm", "pin_p", "pin_q", at=(0, 0, 0.03), lead=lead)
    # the lowest point of the wheel moves by -lead/2π per radian; turning about y moves it along -x
    assert turned(m) == pytest.approx(sense * 0.05 / (2 * np.pi) / 0.2, rel=1e-12)


def test_the_wheel_of_a_worm_carries_its_load() -> None:
    m = shafts((0, 0, 0), (0, 0, 0.23), (0, 0, 0), (X, Y))
    m.gear("worm", "pin_p", "pin_q", at=(0, 0, 0.03), teeth=(1, 40), lead=2 * np.pi * 0.2 / 40)
    m.load("pin_q.angle", 8.0)
    assert m.build().initial.force("pin_p.angle") == pytest.approx(8.0 / 40, rel=1e-10)  # balances the load


def test_a_planetary_gear_follows_willis() -> None:
    """Sun, planet and ring relative to the carrier; with the ring held, carrier : sun = 1 : 1 + ring/sun."""
    m = fx.Model()
    for name, place in (("carrier", (0, 0)), ("sun", (0, 0)), ("planet", (0.3, 0)), ("ring", (0, 0))):
        m.rigid_body(name, place, mass=1.0, inertia=0.1)
    m.revolute("carrier_pin", "ground", "carrier", at=(0, 0))
    for name, place in (("sun", (0, 0)), ("planet", (0.3, 0)), ("ring", (0, 0))):
        m.revolute(f"{name}_pin", "carrier", name, at=place)
    m.gear("inner", "sun_pin", "planet_pin", at=(0.2, 0), teeth=(40, 20))
    m.gear("outer", "planet_pin", "ring_pin", at=(0.4, 0), teeth=(20, 80))
    m.fix("ring_frame")
    m.prescribe("sun_frame.angle", lambda t: 3 * t)
    end = m.build().simulate(10.0)[-1]
    assert end["carrier_frame.angle"] == pytest.approx(30 / (1 + 80 / 40), rel=1e-11)
    assert end["planet_pin.angle"] == pytest.approx(-(30 - 10) * 2, rel=1e-11)


@pytest.mark.parametrize("planar", [True, False])
def test_a_rack_moves_with_the_rim_of_its_pinion(planar: bool) -> None:
    m = fx.Model(gravity=(0, 0) if planar else (0, 0, 0))
    places = [(0.0, 0.0), (0.0, -0.1), (1.0, 0.0)] if planar else [(0.0, 0.0, 0.0), (0.0, -0.1, 0.0), X]
    m.rigid_body("pinion", places[0], mass=1.0, inertia=0.02 if planar else (0.02, 0.02, 0.02))
    m.rigid_body("rack", places[1], mass=3.0, inertia=0.1 if planar else (0.1, 0.1, 0.1))
    m.revolute("shaft", "ground", "pinion", at=places[0], axis=None if planar else Z)
    m.prismatic("guide", "ground", "rack", axis=places[2])
    m.rack_and_pinion("teeth", "shaft", "guide", at=places[1])
    m.load("shaft.angle", 5.0)
    s = m.build()
    assert s.counts["degrees_of_freedom"] == 1
    end = s.simulate(3.0)[-1]
    assert end["shaft.angle"] == pytest.approx(0.5 * 5.0 / (0.02 + 3.0 * 0.1**2) * 9, rel=1e-10)
    assert end["guide.along" if planar else "guide.axial"] == pytest.approx(
        0.1 * end["shaft.angle"], rel=1e-11
    )


@pytest.mark.parametrize("crossed", [False, True])
def test_a_belt_turns_in_the_ratio_of_the_radii(crossed: bool) -> None:
    for axis, sense in ((Z, 1.0), ((0, 0, -1), -1.0)):
        m = shafts((0, 0, 0), (1, 0.5, 0.2), (0, 0, 0), (Z, axis))
        m.belt("belt", "pin_p", "pin_q", radius_p=0.1, radius_q=0.25, crossed=crossed)
        assert turned(m) == pytest.approx(sense * (-0.4 if crossed else 0.4), rel=1e-12)


def test_gears_that_do_not_fit_are_refused_by_name() -> None:
    def refused(words: str, **given: object) -> None:
        m = shafts((0, 0, 0), (0.3, 0, 0), (0, 0, 0), (Z, Z))
        m.rigid_body("r", (0, 1, 0), mass=1.0, inertia=(1, 1, 1))
        m.revolute("other", "p", "r", at=(0, 1, 0), axis=Z)
        m.revolute("across", "ground", "r", at=(0, 1, 0), axis=Y)
        arguments: dict[str, object] = {"p": "pin_p", "q": "pin_q", "at": (0.1, 0, 0)}
        with pytest.raises(fx.ModelError, match=f"gear 'mesh': .*{words}"):
            m.gear("mesh", **(arguments | given))  # type: ignore[arg-type]
        assert "mesh" not in m.instances

    refused("20 and 30 teeth give the ratio", teeth=(20, 30))
    refused("touch on an axis", at=(0.3, 0, 5))
    refused("both its joints are 'pin_p'", q="pin_p")
    refused("'pin_p' starts at 'ground_frame' and 'other' at 'p_frame'", q="other")
    refused("is not a joint with an axis; name one made by m.revolute", q="p")
    refused("is not a joint with an axis; did you mean pin_q", q="pinq")
    refused("cross at 'at'", q="across")
    refused("do not drive", lead=0.0)


def test_racks_belts_and_chains_that_do_not_fit_are_refused_by_name() -> None:
    m = shafts((0, 0, 0), (0.3, 0, 0), (0, 0, 0), (Z, X))
    m.rigid_body("r", (0, -0.1, 0), mass=1.0, inertia=(1, 1, 1))
    m.prismatic("guide", "ground", "r", axis=Y)
    with pytest.raises(fx.ModelError, match="rack and pinion 'z': the pinion does not move along the rack"):
        m.rack_and_pinion("z", "pin_p", "guide", at=(0, -0.1, 0))
    with pytest.raises(fx.ModelError, match="belt 'z': the axes of 'pin_p' and 'pin_q' are not parallel"):
        m.belt("z", "pin_p", "pin_q", radius_p=1.0, radius_q=1.0)
    with pytest.raises(fx.ModelError, match="cardan chain 'a', 'b', 'c': two successive axes are parallel"):
        m.cardan_chain("a", "b", "c", body="r", axes="zzx")
