"""Mistakes in what is fixed, released, rigid, independent, and in initial values."""

import math

from mistakes import Case, built, check, drawing, each, pendulum

from flexel.base.errors import ConstraintError, ModelError, PositionError
from flexel.parts.model import Model

ROLES = {
    "fix unknown": built(lambda m: m.fix("Q"), "fix", "'Q'", "known: O, A"),
    "fix unknown coordinate": built(lambda m: m.fix("A.q"), "fix", "'A'", "'q'", "it has x, y, z"),
    "fix None": built(lambda m: m.fix(None), "fix", "give its name"),
    "fix an element": built(lambda m: m.fix("pivot"), "fix", "'pivot' is an element", "m.rigid"),
    "fix a deformation": built(lambda m: m.fix("pivot.angle"), "fix", "'pivot' is an element", "m.rigid"),
    "fix a node of another model": built(
        lambda m: m.fix(Model().point("A", (5, 5, 5))), "fix", "'A'", "another model"
    ),
    "fix too much": built(
        lambda m: m.fix("A"), "over-constrained", "'rod.along'", "release 2 of them", error=ConstraintError
    ),
    "release unknown": built(lambda m: m.release("pivot.bend"), "'pivot.bend'", "did you mean pivot.bend"),
    "release a coordinate": built(lambda m: m.release("A.x"), "'A.x' is a coordinate", "use fix"),
    "release an element": built(lambda m: m.release("pivot"), "'pivot'", "did you mean pivot."),
    "release None": built(lambda m: m.release(None), "release", "give text such as"),
    "release a list": built(lambda m: m.release(["pivot.bend1"]), "release", "separate arguments"),
    "release a norm": built(
        lambda m: m.release("R1.norm"), "'R1.norm'", "always constrained", "name another"
    ),
    "rigid unknown": built(lambda m: m.rigid("pivot.agnle"), "'pivot.agnle'", "did you mean pivot.angle"),
    "rigid coordinate": built(lambda m: m.rigid("A.x"), "'A.x' is a coordinate", "use fix"),
    "rigid with a spring": built(
        lambda m: (m.spring("pivot.angle", 3.0), m.rigid("pivot.angle")), "'pivot.angle'", "law", "remove one"
    ),
    "rigid and prescribed": built(
        lambda m: (m.prescribe("pivot.angle", 1.0), m.rigid("pivot.angle")), "'pivot.angle'", "remove one"
    ),
    "hinge between a frame and itself": Case(
        lambda: _self_hinged().build(), ("hinge 'h'", "both its frames are 'R0'", "two bodies"), ModelError
    ),
    "independent unknown": built(
        lambda m: m.independent("pivot.agnle"), "'pivot.agnle'", "did you mean pivot.angle"
    ),
    "independent twice": built(
        lambda m: m.independent("pivot.angle", "pivot.angle"), "'pivot.angle'", "named twice", "once"
    ),
    "independent None": built(lambda m: m.independent(None), "independent", "give text such as"),
    "independent list": built(lambda m: m.independent(["pivot.angle"]), "independent", "separate arguments"),
    "independent node": built(
        lambda m: m.independent(m.nodes["A"]), "independent", "give text such as 'A.x'"
    ),
    "independent element": built(lambda m: m.independent("pivot"), "'pivot'", "did you mean pivot."),
    "independent norm": built(lambda m: m.independent("R1.norm"), "'R1.norm'", "name another"),
    "independent and fixed": built(
        lambda m: m.independent("O.y"), "'O.y' is fixed", "name movable coordinates"
    ),
    "independent slip": built(
        lambda m: (m.angular_velocity("R1"), m.independent("R1.omega.wy")), "'R1.omega.wy' is a slip", "name"
    ),
    "independent and prescribed": built(
        lambda m: (m.prescribe("pivot.angle", 1), m.independent("pivot.angle")), "'pivot.angle'", "choose one"
    ),
    "independent and kinematic": built(
        lambda m: (m.kinematic("pivot.angle"), m.independent("pivot.angle")), "'pivot.angle'", "choose one"
    ),
    "too many degrees of freedom": built(
        lambda m: m.independent("pivot.angle", "A.z"),
        "2 dynamic",
        "has 1",
        "remove 1 of",
        error=ConstraintError,
    ),
    "a degree of freedom that does not move": built(
        lambda m: m.independent("A.x"), "'A.x' cannot be", "for example 'pivot.angle'", error=ConstraintError
    ),
    "kinematic without need": built(
        lambda m: m.kinematic("A.z"), "1 kinematic", "has 0", "remove 1 of 'A.z'", error=ConstraintError
    ),
    "kinematic unknown": built(
        lambda m: m.kinematic("pivot.agnle"), "'pivot.agnle'", "did you mean pivot.angle"
    ),
    "empty model": Case(lambda: Model().build(), ("no nodes", "add points and frames")),
    "build at no time": Case(lambda: pendulum().build(t=None), ("time t", "give real numbers")),
    "build at NaN": Case(lambda: pendulum().build(t=math.nan), ("time t", "give finite numbers")),
}


def _self_hinged() -> Model:
    m = drawing()
    m.hinge("h", "R0", "R0", axis=(0, 0, 1))
    return m


INITIAL = {
    "unknown": built(lambda m: m.initial("pivot.agle", 1), "'pivot.agle'", "did you mean pivot.angle"),
    "nothing": built(lambda m: m.initial("pivot.angle"), "initial 'pivot.angle'", "give one of them"),
    "text": built(lambda m: m.initial("pivot.angle", "a"), "initial 'pivot.angle'", "give real"),
    "NaN": built(lambda m: m.initial("pivot.angle", rate=math.nan), "initial 'pivot.angle'", "give finite"),
    "rigid": built(lambda m: m.initial("pivot.bend1", 0.1), "'pivot.bend1'", "rigid", "remove the initial"),
    "fixed": built(lambda m: m.initial("O.x", 0.1), "'O.x'", "fixed", "remove the initial"),
    "prescribed": built(
        lambda m: (m.prescribe("pivot.angle", 1), m.initial("pivot.angle", 1)),
        "'pivot.angle'",
        "remove the initial",
    ),
    "rate of a fixed coordinate": built(
        lambda m: m.initial("O.x", rate=0.1), "'O.x'", "fixed", "remove the initial"
    ),
    "rate of a rigid deformation": built(
        lambda m: m.initial("pivot.bend1", rate=1.0), "'pivot.bend1'", "rigid", "remove the initial"
    ),
    "two rates that contradict": built(
        lambda m: (m.initial("pivot.angle", rate=1), m.initial("A.z", rate=1)),
        "inconsistent",
        "'pivot.angle'",
        "at most 1",
        error=PositionError,
    ),
    "impossible rate": built(
        lambda m: m.initial("A.y", rate=1), "inconsistent", "'A.y'", "give at most 1", error=PositionError
    ),
    "unreachable": built(
        lambda m: m.initial("A.x", 1.5), "'rod.along'", "'A.x'", "correct one", error=PositionError
    ),
    "two values that contradict": built(
        lambda m: (m.initial("A.x", 0.5), m.initial("pivot.angle", 0.0)),
        "cannot be assembled",
        "'A.x'",
        "correct one",
        error=PositionError,
    ),
}


@each(ROLES)
def test_a_mistake_in_a_role_is_named_with_its_remedy(case: Case) -> None:
    check(case)


@each(INITIAL)
def test_a_mistake_in_an_initial_value_is_named_with_its_remedy(case: Case) -> None:
    check(case)
