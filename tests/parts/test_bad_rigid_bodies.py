"""Bodies and joints that cannot be made are refused by name; models with bodies are copied and sent."""

import pickle
from collections.abc import Callable

import pytest
from joined import AT, AXIS, two_bodies

import flexel as fx


@pytest.mark.parametrize(
    ("words", "call"),
    [
        (
            "revolute 'z': unknown rigid body 'c'; known: a, b, d, ground",
            lambda m: m.revolute("z", "a", "c", AT, AXIS),
        ),
        (
            "revolute 'z': both its bodies are the ground",
            lambda m: m.revolute("z", "ground", "ground", AT, AXIS),
        ),
        ("revolute 'z': both its bodies are 'a'", lambda m: m.revolute("z", "a", "a", AT, AXIS)),
        ("revolute 'z': in space it needs an axis", lambda m: m.revolute("z", "a", "b", AT)),
        ("revolute 'z': at .* has shape", lambda m: m.revolute("z", "a", "b", (0, 0), AXIS)),
        ("revolute 'z': 3 is not a body", lambda m: m.revolute("z", "a", 3, AT, AXIS)),
        ("revolute 'a': this name is taken", lambda m: m.revolute("a", "a", "b", AT, AXIS)),
        ("prismatic 'z': axis .* has no length", lambda m: m.prismatic("z", "a", "b", (0, 0, 0))),
        ("screw 'z': pitch 0 lets the nut turn", lambda m: m.screw("z", "a", "b", AT, AXIS, pitch=0.0)),
        ("universal joint 'z': its pins are parallel", lambda m: m.universal("z", "a", "b", AT, AXIS, AXIS)),
        ("joint 'z': friction 3 are not numbers", lambda m: m.revolute("z", "a", "b", AT, AXIS, friction=3)),
        ("rigid body 'ground': the ground already exists", lambda m: m.rigid_body("ground", (0, 0, 0))),
        ("rigid body 'z': mass is given without inertia", lambda m: m.rigid_body("z", (0, 0, 0), mass=1.0)),
        ("body 'z_body': .* triangle", lambda m: m.rigid_body("z", (0, 0, 0), mass=1.0, inertia=(1, 1, 3))),
        ("point 'a': this name is taken", lambda m: m.rigid_body("a", (0, 0, 0))),
    ],
)
def test_what_cannot_be_joined_is_refused_by_name_and_leaves_the_model_as_it_was(
    words: str, call: Callable[[fx.Model], object]
) -> None:
    m = two_bodies(lambda m: None)
    m.rigid_body("d", (0, 0, 0))
    before = [*m.nodes, *m.instances, *m.lowering.rigid_bodies, *m.lowering.roles]
    with pytest.raises(fx.ModelError, match=words):
        call(m)
    assert [*m.nodes, *m.instances, *m.lowering.rigid_bodies, *m.lowering.roles] == before


@pytest.mark.parametrize(
    "kind", ["spherical", "universal", "cylindrical", "planar_joint", "screw", "cardan_chain"]
)
def test_planar_bodies_are_told_what_to_use_instead(kind: str) -> None:
    m = fx.Model()
    m.rigid_body("a", (0, 0))
    m.rigid_body("b", (1, 0))
    calls: dict[str, Callable[[], object]] = {
        "spherical": lambda: m.spherical("z", "a", "b", (0, 0)),
        "universal": lambda: m.universal("z", "a", "b", (0, 0), AXIS, AXIS),
        "cylindrical": lambda: m.cylindrical("z", "a", "b", (0, 0), AXIS),
        "planar_joint": lambda: m.planar_joint("z", "a", "b", AXIS),
        "screw": lambda: m.screw("z", "a", "b", (0, 0), AXIS, pitch=0.1),
        "cardan_chain": lambda: m.cardan_chain("x", "y", "z", body="b", base="a"),
    }
    with pytest.raises(fx.ModelError, match="'z': .*planar"):
        calls[kind]()


def test_a_planar_and_a_spatial_body_do_not_meet() -> None:
    m = fx.Model()
    m.rigid_body("a", (0, 0))
    m.rigid_body("b", (1, 0, 0))
    with pytest.raises(fx.ModelError, match="revolute 'z': one of 'a' and 'b' is planar and one spatial"):
        m.revolute("z", "a", "b", (0, 0))


@pytest.mark.parametrize("planar", [True, False], ids=["plane", "space"])
@pytest.mark.parametrize("first", [True, False], ids=["node first", "joint first"])
def test_a_fixed_node_may_be_called_ground(planar: bool, first: bool) -> None:
    m, zero = fx.Model(), (0, 0) if planar else (0, 0, 0)
    inertia = 1.0 if planar else (1, 1, 1)
    m.rigid_body("a", zero, mass=1.0, inertia=inertia)
    if not first:
        m.revolute("z", "ground", "a", zero, axis=None if planar else AXIS)
    fixed = m.angle("ground", fixed=True) if planar else m.frame("ground", fixed=True)
    if first:
        m.revolute("z", "ground", "a", zero, axis=None if planar else AXIS)
    shelf = m.rigid_body("b", zero, mass=1.0, inertia=inertia)
    m.weld("w", (m.point("O", zero, fixed=True), fixed), shelf, at=zero)
    assert m.build().dynamic == ("z.angle",)


def test_the_ground_of_a_joint_is_no_node_that_can_move() -> None:
    m = fx.Model()
    m.rigid_body("a", (0, 0, 0), mass=1.0, inertia=(1, 1, 1))
    m.frame("ground")
    with pytest.raises(fx.ModelError, match="revolute 'z': the node 'ground' of this model can move"):
        m.revolute("z", "ground", "a", (0, 0, 0), axis=AXIS)
    m.fix("ground")
    m.revolute("z", "ground", "a", (0, 0, 0), axis=AXIS)
    assert m.build().dynamic == ("z.angle",)


def test_names_of_the_nodes_of_the_ground_are_taken_once() -> None:
    m = fx.Model()
    m.rigid_body("a", (0, 0), mass=1.0, inertia=1.0)
    place, turned = m.point("ground_point", (0, 0), fixed=True), m.angle("other", fixed=True)
    with pytest.raises(fx.ModelError, match="revolute 'z': 'ground_point' is already a name in this model"):
        m.revolute("z", "ground", "a", (0, 0))
    m.revolute("z", (place, turned), "a", (0, 0))
    assert m.build().dynamic == ("z.angle",)


def test_a_model_with_bodies_travels_in_a_pickle() -> None:
    m = two_bodies(lambda m: m.spherical("j", "a", "b", AT))
    other = pickle.loads(pickle.dumps(m))
    other.revolute("pivot", "ground", "a", at=(0, 0, 0), axis=AXIS)
    assert other.build().counts["degrees_of_freedom"] == 4
    foreign = other.rigid_body("e", (0, 0, 1))
    m.rigid_body("e", (0, 0, 1))
    with pytest.raises(fx.ModelError, match="weld 'z': the body 'e' belongs to another model"):
        m.weld("z", "a", foreign)
