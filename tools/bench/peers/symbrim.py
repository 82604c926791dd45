"""Times the bicycle in SymBRiM: Kane's equations derived by SymPy, as Python functions by `lambdify`, or printed as C.

The state has all coordinates and speeds, as in SymBRiM's examples: nothing is projected back onto the
constraints, which saves time and costs digits in a long run.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from bench import bicycle
from bench.peers.printed import Rates, printed
from bench.timing import Work
from flexel.base.arrays import Array
from flexel.examples import bicycle_data as data

YAW, ROLL, PITCH, REAR, STEER, FRONT = range(
    2, 8
)  # among the coordinates; the first two are of the rear contact
INDEPENDENT = [ROLL, REAR, STEER]  # speeds


@dataclass(frozen=True)
class BicycleEquations:
    """Functions of the coordinates and speeds, (8,) each.

    Attributes
    ----------
    dynamics : function
        Entries of the mass matrix, row by row, and behind them of the forces (64 + 8,).
    constraints : function
        Entries (40,) of the matrix whose product with the speeds is zero.
    compiled : function, optional
        `rates` all in C.
    """

    dynamics: Callable[..., Any]
    constraints: Callable[..., Any]
    compiled: Rates | None = None

    def rates(self, y: Array) -> Array:
        """Return the time derivative (16,) of coordinates and speeds."""
        if self.compiled is not None:
            return self.compiled(y)
        found = np.array(self.dynamics(*y.tolist()))
        return np.concatenate([y[8:], np.linalg.solve(found[:64].reshape(8, 8), found[64:])])

    def start(self, speed: float, roll_rate: float) -> Array:
        """Return coordinates and speeds (16,) upright, straight ahead, turning about the ground line."""
        q, u = np.zeros(8), np.zeros(8)
        q[PITCH] = data.BENCHMARK["lam"]
        u[ROLL], u[REAR] = roll_rate, -speed / data.BENCHMARK["rR"]
        A = np.array(self.constraints(*q.tolist())).reshape(5, 8)
        rest = [i for i in range(8) if i not in INDEPENDENT]
        u[rest] = -np.linalg.solve(A[:, rest], A[:, INDEPENDENT] @ u[INDEPENDENT])
        return np.concatenate([q, u])


def derive(in_c: bool = False) -> BicycleEquations:
    """Derive the equations of the Whipple bicycle for the benchmark's data, as Python functions or in C."""
    import symbrim
    import sympy
    from sympy.physics.mechanics import dynamicsymbols

    model = symbrim.WhippleBicycle("bicycle")
    model.ground = symbrim.FlatGround("ground")
    model.rear_frame, model.front_frame = symbrim.RigidRearFrame("B"), symbrim.RigidFrontFrame("H")
    model.rear_wheel, model.front_wheel = symbrim.KnifeEdgeWheel("R"), symbrim.KnifeEdgeWheel("F")
    model.rear_tire, model.front_tire = symbrim.NonHolonomicTire("rear"), symbrim.NonHolonomicTire("front")
    model.define_all()
    system = model.to_system()
    system.apply_uniform_gravity(-data.BENCHMARK["g"] * model.ground.get_normal(model.ground.origin))
    q, u = list(model.q), list(model.u)
    system.q_ind, system.q_dep = [coordinate for coordinate in q if coordinate is not q[PITCH]], [q[PITCH]]
    system.u_ind = [u[i] for i in INDEPENDENT]
    system.u_dep = [speed for i, speed in enumerate(u) if i not in INDEPENDENT]
    system.form_eoms(constraint_solver="CRAMER")
    kane, numbers = system.eom_method, values(model)
    order = [list(system.u).index(speed) for speed in u]
    t = dynamicsymbols._t
    slips = system.velocity_constraints.xreplace(
        dict(zip([coordinate.diff(t) for coordinate in q], u, strict=True))
    )
    names = sympy.symbols("q:8 u:8")
    plain = {**numbers, **dict(zip([*q, *u], names, strict=True))}

    def function(arguments: Sequence[Any], entries: Sequence[Any]) -> Callable[..., Any]:
        made: Callable[..., Any] = sympy.lambdify(arguments, entries, modules="math", cse=True)
        return made

    dynamics = [entry.xreplace(plain) for entry in [*kane.mass_matrix[:, order], *kane.forcing]]
    constraints = [entry.xreplace(plain) for entry in slips.jacobian(sympy.Matrix(u))]
    return BicycleEquations(
        function(names, dynamics),
        function(names[:8], constraints),
        printed(names, dynamics) if in_c else None,
    )


