"""Linear laws, and what a declaration may not contain."""

from typing import Any

import pytest
import sympy as sp

from flexel.derive.declare import (
    Deformation,
    Element,
    Frame,
    Law,
    Output,
    Parameter,
    PlanarAngle,
    PlanarPoint,
    Point,
    Slip,
    symbol,
)
from flexel.derive.definition_errors import ElementError
from flexel.derive.emit.printer import _c_name
from flexel.derive.laws.linear_laws import LINEAR


@pytest.mark.parametrize("law", LINEAR, ids=lambda law: law.name)
def test_stored_energy_is_the_potential_of_the_stresses_at_rest(law: Law) -> None:
    at_rest = {rate: 0 for rate in (*law.ed, *law.s)}
    for e, sigma in zip(law.e, law.sigma, strict=True):
        assert sp.expand(sp.diff(law.energy, e) - sigma.subs(at_rest)) == 0


@pytest.mark.parametrize("law", LINEAR, ids=lambda law: law.name)
def test_laws_of_the_table_are_symmetric(law: Law) -> None:
    for outputs, inputs in ((law.sigma, law.e), (law.sigma, law.ed), (law.tau, law.s)):
        jacobian = sp.Matrix(outputs).jacobian(inputs) if outputs else sp.zeros(0)
        assert jacobian == jacobian.T


