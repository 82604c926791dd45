"""Converts a SPACAR file to a readable Python program."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from flexel.apps.spacar.reading import Spacar, read_spacar
from flexel.apps.spacar.routines import input_lines, stress_lines
from flexel.base.errors import ModelError
from flexel.parts.method import METHOD_OF
from flexel.parts.model_program import empty_model, filled, literal, statement
from flexel.parts.roles import Prescribe

NODES = "nodes: positions p, orientations o, warping w"
SECTIONS = {
    "point": NODES,
    "frame": NODES,
    "angle": NODES,
    "warping": NODES,
    "fix": NODES,
    "point_mass": "masses of nodes",
    "rotary_inertia": "masses of nodes",
    "load": "loads",
    "prescribe": "prescribed motions",
    "independent": "degrees of freedom",
    "kinematic": "degrees of freedom",
    "initial": "initial values",
    "angular_velocity": "inputs of the linear model",
    "look": "pictures",
}


def convert_spacar(path: str | Path, target: str | Path, dialect: str | None = None) -> Path:
    """Write the Python program that corresponds to a SPACAR file.

    Parameters
    ----------
    path, target : str or Path
        The .dat file, and the .py file to be written; an existing one is not overwritten.
    dialect : "delft" or "twente", optional

    Returns
    -------
    Path
        The target.

    Raises
    ------
    ModelError
        A file that cannot be read as SPACAR's, an existing target.
    """
    target = Path(target)
    if target.exists():
        raise ModelError(f"{target}: exists already; remove it, or give another name")
    target.write_text(python_source(read_spacar(path, dialect)), encoding="utf-8")
    return target


def python_source(file: Spacar) -> str:
    """Return the program: the model, then the analysis of `flexel run`."""
    lines = [
        f'"""{_quotable(file.path.name)}, a SPACAR input file of the {file.dialect} dialect, as a flexel model.',
        "",
        "Names and signs of deformations are flexel's; `flexel run` on the file itself reports them in SPACAR's.",
        '"""',
        "",
        "import flexel as fx",
        "",
        empty_model(file.model.gravity, "m"),
    ]
    section = ""
    for part in file.model.parts:
        title = SECTIONS.get(METHOD_OF[type(part)], "elements and their laws")
        if title != section:
            lines += ["", f"# {title}"]
            section = title
        if isinstance(part, Prescribe) and "USERINP" in file.routines:
            lines += input_lines(part, file.routines["USERINP"])
        else:
            lines.append(statement(part, "m", {}))
    lines += stress_lines(file.routines, [name for name, _ in file.deformations.values()])
    if _steps(file):
        lines += ["", "# load steps, t from 0 to 1: inputs keep their values unless a step changes them"]
        lines += [statement(part, "m", {}) for part in (*file.still, *file.load_steps)]
    if file.duration is not None:
        step = f', "max_step": {file.max_step!r}' if file.max_step else ""
        options = f'{{"duration": {file.duration!r}, "samples": {file.steps + 1}{step}}}'
        lines += ["", f"simulate = {options}"]
    if file.duration is not None:
        lines += ["", 'if __name__ == "__main__":', *_indented(_analysis(file))]
    else:  # `flexel run` calls main: there is nothing to simulate
        lines += ["", "", "def main(out=None):", *_indented(_analysis(file)), "", ""]
        lines += ['if __name__ == "__main__":', "    main()"]
    return "\n".join(lines) + "\n"


def _quotable(name: str) -> str:
    """Return a file name for a string in the program: without quotes, backslashes or control characters."""
    return json.dumps(name, ensure_ascii=False)[1:-1].encode("utf-8", "backslashreplace").decode("utf-8")


def _indented(lines: Sequence[str]) -> list[str]:
    return [f"    {line}" if line else "" for line in lines]


def _steps(file: Spacar) -> bool:
    """Whether the program runs load steps, as `flexel run` does without a motion."""
    return bool(file.load_steps) and file.duration is None


def _analysis(file: Spacar) -> list[str]:
    """Write the analysis that the program performs when run."""
    start = repr(float(file.start)) if file.start and not _steps(file) else ""
    lines = [f"system = m.build({start})"]
    if file.duration is not None:
        lines += ["state = system.simulate(**simulate)[-1]"]
    elif _steps(file):
        lines += [
            "state = None",
            f"for i in range({file.increments + 1}):",
            f"    state = system.equilibrium(state, t=i / {file.increments})",
        ]
    else:
        lines += ["state = system.equilibrium()"]
    names = [
        *file.coordinates.values(),
        *(name for name, _ in file.deformations.values() if name not in file.slips),
    ]
    lines += [
        "names = (",
        *filled([literal(name) for name in names]),
        ")",
        "for name in names:",
        '    print(f"{name:<24} {state[name]: .12e}")',
    ]
    if file.linearized:
        lines += [
            f"lin = system.linearize({'' if file.duration is not None else 'state'})",
            *(f'print("lin.{matrix}", lin.{matrix}.tolist())' for matrix in ("M", "C", "K")),
        ]
    if file.inputs or file.outputs:
        for what, terminals in (("inputs", file.inputs), ("outputs", file.outputs)):
            lines.append(f"{what} = {literal([terminal.name for terminal in terminals])}")
            flipped = [terminal for terminal in terminals if terminal.factor != 1.0]
            lines += [
                f"# {terminal.name}: the {what[:-1]} of the file is {terminal.factor!r} times this"
                for terminal in flipped
            ]
        lines.append("A, B, C, D = lin.state_space(inputs, outputs)")
        lines += [f'print("{matrix}", {matrix}.tolist())' for matrix in "ABCD"]
    return lines
