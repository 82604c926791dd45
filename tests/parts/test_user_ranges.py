"""A user's element declares the range in which it is valid, and every analysis warns beyond it."""

import numpy as np
import pytest
from sympy import Matrix, sqrt

import flexel as fx
from flexel.derive import Deformation, Element, Let, Output, Parameter, PlanarPoint, ValidRange
from flexel.derive.definition_errors import ElementError

pytestmark = pytest.mark.usefixtures("cache")
BEYOND = "is stretched to {value:.2f} of its length{where}, {digits} % beyond its data; use {count} in a row"


def band(beyond: str = BEYOND, limit: float = 1.5, values: int = 2) -> Element:
    """A band whose data end at one and a half of its length."""
    p, q, l0 = PlanarPoint("p"), PlanarPoint("q"), Parameter("l0", 1, "m", "length", sign="positive")
    d = q.x - p.x
    length = sqrt(d.dot(d))
    stretch = length / l0.symbol
    measured = Matrix([stretch, 100 * (stretch / 1.5 - 1)][:values])
    return Element(
        "band",
        (p, q),
        (l0,),
        Let().entries,
        (Deformation("elongation", "m", length - l0.symbol, free=True),),
        doc="e = |q - p| - l0",
        source="own",
        outputs=(
            ValidRange("stretch", "1", measured, limit=limit, beyond=beyond),
            Output("length", "m", length),
        ),
    )


def test_every_analysis_warns_beyond_the_range() -> None:
    element = fx.compile_element(band())
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    for i in range(1, 4):
        m.point(f"P{i}", (i, 0))
        m.fix(f"P{i}.y")
        m.element(f"band{i}", element, f"P{i - 1}" if i > 1 else "O", f"P{i}", l0=1.0)
        m.spring(f"band{i}.elongation", 100.0 * i)
        m.point_mass(f"mass{i}", f"P{i}", 1.0)
    m.load("P3.x", fx.Ramp(0, 1, 0, 140.0))
    system = m.build()
    told = r"'band1' is stretched to 2\.40 of its length{}, 60 % beyond its data; use 2 in a row"
    with pytest.warns(fx.RangeWarning, match=told.format(r" \(1 more by more than 1\.5\)")):
        rest = system.equilibrium(t=1.0)
    assert rest.outputs("band1")["stretch"] == pytest.approx([2.4, 60.0])
    for name, analysis in {
        "linearize": lambda: system.linearize(rest),
        "vibrations": lambda: system.vibrations(rest),
        "static_path": lambda: system.static_path(t_end=1.0),
    }.items():
        with pytest.warns(fx.RangeWarning, match=f"^{name}: 'band1' is stretched to"):
            analysis()
    with pytest.warns(fx.RangeWarning, match="^simulate: 'band"):
        motion = system.simulate(2.0, samples=21, progress=False)
    reached = max(np.ptp(motion[f"band{i}.elongation"]) for i in range(1, 4)) + 1
    assert f"elements at {100 * reached / 1.5:.3g} % of their ranges at most" in motion.verdict


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"values": 1}, r"range 'stretch' has values of shape \(1,\); give two, a measure and an error"),
        (
            {"limit": 0.0},
            "range 'stretch': limit 0.0 is not positive; give the largest measure that is valid",
        ),
        (
            {"beyond": "{angle}{where}"},
            "has other fields than value, error, digits, where and count: 'angle'",
        ),
        ({"beyond": "is stretched"}, "does not say where; put {where} in it"),
    ],
)
def test_a_wrong_range_names_itself(wrong: dict[str, object], words: str) -> None:
    with pytest.raises(ElementError, match=words):
        band(**wrong)  # type: ignore[arg-type]
