"""Masses that meet thin bars, at random: no step passes a bar, however long it is."""

import warnings

import numpy as np
import pytest

import flexel as fx

LIMITS = {("DOP853", 1e-9): 1e-6, ("DOP853", 1e-3): 0.1, ("Radau", 1e-9): 1e-6, ("Radau", 1e-3): 0.1}


def bar(m: fx.Model, rng: np.random.Generator, at: tuple[float, float], energy: float) -> None:
    """A bar of 1 to 20 mm that touches the point "ball", and is stiff enough for three times this energy [J]."""
    radius = 10 ** rng.uniform(-3.3, -2.0)
    exponent = float(rng.choice([1.0, 1.5]))
    stiffness = 3 * energy * (exponent + 1) / (2 * radius) ** (exponent + 1)
    m.point("axle", at, fixed=True)
    m.angle("R", fixed=True)
    m.sheave("bar", "axle", "R", radius=radius)
    m.contact(
        "touch",
        "ball",
        "bar",
        fx.Contact(stiffness, exponent=exponent, dissipation=float(rng.choice([0.0, 0.2])), per="point"),
        radius=radius,
    )


def guided(rng: np.random.Generator) -> fx.Model:
    """A mass on a vertical guide, thrown at the bar, perhaps on a spring."""
    height, speed, k = (
        rng.uniform(0.3, 6.0),
        rng.uniform(-20.0, 5.0),
        rng.choice([0.0, 10 ** rng.uniform(-1, 2)]),
    )
    m = fx.Model(gravity=(0, -rng.choice([0.0, 9.81])))
    m.point("ball", (0, height))
    m.fix("ball.x")
    m.point_mass("mass", "ball", 1.0)
    if k:
        m.point("above", (0, height + 40.0), fixed=True)
        m.truss("spring", "above", "ball", stiffness=k)
    bar(m, rng, (0, 0), speed**2 / 2 + 9.81 * height + k * height**2 / 2)
    m.initial("ball.y", rate=speed)
    return m


def swinging(rng: np.random.Generator) -> fx.Model:
    """A pendulum whose bob meets the bar near its lowest point."""
    length, start, place = rng.uniform(0.3, 2.0), rng.uniform(0.3, 2.5), rng.uniform(-0.2, 0.2)
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point("ball", (length * np.sin(start), -length * np.cos(start)))
    m.truss("rod", "O", "ball")
    m.point_mass("mass", "ball", 1.0)
    bar(m, rng, (length * np.sin(place), -length * np.cos(place)), 2 * 9.81 * length)
    return m


@pytest.mark.parametrize(
    "seed", [*range(12), *(pytest.param(i, marks=pytest.mark.long) for i in range(12, 100))]
)
def test_no_step_passes_a_bar(seed: int) -> None:
    """Against steps of 2 ms, of which none is as long as a mass stays within the width of the bar."""
    rng = np.random.default_rng(seed)
    system = (guided, swinging)[seed % 2](rng).build()
    duration = rng.uniform(0.3, 2.0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        fine = system.simulate(duration, method="DOP853", rtol=1e-10, max_step=2e-3, samples=21)
        for (method, rtol), limit in LIMITS.items():
            motion = system.simulate(duration, method=method, rtol=rtol, samples=21)
            assert np.abs(motion.x - fine.x).max() < limit * np.ptp(fine.x, axis=0).max(), (method, rtol)
