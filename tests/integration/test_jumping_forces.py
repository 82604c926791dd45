"""Laws whose forces jump: the step across is as short as time is exact."""

import numpy as np

import flexel as fx

RUBBER = {
    "damping": 300.0,
    "load0": 4000.0,
    "rolling_radius": 0.36,
    "friction": (0.73, -0.06),
    "slip_stiffness": 15.18,
    "cornering": (16.75, 2.19),
    "camber_stiffness": 0.43,
    "shape": (1.5, -0.06),
    "trail": (0.03, 6.6),
    "relaxation": (0.44, 0.55),
}


def wheel() -> fx.System:
    """A wheel that leaves the road and comes back to it, where its damping acts at once."""
    m = fx.Model(gravity=(0.0, 0.0, -9.81))
    m.point("hub", (0.15, 0.0, 0.28))
    m.frame("wheel", (0.987814, -0.019759, 0.003087, -0.154349))
    m.body("rim", "hub", "wheel", mass=46.44, inertia=(1.08, 1.19, 1.37))
    m.tyre("tyre", "hub", "wheel", radius=0.35, axle=(0.304815, 0.951572, -0.039989), crown=0.05)
    seen = ("deflection", "camber", "forward", "rolling", "longitudinal", "lateral", "spin")
    start = {"kappa": -0.08, "tan_alpha": -0.11}
    m.attach(
        "magic_formula",
        [f"tyre.{name}" for name in seen],
        name="rubber",
        initial=start,
        stiffness=38000.0,
        **RUBBER,
    )
    return m.build()


def test_a_wheel_comes_back_to_the_road_again_and_again() -> None:
    """In a long motion steps became "too short" there, since the shortest one was a share of the whole time."""
    system = wheel()
    rates = dict(zip(system.dynamic, np.resize([3.87, -1.6, -0.5, 3.54], len(system.dynamic)), strict=True))
    known = {"hub.x": 5.818, "hub.y": -0.325, "hub.z": -0.3}
    rates |= {name: value for name, value in known.items() if name in rates}
    motion = system.simulate(10.0, start=system.state_at(rates=rates))
    assert motion.message.startswith("reached the end")
    assert np.sum(np.diff(np.sign(motion["tyre.deflection"])) != 0) > 4
