"""Cross-check of the compiled kernels against derivatives that were found in other ways.

Every output of every kernel of every element and law, at random configurations and in batches of several
sizes, is compared (a) with differences of the compiled kernel one order below it and (b) with differences of
the undifferentiated definition in 60 digits. Nothing of the differentiation in ``flexel.derive`` is used for
either.
"""

import sys
import time
from collections.abc import Iterable, Sequence
from functools import cache

from tqdm import tqdm

from flexel.derive.declare import Element, Law
from flexel.derive.spec import ElementSpec, LawSpec
from flexel.derive.verify.kernel_calls import Compiled, generated_elements
from flexel.derive.verify.kernel_comparison import element_rows, law_rows
from flexel.derive.verify.report import KernelRow, Verification
from flexel.derive.verify.samples import NOTHING, Ranges

__all__ = ["KernelRow", "Verification", "definitions", "verify", "verify_generated"]


@cache
def definitions() -> dict[str, Element | Law]:
    """Return the definitions of built-in elements and laws, laws as ``law_<name>``; formulas take a second or two."""
    from flexel.derive.elements import ELEMENTS
    from flexel.derive.laws import LAWS

    return {e.name: e for e in ELEMENTS} | {f"law_{law.name}": law for law in LAWS}


def verify(
    spec: ElementSpec | LawSpec, address: int, definition: Element | Law, ranges: Ranges = NOTHING
) -> list[KernelRow]:
    """Verify one element or law, built in or a user's own.

    Parameters
    ----------
    spec : ElementSpec or LawSpec
        Describes the kernels' arrays.
    address : int
        Address of its ``flexel_element`` or ``flexel_law``.
    definition : Element or Law
        What the kernels should compute.
    ranges : mapping of str to (float, float), optional
        Lowest and highest values of coordinates and parameters, by name.

    Returns
    -------
    list of KernelRow
    """
    compiled = Compiled(spec, address)
    if isinstance(definition, Law):
        return law_rows(definition, compiled, ranges)
    return element_rows(definition, compiled, ranges)


def verify_generated(names: Sequence[str] = (), progress: bool = False) -> Verification:
    """Verify the kernels in ``flexel.generated``, all or the named ones (a law is called ``law_<name>``).

    An interrupt (Ctrl-C) keeps what was verified; a row that is not ok says where it stopped.

    Raises
    ------
    KeyError
        The element or law does not exist.
    """
    start = time.perf_counter()
    compiled = generated_elements()
    rows: list[KernelRow] = []
    chosen: Iterable[str] = names or list(definitions())
    if progress:
        chosen = tqdm(chosen, desc="verify", unit="element", disable=not sys.stderr.isatty(), leave=False)
    for name in chosen:
        if name not in compiled:
            rows.append(KernelRow(name, "*", "*", float("nan"), float("inf"), False, "not generated"))
            continue
        try:
            rows += verify(*compiled[name], definitions()[name])
        except KeyboardInterrupt:
            rows.append(KernelRow(name, "*", "*", float("nan"), float("inf"), False, "interrupted"))
            break
    return Verification(tuple(rows), time.perf_counter() - start)
