"""Skate (knife edge): the point of its blade on the ice moves along the blade only."""

from sympy import Matrix

from flexel.derive.declare import (
    Deformation,
    Element,
    Frame,
    Let,
    Output,
    Parameter,
    PlanarAngle,
    PlanarPoint,
    Point,
    Slip,
)
from flexel.derive.declare.rotation import combination, cross, dot, norm, triad
from flexel.derive.elements.picture_outputs import FRAME_DOC, frame
from flexel.derive.elements.planar_beam import ALPHA0
from flexel.derive.elements.triads import named_directions
from flexel.derive.elements.wheel import HEIGHT, NORMAL

BLADE = Parameter("blade", 3, "1", "unit vector along the blade in body axes", ("x", "y", "z"))


def _slips(ahead: Matrix, across: Matrix, v: Matrix) -> tuple[Slip, ...]:
    return Slip("forward", "m/s", dot(ahead, v), free=True), Slip("lateral", "m/s", dot(across, v))


def _skate() -> Element:
    p, r = Point("p"), Frame("r")
    n, let = NORMAL.vector, Let()
    axes = triad(r.x)
    b = let.vector("b", combination(axes, BLADE.vector))
    side = let.vector("side", cross(n, b))
    ey = let.vector("ey", side / let.scalar("side_length", norm(side)))
    return Element(
        name="skate",
        picture="blade",
        nodes=(p, r),
        parameters=(BLADE, NORMAL, HEIGHT),
        let=let.entries,
        deformations=(Deformation("surface", "m", dot(n, p.x) - HEIGHT.symbol),),
        slips=_slips(cross(ey, n), ey, p.v),
        doc=(
            "b = R(lambda) blade, n = normal, ey = (n x b)/|n x b|, ex = ey x n\n"
            "surface = n.x - height,  forward = ex.v,  lateral = ey.v\n"
            "ahead: b" + FRAME_DOC.format(origin="x", axes="columns of R(lambda)")
        ),
        source="Chaplygin 1911, sleigh; Neimark and Fufaev 1972, Dynamics of Nonholonomic Systems",
        outputs=(Output("ahead", "1", b), *frame(p.x, *axes)),
    )


def _planar_skate() -> Element:
    p, r = PlanarPoint("p"), PlanarAngle("r")
    let = Let()
    ex, ey = named_directions(let, r, ALPHA0, "r")
    return Element(
        name="planar_skate",
        picture="blade",
        nodes=(p, r),
        parameters=(ALPHA0,),
        let=let.entries,
        slips=_slips(ex, ey, p.v),
        doc=(
            "ex, ey: direction of the blade (angle + alpha0) and its normal;  forward = ex.v,  lateral = ey.v\n"
            "ahead: ex" + FRAME_DOC.format(origin="x", axes="ex, ey")
        ),
        source="Chaplygin 1911, sleigh; Neimark and Fufaev 1972, Dynamics of Nonholonomic Systems",
        outputs=(Output("ahead", "1", ex), *frame(p.x, ex, ey)),
    )


SKATE = _skate()
PLANAR_SKATE = _planar_skate()
