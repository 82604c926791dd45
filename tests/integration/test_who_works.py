"""Where the energy balance of a motion fails, the warning names what works most there."""

import pytest

import flexel as fx
from flexel.integration.workers import workers


def driven() -> fx.System:
    """A mass that moves with 2 m/s: a damper takes 6 W, a load gives 10 W; a point is drawn along against a spring."""
    m = fx.Model()
    O, A, B = m.point("O", (0, 0), fixed=True), m.point("A", (1, 0)), m.point("B", (0, 1))
    m.fix("A.y", "B.x")
    m.point_mass("mass", A, 1.0)
    m.spring("A.x", damping=1.5)
    m.initial("A.x", rate=2.0)
    m.load("A.x", 5.0)
    m.truss("band", O, B, stiffness=100.0)
    m.prescribe("B.y", fx.Polynomial([1.0, 0.5]))
    return m.build()


def test_laws_loads_and_drives_are_named_with_their_powers() -> None:
    system = driven()
    assert workers(system.kinematics, system.initial) == "load on 'A.x' (10 W), law 'A.x' (6 W)"
    later = system.simulate(0.4)[-1]  # the band is longer by 0.2 m: 20 N at 0.5 m/s
    assert "drive of 'B.y' (10 W)" in workers(system.kinematics, later)


def test_a_warning_of_the_energy_balance_names_them() -> None:
    """A tolerance that is larger than the motion."""
    m = fx.Model()
    A = m.point("A", (0, 0))
    m.fix("A.y")
    m.point_mass("mass", A, 1.0)
    m.spring("A.x", 900.0, damping=1e-6)
    m.initial("A.x", 1e-9)
    with pytest.warns(fx.AuditWarning, match=r"check what acts there: law 'A\.x' \(.* W\)"):
        m.build().simulate(5.0, method="DOP853", atol=1e-11)
