"""Wrong options of pictures are refused by the method that was called, with what to write instead."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import flexel as fx

Picture = Callable[[fx.System, Path, dict[str, Any]], object]


def pendulum() -> fx.System:
    """A rod that hangs on a hinge."""
    m = fx.Model(gravity=(9.81, 0, 0))
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.frame("R0", fixed=True)
    m.frame("R1")
    m.hinge("pivot", "R0", "R1", axis=(0, 1, 0))
    m.beam("rod", "O", "R1", "A", mass_per_length=2.0)
    return m.build()


def moved(s: fx.System) -> fx.Motion:
    """A short motion."""
    return s.simulate(0.01, samples=3)


VIEWS: dict[str, Picture] = {
    "view": lambda s, at, options: moved(s).view(at / "x.html", **options),
    "page": lambda s, at, options: moved(s).page(**options),
    "animate": lambda s, at, options: moved(s).animate(at / "x.html", **options),
    "plot_shapes": lambda s, at, options: moved(s).plot_shapes(**options),
    "view of modes": lambda s, at, options: s.linearize().view(at / "x.html", **options),
    "plot_mode": lambda s, at, options: s.linearize().plot_mode(0, **options),
}


@pytest.mark.parametrize(("owner", "picture"), VIEWS.items())
@pytest.mark.parametrize("option", ["sketches", "trails", "azimuth"])
def test_an_option_of_view_is_asked_for_in_a_view(
    owner: str, picture: Picture, option: str, tmp_path: Path
) -> None:
    words = rf"^{owner}: '{option}' is an option of View; write view=fx\.View\({option}=…\)$"
    with pytest.raises(fx.ModelError, match=words):
        picture(pendulum(), tmp_path, {option: []})


def poles(s: fx.System, at: Path, options: dict[str, Any]) -> object:
    """Root loci of the pendulum over its mass."""
    return s.root_loci(parameters={"rod.rhoA": [1.0, 2.0]}).plot(**options)


@pytest.mark.parametrize(("owner", "picture"), [*VIEWS.items(), ("plot", poles)])
def test_another_wrong_option_is_refused_with_the_near_ones(
    owner: str, picture: Picture, tmp_path: Path
) -> None:
    option, meant = {"plot_shapes": ("lable", "label")}.get(owner, ("titel", "title"))
    with pytest.raises(fx.ModelError, match=rf"^{owner}: unknown option '{option}'; did you mean {meant}\?$"):
        picture(pendulum(), tmp_path, {option: "x"})


@pytest.mark.parametrize(("owner", "picture"), VIEWS.items())
def test_the_view_that_is_asked_for_is_accepted(owner: str, picture: Picture, tmp_path: Path) -> None:
    sketch = fx.Sketch("A", "R1", [(0, 0, 0), (0, 0, 0.1)])
    assert picture(pendulum(), tmp_path, {"view": fx.View(sketches=[sketch])}) is not None
