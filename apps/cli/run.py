"""Implements `flexel run`: simulates and saves a user's model, or runs a SPACAR input file as SPACAR does."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from flexel.apps.cli.modelfile import model_in, options_in, saved_model
from flexel.apps.cli.stop import INTERRUPTED
from flexel.apps.spacar.keywords import DIALECTS, WARPING
from flexel.derive.users_file import names_of, reported_by_line

if TYPE_CHECKING:
    from flexel.mechanics.linearized_system import LinearizedSystem
    from flexel.parts.model import Model
    from flexel.results.motion import Motion

METHODS = ("auto", "DOP853", "Radau", "generalized-alpha")
FORMATS = ("npz", "nc", "mat", "csv")


@dataclass(frozen=True)
class RunOptions:
    """Options of the command line: the folder for results, and what to do with a motion."""

    out: Path
    simulate: Mapping[str, Any]
    formats: tuple[str, ...]
    plots: tuple[str, ...]
    linearize: bool


@click.command()
@click.argument("file", type=click.Path(exists=True, path_type=Path), metavar="MODEL")
@click.option("--time", type=float, metavar="SECONDS", help="Length of the motion.")
@click.option("--samples", type=int, metavar="N", help="Number of stored states.")
@click.option(
    "--method",
    type=click.Choice(METHODS),
    help="Integration method; auto, the default, chooses one to suit the model.",
)
@click.option(
    "--out",
    type=click.Path(file_okay=False, path_type=Path),
    metavar="DIR",
    help="Folder for results, created if missing; out/MODEL by default.",
)
@click.option(
    "--format",
    "formats",
    type=click.Choice(FORMATS),
    multiple=True,
    help="Format of the saved motion; npz by default, repeat for more.",
)
@click.option(
    "--plot", "plots", multiple=True, metavar="QUANTITY", help="Plot this time history; repeat for more."
)
@click.option(
    "--linearize", is_flag=True, help="Print frequency and damping of the modes about the last state."
)
@click.option(
    "--checkpoint",
    is_flag=True,
    help="Write the motion so far to a file in DIR every 30 s; the same command continues from it.",
)
@click.option(
    "--mode", type=int, metavar="N", help="Mode of analysis of a SPACAR file: 0, 1, 2, 3, 4, 7, 8, 9 or 10."
)
@click.option(
    "--dialect",
    type=click.Choice(DIALECTS),
    help="Dialect of a SPACAR file; recognized by its keywords if not given.",
)
@click.option(
    "--warping",
    type=click.Choice(WARPING),
    help="How to read a BEAMW of a SPACAR file: as SPACAR's element, the default, or as flexel's own.",
)
@click.option(
    "--compare",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    multiple=True,
    metavar="RESULT",
    help="Print the differences of a SPACAR file from SPACAR's own results, .sbd, .sbm or .ltv; repeat for more.",
)
@click.option(
    "--log", is_flag=True, help="Write MODEL.log of a SPACAR file: counts and lists of degrees of freedom."
)
def run(
    file: Path,
    time: float | None,
    samples: int | None,
    method: str | None,
    out: Path | None,
    formats: tuple[str, ...],
    plots: tuple[str, ...],
    linearize: bool,
    checkpoint: bool,
    mode: int | None,
    dialect: str | None,
    warping: str | None,
    compare: tuple[Path, ...],
    log: bool,
) -> None:
    """Build and simulate the model in MODEL.py or MODEL.json and save its motion, or run a SPACAR input file MODEL.dat.

    MODEL.py is a Python program that defines a fx.Model, called `model` (or `m`, or the only one), and
    optionally a dict `simulate` with the options of System.simulate, such as simulate = {"duration": 2.0};
    the options given here take precedence. A file with a function main(out) does everything itself: it is
    called with the folder for results, and a Motion that it returns is saved.

    MODEL.json was written by Model.save; --time is required. Modules of functions that it names are imported.

    A SPACAR file is read as data and never executed; results are printed in SPACAR's numbering and signs, and
    written to the folder of --out, a motion also as MODEL_motion.npz for `flexel view`, and with --format mat
    everything as MODEL.mat with SPACAR's names. Without --mode, a file with TIMESTEP is simulated, one with
    load steps is loaded step by step, and for any other file the equilibrium, its frequencies and its
    buckling loads are computed. For a folder, each SPACAR file is run that has SPACAR's own results next to
    it (.sbd, .sbm, .ltv of the same name), and one table shows how well they agree.

    Ctrl-C stops a simulation; the motion so far is saved, and the exit status is 130.
    """
    given = {"duration": time, "samples": samples, "method": method}
    asked: dict[str, Any] = {name: value for name, value in given.items() if value is not None}
    if file.is_dir():
        others = formats or plots or linearize or checkpoint or mode is not None or warping or compare or log
        if asked or out or others:
            raise click.UsageError(
                f"{file} is a folder of SPACAR files; only the option --dialect applies to folders."
            )
        _run_folder(file, dialect)
        return
    if file.suffix.lower() == ".dat":
        if asked or set(formats) - {"mat"} or plots or linearize or checkpoint:
            raise click.UsageError(
                f"{file} specifies its own analysis; only the options --mode, --dialect, --warping, "
                "--compare, --log, --format mat and --out apply to SPACAR files."
            )
        out = out or (Path("out") / file.stem if log or formats else None)
        own = {"mode": mode, "dialect": dialect, "compare": compare, "log": log, "mat": bool(formats)}
        own |= {} if warping is None else {"warping": warping}
        _run_spacar(file, out, own)
        return
    if file.suffix not in (".py", ".json"):
        raise click.UsageError(
            f"{file}: suffix '{file.suffix}' is unknown; give MODEL.py, MODEL.json or MODEL.dat."
        )
    if mode is not None or dialect is not None or warping is not None or compare or log:
        raise click.UsageError(
            f"{file}: --mode, --dialect, --warping, --compare and --log apply to SPACAR files, MODEL.dat."
        )
    folder = out or Path("out") / file.stem
    if checkpoint:
        asked["checkpoint"] = folder / f"{file.stem}.checkpoint.npz"
    _run_model(file, RunOptions(folder, asked, formats or FORMATS[:1], plots, linearize))


def _run_model(file: Path, request: RunOptions) -> None:
    """Run a model declared in Python or saved as JSON; save and print its results."""
    from flexel.results.interrupted import Interrupted

    status = 0
    try:
        motion = _run_saved(file, request) if file.suffix == ".json" else _run_python(file, request)
    except click.ClickException as failure:
        _keep_what_there_is(failure, request, file.stem)
        raise
    except Interrupted as interruption:
        motion, status = interruption.motion, INTERRUPTED
    if motion is None:
        return
    with reported_by_line(file):
        _keep(motion, request, file.stem)
        _report(motion, request)
    if status:
        raise SystemExit(status)


def _run_python(file: Path, request: RunOptions) -> Motion | None:
    """Return the motion of a model declared in Python, or that returned by its ``main(out)``."""
    from flexel.results.motion import Motion

    names = names_of(file)
    request.out.mkdir(parents=True, exist_ok=True)  # a failure is reported before the computation
    if callable(names.get("main")):
        if request.simulate:
            raise click.UsageError(
                f"{file} has a main(out), which runs its own simulation; omit --time and the like."
            )
        with reported_by_line(file):
            made = names["main"](request.out)
        return made if isinstance(made, Motion) else None
    return simulated(model_in(names, file), {**options_in(names, file), **request.simulate}, file)


def _run_saved(file: Path, request: RunOptions) -> Motion:
    """Return the motion of a saved model."""
    model = saved_model(file)
    if "duration" not in request.simulate:
        raise click.UsageError(f"{file} does not say how long to simulate; give --time SECONDS.")
    request.out.mkdir(parents=True, exist_ok=True)  # a failure is reported before the computation
    return simulated(model, request.simulate, file)


def simulated(model: Model, options: Mapping[str, Any], file: Path) -> Motion:
    """Compute the motion of a model, with options of `System.simulate`."""
    with reported_by_line(file):
        system = model.build()
    click.echo(repr(system))
    if "duration" not in options:
        raise click.UsageError(
            f"{file} does not say how long to simulate; give --time SECONDS, or write simulate = {{'duration': 2.0}}."
        )
    with reported_by_line(file):
        return system.simulate(**options)


def _report(motion: Motion, request: RunOptions) -> None:
    """Print how the motion ended and, if requested, the modes about its end."""
    last, total = motion[-1], motion.energy["total"]
    click.echo(f"{motion.message}; {motion.statistics.get('steps', 0)} steps, {len(motion)} states")
    click.echo(f"energy {total[0]:.6g} J at the start, {total[-1]:.6g} J at t = {last.t:g} s")
    for name in motion.system.dynamic:
        click.echo(f"  {name:<24} {last[name]: .10g}   rate {last.rate(name): .10g}")
    if request.linearize:
        _report_modes(motion.system.linearize(last))


def _report_modes(lin: LinearizedSystem) -> None:
    """Print the modes about a state, or explain that it has none because it accelerates."""
    from flexel.mechanics.steadiness import UNSTEADY

    if lin.acceleration > UNSTEADY:
        click.echo(
            f"no modes: the state at t = {lin.state.t:g} s is neither an equilibrium nor a steady motion (residual "
            f"forces {lin.acceleration:.2g} of the balancing ones); simulate until it is at rest, or linearize about "
            "system.equilibrium() or system.steady() in Python"
        )
        return
    click.echo(f"modes about t = {lin.state.t:g} s: frequency [rad/s], damping ratio, eigenvalue [1/s]")
    for mode in lin.modes():
        click.echo(f"  {mode.name:<24} {mode.omega:12.6g} {mode.damping:12.6g}   {mode.eigenvalue:.6g}")


def _keep(motion: Motion, request: RunOptions, stem: str) -> None:
    """Save the motion, and draw the requested plots."""
    for suffix in request.formats:
        click.echo(f"wrote {motion.save(request.out / f'{stem}.{suffix}')}")
    if request.plots:
        path = request.out / f"{stem}.png"
        motion.plot(*request.plots, path=path)
        click.echo(f"wrote {path}")


def _keep_what_there_is(failure: click.ClickException, request: RunOptions, stem: str) -> None:
    """Save the motion up to where a simulation failed."""
    motion = getattr(failure.__cause__, "motion", None)
    if motion is not None and len(motion) > 1:
        _keep(motion, request, stem)
        click.echo(f"the motion up to t = {motion.t[-1]:g} s is kept")


def _run_folder(folder: Path, dialect: str | None) -> None:
    """Run the SPACAR files of a folder and print how they agree with SPACAR's results; the status is 1 if one fails."""
    from flexel.apps.spacar.folder import run_folder
    from flexel.base.errors import FlexelError

    try:
        report = run_folder(folder, dialect)
    except FlexelError as error:
        raise click.ClickException(str(error)) from error
    click.echo(str(report))
    if report.failed:
        raise SystemExit(1)


def _run_spacar(file: Path, out: Path | None, options: Mapping[str, Any]) -> None:
    """Run a SPACAR input file and print its results."""
    from flexel.apps.spacar.run_file import run_spacar
    from flexel.base.errors import FlexelError
    from flexel.results.interrupted import Interrupted
    from flexel.results.saved.tables_of_runs import motion_beside

    try:
        outcome = run_spacar(file, out, **options)
    except FlexelError as error:
        raise click.ClickException(str(error)) from error
    except Interrupted as interruption:
        click.echo(interruption.motion.message)
        if out is not None:
            out.mkdir(parents=True, exist_ok=True)
            click.echo(f"wrote {interruption.motion.save(motion_beside(out / f'{file.stem}.npz'))}")
        raise SystemExit(INTERRUPTED) from None
    click.echo(outcome.report)
