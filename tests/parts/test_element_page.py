"""`fx.page(…).evaluate`: deformations of one element with their first and second derivatives, named."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from own_elements import own_bar

import flexel as fx
from flexel.derive import Element, Law, Parameter, symbol
from flexel.derive.verify import definitions
from flexel.derive.verify.kernel_calls import Compiled, generated_elements
from flexel.derive.verify.samples import element_samples

pytestmark = pytest.mark.usefixtures("cache")


def sample(name: str) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """A random place of an element, and values of its parameters, as `flexel verify` draws them."""
    spec, address = generated_elements()[name]
    element = definitions()[name]
    assert isinstance(element, Element)
    data = element_samples(element, Compiled(spec, address), 2)
    ends = np.cumsum([parameter.size for parameter in spec.parameters])[:-1]
    parts = np.split(data["p"][0], ends)
    return data["x"][0], {p.name: part for p, part in zip(spec.parameters, parts, strict=True)}


def test_a_bar_in_the_plane() -> None:
    page = fx.page("planar_truss")
    at = page.evaluate({"p": (0, 0), "q": (3, 4)}, {"l0": 4.5, "rhoA": 2.0, "gravity": (0, -9.81)})
    u = np.array([-0.6, -0.8, 0.6, 0.8])
    side = np.array([-0.8, 0.6, 0.8, -0.6])
    assert at.rows == ("elongation [m]",) and at.columns == ("p.x", "p.y", "q.x", "q.y") and at.slips == ()
    assert_allclose(at.e, [0.5], rtol=1e-15)
    assert_allclose(at.De, [u], rtol=1e-15)
    assert_allclose(at.D2e, [np.outer(side, side) / 5], rtol=1e-14, atol=1e-16)
    assert_allclose(at.M, np.kron([[2, 1], [1, 2]], np.eye(2)) * 2.0 * 4.5 / 6, rtol=1e-15)
    assert_allclose(at.f, [0, -9.81 * 4.5, 0, -9.81 * 4.5], rtol=1e-15)
    assert at.U == pytest.approx(9.81 * 9.0 * 2.0)
    assert at.V.shape == (0, 4) and at.DV.shape == (0, 4, 4)


def test_coordinates_in_a_row_and_gravity_of_none() -> None:
    page = fx.page("planar_truss")
    row = page.evaluate([0, 0, 3, 4], {"l0": 4.5, "rhoA": 2.0})
    named = page.evaluate({"q": (3, 4), "p": (0, 0)}, {"l0": [4.5], "rhoA": 2.0})
    assert np.array_equal(row.D2e, named.D2e) and row.U == 0.0
    assert str(row).splitlines()[1].split() == ["elongation", "[m]", "0.5", "-0.6", "-0.8", "0.6", "0.8"]


@pytest.mark.parametrize("name", ["beam", "hinge", "wheel", "planar_gear", "cable"])
def test_derivatives_are_those_of_the_values(name: str) -> None:
    """Central differences of e, De and V give De, D2e and DV."""
    page, h = fx.page(name), 1e-6
    x, parameters = sample(name)
    at = page.evaluate(x, parameters)
    assert at.D2e.shape == (len(page.rows), len(x), len(x)) and at.DV.shape == (
        len(page.slips),
        len(x),
        len(x),
    )
    for j in range(len(x)):
        step = h * np.eye(len(x))[j]
        below, above = page.evaluate(x - step, parameters), page.evaluate(x + step, parameters)
        assert_allclose(at.De[:, j], (above.e - below.e) / (2 * h), rtol=1e-7, atol=1e-7)
        assert_allclose(at.D2e[:, :, j], (above.De - below.De) / (2 * h), rtol=1e-7, atol=1e-7)
        assert_allclose(at.DV[:, :, j], (above.V - below.V) / (2 * h), rtol=1e-7, atol=1e-7)
    assert_allclose(at.D2e, at.D2e.transpose(0, 2, 1), atol=1e-12)


def test_an_element_of_a_user_has_a_page() -> None:
    """By its definition or as compiled: the same page, and the numbers of the bar of the table."""
    x, parameters = {"p": (0, 0, 0), "q": (1, 2, 2)}, {"l0": 2.5, "mass": 3.0}
    found = [fx.page(own).evaluate(x, parameters) for own in (own_bar(), fx.compile_element(own_bar()))]
    table = fx.page("truss").evaluate(x, {"l0": 2.5, "rhoA": 3.0 / 2.5})
    for at in found:
        assert at.columns == table.columns and at.rows == table.rows
        for name in ("e", "De", "D2e", "M", "f"):
            assert_allclose(getattr(at, name), getattr(table, name), rtol=1e-14, atol=1e-16)


def test_a_page_says_what_its_symbols_are() -> None:
    page = fx.page("planar_wheel")
    assert page.nodes == {"p": "planar point", "r": "planar angle", "s": "planar angle"}
    assert page.columns == ("p.x", "p.y", "r.angle", "s.angle")
    assert page.slips == ("longitudinal [m/s]", "lateral [m/s]") and page.rows == ()
    assert page.parameters["radius"] == "radius of the wheel [m]"
    shown = str(page)
    assert all(
        text in shown for text in ("element planar_wheel", page.doc.splitlines()[0], "radius of the wheel")
    )


@pytest.mark.parametrize(
    ("x", "parameters", "says"),
    [
        ([0, 0, 1], {"l0": 1, "rhoA": 1}, "x has shape (3,); give 4 numbers: p.x, p.y, q.x, q.y"),
        ({"p": (0, 0)}, {"l0": 1, "rhoA": 1}, "no value for q"),
        ({"p": (0, 0), "q": 1}, {"l0": 1, "rhoA": 1}, "x of node 'q'"),
        ({"p": (0, 0), "r": (1, 1)}, {"l0": 1, "rhoA": 1}, "'r'"),
        ([0, 0, 1, 1], {"l0": 1}, "no value for rhoA, mass per length [kg/m]"),
        ([0, 0, 1, 1], {"l0": 1, "rhoA": 1, "EA": 2}, "'EA'"),
        ([0, 0, 1, 1], None, "no value for l0, undeformed length [m]; rhoA"),
        ([0, 0, 0, 0], {"l0": 1, "rhoA": 1}, "not finite"),
    ],
)
def test_wrong_places_and_parameters_are_named(x: object, parameters: object, says: str) -> None:
    with pytest.raises(fx.ModelError) as error:
        fx.page("planar_truss").evaluate(x, parameters)  # type: ignore[arg-type]
    assert "planar_truss" in str(error.value) and says in str(error.value)


def test_what_is_no_element_has_no_page() -> None:
    with pytest.raises(fx.ModelError, match="did you mean beam"):
        fx.page("bem")
    with pytest.raises(fx.ElementError, match="not a flexel.derive.Element"):
        fx.page(3)  # type: ignore[arg-type]
    e, ed, c = symbol("e"), symbol("ed"), Parameter("c", 1, "N/m", "stiffness")
    law = fx.compile_law(Law("page_spring", "sigma = c e", (c,), (e,), (ed,), (), (c.symbol * e,), ()))
    with pytest.raises(fx.ModelError, match="is a law"):
        fx.page(law)  # type: ignore[arg-type]
