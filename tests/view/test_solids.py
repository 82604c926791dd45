"""Solids and meshes carried by bodies, and what holds a model: springs, dampers, guides, loads, roads of waves."""

import base64
import struct
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

import flexel as fx
from flexel.apps.view.drawing import loads, shapes
from flexel.apps.view.meshes import read_mesh
from flexel.apps.view.page import scene_data
from flexel.apps.view.primitives import Shape
from flexel.apps.view.wavy_roads import wavy_roads
from flexel.base.quaternions import matrix
from flexel.derive.declare import Deformation, Element, Frame, Output, Parameter, Point
from flexel.derive.declare.rotation import rotation_matrix

CORNERS = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], dtype=float)
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def stl(path: Path) -> Path:
    """A tetrahedron as a binary file."""
    triangles = b"".join(struct.pack("<12fH", 0, 0, 0, *CORNERS[list(f)].ravel(), 0) for f in FACES)
    path.write_bytes(b"\0" * 80 + struct.pack("<I", len(FACES)) + triangles)
    return path


def obj(path: Path) -> Path:
    """The same as a text with a face that names its corners from the end."""
    lines = [f"v {x} {y} {z}" for x, y, z in CORNERS] + [
        f"f {a + 1}/1 {b + 1}/2 {c + 1}/3" for a, b, c in FACES[:3]
    ]
    path.write_text("\n".join(["# tetrahedron", *lines, "f -3 -2 -1", ""]))
    return path


def ascii_stl(path: Path) -> Path:
    facets = "".join(
        "facet normal 0 0 0\nouter loop\n"
        + "".join("vertex {} {} {}\n".format(*CORNERS[i]) for i in f)
        + "endloop\nendfacet\n"
        for f in FACES
    )
    path.write_text(f"solid t\n{facets}endsolid t\n")
    return path


def volume(vertices: np.ndarray, triangles: np.ndarray) -> float:
    """Of a closed surface whose triangles are counterclockwise from outside."""
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def test_meshes_of_three_formats_are_the_same(tmp_path: Path) -> None:
    """Each has the volume 1/6 and four vertices."""
    for path in (stl(tmp_path / "a.stl"), ascii_stl(tmp_path / "b.stl"), obj(tmp_path / "c.obj")):
        vertices, triangles = read_mesh(path)
        assert vertices.shape == (4, 3) and triangles.shape == (4, 3), path
        assert volume(vertices, triangles) == pytest.approx(1 / 6), path


def test_boxes_and_cylinders_are_closed_and_face_outward() -> None:
    """Their volumes, wherever they stand and however they are turned."""
    turned = ((0, 1, 0), (-1, 0, 0), (0, 0, 1))
    box = fx.Box("A", None, (1, 2, 3), (0.2, 0.3, 0.4), turned)
    assert volume(*box.surface) == pytest.approx(0.024)
    assert np.ptp(box.surface[0], axis=0) == pytest.approx((0.3, 0.2, 0.4))
    assert len(box.lines) == 12
    cylinder = fx.Cylinder("A", None, (0, 0, 1), (1, 1, 1), 0.1)
    exact = 0.5 * 32 * np.sin(2 * np.pi / 32) * 0.01 * np.sqrt(2)
    assert volume(*cylinder.surface) == pytest.approx(exact)


