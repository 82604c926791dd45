"""Every number of every kind of part: a variant equals the model that is built anew with the other number.

All numbers of the models of `declared_models` are changed, one at a time, through `with_parameters` on one side and in
the field of the part on the other.  Both sides are refused with the same words, or both have equal numbers in all
elements and laws, equal initial states, loads and eigenvalues, and equal motions where they are short to compute.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from declared_models import KINDS, OTHERS
from longer import longer
from optional_numbers import OPTIONAL
from varied_parts import (
    Path,
    field_at,
    fields_of,
    held_at,
    in_kind,
    model_with,
    numbers,
    numeric,
    other_value,
)

import flexel as fx
from flexel.mechanics.inertia import InertiaError
from flexel.model.part import Part
from flexel.parts.method import METHOD_OF
from flexel.parts.roles import Independent, Kinematic

LARGE = {"guide", "pivot", "forks", "roped"}  # of kinds of parts that are among the others, too
WHOLE = {name: make for name, make in OTHERS.items() if name not in LARGE} | OPTIONAL
ALL = KINDS | WHOLE
MOVED = {"gear", "spring", "controller", "prescribe", "load", "tabulated", "incline"}
pytestmark = pytest.mark.filterwarnings("ignore")

# Numbers that are no parameters, by kind of part and field, with the reason.
FIXED = {
    ("cable_line", "n"): "a count of elements",
    ("chain", "n"): "a count of links",
    ("rope", "n"): "a count of elements",
    ("leaf_spring", "elements"): "a count of beams",
    ("contact", "points"): "a count of points of contact",
    ("rope", "points"): "a count of points of contact",
    ("rope_contact", "points"): "a count of points of contact",
    ("gear", "teeth"): "counts of teeth",
    ("tyre", "count"): "a count of waves",
    ("spring", "pieces"): "a curve, which is given as a whole",
    ("spring", "breaks"): "a curve, which is given as a whole",
    ("look", "diameter"): "for pictures only",
    ("look", "colour"): "for pictures only",
    ("look", "opacity"): "for pictures only",
}  # fmt: skip

# Fields with a unit that are no parameters, by class and field, with the reason.
NOT_VARIED = {("LookPart", "opacity"): "for pictures only"}

# Numbers whose change adds nodes, elements or laws, by kind of part and field, with what is added.
LAYOUT = {
    ("hinge", "damping"): "a law, where there was no damping",
    ("revolute", "damping"): "a law, where there was no damping",
    ("prismatic", "damping"): "a law, where there was no damping",
    ("contact", "friction"): "slips, where there was no friction",
    ("rope", "friction"): "slips, where there was no friction",
    ("rope_contact", "friction"): "slips, where there was no friction",
    ("rigid_body", "position"): "a point, where a joint was at the body's own point",
    ("wheel", "crown"): "another element, where the wheel was a disc",
    ("revolute", "at"): "a point, where the pin was at the body's own point",
    ("cam", "at"): "a point, where the roller was at the body's own point",
    ("cam", "centre"): "a point, where the centre was at the body's own point",
}


def varied(m: fx.Model, name: str) -> Iterator[tuple[int, Path]]:
    """Numbers of the parts that a model is there for: those of the kind, or all of other models."""
    for i, part in enumerate(m.parts):
        if name in WHOLE or METHOD_OF[type(part)] == name:
            yield from ((i, path) for path, _ in numbers(part))


def field_of(part: Part[Any], path: Path) -> tuple[str, str]:
    return METHOD_OF[type(part)], path[-1] if path[0] not in ("terms", "points") else path[0]


@pytest.mark.parametrize("name", longer(ALL, "own pages", "wound", "rolling"))
def test_a_variant_of_every_number_equals_the_model_built_anew(name: str) -> None:
    m = ALL[name]()
    s = anew(m, m.build())
    assert s.origin is not None
    named = {(number.part, number.path): label for label, number in s.origin.numbers.items()}
    for i, path in varied(m, name):
        part = m.parts[i]
        if field_of(part, path) in FIXED:
            assert (i, path) not in named
            continue
        check_number(m, s, part, path, named[i, path], moved=name in MOVED)


def test_every_number_of_every_part_is_varied() -> None:
    """Some model above gives each of them, also within sections, materials and the like, with another one valid."""
    wanted = fields_of(METHOD_OF) | fields_of(getattr(fx, name) for name in fx.__all__ if name[0].isupper())
    left = set(wanted)
    for name, make in ALL.items():
        m = make()
        for i, path in varied(m, name):
            if (field := field_at(m.parts[i], path)) in left and can_vary(m, i, path):
                left.remove(field)
    assert left == set(NOT_VARIED)


def can_vary(m: fx.Model, i: int, path: Path) -> bool:
    """Whether a part takes another number, which is a parameter."""
    part = m.parts[i]
    held = held_at(part, path)
    if field_of(part, path) in FIXED:
        return False
    try:
        model_with(m, part, path, in_kind(held, other_value(*field_at(part, path), held)))
    except fx.ModelError:
        return False
    return True


def check_number(m: fx.Model, s: fx.System, part: Part[Any], path: Path, name: str, moved: bool) -> None:
    """One number changed on both sides."""
    held = held_at(part, path)
    assert numeric(held)
    value = other_value(*field_at(part, path), held)
    try:
        other = model_with(m, part, path, in_kind(held, value)).build()
    except fx.FlexelError as error:
        with pytest.raises(type(error)) as raised:
            s.with_parameters({name: value.ravel()})
        assert same_words(raised.value, error)
        return
    try:
        variant = s.with_parameters({name: value.ravel()})
    except fx.ModelError as error:
        assert field_of(part, path) in LAYOUT, error
        assert f"'{name}' changes which nodes, elements or laws the model has" in str(error)
        return
    assert_equal_systems(variant, other, name)
    if moved:
        a, b = (system.simulate(0.02, samples=3) for system in (variant, other))
        scale = np.abs(b.x).max()
        np.testing.assert_allclose(a.x, b.x, rtol=0, atol=1e-12 * scale, err_msg=name)


def anew(m: fx.Model, s: fx.System) -> fx.System:
    """The model built with the degrees of freedom of a system, which a model with another number may not choose."""
    if s.dynamic:
        m.add(Independent([name for name in s.dynamic if name not in (m.lowering.dynamic or ())]))
    if s.kinematic:
        m.add(Kinematic(s.kinematic))
    return m.build()


def same_words(error: Exception, wanted: Exception) -> bool:
    """Whether the refusal of a variant says what that of the part says."""
    return str(error).removeprefix("with_parameters: ") == str(wanted)


def assert_equal_systems(a: fx.System, b: fx.System, name: str) -> None:
    """Equal numbers in elements, laws and parts, equal starts and loads, and equal eigenvalues."""
    for own, other in (
        *zip(a.structure.instances, b.structure.instances, strict=True),
        *zip(a.structure.laws, b.structure.laws, strict=True),
    ):
        np.testing.assert_array_equal(own.p, other.p, err_msg=f"{name}: {own.name}")
    assert [law.z0 for law in a.structure.laws] == [law.z0 for law in b.structure.laws]
    given, wanted = a.parameters, b.parameters
    assert list(given) == list(wanted)
    for label, value in given.items():
        np.testing.assert_array_equal(value, wanted[label], err_msg=f"{name}: {label}")
    assert (a.dynamic, a.kinematic) == (b.dynamic, b.kinematic)
    start, again = a.unaccelerated, b.unaccelerated
    np.testing.assert_allclose(start.x, again.x, rtol=0, atol=1e-13 * max(1.0, np.abs(again.x).max()))
    np.testing.assert_allclose(start.v, again.v, rtol=0, atol=1e-13 * max(1.0, np.abs(again.v).max()))
    one, two = matrices(a), matrices(b)
    assert one.keys() == two.keys()
    for key in two:
        scale = max(np.abs(two[key]).max(initial=0.0), 1e-300)
        np.testing.assert_allclose(one[key], two[key], rtol=0, atol=1e-13 * scale, err_msg=f"{name}: {key}")


def matrices(s: fx.System) -> dict[str, Any]:
    """M, C and K at the start; nothing for a model that has parts without mass."""
    try:
        lin = s.linearize()
    except InertiaError:
        return {}
    return {key: np.asarray(getattr(lin, key)) for key in "MCK"}
