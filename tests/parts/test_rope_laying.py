"""How ropes are laid: tension from length, depth in sheaves, turns on drums, what is in their way, what is refused."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.parts.rope import Rope

R, LEG = 0.2, 0.5
GIVEN: dict[str, Any] = {"EA": 1e6, "EI": 1e-3, "mass_per_length": 0.1, "radius": 0.01}


def sheave(groove: Any = None, planar: bool = True, radius: float = R, leg: float = LEG) -> fx.Model:
    """A sheave S with fixed ends A and B, for a rope of radius 1 cm with two vertical legs."""
    m = fx.Model()
    flat = (2,) if planar else (3,)
    (m.angle if planar else m.frame)("F", fixed=True)
    for name, x, y in (("C", 0, 0), ("A", -radius - 0.01, -leg), ("B", radius + 0.01, -leg)):
        m.point(name, np.resize([x, y, 0.0], flat), fixed=True)
    m.sheave("S", "C", "F", radius=radius, groove=groove)
    return m


def laid(m: fx.Model, n: int = 60, path: Any = ("A", "S", "B"), **change: Any) -> Rope:
    return m.rope("r", list(path), n, **({"contact": fx.Contact(1e9)} | GIVEN | change))


# -- tension, length and depth ----------------------------------------------------------------------


@pytest.mark.parametrize("groove", [None, fx.RoundGroove(0.011), fx.VGroove()])
@pytest.mark.parametrize(("stiffness", "EA"), [(1e9, 1e6), (7e10, 1e6), (1e9, 5e7), (1e8, 1e6)])
def test_the_tension_that_a_length_gives_fills_the_path(groove: Any, stiffness: float, EA: float) -> None:  # noqa: N803
    m = sheave(groove, planar=False)
    length = (2 * LEG + np.pi * (R + 0.01)) / 1.002
    rope = laid(m, contact=fx.Contact(stiffness), length=length, EA=EA)
    assert rope.path.length / length == pytest.approx(1 + rope.tension0 / EA, rel=1e-11)
    ends = rope.tension(m.build().equilibrium())[1][[0, -1]]
    assert ends == pytest.approx(rope.tension0, rel=0.03)


def test_a_sheave_that_hardly_gives_way_leaves_the_tension_of_the_length_alone() -> None:
    rope = laid(sheave(), contact=fx.Contact(1e17), length=(2 * LEG + np.pi * (R + 0.01)) / 1.002)
    assert rope.tension0 == pytest.approx(1e6 * 0.002, rel=1e-4)


@pytest.mark.parametrize(("per", "stiffness"), [("length", 1e9), ("point", 1e7)])
@pytest.mark.parametrize("n", [80, 160])
def test_a_rope_lies_as_deep_as_it_carries(per: str, stiffness: float, n: int) -> None:
    """The initial resultant is that of the tension over half a turn, whatever the contact's unit and the mesh."""
    m = sheave()
    rope = laid(m, n, contact=fx.Contact(stiffness, per=per), tension=1000.0, refine=1.5)
    s = m.build()
    assert rope.resultant(s.initial, "S") == pytest.approx(np.pi * 1000.0, rel=0.05)
    assert rope.tension(s.equilibrium())[1] == pytest.approx(1000.0, rel=0.01)


@pytest.mark.parametrize("planar", [True, False])
def test_the_wrap_of_a_thick_rope_is_counted_on_its_centre_line(planar: bool) -> None:
    m = sheave(planar=planar, radius=0.05)
    rope = laid(m, 200, contact=fx.Contact(1e12), tension=100.0, length=None)
    found = rope.wrap_angle(m.build().equilibrium(), "S")
    element = float(rope.s[1]) / 0.06
    assert found == pytest.approx(rope.path.wraps["S"], abs=element)


# -- turns, other surfaces --------------------------------------------------------------------------


def two_drums(**change: Any) -> Rope:
    m = sheave()
    m.point("D", (1.0, 0), fixed=True)
    m.sheave("E", "D", "F", radius=R)
    return laid(m, 100, path=["S", "E"], tension=10.0, **change)


def test_turns_lie_on_the_drums_that_they_are_given_for() -> None:
    for turns, wraps in ((1.0, (1, 1)), ((1.5, 0.5), (1.5, 0.5)), ((0, 1), (0, 1))):
        found = two_drums(turns=turns).path.wraps
        assert [found.get(name, 0.0) / (2 * np.pi) for name in "SE"] == pytest.approx(wraps)