def test_a_mesh_turns_and_moves_with_its_body(tmp_path: Path) -> None:
    """After a quarter turn about z its point on the x axis lies on the y axis; the page holds its triangles."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.frame("ground", fixed=True)
    m.frame("arm")
    m.hinge("pivot", "ground", "arm", axis=(0, 0, 1))
    m.body("mass", "O", "arm", mass=1.0, inertia=(1.0, 1.0, 1.0))
    system = m.build()
    mesh = fx.Mesh("O", "arm", stl(tmp_path / "a.stl"), scale=0.001, origin=(0.5, 0, 0))
    state = system.state_at({"pivot.angle": np.pi / 2})
    (found,) = (shape for shape in shapes(state, [mesh]) if shape.style == "solid")
    assert found.pose is not None and found.surface is not None
    places = found.pose[0] + found.surface[0] @ found.pose[1].T
    assert places.max(axis=0) == pytest.approx((0, 0.501, 0.001), abs=1e-12)
    motion = system.simulate(0.1, progress=False)
    scene = scene_data(motion, frames=3, view=fx.View(sketches=[mesh]))
    assert [shape["colour"] for shape in scene["shapes"] if shape["style"] == "solid"] == ["#8fa3b3"]
    assert not any(
        shape["style"] == "box" for shape in scene["shapes"]
    )  # the solid replaces the box of inertia


def held() -> fx.System:
    """Planar: A hangs on a spring with a damper and a stiff bar, B slides with a spring to the ground."""
    m = fx.Model(gravity=(0, -9.81))
    for name, x in (("O", 0.0), ("P", 0.5)):
        m.point(name, (x, 0), fixed=True)
    m.point("A", (0.2, -0.5))
    m.point("B", (0.8, -0.5))
    m.fix("B.y")
    m.truss("strut", "O", "A")
    m.spring("strut.elongation", 500.0, 5.0)
    m.truss("bar", "P", "A", stiffness=1e9)
    m.spring("B.x", 100.0)
    m.spring(("A.x", "B.x"), 50.0)
    for name in "AB":
        m.point_mass(f"mass {name}", name, 1.0)
    m.load("A.x", 3.0)
    m.angle("ground", fixed=True)
    m.angle("turn")
    m.hinge("pivot", "ground", "turn", stiffness=3.0)
    m.body("wheel", "P", "turn", mass=1.0, inertia=1.0)
    return m.build()


def of(found: list[Shape], style: str) -> dict[str, Shape]:
    return {shape.name: shape for shape in found if shape.style == style}


def test_springs_dampers_guides_and_loads_are_drawn_where_they_act() -> None:
    """A spring with a damper replaces its truss, a stiff bar stays; one to the ground lies along its coordinate."""
    system = held()
    state = system.initial
    found = shapes(state)
    springs = of(found, "spring")
    assert np.allclose(springs["strut"].lines[0], [(0, 0, 0), (0.2, -0.5, 0)])
    assert np.allclose(of(found, "damper")["strut"].lines[0], springs["strut"].lines[0])
    assert set(of(found, "bar")) == {"bar"}
    ground = springs["B"].lines[0]
    assert (
        np.allclose(ground[1], (0.8, -0.5, 0)) and ground[0][1] == pytest.approx(-0.5) and ground[0][0] < 0.8
    )
    between = [
        shape for shape in springs.values() if np.allclose(shape.lines[0], [(0.2, -0.5, 0), (0.8, -0.5, 0)])
    ]
    assert len(between) == 1
    assert set(of(found, "spiral")) == {"pivot"}
    assert set(of(found, "slide")) == {"B"}
    (arrow,) = loads([state, state], system.loads)
    assert arrow.force is not None and np.allclose(arrow.force, [(3, 0, 0)] * 2)
    assert arrow.name == "A"


def test_a_spring_to_the_ground_keeps_its_foot_in_a_displaced_picture() -> None:
    """Only the end at the point moves with the coordinates, as in a mode of vibration; across as along."""
    m = fx.Model()
    m.point("A", (0.2, 0.1))
    m.spring("A.x", 10.0)
    m.spring("A.y", 10.0)
    m.point_mass("mass", "A", 1.0)
    state = m.build().initial
    moved = replace(
        state,
        x=state.x + np.array([0.01 * (name == "A.x") for name in state.structure.names[-state.x.size :]]),
    )
    before, after = (
        [shape.lines[0] for shape in shapes(s) if shape.style == "spring"] for s in (state, moved)
    )
    assert len(before) == 2
    assert np.allclose(after[0][1] - before[0][1], (0.01, 0, 0)) and np.allclose(after[0][0], before[0][0])
    assert np.allclose(before[1][1] - before[1][0], (0, before[1][1][1] - before[1][0][1], 0))


@pytest.mark.parametrize("picture", ["beam", "body", "wheel"])
def test_a_users_element_that_lacks_what_its_painter_shows_is_a_line(picture: str) -> None:
    truss = fx.compile_element(stretch(f"user_{picture}", picture))
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.element("mine", truss, "O", "A", l0=1.0)
    m.point_mass("mass", "A", 1.0)
    m.spring("mine.e", 10.0)
    found = shapes(m.build().initial)
    assert [shape.style for shape in found if shape.name == "mine"] == ["bar"]


def test_a_users_element_is_drawn_by_what_it_says() -> None:
    """Its lines and marks have the styles that it names, and are where it says at each state; nothing else is drawn."""
    p, q = Point("p"), Point("q")
    middle = (p.x + q.x) / 2 + sp.Matrix([0, 0, sp.Rational(1, 4)])
    outputs = (
        Output("sag", "m", sp.Matrix.hstack(p.x, middle, q.x).T, draws="rim"),
        Output("middle", "m", middle, draws="mass"),
        Output("unseen", "m", middle),
    )
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.element("mine", fx.compile_element(replace(stretch("sagging", ""), outputs=outputs)), "O", "A", l0=1.0)
    m.point_mass("mass", "A", 1.0)
    m.spring("mine.e", 10.0)
    s = m.build()
    state = s.initial
    for shown in (state, replace(state, x=state.x + 0.125)):
        start, A = shown.position("O"), shown.position("A")
        found = [shape for shape in shapes(shown) if shape.name == "mine"]
        assert [shape.style for shape in found] == ["rim", "mass"]
        centre = (start + A) / 2 + (0, 0, 0.25)
        np.testing.assert_allclose(found[0].lines[0], [start, centre, A], rtol=0, atol=1e-15)
        np.testing.assert_allclose(found[1].lines[0], [centre], rtol=0, atol=1e-15)
    motion = s.simulate(0.1, start=s.state_at(rates={"A.y": 1.0}), progress=False)
    assert {
        shape["style"] for shape in scene_data(motion, frames=3)["shapes"] if shape["name"] == "mine"
    } == {
        "rim",
        "mass",
    }


def test_a_users_line_is_carried_by_the_frame_that_it_names() -> None:
    """A triangle in the axes of a frame turns with it, and a page stores it once."""
    p, r = Point("p"), Frame("r")
    corners = [(0.1, 0, 0.2), (0.3, 0.1, 0), (0, 0.4, 0.1), (0.1, 0, 0.2)]
    outputs = (
        Output("origin", "m", p.x),
        Output("axes", "1", rotation_matrix(r.x).T),
        Output("triangle", "m", sp.Matrix(corners), draws="rim", carrier=("origin", "axes")),
    )
    height = Deformation("height", "m", p.x[2], free=True)
    element = Element("carrying", (p, r), deformations=(height,), doc="height = z", outputs=outputs)
    m = fx.Model()
    m.point("A", (1, 0, 0))
    m.frame("R", (0.5, 0.5, 0.5, 0.5))
    m.body("top", "A", "R", mass=1.0, inertia=(1.0, 2.0, 3.0))
    m.element("mine", fx.compile_element(element), "A", "R")
    s = m.build()
    motion = s.simulate(0.3, start=s.state_at(rates={"A.x": 1.0}), progress=False)
    q = np.array([0.6, 0.0, 0.0, 0.8])
    turned = replace(s.initial, x=s.initial.x.copy())
    turned.x.flags.writeable = True
    turned.x[s.structure.places("R")] = q
    for shown in (s.initial, motion[-1], turned):
        (shape,) = (shape for shape in shapes(shown) if shape.name == "mine")
        R = matrix(shown.position("R"))
        np.testing.assert_allclose(shape.lines[0], shown.position("A") + corners @ R.T, rtol=0, atol=1e-15)
    (stored,) = (shape for shape in scene_data(motion, frames=3)["shapes"] if shape["name"] == "mine")
    assert stored["style"] == "rim" and stored["rigid"]


def stretch(name: str, picture: str) -> Element:
    """A bar between two points."""
    p, q = Point("p"), Point("q")
    l0 = Parameter("l0", 1, "m", "length", sign="positive")
    d = q.x - p.x
    return Element(
        name=name,
        nodes=(p, q),
        parameters=(l0,),
        deformations=(Deformation("e", "m", sp.sqrt(d.dot(d)) - l0.symbol),),
        picture=picture,
        doc="e = |xq - xp| - l0",
    )


@pytest.mark.long
def test_a_guide_is_as_long_as_what_slides_goes() -> None:
    """Its rail is the same at all frames and holds the slider at each."""
    motion = held().simulate(1.0, progress=False)
    scene = scene_data(motion, frames=41)
    rails = [shape for shape in scene["shapes"] if shape["style"] == "guide"]
    x = motion["B.x"]
    assert len(rails) == 2
    for rail in rails:
        line = np.frombuffer(base64.b64decode(rail["data"]), "<f4").reshape(-1, 2, 3)
        assert len(line) == 1
        assert line[0, :, 0].min() < x.min() and line[0, :, 0].max() > x.max()


def test_a_road_of_waves_lies_under_its_tyres() -> None:
    """The strip has the crest's height and reaches beyond the tyre."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("hub", (0, 0, 0.3))
    m.frame("wheel")
    road = fx.Waves(0.1, 2.0, 0.5)
    m.tyre("tyre", "hub", "wheel", radius=0.3, axle=(0, 1, 0), road=road)
    m.body("rim", "hub", "wheel", mass=10.0, inertia=(1.0, 1.0, 1.0))
    (strip,) = wavy_roads([m.build().initial])
    assert strip.surface is not None
    places = strip.surface[0]
    assert places[:, 0].min() < -0.3 and places[:, 0].max() > 0.3
    assert np.ptp(places[:, 1]) > 0.3
    assert np.allclose(places[:, 2], [road.level(x, y) for x, y, _ in places])


