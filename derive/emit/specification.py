"""The specification of a derived element or law: what the runtime reads of it."""

from sympy import Expr

from flexel.derive.declare import TIME, Deformation, Element, Law, Parameter
from flexel.derive.declare.law import begin_terms
from flexel.derive.declare.output import ValidRange
from flexel.derive.declare.winding import period_terms
from flexel.derive.declare.words import ARMS, MATRIX_SIGNS
from flexel.derive.program.kernel_outputs import Derived
from flexel.derive.spec import (
    ArgumentSpec,
    BeginSpec,
    DeformationSpec,
    ElementSpec,
    InternalSpec,
    KernelSpec,
    LawSpec,
    LimitSpec,
    NodeSpec,
    OutputSpec,
    ParameterSpec,
    SlipSpec,
    TermSpec,
)


def element_spec(element: Element, derived: Derived, digest: str) -> ElementSpec:
    """Return the specification of an element, with the digest of its C."""
    return ElementSpec(
        name=element.name,
        digest=digest,
        doc=element.doc,
        source=element.source,
        nodes=tuple(NodeSpec(node.name, node.kind) for node in element.nodes),
        parameters=_parameters(element.parameters),
        deformations=tuple(_deformation(d, element.parameters) for d in element.deformations),
        slips=tuple(SlipSpec(s.name, s.unit, s.free) for s in element.slips),
        kernels=_kernels(derived) | _outputs(element, derived),
        family=element.family,
        picture=element.picture,
        span=element.span,
        arm=element.family in ARMS,
    )


def law_spec(law: Law, derived: Derived, digest: str) -> LawSpec:
    """Return the specification of a law, with the digest of its C."""
    return LawSpec(
        name=law.name,
        digest=digest,
        doc=law.doc,
        deformations=len(law.e),
        slips=len(law.s),
        states=tuple(InternalSpec(state.name, state.unit, state.lasting) for state in law.states),
        parameters=_parameters(law.parameters),
        kernels=_kernels(derived),
        limit=_limit(law),
        begins=tuple(_begin(law, expr) for expr in law.begins),
        arguments=_arguments(law),
        timed=_is_timed(law),
    )


def _deformation(d: Deformation, parameters: tuple[Parameter, ...]) -> DeformationSpec:
    period = tuple(TermSpec(*term) for term in period_terms(d, parameters))
    return DeformationSpec(d.name, d.unit, d.free, period, d.kind, d.kinked)


def _is_timed(law: Law) -> bool:
    """Whether the time appears in a law."""
    rates = (state.rate for state in law.states)
    expressions = (*law.sigma, *law.tau, *rates, *(expr for _, expr in law.let))
    return any(TIME in expr.free_symbols for expr in expressions)


def _arguments(law: Law) -> tuple[ArgumentSpec, ...]:
    names = [symbol.name for symbol in (*law.e, *law.s)]
    return tuple(map(ArgumentSpec, names, law.units or [""] * len(names)))


def _limit(law: Law) -> LimitSpec | None:
    if law.limit is None:
        return None
    (found,) = (p for p in law.parameters if law.limit.parameter in p.symbols)
    return LimitSpec(found.name, found.symbols.index(law.limit.parameter), law.limit.beyond)


def _begin(law: Law, expr: Expr) -> BeginSpec:
    return BeginSpec(*(tuple(TermSpec(*term) for term in terms) for terms in begin_terms(law, expr)))


def _sign(parameter: Parameter) -> tuple[str, ...]:
    """Return one word for each component; none where all may be anything."""
    sign = parameter.sign
    if sign == "any":
        return ()
    return sign if isinstance(sign, tuple) else (sign,) if sign in MATRIX_SIGNS else (sign,) * parameter.size


def _parameters(parameters: tuple[Parameter, ...]) -> tuple[ParameterSpec, ...]:
    return tuple(ParameterSpec(p.name, p.size, p.unit, p.doc, _sign(p)) for p in parameters)


def _kernels(derived: Derived) -> dict[str, KernelSpec]:
    return {
        name: KernelSpec(
            tuple(k.inputs), tuple(OutputSpec(o.name, o.shape, o.nonzeros) for o in k.outputs), k.operations
        )
        for name, k in derived.kernels.items()
    }


def _outputs(element: Element, derived: Derived) -> dict[str, KernelSpec]:
    """Return the kernel of the outputs, if there are any, with their units and what is drawn of them."""
    if not element.outputs:
        return {}
    kernel = derived.kernels["outputs"]
    arrays = tuple(
        OutputSpec(
            array.name,
            array.shape,
            array.nonzeros,
            output.unit,
            output.draws,
            output.carrier,
            *((output.limit, output.beyond) if isinstance(output, ValidRange) else ()),
        )
        for array, output in zip(kernel.outputs, element.outputs, strict=True)
    )
    return {"outputs": KernelSpec(kernel.inputs, arrays, kernel.operations)}
