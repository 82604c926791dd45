"""A SPACAR file as readable flexel Python."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from flexel.base.errors import ModelError
from flexel.spacar.reading import Spacar, read_spacar
from flexel.spacar.routines import input_lines, stress_lines
from flexel.spacar.statements import Call, literal

WIDTH = 110
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
    """Write the Python program that a SPACAR file corresponds to.

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
    """The program: the model, then the analysis of `flexel run`."""
    lines = [
        f'"""{_quotable(file.path.name)}, a SPACAR input file of the {file.dialect} dialect, as a flexel model.',
        "",
        "Names and signs of deformations are flexel's; `flexel run` on the file itself reports them in SPACAR's.",
        '"""',
        "",
        "import flexel as fx",
        "",
        f"m = fx.Model({f'gravity={literal(file.gravity)}' if any(file.gravity) else ''})",
    ]
    section = ""
    for call in file.calls:
        title = SECTIONS.get(call.method, "elements and their laws")
        if title != section:
            lines += ["", f"# {title}"]
            section = title
        if call.method == "prescribe" and "USERINP" in file.routines:
            lines += input_lines(call, file.routines["USERINP"])
        else:
            lines += _wrapped(call)
    lines += stress_lines(file.routines, [name for name, _ in file.deformations.values()])
    if _steps(file):
        lines += ["", "# load steps, t from 0 to 1: inputs stand still unless a step changes them"]
        for call in (*file.still, *file.load_steps):
            lines += _wrapped(call)
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
    """A file name that a string in the program may hold: no quote, backslash or control character of it acts."""
    return json.dumps(name, ensure_ascii=False)[1:-1].encode("utf-8", "backslashreplace").decode("utf-8")


def _wrapped(call: Call) -> Sequence[str]:
    """A call on one line, or with its arguments below if it is long."""
    text = str(call)
    if len(text) <= WIDTH:
        return [text]
    matrices = {key: z for key, z in call.options.items() if isinstance(z, list) and isinstance(z[0], list)}
    options = [f"{key}={literal(z)}" for key, z in call.options.items() if key not in matrices]
    lines = [f"m.{call.method}(", *_filled([*map(literal, call.arguments), *options])]
    for key, rows in matrices.items():
        lines += [f"    {key}=[", *(f"        {literal(row)}," for row in rows), "    ],"]
    return [*lines, ")"]


def _filled(parts: Sequence[str]) -> list[str]:
    """Indented lines of parts with commas, as many on a line as fit."""
    lines = [""]
    for part in parts:
        if lines[-1] and len(lines[-1]) + len(part) + 6 > WIDTH:
            lines.append("")
        lines[-1] += (" " if lines[-1] else "") + part + ","
    return [f"    {line}" for line in lines]


def _indented(lines: Sequence[str]) -> list[str]:
    return [f"    {line}" if line else "" for line in lines]


def _steps(file: Spacar) -> bool:
    """Whether the program runs load steps, as `flexel run` does without a motion."""
    return bool(file.load_steps) and file.duration is None


def _analysis(file: Spacar) -> list[str]:
    """The analysis that the program performs when run."""
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
        *_filled([literal(name) for name in names]),
        ")",
        "for name in names:",
        '    print(f"{name:<24} {state[name]: .12e}")',
    ]
    if file.linearized:
        lines += [
            f"lin = system.linearize({'' if file.duration is not None else 'state'})",
            *(f'print("lin.{z}", lin.{z}.tolist())' for z in ("M", "C", "K")),
        ]
    if file.inputs or file.outputs:
        for what, terminals in (("inputs", file.inputs), ("outputs", file.outputs)):
            lines.append(f"{what} = {literal([z.name for z in terminals])}")
            flipped = [z for z in terminals if z.factor != 1.0]
            lines += [f"# {z.name}: the {what[:-1]} of the file is {z.factor!r} times this" for z in flipped]
        lines.append("A, B, C, D = lin.state_space(inputs, outputs)")
        lines += [f'print("{z}", {z}.tolist())' for z in "ABCD"]
    return lines
