"""Invalid requests to a linearization."""

from mistakes import Case, check, double, each, linear, pendulum, system

from flexel.base.errors import LinearizationError
from flexel.results.linearization import Linearization

LINEARIZATIONS = {
    "linearize another model": system(
        lambda s: s.linearize(pendulum().build().initial), "linearize", "another model", "of this one"
    ),
    "linearize a motion": system(
        lambda s: s.linearize(s.simulate(0.01, samples=2)), "linearize", "motion[-1]"
    ),
    "reduced to an unknown": linear(lambda lin: lin.reduced(["q"]), "'q'", "name some of"),
    "reduced to nothing": linear(lambda lin: lin.reduced([]), "reduced", "name one"),
    "reduced twice": linear(lambda lin: lin.reduced(["elbow.angle"] * 2), "reduced", "each once"),
    "reduced but coupled": linear(
        lambda lin: lin.reduced(["elbow.angle"]),
        "'elbow.angle'",
        "'pivot.angle' enters through",
        "include it",
    ),
    "input fixed": linear(lambda lin: lin.state_space(["O.x"], ["A.x"]), "'O.x'", "fixed", "drop it"),
    "output without value": Case(
        lambda: _measured().state_space([], ["R1.omega.wy"]),
        ("'R1.omega.wy'", "use its rate"),
        LinearizationError,
    ),
    "input unknown": Case(lambda: double().state_space(["q"], []), ("'q'", "known: ")),
    "output unknown": Case(
        lambda: double().state_space([], ["farce:A.x"]), ("'farce:A.x'", "did you mean force:A.x")
    ),
    "inputs as text": Case(lambda: double().state_space("A.x", []), ("inputs", "write ['…'")),
    "reduced to a text": Case(lambda: double().reduced("elbow.angle"), ("reduced", "write ['…'")),
}


def _measured() -> Linearization:
    m = pendulum()
    m.angular_velocity("R1")
    return m.build().linearize()


@each(LINEARIZATIONS)
def test_a_mistake_in_a_linearization_is_named_with_its_remedy(case: Case) -> None:
    check(case)
