"""The laws of controllers: compiled ones of linear controllers, callbacks of functions, and forces that are held.

A controller is a law like any other, so the closed loop is simulated, linearized, solved for statics and saved like
everything else.  The outputs and the own state of a sampled controller are internal states, which change at its
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
from flexel.declare.declarations import Declarations
from flexel.declare.displacements import displacement
from flexel.derive.spec import InternalSpec
from flexel.generated.table import LAWS
from flexel.structure.callbacks import Callback, Wires
from flexel.structure.controllers import Controller, numbered, parts
from flexel.structure.instances import LawInstance
from flexel.structure.rules import LinearRule
from flexel.structure.windup import BackCalculation

UNITS = {"A": "1/s", "B": "1/s", "C": "N or N m", "D": "N/m or N m", "L": "1/(N s)"}
MOST = 100  # own states of a continuous controller: the compiler takes a minute for them


def wired(model: Declarations, c: Controller) -> tuple[Wires, list[str]]:
    """How a continuous controller is connected, and its deformations and slips."""
    targets = [_target(model, c, z, "output") for z in c.outputs]
    sources = []
    for z in c.inputs:
        base, order = parts(z)
        if order not in (0, 1):
            raise ModelError(
                f"{c.owner}: a continuous controller measures values and rates, and '{z}' depends on its own force; "
                "give it a period, or leave that input out"
            )
        name, slip, offset = _target(model, c, base, "input")
        if slip != bool(order) and slip:
            raise ModelError(f"{c.owner}: '{z}' is a slip, which has no value; name its rate, \"{z}'\"")
        sources.append((name, slip, order, 0.0 if order else offset))
    both = [z[:2] for z in targets] + [z[:2] for z in sources]
    on = list(dict.fromkeys(name for name, slip in both if not slip))
    slips = list(dict.fromkeys(name for name, slip in both if slip))
    m, k = len(on), len(slips)
    inputs = tuple(
        2 * m + slips.index(z) if slip else order * m + on.index(z) for z, slip, order, _ in sources
    )
    outputs = tuple(m + slips.index(z) if slip else on.index(z) for z, slip, _ in targets)
    return Wires(m, k, inputs, np.array([z[-1] for z in sources]), outputs), [*on, *slips]


def _target(model: Declarations, c: Controller, name: str, what: str) -> tuple[str, bool, float]:
    """The deformation or slip of a name, whether it is a slip, and its offset.

    A coordinate is its displacement from where it is drawn.
    """
    owner = f"{c.owner}: {what} '{name}'"
    known = known_names(model)
    if name not in known:
        raise ModelError(f"{c.owner}: {what}: {unknown(name, known)}")
    found = displacement(model, name, owner)
    if found != name:
        node, _, component = name.partition(".")
        place = model.nodes[node].coordinates.index(name)
        return found, False, float(model.nodes[node].x0[place])
    instance = model.instances[name.rpartition(".")[0]]
    return name, name in instance.slips, 0.0


def known_names(model: Declarations) -> dict[str, str]:
    """Coordinates, deformations and slips declared so far, with their units."""
    known = {z: node.unit for node in model.nodes.values() for z in node.coordinates}
    for z in model.instances.values():
        deformations, slips = [d.unit for d in z.spec.deformations], [s.unit for s in z.spec.slips]
        known |= dict(zip(z.deformations, deformations, strict=True)) | dict(zip(z.slips, slips, strict=True))
    return known


def add_continuous(model: Declarations, c: Controller, start: Sequence[float]) -> None:
    """Add the law of a continuous controller."""
    if c.rule.nx > MOST:
        raise ModelError(
            f"{c.owner}: {c.rule.nx} own states; a continuous one may have {MOST}: reduce its order "
            "(control.balanced_reduction), or sample it (period=…)"
        )
    wires, on = wired(model, c)
    on, slips = on[: wires.m], on[wires.m :]
    if isinstance(c.rule, LinearRule):
        compiled = _linear_law(c, c.rule, wires)
        own = {"A": c.rule.A, "B": c.rule.B, "C": c.rule.C, "D": c.rule.D, "r": c.rule.r - wires.offsets}
        if c.limits:
            own |= {"low": np.maximum(c.low, -LARGEST), "high": np.minimum(c.high, LARGEST)}
        if isinstance(c.windup, BackCalculation):
            own["L"] = c.windup.gains
        spec, code = compiled.spec, compiled.code
        parameters = {name: z.ravel() for name, z in own.items() if z.size}
    else:
        code = Callback(c, wires)
        spec, parameters = code.spec, {}
    model.laws.append(LawInstance(c.name, spec, tuple(on), tuple(slips), parameters, code, tuple(start)))


def _linear_law(c: Controller, rule: LinearRule, wires: Wires) -> Any:
    """The compiled law of a linear controller; those of one shape are derived and compiled once."""
    import sympy

    from flexel.derive import Internal, Law, Parameter, symbol
    from flexel.derive.cache import CacheError
    from flexel.derive.compile import compile_law
    from flexel.derive.shared_object import CompilationError, CompilerMissingError

    shapes = {z: getattr(rule, z).shape for z in "ABCD"}
    if isinstance(c.windup, BackCalculation):
        shapes["L"] = c.windup.gains.shape
    given = {z: Parameter(z, a * b, UNITS[z], "row by row") for z, (a, b) in shapes.items() if a * b}
    matrix = {
        z: sympy.Matrix(*shapes[z], list(given[z].symbols)) if z in given else sympy.zeros(*shapes[z])
        for z in shapes
    }
    nu, ny = len(c.outputs), len(c.inputs)
    r = Parameter("r", ny, "m or rad", "reference")
    limits = [Parameter(z, nu, "N or N m", "limit") for z in ("low", "high")] if c.limits else []
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


def add_sampled(model: Declarations, c: Controller, start: Sequence[float]) -> None:
    """Add the forces that a sampled controller holds, its delayed outputs, and its own state."""
    units, names = known_names(model), numbered("u", len(c.outputs))
    forces = []
    for target, name in zip(c.outputs, names, strict=True):
        found, slip, _ = _target(model, c, target, "output")
        state = InternalSpec(name, force_unit(units[target], slip))
        forces.append(state)
        spec = replace(LAWS["slip_held" if slip else "held"], states=(state,))
        on, slips = ((), (found,)) if slip else ((found,), ())
        model.laws.append(LawInstance(c.name, spec, on, slips, {}, None, (0.0,)))
    waiting = [InternalSpec(f"next{i}", forces[i % len(forces)].unit) for i in range(len(c.waiting))]
    own = [InternalSpec(f"x{i}", "1") for i in range(c.rule.nx)]
    for state, value in zip([*waiting, *own], [*[0.0] * len(waiting), *start], strict=True):
        spec = replace(LAWS["memory"], states=(state,))
        model.laws.append(LawInstance(c.name, spec, (), (), {}, None, (float(value),)))
