"""Renders formulas as MathML when the pages are built: browsers typeset it, without scripts or a network."""

import re
from typing import Any

from docutils.nodes import Element, SkipNode, math, math_block
from docutils.utils.math import MathError
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.errors import SphinxError
from sphinx.util.math import get_node_equation_number

ACCENT = re.compile(r"\\(d?dot|bar) ([A-Za-z])")
COMBINING = {"dot": "\u0307", "ddot": "\u0308", "bar": "\u0304"}
PRIVATE = 0xE000  # first private-use character of Unicode


def converted(node: Element, as_block: bool) -> str:
    """Return a formula of LaTeX as MathML.

    A letter under dots or a bar becomes one symbol, with Unicode's combining accent. As an accent of MathML, it would
    have its index below, and overlap the letter if a browser finds no font for mathematics.
    """
    symbols: list[str] = []

    def symbol(found: re.Match[str]) -> str:
        symbols.append(found[2] + COMBINING[found[1]])
        return rf"\text{{{chr(PRIVATE + len(symbols) - 1)}}}"

    try:
        text = str(tex2mathml(ACCENT.sub(symbol, node.astext()), as_block=as_block))
    except MathError as error:
        raise SphinxError(
            f"{node.source}:{node.line}: {node.astext()!r} is not understood: {error}"
        ) from error
    for number, written in enumerate(symbols):
        text = text.replace(f"<mtext>{chr(PRIVATE + number)}</mtext>", f'<mi class="accented">{written}</mi>')
    return text


def visit_inline(translator: Any, node: math) -> None:
    """Write a formula in a line."""
    translator.body.append(converted(node, as_block=False))
    raise SkipNode


def visit_block(translator: Any, node: math_block) -> None:
    """Write a displayed formula, which scrolls on a narrow page, with its number if it has one."""
    number = ""
    if node["number"]:
        number = f'<span class="eqno">({get_node_equation_number(translator, node)})</span>'
    translator.body.append(translator.starttag(node, "div", CLASS="formula"))
    translator.body.append(f"{number}{converted(node, as_block=True)}</div>\n")
    raise SkipNode


def setup(app: Any) -> dict[str, bool]:
    """Make this the renderer of formulas in HTML."""
    app.add_html_math_renderer("mathml", (visit_inline, None), (visit_block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
