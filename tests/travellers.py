"""Objects of every kind that are sent to another process, and their numbers, for tests."""

import hashlib
import warnings
from collections.abc import Callable, Mapping
from functools import cache
from types import FunctionType
from typing import Any

import numpy as np
from mechanisms import DATA, cantilever, disc, rssr
from rides import ride
from scipy.sparse import issparse
from valid_flexures import tables

import flexel as fx
from flexel.derive import Deformation, Element, Law, Parameter, PlanarPoint, symbol
from flexel.examples.vehicle import vehicle
from flexel.examples.vehicle_runs import rounded_ramp

K = Parameter("k", 1, "N/m", "stiffness")
E, ED = symbol("e"), symbol("ed")
SIGMA, STORED = K.symbol * E + E**3 + ED, K.symbol * E**2 / 2 + E**4 / 4
HARDENING = Law("own_hardening", "k e + e^3 + ed", (K,), (E,), (ED,), (), (SIGMA,), (), STORED)
END, LENGTH = PlanarPoint("p"), Parameter("length", 1, "m", "length at rest")
SQUARE = Deformation("square", "m", END.x.dot(END.x) / LENGTH.symbol - LENGTH.symbol)
TETHER = Element(
    "own_tether", (END,), (LENGTH,), deformations=(SQUARE,), doc="square = |p|^2/length - length"
)


def push(t: Any) -> Any:
    """A force as a function of time."""
    return 0.1 * np.sin(2 * t)


def steered(state: fx.State) -> float:
    """The function of an event."""
    return state["steer.angle"] - 0.01


class Step:
    """A function of time as a user writes one: an object with rates."""

    def rates(self, t: float) -> tuple[float, float, float]:
        """Value, first and second rate."""
        return 0.01 * t, 0.01, 0.0


def pushed() -> fx.Model:
    """A mass on a formula's spring, pushed by a function, next to a point that an object moves."""
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.point("P", (1, 0))
    m.point("D", (0, 1))
    m.fix("P.y", "D.y")
    m.point_mass("mass", "P", 1.0)
    m.truss("spring", "O", "P")
    m.law("spring.elongation", lambda e, ed: 4 * e + e**3 + 0.1 * ed)
    m.load("P.x", push)
    m.prescribe("D.x", Step())
    return m


def sampled() -> fx.System:
    """A mass on a line with a sampled controller."""
    m = fx.Model()
    m.point("P", (1, 0))
    m.fix("P.y")
    m.point_mass("mass", "P", 1.0)
    m.controller([[5.0, 1.0]], inputs=["P.x", "P.x'"], outputs=["P.x"], period=0.01)
    return m.build()


def sampled_loop() -> Any:
    """The loop of a linear controller, whose matrix is the same at all states."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", fx.UnsteadyWarning)
        return sampled().linearize().sampled()


def tabulated() -> fx.Model:
    """The slider of a spring with a curve, driven by tables and other given functions of time."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.fix("A.y", "A.z")
    m.truss("strut", "O", "A")
    m.point_mass("body", "A", 2.0)
    m.spring("strut.elongation", fx.Curve([[0, 3e4], [-700.0, 4e4]], breaks=[0.07]))
    times = np.linspace(0.0, 1.0, 8)
    m.load("A.x", fx.Table(times, times**2))
    m.load("A.x", fx.Ramp(0, 1, 0, 5))
    m.load("A.x", fx.Harmonic(1.0, 3.0))
    m.load("A.x", fx.Polynomial((1.0, 2.0)))
    return m


def roped() -> tuple[fx.Model, fx.Rope]:
    """A rope over a quarter of a fixed sheave."""
    m = fx.Model()
    m.point("C", (0, 0), fixed=True)
    m.angle("G", fixed=True)
    m.sheave("S", "C", "G", radius=0.1)
    A, B = m.point("A", (-0.101, -0.4)), m.point("B", (0.4, 0.101))
    m.fix(A, B)
    contact = fx.Contact(1e8, dissipation=10.0)
    given = {"radius": 1e-3, "tension": 5.0, "EA": 1e5, "EI": 1e-5, "mass_per_length": 0.01, "damping": 1e-3}
    return m, m.rope("rope", [A, "S", B], 20, contact=contact, **given)


@cache
def motion() -> fx.Motion:
    """A bicycle's motion with an event."""
    return ride(0.5, 9, events=[fx.Event("steered", steered)])


