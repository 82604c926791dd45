"""Laws that act on deformations and slips: built in, compiled, or a formula."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import KW_ONLY
from typing import TYPE_CHECKING, Any

from flexel.base.arguments import names, unknown
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry
from flexel.derive.spec import LawSpec
from flexel.generated.table import LAWS
from flexel.model.law_arguments import in_order
from flexel.model.lowering import Lowering
from flexel.model.part import Part, part
from flexel.parts.displacements import displacement
from flexel.parts.formulas import formula_law

if TYPE_CHECKING:
    from flexel.derive.compiled import CompiledLaw


@part
class AttachedLaw(Part[None]):
    """Attach a built-in law of several deformations and slips together; they become free.

    Raises
    ------
    ModelError
        An unknown law, argument, parameter or state; a quantity whose unit differs from the argument's; a wrong
        number of names or values; a value that is not physically meaningful.

    See Also
    --------
    law : Compiled laws and formulas.

    Examples
    --------
    >>> m.attach("viscous_2", ["tyre.longitudinal", "tyre.lateral"], C=[900, 0, 700])  # doctest: +SKIP
    """

    law: str = entry("Name in the table of laws.")
    on: Sequence[str] | Mapping[str, str] = entry(
        "The quantity of the model for each of the law's arguments, by name; or the deformations, then the slips, in "
        "the law's order."
    )
    _: KW_ONLY
    name: str | None = entry(
        "Prefix of its internal states, ``name.state``; by default the element on which it acts, or the names in "
        "`on`, joined.",
        default=None,
    )
    initial: Mapping[str, float] | None = array_quantity(
        "", "Initial values of internal states; zero by default.", default=None
    )
    parameters: Mapping[str, Any] | None = entry(
        "Value of each of the law's parameters.", default=None, spread=True
    )

    @property
    def owner(self) -> str:
        """The law, by its name."""
        return f"law '{self.law}'"

    def lower(self, to: Lowering) -> None:
        """Add the law."""
        if _is_compiled(self.law):
            raise ModelError("attach: this law is a compiled one; use m.law(on, law, …)")
        spec = LAWS.get(self.law) if isinstance(self.law, str) else None
        if spec is None:
            raise ModelError(f"attach: {unknown(str(self.law), LAWS, 'law')}")
        on = in_order(self.owner, spec, self.on)
        owner = f"{self.owner} on {_listed(on)}"
        to.law(owner, spec, on, self.parameters or {}, initial=self.initial, label=self.name)


@part
class LawPart(Part[None]):
    """Attach a user-defined law: a compiled one, or a formula σ = law(e, ė, t) on one deformation or coordinate.

    Statics, linearizations and vibrations evaluate a law that depends on time at the time of their state.

    Raises
    ------
    ModelError
        A formula of anything but e, its rate and the time, or an energy that does not match it; names or parameters
        that do not match a compiled law.
    CompilerError
        If no C compiler is found (only user-defined laws and elements need one).

    See Also
    --------
    attach : Built-in laws.

    Examples
    --------
    >>> m.law("strut.elongation", lambda e, ed: 2e4 * e + 3e6 * e**3 + 40 * ed)  # doctest: +SKIP
    >>> m.law("strut.elongation", lambda e, ed, t: (1 + 0.2 * sympy.cos(9 * t)) * e)  # doctest: +SKIP
    >>> m.law(["strut.elongation"], fx.compile_law(DAMPER), lag=0.1, k=50.0)  # doctest: +SKIP
    """

    on: str | Sequence[str] | Mapping[str, str] = entry(
        "A deformation, or a coordinate for its displacement from where it is drawn; for a compiled law its "
        "deformations, then its slips, in order, or the quantity for each of its arguments, by name.  They become "
        "free."
    )
    law: CompiledLaw | Callable[..., Any] = entry(
        "The result of `flexel.compile_law`; or a function of e, of e and ed, or of e, ed and the time t [s], that is "
        "called once with SymPy symbols and returns an expression.  Its tangent is derived, and it is compiled and "
        "verified."
    )
    _: KW_ONLY
    energy: Callable[..., Any] | None = entry(
        "Stored energy [J] of a formula, a function of e; the integral of the elastic part from zero by default: in "
        "closed form, else by quadrature over the range of e, else none, with a warning.  Terms with t store none: "
        "the energy that they supply counts as negative dissipation.",
        default=None,
    )
    ranges: Mapping[str, tuple[float, float]] | None = entry(
        "Lowest and highest ``e``, ``ed`` and ``t`` at which a formula is used: it is verified there (for ``t`` in "
        "(0, 1) by default), and a quadrature of the energy ends there.",
        default=None,
    )
    name: str | None = entry(
        "Prefix of internal states, ``name.state``; by default the element on which it acts, or the names in `on`, "
        "joined.",
        default=None,
    )
    initial: Mapping[str, float] | None = array_quantity(
        "", "Initial values of internal states; zero by default.", default=None
    )
    parameters: Mapping[str, Any] | None = entry(
        "Value of each parameter of a compiled law.", default=None, spread=True
    )

    @property
    def owner(self) -> str:
        """The law, by its name if it is compiled."""
        spec = getattr(self.law, "spec", None)
        return f"law '{spec.name}'" if isinstance(spec, LawSpec) else "law"

    def lower(self, to: Lowering) -> None:
        """Add the law, or the formula when it is compiled."""
        if _is_compiled(self.law):
            _lower_compiled(to, self, self.law)
        else:
            _lower_formula(to, self)


def _lower_compiled(to: Lowering, given: LawPart, law: Any) -> None:
    """Add a compiled law."""
    on = in_order(given.owner, law.spec, (given.on,) if isinstance(given.on, str) else given.on)
    owner = f"law on {_listed(on)}"
    if given.energy is not None:
        raise ModelError(f"{owner}: a compiled law already has an energy; leave energy out")
    if given.ranges is not None:
        raise ModelError(f"{owner}: a compiled law is already verified; give ranges to fx.compile_law")
    places, label = _placed(to, on, owner, given.name)
    to.law(
        f"{given.owner} on {_listed(on)}",
        law.spec,
        places,
        given.parameters or {},
        code=law.code,
        initial=given.initial,
        label=label,
    )


def _placed(to: Lowering, on: Sequence[str], owner: str, label: str | None) -> tuple[list[str], str | None]:
    """Return the deformations that some names mean, and the label of a law on them: coordinates give theirs."""
    places = [displacement(to, name, owner) for name in on]
    return places, " ".join(on) if label is None and places != list(on) else label


def _lower_formula(to: Lowering, given: LawPart) -> None:
    """Compile a formula and add it."""
    on = (given.on,) if isinstance(given.on, str) else names(given.on, given.owner)
    owner = f"{given.owner} on {_listed(on)}"
    if isinstance(given.law, str):
        raise ModelError(
            f"{owner}: {given.law!r} is text; attach a built-in law with m.attach({given.law!r}, …)"
        )
    if extra := [*(given.parameters or {}), *(["initial"] if given.initial is not None else [])]:
        raise ModelError(f"{owner}: a formula takes no {', '.join(extra)}; insert the numbers")
    add_formula(to, owner, on, given.law, given.energy, given.ranges, given.name)


def add_formula(
    to: Lowering,
    owner: str,
    on: Sequence[str],
    stress: Any,
    energy: Callable[..., Any] | None = None,
    ranges: Mapping[str, tuple[float, float]] | None = None,
    label: str | None = None,
) -> None:
    """Add a law that is a formula of one deformation, its rate and the time.

    Parameters
    ----------
    to : Lowering
    owner : str
        The declaration that adds it, for messages.
    on : sequence of str
        One deformation, or one coordinate, whose displacement from where it is drawn counts.
    stress : callable(e), callable(e, ed) or callable(e, ed, t)
    energy : callable(e), optional
    ranges : mapping of str to (float, float), optional
        As in `LawPart`.
    label : str, optional
        Its name; by default the deformation.
    """
    if len(on) != 1:
        raise ModelError(
            f"{owner}: a formula acts on one deformation, but {len(on)} are named; compile a law of more with "
            "fx.compile_law"
        )
    places, label = _placed(to, on, owner, label)
    to.quantity_kind(places[0], owner)  # before a formula is compiled for it
    found = formula_law(owner, stress, energy, ranges)
    to.law(
        owner, found.law.spec, places, found.parameters, code=found.law.code, label=label, knots=found.knots
    )


def _is_compiled(law: object) -> bool:
    return isinstance(getattr(law, "spec", None), LawSpec) and hasattr(law, "code")


def _listed(on: Sequence[object]) -> str:
    return ", ".join(map(repr, on))
