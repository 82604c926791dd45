"""Springs, dampers and laws: the methods of `Model` that give free deformations and slips their stress."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from flexel.base.arguments import array, names, not_negative, number, numbers, quantities, unknown
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.declare.declarations import Declarations
from flexel.declare.formulas import formula_law
from flexel.declare.signs import check_signs, refuse_negative
from flexel.generated.spec import LawSpec
from flexel.generated.table import ELEMENTS, LAWS
from flexel.structure.instances import Instance, LawInstance
from flexel.structure.nodes import COMPONENTS, Node

LARGEST = 6  # deformations of one linear law


class Springs(Declarations):
    """Springs, dampers and laws."""

    def linear_law(self, on: Sequence[str], S: Any, D: Any = None, preload: Any = None) -> None:
        """Attach σ = preload + S e + D ė to up to six deformations, which become free.

        Parameters
        ----------
        on : sequence of str (m,)
            Deformations.
        S, D : array_like (m, m)
            Stiffness and damping, symmetric and without negative eigenvalues.
        preload : array_like (m,)

        Raises
        ------
        ModelError
        """
        on = names(on, "linear law")
        owner, m = f"linear law on {', '.join(repr(z) for z in on)}", len(on)
        if not 1 <= m <= LARGEST or len(set(on)) < m:
            raise ModelError(f"{owner}: {m} deformations named; name 1 to {LARGEST}, each once")
        upper = np.triu_indices(m)
        values = {
            "preload": np.zeros(m) if preload is None else array(preload, owner, "preload"),
            "S": _symmetric(S, owner, "stiffness", m)[upper],
            "D": _symmetric(np.zeros((m, m)) if D is None else D, owner, "damping", m)[upper],
        }
        if values["preload"].shape != (m,):
            raise ModelError(f"{owner}: preload has shape {values['preload'].shape}; give {m} numbers")
        self.laws.append(LawInstance(" ".join(on), LAWS[f"linear_{m}"], on, (), values))

    def spring(
        self,
        name: str,
        stiffness: float,
        damping: float = 0.0,
        preload: float = 0.0,
        *,
        to: str | None = None,
    ) -> None:
        """Attach a linear spring and damper: force = preload + stiffness e + damping ė, against the growth of e.

        Parameters
        ----------
        name : str
            A deformation; or a coordinate of a point or planar angle, counted from its drawn value, for a spring to
            the ground.
        stiffness, damping, preload : float
            Stiffness 0 leaves a mere damper.
        to : str, optional
            A second deformation or coordinate; e is then the first less the second.

        Raises
        ------
        ModelError

        Examples
        --------
        >>> m.spring("A.x", 200.0)  # to the ground  # doctest: +SKIP
        >>> m.spring("left.angle", 0.0, damping=0.3, to="right.angle")  # doctest: +SKIP
        """
        quantities([name] if to is None else [name, to], "spring")
        owner = f"spring on '{name}'" if to is None else f"spring between '{name}' and '{to}'"
        k, d = not_negative(stiffness, owner, "stiffness"), not_negative(damping, owner, "damping")
        force = number(preload, owner, "preload")
        if to == name:
            raise ModelError(
                f"{owner}: a quantity does not change against itself; name another one, or leave out to"
            )
        on = [displacement(self, z, owner) for z in ([name] if to is None else [name, to])]
        share = np.array([1.0, -1.0])[: len(on)]
        self.linear_law(on, k * np.outer(share, share), d * np.outer(share, share), force * share)

    def mass_damping(self, element: str, rate: float) -> None:
        """Resist the motion of an element by `rate` [1/s] times its momentum: Rayleigh's mass-proportional part.

        The stiffness-proportional part is the `damping` of springs and beams.  The force is -rate M v, with M the
        element's own consistent mass matrix; a whole mechanism that drifts is resisted too.

        Raises
        ------
        ModelError
            An unknown element, one without mass, a rate that is negative.
        """
        owner = f"mass_damping of '{element}'"
        if element not in self.instances:
            raise ModelError(f"{owner}: {unknown(str(element), self.instances, 'element')}")
        if "inertia" not in self.instances[element].spec.kernels:
            raise ModelError(
                f"{owner}: a {self.instances[element].spec.name} has no mass; name a body or a beam"
            )
        share = not_negative(rate, owner, "rate")
        self.instances[element] = replace(self.instances[element], mass_damping=share)

    def viscous(self, name: str, damping: float) -> None:
        """Attach a viscous resistance to one slip, τ = damping s; the slip becomes free."""
        quantities([name], "viscous")
        values = {"C": np.array([not_negative(damping, f"damper on '{name}'", "damping")])}
        self.laws.append(LawInstance(name, LAWS["viscous_1"], (), (name,), values))

    def attach(
        self,
        law: Any,
        on: Sequence[str],
        *,
        name: str | None = None,
        initial: Mapping[str, float] | None = None,
        **parameters: Any,
    ) -> None:
        """Attach a law of several deformations and slips together, built in or compiled; they become free.

        Parameters
        ----------
        law : str or compiled law
            Name in the table of laws, or what `flexel.derive.compile.compile_law` gives.
        on : sequence of str
            As many deformations as the law has, then as many slips, in the law's order.
        name : str, optional
            What its internal states are called by, ``name.state``; the names in `on`, joined, by default.
        initial : mapping of str to float, optional
            Initial values of internal states; zero by default.
        **parameters
            Value of each of the law's parameters.

        Raises
        ------
        ModelError
            An unknown law, parameter or state; a number of names or values that does not fit; a value of a built-in
            law's parameter that has no physical sense.

        Examples
        --------
        >>> m.attach("viscous_2", ["tyre.longitudinal", "tyre.lateral"], C=[900, 0, 700])  # doctest: +SKIP
        """
        on = names(on, "attach")
        quantities(on, "attach")
        spec = LAWS.get(law) if isinstance(law, str) else getattr(law, "spec", None)
        if not isinstance(spec, LawSpec):
            raise ModelError(f"attach: {unknown(str(law), LAWS, 'law')}")
        owner = f"law '{spec.name}' on {', '.join(repr(z) for z in on)}"
        m, k = spec.deformations, spec.slips
        if len(on) != m + k or len(set(on)) < len(on):
            raise ModelError(f"{owner}: {len(on)} names; give {m} deformations, then {k} slips, each once")
        sizes = {z.name: z.size for z in spec.parameters}
        for wrong in [z for z in parameters if z not in sizes]:
            raise ModelError(f"{owner}: {unknown(wrong, sizes, 'parameter')}")
        if missing := [f"{z.name} [{z.unit}] ({z.doc})" for z in spec.parameters if z.name not in parameters]:
            raise ModelError(f"{owner}: parameters are missing: {', '.join(missing)}")
        values = {z: np.atleast_1d(array(value, owner, f"parameter {z}")) for z, value in parameters.items()}
        if spec is LAWS.get(spec.name):
            check_signs(spec.name, values, owner)
        start = numbers(initial or {}, owner, "initial value")
        states = [z.name for z in spec.states]
        for wrong in [z for z in start if z not in states]:
            raise ModelError(f"{owner}: {unknown(wrong, states, 'internal state')}")
        z0 = tuple(start.get(z, 0.0) for z in states)
        address = getattr(law, "address", None)
        label = " ".join(on) if name is None else name
        instance = LawInstance(label, spec, tuple(on[:m]), tuple(on[m:]), values, address, z0)
        if states and any(z.name == label and z.spec.states for z in self.laws):
            raise ModelError(
                f"{owner}: there is a law '{label}' with internal states already; give another name"
            )
        self.laws.append(instance)

    def law(self, name: str, stress: Callable[..., Any], energy: Callable[..., Any] | None = None) -> None:
        """Attach a nonlinear spring given by a formula: σ = stress(e, ė) on one deformation.

        Parameters
        ----------
        stress : callable(e, ed)
            Called once with SymPy symbols; returns an expression.  Its tangent is derived and compiled.
        energy : callable(e), optional
            Stored energy [J]; the integral of the elastic part by default, where SymPy finds it.

        Raises
        ------
        ModelError
            If the formula is not one of e and its rate, or the energy does not belong to it.
        CompilerError
            If no C compiler is found (only user-defined laws and elements need one).

        Examples
        --------
        >>> m.law("strut.elongation", lambda e, ed: 2e4 * e + 3e6 * e**3 + 40 * ed)  # doctest: +SKIP
        """
        quantities([name], "law")
        compiled = formula_law(name, stress, energy)
        self.laws.append(LawInstance(name, compiled.spec, (name,), (), {}, compiled.address))


def _symmetric(value: Any, owner: str, what: str, m: int) -> Array:
    A = array(value, owner, what)
    if A.shape != (m, m):
        raise ModelError(f"{owner}: {what} has shape {A.shape}; give ({m}, {m})")
    size = float(np.max(np.abs(A)))
    if np.max(np.abs(A - A.T)) > 1e-12 * size:
        raise ModelError(
            f"{owner}: {what} {A.tolist()} is not symmetric; no energy belongs to it, make it so"
        )
    refuse_negative(A, owner, what)
    return (A + A.T) / 2


def displacement(model: Declarations, name: str, owner: str) -> str:
    """The deformation that is a coordinate less its drawn value; other names are returned as they are.

    It is one of an element without mass from a fixed node, ``<node>.drawn``; made when first needed.
    """
    node, _, component = name.partition(".")
    if node not in model.nodes or component not in COMPONENTS[model.nodes[node].kind]:
        return name
    found = model.nodes[node]
    if found.kind == "frame":
        raise ModelError(
            f"{owner}: Euler parameters such as '{name}' carry no springs; measure an angle with m.hinge(…), all of "
            "it released, and take its angle"
        )
    if found.fixed[COMPONENTS[found.kind].index(component)]:
        raise ModelError(f"{owner}: '{name}' is fixed and cannot move; remove spring or fixing")
    element = f"{node}.displacement"
    if element not in model.instances:
        _add_displacement(model, element, found)
    spec = model.instances[element].spec
    return f"{element}.{spec.deformations[COMPONENTS[found.kind].index(component)].name}"


def _add_displacement(model: Declarations, element: str, node: Node) -> None:
    """The element whose deformations, all free, are the displacements of a point or an angle in global axes."""
    drawn = Node(f"{node.name}.drawn", node.kind, node.x0, np.ones(node.x0.size, dtype=bool))
    axes_kind, axes = ("frame", np.eye(4)[0]) if node.kind == "point" else ("planar_angle", np.zeros(1))
    still = Node(f"{node.name}.axes", axes_kind, axes, np.ones(axes.size, dtype=bool))
    kind = {"point": "beam3", "planar_point": "planar_beam3", "planar_angle": "planar_hinge"}[node.kind]
    ends = (drawn, node) if node.kind == "planar_angle" else (drawn, still, node)
    model.nodes |= {z.name: z for z in ends if z is not node}
    spec = ELEMENTS[kind]
    values = {z.name: np.eye(z.size)[0] if z.name == "tp" else np.zeros(z.size) for z in spec.parameters}
    model.instances[element] = Instance(element, spec, tuple(z.name for z in ends), values)
    model._roles |= {z: "free" for z in model.instances[element].deformations if z not in model._roles}
