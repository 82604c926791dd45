"""Mistakes in what statics, buckling and vibrations are given."""

from coarse import COARSE_MESH
from mistakes import Case, check, drawing, each

from flexel.base.errors import DynamicsError
from flexel.results.system_facade import System


def strut() -> System:
    """A column of one flexible beam."""
    m = drawing()
    section = {"EA": 10.0, "GJ": 1.0, "EIy": 1.0, "EIz": 1.0}
    m.beam("b", "O", "R0", "A", "R1", **section, mass_per_length=1.0, inertia_per_length=(1, 1, 1))
    return m.build()


STATICS = {
    "of another model": Case(
        lambda: strut().equilibrium(start=strut().at_rest), ("equilibrium", "another model", "of this one")
    ),
    "from a number": Case(lambda: strut().equilibrium(start=3), ("int is not a state", "system.initial")),
    "at a text": Case(lambda: strut().equilibrium(t="a"), ("time t", "give real")),
    "path to a text": Case(lambda: strut().static_path(t_end="a"), ("t_end", "give real")),
    "path to nowhere": Case(lambda: strut().static_path(t_end=0.0), ("t_end", "give another")),
    "path that holds a text": Case(
        lambda: strut().static_path(t_end=1.0, hold="A.x"), ("static_path: hold", "write ['…'")
    ),
    "path that holds a support": Case(
        lambda: strut().static_path(t_end=1.0, hold=["O.x"]),
        ("static_path: 'O.x'", "cannot be held", "drop it"),
    ),
    "buckling without load": Case(lambda: strut().buckling(increment={}), ("buckling", "name at least one")),
    "buckling under no load": Case(
        lambda: strut().buckling(increment={"A.x": 0.0}), ("buckling", "name at least")
    ),
    "buckling under an unknown load": Case(
        lambda: strut().buckling(increment={"A": -1.0}), ("buckling", "'A'", "did you mean A.")
    ),
    "buckling under a load on a support": Case(
        lambda: strut().buckling(increment={"O.x": -1.0}), ("'O.x'", "fixed", "name another")
    ),
    "buckling under a text": Case(lambda: strut().buckling(increment={"A.x": "a"}), ("'A.x'", "give real")),
    "buckling under a list": Case(lambda: strut().buckling(increment=["A.x"]), ("buckling", "by name")),
    "no modes": Case(lambda: strut().vibrations(count=0), ("vibrations", "1 or more")),
    "modes as text": Case(lambda: strut().vibrations(count="a"), ("vibrations", "whole number")),
    "steady of a text": Case(lambda: strut().steady(unknown="b.bend1"), ("steady", "write ['…'")),
    "stability as a text": Case(lambda: strut().equilibrium(stable="yes"), ("stable", "True nor False")),
    "free fall": Case(
        lambda: _falling().equilibrium(), ("nothing resists", "'A.", "support it"), DynamicsError
    ),
}


def _falling() -> System:
    m = drawing()
    m.fix("R1")
    m.point_mass("b", "A", 1.0)
    return m.build()


@COARSE_MESH
@each(STATICS)
def test_a_mistake_in_statics_is_named_with_its_remedy(case: Case) -> None:
    check(case)
