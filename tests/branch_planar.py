"""Planar families of the campaign "no step onto another branch": chains, four-bars and slider-cranks of rods."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from branch_case import Case
from references import Rods, follow

import flexel as fx
from flexel.base.arrays import Array

Rng = np.random.Generator
SYMPTOM = Rods(np.array([(0.46, -0.19), (-0.04, -0.22)]), np.array([7.0, 3.0]))


def model(rods: Rods) -> fx.Model:
    """The rods as a model: points O, P0, P1, …, angles R0, R1, …, with the start's rates."""
    m = fx.Model(gravity=(0, -rods.gravity))
    last, n = m.point("O", (0, 0), fixed=True), len(rods.points)
    for i, place in enumerate(rods.points):
        end = m.point(f"P{i}", place, fixed=i == n - 1 and len(rods.held) == 2)
        m.beam(f"b{i}", last, m.angle(f"R{i}"), end, mass_per_length=1.0)
        last = end
        m.initial(f"R{i}.angle", rate=rods.speeds[i])
    if rods.held == [1]:
        m.fix(f"P{n - 1}.y")
    if rods.wheel:
        m.rotary_inertia("wheel", "R0", rods.wheel)
    if rods.load:
        m.point_mass("slider", last, rods.load)
    return m


def case(name: str, rods: Rods, good: tuple[str, ...], size: float = 0.0) -> Case:
    """A motion of rods; any coordinates but the good ones are bad."""
    m = model(rods)
    free = [i for i in range(len(rods.points)) if not np.all(m.nodes[f"P{i}"].fixed)]
    names = tuple(
        coordinate for coordinate in rods.names if coordinate[0] == "R" or int(coordinate[1]) in free
    )

    def exact() -> Callable[[Array], Array]:
        y = rods.follow(1.0)
        rows = [rods.names.index(coordinate) for coordinate in names]
        return lambda t: rods.values(y(t))[rows]

    held = {f"P{len(rods.points) - 1}.y"} if rods.held == [1] else set()
    candidates = tuple(coordinate for coordinate in names if coordinate not in held.union(good))
    return Case(name, lambda: model(rods), good, candidates, names, exact, float(np.max(rods.lengths)))


def chain(name: str, rng: Rng, links: int) -> Case:
    """A pendulum of some random links; the bad coordinates are those of points."""
    points = np.cumsum(rng.uniform(-0.5, 0.5, (links, 2)), axis=0)
    rods = Rods(points, rng.uniform(-8, 8, links))
    return case(name, rods, tuple(f"R{i}.angle" for i in range(links)))


def double(name: str, rng: Rng) -> Case:
    """A double pendulum; number 0 is the one that jumped to its mirrored configuration."""
    if name.endswith(" 0"):
        return replace(case(name, SYMPTOM, ("R0.angle", "R1.angle")), given=("P0.y", "P1.x"))
    return chain(name, rng, 2)


def triple(name: str, rng: Rng) -> Case:
    """A triple pendulum."""
    return chain(name, rng, 3)


def four_bar(name: str, rng: Rng) -> Case:
    """A crank that turns fully before a coupler and a rocker."""
    a, b, c = rng.uniform(0.2, 0.35), rng.uniform(0.8, 1.1), rng.uniform(0.6, 0.9)
    d = rng.uniform(abs(b - c) + a + 0.1, b + c - a - 0.1)
    turn, side = rng.uniform(-np.pi, np.pi), rng.choice([-1.0, 1.0])
    crank, ground = a * np.array([np.cos(turn), np.sin(turn)]), np.array([d, 0.0])
    points = np.array([crank, crank + _side(ground - crank, b, c, side), ground])
    rods = Rods(points, _rolling(points, rng.choice([-1, 1]) * rng.uniform(4, 12)), held=(0, 1))
    return case(name, rods, ("R0.angle",))


