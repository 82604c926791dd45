"""Valid calls of the methods of results."""

import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import travellers
from mistakes import pendulum
from spacar_binary import ltv
from valid_call import Valid, calling
from valid_systems import driven, leaf, rod

import flexel as fx

DATA = Path(__file__).parent / "data"


@cache
def swing() -> fx.Motion:
    """A short motion of the rod."""
    return rod().simulate(0.1, samples=4, method="DOP853")


@cache
def turned() -> fx.Motion:
    """A short motion of the rod, which a motor turns."""
    m = pendulum()
    m.prescribe("pivot.angle", fx.Polynomial([0.0, 1.0]))
    return m.build().simulate(0.1, samples=3)


@cache
def forced() -> fx.Linearization:
    """The pushed mass, linearized."""
    return driven().linearize(driven().equilibrium())


@cache
def along() -> fx.TimeVarying:
    """The linearized equations along the motion, taken for a period of it."""
    return rod().along(swing(), period=0.1)


@cache
def small() -> fx.SmallMotion:
    """A small motion about it."""
    return along().transient({"pivot.angle": 0.01})


@cache
def vibration() -> fx.PeriodicSolution:
    """Its forced vibration."""
    return travellers.periodic()


@cache
def branch() -> fx.PeriodicBranch:
    """The same over the speed."""
    return travellers.branch()


@cache
def many() -> tuple[fx.Ensemble, fx.Linearizations, fx.RootLoci]:
    """Variants."""
    return travellers.pushed_many()


@cache
def rope() -> tuple[fx.Rope, fx.State]:
    """A rope on a sheave and its state."""
    m, rope = travellers.roped()
    return rope, m.build().initial


@cache
def spacar() -> fx.Spacar:
    """A cantilever from a file."""
    return fx.read_spacar(DATA / "spacar_cantilever.dat")


@cache
def records() -> fx.SpacarRecords:
    """State-space models in a file of SPACAR."""
    found = fx.load(ltv(Path(tempfile.mkdtemp()) / "records.ltv"))
    assert isinstance(found, fx.SpacarRecords)
    return found


def of_rope(method: str) -> Callable[[], Valid]:
    """A result of a rope."""
    return lambda: calling(getattr(rope()[0], method), states=rope()[1])


def on_sheave(method: str) -> Callable[[], Valid]:
    """A result of a rope on a sheave."""
    return lambda: calling(getattr(rope()[0], method), states=rope()[1], surface="S")


def of_motion(method: str, value: str, parameter: str = "name") -> Callable[[], Valid]:
    """A result of a motion, by name."""
    return lambda: Valid(getattr(swing(), method), {parameter: value})


