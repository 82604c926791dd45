"""Outputs of the kernels by differences of the compiled kernel one order below, in double precision.

Central differences with two steps of Richardson's extrapolation (error of order h^6), from three initial
steps; of the three, each entry takes the one that the extrapolation itself changed least. A whole stencil is
one call of the compiled kernel. Outputs of the lowest order (e, V, s, M, U, an element's outputs and a law's stresses)
have no kernel below them and are missing here; they are compared with the definition.
"""

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from flexel.derive.verify.kernel_calls import Compiled

Array = NDArray[np.float64]
Data = Mapping[str, Array]
_STEPS = (2e-3, 2e-4, 2e-5)
# Central differences with steps h, h/2, h/4: weights of order h^6, and h^4 (of the last two) to compare.
_FRACTIONS = (1.0, 0.5, 0.25)
_SIXTH = (1 / 45, -20 / 45, 64 / 45)
_FOURTH = (0.0, -1 / 3, 4 / 3)
_NO_PERIODS = np.zeros((1, 1))


def along(function: Callable[[Data], Array], data: Data, motion: Data, periods: Array = _NO_PERIODS) -> Array:
    """Compute the derivative of a kernel's output along a motion of its inputs.

    Parameters
    ----------
    function : callable
        From inputs (count, rows) to an output (count, ...).
    data, motion : mapping
        Inputs, and the rates of some of them.
    periods : ndarray (count, ...), optional
        Periods of the entries of the output, zero where there is none.
    """
    tried = [_extrapolated(function, data, motion, periods, step) for step in _STEPS]
    best, uncertainty = tried[0]
    for other, its_uncertainty in tried[1:]:
        best = np.where(its_uncertainty < uncertainty, other, best)
        uncertainty = np.minimum(uncertainty, its_uncertainty)
    return best