def _side(line: Array, b: float, c: float, side: float) -> Array:
    """First side b of the triangle over a line, whose other side is c."""
    l = np.hypot(*line)
    along = (l**2 + b**2 - c**2) / (2 * l)
    across = side * np.sqrt(b**2 - along**2)
    return np.asarray((along * line + across * np.array([-line[1], line[0]])) / l)


def _rolling(points: Array, rate: float) -> Array:
    """Angular velocities of a closed chain of three rods, for that of the first."""
    d = np.diff(points, axis=0, prepend=np.zeros((1, 2)))
    C = np.array([-d[:, 1], d[:, 0]])
    return np.append(rate, np.linalg.solve(C[:, 1:], -C[:, 0] * rate))


def change_point(name: str, rng: Rng) -> Case:
    """A four-bar 1, 2, 1 in a frame of 2 + gap, which passes close to its change point; nothing is regular there."""
    gap = 10.0 ** -rng.integers(1, 7)
    rate = -rng.choice([6.0, 15.0, 30.0])
    points = np.array([(0.0, 1.0), (2.0, 1.0), (2 + gap, 0.0)])
    points[1] = points[0] + _side(points[2] - points[0], 2.0, 1.0, 1.0)
    rods = Rods(points, _rolling(points, rate), gravity=0.0, held=(0, 1))
    found = case(name, rods, ("R0.angle",))
    return replace(found, worst=1.0, duration=min(1.0, 8 / abs(rate)))


def parallelogram(name: str, rng: Rng) -> Case:
    """A parallelogram that swings through its flat positions, where another branch meets its own."""
    l, d = rng.uniform(0.3, 1.0), rng.uniform(0.3, 1.0)
    turn, rate, g = rng.uniform(0.3, 2.8), rng.choice([-1, 1]) * rng.uniform(1, 6), 9.81
    arm = l * np.array([np.cos(turn), np.sin(turn)])
    rods = Rods(np.array([arm, arm + (d, 0), (d, 0)]), np.array([rate, 0.0, rate]), held=(0, 1))

    def exact() -> Callable[[Array], Array]:
        pull = -g * (l**2 + d * l) / (2 * l**3 / 3 + d * l**2)  # a single swinging angle
        angle = follow(
            lambda t, y: np.array([y[1], pull * np.cos(y[0])]), lambda y: y, np.array([turn, rate]), 1.0
        )
        return lambda t: np.array(
            [l * np.cos(angle(t)[0]), l * np.sin(angle(t)[0]), angle(t)[0] - turn, 0 * t, angle(t)[0] - turn]
        )

    names = ("P0.x", "P0.y", "R0.angle", "R1.angle", "R2.angle")
    found = case(name, rods, ("R0.angle",))
    return replace(found, names=names, exact=exact, worst=LARGE, singular=True)


LARGE = 0.1  # error of a parallelogram that left its branch; its own coordinates are exact on it


def slider_crank(name: str, rng: Rng) -> Case:
    """A crank with a flywheel, a rod and a slider, which may run beside the crank's axis."""
    a, b, turn = rng.uniform(0.2, 0.35), rng.uniform(0.5, 1.0), rng.uniform(-np.pi, np.pi)
    crank, height = a * np.array([np.cos(turn), np.sin(turn)]), rng.uniform(-0.1, 0.1)
    drop = height - crank[1]
    points = np.array([crank, crank + (np.sqrt(b**2 - drop**2), drop)])
    rate = rng.choice([-1, 1]) * rng.uniform(5, 40)
    speeds = np.array([rate, -rate * a * np.cos(turn) / (points[1, 0] - points[0, 0])])
    rods = Rods(points, speeds, wheel=rng.choice([0.0, 0.1, 10.0]), load=rng.uniform(0.1, 2.0), held=(1,))
    return case(name, rods, ("R0.angle",))


PLANAR: dict[str, Callable[[str, Rng], Case]] = {
    "double": double,
    "triple": triple,
    "four-bar": four_bar,
    "change-point": change_point,
    "parallelogram": parallelogram,
    "slider-crank": slider_crank,
}
