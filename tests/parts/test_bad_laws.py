"""Mistakes in springs, laws and formulas."""

import math
from typing import Any

import numpy as np
import pytest
import sympy
from mistakes import Case, built, check, each, pendulum

from flexel.base.errors import CompilerError
from flexel.parts.curves import Curve

LAWS = {
    "spring unknown": built(lambda m: m.spring("pivot.a", 1), "'pivot.a'", "did you mean pivot.angle"),
    "spring on an element": built(lambda m: m.spring("pivot", 1), "'pivot'", "did you mean pivot."),
    "spring on Euler parameters": built(
        lambda m: m.spring("R1.lambda1", 1), "'R1.lambda1'", "measure an angle"
    ),
    "spring on a fixed coordinate": built(
        lambda m: m.spring("O.x", 1), "'O.x' is fixed", "remove the spring"
    ),
    "spring to itself": built(lambda m: m.spring(("A.x", "A.x"), 1), "'A.x'", "name another one"),
    "spring to nothing": built(lambda m: m.spring(("A.x", "pivot.a"), 1), "'pivot.a'", "did you mean"),
    "spring on a norm": built(lambda m: m.spring("R1.norm", 1), "'R1.norm'", "name another"),
    "spring on a slip": built(
        lambda m: (m.angular_velocity("R1"), m.spring("R1.omega.wx", 1)),
        "spring on 'R1.omega.wx': a slip",
        "no stiffness",
        "give damping alone",
    ),
    "free length on a slip": built(
        lambda m: (m.angular_velocity("R1"), m.spring("R1.omega.wx", damping=1, free_length=1)),
        "spring on 'R1.omega.wx': a slip",
        "no free_length",
    ),
    "slip and deformation": built(
        lambda m: (m.angular_velocity("R1"), m.spring(["R1.omega.wx", "pivot.angle"], damping=np.eye(2))),
        "spring on 'R1.omega.wx', 'pivot.angle'",
        "'R1.omega.wx' is a slip",
        "a separate damper",
    ),
    "curve on a slip": built(
        lambda m: (m.angular_velocity("R1"), m.spring("R1.omega.wx", damping=Curve([[0, 1]]))),
        "spring on 'R1.omega.wx'",
        "takes a number or matrix",
    ),
    "four slips": built(
        lambda m: (
            m.wheel("w", "O", "R1", m.point("W", (0, 0, -1)), radius=1, axle=(0, 1, 0)),
            m.angular_velocity("R1"),
            m.spring(
                ["w.longitudinal", "w.lateral", "w.spin", "R1.omega.wx"],
                damping=np.eye(4),
            ),
        ),
        "4 slips; name 1 to 3",
    ),
    "damper on a slip that comes later": built(
        lambda m: (m.spring("R1.omega.wx", damping=1), m.angular_velocity("R1")),
        "spring on 'R1.omega.wx': unknown name 'R1.omega.wx'",
        "declare m.angular_velocity('R1') first, which makes the slips R1.omega.wx",
    ),
    "spring of nothing": built(
        lambda m: m.spring("pivot.angle"), "spring on 'pivot.angle'", "give one of them"
    ),
    "spring by number": built(lambda m: m.spring(3, 1), "spring: 3 is not the name", "give one, a pair"),
    "spring by nothing": built(lambda m: m.spring([], np.eye(0)), "spring: [] is not the name", "give one"),
    "spring between three": built(
        lambda m: m.spring(("A.x", "A.y", "A.z"), 1),
        "spring between 'A.x' and 'A.y' and 'A.z'",
        "3 are given",
        "a list and matrices",
    ),
    "free length and preload": built(
        lambda m: m.spring("pivot.angle", 1, free_length=0.1, preload=2),
        "spring on 'pivot.angle': free_length and preload are both given",
        "drop one",
    ),
    "free length of a damper": built(
        lambda m: m.spring("pivot.angle", damping=1, free_length=0.1),
        "spring on 'pivot.angle': free_length without a stiffness",
        "drop it",
    ),
    "negative free length": built(
        lambda m: (m.truss("t", "O", "A"), m.spring("t.elongation", 1, free_length=-0.1)),
        "spring on 't.elongation'",
        "free_length -0.1",
        "zero or a positive",
    ),
    "preload of a curve": built(
        lambda m: m.spring("pivot.angle", Curve([[0, 1]]), preload=1),
        "spring on 'pivot.angle'",
        "contains its preload",
        "add it there",
    ),
    "curve between two": built(
        lambda m: m.spring(("A.x", "A.y"), Curve([[0, 1]])),
        "spring between 'A.x' and 'A.y'",
        "one deformation",
    ),
    "formula of two": built(
        lambda m: m.spring(["A.x", "A.y"], lambda e: e),
        "spring on 'A.x', 'A.y'",
        "one deformation",
        "fx.compile",
    ),
    "damper with a force at rest": built(
        lambda m: m.spring("pivot.angle", damping=Curve([[4, 1]])),
        "spring on 'pivot.angle': damping gives 4 at rest",
    ),
    "spring text": built(lambda m: m.spring("pivot.angle", "stiff"), "spring on 'pivot.angle'", "give real"),
    "matrix of one": built(lambda m: m.spring("pivot.angle", np.eye(2)), "stiffness", "give one number"),
    "numbers for a list": built(
        lambda m: m.spring(["A.x", "A.y"], 3.0),
        "spring on 'A.x', 'A.y'",
        "stiffness has shape ()",
        "give (2, 2)",
    ),
    "spring None": built(lambda m: m.spring("pivot.angle", None), "'pivot.angle'", "give one of them"),
    "spring negative": built(
        lambda m: m.spring("pivot.angle", -1), "'pivot.angle'", "stiffness", "zero or a positive"
    ),
    "spring preload NaN": built(
        lambda m: m.spring("pivot.angle", 1, preload=math.nan), "preload", "give finite"
    ),
    "spring preload text": built(lambda m: m.spring("pivot.angle", 1, preload="x"), "preload", "give real"),
    "viscous on a deformation": built(
        lambda m: m.attach("viscous_1", ["pivot.angle"], C=1.0),
        "'pivot.angle' is not a slip",
        "m.spring(…, damping=…)",
    ),
    "viscous negative": built(
        lambda m: (m.angular_velocity("R1"), m.spring("R1.omega.wx", damping=-1)),
        "spring on 'R1.omega.wx'",
        "damping",
        "zero or",
    ),
    "linear law on seven": built(
        lambda m: m.spring([f"d.{i}" for i in range(7)], np.eye(7)),
        "7 deformations",
        "name 1 to 6",
        "springs that share deformations add up",
    ),
    "linear law twice on one": built(
        lambda m: m.spring(["pivot.angle"] * 2, np.eye(2)), "'pivot.angle'", "each once"
    ),
    "linear law of wrong shape": built(
        lambda m: m.spring(["pivot.angle", "pivot.bend1"], np.eye(3)),
        "stiffness",
        "(3, 3)",
        "give (2, 2)",
    ),
    "linear law not symmetric": built(
        lambda m: m.spring(["pivot.angle", "pivot.bend1"], [[1, 2], [3, 4]]),
        "not symmetric",
        "make it symmetric",
    ),
    "linear law indefinite": built(
        lambda m: m.spring(["pivot.angle", "pivot.bend1"], [[1, 2], [2, 1]]),
        "negative eigenvalue",
        "correct it",
    ),
    "linear law with two preloads": built(
        lambda m: m.spring(["pivot.angle"], [[1]], preload=[1, 2]), "preload", "give 1 numbers"
    ),
    "formula with a parameter": built(
        lambda m: m.law("pivot.angle", lambda e: e, k=3.0),
        "law on 'pivot.angle': a formula takes no k",
        "insert the numbers",
    ),
    "formula with an initial value": built(
        lambda m: m.law("pivot.angle", lambda e: e, initial={"z": 1.0}), "takes no initial", "insert"
    ),
    "formula on two": built(
        lambda m: m.law(["A.x", "A.y"], lambda e: e), "law on 'A.x', 'A.y'", "2 are named", "fx.compile_law"
    ),
    "built-in law by m.law": built(
        lambda m: m.law("pivot.angle", "stop"), "law on 'pivot.angle': 'stop' is text", "m.attach('stop', …)"
    ),
    "attached on one of two": built(
        lambda m: m.attach("linear_2", ["pivot.angle"], preload=0, S=1, D=0),
        "law 'linear_2' on 'pivot.angle'",
        "1 names; give 2 deformations",
    ),
    "attached with too few numbers": built(
        lambda m: m.attach("linear_2", ["pivot.angle", "pivot.bend1"], preload=[0, 0], S=1, D=[0, 0, 0]),
        "law 'linear_2'",
        "parameter S has 1 numbers; it needs 3",
    ),
    "law in a list": built(lambda m: m.attach([], ["pivot.angle"]), "unknown law '[]'", "known: "),
    "law in a mapping": built(lambda m: m.attach({}, ["pivot.angle"]), "unknown law '{}'", "known: "),
    "attached stop that pulls": built(
        lambda m: m.attach("stop", ["pivot.angle"], gap=0.1, stiffness=-1, damping=0),
        "law 'stop' on 'pivot.angle'",
        "stiffness -1",
        "give zero or",
    ),
    "attached contact of exponent 1/2": built(
        lambda m: m.attach("hertz", ["pivot.angle"], stiffness=1, exponent=0.5, dissipation=0),
        "law 'hertz' on 'pivot.angle'",
        "exponent 0.5",
        "give 1",
    ),
    "attached linear law that pushes": built(
        lambda m: m.attach("linear_1", ["pivot.angle"], preload=0, S=-1, D=0),
        "law 'linear_1' on 'pivot.angle'",
        "negative eigenvalue",
        "m.law",
    ),
    "formula with math.sin": built(
        lambda m: m.law("pivot.angle", lambda e, ed: math.sin(e)), "'pivot.angle'", "sympy.sin"
    ),
    "formula with np.sin": built(
        lambda m: m.law("pivot.angle", lambda e, ed: np.sin(e)), "'pivot.angle'", "sympy.sin"
    ),
    "formula with a branch": built(
        lambda m: m.law("pivot.angle", lambda e, ed: e if e > 0 else 0), "'pivot.angle'", "sympy.Piecewise"
    ),
    "formula with a symbol": built(
        lambda m: m.law("pivot.angle", lambda e, ed: sympy.Symbol("k") * e),
        "'pivot.angle'",
        "e*k",
        "insert the numbers",
    ),
    "formula with an open case": built(
        lambda m: m.law("pivot.angle", lambda e, ed: sympy.Piecewise((1e5 * e, e > 0))),
        "'pivot.angle'",
        "no value on one side of e = 0",
        "condition True",
    ),
    "formula that jumps": built(
        lambda m: m.law("pivot.angle", lambda e, ed: sympy.Piecewise((0, e < 0.1), (100, True))),
        "'pivot.angle'",
        "jumps at e = 0.1",
        "make the pieces join",
    ),
    "formula with a step": built(
        lambda m: m.law("pivot.angle", lambda e, ed: 1e4 * sympy.Heaviside(e)), "jumps at e = 0", "smooth"
    ),
    "formula of dry friction": built(
        lambda m: m.law("pivot.angle", lambda e, ed: 5 * sympy.sign(ed), energy=lambda e: 0 * e),
        "'pivot.angle'",
        "jumps at ed = 0",
        "tanh(ed/v)",
    ),
    "formula None": built(
        lambda m: m.law("pivot.angle", lambda e, ed: None), "'pivot.angle'", "insert the numbers"
    ),
    "formula as text": built(lambda m: m.law("pivot.angle", lambda e, ed: "3**"), "'pivot.angle'", "failed"),
    "no formula": built(lambda m: m.law("pivot.angle", 3.0), "'pivot.angle'", "write lambda e, ed"),
    "formula infinite": built(
        lambda m: m.law("pivot.angle", lambda e, ed: e / sympy.Integer(0)),
        "'pivot.angle'",
        "correct the formula",
    ),
    "formula complex": built(
        lambda m: m.law("pivot.angle", lambda e, ed: e * sympy.I), "'pivot.angle'", "not real", "correct"
    ),
    "range of something else": built(
        lambda m: m.law("pivot.angle", lambda e: e, ranges={"phi": (0, 1)}),
        "law on 'pivot.angle': ranges of 'phi'",
        "give ranges={'e'",
    ),
    "range that decreases": built(
        lambda m: m.spring("pivot.angle", lambda e: e, ranges={"e": (1, 0)}),
        "spring on 'pivot.angle': the range (1, 0) of 'e'",
        "give increasing",
    ),
    "range with a free value": built(
        lambda m: m.spring("pivot.angle", lambda e: e, free_length=0.1, ranges={"e": 3}),
        "spring on 'pivot.angle': range of e",
        "give 2 numbers",
    ),
    "ranges of a number": built(
        lambda m: m.spring("pivot.angle", 3.0, ranges={"e": (0, 1)}),
        "spring on 'pivot.angle': ranges belong to a formula",
        "drop them",
    ),
    "energy of a curve": built(
        lambda m: m.spring("pivot.angle", Curve([[0, 1]]), energy=lambda e: e),
        "spring on 'pivot.angle': energy belongs to a formula",
        "drop it",
    ),
    "energy infinite": built(lambda m: m.law("pivot.angle", lambda e, ed: 1 / e), "'pivot.angle'", "energy="),
    "energy of another law": built(
        lambda m: m.law("pivot.angle", lambda e, ed: e, energy=lambda e: e**3),
        "'pivot.angle'",
        "the derivative of the energy e**3",
        "correct one",
    ),
    "energy not callable": built(
        lambda m: m.law("pivot.angle", lambda e, ed: e, energy=3), "'pivot.angle'", "write lambda e"
    ),
    "unknown function": built(
        lambda m: m.law("pivot.angle", lambda e, ed: sympy.gamma(e), energy=lambda e: sympy.loggamma(e)),
        "'pivot.angle'",
    ),
    "formula on unknown": built(
        lambda m: m.spring(["pivot.agle"], [[1.0]]), "'pivot.agle'", "did you mean pivot.angle"
    ),
}


@each(LAWS)
def test_a_mistake_in_a_law_is_named_with_its_remedy(case: Case) -> None:
    check(case)


def test_missing_compiler_is_named_and_matters_for_formulas_only(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Any
) -> None:
    monkeypatch.setenv("CC", "/nowhere/cc")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    m = pendulum()
    m.spring("pivot.angle", 2.0)
    m.build().simulate(0.01, samples=2)
    with pytest.raises(
        CompilerError, match=r"law on 'rod.along': no C compiler '/nowhere/cc'.*apt install gcc"
    ):
        m.law("rod.along", lambda e, ed: 3 * e + e**3)
