"""Solids and meshes carried by bodies, and what holds a model: springs, dampers, guides, loads, roads of waves."""

import base64
import struct
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

import flexel as fx
from flexel.derive.declare import Deformation, Element, Parameter, Point
from flexel.pictures.drawing import loads, shapes
from flexel.pictures.meshes import read_mesh
from flexel.pictures.shape import Shape
from flexel.pictures.view import scene_data
from flexel.pictures.wavy_roads import wavy_roads

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
    (found,) = (z for z in shapes(state, [mesh]) if z.style == "solid")
    assert found.pose is not None and found.surface is not None
    places = found.pose[0] + found.surface[0] @ found.pose[1].T
    assert places.max(axis=0) == pytest.approx((0, 0.501, 0.001), abs=1e-12)
    motion = system.simulate(0.1, progress=False)
    scene = scene_data(motion, frames=3, view=fx.View(sketches=[mesh]))
    assert [z["colour"] for z in scene["shapes"] if z["style"] == "solid"] == ["#8fa3b3"]
    assert not any(z["style"] == "box" for z in scene["shapes"])  # the solid replaces the box of inertia


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
    return {z.name: z for z in found if z.style == style}


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
    between = [z for z in springs.values() if np.allclose(z.lines[0], [(0.2, -0.5, 0), (0.8, -0.5, 0)])]
    assert len(between) == 1
    assert set(of(found, "spiral")) == {"pivot"}
    assert set(of(found, "slide")) == {"B"}
    (arrow,) = loads(state, system.loads)
    assert arrow.force is not None and np.allclose(arrow.force, (3, 0, 0))
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
        state, x=state.x + np.array([0.01 * (z == "A.x") for z in state.structure.names[-state.x.size :]])
    )
    before, after = ([z.lines[0] for z in shapes(s) if z.style == "spring"] for s in (state, moved))
    assert len(before) == 2
    assert np.allclose(after[0][1] - before[0][1], (0.01, 0, 0)) and np.allclose(after[0][0], before[0][0])
    assert np.allclose(before[1][1] - before[1][0], (0, before[1][1][1] - before[1][0][1], 0))


@pytest.mark.parametrize(("picture", "style"), [("mass", "mass"), ("beam", "bar")])
def test_a_users_element_has_the_picture_of_its_page(picture: str, style: str) -> None:
    """A mark where it asks for one; one that lacks what a beam shows is a line."""
    truss = fx.compile_element(stretch(f"user_{picture}", picture))
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.element("mine", truss, "O", "A", l0=1.0)
    m.point_mass("mass", "A", 1.0)
    m.spring("mine.e", 10.0)
    found = shapes(m.build().initial)
    assert [z.style for z in found if z.name == "mine"] == [style]


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


def test_a_guide_is_as_long_as_what_slides_goes() -> None:
    """Its rail is the same at all frames and holds the slider at each."""
    motion = held().simulate(1.0, progress=False)
    scene = scene_data(motion, frames=41)
    rails = [z for z in scene["shapes"] if z["style"] == "guide"]
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
    with pytest.raises(fx.ModelError, match="a vertex that is not there"):
        fx.Mesh("A", None, tmp_path / "cut.obj")
    with pytest.raises(fx.ModelError, match="not a list of Sketch, Box"):
        fx.View(sketches=["box"])  # type: ignore[list-item]
    with pytest.raises(fx.ModelError, match="unknown"):
        scene_data(held().simulate(0.1, progress=False), frames=2, plots=["strut.elong"])
