"""The bicycle once more, element by element from SPACAR's own input file: the same linearized equations.

`tests/data/bicycle_benchmark.dat` has the elements, roles and numbers of the input file in the electronic supplement
of Meijaard, Papadopoulos, Ruina and Schwab (2007), Proc. R. Soc. A 463:1955.  It was made independently of the model
in `flexel.examples`: body points instead of rigid beams, masses and weights on nodes, a rear wheel whose spin is
prescribed, another choice of kinematic coordinates.
"""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm

from flexel.base.arrays import Array
from flexel.examples.published import published as table
from flexel.parts.model import Model
from flexel.results.linearization import Linearization
from flexel.results.system_facade import System

DATA = Path(__file__).parent.parent / "data"
RADIUS = 0.3  # rear wheel; the file's spin rate, -3.333333333 rad/s for 1 m/s, has ten digits only
LEAN, STEER, SPIN = "hinge2.angle", "hinge8.angle", "hinge4.angle"
SLIPS = {4: "longitudinal", 5: "lateral"}  # modes of SPACAR's wheel
PINBODY = {1: "along", 2: "across1", 3: "across2"}


def lines(keyword: str) -> list[list[float]]:
    """The numbers of all lines of the file that begin with a keyword."""
    text = (DATA / "bicycle_benchmark.dat").read_text().splitlines()
    words = [line.partition("%")[0].split() for line in text]
    return [[float(word) for word in w[1:]] for w in words if w and w[0] == keyword]


def p(number: float) -> str:
    """Name of a position node."""
    return f"p{number:.0f}"


def o(number: float) -> str:
    """Name of an orientation node."""
    return f"o{number:.0f}"


def quantity(element: float, mode: float) -> str:
    """Our name of a deformation of a hinge or body point of the file."""
    hinges = {row[0] for row in lines("hinge")}
    if element in hinges:
        return f"hinge{element:.0f}.{('angle', 'bend1', 'bend2')[int(mode) - 1]}"
    return f"pinbody{element:.0f}.{PINBODY[int(mode)]}"


def bicycle(speed: float) -> System:
    """The model of the file; z points down, weights are forces."""
    m = Model()
    held = {row[0] for row in lines("fix")}
    for row in lines("x"):
        m.point(p(row[0]), row[1:], fixed=row[0] in held)
    for number in sorted({row[k] for row in lines("hinge") for k in (1, 2)}):
        m.frame(o(number), fixed=number in held)
    for row in lines("hinge"):
        m.hinge(f"hinge{row[0]:.0f}", o(row[1]), o(row[2]), axis=row[3:])
    for row in lines("pinbody"):
        m.body_point(f"pinbody{row[0]:.0f}", p(row[1]), o(row[2]), p(row[3]))
    for row in lines("wheel"):
        radius = -lines("x")[int(row[1]) - 1][3]
        m.wheel(
            f"wheel{row[0]:.0f}",
            p(row[1]),
            o(row[2]),
            p(row[3]),
            radius=radius,
            axle=row[4:],
            normal=(0, 0, -1),
        )
    mass = {row[0]: row[1:] for row in lines("mass")}
    for point, frame in ((3, 12), (4, 13), (6, 14), (7, 15)):
        xx, xy, xz, yy, yz, zz = mass[frame]
        m.body(f"body{frame}", p(point), o(frame), mass=mass[point][0], inertia=(xx, yy, zz, xy, xz, yz))
    for row in lines("force"):
        m.load(p(row[0]), row[1:])
    for row in lines("rlse"):
        for mode in row[1:]:
            m.release(quantity(row[0], mode))
    (spin,) = lines("inpute")
    m.prescribe(quantity(*spin), lambda t: -speed / RADIUS * t)
    m.independent(*(quantity(*row) for row in lines("line")))
    for row in lines("enhc"):
        m.kinematic(quantity(row[2], row[3]))
    return m.build()


