"""Motions that move no mass and that nothing resists: every method names them, and none stands still."""

from collections.abc import Callable
from typing import Any

import pytest

import flexel as fx

METHODS = ["auto", "generalized-alpha", "DOP853", "Radau"]


def loose_angle(m: fx.Model) -> None:
    m.point("A", (0, 0))
    m.point_mass("k", "A", 1.0)
    m.angle("loose")


def loose_point(m: fx.Model) -> None:
    pendulum(m, "O", "A", 1.0)
    m.point("loose", (2, 2))


def forgotten_mass(m: fx.Model) -> None:
    pendulum(m, "O", "A", 1.0)
    pendulum(m, "A", "loose", 0.0)


def smooth_sheave(m: fx.Model) -> None:
    m.point("centre", (0, 0), fixed=True)
    m.angle("ground", fixed=True)
    m.angle("loose")
    m.hinge("axle", "ground", "loose")
    m.sheave("sheave", "centre", "loose", radius=0.099)
    for name, x, mass in (("A", -0.1, 3.0), ("B", 0.1, 2.0)):
        m.point(name, (x, -0.5))
        m.point_mass(f"weight {name}", name, mass)
    data = {"radius": 1e-3, "EA": 1e5, "EI": 1e-5, "mass_per_length": 0.1, "damping": 1e-3}
    m.rope("rope", ["A", "sheave", "B"], 27, contact=fx.Contact(1e9, dissipation=10.0), tension=25.0, **data)


def pendulum(m: fx.Model, p: str, q: str, mass: float) -> None:
    x = len(m.nodes)
    if p not in m.nodes:
        m.point(p, (x, 0), fixed=True)
    m.point(q, (x + 1.0, 0))
    m.truss(f"rod to {q}", p, q)
    m.rigid(f"rod to {q}.elongation")
    if mass:
        m.point_mass(f"bob {q}", q, mass)


MODELS: dict[str, Callable[[fx.Model], None]] = {
    make.__name__: make for make in (loose_angle, loose_point, forgotten_mass, smooth_sheave)
}


@pytest.mark.filterwarnings("ignore::flexel.ModelWarning")
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", MODELS)
def test_an_undetermined_motion_is_an_error_that_names_it(name: str, method: str) -> None:
    m = fx.Model(gravity=(0, -9.81))
    MODELS[name](m)
    options: dict[str, Any] = (
        {} if name != "smooth_sheave" or method != "generalized-alpha" else {"step": 2e-3}
    )
    with pytest.raises(fx.DynamicsError, match=r"'loose\..*moves no mass"):
        m.build().simulate(0.1, method=method, **options)


def test_a_part_without_mass_that_a_damper_resists_moves() -> None:
    """Closed form: 1 N m on a damper of 2 N m s turns it by 0.5 rad/s."""
    m = fx.Model()
    m.angle("ground", fixed=True)
    m.angle("plate")
    m.hinge("hinge", "ground", "plate")
    m.spring("hinge.angle", stiffness=0.0, damping=2.0)
    m.load("hinge.angle", 1.0)
    assert m.build().simulate(1)["hinge.angle"][-1] == pytest.approx(0.5, rel=1e-5)


def test_build_warns_of_a_node_without_an_element() -> None:
    m = fx.Model()
    loose_angle(m)
    with pytest.warns(fx.ModelWarning, match="'loose' belongs to no element"):
        m.build()


@pytest.mark.filterwarnings("ignore::flexel.ModelWarning")
def test_vibrations_name_a_motion_with_neither_mass_nor_stiffness() -> None:
    m = fx.Model(gravity=(0, -9.81))
    loose_point(m)
    s = m.build()
    with pytest.raises(fx.DynamicsError, match=r"'loose\..*neither mass nor stiffness"):
        s.vibrations(s.equilibrium())