@cache
def leaf() -> fx.System:
    """A steel strip clamped at one end."""
    return cantilever()


def hung() -> fx.Motion:
    """A motion by an implicit method, with its energy balance."""
    return disc(np.pi / 2 - 0.2).build().simulate(0.05, samples=3, method="generalized-alpha")


def failed() -> BaseException:
    """An error that holds the motion so far."""
    table = fx.Table([0.0, 0.1, 0.2, 0.3], [0.0, 0.1, 0.2, 0.3])
    m = tabulated()
    m.load("A.x", table)
    try:
        m.build().simulate(1.0)
    except fx.FlexelError as error:
        return error
    raise AssertionError("the table ends at 0.3 s")


def periodic() -> fx.PeriodicSolution:
    """A forced vibration whose force is a function."""
    m = pushed()
    return m.build().periodic(period=np.pi, harmonics=3)


def branch() -> fx.PeriodicBranch:
    """Vibrations of the same over the speed of the force."""
    return pushed().build().periodic_branch(period=np.pi, end=3.0, harmonics=2)


def pushed_many() -> tuple[fx.Ensemble, fx.Linearizations, fx.RootLoci]:
    """Motions, linearized equations and root loci of variants of a mass on a spring."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.fix("A.y", "A.z")
    m.point_mass("body", "A", 2.0)
    m.spring("A.x", 3.0)
    s, values = m.build(), {"body.mass": [1.0, 2.0]}
    many = s.simulate_many(0.1, parameters=values, initial={"A.x'": 1.0}, samples=2)
    return many, s.linearize_many(parameters=values), s.root_loci(parameters=values)


def own_law() -> fx.Model:
    """A mass on a spring of the user's own law."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.fix("A.y", "A.z")
    m.truss("strut", "O", "A")
    m.point_mass("body", "A", 2.0)
    m.law("strut.elongation", fx.compile_law(HARDENING), k=3.0)
    m.initial("strut.elongation", 0.2)
    return m


