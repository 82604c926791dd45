"""Laws: the single entry point for every law of a model, and the methods of `Model` that attach a law directly.

Springs, beams, cables, contacts and controllers are laws too; their methods call this module.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.base.arguments import array, names, numbers, text, unknown
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.declare.declarations import Declarations
from flexel.declare.formulas import formula_law
from flexel.declare.signs import check_signs
from flexel.derive.spec import LawSpec
from flexel.generated.table import LAWS
from flexel.structure.instances import Code, LawInstance

if TYPE_CHECKING:
    from flexel.derive.compile import CompiledLaw


class Laws(Declarations):
    """Laws, built in, compiled and by formula."""

    def attach(
        self,
        law: str,
        on: Sequence[str] | Mapping[str, str],
        *,
        name: str | None = None,
        initial: Mapping[str, float] | None = None,
        **parameters: Any,
    ) -> None:
        """Attach a built-in law of several deformations and slips together; they become free.

        Parameters
        ----------
        law : str
            Name in the table of laws.
        on : mapping of str to str, or sequence of str
            The quantity of the model for each of the law's arguments, by name; or as many deformations as the law has,
            then as many slips, in the law's order.
        name : str, optional
            Prefix of its internal states, ``name.state``; by default the element on which it acts, or the names in
            `on`, joined.
        initial : mapping of str to float, optional
            Initial values of internal states; zero by default.
        **parameters
            Value of each of the law's parameters.

        Raises
        ------
        ModelError
            An unknown law, argument, parameter or state; a quantity in another unit than the argument's; a wrong
            number of names or values; a value that is not physically meaningful.

        See Also
        --------
        law : Compiled laws and formulas.

        Examples
        --------
        >>> m.attach("viscous_2", ["tyre.longitudinal", "tyre.lateral"], C=[900, 0, 700])  # doctest: +SKIP
        """
        if _is_compiled(law):
            raise ModelError("attach: this law is a compiled one; use m.law(on, law, …)")
        spec = LAWS.get(law) if isinstance(law, str) else None
        if spec is None:
            raise ModelError(f"attach: {unknown(str(law), LAWS, 'law')}")
        on = _ordered(f"law '{spec.name}'", spec, on)
        owner = f"law '{spec.name}' on {_listed(on)}"
        self._add_law(owner, spec, on, parameters, initial=initial, label=name)

    def law(
        self,
        on: str | Sequence[str] | Mapping[str, str],
        law: CompiledLaw | Callable[..., Any],
        *,
        energy: Callable[..., Any] | None = None,
        ranges: Mapping[str, tuple[float, float]] | None = None,
        name: str | None = None,
        initial: Mapping[str, float] | None = None,
        **parameters: Any,
    ) -> None:
        """Attach a user-defined law: a compiled one, or a formula σ = law(e, ė) on one deformation.

        Parameters
        ----------
        on : str, sequence of str, or mapping of str to str
            A deformation; for a compiled law as many deformations as it has, then as many slips, or the quantity for
            each of its arguments, by name.  They become free.
        law : CompiledLaw or callable
            The result of `flexel.compile_law`; or a function of e, or of e and ed, that is called once with SymPy
            symbols and returns an expression.  Its tangent is derived, and it is compiled and verified.
        energy : callable(e), optional
            Stored energy [J] of a formula; the integral of the elastic part from zero by default: in closed form, else
            by quadrature over the range of e, else none, with a warning.
        ranges : mapping of str to (float, float), optional
            Lowest and highest ``e`` and ``ed`` at which a formula is used: it is verified there, and the energy found
            by quadrature ends there.
        name : str, optional
            Prefix of internal states, ``name.state``; by default the element on which it acts, or the names in `on`,
            joined.
        initial : mapping of str to float, optional
            Initial values of internal states; zero by default.
        **parameters
            Value of each parameter of a compiled law.

        Raises
        ------
        ModelError
            A formula of anything but e and its rate, or an energy that does not match it; names or parameters
            that do not match a compiled law.
        CompilerError
            If no C compiler is found (only user-defined laws and elements need one).

        See Also
        --------
        attach : Built-in laws.

        Examples
        --------
        >>> m.law("strut.elongation", lambda e, ed: 2e4 * e + 3e6 * e**3 + 40 * ed)  # doctest: +SKIP
        >>> m.law(["strut.elongation"], fx.compile_law(DAMPER), lag=0.1, k=50.0)  # doctest: +SKIP
        """
        if _is_compiled(law):
            compiled: Any = law
            on = _ordered(f"law '{compiled.spec.name}'", compiled.spec, (on,) if isinstance(on, str) else on)
        else:
            on = (on,) if isinstance(on, str) else names(on, "law")
        owner = f"law on {_listed(on)}"
        if isinstance(law, str):
            raise ModelError(f"{owner}: {law!r} is text; attach a built-in law by m.attach({law!r}, …)")
        if not _is_compiled(law):
            if given := [*parameters, *(["initial"] if initial is not None else [])]:
                raise ModelError(f"{owner}: a formula takes no {', '.join(given)}; insert the numbers")
            self._add_formula(owner, on, law, energy, ranges, name)
            return
        if energy is not None:
            raise ModelError(f"{owner}: a compiled law has its own energy; leave energy out")
        if ranges is not None:
            raise ModelError(f"{owner}: a compiled law is verified already; give ranges to fx.compile_law")
        owner = f"law '{compiled.spec.name}' on {_listed(on)}"
        self._add_law(owner, compiled.spec, on, parameters, code=compiled.code, initial=initial, label=name)

    def _add_law(
        self,
        owner: str,
        spec: LawSpec,
        on: Sequence[str],
        parameters: Mapping[str, Any],
        *,
        code: Code | None = None,
        initial: Mapping[str, float] | None = None,
        label: str | None = None,
    ) -> None:
        """Check a law and add it to the model; every law is added here.

        Parameters
        ----------
        owner : str
            The declaration that adds it, for messages.
        spec : LawSpec
        on : sequence of str
            Deformations, then slips.
        parameters : mapping of str to array_like
        code : Code, optional
            Compiled code of a user's law; none for a built-in law.
        initial : mapping of str to float, optional
        label : str, optional
            Its name; by default the element on which it acts, or the names in `on`, joined.
        """
        m, k = spec.deformations, spec.slips
        on = tuple(on)
        kinds = [self._quantity_kind(z, owner) for z in on]
        if len(on) != m + k or len(set(on)) < len(on):
            raise ModelError(
                f"{owner}: {len(on)} names; give {m} deformations, then {k} slips, each once{_arguments(spec)}"
            )
        for wrong in [z for z, kind in zip(on[:m], kinds[:m], strict=True) if kind != "deformation"]:
            raise ModelError(f"{owner}: '{wrong}' is not a deformation; springs and formulas act on these")
        for wrong in [z for z, kind in zip(on[m:], kinds[m:], strict=True) if kind != "slip"]:
            raise ModelError(f"{owner}: '{wrong}' is not a slip; use m.spring(…, damping=…) on deformations")
        for argument, name in zip(spec.arguments, on, strict=False):
            if not argument.fits(unit := self._unit(name)):
                raise ModelError(
                    f"{owner}: '{name}' is in {unit}, which does not fit argument {argument}; give in this order"
                    f"{_arguments(spec)}"
                )
        values = _checked_parameters(owner, spec, parameters)
        check_signs(spec, values, owner)
        start = numbers(initial, owner, "initial value")
        states = [z.name for z in spec.states]
        for wrong in [z for z in start if z not in states]:
            raise ModelError(f"{owner}: {unknown(wrong, states, 'internal state')}")
        z0 = tuple(start.get(z, 0.0) for z in states)
        label = _label(on) if label is None else text(label, owner, "name")
        if states and any(z.name == label and z.spec.states for z in self.laws):
            raise ModelError(
                f"{owner}: there is a law '{label}' with internal states already; give another name"
            )
        self.laws.append(LawInstance(label, spec, on[:m], on[m:], values, code, z0))

    def _unit(self, quantity: str) -> str:
        """Unit of a deformation or slip of an element."""
        element, _, own = quantity.rpartition(".")
        spec = self.instances[element].spec
        units = {part.name: part.unit for part in spec.deformations}
        return (units | {part.name: part.unit for part in spec.slips})[own]

    def _add_linear(
        self, owner: str, on: Sequence[str], S: Array, D: Array, preload: Array, label: str
    ) -> None:
        """Add σ = preload + S e + D ė on one to six deformations; S and D are symmetric."""
        upper = np.triu_indices(len(on))
        values = {"preload": preload, "S": S[upper], "D": D[upper]}
        self._add_law(owner, LAWS[f"linear_{len(on)}"], on, values, label=label)

    def _add_formula(
        self,
        owner: str,
        on: Sequence[str],
        stress: Any,
        energy: Callable[..., Any] | None = None,
        ranges: Mapping[str, tuple[float, float]] | None = None,
        label: str | None = None,
    ) -> None:
        """Add a law that is a formula of one deformation and its rate."""
        if len(on) != 1:
            raise ModelError(
                f"{owner}: a formula acts on one deformation and {len(on)} are named; compile a law of more with "
                "fx.compile_law"
            )
        self._quantity_kind(on[0], owner)  # before a formula is compiled for it
        found = formula_law(owner, stress, energy, ranges)
        self._add_law(owner, found.law.spec, on, found.parameters, code=found.law.code, label=label)


def _ordered(
    owner: str, spec: LawSpec, on: Sequence[str] | Mapping[str, str]
) -> tuple[str, ...] | Sequence[str]:
    """The quantities on which a law acts in the law's order, where they are given by its arguments."""
    if not isinstance(on, Mapping):
        return names(on, owner)
    known = [argument.name for argument in spec.arguments]
    for wrong in [name for name in on if name not in known]:
        raise ModelError(f"{owner}: {unknown(str(wrong), known, 'argument')}")
    if missing := [str(argument) for argument in spec.arguments if argument.name not in on]:
        raise ModelError(f"{owner}: arguments are missing: {', '.join(missing)}; name a quantity for each")
    return names([on[name] for name in known], owner)


