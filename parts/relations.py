"""Linear relations: the part behind screws, racks, gears, belts and differentials."""

from __future__ import annotations

from collections.abc import Mapping

from flexel.base.arguments import number
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry
from flexel.derive.spec import DeformationSpec, ElementSpec
from flexel.model.instances import Instance
from flexel.model.lowering import Lowering
from flexel.model.node import COMPONENTS
from flexel.model.part import Part, part


@part
class Relation(Part[tuple[str, ...]]):
    """Relate deformations and coordinates linearly: Σ cᵢ (eᵢ - eᵢ as drawn) = 0, with counted turns.

    The relation is a deformation, ``name.relation``, rigid by default; its stress is the constraint force, and
    it can be prescribed, independent, or free with a spring, like any other.  Angles are counted over any
    number of turns.

    Returns
    -------
    tuple of str
        The terms that were rigid by default and are now free.

    Raises
    ------
    ModelError
        No terms, an unknown name, a slip, a fixed coordinate, a coefficient that is zero or not finite.

    Examples
    --------
    A screw with a pitch of 5 mm per turn:

    >>> m.relation("screw", {"slide.along": 1.0, "hinge.angle": -0.005 / (2 * np.pi)})  # doctest: +SKIP
    """

    name: str = entry("Name of the relation; its deformation is ``name.relation``.")
    terms: Mapping[str, float] = array_quantity(
        "",
        "Coefficients cᵢ of deformations, of coordinates, or of the deformations of earlier relations, by name.  The "
        "relation has the unit of its first term; the coefficients of the others convert theirs.",
    )

    def lower(self, to: Lowering) -> tuple[str, ...]:
        """Add the relation."""
        if not isinstance(self.terms, Mapping) or not self.terms:
            raise ModelError(
                f"{self.owner}: terms {self.terms!r} are not coefficients by name; write "
                "{'a.angle': 1.0, 'b.angle': -2.0}"
            )
        found = {term: number(c, self.owner, f"coefficient of '{term}'") for term, c in self.terms.items()}
        units = {term: _unit_of(to, term, self.owner) for term in found}
        if zero := [term for term, c in found.items() if c == 0]:
            raise ModelError(f"{self.owner}: the coefficient of '{zero[0]}' is zero; leave the term out")
        to.new_name(self.name, "relation")
        spec = _spec(units[next(iter(found))])
        to.instances[self.name] = Instance(self.name, spec, (), {}, terms=found)
        held = {
            name: deformation.free
            for instance in to.instances.values()
            for name, deformation in zip(instance.deformations, instance.spec.deformations, strict=True)
        }
        return tuple(term for term in found if not held.get(term, True) and term not in to.roles)


def _spec(unit: str) -> ElementSpec:
    """Specify a relation in a unit: one deformation, no nodes and no code."""
    return ElementSpec(
        name="relation",
        digest="",
        doc="relation = sum of c (e - e as drawn)",
        source="",
        nodes=(),
        parameters=(),
        deformations=(DeformationSpec("relation", unit, False),),
        slips=(),
        kernels={},
    )


def _unit_of(to: Lowering, term: str, owner: str) -> str:
    """Return the unit of a deformation or coordinate that may be a term of a relation."""
    kind, (name, _, component) = to.quantity_kind(term, owner), term.rpartition(".")
    if kind == "coordinate":
        node = to.nodes[name]
        if node.fixed[COMPONENTS[node.kind].index(component)]:
            raise ModelError(f"{owner}: '{term}' is fixed and does not change; leave it out")
        return node.unit
    if kind == "slip":
        raise ModelError(f"{owner}: '{term}' is a slip, which has a rate but no value; name a deformation")
    return to.unit_of(term)
