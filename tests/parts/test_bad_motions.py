"""Mistakes in prescribed motions, functions of time and loads."""

import math
from typing import Any

import numpy as np
import pytest
from mistakes import Case, built, check, each, pendulum

from flexel.base.errors import ConstraintError, PositionError
from flexel.base.time_functions import Harmonic, Polynomial, Ramp
from flexel.base.time_tables import Table
from flexel.results.system_facade import System


def _fails(t: Any) -> Any:
    raise ZeroDivisionError("no value")


MOTIONS = {
    "unknown": built(lambda m: m.prescribe("pivot.angel", 1.0), "'pivot.angel'", "did you mean pivot.angle"),
    "None": built(lambda m: m.prescribe("pivot.angle", None), "prescribe 'pivot.angle'", "give one of these"),
    "text": built(
        lambda m: m.prescribe("pivot.angle", "fast"), "prescribe 'pivot.angle'", "give one of these"
    ),
    "NaN": built(lambda m: m.prescribe("pivot.angle", math.nan), "prescribe 'pivot.angle'", "give finite"),
    "node": built(lambda m: m.prescribe("A", 1.0), "'A'", "did you mean A."),
    "node object": built(lambda m: m.prescribe(m.nodes["A"], 1.0), "prescribe", "give text such as 'A.x'"),
    "math.sin": built(
        lambda m: m.prescribe("pivot.angle", lambda t: math.sin(t)), "'pivot.angle'", "np.sin, not math.sin"
    ),
    "np.cbrt": built(
        lambda m: m.prescribe("pivot.angle", lambda t: np.cbrt(t + 1)),
        "'pivot.angle'",
        "cbrt",
        "give the triple",
    ),
    "np.unwrap": built(
        lambda m: m.prescribe("pivot.angle", lambda t: np.unwrap(t)),
        "'pivot.angle'",
        "triple",
    ),
    "function that fails": built(
        lambda m: m.prescribe("pivot.angle", _fails), "prescribe 'pivot.angle'", "no value", "one argument t"
    ),
    "function of nothing": built(
        lambda m: m.prescribe("pivot.angle", lambda: 0), "'pivot.angle'", "one argument t"
    ),
    "function of two": built(
        lambda m: m.prescribe("pivot.angle", lambda t, x: t), "'pivot.angle'", "one argument t"
    ),
    "function without value": built(
        lambda m: m.prescribe("pivot.angle", lambda t: None), "'pivot.angle'", "must return one number"
    ),
    "function with an array": built(
        lambda m: m.prescribe("pivot.angle", lambda t: np.array([t, t])),
        "'pivot.angle'",
        "must return one number",
    ),
    "root of a negative number": built(
        lambda m: m.prescribe("pivot.angle", lambda t: np.sqrt(t - 1)), "'pivot.angle'", "t = 0 s"
    ),
    "pair": built(
        lambda m: m.prescribe("pivot.angle", (lambda t: t, lambda t: 1)), "'pivot.angle'", "(u, u', u'')"
    ),
    "triple of numbers": built(
        lambda m: m.prescribe("pivot.angle", (1, 2, 3)), "'pivot.angle'", "three functions"
    ),
    "triple without values": built(
        lambda m: m.prescribe("pivot.angle", (lambda t: None,) * 3), "'pivot.angle'", "must return one number"
    ),
    "triple with NaN": built(
        lambda m: m.prescribe("pivot.angle", (lambda t: math.nan,) * 3), "'pivot.angle'", "must be finite"
    ),
    "class": built(lambda m: m.prescribe("pivot.angle", Ramp), "'pivot.angle'", "Ramp is a class", "Ramp(…)"),
    "slip": built(
        lambda m: (m.angular_velocity("R1"), m.prescribe("R1.omega.wx", 1)), "'R1.omega.wx' is a slip", "only"
    ),
    "fixed": built(lambda m: m.prescribe("O.x", 1), "'O.x' is fixed", "release the node"),
    "two that depend": built(
        lambda m: (m.prescribe("pivot.angle", 0), m.prescribe("A.z", 0)),
        "over-constrained",
        "'pivot.angle'",
        "release one",
        error=ConstraintError,
    ),
    "unreachable": built(
        lambda m: m.prescribe("A.x", 1.5), "cannot be assembled", "'A.x'", "correct one", error=PositionError
    ),
    "Ramp backwards": Case(lambda: Ramp(1, 0, 0, 1), ("Ramp", "give t0 < t1")),
    "Ramp of text": Case(lambda: Ramp("a", "b", 0, 1), ("Ramp", "t0", "give real")),
    "Ramp of NaN": Case(lambda: Ramp(0, 1, math.nan, 1), ("Ramp", "u0", "give finite")),
    "Harmonic of NaN": Case(lambda: Harmonic(1, math.nan), ("Harmonic", "omega", "give finite")),
    "Harmonic of text": Case(lambda: Harmonic("a", 1), ("Harmonic", "amplitude", "give real")),
    "Polynomial of text": Case(lambda: Polynomial("abc"), ("Polynomial", "give real")),
    "Polynomial of nothing": Case(lambda: Polynomial([]), ("Polynomial", "give")),
    "Polynomial of one number": Case(lambda: Polynomial(3), ("Polynomial", "give a list")),
    "Table too short": Case(lambda: Table([0, 1], [0, 1]), ("Table", "at least four")),
    "Table of one time": Case(lambda: Table([0], [0], "linear"), ("Table", "at least two")),
    "Table of an unknown kind": Case(lambda: Table([0, 1], [0, 1], "steps"), ("Table", "mean step")),
    "Table of two lengths": Case(lambda: Table([0, 1, 2, 3], [0, 1]), ("Table", "one value for each")),
    "Table of vectors": Case(lambda: Table([0, 1, 2, 3], np.zeros((4, 2))), ("Table", "one value for each")),
    "Table of NaN": Case(
        lambda: Table([0, 1, 2, 3], [0, 1, math.nan, 2]), ("Table", "values", "give finite")
    ),
    "Table of another kind": Case(
        lambda: Table([0, 1, 2, 3], [0, 1, 0, 1], kind="spline"), ("Table", "'spline'")
    ),
    "Table of steps": built(
        lambda m: m.prescribe("pivot.angle", Table([0, 1], [0, 1], kind="step")), "'pivot.angle'", "fx.Ramp"
    ),
    "linear Table with a time three times": Case(
        lambda: Table([0, 1, 1, 1], [0, 1, 2, 3], kind="linear"), ("Table", "sort them")
    ),
    "Table not sorted": Case(lambda: Table([0, 2, 1, 3], [0, 1, 2, 2]), ("Table", "sort them")),
    "beyond the Table": Case(
        lambda: _tabled().simulate(5.0), ("Table", "outside 0.0…3.0", "extend the table")
    ),
}


