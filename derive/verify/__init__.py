"""Cross-check of the compiled kernels against derivatives that were found in other ways.

Every output of every kernel of every element and law, at random configurations and in batches of several
sizes, is compared (a) with differences of the compiled kernel one order below it and (b) with differences of
the undifferentiated definition in 60 digits. Nothing of the differentiation in ``flexel.derive`` is used for
either.
"""

import json
import sys
import time
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path

import click
from tqdm import tqdm

from flexel.derive.declare import Element, Law
from flexel.derive.spec import ElementSpec, LawSpec
from flexel.derive.verify.check import element_rows, law_rows
from flexel.derive.verify.compiled import Compiled, generated_elements
from flexel.derive.verify.report import Row, Verification
from flexel.derive.verify.samples import NOTHING, Ranges

__all__ = ["Row", "Verification", "definitions", "main", "verify", "verify_generated"]


@cache
def definitions() -> dict[str, Element | Law]:
    """Definition of every built-in element and law, laws as ``law_<name>``; the formulas take a second or two."""
    from flexel.derive.elements import ELEMENTS
    from flexel.derive.laws import LAWS

    return {e.name: e for e in ELEMENTS} | {f"law_{law.name}": law for law in LAWS}


def verify(
    spec: ElementSpec | LawSpec, address: int, definition: Element | Law, ranges: Ranges = NOTHING
) -> list[Row]:
    """Verify one element or law, built in or a user's own.

    Parameters
    ----------
    spec : ElementSpec or LawSpec
        What the kernels' arrays are.
    address : int
        Address of its ``flexel_element`` or ``flexel_law``.
    definition : Element or Law
        What the kernels should compute.
    ranges : mapping of str to (float, float), optional
        Lowest and highest values of coordinates and parameters, by name.

    Returns
    -------
    list of Row
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
    rows: list[Row] = []
    chosen: Iterable[str] = names or list(definitions())
    if progress:
        chosen = tqdm(chosen, desc="verify", unit="element", disable=not sys.stderr.isatty(), leave=False)
    for name in chosen:
        if name not in compiled:
            rows.append(Row(name, "*", "*", float("nan"), float("inf"), False, "not generated"))
            continue
        try:
            rows += verify(*compiled[name], definitions()[name])
        except KeyboardInterrupt:
            rows.append(Row(name, "*", "*", float("nan"), float("inf"), False, "interrupted"))
            break
    return Verification(tuple(rows), time.perf_counter() - start)


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.argument("names", nargs=-1, metavar="[ELEMENT]...")
@click.option(
    "--json",
    "json_file",
    type=click.Path(dir_okay=False, writable=True, allow_dash=True),
    metavar="FILE",
    help="Write the numbers as JSON; - for stdout.",
)
def main(names: tuple[str, ...], json_file: str | None) -> None:
    """Check every compiled kernel's derivatives; all elements and laws, or the named ones.

    Exit status 0 only if every output is within its tolerance. A law is named law_<name>.
    """
    unknown = [name for name in names if name not in definitions()]
    if unknown:
        raise click.UsageError(f"no element or law '{unknown[0]}'; there are: {', '.join(definitions())}.")
    if json_file is not None and not Path(json_file).absolute().parent.is_dir():
        raise click.UsageError(
            f"--json {json_file}: the folder does not exist; create it, or give another path."
        )
    result = verify_generated(names, progress=True)
    click.echo(result.table(), err=json_file == "-")
    if json_file is not None:
        with click.open_file(json_file, "w") as stream:
            stream.write(json.dumps(result.as_json(), indent=1) + "\n")
    sys.exit(0 if result.ok else 1)
