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
from flexel.derive.laws import LAWS

FOLDER = Path(__file__).resolve().parents[1] / "generated"


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.argument("only", nargs=-1, metavar="[NAME]...")
@click.option(
    "--check", "checking", is_flag=True, help="Compare byte for byte and count operations; write nothing."
)
@click.option("--update-baseline", is_flag=True, help="Accept the operation counts as the new baseline.")
@click.option(
    "--out", type=click.Path(path_type=Path, file_okay=False), default=FOLDER, help="Folder of the C files."
)
def main(only: tuple[str, ...], checking: bool, update_baseline: bool, out: Path) -> None:
    """Derive the kernels of all elements and laws (or of those that are named) and write them to generated/.

    All laws stand in one file and are derived together.
    """
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


if __name__ == "__main__":
    main()
