"""Every program of README.md and of the pages runs, prints what its page shows, and computes what is right."""

import re

import numpy as np
import pytest
from filling import DOCS
from longer import longer
from page_output import agrees
from page_programs import PAGES, WITHOUT, ran

RUN = sorted({*PAGES} - {*WITHOUT, "adding-an-element.md"})


@pytest.mark.parametrize("page", longer(RUN, "concepts.md", "control.md", "vehicles.md"))
def test_the_program_of_a_page_runs_and_prints_what_the_page_shows(page: str) -> None:
    for package in ("matplotlib", "xarray", "joblib", "gymnasium", "control"):
        pytest.importorskip(package, reason="pages use everything optional: pip install 'flexel[test]'")
    found = ran(page)
    assert found.printed
    for part, out in found.printed:
        assert agrees(part, out), f"{page} shows\n{part.shown and part.shown['text']}\nnow\n{out}"
    for name, picture in found.drawn.items():
        assert len(picture) > 5_000, name


def test_the_program_of_the_first_five_minutes_draws() -> None:
    pytest.importorskip("matplotlib", reason="the page draws with matplotlib: pip install 'flexel[plot]'")
    assert len(ran("start.md").drawn["fourbar.png"]) > 5_000


def test_the_bicycle_of_the_readme_rides() -> None:
    pytest.importorskip("matplotlib", reason="the README's program draws with matplotlib")
    found = ran("README.md")
    assert len(found.drawn["kick.png"]) > 10_000
    for digits in ("-13.1", "-0.72", "-0.26", "3.72"):
        assert digits in next(out for part, out in found.printed if "kick.png" in part.code)


@pytest.mark.long
def test_the_program_of_the_page_on_control_steadies_the_rod() -> None:
    """Upright and falling at first, then at rest and upright with a controller; sampled too, unless too late."""
    pytest.importorskip("control", reason="the page uses python-control: pip install 'flexel[control]'")
    names = ran("control.md").names
    assert names["lin"].eigenvalues().real.max() == pytest.approx((1.5 * 9.81 / 0.5) ** 0.5, rel=1e-9)
    assert names["regulated"].linearize().eigenvalues().real.max() < -1
    assert abs(names["balanced"]["motor.angle"][-1]) < 1e-4
    assert names["sampled"]["motor.angle"][-1] == pytest.approx(0.2, abs=1e-6)
    assert names["delay"] == 0.03 and not names["loop"].stable
    assert names["both"].stable and names["both"].period == pytest.approx(0.02)
    assert names["limited"]["motor.angle"].max() < 0.601 < names["wound_up"]["motor.angle"].max() - 0.1
    assert abs(names["angle"]) < 1e-3


def test_the_programs_of_the_page_on_variants_run() -> None:
    names = ran("many.md").names
    assert names["found"]["pivot.angle"].shape == (40, 201) and not names["found"].failed
    assert names["many"].M.shape == (20, 1, 1) and names["loci"].stable.all()


@pytest.mark.long
def test_the_car_and_the_winch_do_what_their_pages_say() -> None:
    """The car turns as the single-track model does, but for its roll; the winch lifts by what it winds up."""
    pytest.importorskip("matplotlib", reason="the pages draw with matplotlib: pip install 'flexel[plot]'")
    car, winch = ran("vehicles.md").names, ran("cranes.md").names
    single_track = car["speed"] * 0.01 / (car["base"] + car["understeer"] * car["speed"] ** 2)
    assert car["motion"].rate("yaw.angle")[-1] == pytest.approx(single_track, rel=3e-3)
    assert sum(car["loads"].values()) == pytest.approx(1380 * 9.81, rel=1e-9)
    assert winch["lift"] == pytest.approx(1.5 * 0.208, rel=2e-3)
    assert winch["rest"].force("drum axle.angle") == pytest.approx(-500 * 9.81 * 0.208, rel=1e-3)
    assert 1.15 < winch["ends"].max() / (500 * 9.81) < 1.3


def test_models_of_pages_for_users_of_other_programs_are_the_same() -> None:
    """SymPy's program is on its page; Exudyn's numbers are shown there, and its program runs where it is installed."""
    sympy, spacar = ran("coming-from-sympy.md").names, ran("coming-from-spacar.md").names
    angles = [sympy["motion"][f"{name}.angle"][-1] for name in "AB"]
    np.testing.assert_allclose(sympy["found"].y[:2, -1], angles, rtol=1e-8)
    by_hand, file = spacar["motion"][-1], spacar["file"]
    read = file.system.simulate(file.duration)[-1]
    assert by_hand["slider.x"] == pytest.approx(read["p8.x"], abs=1e-9)
    assert by_hand["rod1.bend1"] == pytest.approx(-file.deformation(read, 2, 2), abs=1e-8)


def test_the_programs_of_the_pages_on_flexures_run() -> None:
    """The mechanisms behave as the page says, and it shows all pictures that its program draws."""
    pytest.importorskip("matplotlib", reason="the page draws with matplotlib: pip install 'flexel[plot]'")
    found = ran("flexure-design.md")
    page = (DOCS / "flexure-design.md").read_text(encoding="utf-8")
    assert set(found.drawn) == set(re.findall(r"\]\(images/(\w+\.png)\)", page)) and len(found.drawn) == 6
    guide, hinge, stage = (found.names[name] for name in ("guide", "hinge", "stage"))
    stiffness = 2 * 206e9 * 25e-3 * 0.4e-3**3 / 0.1**3
    assert 8 / guide.displacements[-1, 4, 0] == pytest.approx(stiffness * (1 - 5 / 54.2), rel=0.02)
    assert guide.displacements[-1, 4, 1] == pytest.approx(
        -0.6 * guide.displacements[-1, 4, 0] ** 2 / 0.1, rel=0.02
    )
    assert hinge.moments[-1, 4, 2] == pytest.approx(2 * 206e9 * 25e-3 * 0.4e-3**3 / 12 / 0.1 * 0.4, rel=0.05)
    assert stage.released == () and len(guide.released) == len(hinge.released) == 1
    A, B, C, D = (found.names[name] for name in "ABCD")
    static = (D - C @ np.linalg.solve(A, B))[0, 0]
    assert static == pytest.approx(guide.compliance(5)[-1, 0, 0], rel=1e-6)
