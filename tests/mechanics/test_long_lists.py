"""Printed forms of systems with many degrees of freedom."""

import flexel as fx


def test_a_system_and_its_check_list_the_first_of_many_degrees_of_freedom() -> None:
    m = fx.Model(gravity=(0, 0, -9.81))
    for i in range(20):
        m.point(f"P{i}", (float(i), 0, 0))
        m.point_mass(f"mass {i}", f"P{i}", 1.0)
    system = m.build()
    assert len(system.dynamic) == 60
    for printed in (repr(system), str(m.check())):
        assert "and 52 more" in printed
        assert "P10" not in printed
