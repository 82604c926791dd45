"""The formulas of a definition, as plain text and as LaTeX."""

from collections.abc import Iterator

import sympy as sp

from flexel.derive.declare import Element, Law

Formula = tuple[str, str, sp.Basic]  # left side as text and as LaTeX, right side


def formulas(declared: Element | Law) -> list[Formula]:
    """Return named intermediates, then what the definition declares; energies that are zero are left out."""
    found: list[Formula] = [(s.name, _name(s), sp.sympify(expr)) for s, expr in declared.let]
    return [*found, *(_of_law(declared) if isinstance(declared, Law) else _of_element(declared))]


def _of_element(element: Element) -> Iterator[Formula]:
    for d in element.deformations:
        yield d.name, _indexed("e", d.name), sp.sympify(d.expr)
    for slip in element.slips:
        yield slip.name, _indexed("s", slip.name), sp.sympify(slip.expr)
    for name, energy in (("T", element.kinetic_energy), ("U", element.potential)):
        if energy != 0:
            yield name, name, sp.sympify(energy)
    for output in element.outputs:
        yield output.name, rf"\mathrm{{{_escaped(output.name)}}}", sp.sympify(output.values)


def _of_law(law: Law) -> Iterator[Formula]:
    for letter, on, stresses in (("sigma", law.e, law.sigma), ("tau", law.s, law.tau)):
        for symbol, stress in zip(on, stresses, strict=True):
            yield f"{letter}_{symbol}", rf"\{letter}_{{{_name(symbol)}}}", sp.sympify(stress)
    for state in law.states:
        yield f"{state.name}'", _dotted(_name(state.symbol)), sp.sympify(state.rate)
    if law.energy != 0:
        yield "U", "U", sp.sympify(law.energy)


def as_text(declared: Element | Law) -> str:
    """Return one line for each formula; of outputs with several components, only that they are such."""
    lines = []
    for name, _, expr in formulas(declared):
        shape = "×".join(map(str, expr.shape)) if hasattr(expr, "shape") else ""
        lines.append(f"  {name} = {f'({shape})' if shape else expr}")
    return "\n".join(lines)


def as_latex(declared: Element | Law) -> str:
    """Return all formulas as one ``align*``: names of several letters are upright, rates of coordinates have a dot."""
    found = formulas(declared)
    names = {symbol: _name(symbol) for _, _, expr in found for symbol in expr.free_symbols}
    with_rates = (declared.v, declared.x) if isinstance(declared, Element) else (declared.ed, declared.e)
    names |= {rate: _dotted(_name(symbol)) for rate, symbol in zip(*with_rates, strict=True)}
    lines = [rf"{left} &= {sp.latex(expr, symbol_names=names)}" for _, left, expr in found]
    return "\n".join([r"\begin{align*}", " \\\\\n".join(lines), r"\end{align*}"])


def _name(symbol: sp.Symbol) -> str:
    """Return the LaTeX of a symbol; a name of several letters, or such an index, is not a product."""
    letter, *index = sp.latex(symbol).split("_", 1)
    return "_".join([_upright(letter), *(f"{{{_upright(part[1:-1])}}}" for part in index)])


def _upright(text: str) -> str:
    return rf"\mathrm{{{text}}}" if text.isalpha() and len(text) > 1 else text


def _dotted(name: str) -> str:
    """Return a name with a dot on its letter, not on its indices."""
    letter, *index = name.split("_", 1)
    return "_".join([rf"\dot{{{letter}}}", *index])


def _indexed(letter: str, name: str) -> str:
    return rf"{letter}_{{\mathrm{{{_escaped(name)}}}}}"


def _escaped(name: str) -> str:
    return name.replace("_", r"\_")
