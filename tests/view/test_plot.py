"""Pictures: what is drawn lies where the mechanism is, files are written, and what is missing is named."""

import shutil
import sys
from pathlib import Path

import numpy as np
import pytest

import flexel as fx
from flexel.apps.view import drawing
from flexel.apps.view.figures import save
from flexel.apps.view.plot import animate, draw
from flexel.apps.view.scene import display_axes
from flexel.base.quaternions import matrix
from flexel.examples.bicycle import bicycle, kick


@pytest.fixture(scope="module")
def motion() -> fx.Motion:
    return kick(bicycle(), 4.5, 0.5, rtol=1e-8)


def pendulum() -> fx.System:
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point("A", (1, 0))
    m.angle("ground", fixed=True)
    m.angle("turn")
    m.hinge("pivot", "ground", "turn")
    m.beam("rod", "O", "turn", "A", mass_per_length=1.0)
    return m.build()


def test_wheels_touch_the_road_and_have_their_radius(motion: fx.Motion) -> None:
    """The rim is a circle about the hub, and its lowest point is the contact point."""
    state = motion[-1]
    rim = next(
        shape for shape in drawing.shapes(state) if shape.style == "rim" and shape.name == "rear"
    ).lines[0]
    assert np.allclose(np.linalg.norm(rim - state.position("rear hub"), axis=1), 0.3, atol=1e-12)
    assert 0 <= -rim[:, 2].max() < 0.3 * (1 - np.cos(np.pi / 48))  # z points down
    assert np.linalg.norm(rim - state.position("rear contact"), axis=1).min() < 0.3 * np.pi / 48


def test_sketches_move_with_their_body(motion: fx.Motion) -> None:
    """A sketch drawn through two points of one body goes through them at any time."""
    state = motion[-1]
    places = [motion.system.structure.node(name).x0.tolist() for name in ("rear hub", "head")]
    line = drawing.shapes(state, [drawing.Sketch("rear hub", "rear frame", places)])
    found = next(shape for shape in line if shape.style == "sketch").lines[0]
    assert np.allclose(found, [state.position("rear hub"), state.position("head")], atol=1e-12)


def test_a_bent_beam_ends_at_its_points_with_its_directions() -> None:
    """The drawn axis of a flexible beam is the cubic through its ends; clamped, it starts along the wall's normal."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.frame("wall", fixed=True)
    m.frame("tip")
    m.beam("leaf", "O", "wall", "A", "tip", EA=1e4, GJ=1.0, EIy=1.0, EIz=1.0, mass_per_length=1.0)
    m.point_mass("weight", "A", 1.0)
    m.body("end", "A", "tip", mass=0.1, inertia=(0.1, 0.1, 0.1))
    system = m.build()
    bent = {name: 0.1 for name in system.dynamic if "bend" in name}
    state = system.state_at(bent)
    line = next(shape for shape in drawing.shapes(state) if shape.style == "beam").lines[0]
    assert np.allclose(line[[0, -1]], [(0, 0, 0), state.position("A")])
    start, end = 16 * (line[1] - line[0]), 16 * (line[-1] - line[-2])
    assert np.linalg.norm(state.position("A")[1:]) > 0.05
    assert np.allclose(start, (1, 0, 0), atol=0.03)
    assert np.allclose(end, matrix(state.position("tip"))[:, 0], atol=0.03)


def test_up_is_normal_to_the_road_or_against_gravity(motion: fx.Motion) -> None:
    """With z pointing down, the picture is turned about the x axis."""
    assert np.array_equal(drawing.upward(motion[0]), (0, 0, -1))
    assert np.allclose(display_axes(np.array([0.0, 0, -1])), np.diag([1, -1, -1]))
    for up in np.eye(3):
        R = display_axes(up)
        assert np.allclose(R @ R.T, np.eye(3))
        assert np.isclose(np.linalg.det(R), 1)


def test_spatial_and_planar_models_are_drawn(motion: fx.Motion, tmp_path: Path) -> None:
    """The same function draws both; a planar model gets plain axes with equal scales."""
    axes = draw(motion[-1], view=fx.View(centre="head", span=2.0))
    assert axes.name == "3d"
    save(axes.figure, tmp_path / "bicycle.png")
    flat = draw(pendulum().initial)
    assert flat.name == "rectilinear"
    assert flat.get_aspect() == 1
    assert (tmp_path / "bicycle.png").stat().st_size > 5000


def test_histories_have_a_panel_for_each_unit(motion: fx.Motion, tmp_path: Path) -> None:
    """Names may ask for rates and forces; units come from the model."""
    drawn = motion.plot(
        "lean.angle", "steer.angle", "lean.angle'", "force:rear.surface", path=tmp_path / "h.png"
    )
    assert [axes.get_ylabel() for axes in drawn.axes] == [
        "angle [rad]",
        "lean.angle' [rad/s]",
        "force:rear.surface [N]",
    ]
    assert np.array_equal(drawn.axes[1].lines[0].get_ydata(), motion.rate("lean.angle"))
    assert (tmp_path / "h.png").exists()
    with pytest.raises(fx.ModelError, match=r"did you mean lean\.angle"):
        motion.plot("lean.angel")


def test_an_animation_in_memory_is_written_as_the_gif_that_it_is(tmp_path: Path) -> None:
    made = pendulum().simulate(0.2, progress=False).animate(fps=5.0, progress=False)
    assert made.write(tmp_path / "swing.gif").read_bytes()[:6] == b"GIF89a"
    with pytest.raises(fx.ModelError, match=r"it is a GIF; write \.gif, or motion\.animate"):
        made.write(tmp_path / "swing.mp4")


def test_gif_and_planar_animation(tmp_path: Path) -> None:
    """Pillow joins the frames."""
    from PIL import Image

    path = animate(pendulum().simulate(0.5), tmp_path / "pendulum.gif", fps=10, dpi=40)
    with Image.open(path) as picture:
        assert picture.n_frames == 6  # type: ignore[attr-defined]


def test_mp4_needs_ffmpeg(motion: fx.Motion, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the program is missing, it is named before anything is drawn."""
    monkeypatch.setattr(shutil, "which", lambda _: None)
    with pytest.raises(
        fx.FlexelError,
        match="ffmpeg is not installed; .*`apt install ffmpeg`.*write .html or .gif",
    ):
        animate(motion, tmp_path / "kick.mp4")
    with pytest.raises(fx.ModelError, match=r"suffix '\.avi' is unknown"):
        animate(motion, tmp_path / "kick.avi")


def test_missing_matplotlib_is_named(motion: fx.Motion, monkeypatch: pytest.MonkeyPatch) -> None:
    """Everything but pictures works without matplotlib."""
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(fx.FlexelError, match=r'pip install "flexel\[plot\]"'):
        motion.plot("lean.angle")