RESULTS: dict[str, Callable[[], Valid]] = {
    "Compliance.stiffness": lambda: calling(leaf().compliance("A", "tip").stiffness, body_axes=True),
    "Compliance.stiffness_matrix": lambda: calling(leaf().compliance("A", "tip").stiffness_matrix, body_axes=True),
    "Ensemble.motion": lambda: calling(many()[0].motion, i=0),
    "Linearization.bode": lambda: calling(
        forced().bode, inputs="P.x", outputs="P.x", frequencies=[1.0, 2.0], path=Path("bode.png")
    ),
    "Linearization.frequency_response": lambda: calling(
        forced().frequency_response, inputs="P.x", outputs="P.x", frequencies=[1.0, 2.0]
    ),
    "Linearization.input_matrix": lambda: calling(forced().input_matrix, names=["P.x"]),
    "Linearization.mode": lambda: calling(forced().mode, number=0),
    "Linearization.mode_shape": lambda: calling(forced().mode_shape, number=0),
    "Linearization.plot": lambda: calling(forced().plot, path=Path("modes.png")),
    "Linearization.plot_mode": lambda: calling(forced().plot_mode, number=0, path=Path("mode.png")),
    "Linearization.reduced": lambda: calling(forced().reduced, names=["spring.elongation"]),
    "Linearization.save": lambda: calling(forced().save, path=Path("lin.npz")),
    "Linearization.save_state_space": lambda: calling(
        forced().save_state_space, path=Path("space.mat"), inputs=["P.x"], outputs=["P.x"]
    ),
    "Linearization.state_space": lambda: calling(forced().state_space, inputs=["P.x"], outputs=["P.x"]),
    "Linearization.to_control": lambda: calling(forced().to_control, inputs=["P.x"], outputs=["P.x"]),
    "Linearization.to_scipy": lambda: calling(forced().to_scipy, inputs=["P.x"], outputs=["P.x"]),
    "Linearization.view": lambda: calling(forced().view, path=Path("modes.html")),
    "Linearizations.linearization": lambda: calling(many()[1].linearization, variant=0),
    "Linearizations.reduced": lambda: calling(many()[1].reduced, names=["A.displacement.along"]),
    "Motion.acceleration": of_motion("acceleration", "A.x"),
    "Motion.animate": lambda: calling(swing().animate, path=Path("swing.html")),
    "Motion.page": lambda: calling(swing().page),
    "Motion.at": lambda: calling(swing().at, t=0.05),
    "Motion.force": of_motion("force", "pivot.angle"),
    "Motion.drive": lambda: calling(turned().drive, name="pivot.angle"),
    "Motion.nearest": lambda: calling(swing().nearest, t=0.05),
    "Motion.plot": lambda: calling(swing().plot, names=("A.x",), path=Path("plot.png")),
    "Motion.plot_phase": lambda: calling(swing().plot_phase, x="A.x", y="A.z", path=Path("phase.png")),
    "Motion.plot_shapes": lambda: calling(swing().plot_shapes, times=(0.0, 0.1), path=Path("shapes.png")),
    "Motion.spectrum": of_motion("spectrum", "A.x"),
    "Motion.spectrum_plot": lambda: calling(swing().spectrum_plot, names=("A.x",), path=Path("spectrum.png")),
    "Motion.position": of_motion("position", "A", "node"),
    "Motion.rate": of_motion("rate", "A.x"),
    "Motion.save": lambda: calling(swing().save, path=Path("motion.npz")),
    "Motion.series": of_motion("series", "A.x"),
    "Motion.to_pandas": lambda: calling(swing().to_pandas, names=("A.x",)),
    "Motion.to_xarray": lambda: calling(swing().to_xarray, names=("A.x",)),
    "Motion.unit": of_motion("unit", "A.x"),
    "Motion.velocity": of_motion("velocity", "A", "node"),
    "Motion.view": lambda: calling(swing().view, path=Path("swing.html")),
    "PeriodicBranch.harmonics": lambda: calling(branch().harmonics, name="spring.elongation"),
    "PeriodicBranch.largest": lambda: calling(branch().largest, name="P.x"),
    "PeriodicBranch.plot": lambda: calling(branch().plot, names=("P.x",), path=Path("branch.png")),
    "PeriodicBranch.to_pandas": lambda: calling(branch().to_pandas, names=("P.x",)),
    "PeriodicSolution.harmonics": lambda: calling(vibration().harmonics, name="spring.elongation"),
    "PeriodicSolution.plot": lambda: calling(vibration().plot, names=("P.x",), path=Path("periodic.png")),
    "PeriodicSolution.plot_phase": lambda: calling(vibration().plot_phase, x="P.x", path=Path("phase.png")),
    "PeriodicSolution.plot_shapes": lambda: calling(vibration().plot_shapes, times=(0.0,), path=Path("shapes.png")),
    "PeriodicSolution.spectrum_plot": lambda: calling(vibration().spectrum_plot, path=Path("spectrum.png")),
    "PeriodicSolution.save": lambda: calling(vibration().save, path=Path("periodic.npz")),
    "PeriodicSolution.to_pandas": lambda: calling(vibration().to_pandas, names=("P.x",)),
    "PeriodicSolution.unit": lambda: calling(vibration().unit, name="P.x"),
    "PeriodicSolution.view": lambda: calling(vibration().view, path=Path("periodic.html")),
    "RootLoci.branches": lambda: calling(many()[2].branches, variant=0),
    "RootLoci.plot": lambda: calling(many()[2].plot, path=Path("loci.png")),
    "Rope.contact_force": on_sheave("contact_force"),
    "Rope.curvature": of_rope("curvature"),
    "Rope.resultant": on_sheave("resultant"),
    "Rope.slip": on_sheave("slip"),
    "Rope.strain": of_rope("strain"),
    "Rope.tension": of_rope("tension"),
    "Rope.wrap_angle": on_sheave("wrap_angle"),
    "Spacar.buckling": lambda: calling(spacar().buckling, count=2),
    "Spacar.deformation": lambda: calling(spacar().deformation, state=spacar().system.initial, element=1, i=1),
    "Spacar.factor": lambda: calling(spacar().factor, name="n2.y"),
    "Spacar.frequencies": lambda: calling(spacar().frequencies, state=spacar().system.initial, count=2),
    "Spacar.matrices": lambda: calling(spacar().matrices, state=spacar().system.initial),
    "Spacar.state_space": lambda: calling(spacar().state_space, state=spacar().system.initial),
    "Spacar.stress": lambda: calling(spacar().stress, state=spacar().system.initial, element=1, i=1),
    "SpacarRecords.state_space": lambda: calling(records().state_space, record=0),
    "SpacarRecords.to_control": lambda: calling(records().to_control, record=0),
    "Spacar.variant": lambda: calling(spacar().variant, loads=False),
    "SmallMotion.total": lambda: calling(small().total, name="A.x"),
    "TimeVarying.at": lambda: calling(along().at, t=0.05),
    "TimeVarying.coefficients": lambda: calling(along().coefficients, samples=8),
    "TimeVarying.harmonic_balance": lambda: calling(
        along().harmonic_balance, harmonics=2, inputs={"pivot.angle": np.cos}
    ),
    "TimeVarying.multipliers": lambda: calling(along().multipliers),
    "TimeVarying.state_space": lambda: calling(
        along().state_space, inputs=["pivot.angle"], outputs=["A.x"], times=[0.0, 0.05]
    ),
    "TimeVarying.transient": lambda: calling(
        along().transient, initial={"pivot.angle": 0.01}, inputs={"pivot.angle": 0.1}, times=[0.0, 0.05]
    ),
}  # fmt: skip
