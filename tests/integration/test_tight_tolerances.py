"""Mechanisms and particles whose motions are published, at tolerances near rounding, and motions that grow."""

from itertools import combinations
from typing import Any

import numpy as np
import pytest

import flexel as fx

TIGHT: dict[str, Any] = {"rtol": 1e-12, "atol": 1e-13, "samples": 2}

# Hairer, Nørsett and Wanner (1993), II.10: seven stars; values at t = 3 of the problem PLEI in the IVP Test Set.
STARS = np.array([(3, 3), (3, -3), (-1, 2), (-3, 0), (2, 0), (-2, -4), (2, 4)], dtype=float)
SPEEDS = np.array([(0, 0), (0, 0), (0, 0), (0, -1.25), (0, 1), (1.75, 0), (-1.5, 0)])
ENDS = np.array(
    [
        (0.3706139143970502, -3.943437585517392),
        (3.237284092057233, -3.271380973972550),
        (-3.222559032418324, 5.225081843456543),
        (0.6597091455775310, -2.590612434977470),
        (0.3425581707156584, 1.198213693392275),
        (1.562172101400631, -0.2429682344935824),
        (-0.7003092922212495, 1.091449240428980),
    ]
)


@pytest.mark.parametrize("method", ["DOP853", "Radau"])
def test_pleiades_end_where_they_are_published_to_end(method: str) -> None:
    """The law acts on the distances, of which eleven are chosen as degrees of freedom."""
    m = fx.Model(gravity=(0, 0))
    for i, (place, speed) in enumerate(zip(STARS, SPEEDS, strict=True)):
        m.point_mass(f"star {i}", m.point(f"P{i}", tuple(place)), i + 1.0)
        m.initial(f"P{i}.x", rate=speed[0])
        m.initial(f"P{i}.y", rate=speed[1])
    for i, j in combinations(range(7), 2):
        distance, product = float(np.linalg.norm(STARS[i] - STARS[j])), (i + 1.0) * (j + 1.0)
        m.truss(f"{i}-{j}", f"P{i}", f"P{j}")
        m.law(f"{i}-{j}.elongation", lambda e, ed, l=distance, k=product: k / (l + e) ** 2)
    end = m.build().simulate(3.0, method=method, **TIGHT)[-1]
    assert np.array([end.position(f"P{i}") for i in range(7)]) == pytest.approx(ENDS, abs=2e-9)


CORNERS = [(0, 0, 0), (1, 0, 0), (1, -1, 0), (1, -1, 1), (0, -1, 1), (0, 0, 1)]
AXES = [(0, 1, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 0)]


def bricard() -> fx.System:
    """Five rods of 1 m and 1 kg and the ground, joined by six hinges; IFToMM benchmark library, problem A04."""
    m = fx.Model(gravity=(0, -9.81, 0))
    last = m.frame("ground", fixed=True)
    for i, corner in enumerate(CORNERS):
        m.point(f"P{i}", corner, fixed=i in (0, 5))
    for i in range(5):
        along = np.subtract(CORNERS[i + 1], CORNERS[i])
        turning = m.frame(f"R{i}")
        m.hinge(f"h{i}", last, turning, axis=AXES[i])
        m.body_point(f"rod {i}", f"P{i}", turning, f"P{i + 1}")
        moments = np.where(along == 0, 1 / 12, 1e-9)
        m.body(f"bar {i}", f"P{i}", turning, mass=1.0, inertia=tuple(moments), offset=tuple(along / 2))
        last = turning
    m.hinge("h5", last, "ground", axis=AXES[5])
    m.release(*m.constraint_report().release)
    return m.build()


def test_bricards_mechanism_keeps_its_energy_for_ten_seconds() -> None:
    """It passes a nearly flat position in each swing; two methods agree (own)."""
    system, ends = bricard(), []
    for method in ("DOP853", "Radau"):
        motion = system.simulate(10.0, method=method, **TIGHT)
        assert np.ptp(motion.energy["total"]) < 2e-10
        ends.append(motion[-1].position("P3"))
    assert ends[0] == pytest.approx(ends[1], abs=1e-10)


@pytest.mark.parametrize("method", ["DOP853", "Radau", "auto"])
def test_positions_are_found_relative_to_what_they_have_become(method: str) -> None:
    """A vibration of 225 Hz grows by exp(20) in 4 s, from 1e-7 m to tens of metres; its envelope is a closed form."""
    m = fx.Model(gravity=(0, 0))
    m.point_mass("mass", m.point("P", (0, 0)), 1.0)
    m.fix("P.y")
    m.law("P.x", lambda e, ed: 2e6 * e - 10 * ed)
    omega = np.sqrt(2e6 - 25)
    m.initial("P.x", rate=1e-7 * omega)
    end = m.build().simulate(4.0, method=method, samples=2, rtol=1e-6)[-1]
    size = np.hypot(end["P.x"], (end.rate("P.x") - 5 * end["P.x"]) / omega)
    assert size == pytest.approx(1e-7 * np.exp(20.0), rel=0.05)