P, R = Point("p"), Frame("r")
LENGTH = sp.sqrt(P.x.dot(P.x))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"deformations": (Deformation("d", "m", LENGTH - symbol("l0")),)}, "'d' contains l0"),
        ({"deformations": (Deformation("d", "m", P.x),)}, "'d' is not a scalar"),
        ({"deformations": (Deformation("d", "", LENGTH),)}, "'d' has no unit"),
        ({"deformations": (Deformation("d", "m", P.v[0]),)}, "'d' depends on rates"),
        (
            {"deformations": (Deformation("d", "m", LENGTH), Deformation("d", "m", LENGTH))},
            "'d' is used twice",
        ),
        ({"slips": (Slip("s", "m/s", P.v[0] ** 2),)}, "'s' is not linear"),
        ({"slips": (Slip("s", "m/s", P.v[0] + 1),)}, "'s' is not linear"),
        ({"slips": (Slip("s", "m/s", sp.sqrt(P.v[0] ** 2)),)}, "'s' is not linear"),
        ({"kinetic_energy": P.v[0]}, "kinetic energy is not quadratic"),
        ({"potential": P.v[0]}, "potential depends on rates"),
        ({"parameters": (Parameter("p_x", 1, "m", "clash"),)}, "'p_x' is used twice"),
        ({"parameters": (Parameter("double", 1, "m", "word of C"),)}, "'double' is not a valid name"),
        ({"nodes": (P, P)}, "is used twice"),
        ({"nodes": ()}, "has no nodes"),
        ({"let": ((symbol("l"), symbol("k")),)}, "let 'l' contains k"),
    ],
)
def test_a_wrong_declaration_is_refused_by_name(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Element(**({"name": "wrong", "nodes": (P,)} | arguments))


HEIGHT = Deformation("d", "m", LENGTH)


@pytest.mark.parametrize(
    ("outputs", "message"),
    [
        ((Output("speed", "m/s", P.v[0]),), "output 'speed' depends on rates"),
        ((Output("force", "N", R.f[0]),), "output 'force' contains r_fl0: not a coordinate"),
        ((Output("force", "N", symbol("sigma_e")),), "output 'force' contains sigma_e"),
        ((Output("U", "J", P.x[0]),), "output 'U' has a name used in the C code; choose another"),
        ((Output("t7", "J", P.x[0]),), "output 't7' has a name used in the C code"),
        ((Output("a b", "J", P.x[0]),), "'a b' is not a valid name in C"),
        ((Output("d1", "m", P.x), Output("d1", "m", P.x)), "'d1' is used twice"),
        (
            (Output("line", "m", P.x[:2, :], draws="bar"),),
            r"'line' is drawn, but its shape is \(2,\); give a row",
        ),
        (
            (Output("line", "m", P.x, draws="mass", carrier=("origin", "axes")), Output("origin", "m", P.x)),
            r"the carrier \('origin', 'axes'\) of output 'line' is not a frame; name two outputs, its origin \(3",
        ),
        ((P.x,), "(?s)outputs holds .* give a tuple of Output"),
    ],
)
def test_a_wrong_output_is_refused_by_name(outputs: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Element("wrong", (P,), deformations=(HEIGHT,), doc="height", outputs=outputs)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("f", "", P.x), "output 'f' has no unit"),
        (("f", "N", P.x, "bar"), "output 'f' is drawn, but is in N; points are in m"),
        (("f", "m", P.x, "", ("origin", "axes")), "output 'f' has a carrier, but is not drawn"),
        (("f", "m", P.x, "photo"), "output 'f': draws 'photo' is unknown; choose one of '', 'bar'"),
    ],
)
def test_a_wrong_output_names_itself(arguments: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Output(*arguments)


def test_a_family_with_other_nodes_than_its_own_is_refused() -> None:
    message = (
        r"element 'wrong': the family 'truss' has the nodes \(point, point\) or \(planar_point, planar_point\), "
        r"not \(point\); omit the family, or give its nodes"
    )
    with pytest.raises(ValueError, match=message):
        Element("wrong", (P,), deformations=(HEIGHT,), doc="height", family="truss")
    Element("right", (P, Point("q")), deformations=(HEIGHT,), doc="height", family="truss")


def test_the_name_of_the_time_is_no_name_of_a_parameter() -> None:
    x, xd = symbol("x"), symbol("xd")
    with pytest.raises(ValueError, match="the name 't' is reserved for the time; rename"):
        Law("wrong", "doc", (Parameter("t", 1, "m", "thickness"),), (x,), (xd,), (), (symbol("t") * x,), ())


def test_a_parameter_needs_a_unit() -> None:
    with pytest.raises(ValueError, match="no unit"):
        Parameter("k", 1, "", "stiffness")


def test_a_law_gives_a_stress_for_each_deformation() -> None:
    e, ed = symbol("e"), symbol("ed")
    with pytest.raises(ValueError, match="a stress for each deformation"):
        Law(name="wrong", doc="", parameters=(), e=(e,), ed=(ed,), s=(), sigma=(), tau=())


def test_coordinates_have_readable_names() -> None:
    assert [s.name for s in Point("p").x] == ["p_x", "p_y", "p_z"]
    assert [s.name for s in Frame("r").v] == ["r_vl0", "r_vl1", "r_vl2", "r_vl3"]
    assert [s.name for s in PlanarPoint("p").v] == ["p_vx", "p_vy"]
    assert [s.name for s in PlanarAngle("r").x] == ["r_angle"]


@pytest.mark.parametrize("name", ["x y", "a.b", "e'", "e[0]", "", "in", "1a"])
def test_names_of_deformations_are_names_in_c(name: str) -> None:
    """They ended in pages of messages of the compiler."""
    p, q = PlanarPoint("p"), PlanarPoint("q")
    with pytest.raises(ElementError, match="is not a valid name"):
        Element(
            "one", (p, q), (), deformations=(Deformation(name, "m", p.x[0] - q.x[0]),), doc="x", source="own"
        )


def test_names_that_begin_like_functions_of_the_generated_code() -> None:
    """They hung the generation of code."""
    used: set[str] = set()
    assert [_c_name("real_length", used) for _ in range(2)] == ["its_real_length", "its_real_length_"]


def test_the_atan_of_a_quotient_jumps_where_its_divisor_is_zero() -> None:
    """Like atan2, whose jumps are found; one with a constant divisor does not jump."""
    p, q, k = PlanarPoint("p"), PlanarPoint("q"), Parameter("k", 1, "m", "length")
    d = q.x - p.x

    def angle(expr: sp.Expr, **period: int) -> Element:
        turns = (Deformation("angle", "rad", expr, free=True, **period),)
        return Element("one", (p, q), (k,), deformations=turns, doc="x", source="own")

    with pytest.raises(ElementError, match=r"'angle' jumps where the divisor in atan.* is zero; write atan2"):
        angle(sp.atan(d[1] / d[0]))
    assert angle(sp.atan(d[1] / k.symbol)).name == angle(sp.atan(d[1] / d[0]), period=0).name == "one"
