"""Invalid requests for states, the choice of degrees of freedom, and steady motion."""

import math

import pytest
from mistakes import Case, check, each, pendulum, system

import flexel as fx
from flexel.base.errors import ConstraintError, PositionError

STATES = {
    "value of an unknown": system(lambda s: s.state_at({"q": 1}), "state_at", "'q'", "known: "),
    "value of no degree of freedom": system(
        lambda s: s.state_at({"A.x": 1}), "'A.x' is not a degree of freedom", "'pivot.angle'"
    ),
    "value as text": system(lambda s: s.state_at({"pivot.angle": "a"}), "'pivot.angle'", "give real"),
    "value None": system(lambda s: s.state_at({"pivot.angle": None}), "'pivot.angle'", "give real"),
    "value NaN": system(lambda s: s.state_at({"pivot.angle": math.nan}), "'pivot.angle'", "give finite"),
    "values as a list": system(lambda s: s.state_at([1.0]), "state_at", "by name"),
    "rate None": system(lambda s: s.state_at(rates={"pivot.angle": None}), "'pivot.angle'", "give real"),
    "rate unknown": system(lambda s: s.state_at(rates={"pit": 1}), "'pit'", "did you mean"),
    "rate of a fixed coordinate": system(
        lambda s: s.state_at(rates={"O.x": 1}), "'O.x' cannot be 1", "give at most", error=PositionError
    ),
    "at no time": system(lambda s: s.state_at(t=math.nan), "state_at", "time t", "give finite"),
    "state of another model": system(
        lambda s: s.state_at(start=pendulum().build().initial), "state_at", "another model", "of this one"
    ),
    "steady of an unknown": system(lambda s: s.steady(unknown=["q"]), "'q'", "name one of them"),
    "steady rate unknown": system(lambda s: s.steady(unknown_rates=["q"]), "'q'", "name one of them"),
    "steady of another model": system(
        lambda s: s.steady(pendulum().build().initial), "another model", "of this one"
    ),
    "degrees of freedom unknown": system(
        lambda s: s.use_coordinates(["q"]), "use_coordinates", "'q'", "known: "
    ),
    "degrees of freedom as text": system(
        lambda s: s.use_coordinates("pivot.angle"), "use_coordinates", "write ['…'"
    ),
    "degree of freedom fixed": system(
        lambda s: s.use_coordinates(["O.x"]), "'O.x' is fixed", "name movable coordinates"
    ),
    "degree of freedom rigid": system(
        lambda s: s.use_coordinates(["rod.along"]),
        "'rod.along' is constrained",
        "name others",
        error=ConstraintError,
    ),
    "state of an unknown": system(
        lambda s: s.initial["pivot.agle"], "'pivot.agle'", "did you mean pivot.angle"
    ),
    "rate of an unknown": system(
        lambda s: s.initial.rate("pivot.agle"), "'pivot.agle'", "did you mean pivot.angle"
    ),
    "position of an element": system(lambda s: s.initial.position("rod"), "'rod'", "known: O, A"),
    "motion of an unknown": system(
        lambda s: s.simulate(0.01, samples=2)["pivot.agle"], "'pivot.agle'", "did you mean pivot.angle"
    ),
    "motion after its end": system(lambda s: s.simulate(0.01, samples=2).at(5), "5 s", "0…0.01"),
    "motion at NaN": system(lambda s: s.simulate(0.01, samples=2).at(math.nan), "nan", "finite"),
}


@each(STATES)
def test_a_mistake_in_a_state_is_named_with_its_remedy(case: Case) -> None:
    check(case)


def test_a_prescribed_motion_that_begins_where_points_coincide_is_named() -> None:
    """A band whose free end is drawn at 1 m, and prescribed to start at its fixed end: it has no direction there."""
    m = fx.Model()
    O, A, B = m.point("O", (0, 0), fixed=True), m.point("A", (1, 0)), m.point("B", (0, 1))
    m.fix("A.y", "B.x")
    m.point_mass("mass", A, 1.0)
    m.truss("band", O, B, stiffness=10.0)
    m.prescribe("B.y", fx.Polynomial([0.0, 0.5]))
    with pytest.raises(
        fx.ConstraintError, match=r"'band\.elongation' cannot be differentiated in this position"
    ):
        m.build()