OBJECTS: dict[str, Callable[[], Any]] = {
    "variants": pushed_many,
    "points of a sweep": lambda: fx.grid({"speed": [1.0, 2.0]}),
    "model": lambda: rssr(universal=False),
    "model with functions": pushed,
    "model with tables": tabulated,
    "model of a bicycle": lambda: fx.read_spacar(DATA / "bicycle_benchmark.dat").model,
    "model and its rope": roped,
    "rope": lambda: roped()[1],
    "SPACAR file": lambda: fx.read_spacar(DATA / "slider_crank.dat"),
    "records of SPACAR": lambda: fx.load(DATA / "two_leaf_pivot.sbm"),
    "stepper": lambda: pushed().build().stepper(0.01, inputs=["P.x"]),
    "summary": lambda: motion().system.summary(),
    "system": lambda: motion().system,
    "system with functions": lambda: pushed().build(),
    "system with a compiled law": lambda: own_law().build(),
    "system of a vehicle": lambda: vehicle(20.0, rack=rounded_ramp()),
    "page of an element": lambda: fx.page("planar_truss"),
    "page of a compiled element": lambda: fx.page(TETHER),
    "values of an element": lambda: fx.page("planar_truss").evaluate([0, 0, 3, 4], {"l0": 4.5, "rhoA": 1}),
    "state": lambda: motion()[3],
    "states": lambda: motion()[2:5],
    "motion": motion,
    "motion by an implicit method": hung,
    "linearization": lambda: motion().system.linearize(motion()[-1]),
    "equations along a motion": lambda: motion().system.along(motion()),
    "small motion": lambda: motion().system.along(motion()).transient(times=[0.0, 0.01]),
    "sampled loop": sampled_loop,
    "modes": lambda: motion().system.linearize().modes(),
    "reduced equations": lambda: motion().system.linearize().reduced(motion().system.dynamic),
    "periodic solution": periodic,
    "periodic branch": branch,
    "buckling": lambda: leaf().buckling(increment={"A.x": -1.0}),
    "vibrations": lambda: leaf().vibrations(count=3),
    "compliance": lambda: leaf().compliance("A", "tip"),
    "static path": lambda: leaf().static_path(t_end=1.0),
    "stress": lambda: leaf().equilibrium().largest_stress(),
    "section forces": lambda: leaf().equilibrium().section_forces("leaf"),
    "constraints": lambda: rssr(universal=True).constraint_report(),
    "check": lambda: rssr(universal=True).check(),
    "stress point": lambda: fx.StressPoint("corner", 1e6, 2e5),
    "plates": lambda: [
        fx.Rectangle(1e-3, 1e-2),
        fx.IBeam(0.1, 0.05, 0.005, 0.004),
        fx.LBeam(0.1, 0.05, 0.01),
        fx.UBeam(0.1, 0.05, 0.005, 0.004),
        fx.ClosedProfile([(0, 0), (1, 0), (1, 1), (0, 1)], 0.1),
    ],
    "rods": lambda: [fx.Circle(0.01), fx.Tube(0.02, 0.016)],
    "parts of ropes": lambda: [
        fx.WireRope(0.02),
        fx.Contact(1e8),
        fx.RoundGroove(0.01),
        fx.HelicalGroove(0.01, lead=0.02),
        fx.VGroove(0.6),
    ],
    "material": lambda: fx.Material(E=200e9, nu=0.3, rho=7800.0),
    "curve": lambda: fx.Curve([[0, 3e4], [-700.0, 4e4]], breaks=[0.07]),
    "waves": lambda: fx.Waves(0.01, 1.0),
    "view": lambda: fx.View(azimuth=10.0, trails=("A",)),
    "solids": lambda: [
        fx.Sketch("A", "R", [(0, 0, 0), (1, 0, 0)]),
        fx.Box("A", "R", (0, 0, 0), (1, 2, 3)),
        fx.Cylinder("A", None, (0, 0, 0), (0, 0, 1), 0.1),
        fx.Mesh("A", "R", DATA / "tetrahedron.obj"),
    ],
    "flexure": lambda: fx.flexure(**tables()),
    "step of a flexure": lambda: (
        (step := fx.flexure(**tables()).steps[0]) and [step, step.node(2), step.element(1)]
    ),
    "tables of a flexure": lambda: [
        fx.NodeProperties(fixed=True),
        fx.ElementProperties(elements=[1], section="rod", dimensions=0.001, material="steel"),
        fx.FlexureOptions(steps=1),
    ],
    "body": lambda: fx.Model().rigid_body("B", (0, 0, 0), mass=1.0, inertia=(1, 1, 1)),
    "event": lambda: fx.Event("steered", steered, terminal=True),
    "compiled law": lambda: fx.compile_law(HARDENING),
    "error": failed,
}


def content(value: Any, seen: dict[int, object] | None = None) -> Any:
    """All that a pickle of an object says, digits exact, without how its parts are shared."""
    seen = {} if seen is None else seen
    if isinstance(value, np.ndarray) and value.dtype != object:
        return value.dtype.str, value.shape, value.tobytes()
    if issparse(value):
        return content(value.toarray(), seen)
    if isinstance(value, (Mapping, list, tuple)):
        items = value.items() if isinstance(value, Mapping) else value
        return [content(item, seen) for item in items]
    if value is None or isinstance(value, (bool, int, float, complex, str, bytes)):
        return value
    if isinstance(value, (type, FunctionType, np.ufunc, np.dtype)):
        return str(getattr(value, "__qualname__", value))
    if id(value) in seen:
        return "again"
    seen[id(value)] = value
    made, given, *state = value.__reduce_ex__(2)
    return [made.__qualname__, content(given, seen), content(state[0] if state else None, seen)]


def fingerprint(value: Any) -> str:
    """A digest of the content, for comparison with another process."""
    return hashlib.sha256(repr(content(value)).encode()).hexdigest()


def eigenvalues(lin: fx.Linearization) -> str:
    """All digits of the eigenvalues."""
    return np.linalg.eigvals(lin.state_matrix).tobytes().hex()


def figures(system: fx.System) -> str:
    """All digits of a right-hand side, of a linearization and of a short motion, from a fresh start."""
    start = system.initial
    system.warm(start)
    rates = system.rhs(start.t, np.concatenate([start.q, start.qd, start.z]))
    last = system.simulate(0.1, samples=2)[-1]
    return rates.tobytes().hex() + eigenvalues(system.linearize()) + last.values.tobytes().hex()


def run(system: fx.System) -> fx.Motion:
    """A member of an ensemble."""
    return system.simulate(0.5, samples=5)
