"""The command ``python -m flexel.derive.verify_command``, also reached as ``flexel verify``."""

import json
import sys
import time
from pathlib import Path

import click
from tqdm import tqdm

from flexel.derive.acceptance import check_definition, compared
from flexel.derive.declare import Element
from flexel.derive.user_definitions import compile_element, compile_law
from flexel.derive.users_page import UsersPage, is_page, read_page
from flexel.derive.verify import KernelRow, Verification, definitions, verify_generated
from flexel.derive.verify.samples import check_ranges


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.argument("names", nargs=-1, metavar="[NAME]...")
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

    `flexel verify PAGE.py [NAME]...` compiles and checks the elements and laws declared in your Python file.
    """
    if json_file is not None and not Path(json_file).absolute().parent.is_dir():
        raise click.UsageError(
            f"--json {json_file}: the folder does not exist; create it, or give another path."
        )
    result = _verified(names)
    click.echo(result.table(), err=json_file == "-")
    if json_file is not None:
        with click.open_file(json_file, "w") as stream:
            stream.write(json.dumps(result.as_json(), indent=1) + "\n")
    sys.exit(0 if result.ok else 1)


def _verified(names: tuple[str, ...]) -> Verification:
    """Return the rows of built-in elements and laws, or of those of a user's page."""
    if names and is_page(names[0]):
        return _verified_page(read_page(Path(names[0])).chosen(names[1:]))
    unknown = [name for name in names if name not in definitions()]
    if unknown:
        raise click.UsageError(f"no element or law '{unknown[0]}'; there are: {', '.join(definitions())}.")
    return verify_generated(names, progress=True)


def _verified_page(page: UsersPage) -> Verification:
    start = time.perf_counter()
    rows: list[KernelRow] = []
    for name in tqdm(
        page.declared, desc="verify", unit="element", disable=not sys.stderr.isatty(), leave=False
    ):
        declared, ranges = page.declared[name], page.ranges_of(name)
        with page.reported(name):
            check_definition(declared)
            check_ranges(declared, ranges)
            compiled = compile_element(declared) if isinstance(declared, Element) else compile_law(declared)
            rows += compared(declared, compiled, ranges)
    return Verification(tuple(rows), time.perf_counter() - start)


if __name__ == "__main__":
    main(prog_name="flexel verify")
