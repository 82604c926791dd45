"""Laws and formulas on coordinates act on the displacement from where these are drawn, as springs do."""

import pytest

import flexel as fx
from flexel.derive import Internal, Law, Parameter, symbol

pytestmark = pytest.mark.usefixtures("cache")


def creeping() -> Law:
    """A spring and a damper in series."""
    e, ed, z = symbol("e"), symbol("ed"), symbol("z")
    k, lag = Parameter("k", 1, "N/m", "stiffness"), Parameter("lag", 1, "s", "time of relaxation")
    return Law(
        "creeping",
        "sigma = k (e - z), z' = (e - z)/lag",
        parameters=(k, lag),
        e=(e,),
        ed=(ed,),
        s=(),
        sigma=(k.symbol * (e - z),),
        tau=(),
        energy=k.symbol * (e - z) ** 2 / 2,
        source="Maxwell",
        states=(Internal("z", "m", (e - z) / lag.symbol),),
    )


def foot() -> fx.Model:
    m = fx.Model(gravity=(0, -9.81))
    m.point("foot", (0.3, 0.1))
    m.fix("foot.x")
    m.point_mass("mass", "foot", 2.0)
    return m


def lifted(m: fx.Model) -> fx.State:
    """One centimetre above the drawn place, at rest."""
    system = m.build()
    (name,) = system.dynamic
    return system.state_at({name: system.unaccelerated[name] + 0.01})


def test_a_formula_on_a_coordinate_is_the_spring() -> None:
    by_formula, by_spring = foot(), foot()
    by_formula.law("foot.y", lambda e, ed: 500 * e + 3 * ed)
    by_spring.spring("foot.y", 500.0, damping=3.0)
    systems = [m.build() for m in (by_formula, by_spring)]
    found, reference = (system.linearize(system.equilibrium()) for system in systems)
    assert found.eigenvalues() == pytest.approx(reference.eigenvalues(), rel=1e-12)
    assert lifted(by_formula).acceleration("foot.y") == pytest.approx(-9.81 - 500 * 0.01 / 2, rel=1e-12)


def test_the_states_of_a_compiled_law_are_named_by_the_coordinate() -> None:
    m = foot()
    m.law("foot.y", fx.compile_law(creeping()), k=500.0, lag=0.1)
    state = lifted(m)
    assert state["foot.y.z"] == 0.0
    assert state.acceleration("foot.y") == pytest.approx(-9.81 - 500 * 0.01 / 2, rel=1e-12)


def test_a_coordinate_that_is_fixed_or_an_euler_parameter_is_refused() -> None:
    m = foot()
    m.frame("turn")
    with pytest.raises(fx.ModelError, match="'foot.x' is fixed"):
        m.law("foot.x", lambda e: 500 * e)
    with pytest.raises(fx.ModelError, match="Euler parameters such as 'turn.lambda1'"):
        m.law("turn.lambda1", lambda e: 500 * e)