@pytest.fixture(scope="module")
def linearized() -> dict[float, Linearization]:
    return {speed: bicycle(speed).linearize() for speed in (1.0, 2.0)}


@pytest.fixture(scope="module")
def published() -> dict[str, Array]:
    data: dict[str, Any] = table("bicycle_whipple")
    return {key: np.array(value, dtype=float) for key, value in data["computed_matrices"].items()}


def test_counts_and_roles_are_those_of_the_file() -> None:
    s = bicycle(1.0)
    assert s.dynamic == (LEAN, STEER)
    assert s.kinematic == ("pinbody13.along", "pinbody13.across1", "hinge1.angle", "hinge11.angle")
    rolling = [f"wheel{row[0]:.0f}.{SLIPS[int(row[1])]}" for row in lines("enhc")]
    assert [s.structure.names[i] for i in s.roles.zero] == rolling
    assert lines("ed") == [[4, 1, -3.333333333]]
    assert abs(s.initial.rate(SPIN) - lines("ed")[0][2]) < 1e-9


def test_linearized_equations_are_the_published_ones(
    linearized: dict[float, Linearization], published: dict[str, Array]
) -> None:
    one, two = (linearized[v].reduced([LEAN, STEER]) for v in (1.0, 2.0))
    K2 = (two.K - one.K) / 3
    computed = {"M": one.M, "C1": one.C, "K0": (one.K - K2) / 9.81, "K2": K2}
    for key, value in computed.items():
        assert np.max(np.abs(value - published[key])) < 1e-11 * np.max(np.abs(published[key])), key
    assert np.max(np.abs(two.C - 2 * one.C)) < 1e-12 * np.max(np.abs(one.C))


def test_kinematic_coordinates_follow_the_rolling_wheels(linearized: dict[float, Linearization]) -> None:
    lin = linearized[2.0]
    names = list(lin.kinematic)
    yaw, across = names.index("hinge1.angle"), names.index("pinbody13.across1")
    # the contact point moves where the rear wheel points: dy/dt = v psi; the yaw rate follows the steer angle,
    # d(psi)/dt = (v delta + c d(delta)/dt) cos(lambda) / w
    w, c, cos = 1.02, 0.08, np.cos(np.pi / 10)
    free = list(lin.dofs)
    assert abs(lin.B_k[across, free.index("hinge1.angle")] - 2.0) < 1e-12
    assert abs(lin.B_k[yaw, free.index(STEER)] - 2.0 * cos / w) < 1e-12
    assert abs(lin.A_k[yaw, lin.dynamic.index(STEER)] - c * cos / w) < 1e-12
    assert np.max(np.abs(lin.A_k[:, lin.dynamic.index(LEAN)])) < 1e-12


def test_driving_the_rear_wheel_at_constant_speed_takes_no_torque(
    linearized: dict[float, Linearization],
) -> None:
    state = linearized[2.0].state
    assert abs(state.force(SPIN)) < 1e-10
    assert abs(state.force("wheel5.surface") + state.force("wheel12.surface")) > 900.0  # the weight, 922.14 N


@pytest.mark.parametrize("kick", [1e-2, 1e-3])
def test_small_motion_follows_the_linearized_equations(kick: float) -> None:
    s = bicycle(4.6)
    lin = s.linearize()
    start = s.state_at(rates={LEAN: kick, STEER: 0.0})
    motion = s.simulate(1.0, start=start, samples=11, rtol=1e-11, atol=1e-14)
    begin = np.zeros(len(lin.states))
    begin[lin.states.index(f"{LEAN}'")] = kick
    end = expm(lin.state_matrix * 1.0) @ begin
    for name in (LEAN, STEER, "hinge1.angle", "pinbody13.across1"):
        # mirror symmetry: the first neglected terms are cubic
        assert abs(motion[-1][name] - end[lin.states.index(name)]) < 10 * kick**3, name
    assert np.max(np.abs(motion.rate(SPIN) + 4.6 / RADIUS)) < 1e-11
    assert np.max(motion.drift) < 1e-12
