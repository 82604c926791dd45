"""What is printed in a shell, and shown in a notebook."""

from html.parser import HTMLParser
from typing import Any

import pytest
from mechanisms import cantilever, disc

import flexel as fx
from flexel.examples.bicycle import bicycle, model


class Cells(HTMLParser):
    """The texts of all cells of a table."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.found: list[str] = []
        self.feed(text)

    def handle_data(self, data: str) -> None:
        self.found.append(data)


def cells(shown: Any) -> list[str]:
    return Cells(shown._repr_html_()).found


def test_everything_has_a_short_line() -> None:
    """One line for models, systems, states, motions and linearizations."""
    system = bicycle()
    motion = system.simulate(0.01, samples=3)
    lines = {
        "model": repr(model()),
        "system": repr(system),
        "state": repr(motion[0]),
        "motion": repr(motion),
        "linearization": repr(system.linearize()),
        "mode": repr(system.linearize().modes()[0]),
    }
    assert all("\n" not in line and len(line) < 260 for line in lines.values()), lines
    assert "hinge × 6" in lines["model"] and "5 points" in lines["model"]
    assert lines["state"].startswith("State(t = 0 s; lean.angle = 0")
    assert lines["motion"].startswith("Motion(3 states, t = 0 … 0.01 s; reached the end")
    assert "lean.angle" in lines["linearization"] and "4 kinematic coordinates" in lines["linearization"]
    assert repr(fx.Model()) == "Model(empty)"


def test_a_model_shows_counts_and_its_picture_in_a_notebook() -> None:
    pytest.importorskip("matplotlib", reason="pictures need pip install 'flexel[plot]'")
    m = model()
    shown = m._repr_html_()
    assert {"hinge", "6", "point", "5"} <= set(cells(m))
    assert '<img alt="the model as drawn" src="data:image/png;base64,iVBOR' in shown
    assert fx.Model()._repr_html_().startswith("<p>Model(empty)</p>")


def test_a_model_that_cannot_be_built_says_why_in_a_notebook() -> None:
    m = fx.Model()
    m.point("A", (0, 0), fixed=True)
    m.point("B", (1, 0), fixed=True)
    m.truss("rod <1>", "A", "B")
    shown = m._repr_html_()
    assert "<img" not in shown and "rod &lt;1&gt;" in shown and "link" not in shown


def test_bodies_and_steppers_are_one_line() -> None:
    m = fx.Model(gravity=(0, -9.81))
    body = m.rigid_body("crank", (0.5, 0), mass=1.0, inertia=0.1, points={"tip": (1, 0)})
    m.revolute("pin", "ground", "crank", at=(0, 0))
    assert repr(body) == "RigidBody('crank': crank, crank_frame, points tip)"
    stepper = m.build().stepper(0.01, inputs=["pin.angle"], outputs=["crank.x"])
    assert repr(stepper) == "Stepper(t = 0 s, dt = 0.01 s; in: pin.angle; out: crank.x; DOP853)"


def test_modes_are_a_table() -> None:
    """In a shell, in print, and as HTML with the same numbers."""
    modes = bicycle().linearize().modes()
    lines = repr(modes).splitlines()
    assert len(lines) == len(modes) + 1
    assert lines[0].split()[0] == "mode" and lines[1].split()[:2] == ["steer.angle", "-5.5309"]
    assert "-5.5309" in cells(modes)
    assert modes[1:] == list(modes)[1:] and isinstance(modes, list)


def test_vibrations_and_buckling_are_tables() -> None:
    system = cantilever()
    for found, head in (
        (system.vibrations(count=3), "frequency [rad/s]"),
        (system.buckling(increment={"A.x": -1.0}, count=2), "multiplier"),
    ):
        assert repr(found).startswith(head) and len(repr(found).splitlines()) == len(found) + 1
        assert head in cells(found)


def test_a_linearization_shows_its_modes_in_a_notebook() -> None:
    """Also about a state that accelerates, with a note."""
    assert "-5.5309" in cells(bicycle().linearize())
    system = disc().build()
    tilted = system.state_at({"lean.angle": 0.3})
    assert "the state accelerates" in system.linearize(tilted)._repr_html_()


def test_a_summary_names_what_a_system_is() -> None:
    text = repr(bicycle().summary())
    for part in (
        "3: lean.angle, steer.angle",
        "rear contact.x",
        "4 of them zero",
        "3.13 to 5.53 1/s",
        "DOP853, also for long motions from this start",
    ):
        assert part in text
    assert "lean.angle" in bicycle()._repr_html_()


def test_a_stiff_system_says_so() -> None:
    """A mass on a stiff spring, beside one on a soft one."""
    m = fx.Model()
    for name, stiffness in (("soft", 1.0), ("hard", 1e10)):
        m.point_mass(f"mass {name}", m.point(name, (0.0, 0.0)), 1.0)
        m.fix(f"{name}.y")
        m.point(f"{name} end", (1.0, 0.0), fixed=True)
        m.truss(f"{name} bar", name, f"{name} end")
        m.spring(f"{name} bar.elongation", stiffness)
    text = repr(m.build().summary())
    assert "Radau for longer motions (stiff)" in text and "1 to 1e+05 1/s" in text


@pytest.mark.parametrize("count", [3, 100])
def test_long_tables_are_cut(count: int) -> None:
    from flexel.base.shown import PrintedTable

    shown = PrintedTable("title", ("a", "b"), [(str(i), "<b>") for i in range(count)])
    assert ("and 40 more" in shown.text) == (count == 100) == ("and 40 more" in shown.html)
    assert "&lt;b&gt;" in shown.html


def uneven(heavy: float) -> fx.System:
    """Two rods in a row, one of them heavy."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point("A", (1, 0))
    m.point("B", (2, 0))
    m.truss("stout", "O", "A", mass_per_length=heavy)
    m.truss("thin", "A", "B", mass_per_length=1e-3)
    return m.build()


def test_the_summary_of_a_badly_scaled_system_says_so_and_that_of_a_usual_one_does_not() -> None:
    assert "badly scaled: the inertia of 'A.y' is 1e+12 times that of 'B.y'" in repr(uneven(1e9).summary())
    assert "scaled" not in repr(uneven(1e3).summary())


def test_the_summary_of_a_stiff_system_says_so_with_its_integrator() -> None:
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point("A", (1, 0))
    m.truss("rod", "O", "A", mass_per_length=1.0)
    m.spring("rod.elongation", 1e9)
    s = m.build()
    assert "Radau for longer motions (stiff)" in repr(s.summary())
    assert s.simulate(2.0, samples=3).message.startswith(
        "reached the end (Radau, chosen because it takes fewer"
    )


def test_results_are_one_line_in_a_shell() -> None:
    from travellers import pushed_many

    _, linearizations, loci = pushed_many()
    dofs = ", ".join(linearizations.dofs)
    assert repr(linearizations) == f"Linearizations(2 variants; {dofs})"
    assert repr(loci) == f"RootLoci(body.mass from 1 to 2 kg, 2 values; {linearizations!r})"
    lin = bicycle().linearize()
    assert repr(lin.reduced(lin.dynamic)) == f"Reduced({', '.join(lin.dynamic)}; M, C, K)"
