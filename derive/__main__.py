"""The command ``python -m flexel.derive``, also reached as ``flexel derive``.

Works without compiled kernels, since it generates them.
"""

import sys
from pathlib import Path

import click
from tqdm import tqdm

from flexel.derive.elements import ELEMENTS
from flexel.derive.emit.emit import baseline, check, differing, emit, emit_page, risen, write, write_files
from flexel.derive.emit.emit import update_baseline as accept
from flexel.derive.laws import LAWS
from flexel.derive.users_page import is_page, read_page

FOLDER = Path(__file__).resolve().parents[1] / "generated"


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.argument("only", nargs=-1, metavar="[NAME]...")
@click.option(
    "--check", "checking", is_flag=True, help="Compare byte for byte and count operations; write nothing."
)
@click.option("--update-baseline", is_flag=True, help="Accept the operation counts as the new baseline.")
@click.option(
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    help="Folder for the C files; generated/ by default, required for a page.",
)
def main(only: tuple[str, ...], checking: bool, update_baseline: bool, out: Path | None) -> None:
    """Derive the kernels of all elements and laws (or of those named) and write them to generated/.

    All laws are in one file and are derived together.

    `flexel derive PAGE.py [NAME]... --out FOLDER` writes the C code of the elements and laws declared in your
    Python file, with the headers that it includes and the table of its arrays.
    """
    if only and is_page(only[0]):
        if update_baseline:
            raise click.UsageError("--update-baseline is for the built-in elements; leave it out")
        if out is None:
            raise click.UsageError(f"no folder for the C code of {only[0]}; give one: --out FOLDER")
        _derive_page(Path(only[0]), only[1:], out, checking)
        return
    out = out or FOLDER
    elements, laws = [element.name for element in ELEMENTS], [law.name for law in LAWS]
    unknown = [name for name in only if name not in elements + laws]
    if unknown:
        raise click.UsageError(f"no element or law '{unknown[0]}'; there are {', '.join(elements + laws)}")
    chosen = set(only) or {*elements, *laws}
    count = len(chosen.intersection(elements)) + (not chosen.isdisjoint(laws))
    with tqdm(total=count, unit="element", file=sys.stderr, disable=None) as bar:

        def progress(name: str) -> None:
            bar.set_description(name, refresh=False)
            bar.update()

        emitted = emit(only=only, folder=out, progress=progress)
    rises = risen(emitted.operations, baseline())
    if update_baseline:
        accept(emitted.operations)
        rises = []
    for line in rises:
        click.echo(f"more operations: {line}", err=True)
    if not checking:
        changed = write(out, emitted)
        click.echo(f"{len(changed)} files changed" + "".join(f"\n  {name}" for name in changed))
        return
    different = check(out, emitted)
    for name in different:
        click.echo(f"differs: {name}", err=True)
    if different:
        click.echo("generated/ does not match the elements; run `flexel derive`", err=True)
    if rises:
        click.echo("if the increase is intended, run `flexel derive --update-baseline`", err=True)
    if different or rises:
        raise SystemExit(1)
    click.echo(f"{len(emitted.files)} files are as derived")


def _derive_page(path: Path, names: tuple[str, ...], out: Path, checking: bool) -> None:
    """Write the C of a user's page, or compare it with what the folder has."""
    from flexel.derive.acceptance import check_definition

    page = read_page(path).chosen(names)
    for name, declared in page.declared.items():
        with page.reported(name):
            check_definition(declared)
    files = emit_page(page.elements, page.laws).files
    if not checking:
        changed = write_files(out, files)
        click.echo(f"{len(changed)} files changed in {out}" + "".join(f"\n  {name}" for name in changed))
        return
    different = differing(out, files)
    for name in different:
        click.echo(f"differs: {out / name}", err=True)
    if different:
        click.echo(f"{out} does not match {path}; run `flexel derive {path} --out {out}`", err=True)
        raise SystemExit(1)
    click.echo(f"{len(files)} files are as derived")


if __name__ == "__main__":
    main()
