"""Linear relations: the method of `Model` behind screws, racks, gears, belts and differentials."""

from __future__ import annotations

from collections.abc import Mapping

from flexel.base.arguments import number
from flexel.base.errors import ModelError
from flexel.declare.declarations import Declarations
from flexel.derive.spec import DeformationSpec, ElementSpec
from flexel.structure.instances import Instance
from flexel.structure.nodes import COMPONENTS


class RelationMethods(Declarations):
    """Linear relations among deformations and coordinates."""

    def relation(self, name: str, terms: Mapping[str, float]) -> tuple[str, ...]:
        """Relate deformations and coordinates linearly: Σ cᵢ (eᵢ - eᵢ as drawn) = 0, with counted turns.

        The relation is a deformation, ``name.relation``, rigid by default; its stress is the constraint force, and
        it can be prescribed, independent, or free with a spring, like every other.  Angles are counted over any
        number of turns.

        Parameters
        ----------
        name : str
        terms : mapping of name to float
            Coefficients cᵢ of deformations, of coordinates, or of the deformations of earlier relations.  The
            relation has the unit of its first term; the coefficients of the others convert theirs.

        Returns
        -------
        tuple of str
            The terms that were rigid by default and are free now.

        Raises
        ------
        ModelError
            No terms, an unknown name, a slip, a fixed coordinate, a coefficient that is zero or not finite.

        Examples
        --------
        A screw with a pitch of 5 mm per turn:

        >>> m.relation("screw", {"slide.along": 1.0, "hinge.angle": -0.005 / (2 * np.pi)})  # doctest: +SKIP
        """
        owner = f"relation '{name}'"
        if not isinstance(terms, Mapping) or not terms:
            raise ModelError(
                f"{owner}: terms {terms!r} are not coefficients by name; write {{'a.angle': 1.0, 'b.angle': -2.0}}"
            )
        found = {term: number(c, owner, f"coefficient of '{term}'") for term, c in terms.items()}
        units = {term: self._unit_of(term, owner) for term in found}
        if zero := [term for term, c in found.items() if c == 0]:
            raise ModelError(f"{owner}: the coefficient of '{zero[0]}' is zero; leave the term out")
        self._new_name(name, "relation")
        spec = ElementSpec(
            name="relation",
            digest="",
            doc="relation = sum of c (e - e as drawn)",
            source="",
            nodes=(),
            parameters=(),
            deformations=(DeformationSpec("relation", units[next(iter(found))], False),),
            slips=(),
            kernels={},
        )
        self.instances[name] = Instance(name, spec, (), {}, terms=found)
        held = {
            z: d.free
            for instance in self.instances.values()
            for z, d in zip(instance.deformations, instance.spec.deformations, strict=True)
        }
        return tuple(z for z in found if not held.get(z, True) and z not in self._roles)

    def _unit_of(self, term: str, owner: str) -> str:
        """Unit of a deformation or coordinate that may be a term of a relation."""
        kind, (part, _, component) = self._quantity_kind(term, owner), term.rpartition(".")
        if kind == "coordinate":
            node = self.nodes[part]
            if node.fixed[COMPONENTS[node.kind].index(component)]:
                raise ModelError(f"{owner}: '{term}' is fixed and does not change; leave it out")
            return node.unit
        if kind == "slip":
            raise ModelError(
                f"{owner}: '{term}' is a slip, which has a rate but no value; name a deformation"
            )
        element = self.instances[part]
        return element.spec.deformations[element.deformations.index(term)].unit