def _arguments(spec: LawSpec) -> str:
    """The arguments of a law with their units, for a message."""
    return f": {', '.join(map(str, spec.arguments))}" if any(z.unit for z in spec.arguments) else ""


def _label(on: Sequence[str]) -> str:
    """The element on which a law of several quantities acts, otherwise their names, joined."""
    elements = {name.rpartition(".")[0] for name in on}
    return elements.pop() if len(on) > 1 and len(elements) == 1 else " ".join(on)


def _checked_parameters(owner: str, spec: LawSpec, parameters: Mapping[str, Any]) -> dict[str, Array]:
    """Numbers for each of the law's parameters, of the right sizes."""
    known = [z.name for z in spec.parameters]
    for wrong in [z for z in parameters if z not in known]:
        raise ModelError(f"{owner}: {unknown(wrong, known, 'parameter')}")
    if missing := [f"{z.name} [{z.unit}] ({z.doc})" for z in spec.parameters if z.name not in parameters]:
        raise ModelError(f"{owner}: parameters are missing: {', '.join(missing)}")
    values = {}
    for z in spec.parameters:
        value = array(parameters[z.name], owner, f"parameter {z.name}").reshape(-1)
        if value.size != z.size:
            raise ModelError(f"{owner}: parameter {z.name} has {value.size} numbers; it needs {z.size}")
        values[z.name] = value
    return values


def _is_compiled(law: object) -> bool:
    return isinstance(getattr(law, "spec", None), LawSpec) and hasattr(law, "code")


def _listed(on: Sequence[object]) -> str:
    return ", ".join(repr(z) for z in on)
