"""The universal joint: closed forms of kinematics, moments and linearization; flexible pins; instability."""

from typing import Any

import numpy as np
import pytest
from system_rows import not_reproduced, rows_of

from flexel.examples import cardan as example
from flexel.examples.published import published
from flexel.linear import periodic


@pytest.fixture(scope="module")
def benchmark() -> dict[str, Any]:
    return published("hooke_joint")


@pytest.mark.long
def test_every_quantity_is_within_its_tolerance() -> None:
    assert not_reproduced("cardan") == {}
    assert {"ratio_max_error", "flexible_limit_order"} <= set(rows_of("cardan"))


def test_the_closed_form_is_that_of_the_textbooks(benchmark: dict[str, Any]) -> None:
    for row in benchmark["table_beta30_convA"]:
        angle = np.radians(row["theta1_deg"])
        out, ratio, second = example.closed_form(np.array(angle), example.B30)
        assert (np.degrees(out), ratio) == pytest.approx((row["theta2_deg"], row["ratio"]), abs=1e-13)
        assert second == pytest.approx(row["theta2dd_over_w1sq"], abs=1e-14)


def test_the_rigid_joint_has_one_dof_and_no_redundant_constraint() -> None:
    m = example.joint(0.7)
    example.rotor(m, "driving", 1.0)
    system = m.build()
    assert system.counts["degrees_of_freedom"] == 1
    assert sum(instance.spec.name == "hinge" for instance in system.structure.instances) == 4


def test_reactions_do_no_work_on_the_steadily_driven_joint() -> None:
    """The driving power equals that on the driven shaft at every angle."""
    turn = example.driven(np.radians(45), 3.0).simulate(2 * np.pi, samples=73, progress=False)
    power = turn.force("in.angle") * turn.rate("in.angle") + 3.0 * turn.rate("out.angle")
    assert np.max(np.abs(power)) < 1e-12


def test_the_free_run_keeps_its_energy() -> None:
    motion = example.free_run(np.radians(50))
    E = motion.energy["total"]
    assert np.max(np.abs(E / E[0] - 1)) < 1e-10


def test_small_angles_excite_twice_the_speed_with_a_quarter_of_the_angle_squared() -> None:
    """θ2 = θ1 + (b²/4) sin 2θ1: the resonance of the elastic shaft lies at half its frequency."""
    b = 0.02
    turn = example.driven(b).simulate(2 * np.pi, samples=65, progress=False)
    pairs = periodic.cosine_sine((turn["out.angle"] - turn.t)[:-1], 4)
    assert pairs[2, 1] == pytest.approx(b**2 / 4, rel=1e-3)

    def twist(speed: float) -> float:
        nominal = periodic.orbit(example.elastic_shaft(b, speed, 1.0), 2 * np.pi / speed, 24)
        return float(np.abs(nominal.coefficients.harmonic_balance(4).X[6, 0]) * 2)

    for speed in (0.3, 0.45, 0.7):
        ratio = (2 * speed) ** 2 / (1 - (2 * speed) ** 2)
        assert twist(speed) == pytest.approx(abs(b**2 / 4 * ratio), rel=5e-3)


def test_the_first_zone_of_the_elastic_shaft_opens_with_the_angle_squared() -> None:
    widths = []
    for b in (0.1, 0.2):
        equations = example.family(lambda w, b=b: example.elastic_shaft(b, w, 1.0), 32)  # type: ignore[misc]
        low, high = example.zone_edges(equations.at, 1.0 + b**2 / 4, 0.1)
        widths.append(high - low)
    assert widths[0] == pytest.approx(0.1**2 / 2, rel=0.02)
    assert np.log2(widths[1] / widths[0]) == pytest.approx(2, abs=0.03)


def test_damping_closes_the_zone() -> None:
    def at(damping: float) -> float:
        system = example.elastic_shaft(example.B30, 1.0, 1.0, damping)
        return example.growth(periodic.orbit(system, 2 * np.pi, 48).coefficients)

    assert at(0.0) > 0.1
    assert at(0.3) < 0
