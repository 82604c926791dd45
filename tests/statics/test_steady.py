"""Steady motions whose forces are small beside what rounding of the coordinates does in stiff parts."""

import pytest

import flexel as fx


def blade(n: int, EA: float, speed: float) -> fx.System:  # noqa: N803
    """A blade of one metre and one kilogram that turns about its root at a speed [rad/s]."""
    m = fx.Model()
    point, frame = m.point("O", (0, 0, 0), fixed=True), m.frame("hub")
    m.hinge("shaft", m.frame("ground", fixed=True), frame, axis=(0, 0, 1))
    for i in range(n):
        ends = point, frame, m.point(f"P{i}", ((i + 1) / n, 0, 0)), m.frame(f"R{i}")
        stiffness = {"EA": EA, "EIy": 2e-5 * EA, "EIz": 1e-5 * EA, "GJ": 1e-5 * EA}
        m.beam(f"B{i}", *ends, **stiffness, mass_per_length=1.0)
        m.rotary_inertia(f"J{i}", ends[3], (1e-3, 1e-3, 1e-3))
        point, frame = ends[2:]
    m.prescribe("shaft.angle", fx.Polynomial([0.0, speed]))
    return m.build()


@pytest.mark.parametrize("speed", [0.01, 0.1, 1.0, 10.0, 100.0])
@pytest.mark.parametrize("EA", [1e7, 1e9, 1e11])
def test_a_stiff_blade_turns_as_slowly_as_one_likes(EA: float, speed: float) -> None:  # noqa: N803
    """Closed form ω² ρ L³ / (3 EA); of these, 11 were "no steady motion found"."""
    n = 6
    found = blade(n, EA, speed).steady()["P5.x"] - 1.0
    grown = speed**2 / (3 * EA)
    assert found == pytest.approx(grown, rel=0.06 / n**2 + 3 * grown, abs=4e-16)


def test_a_search_that_fails_at_rest_names_the_one_that_looks_further() -> None:
    m = fx.Model(gravity=(0, -9.81))
    ends = [m.point("O", (0, 0), fixed=True), *(m.point(f"P{i}", (i + 1, 0.3 * i)) for i in range(8))]
    for i, (one, other) in enumerate(zip(ends, ends[1:], strict=False)):
        m.truss(f"t{i}", one, other, mass_per_length=1.0)
    s = m.build()
    with pytest.raises(
        fx.PositionError, match=r"P5\.y = .* and 2 more\); .*system\.equilibrium\(\) finds a state of rest"
    ):
        s.steady()
    assert s.equilibrium()["P7.x"] == pytest.approx(0.0, abs=1e-9)
