"""`Model.check` and `flexel check`: everything at once, by name, and never an exception."""

import re
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import flexel as fx
from flexel.apps.cli.main import main

STEEL = {"section": fx.Rectangle(0.3e-3, 20e-3), "material": "steel"}


def drawing(gravity: float = 9.81) -> fx.Model:
    m = fx.Model(gravity=(0, 0, -gravity))
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (0.1, 0, 0))
    m.frame("R0", fixed=True)
    m.frame("R1")
    return m


def leaf(**values: object) -> fx.Model:
    """A leaf spring that is clamped at one end."""
    m = drawing()
    m.beam("leaf", "O", "R0", "A", "R1", direction=(0, 1, 0), **{**STEEL, **values})
    return m


def pendulum() -> fx.Model:
    m = drawing()
    m.hinge("pivot", "R0", "R1", axis=(0, 1, 0))
    m.beam("rod", "O", "R1", "A", mass_per_length=2.0)
    return m


def messages(report: fx.CheckReport, severity: str, subject: str) -> str:
    return "\n".join(
        finding.message
        for finding in report.findings
        if (finding.severity, finding.subject) == (severity, subject)
    )


def test_a_sound_structure_has_nothing_but_notes() -> None:
    report = leaf().check()
    assert report.ok
    assert {finding.severity for finding in report.findings} == {"note"}
    assert report.dynamic == tuple(leaf().build().dynamic)
    assert "6 degree(s) of freedom: 'leaf.elongation'" in str(report)
    assert str(report).endswith("1 note(s)")


def test_a_mechanism_that_is_left_free_is_named() -> None:
    report = pendulum().check()
    assert report.ok
    assert "'A.z'" in messages(report, "note", "constraints")


def test_redundant_conditions_and_what_to_release_are_listed() -> None:
    m = drawing()
    m.hinge("a", "R0", "R1", axis=(0, 1, 0))
    m.hinge("b", "R0", "R1", axis=(0, 1, 0))
    m.beam("rod", "O", "R1", "A", mass_per_length=2.0)
    report = m.check()
    assert report.dynamic == ()
    said = messages(report, "error", "constraints")
    assert said.count("over-constrained") == 2
    release = m.constraint_report().release
    assert len(release) == 2
    for name in release:
        assert f"m.release('{name}')" in said
        m.release(name)
    assert not m.check().errors


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"material": fx.Material(E=210, rho=7850, nu=0.3)}, "E = 210 Pa looks like another unit"),
        ({"material": fx.Material(E=2.1e5, rho=7850, nu=0.3)}, "E = 2.1e+05 Pa"),
        ({"material": fx.Material(E=2.1e11, rho=7.85, nu=0.3)}, "density 7.85"),
        ({"section": fx.Rectangle(0.3, 20)}, "is longer than it is deep"),
    ],
)
def test_units_that_look_wrong_are_suspected(values: dict[str, object], words: str) -> None:
    report = leaf(**values).check()
    assert words in messages(report, "warning", "units")
    assert not report.ok
    assert not report.errors


def test_gravity_in_millimetres_and_angles_in_degrees_are_suspected() -> None:
    m = drawing(9810.0)
    m.hinge("pivot", "R0", "R1", axis=(0, 1, 0))
    m.beam("rod", "O", "R1", "A", mass_per_length=2.0)
    m.independent("pivot.angle")
    m.initial("pivot.angle", 90.0)
    said = messages(m.check(), "warning", "units")
    assert "looks like mm/s²" in said
    assert "'pivot.angle' looks like degrees" in said


def rod(gravity: tuple[float, ...], **given: float) -> fx.Model:
    m = fx.Model(gravity=gravity)
    m.point("O", (0, 0), fixed=True)
    m.point("A", (1, 0))
    m.angle("turn")
    m.beam("rod", "O", "turn", "A", **given)  # type: ignore[arg-type]
    m.load("A.y", 1.0)
    return m


def test_gravity_that_does_not_act_is_suspected() -> None:
    """Along z in the plane, and where nothing has a mass; not where it acts."""
    with pytest.warns(fx.ModelWarning, match=r"along z does not act.*give gravity=\(0, -9.81\)"):
        rod((0, 0, -9.81), mass_per_length=1.0).build()
    with pytest.warns(fx.ModelWarning, match="gravity acts on no mass"):
        rod((0, -9.81)).build()
    rod((0, -9.81), mass_per_length=1.0).build()
    rod((0, 0)).build()


def test_round_degrees_given_to_a_state_are_suspected_and_turns_of_a_wheel_are_not() -> None:
    s = rod((0, -9.81), mass_per_length=1.0).build()
    for value in (45, 90.0, -180, 360):
        with pytest.warns(fx.ModelWarning, match="state_at: .* rad of 'turn.angle' looks like degrees"):
            s.state_at({"turn.angle": value})
    for value in (3.0, 12.0, 200.0, 87.5, 3600.0):
        assert s.state_at({"turn.angle": value})["turn.angle"] == value


