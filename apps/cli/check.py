"""Implements `flexel check FILE`."""

from __future__ import annotations

from pathlib import Path

import click

MODELS, RESULTS = (".py", ".json", ".dat"), (".nc", ".npz", ".mat", ".csv")


@click.command()
@click.argument("file", type=click.Path(exists=True, dir_okay=False, path_type=Path))
def check(file: Path) -> None:
    """List all errors and probable mistakes in the model of MODEL.py, .json or .dat, or in the motion of RESULT.

    For a model: degrees of freedom, redundant constraints and candidates for release, unconstrained motions, missing
    masses, degenerate elements, suspicious units, conditioning of the coordinates. A MODEL.py defines its model as for
    `flexel run`; a MODEL.json was written by Model.save. For a saved motion (.nc, .npz, .mat, .csv): the verdict of its
    audit, and its warnings. The exit status is 1 if there are errors or warnings, else 0.
    """
    suffix = file.suffix.lower()
    if suffix in RESULTS:
        fine = _motion(file)
    elif suffix in MODELS:
        fine = _model(file)
    else:
        raise click.UsageError(
            f"{file}: suffix '{file.suffix}' is unknown; give MODEL.py, MODEL.json or MODEL.dat, or a saved motion "
            f"({', '.join(RESULTS)})."
        )
    raise SystemExit(0 if fine else 1)


def _model(file: Path) -> bool:
    """Print the findings about a model; return whether there are none."""
    from flexel.apps.cli.modelfile import model_in, saved_model
    from flexel.apps.spacar.reading import read_spacar
    from flexel.derive.users_file import names_of, reported_by_line

    if file.suffix.lower() == ".dat":
        with reported_by_line(file):
            model = read_spacar(file).model
    elif file.suffix.lower() == ".json":
        model = saved_model(file)
    else:
        model = model_in(names_of(file), file)
    report = model.check()
    click.echo(str(report))
    return report.ok


def _motion(file: Path) -> bool:
    """Print the verdict and the warnings of a saved motion; return whether there are no warnings."""
    from flexel.parts.opening import load
    from flexel.results.motion import Motion

    motion = load(file)
    if not isinstance(motion, Motion):
        raise click.UsageError(
            f"{file}: contains a {type(motion).__name__}, not a motion; give a saved motion."
        )
    click.echo(
        motion.verdict
        or "no verdict: a motion that is prescribed or was interrupted, a path, or an older file"
    )
    for text in motion.warnings:
        click.echo(f"warning: {text}")
    return not motion.warnings