def test_a_plane_below_a_rope_and_a_sheave_beside_it_are_no_obstacle() -> None:
    m = sheave()
    m.point("G", (0, -2.0), fixed=True)
    m.plane("ground", "G", "F", (0, 1))
    m.point("H", (1.0, -0.2), fixed=True)
    m.sheave("guard", "H", "F", radius=R)
    assert set(laid(m, tension=10.0, also=["ground", "guard"]).contacts) == {"S", "ground", "guard"}


def obstacle(kind: str) -> fx.Model:
    m = sheave(planar=kind != "groove")
    place = (R + 0.01 + 0.9 * 0.1, -0.3, 0.0)
    m.point("H", place if kind == "groove" else place[:2], fixed=True)
    if kind == "plane":
        m.plane("O", "H", "F", (0, 1))
    else:
        m.sheave("O", "H", "F", radius=0.1, groove=fx.VGroove() if kind == "groove" else None)
    return m


@pytest.mark.parametrize("kind", ["plane", "sheave", "groove"])
def test_a_rope_is_not_laid_through_other_surfaces(kind: str) -> None:
    with pytest.raises(
        fx.ModelError, match=r"rope 'r': in its initial configuration it runs \S+ m deep into 'O'"
    ):
        laid(obstacle(kind), tension=10.0, also=["O"])


def test_a_rope_is_not_laid_over_one_sheave_through_another_of_its_path() -> None:
    m = sheave()
    m.point("H", (0, 0.5 * R), fixed=True)
    m.sheave("O", "H", "F", radius=R)
    with pytest.raises(
        fx.ModelError, match=r"deep into '[SO]', where another sheave guides it; move them apart"
    ):
        laid(m, path=["A", ("S", -1), ("O", -1), "B"], tension=10.0)


# -- what is refused --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"turns": -1.0}, "turns -1 is negative"),
        ({"turns": np.nan}, "turns nan is not finite"),
        ({"turns": "1"}, "turns '1' is not numeric"),
        ({"turns": (1, 2, 3)}, r"turns \(1, 2, 3\); give one number, or a pair"),
        ({"turns": 2.0}, "turns 2.0 need a drum, but there is none"),
        ({"refine": 0}, "refine 0 is not positive"),
        ({"refine": np.nan}, "refine nan is not finite"),
        ({"refine": "2"}, "refine '2' is not numeric"),
        ({"also": "S"}, "'S' is not a list of names"),
        ({"also": ["T"]}, "rope 'r': unknown sheave or plane 'T'"),
        ({"contact": 1e9}, "contact 1000000000.0 is not a Contact; give fx.Contact"),
        ({"tension": 1e12}, "presses it into a sheave by more than half the radius; give a lower tension"),
        ({"tension": None, "length": 0.01}, "the length 0.01 m on a path of .* give a greater length"),
        ({"tension": None, "length": 3.0}, "hangs slack"),
        ({"path": ["A", ("S",), "B"]}, r"\('S',\) in its path; give a name, or"),
        ({"path": ["A", ("S", np.array([1, 2])), "B"]}, "in its path; give a name, or"),
        ({"path": [("A", 1), "S", "B"]}, "'A' is a point and has no sense of wrap"),
        ({"path": ["A", "T", "B"]}, "rope 'r': unknown sheave or plane 'T'"),
        ({"path": ["A", "S", "Z"]}, "A, S, C lie in a planar model, Z in space|A, S lie in a planar model, Z in space"),
        ({"EI": None}, "EA or EI is missing"),
    ],
)  # fmt: skip
def test_what_cannot_be_laid_is_refused_by_name_and_leaves_the_model_as_it_was(
    change: dict[str, Any], message: str
) -> None:
    m = sheave()
    m.point("Z", (0.3, -0.5, 0.0), fixed=True)
    before = {name: len(value) for name, value in vars(m.lowering).items() if isinstance(value, (dict, list))}
    with pytest.raises(fx.ModelError, match=message):
        laid(m, **({"tension": 10.0} | change))
    assert {
        name: len(value) for name, value in vars(m.lowering).items() if isinstance(value, (dict, list))
    } == before
    laid(m, tension=10.0)


