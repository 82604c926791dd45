"""The command ``python -m flexel.derive``, also reached as ``flexel derive``.

Works without compiled kernels, since it generates them.
"""

import sys
from pathlib import Path

import click
from tqdm import tqdm

from flexel.derive.elements import ELEMENTS
from flexel.derive.emit.emit import baseline, check, emit, risen, write
from flexel.derive.emit.emit import update_baseline as accept

FOLDER = Path(__file__).resolve().parents[1] / "generated"


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.argument("elements", nargs=-1, metavar="[ELEMENT]...")
@click.option(
    "--check", "checking", is_flag=True, help="Compare byte for byte and count operations; write nothing."
)
@click.option("--update-baseline", is_flag=True, help="Accept the operation counts as the new baseline.")
@click.option(
    "--out", type=click.Path(path_type=Path, file_okay=False), default=FOLDER, help="Folder of the C files."
)
def main(elements: tuple[str, ...], checking: bool, update_baseline: bool, out: Path) -> None:
    """Derive the kernels of all elements (or of some) and write them to generated/."""
    names = [element.name for element in ELEMENTS]
    unknown = [name for name in elements if name not in names]
    if unknown:
        raise click.UsageError(f"no element '{unknown[0]}'; there are {', '.join(names)}")
    with tqdm(total=len(elements) or len(names) + 1, unit="element", file=sys.stderr, disable=None) as bar:

        def progress(name: str) -> None:
            bar.set_description(name, refresh=False)
            bar.update()

        emitted = emit(only=elements, folder=out, progress=progress)
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


if __name__ == "__main__":
    main()
