"""The specification of what was derived: what the runtime reads of an element or a law."""

from flexel.derive.declare import Element, Law, Parameter
from flexel.derive.program.kernels import Derived
from flexel.derive.spec import (
    DeformationSpec,
    ElementSpec,
    InternalSpec,
    KernelSpec,
    LawSpec,
    NodeSpec,
    OutputSpec,
    ParameterSpec,
    SlipSpec,
)


def element_spec(element: Element, derived: Derived, digest: str) -> ElementSpec:
    """The specification of an element, with the digest of its C."""
    return ElementSpec(
        name=element.name,
        digest=digest,
        doc=element.doc,
        source=element.source,
        nodes=tuple(NodeSpec(node.name, node.kind) for node in element.nodes),
        parameters=_parameters(element.parameters),
        deformations=tuple(DeformationSpec(d.name, d.unit, d.angle, d.free) for d in element.deformations),
        slips=tuple(SlipSpec(s.name, s.unit, s.free) for s in element.slips),
        kernels=_kernels(derived),
    )


def law_spec(law: Law, derived: Derived, digest: str) -> LawSpec:
    """The specification of a law, with the digest of its C."""
    return LawSpec(
        name=law.name,
        digest=digest,
        doc=law.doc,
        deformations=len(law.e),
        slips=len(law.s),
        states=tuple(InternalSpec(z.name, z.unit) for z in law.states),
        parameters=_parameters(law.parameters),
        kernels=_kernels(derived),
    )


def _parameters(parameters: tuple[Parameter, ...]) -> tuple[ParameterSpec, ...]:
    return tuple(ParameterSpec(p.name, p.size, p.unit, p.doc) for p in parameters)


def _kernels(derived: Derived) -> dict[str, KernelSpec]:
    return {
        name: KernelSpec(
            tuple(k.inputs), tuple(OutputSpec(o.name, o.shape, o.nonzeros) for o in k.outputs), k.operations
        )
        for name, k in derived.kernels.items()
    }
