"""Models in which every kind of declaration occurs, for tests of programs, files and parameters."""

import inspect
from collections.abc import Callable
from typing import Any

from bad_calls import named, positional
from forty import MECHANISMS
from own_elements import own_bar
from travellers import HARDENING, Step, push, roped, tabulated
from valid_flexures import FLEXURES
from valid_joints import JOINTS
from valid_models import MODELS

import flexel as fx
from flexel.examples import contact, flexures, joints, warping
from flexel.parts.method import METHOD_OF

Make = Callable[[], fx.Model]
VALID = MODELS | JOINTS | FLEXURES


def hardening(e: Any, ed: Any) -> Any:
    """The force of a spring."""
    return 3 * e + ed


def stored(e: Any) -> Any:
    """Its energy."""
    return 1.5 * e**2


BAR = fx.compile_element(own_bar())
STEP = Step()
LAW = fx.compile_law(HARDENING)
GIVEN = {  # in place of what no module holds, by method
    "law": {"law": hardening, "energy": stored},
}


def declared_by(method: str) -> Make:
    """The model with one declaration of a kind, from the valid calls."""

    def made() -> fx.Model:
        valid = VALID[f"Model.{method}"]()
        arguments = dict(valid.arguments) | GIVEN.get(method, {})
        signature = inspect.signature(valid.function)
        valid.function(*positional(signature, arguments), **named(signature, arguments))
        found: fx.Model = valid.function.__self__  # type: ignore[attr-defined]
        return found

    return made


def own() -> fx.Model:
    """A mass on an element, a law and functions of modules."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.point("B", (2, 0, 0))
    m.element("own", BAR, "O", "A", l0=1.0, mass=0.5)
    m.law("own.elongation", LAW, k=3.0, name="hard")
    m.truss("bar", "A", "B", mass_per_length=1.0)
    m.spring("bar.elongation", hardening, energy=stored)
    m.load("B.x", push)
    m.prescribe("A.y", STEP)
    return m


def of_system(system: fx.System) -> fx.Model:
    """The model that a system was built from."""
    assert system.origin is not None
    return fx.Model.of(system.origin.gravity, system.origin.parts)


def mechanism(name: str) -> Make:
    """One of the forty."""
    return lambda: of_system(MECHANISMS[name].make()[0])


KINDS: dict[str, Make] = {name: declared_by(name) for name in sorted(METHOD_OF.values())}
OTHERS: dict[str, Make] = {
    "own": own,
    "tabulated": tabulated,
    "roped": lambda: roped()[0],
    "guide": flexures.guide,
    "pivot": flexures.pivot,
    "incline": lambda: contact.incline(fx.Contact(1e5, friction=0.3), 0.1),
    "forks": lambda: warping.between_forks(fx.IBeam(0.1, 0.2, 0.005, 0.01), 2.0, 4),
    **{f"joint {name}": shown.make for name, shown in joints.JOINTS.items()},
}
FORTY: dict[str, Make] = {name: mechanism(name) for name in MECHANISMS}