def _extrapolated(
    function: Callable[[Data], Array], data: Data, motion: Data, periods: Array, step: float
) -> tuple[Array, Array]:
    """Compute the derivative along a motion from one initial step, and the change in the last extrapolation."""
    steps = [sign * fraction * step for fraction in _FRACTIONS for sign in (1.0, -1.0)]
    moved = {
        name: np.concatenate([values + h * motion[name] if name in motion else values for h in steps])
        for name, values in data.items()
    }
    values = function(moved)
    values = values.reshape(len(steps), len(values) // len(steps), *values.shape[1:])
    sixth, fourth = np.zeros((2, *values.shape[1:]))
    for i, fraction in enumerate(_FRACTIONS):
        difference = values[2 * i] - values[2 * i + 1]
        if periods.any():
            turns = np.divide(difference, periods, out=np.zeros_like(difference), where=periods > 0)
            difference = difference - periods * np.round(turns)
        difference /= 2 * fraction * step
        sixth += _SIXTH[i] * difference
        fourth += _FOURTH[i] * difference
    return sixth, np.abs(sixth - fourth)


def jacobian(function: Callable[[Data], Array], data: Data, name: str, periods: Array = _NO_PERIODS) -> Array:
    """Compute the derivative of a kernel's output by one of its inputs, (count, ..., rows of the input)."""
    count, rows = data[name].shape
    repeated = {key: np.repeat(values, rows, axis=0) for key, values in data.items()}
    directions = np.tile(np.eye(rows), (count, 1))
    repeating = np.repeat(periods, rows, axis=0) if periods.any() else periods
    columns = along(function, repeated, {name: directions}, repeating)
    return np.moveaxis(columns.reshape(count, rows, *columns.shape[1:]), 1, -1)


class Differences:
    """Outputs of an element's kernels, each from the kernel below it.

    Parameters
    ----------
    compiled : Compiled
    data : mapping
        Inputs of all kernels, each (count, rows).
    """

    def __init__(self, compiled: Compiled, data: Data, periods: Array) -> None:
        self.call = compiled
        self.data = data
        self.periods = periods

    def outputs(self, kernel: str) -> dict[str, Array]:
        """Compute what can be found from the kernels below; the kernel of the outputs has none."""
        table: dict[str, Callable[[], dict[str, Array]]] = {
            "position": self._position,
            "acceleration": self._acceleration,
            "inertia": self._inertia,
            "rates": self._rates,
            "kinematics": self._kinematics,
            "stiffness": self._stiffness,
            "tangent": self._tangent,
            "outputs": dict,
        }
        return table[kernel]()

    def _output(self, kernel: str, name: str) -> Callable[[Data], Array]:
        return lambda data: self.call(kernel, data)[name]

    def _position(self) -> dict[str, Array]:
        return {"De": jacobian(self._output("position", "e"), self.data, "x", self.periods)}

    def _acceleration(self) -> dict[str, Array]:
        rates = along(self._mode_rates, self.data, {"x": self.data["v"]})
        m = self.periods.shape[1]
        return {"g": rates[:, :m], "gs": rates[:, m:]}

    def _mode_rates(self, data: Data) -> Array:
        """Return De v and V v."""
        position = self.call("position", data)
        B = np.concatenate([position["De"], position["V"]], axis=1)
        return np.asarray(np.einsum("bij,bj->bi", B, data["v"]))

    def _mode_accelerations(self, data: Data) -> Array:
        position, acceleration = self.call("position", data), self.call("acceleration", data)
        B = np.concatenate([position["De"], position["V"]], axis=1)
        Psi: Array = np.hstack([acceleration["g"], acceleration["gs"]]) + np.einsum(
            "bij,bj->bi", B, data["a"]
        )
        return Psi

    def _rates(self) -> dict[str, Array]:
        return {"Phi_x": jacobian(self._mode_rates, self.data, "x")}

    def _kinematics(self) -> dict[str, Array]:
        return {
            "Psi_x": jacobian(self._mode_accelerations, self.data, "x"),
            "Psi_v": jacobian(self._mode_accelerations, self.data, "v"),
        }

    def _nodal_forces(self, data: Data) -> Array:
        position = self.call("position", data)
        B = np.concatenate([position["De"], position["V"]], axis=1)
        forces: Array = np.einsum("bij,bi->bj", B, np.hstack([data["sigma"], data["tau"]]))
        return forces

    def _stiffness(self) -> dict[str, Array]:
        return {"K": jacobian(self._nodal_forces, self.data, "x")}

    def _inertia(self) -> dict[str, Array]:
        v = self.data["v"]
        mass = self._output("inertia", "M")
        Mdot = along(mass, self.data, {"x": v})
        M_x = jacobian(mass, self.data, "x")
        return {
            "h": np.einsum("bij,bj->bi", Mdot, v) - np.einsum("bi,bijk,bj->bk", v, M_x, v) / 2,
            "f": -jacobian(self._output("inertia", "U"), self.data, "x")[:, 0],
        }

    def _residual(self, data: Data) -> Array:
        inertia = self.call("inertia", data)
        residual: Array = np.einsum("bij,bj->bi", inertia["M"], data["a"]) + inertia["h"] - inertia["f"]
        return residual

    def _tangent(self) -> dict[str, Array]:
        return {
            "R_x": jacobian(self._residual, self.data, "x"),
            "R_v": jacobian(self._residual, self.data, "v"),
        }


def law_differences(compiled: Compiled, kernel: str, data: Data) -> dict[str, Array]:
    """Compute a law's tangent from its stresses and rates of z, and its dissipated power from its stored energy."""
    law = compiled("law", data)
    if kernel == "law":
        motion = {"e": data["ed"], "z": law["zd"]}
        stored = along(lambda data: compiled("law", data)["U"], data, motion)
        work = np.einsum("bi,bi->b", law["sigma"], data["ed"]) + np.einsum("bi,bi->b", law["tau"], data["s"])
        return {"P": work[:, None] - stored}

    def answers(data: Data) -> Array:
        law = compiled("law", data)
        return np.hstack([law["sigma"], law["tau"], law["zd"]])

    return {"J": np.concatenate([jacobian(answers, data, name) for name in ("e", "ed", "s", "z")], axis=-1)}
