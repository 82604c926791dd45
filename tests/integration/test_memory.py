"""Memory of long motions: an implicit one keeps some of its points, an explicit one its steps, and nothing else."""

import sys

import pytest
from memory import memory_in_use

import flexel as fx

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="asks glibc")
STEP, DURATION = 1e-3, 10.0  # [s]
SLACK = 0.1  # MB, of caches that grow a little
PER_STEP = 4e-3  # MB that a step of DOP853 may keep for dense output
PER_IMPLICIT = 1e-4  # MB that one of generalized-alpha may: 8 bytes, and a point every 32 steps


def pendulum() -> fx.System:
    m = fx.Model(gravity=(0, -9.81))
    last = m.point("O", (0, 0), fixed=True)
    for i in range(2):
        end = m.point(f"P{i}", (0.5 * (i + 1), 0.0))
        m.beam(f"b{i}", last, m.angle(f"R{i}"), end, mass_per_length=1.0)
        last = end
    return m.build()


def test_an_implicit_motion_keeps_a_point_of_many_steps() -> None:
    system = pendulum()
    system.simulate(0.1, method="generalized-alpha", step=STEP, samples=2)
    before = memory_in_use()
    motion = system.simulate(DURATION, method="generalized-alpha", step=STEP, samples=2)
    assert motion.statistics["steps"] == pytest.approx(DURATION / STEP)
    assert memory_in_use() < before + SLACK + PER_IMPLICIT * motion.statistics["steps"]


@pytest.mark.long
def test_an_explicit_motion_keeps_its_steps_and_nothing_else() -> None:
    """They are kept for `Motion.at`; another motion uses the same memory again."""
    system = pendulum()
    found = [memory_in_use()]
    for _ in range(4):
        motion = system.simulate(DURATION, method="DOP853", max_step=STEP, samples=2)
        steps = motion.statistics["steps"]
        found.append(memory_in_use())
        del motion
    assert steps >= DURATION / STEP
    assert found[1] < found[0] + SLACK + PER_STEP * steps
    assert found[-1] < found[1] + SLACK
