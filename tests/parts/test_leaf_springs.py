"""m.leaf_spring: beams in series, with nodes of clear names, between nodes or between places on bodies."""

import numpy as np
import pytest

import flexel as fx

L = 0.1
SECTION = fx.Rectangle(0.4e-3, 25e-3)


def bodies(planar: bool = False) -> fx.Model:
    """A fixed and a free body."""
    m = fx.Model()
    frame = m.angle if planar else m.frame
    for name, x in (("A", 0.0), ("B", L)):
        m.point(name, (x, 0) if planar else (x, 0, 0), fixed=name == "A")
        frame(f"R{name}", fixed=name == "A")
    return m


def tip(m: fx.Model) -> tuple[fx.State, fx.System]:
    """The equilibrium under a force on B."""
    system = m.build()
    return system.equilibrium(), system


def test_its_nodes_and_beams_have_clear_names() -> None:
    m = bodies()
    beams = m.leaf_spring("leaf", "A", "RA", "B", "RB", section=SECTION, material="steel", elements=3)
    assert beams == ("leaf beam 1", "leaf beam 2", "leaf beam 3")
    inner = [f"leaf {kind} {i}" for i in (1, 2) for kind in ("point", "frame")]
    assert list(m.nodes) == ["A", "RA", "B", "RB", *inner]
    assert m.nodes["leaf point 2"].x0 == pytest.approx([2 * L / 3, 0, 0])
    assert m.instances["leaf beam 2"].nodes == (
        "leaf point 1",
        "leaf frame 1",
        "leaf point 2",
        "leaf frame 2",
    )
    single = bodies().leaf_spring("leaf", "A", "RA", "B", "RB", section=SECTION, material="steel", elements=1)
    assert single == ("leaf",)


@pytest.mark.parametrize("planar", [False, True])
def test_it_is_the_chain_of_beams_that_one_would_write(planar: bool) -> None:
    load = ("B.y", 1.0)
    m = bodies(planar)
    m.leaf_spring("leaf", "A", "RA", "B", "RB", section=SECTION, material="steel", elements=3, damping=1e-4)
    m.load(*load)
    other = bodies(planar)
    nodes = [("A", "RA")]
    for i in (1, 2):
        other.point(f"P{i}", np.array([i * L / 3, 0.0, 0.0])[: 2 if planar else 3])
        (other.angle if planar else other.frame)(f"F{i}")
        nodes.append((f"P{i}", f"F{i}"))
    for i, (a, b) in enumerate(zip(nodes, [*nodes[1:], ("B", "RB")], strict=True)):
        other.beam(
            f"z{i}",
            *a,
            *b,
            direction=None if planar else (0, 1, 0),
            section=SECTION,
            material="steel",
            damping=1e-4,
        )
    other.load(*load)
    (own, system), (hand, chain) = tip(m), tip(other)
    assert own.position("B") == pytest.approx(hand.position("B"), abs=1e-10)
    assert own.position("leaf point 2") == pytest.approx(hand.position("P2"), abs=1e-10)
    damped = system.linearize(own).eigenvalues(), chain.linearize(hand).eigenvalues()
    slow = [np.sort_complex(roots[np.abs(roots) < 1e5]) for roots in damped]
    assert slow[0] == pytest.approx(slow[1], rel=1e-7)


def test_it_is_clamped_to_bodies_where_one_says() -> None:
    """Two leaf springs between a base and a shuttle whose points are elsewhere: 24 EI / L³."""
    m = fx.Model()
    m.point("base", (0, -0.3, 0), fixed=True)
    m.frame("wall", fixed=True)
    m.point("shuttle", (L, 0.2, 0.1))
    m.frame("table")
    for name, y in (("left", 0.0), ("right", 0.06)):
        m.leaf_spring(
            name,
            "base",
            "wall",
            "shuttle",
            "table",
            start=(0, y, 0),
            end=(L, y, 0),
            direction=(0, 1, 0),
            section=SECTION,
            material="steel",
            flexible=["bend3", "bend4"],
        )
    assert m.nodes["left start"].fixed.all()
    assert "left end clamp" in m.instances and "left start clamp" not in m.instances
    m.release(*m.constraint_report().release)
    EI = 210e9 * SECTION.Iz
    shear = 12 * EI / (SECTION.shear_factors(0.3)[0] * 210e9 / 2.6 * SECTION.A * L**2)
    k = m.build().compliance("shuttle", "table").stiffness()["y"]
    assert k == pytest.approx(24 * EI / L**3 / (1 + shear), rel=1e-9)


def test_a_refused_leaf_leaves_the_model_as_it_was() -> None:
    m = bodies()
    for values, message in (
        ({"elements": 0}, "leaf spring 'leaf': elements 0; give a whole number"),
        ({"elements": 2.5}, "leaf spring 'leaf': elements 2.5 is not a whole number"),
        ({"end": (0, 0, 0)}, "leaf spring 'leaf': its two points coincide"),
        ({"end": (0, 0)}, "point 'leaf end': place .* give 3 numbers"),
        ({"direction": (1, 0, 0)}, "leaf spring 'leaf': direction .* is parallel to the axis"),
        ({"flexible": ["bend1"]}, "beam 'leaf beam 1': flexible has only one of bend1 and bend2"),
        ({"section": 3}, "beam 'leaf beam 1': 3 is not a section"),
        ({"q": "Z"}, "leaf spring 'leaf': unknown node 'Z'"),
        ({"frame_q": "B"}, "leaf spring 'leaf': node 'B' is a point; it needs a frame"),
    ):
        given = {
            "p": "A",
            "frame_p": "RA",
            "q": "B",
            "frame_q": "RB",
            "section": SECTION,
            "material": "steel",
        }
        with pytest.raises(fx.ModelError, match=message):
            m.leaf_spring("leaf", **(given | values))  # type: ignore[arg-type]
        assert list(m.nodes) == ["A", "RA", "B", "RB"] and not m.instances
    with pytest.raises(fx.ModelError, match="a planar leaf spring bends in its plane and has no direction"):
        bodies(True).leaf_spring(
            "leaf", "A", "RA", "B", "RB", section=SECTION, material="steel", direction=(0, 1, 0)
        )


def test_its_sections_warp_along_one_line_of_nodes() -> None:
    m = bodies()
    clamps = [m.warping(name, fixed=True) for name in ("first", "last")]
    beams = m.leaf_spring(
        "leaf", "A", "RA", "B", "RB", section=SECTION, material="steel", elements=3, warping=clamps
    )
    assert [m.instances[beam].nodes[4:] for beam in beams] == [
        ("first", "leaf warping 1"),
        ("leaf warping 1", "leaf warping 2"),
        ("leaf warping 2", "last"),
    ]
    own = bodies()
    own.leaf_spring("leaf", "A", "RA", "B", "RB", section=SECTION, material="steel", elements=2, warping=True)
    assert own.instances["leaf beam 2"].nodes[4:] == ("leaf warping 1", "leaf_warping_q")
    with pytest.raises(fx.ModelError, match="leaf spring 'leaf': warping 'clamped' is neither True nor two"):
        bodies().leaf_spring(
            "leaf", "A", "RA", "B", "RB", section=SECTION, material="steel", warping="clamped"
        )


def test_a_planar_one_has_no_warping() -> None:
    m = bodies(planar=True)
    with pytest.raises(fx.ModelError, match="a planar beam has no warping; drop warping="):
        m.leaf_spring("leaf", "A", "RA", "B", "RB", section=SECTION, material="steel", warping=True)
    assert list(m.nodes) == ["A", "RA", "B", "RB"]
