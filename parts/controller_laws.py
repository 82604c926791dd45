"""The laws of controllers: compiled ones of linear controllers, callbacks of functions, and forces that are held.

A controller is a law like any other, so the closed loop is simulated, linearized, solved for statics and saved like
everything else.  The outputs and the state of a sampled controller are internal states, which change at its
instants only.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from flexel.base.arguments import LARGEST, unknown
from flexel.base.errors import CompilerError, ModelError
from flexel.base.units import force_unit
from flexel.derive.spec import InternalSpec
from flexel.generated.table import LAWS
from flexel.model.callbacks import Callback, Wires
from flexel.model.controller import Controller, numbered, parts
from flexel.model.instances import LawInstance
from flexel.model.lowering import Lowering
from flexel.model.rules import LinearRule
from flexel.model.windup import BackCalculation
from flexel.parts.displacements import displacement

UNITS = {"A": "1/s", "B": "1/s", "C": "N or N m", "D": "N/m or N m", "L": "1/(N s)"}
MOST = 100  # states of a continuous controller: the compiler takes a minute for them


def wired(to: Lowering, c: Controller) -> tuple[Wires, list[str]]:
    """Return how a continuous controller is connected, and its deformations and slips."""
    targets = [_target(to, c, name, "output") for name in c.outputs]
    sources = []
    for given in c.inputs:
        base, order = parts(given)
        if order not in (0, 1):
            raise ModelError(
                f"{c.owner}: a continuous controller measures values and rates, but '{given}' depends on its own "
                "force; give it a period, or leave that input out"
            )
        name, slip, offset = _target(to, c, base, "input")
        if slip != bool(order) and slip:
            raise ModelError(
                f"{c.owner}: '{given}' is a slip, which has no value; name its rate, \"{given}'\""
            )
        sources.append((name, slip, order, 0.0 if order else offset))
    both = [(name, slip) for name, slip, *_ in targets] + [(name, slip) for name, slip, *_ in sources]
    on = list(dict.fromkeys(name for name, slip in both if not slip))
    slips = list(dict.fromkeys(name for name, slip in both if slip))
    m, k = len(on), len(slips)
    inputs = tuple(
        2 * m + slips.index(name) if slip else order * m + on.index(name) for name, slip, order, _ in sources
    )
    outputs = tuple(m + slips.index(name) if slip else on.index(name) for name, slip, _ in targets)
    return Wires(m, k, inputs, np.array([offset for *_, offset in sources]), outputs), [*on, *slips]


def _target(to: Lowering, c: Controller, name: str, what: str) -> tuple[str, bool, float]:
    """Return the deformation or slip with this name, whether it is a slip, and its offset.

    A coordinate is its displacement from where it is drawn.
    """
    owner = f"{c.owner}: {what} '{name}'"
    known = known_names(to)
    if name not in known:
        raise ModelError(f"{c.owner}: {what}: {unknown(name, known)}")
    found = displacement(to, name, owner)
    if found != name:
        node, _, component = name.partition(".")
        place = to.nodes[node].coordinates.index(name)
        return found, False, float(to.nodes[node].x0[place])
    instance = to.instances[name.rpartition(".")[0]]
    return name, name in instance.slips, 0.0


def known_names(to: Lowering) -> dict[str, str]:
    """Return the coordinates, deformations and slips declared so far, with their units."""
    known = {name: node.unit for node in to.nodes.values() for name in node.coordinates}
    for instance in to.instances.values():
        units = [d.unit for d in instance.spec.deformations] + [s.unit for s in instance.spec.slips]
        known |= dict(zip((*instance.deformations, *instance.slips), units, strict=True))
    return known


def add_continuous(to: Lowering, c: Controller, start: Sequence[float]) -> None:
    """Add the law of a continuous controller."""
    if c.rule.nx > MOST:
        raise ModelError(
            f"{c.owner}: {c.rule.nx} states; a continuous one may have at most {MOST}: reduce its order "
            "(control.balanced_reduction), or sample it (period=…)"
        )
    wires, on = wired(to, c)
    on, slips = on[: wires.m], on[wires.m :]
    if isinstance(c.rule, LinearRule):
        compiled = _linear_law(c, c.rule, wires)
        own = {"A": c.rule.A, "B": c.rule.B, "C": c.rule.C, "D": c.rule.D, "r": c.rule.r - wires.offsets}
        if c.limits:
            own |= {"low": np.maximum(c.low, -LARGEST), "high": np.minimum(c.high, LARGEST)}
        if isinstance(c.windup, BackCalculation):
            own["L"] = c.windup.gains
        spec, code = compiled.spec, compiled.code
        parameters = {name: values.ravel() for name, values in own.items() if values.size}
    else:
        code = Callback(c, wires)
        spec, parameters = code.spec, {}
    to.laws.append(LawInstance(c.name, spec, tuple(on), tuple(slips), parameters, code, tuple(start)))


def _linear_law(c: Controller, rule: LinearRule, wires: Wires) -> Any:
    """Return the compiled law of a linear controller; controllers of one shape are derived and compiled once."""
    import sympy

    from flexel.derive import Internal, Law, Parameter, symbol
    from flexel.derive.cache import CacheError
    from flexel.derive.shared_object import CompilationError, CompilerMissingError
    from flexel.derive.user_definitions import compile_law

    shapes = {letter: getattr(rule, letter).shape for letter in "ABCD"}
    if isinstance(c.windup, BackCalculation):
        shapes["L"] = c.windup.gains.shape
    given = {
        letter: Parameter(letter, rows * columns, UNITS[letter], "row by row")
        for letter, (rows, columns) in shapes.items()
        if rows * columns
    }
    matrix = {
        letter: sympy.Matrix(*shape, list(given[letter].symbols)) if letter in given else sympy.zeros(*shape)
        for letter, shape in shapes.items()
    }
    nu, ny = len(c.outputs), len(c.inputs)
    r = Parameter("r", ny, "m or rad", "reference")
    limits = [Parameter(side, nu, "N or N m", "limit") for side in ("low", "high")] if c.limits else []
    e, ed = (tuple(symbol(f"{letter}_{i}") for i in range(wires.m)) for letter in ("e", "ed"))
    s = tuple(symbol(f"s_{i}") for i in range(wires.k))
    x = sympy.Matrix(rule.nx, 1, [symbol(f"x{i}") for i in range(rule.nx)])
    w = r.vector - sympy.Matrix([(*e, *ed, *s)[i] for i in wires.inputs])
    u, xd = matrix["C"] * x + matrix["D"] * w, matrix["A"] * x + matrix["B"] * w
    if limits:
        low, high = limits
        free, u = u, u.applyfunc(sympy.sympify)
        for i in range(nu):
            u[i] = sympy.Min(sympy.Max(u[i], low.symbols[i]), high.symbols[i])
        if "L" in matrix:
            xd += matrix["L"] * (u - free)
    stress = [sympy.S.Zero] * (wires.m + wires.k)
    for i, place in enumerate(wires.outputs):
        stress[place] = -u[i]
    law = Law(
        name="linear_controller",
        doc="u = C x + D (r - y), x' = A x + B (r - y), stresses -u; limited, with L: x' + L (limited u - u)",
        parameters=(*given.values(), r, *limits),
        e=e,
        ed=ed,
        s=s,
        sigma=tuple(stress[: wires.m]),
        tau=tuple(stress[wires.m :]),
        source="linear control",
        states=tuple(Internal(f"x{i}", "1", xd[i]) for i in range(rule.nx)),
    )
    try:
        return compile_law(law)
    except (CompilerMissingError, CompilationError, CacheError) as error:
        raise CompilerError(f"{c.owner}: {error}") from error


def add_sampled(to: Lowering, c: Controller, start: Sequence[float]) -> None:
    """Add the forces that a sampled controller holds, its delayed outputs, and its state."""
    units, names = known_names(to), numbered("u", len(c.outputs))
    forces = []
    for target, name in zip(c.outputs, names, strict=True):
        found, slip, _ = _target(to, c, target, "output")
        state = InternalSpec(name, force_unit(units[target], slip))
        forces.append(state)
        spec = replace(LAWS["slip_held" if slip else "held"], states=(state,))
        on, slips = ((), (found,)) if slip else ((found,), ())
        to.laws.append(LawInstance(c.name, spec, on, slips, {}, None, (0.0,)))
    waiting = [InternalSpec(f"next{i}", forces[i % len(forces)].unit) for i in range(len(c.waiting))]
    own = [InternalSpec(f"x{i}", "1") for i in range(c.rule.nx)]
    for state, value in zip([*waiting, *own], [*[0.0] * len(waiting), *start], strict=True):
        spec = replace(LAWS["memory"], states=(state,))
        to.laws.append(LawInstance(c.name, spec, (), (), {}, None, (float(value),)))