def test_mistakes_are_reported(tmp_path: Path) -> None:
    """Each names the remedy."""
    with pytest.raises(fx.ModelError, match="colour 'red' is not of the form"):
        fx.Box("A", None, (0, 0, 0), (1, 1, 1), colour="red")
    with pytest.raises(fx.ModelError, match="start and end coincide"):
        fx.Cylinder("A", None, (0, 0, 0), (0, 0, 0), 1.0)
    with pytest.raises(fx.ModelError, match=r"only \.stl and \.obj"):
        fx.Mesh("A", None, "x.step")
    with pytest.raises(fx.ModelError, match="give a file that can be read"):
        fx.Mesh("A", None, tmp_path / "none.stl")
    (tmp_path / "empty.obj").write_text("v 0 0 0\n")
    with pytest.raises(fx.ModelError, match="no triangles"):
        fx.Mesh("A", None, tmp_path / "empty.obj")
    (tmp_path / "cut.obj").write_text("v 0 0 0\nf 1 2 9\n")
    with pytest.raises(fx.ModelError, match="a vertex that does not exist"):
        fx.Mesh("A", None, tmp_path / "cut.obj")
    with pytest.raises(fx.ModelError, match="not a list of Sketch, Box"):
        fx.View(sketches=["box"])  # type: ignore[list-item]
    with pytest.raises(fx.ModelError, match="unknown"):
        scene_data(held().simulate(0.1, progress=False), frames=2, plots=["strut.elong"])