@pytest.mark.parametrize("radius", [0.01, 0.005])
def test_a_rope_that_does_not_fit_into_its_groove_is_refused(radius: float) -> None:
    with pytest.raises(
        fx.ModelError, match=rf"rope of radius 0\.01 m does not fit into the groove of radius {radius}"
    ):
        laid(sheave(fx.RoundGroove(radius), planar=False), tension=10.0)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda m, r: m.rope_contact(r, "S", 1e9, radius=0.01), "contact 1000000000.0 is not a Contact"),
        (
            lambda m, r: m.rope_contact("rr", "S", fx.Contact(1e9), radius=0.01),
            "unknown rope 'rr'; did you mean r",
        ),
        (lambda m, r: m.plane("g", "C", "F", 3), r"plane 'g': normal \[3\.0\] has shape"),
        (lambda m, r: m.plane("g", "C", "F", None), "plane 'g': normal None is not numeric"),
        (lambda m, r: m.sheave("T.a", "C", "F", radius=0.1), "a name is text without dots"),
        (
            lambda m, r: m.cable_line("c", lambda u: "ab", 4, EA=1.0, EI=0.0),
            "cable line 'c': path .* is not numeric",
        ),
        (
            lambda m, r: m.build().simulate(0.1, method="generalized-alpha", spectral_radius="a"),
            "spectral_radius 'a' is not numeric",
        ),
    ],
)
def test_other_bad_input_is_named(call: Callable[[fx.Model, Rope], Any], message: str) -> None:
    m = sheave()
    rope = laid(m, tension=10.0)
    with pytest.raises(fx.ModelError, match=message):
        call(m, rope)


# -- results ----------------------------------------------------------------------------------------


def test_a_rope_is_shown_in_a_line() -> None:
    assert repr(laid(sheave(), 60, tension=10.0, EA=1e9)) == "Rope('r', 60 elements, 1.65969 m)"


def test_all_questions_take_motions_and_refuse_what_is_not_a_state_of_the_rope() -> None:
    m, other = sheave(), sheave()
    rope, longer = laid(m, 60, tension=10.0), laid(other, 80, tension=10.0)
    states = [m.build().initial] * 3
    assert rope.wrap_angle(states, "S").shape == (3,)
    assert rope.slip(states, "S")[1].shape == rope.contact_force(states, "S")[1].shape == (3, 300)
    foreign = other.build().initial
    for wrong in (foreign, [states[0], foreign]):
        with pytest.raises(fx.ModelError, match="rope 'r': the states belong to different models"):
            rope.tension(wrong)
    for nothing in ([], m):
        with pytest.raises(fx.ModelError, match=r"rope 'r': .* is not a state; give a state, or a motion"):
            longer.tension(nothing)  # type: ignore[arg-type]


@pytest.fixture(scope="module", params=[None, fx.RoundGroove(0.0011), fx.VGroove()])
def fallen(request: pytest.FixtureRequest) -> fx.Motion:
    """A rope that falls on a sheave at 1 m/s."""
    m = fx.Model(gravity=(0, -9.81, 0))
    m.frame("F", fixed=True)
    m.point("C", (0, 0, 0), fixed=True)
    m.sheave("S", "C", "F", radius=0.1, groove=request.param)
    rope = m.cable_line("r", [(-0.3, 0.1015, 0), (0.3, 0.1015, 0)], 20, EA=1e4, EI=1e-3, mass_per_length=0.1)
    m.rope_contact(rope, "S", fx.Contact(1e8, dissipation=1.0), radius=0.001)
    for point in rope.points:
        m.initial(f"{point.name}.y", rate=-1.0)
    return m.build().simulate(
        0.01, method="generalized-alpha", samples=6, spectral_radius=0.5, step=5e-4, progress=False
    )


def test_every_kind_of_groove_counts_as_a_contact(fallen: fx.Motion) -> None:
    assert fallen.statistics["halved at contact"] > 0
    assert fallen.energy_balance()["contact"].max() > 1e-6


@pytest.mark.parametrize("suffix", [".nc", ".npz", ".mat", ".csv"])
def test_the_energy_balance_is_saved_with_the_motion(fallen: fx.Motion, tmp_path: Path, suffix: str) -> None:
    read, own = fx.load(fallen.save(tmp_path / f"fall{suffix}")).energy_balance(), fallen.energy_balance()
    assert all(np.array_equal(read[name], own[name]) for name in own)


def test_an_implicit_motion_is_animated_from_its_stored_states(fallen: fx.Motion, tmp_path: Path) -> None:
    from PIL import Image

    path = fallen.animate(tmp_path / "fall.gif", fps=10, slower=50, size=(3, 2), progress=False)
    with Image.open(path) as picture:
        assert picture.n_frames > 1