def values(model: Any) -> dict[Any, float]:
    """Return the benchmark's data by SymBRiM's symbols: frames along the steering axis, lengths between them."""
    p = data.BENCHMARK
    s, c = float(np.sin(p["lam"])), float(np.cos(p["lam"]))
    d1 = c * (p["c"] + p["w"]) - p["rR"] * s
    d3 = p["rF"] * s - c * p["c"]
    lengths = {
        "d1": d1,
        "d3": d3,
        "d2": (p["rR"] - p["rF"] + (d1 + d3) * s) / c,
        "l1": p["xB"] * c - (p["zB"] + p["rR"]) * s,
        "l2": p["xB"] * s + (p["zB"] + p["rR"]) * c,
        "l3": (p["xH"] - p["w"]) * c - (p["zH"] + p["rF"]) * s,
        "l4": (p["xH"] - p["w"]) * s + (p["zH"] + p["rF"]) * c,
    }
    frames, wheels = (model.rear_frame, model.front_frame), (model.rear_wheel, model.front_wheel)
    found = {
        symbol: lengths[name] for frame in frames for name, symbol in frame.symbols.items() if name in lengths
    }
    turn = np.array([[c, 0, -s], [0, 1, 0], [s, 0, c]])
    for part, name in zip((*frames, *wheels), "BHRF", strict=True):
        xx, yy, xz = p[f"I{name}xx"], p[f"I{name}yy"], p.get(f"I{name}xz", 0.0)
        inertia = np.array([[xx, 0, xz], [0, yy, 0], [xz, 0, p.get(f"I{name}zz", xx)]])
        if name in "BH":
            inertia = turn @ inertia @ turn.T
        symbols = part.body.central_inertia.to_matrix(part.body.frame)
        found |= {
            symbols[i, j]: float(inertia[i, j]) for i in range(3) for j in range(3) if symbols[i, j] != 0
        }
        found[part.body.mass] = p[f"m{name}"]
    return found | {wheel.radius: p[f"r{name}"] for name, wheel in zip("RF", wheels, strict=True)}


def right_hand_side(in_c: bool = False) -> Work:
    """Time accelerations of all speeds at two alternating states, see `bicycle.right_hand_side`."""
    equations = derive(in_c)
    y = equations.start(data.M1_SPEED, bicycle.SMALL)
    points = y, y + 1e-4

    def error(rates: list[Array]) -> float:
        lateral = [8 + ROLL, 8 + STEER]
        return bicycle.accelerations_error(rates[0][lateral], y[lateral])

    return Work(lambda: [equations.rates(point) for point in points], error, count=2)


def manoeuvre() -> Work:
    """Time manoeuvre M1 by the same method and tolerances as in `bicycle.manoeuvre`."""
    from scipy.integrate import solve_ivp

    equations = derive()
    y = equations.start(data.M1_SPEED, data.ROLL_RATE)

    def run() -> Any:
        return solve_ivp(
            lambda t, state: equations.rates(state), (0, 5.0), y, method="DOP853", rtol=1e-7, atol=1e-9
        )

    return Work(run, lambda motion: abs(motion.y[STEER, -1] - data.M1_STEER_5S))


def manoeuvre_in_c() -> Work:
    """Time the same with the equations in C, by Hairer's DOP853: only the call of the equations is Python."""
    from scipy.integrate import ode

    equations = derive(in_c=True)
    y = equations.start(data.M1_SPEED, data.ROLL_RATE)

    def run() -> Array:
        solver = ode(lambda t, state: equations.rates(state)).set_integrator(
            "dop853", rtol=1e-7, atol=1e-9, nsteps=100_000
        )
        end: Array = solver.set_initial_value(y, 0.0).integrate(5.0)
        if not solver.successful():
            raise RuntimeError("DOP853 did not reach the end")
        return end

    return Work(run, lambda end: abs(end[STEER] - data.M1_STEER_5S))


ROWS: dict[str, Callable[..., Work]] = {
    "bicycle_rhs": right_hand_side,
    "bicycle_M1": manoeuvre,
    "build_bicycle": lambda: Work(derive),
}
IN_C: dict[str, Callable[..., Work]] = {
    "bicycle_rhs": lambda: right_hand_side(in_c=True),
    "bicycle_M1": manoeuvre_in_c,
}
