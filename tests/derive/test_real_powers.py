"""Products such as x |x|^(1/2) in laws: joined into one power, whose slope at zero is a number."""

import numpy as np
import pytest
import sympy as sp

import flexel as fx
from flexel.derive.clipped import joined

X, Y = sp.symbols("x y", real=True)
HALF = sp.Rational(1, 2)
ODD = sp.sign(X) * abs(X) ** (1 + HALF)


@pytest.mark.parametrize(
    ("product", "wanted"),
    [
        (3 * X * abs(X) ** HALF, 3 * ODD),
        (X**2 * abs(X) ** HALF, abs(X) ** (2 + HALF)),
        (X / sp.sqrt(abs(X)), sp.sign(X) * sp.sqrt(abs(X))),
        ((Y - X) * abs(X - Y) ** HALF, sp.sign(Y - X) * abs(X - Y) ** (1 + HALF)),
        (X * abs(X) ** HALF * Y * abs(Y) ** HALF, ODD * ODD.subs(X, Y)),
        (X * abs(X), X * abs(X)),  # its slope is a number
        (Y * abs(X) ** HALF, Y * abs(X) ** HALF),
    ],
)
def test_products_that_are_joined(product: sp.Expr, wanted: sp.Expr) -> None:
    found = joined(sp.cos(1 + product))
    assert found == sp.cos(1 + wanted)
    for x, y in ((-0.7, 0.3), (0.4, -0.2), (0.9, 0.9)):
        values = {X: x, Y: y}
        assert float(found.subs(values)) == pytest.approx(float(sp.cos(1 + product).subs(values)), rel=1e-14)


@pytest.mark.parametrize("method", ["DOP853", "Radau", "generalized-alpha"])
def test_a_damper_with_an_exponent_of_three_halves_starts_at_rest(method: str) -> None:
    """Its slope at rest was zero times infinity: generalized-alpha and the linearization refused it."""
    m = fx.Model()
    m.point("A", (0, 0))
    m.fix("A.y")
    m.point_mass("mass", "A", 1.0)
    m.spring("A.x", 10.0, damping=lambda rate: 2.0 * rate * abs(rate) ** 0.5)
    m.load("A.x", 1.0)
    system = m.build()
    assert np.allclose(system.linearize(system.at_rest).eigenvalues(), [-np.sqrt(10) * 1j, np.sqrt(10) * 1j])
    motion = system.simulate(2.0, method=method, samples=3)
    exact = system.simulate(2.0, method="DOP853", samples=3, rtol=1e-11)
    assert motion["A.x"][-1] == pytest.approx(exact["A.x"][-1], rel=1e-3)
