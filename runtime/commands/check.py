"""`flexel check FILE`."""

from __future__ import annotations

from pathlib import Path

import click


@click.command()
@click.argument("file", type=click.Path(exists=True, dir_okay=False, path_type=Path))
def check(file: Path) -> None:
    """List at once what is wrong or suspicious in the model of MODEL.py or MODEL.dat.

    Degrees of freedom, redundant constraints and what to release, mechanisms left free, masses missing, degenerate
    elements, units that look wrong, and the condition of the coordinates. A MODEL.py defines its model as for `flexel
    run`. The exit status is 1 if there are errors or warnings, else 0.
    """
    from flexel.commands.modelfile import model_in, names_of, reported_by_line
    from flexel.spacar.reading import read_spacar

    if file.suffix.lower() == ".dat":
        with reported_by_line(file):
            model = read_spacar(file).model
    elif file.suffix == ".py":
        model = model_in(names_of(file), file)
    else:
        raise click.UsageError(f"{file}: suffix '{file.suffix}' is unknown; give MODEL.py or MODEL.dat.")
    report = model.check()
    click.echo(str(report))
    raise SystemExit(0 if report.ok else 1)
