"""The pages of a cable: its element and its elastic law, built in or user-defined, and their parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from flexel.base.arguments import mapping, unknown
from flexel.base.errors import ModelError
from flexel.derive.spec import ElementSpec, LawSpec
from flexel.generated.table import ELEMENTS, LAWS
from flexel.model.instances import Code

REPORTED = ("arc_length", "tension", "strain", "curvature")  # outputs that results of cables and ropes read
ARGUMENTS = {  # what users of `Model.cable` call the parameters of the pages
    "l0": "length",
    "rhoA": "mass_per_length",
    "EA": "EA",
    "EI": "EI",
    "damping": "damping",
    "bending_damping": "bending_damping",
}
OPTIONAL = {"l0", "EA"}  # that a page need not take: the length is checked, and ropes are laid by EA


@dataclass(frozen=True)
class CablePages:
    """The element of a cable and its law, with their code where a user compiled them."""

    element: ElementSpec
    element_code: Code | None
    law: LawSpec
    law_code: Code | None

    def numbers(
        self, owner: str, given: Mapping[str, Any], further: Mapping[str, Any] | None
    ) -> tuple[dict[str, Any], dict[str, Any]]:
        """Return the parameters of the element and those of the law.

        Parameters
        ----------
        owner : str
        given : mapping of str to float
            By the names in `ARGUMENTS`; None and zero where nothing was given.
        further : mapping of str to array_like, optional
            Of a user's pages.

        Raises
        ------
        ModelError
            A number that neither page takes, one that is missing or given twice.
        """
        sizes = {p.name: p.size for p in (*self.element.parameters, *self.law.parameters)}
        further = mapping(further, owner, "parameters")
        for name in further:
            if name in ARGUMENTS:
                raise ModelError(
                    f"{owner}: '{name}' in parameters has a separate argument; give {ARGUMENTS[name]}=…"
                )
            if name not in sizes:
                raise ModelError(f"{owner}: {unknown(name, sizes, 'parameter')}")
        for name in given.keys() - sizes.keys() - OPTIONAL:
            if given[name]:
                raise ModelError(
                    f"{owner}: {ARGUMENTS[name]} is given, but neither page has a parameter '{name}': element "
                    f"'{self.element.name}', law '{self.law.name}'; leave it out"
                )
        values = {key: value for key, value in given.items() if value is not None} | dict(further)
        missing = [name for name in sizes if name not in values and name != "gravity"]
        if {"EA", "EI"} & set(missing):
            raise ModelError(
                f"{owner}: EA or EI is missing; give both (EI=0 for a chain), or section and material"
            )
        if missing:
            entries = ", ".join(f"'{name}': …" for name in missing)
            raise ModelError(f"{owner}: parameters of its pages are missing; give parameters={{{entries}}}")
        return _taken(self.element, values), _taken(self.law, values)


def cable_pages(owner: str, element: Any, law: Any, planar: bool) -> CablePages:
    """Return the pages of a cable: the built-in ones in place of None.

    Raises
    ------
    ModelError
        A page that does not describe a cable: the message says what to change.
    """
    own = ELEMENTS["planar_cable" if planar else "cable"]
    spec, element_code = own, None
    if element is not None:
        spec, element_code = _compiled(owner, element, ElementSpec, "element")
        _check_element(owner, spec, own)
    if law is not None:
        law_spec, law_code = _compiled(owner, law, LawSpec, "law")
        _check_law(owner, spec, law_spec)
        return CablePages(spec, element_code, law_spec, law_code)
    if [(d.name, d.unit) for d in spec.deformations] != [(d.name, d.unit) for d in own.deformations]:
        raise ModelError(
            f"{owner}: the deformations of element '{spec.name}' differ from those of the built-in cable, so its law "
            "does not apply; give a suitable one, law=fx.compile_law(…)"
        )
    return CablePages(spec, element_code, LAWS[f"{own.name}_stiffness"], None)


def _compiled(owner: str, given: Any, kind: type[Any], what: str) -> tuple[Any, Code]:
    """Return specification and code of what `flexel.compile_element` or `flexel.compile_law` returned."""
    spec = getattr(given, "spec", None)
    if not isinstance(spec, kind) or not hasattr(given, "code"):
        shown = getattr(given, "name", None) or spec
        named = getattr(shown, "name", shown) if shown is not None else f"{given!r:.40}"
        raise ModelError(
            f"{owner}: {what} '{named}' is not a compiled {what}; give the result of fx.compile_{what}(…)"
        )
    return spec, given.code


def _check_element(owner: str, spec: ElementSpec, own: ElementSpec) -> None:
    """Check that a user's element can be a cable: nodes, family, length, slips and outputs."""
    page, ends = f"{owner}: element '{spec.name}'", _words([node.kind for node in own.nodes])
    if [node.kind for node in spec.nodes] != [node.kind for node in own.nodes]:
        found = _words([node.kind for node in spec.nodes])
        raise ModelError(f"{page} has the nodes {found}; declare those of a cable: {ends}")
    if spec.family != own.family:
        raise ModelError(
            f"{page} is not declared as a cable; add family='cable' to its page, so that contacts and results find it"
        )
    if "l0" not in {parameter.name for parameter in spec.parameters}:
        raise ModelError(f"{page} has no parameter 'l0', its undeformed length; add it to its page")
    if spec.slips:
        raise ModelError(
            f"{page} has slips, on which no law of a cable acts; leave them out, or use m.element"
        )
    found_outputs = {output.name: output for output in spec.outputs}
    for name in REPORTED:
        if name not in found_outputs:
            unit = next(output.unit for output in own.outputs if output.name == name)
            raise ModelError(
                f"{page} reports no {name}; add Output('{name}', '{unit}', …) to its page, one value per point"
            )
    if len({found_outputs[name].shape for name in REPORTED}) > 1:
        raise ModelError(
            f"{page} reports {', '.join(REPORTED)} at different numbers of points; report them at the same ones"
        )


def _check_law(owner: str, element: ElementSpec, law: LawSpec) -> None:
    """Check that a user's law acts on the deformations of the element, all and in their order."""
    count = len(element.deformations)
    if law.slips or law.deformations != count:
        slips = f" and {law.slips} slips" if law.slips else ""
        raise ModelError(
            f"{owner}: law '{law.name}' acts on {law.deformations} deformations{slips}; element '{element.name}' has "
            f"{count}: {', '.join(d.name for d in element.deformations)}; declare a law of these"
        )


def _taken(spec: ElementSpec | LawSpec, values: Mapping[str, Any]) -> dict[str, Any]:
    """Return the values of the parameters of one page."""
    return {p.name: values[p.name] for p in spec.parameters if p.name in values}


def _words(kinds: Sequence[str]) -> str:
    return f"({', '.join(kind.replace('_', ' ') for kind in kinds)})"