def _tabled() -> System:
    m = pendulum()
    m.prescribe("pivot.angle", Table([0, 1, 2, 3], [0, 1, 2, 3]))
    return m.build()


LOADS = {
    "unknown": built(lambda m: m.load("AA", (1, 2, 3)), "load", "'AA'", "did you mean A"),
    "unknown quantity": built(lambda m: m.load("A.q", 1), "'A.q'", "'A' has A.x, A.y, A.z"),
    "element": built(lambda m: m.load("pivot", 1), "load", "'pivot'", "known: O, A"),
    "None": built(lambda m: m.load(None, 1), "load", "give its name"),
    "two components": built(lambda m: m.load("A", (1, 2)), "load on 'A'", "2 components", "takes 3"),
    "one number": built(lambda m: m.load("A", 1.0), "load on 'A'", "takes a list of 3"),
    "no components": built(lambda m: m.load("A", None), "load on 'A'", "takes a list of 3"),
    "vector function": built(lambda m: m.load("A", lambda t: (0, 0, t)), "load on 'A'", "takes a list of 3"),
    "texts": built(lambda m: m.load("A", ("a", "b", "c")), "load on 'A'", "give one of these"),
    "NaN": built(lambda m: m.load("A", (math.nan, 0, 1)), "load on 'A'", "give finite"),
    "three numbers on an angle": built(
        lambda m: m.load("pivot.angle", (1, 2, 3)), "'pivot.angle'", "functions"
    ),
    "fixed point": built(
        lambda m: m.load("O", (1, 0, 1)), "load on 'O'", "fixed", "remove the load or the fixing"
    ),
    "fixed frame": built(
        lambda m: m.load("R0", (1, 0, 1)), "load on 'R0'", "fixed", "remove the load or the fixing"
    ),
    "fixed coordinate": built(
        lambda m: (m.fix("A.y"), m.release("rod.across1", "pivot.bend1"), m.load("A", (0, 1, 0))),
        "load on 'A.y'",
        "fixed",
        "remove the load or the fixing",
    ),
    "follower on a point": built(
        lambda m: m.load("A", (1, 0, 1), follower=True), "'A'", "no axes", "follower=frame"
    ),
    "follower on an angle": built(
        lambda m: m.load("pivot.angle", 1, follower=True), "'pivot.angle'", "leave follower"
    ),
    "norm": built(lambda m: m.load("R1.norm", 1), "'R1.norm'", "always constrained", "name another"),
    "function that fails": built(
        lambda m: m.load("pivot.angle", _fails), "load on 'pivot.angle'", "no value", "one argument t"
    ),
    "slip not measured": built(
        lambda m: m.load("R1.omega.wx", 1),
        "unknown name 'R1.omega.wx'",
        "declare m.angular_velocity('R1') first",
    ),
    "angular velocity of a point": built(
        lambda m: m.angular_velocity("A"), "angular_velocity", "needs a frame"
    ),
}


@each(MOTIONS)
def test_a_mistake_in_a_prescribed_motion_is_named_with_its_remedy(case: Case) -> None:
    check(case)


@each(LOADS)
def test_a_mistake_in_a_load_is_named_with_its_remedy(case: Case) -> None:
    check(case)


def test_motion_that_leaves_the_reach_says_where() -> None:
    m = pendulum()
    m.prescribe("A.z", lambda t: -t)  # the rod is 1 m long
    with pytest.raises(
        PositionError,
        match=r"position at t = 1(\.\d+)? s cannot be reached.*check prescribed and initial values of 'A\.z'",
    ):
        m.build().simulate(1.5)