@pytest.mark.parametrize(
    "material", ["steel", "titanium", "wire rope", fx.Material(E=5e6, rho=1100, nu=0.49)]
)
def test_real_materials_are_not_suspected(material: str | fx.Material) -> None:
    assert leaf(material=material).check().ok


def test_missing_masses_and_idle_nodes_are_named() -> None:
    m = drawing()
    m.hinge("pivot", "R0", "R1", axis=(0, 1, 0))
    m.beam("rod", "O", "R1", "A")
    m.point("Z", (1, 1, 1))
    report = m.check()
    assert "moves no mass" in messages(report, "warning", "masses")
    assert "point 'Z' belongs to no element" in messages(report, "warning", "elements")


def test_a_drawing_that_has_to_be_mended_is_a_warning() -> None:
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("hub", (0, 0, 0.9))
    m.frame("rim")
    m.point("contact", (0, 0, 0))
    m.wheel("w", "hub", "rim", "contact", radius=0.4, axle=(0, 1, 0))
    m.body("tyre", "hub", "rim", mass=2.0, inertia=np.eye(3))
    assert "'hub.z' by -0.5 m" in messages(m.check(), "warning", "drawing")


def test_poor_coordinates_are_named_with_better_ones() -> None:
    def report(x: float) -> fx.CheckReport:
        m = fx.Model(gravity=(0, -9.81))
        m.point("O", (0, 0), fixed=True)
        m.point("A", (x, 1))
        m.truss("rod", "O", "A", mass_per_length=1)
        m.independent("A.y")
        return m.check()

    assert "1e+03 times as far as 'A.x'" in messages(report(1e-3), "warning", "coordinates")
    assert "20 times as far" in messages(report(0.05), "note", "coordinates")
    assert not messages(report(1.0), "note", "coordinates")


def test_contradictions_are_findings_too() -> None:
    m = pendulum()
    m.spring("pivot.angle", 1.0)
    m.rigid("pivot.angle")
    assert "'pivot.angle' is rigid and also has a law" in messages(m.check(), "error", "declarations")
    assert "no nodes" in messages(fx.Model().check(), "error", "assembly")


MODEL = """
import flexel as fx
m = fx.Model(gravity=(0, -{gravity}))
m.point("O", (0, 0), fixed=True)
m.point("A", (1, 0))
m.truss("rod", "O", "A", mass_per_length=1)
"""


@pytest.mark.parametrize(("gravity", "status"), [("9.81", 0), ("9810", 1)])
def test_the_command_prints_the_table_and_says_by_its_status(
    tmp_path: Path, gravity: str, status: int
) -> None:
    file = tmp_path / "model.py"
    file.write_text(MODEL.format(gravity=gravity))
    result = CliRunner().invoke(main, ["check", str(file)])
    assert result.exit_code == status
    assert "1 degree(s) of freedom: 'A.y'" in result.output
    assert ("looks like mm/s²" in result.output) is bool(status)


def test_the_command_refuses_other_files(tmp_path: Path) -> None:
    file = tmp_path / "model.txt"
    file.write_text("")
    result = CliRunner().invoke(main, ["check", str(file)])
    assert result.exit_code == 2
    assert "give MODEL.py, MODEL.json or MODEL.dat" in result.output


def test_a_cable_too_coarse_for_a_circle_that_it_may_touch_is_a_finding() -> None:
    m = fx.Model(gravity=(0, -9.81))
    m.point("C", (0, 0), fixed=True)
    m.angle("F", fixed=True)
    m.sheave("drum", "C", "F", radius=0.1)
    rope = m.cable_line("rope", [(-1, 0.11), (1, 0.11)], 4, EA=1e4, EI=0.1, mass_per_length=0.1)
    m.fix(rope.points[0], rope.points[-1])
    m.rope_contact(rope, "drum", fx.Contact(1e8), radius=0.005)
    with pytest.warns(
        fx.ModelWarning, match=r"'rope\d' of 0\.5 m cannot follow 'drum', whose radius is 0\.1 m"
    ):
        m.build()


def test_reports_name_joints_and_bodies_not_what_joints_add() -> None:
    """Two hinges between two bodies: neither their points on the bodies nor the links that hold these are named."""
    m = fx.Model()
    for name, x in (("a", 0.0), ("b", 1.0)):
        m.rigid_body(name, (x, 0, 0), mass=1.0, inertia=(1, 1, 1))
    for name, at in (("j", (0.5, 0, 0)), ("k", (0.6, 0.2, 0))):
        m.revolute(name, "a", "b", at=at, axis=(0, 0, 1))
    m.revolute("g", "ground", "a", at=(-0.5, 0, 0), axis=(0, 0, 1))
    with pytest.raises(fx.ConstraintError) as refused:
        m.build()
    for text in (str(refused.value), str(m.check()), str(m.constraint_report())):
        assert "'k.bend1'" in text and "_link" not in text
        assert not re.search(r"'[jkg]_[pq]\.", text)
