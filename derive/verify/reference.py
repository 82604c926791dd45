"""Every output of every kernel from the undifferentiated definition, by differences in many digits.

Central differences with a step of 1e-12 in 60 digits: the truncation error is about 1e-24, and rounding stays
below that for third derivatives too. Energies are quadratic in the rates, so their rate derivatives are exact
differences with a step of one.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from decimal import Decimal, localcontext

import numpy as np
from numpy.typing import NDArray

from flexel.derive.verify.definition import CONTEXT, Definition, LawDefinition, Vector, many_digits

Array = NDArray[np.float64]
_STEP = Decimal("1e-12")


def _moved(x: Vector, step: Decimal | int, direction: Vector) -> Vector:
    return [a + step * b for a, b in zip(x, direction, strict=True)]


def _dot(x: Vector, y: Vector) -> Decimal:
    return sum((a * b for a, b in zip(x, y, strict=True)), Decimal(0))


def _unit(n: int, i: int) -> Vector:
    return [Decimal(int(i == j)) for j in range(n)]


def _central(function: Callable[[Decimal], Vector]) -> Vector:
    """Return the first derivative at zero of a column that depends on one number."""
    plus, minus = function(_STEP), function(-_STEP)
    return [(a - b) / (2 * _STEP) for a, b in zip(plus, minus, strict=True)]


def _central_second(function: Callable[[Decimal], Vector]) -> Vector:
    """Return the second derivative at zero of a column that depends on one number."""
    plus, middle, minus = function(_STEP), function(Decimal(0)), function(-_STEP)
    return [(a - 2 * b + c) / _STEP**2 for a, b, c in zip(plus, middle, minus, strict=True)]


def _columns(function: Callable[[Vector], Vector], x: Vector, rows: int, columns: Sequence[int]) -> Array:
    """Compute some columns of the Jacobian of a function, (rows, len(x)); the others are not-a-number."""
    jacobian = np.full((rows, len(x)), np.nan)
    for j in columns:
        direction = _unit(len(x), j)
        jacobian[:, j] = _central(lambda h, d=direction: function(_moved(x, h, d)))  # type: ignore[misc]
    return jacobian


def _array(values: Vector) -> Array:
    return np.array([float(value) for value in values])


class Reference:
    """Outputs of the kernels of one element at one configuration.

    Parameters
    ----------
    definition : Definition
    data : mapping
        The inputs x, v, a, p, e, sigma, tau of the kernels, one column each.
    columns : sequence of int
        The columns of the tangents that are worth their time.
    """

    def __init__(self, definition: Definition, data: Mapping[str, Array], columns: Sequence[int]) -> None:
        self.d = definition
        self.x, self.v, self.a = (many_digits(data[name]) for name in ("x", "v", "a"))
        self.e, self.sigma, self.tau = (many_digits(data[name]) for name in ("e", "sigma", "tau"))
        definition.p = many_digits(data["p"])
        self.every = range(definition.n)
        self.columns = columns

    def outputs(self, kernel: str) -> dict[str, Array]:
        """Compute the outputs of a kernel by name; entries that were not requested are not-a-number."""
        table: dict[str, Callable[[], dict[str, Array]]] = {
            "position": self._position,
            "acceleration": self._acceleration,
            "inertia": self._inertia,
            "rates": self._rates,
            "kinematics": self._kinematics,
            "stiffness": self._stiffness,
            "tangent": self._tangent,
            "outputs": self._outputs,
        }
        with localcontext(CONTEXT):
            return table[kernel]()

    def _position(self) -> dict[str, Array]:
        d, x = self.d, self.x
        V = np.array([_array(d.s(x, _unit(d.n, i))) for i in self.every]).T.reshape(d.k, d.n)
        return {"e": _array(d.D(x)), "De": _columns(d.D, x, d.m, self.every), "V": V}

    def _acceleration(self) -> dict[str, Array]:
        zero = [Decimal(0)] * self.d.n
        second = self._mode_accelerations(self.x, self.v, zero)
        return {"g": _array(second[: self.d.m]), "gs": _array(second[self.d.m :])}

    def _deformation_rates(self, x: Vector, v: Vector) -> Vector:
        return _central(lambda t: self.d.D(_moved(x, t, v)))

    def _mode_rates(self, x: Vector, v: Vector) -> Vector:
        """Return Phi = (De v, s)."""
        return [*self._deformation_rates(x, v), *self.d.s(x, v)]

    def _mode_accelerations(self, x: Vector, v: Vector, a: Vector) -> Vector:
        """Return Psi: second derivative of D, first of s, along the motion x + v t + a t^2/2."""
        d = self.d
        e = _central_second(lambda t: d.D(_moved(_moved(x, t, v), t * t / 2, a)))
        s = _central(lambda t: d.s(_moved(x, t, v), _moved(v, t, a)))
        return [*e, *s]

    def _rates(self) -> dict[str, Array]:
        v, rows = self.v, self.d.m + self.d.k
        return {"Phi_x": _columns(lambda y: self._mode_rates(y, v), self.x, rows, self.every)}

    def _kinematics(self) -> dict[str, Array]:
        x, v, a, rows = self.x, self.v, self.a, self.d.m + self.d.k
        return {
            "Psi_x": _columns(lambda y: self._mode_accelerations(y, v, a), x, rows, self.every),
            "Psi_v": _columns(lambda w: self._mode_accelerations(x, w, a), v, rows, self.every),
        }

    def _stiffness(self) -> dict[str, Array]:
        return {"K": _columns(self._nodal_forces, self.x, self.d.n, self.every)}

    def _nodal_forces(self, x: Vector) -> Vector:
        """Return De' sigma + V' tau, (n,)."""
        d, forces = self.d, []
        for i in self.every:
            unit = _unit(d.n, i)
            De_i = _central(lambda h, unit=unit: d.D(_moved(x, h, unit)))  # type: ignore[misc]
            forces.append(_dot(self.sigma, De_i) + _dot(self.tau, d.s(x, unit)))
        return forces

    def _outputs(self) -> dict[str, Array]:
        values = self.d.outputs(self.x, self._nodal_forces(self.x), self.e, [*self.sigma, *self.tau])
        ends = np.cumsum([math.prod(shape) for shape in self.d.reported.values()])
        parts = np.split(_array(values), ends[:-1])
        pairs = zip(self.d.reported.items(), parts, strict=True)
        return {name: part.reshape(shape) for (name, shape), part in pairs}

    def _momenta(self, x: Vector, v: Vector) -> Vector:
        """Return M v, exactly, from the energy."""
        d, values = self.d, []
        for i in self.every:
            unit = _unit(d.n, i)
            values.append((d.T(x, _moved(v, 1, unit)) - d.T(x, _moved(v, -1, unit))) / 2)
        return values

    def _gradient(self, function: Callable[[Vector], Decimal]) -> Callable[[Vector], Vector]:
        def gradient(x: Vector) -> Vector:
            units = (_unit(len(x), i) for i in self.every)
            return [_central(lambda h, u=u: [function(_moved(x, h, u))])[0] for u in units]  # type: ignore[misc]

        return gradient

    def _residual(self, x: Vector, v: Vector, a: Vector, body_forces: bool = True) -> Vector:
        """Return M a + h - f: Lagrange's d(dT/dv)/dt - dT/dx + dU/dx along the motion (v, a)."""
        inertia = _central(lambda t: self._momenta(_moved(x, t, v), _moved(v, t, a)))
        centrifugal = self._gradient(lambda y: self.d.T(y, v))(x)
        weight = self._gradient(self.d.U)(x) if body_forces else [Decimal(0)] * self.d.n
        return [i - c + w for i, c, w in zip(inertia, centrifugal, weight, strict=True)]

    def _inertia(self) -> dict[str, Array]:
        d, x = self.d, self.x
        zero = [Decimal(0)] * d.n
        return {
            "M": np.array([_array(self._momenta(x, _unit(d.n, i))) for i in self.every]),
            "h": _array(self._residual(x, self.v, zero, body_forces=False)),
            "f": -_array(self._gradient(d.U)(x)),
            "U": _array([d.U(x)]),
        }

    def _tangent(self) -> dict[str, Array]:
        x, v, a = self.x, self.v, self.a
        return {
            "R_x": _columns(lambda y: self._residual(y, v, a), x, self.d.n, self.columns),
            "R_v": _columns(lambda w: self._residual(x, w, a, body_forces=False), v, self.d.n, self.columns),
        }


def law_outputs(definition: LawDefinition, kernel: str, data: Mapping[str, Array]) -> dict[str, Array]:
    """Compute the outputs of a kernel of a law at one state; `data` has its inputs e, ed, s, z, t, p."""
    e, ed, s, z = (many_digits(data[name]) for name in ("e", "ed", "s", "z"))
    definition.p, definition.t = many_digits(data["p"]), many_digits(data["t"])
    m, k, nz = len(e), len(s), len(z)
    inputs = [*e, *ed, *s, *z]
    with localcontext(CONTEXT):
        if kernel == "tangent":
            return {"J": _columns(definition.answers, inputs, m + k + nz, range(len(inputs)))}
        answers = definition.answers(inputs)
        sigma, tau, zd = answers[:m], answers[m : m + k], answers[m + k :]

        def stored(h: Decimal) -> Vector:
            return [definition.energy([*_moved(e, h, ed), *ed, *s, *_moved(z, h, zd)])]

        P = _dot(sigma, ed) + _dot(tau, s) - _central(stored)[0]
        values = {"sigma": sigma, "tau": tau, "zd": zd, "U": [definition.energy(inputs)], "P": [P]}
        return {name: _array(value) for name, value in values.items()}
