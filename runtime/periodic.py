"""Periodic motion: linearized coefficients over a period, harmonic balance, Floquet multipliers, nonlinear solutions.

A nominal periodic motion is given by periodic prescribed motions with the freedoms held; small vibrations about
it obey M q'' + C q' + K q = F with coefficients of the same period, which are sampled, never differenced, and
expanded in Fourier series.  The full nonlinear periodic motion is found with the same coefficients as its
Jacobian.  Source: Jonker (1988); Schwab and Meijaard, "SPACAR" (2004), harmonic balance: (2k+1) nd linear equations.
Imports numpy, scipy.integrate and the linearization.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from flexel import dynamics
from flexel.errors import LinearizationError, PositionError
from flexel.linearize import ComplexArray, Linearization, linearize
from flexel.state import State
from flexel.states import unwrap, with_freedoms
from flexel.structure import Array

if TYPE_CHECKING:
    from flexel.system import System

TOLERANCE = 1e-11
MAX_ITERATIONS = 30


@dataclass(frozen=True)
class Coefficients:
    """Periodic coefficients of M q'' + C q' + K q = F at equidistant times of one period.

    Attributes
    ----------
    omega : float
        Base frequency 2 pi / period [rad/s].
    M, C, K : ndarray (ns, nd, nd)
    F : ndarray (ns, nd)
    names : tuple of str
        The freedoms.
    """

    omega: float
    M: Array
    C: Array
    K: Array
    F: Array
    names: tuple[str, ...]

    @property
    def samples(self) -> int:
        """Number of times in the period."""
        return int(self.F.shape[0])

    def harmonic_balance(self, harmonics: int) -> PeriodicVibration:
        """Periodic solution with the given number of harmonics, by (2k+1) nd linear equations.

        Raises
        ------
        LinearizationError
            If there are too few samples for the harmonics, or the equations are singular (a resonance without
            damping).
        """
        k, nd, ns = harmonics, self.F.shape[1], self.samples
        if ns < 4 * k + 1:
            raise LinearizationError(
                f"{k} harmonics need {4 * k + 1} samples of the coefficients; there are {ns}: take more samples"
            )
        order = np.arange(-k, k + 1)
        M, C, K, F = (np.fft.fft(z, axis=0) / ns for z in (self.M, self.C, self.K, self.F))
        shift = (order[:, None] - order[None, :]) % ns
        iw = 1j * self.omega * order
        A = M[shift] * (iw**2)[None, :, None, None] + C[shift] * iw[None, :, None, None] + K[shift]
        matrix = A.transpose(0, 2, 1, 3).reshape((2 * k + 1) * nd, (2 * k + 1) * nd)
        try:
            X = np.linalg.solve(matrix, F[order % ns].reshape(-1)).reshape(2 * k + 1, nd)
        except np.linalg.LinAlgError as error:
            raise LinearizationError(
                f"harmonic balance at {self.omega:g} rad/s is singular: an undamped resonance; add damping"
            ) from error
        return PeriodicVibration(self, X, self._neglected(X, M, C, K))

    def _neglected(self, X: ComplexArray, M: ComplexArray, C: ComplexArray, K: ComplexArray) -> float:
        """Amplitude of the harmonics left out: what the residual there drives, by the mean coefficients."""
        k = X.shape[0] // 2
        w = PeriodicVibration(self, X, 0.0)
        q, qd, qdd = w.samples()
        r = self.F - sum(np.einsum("sij,sj->si", z, y) for z, y in ((self.M, qdd), (self.C, qd), (self.K, q)))
        R = np.fft.fft(r, axis=0) / self.samples
        total = 0.0
        for j in range(k + 1, self.samples // 2):
            s = 1j * self.omega * j
            total += 2 * float(np.abs(np.linalg.solve(s * s * M[0] + s * C[0] + K[0], R[j])).max())
        return total

    def floquet_multipliers(self) -> ComplexArray:
        """Eigenvalues (2 nd,) of the transition matrix of (q', q) over one period, largest modulus first."""
        nd, period = self.F.shape[1], 2 * np.pi / self.omega
        state = np.zeros((self.samples, 2 * nd, 2 * nd))
        state[:, :nd] = -np.linalg.solve(self.M, np.concatenate([self.C, self.K], axis=2))
        state[:, nd:, :nd] = np.eye(nd)
        hat = np.fft.rfft(state, axis=0) / self.samples
        weight = np.full(hat.shape[0], 2.0)
        weight[0] = 1.0
        if self.samples % 2 == 0:
            weight[-1] = 1.0
        orders = np.arange(hat.shape[0])

        def rate(t: float, y: Array) -> Array:
            phase = weight * np.exp(1j * self.omega * orders * t)
            A = np.tensordot(phase, hat, axes=1).real
            return np.asarray((A @ y.reshape(2 * nd, 2 * nd)).ravel())

        run = solve_ivp(rate, (0.0, period), np.eye(2 * nd).ravel(), method="DOP853", rtol=1e-11, atol=1e-13)
        w = np.linalg.eigvals(run.y[:, -1].reshape(2 * nd, 2 * nd)).astype(complex)
        return np.asarray(w[np.lexsort((w.imag, -np.round(np.abs(w), 11)))])


@dataclass(frozen=True)
class PeriodicVibration:
    """A periodic solution of the linearized equations: q(t) = Σ X_j exp(i j omega t), j = -k…k.

    Attributes
    ----------
    coefficients : Coefficients
    X : ndarray of complex (2k + 1, nd)
    neglected : float
        Estimated amplitude of all harmonics left out.
    """

    coefficients: Coefficients
    X: ComplexArray
    neglected: float

    @property
    def harmonics(self) -> int:
        """Number of harmonics k."""
        return int(self.X.shape[0] // 2)

    def at(self, t: Array) -> tuple[Array, Array, Array]:
        """Freedoms, their rates and accelerations (nt, nd) at times t (nt,)."""
        return fourier_sum(self.X, self.coefficients.omega, t)

    def samples(self) -> tuple[Array, Array, Array]:
        """The same at the sampled times of the coefficients."""
        ns, omega = self.coefficients.samples, self.coefficients.omega
        return self.at(np.arange(ns) * 2 * np.pi / (omega * ns))


def fourier_sum(X: ComplexArray, omega: float, t: Array) -> tuple[Array, Array, Array]:
    """Value, first and second rate (nt, nd) of Σ X_j exp(i j omega t)."""
    k = X.shape[0] // 2
    iw = 1j * omega * np.arange(-k, k + 1)
    E = np.exp(np.outer(t, iw))
    return (E @ X).real, (E @ (iw[:, None] * X)).real, (E @ ((iw**2)[:, None] * X)).real


def cosine_sine(series: Array, count: int) -> NDArray[np.float64]:
    """Fourier coefficients [[a0, 0], [a1, b1], …] of a series over one period: Σ a_j cos jωt + b_j sin jωt."""
    c = np.fft.rfft(series) / series.size
    if count >= c.size:
        raise LinearizationError(
            f"{count} harmonics need more than {2 * count} samples; there are {series.size}"
        )
    pairs = np.column_stack([2 * c.real, -2 * c.imag])[: count + 1]
    pairs[0] = c[0].real, 0.0
    return pairs


def driven_state(system: System, t: float, q: Array, qd: Array, qdd: Array, near: State) -> State:
    """State in which the freedoms move as given; its stresses and reactions hold what drives them."""
    kinematics, structure = system.kinematics, system.structure
    c = kinematics.position(t, q, near.x)
    v = kinematics.velocity(c, kinematics.velocity_matrix(c), qd)
    e = with_freedoms(structure, unwrap(structure, c.e, near.e), q, system.roles)
    return dynamics.complete(kinematics, system.loads, c, v, e, qdd)


@dataclass(frozen=True)
class Orbit:
    """A periodic motion, sampled: states and linearizations at equidistant times of one period.

    Attributes
    ----------
    period : float
        [s]
    states : list of State
    linearizations : list of Linearization
    coefficients : Coefficients
        F is what the held or given motion lacks in force: zero if it is a true motion.
    """

    period: float
    states: list[State]
    linearizations: list[Linearization]
    coefficients: Coefficients

    @property
    def t(self) -> Array:
        """Sampled times (ns,) [s]."""
        return np.array([state.t for state in self.states])

    def __getitem__(self, name: str) -> Array:
        """Values (ns,) of a named quantity over the period."""
        return np.array([state[name] for state in self.states])

    def coordinates(self, node: str, vibration: PeriodicVibration | None = None) -> Array:
        """Coordinates (ns, …) of a node, with a small vibration about the orbit if one is given."""
        places = self.states[0].structure.places(node)
        x = np.array([state.x[places] for state in self.states])
        if vibration is None:
            return x
        q = vibration.samples()[0]
        free = places < self.states[0].structure.nf
        for i, lin in enumerate(self.linearizations):
            x[i, free] += lin.transfer.G[places[free], : q.shape[1]] @ q[i]
        return x


def orbit(
    system: System,
    period: float,
    samples: int,
    motion: Callable[[Array], tuple[Array, Array, Array]] | None = None,
    start: State | None = None,
) -> Orbit:
    """Sample a periodic motion and linearize along it.

    Parameters
    ----------
    period : float
        [s]
    samples : int
        Equidistant times, from that of `start` on.
    motion : callable, optional
        Freedoms, rates and accelerations (ns, nd) at times (ns,); by default the freedoms are held at their
        initial values, while the prescribed motions go on: the nominal motion.
    start : State, optional
        The initial state by default.

    Raises
    ------
    LinearizationError
        If the system has kinematic coordinates, whose values no periodicity determines.
    """
    if system.roles.nq != system.roles.nd:
        raise LinearizationError(
            f"periodic motion of a non-holonomic system with kinematic coordinates {system.kinematic} is not "
            "available; prescribe them or leave the rolling condition out"
        )
    state = start or system.rest
    t = state.t + np.arange(samples) * period / samples
    q0, nd = state.q, system.roles.nd
    still = np.zeros((samples, nd))
    q, qd, qdd = motion(t) if motion else (np.tile(q0, (samples, 1)), still, still)
    states, lins, F = [], [], np.zeros((samples, nd))
    for i in range(samples):
        state = driven_state(system, float(t[i]), q[i], qd[i], qdd[i], state)
        lins.append(linearize(system.kinematics, state))
        F[i] = -system.residual(float(t[i]), q[i], qd[i], qdd[i], state)
        states.append(state)
    M, C, K = (np.array([getattr(z, name) for z in lins]) for name in ("M", "C", "K"))
    return Orbit(period, states, lins, Coefficients(2 * np.pi / period, M, C, K, F, system.dynamic))


def periodic_motion(
    system: System,
    period: float,
    harmonics: int,
    start: PeriodicVibration | None = None,
    samples: int | None = None,
) -> tuple[Orbit, PeriodicVibration]:
    """Nonlinear periodic motion by harmonic balance, Newton's method with the analytic Jacobian.

    Parameters
    ----------
    start : PeriodicVibration, optional
        First guess; the linearized solution about the nominal motion by default.

    Returns
    -------
    Orbit, PeriodicVibration
        The motion, and its Fourier coefficients with the estimate of what was left out.

    Raises
    ------
    PositionError
        If Newton's method does not converge; says what was reached.
    """
    ns, k = samples or 4 * harmonics + 4, harmonics
    guess = start or orbit(system, period, ns).coefficients.harmonic_balance(k)
    X = np.asarray(guess.X)
    if start is None:
        X = X.copy()
        X[k] += system.rest.q
    omega, size = 2 * np.pi / period, np.inf
    for _ in range(MAX_ITERATIONS):
        found = orbit(system, period, ns, lambda t, X=X: fourier_sum(X, omega, t - system.rest.t))  # type: ignore[misc]
        step = found.coefficients.harmonic_balance(k)
        size = float(np.abs(step.X).max())
        X = X + step.X
        if size < TOLERANCE * max(float(np.abs(X).max()), 1e-3):
            return found, PeriodicVibration(found.coefficients, X, step.neglected)
    raise PositionError(
        f"no periodic motion found at {omega:g} rad/s with {k} harmonics in {MAX_ITERATIONS} iterations (last change "
        f"{size:.2g}): start from the solution at a nearby speed, or take more harmonics"
    )


@dataclass(frozen=True)
class SpeedFamily:
    """Coefficients of a nominal motion as polynomials in its speed: M; C0 + C1 ω; K, F of second degree.

    Exact where the prescribed motion depends on the phase ω t alone and damping is linear.
    """

    M: Array
    C: Array  # (2, ns, nd, nd)
    K: Array  # (3, ns, nd, nd)
    F: Array  # (3, ns, nd)
    names: tuple[str, ...]

    @classmethod
    def through(cls, orbits: Sequence[Orbit]) -> SpeedFamily:
        """The family through three orbits that differ only in their speed."""
        if len({z.period for z in orbits}) != 3:
            raise LinearizationError("a family of speeds needs three orbits of three different periods")
        w = np.array([z.coefficients.omega for z in orbits])
        V = np.linalg.inv(np.vander(w, 3, increasing=True))
        C, K, F = (np.array([getattr(z.coefficients, n) for z in orbits]) for n in ("C", "K", "F"))
        polynomial = [np.tensordot(V, z, axes=1) for z in (C, K, F)]
        first = orbits[0].coefficients
        return cls(first.M, polynomial[0], polynomial[1], polynomial[2], first.names)

    def at(self, omega: float) -> Coefficients:
        """Coefficients at a speed [rad/s]."""
        powers = np.array([1.0, omega, omega**2])
        C, K, F = (np.tensordot(powers, z, axes=1) for z in (self.C, self.K, self.F))
        return Coefficients(omega, self.M, C, K, F, self.names)
