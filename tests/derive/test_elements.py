"""Elements: statements of physics about their definitions, before anything is differentiated."""

import decimal
import random
from collections.abc import Callable, Sequence
from decimal import Decimal
from typing import Any

import mpmath
import pytest
import sympy as sp
from mpmath import cos, mpf, sin

from flexel.derive.declare import (
    Deformation,
    Element,
    Frame,
    Law,
    Parameter,
    PlanarAngle,
    PlanarPoint,
    Point,
    Slip,
    symbol,
)
from flexel.derive.declare.shape import rotary_gram
from flexel.derive.elements import ELEMENTS
from flexel.derive.laws import LAWS
from flexel.derive.laws.linear import LINEAR
from flexel.derive.verify.definition import Definition

mpmath.mp.dps = 50
decimal.getcontext().prec = 50
TINY = mpf(10) ** -35

Vector = list[Any]
BY_NAME = {element.name: element for element in ELEMENTS}
with_deformations = pytest.mark.parametrize(
    "element", [e for e in ELEMENTS if e.deformations], ids=lambda e: e.name
)
with_slips = pytest.mark.parametrize("element", [e for e in ELEMENTS if e.slips], ids=lambda e: e.name)
with_mass = pytest.mark.parametrize(
    "element", [e for e in ELEMENTS if e.kinetic_energy != 0], ids=lambda e: e.name
)
beams = pytest.mark.parametrize("name", ["beam", "beam_first_order"])
planar_beams = pytest.mark.parametrize("name", ["planar_beam", "planar_beam_first_order"])


@pytest.fixture
def rng(request: pytest.FixtureRequest) -> random.Random:
    return random.Random(request.node.name)


# --- numbers: columns, quaternions -------------------------------------------------------------------------


def column(rng: random.Random, size: int) -> Vector:
    return [mpf(rng.uniform(-1, 1)) for _ in range(size)]


def unit(values: Vector) -> Vector:
    length = mpmath.sqrt(sum(v * v for v in values))
    return [v / length for v in values]


def dot(a: Vector, b: Vector) -> Any:
    return mpmath.fdot(a, b)


def cross(a: Vector, b: Vector) -> Vector:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plus(a: Vector, b: Vector, factor: Any = 1) -> Vector:
    return [i + factor * j for i, j in zip(a, b, strict=True)]


def product(a: Vector, b: Vector) -> Vector:
    vector = plus(plus(cross(a[1:], b[1:]), b[1:], a[0]), a[1:], b[0])
    return [a[0] * b[0] - dot(a[1:], b[1:]), *vector]


def conjugate(a: Vector) -> Vector:
    return [a[0], -a[1], -a[2], -a[3]]


def rotated(q: Vector, a: Vector) -> Vector:
    return product(product(q, [0, *a]), conjugate(q))[1:]


def rotation(axis: Vector, angle: Any) -> Vector:
    return [cos(angle / 2), *(sin(angle / 2) * a for a in axis)]


X, Y, Z = [1, 0, 0], [0, 1, 0], [0, 0, 1]


# --- an element with numbers -------------------------------------------------------------------------------


class Numbers(Definition):
    """The functions of an element, of numbers of mpmath."""

    def D(self, x: Vector) -> Vector:
        return many(super().D(decimals(x)))

    def s(self, x: Vector, v: Vector) -> Vector:
        return many(super().s(decimals(x), decimals(v)))

    def T(self, x: Vector, v: Vector) -> Any:
        return many([super().T(decimals(x), decimals(v))])[0]

    def U(self, x: Vector) -> Any:
        return many([super().U(decimals(x))])[0]


def decimals(values: Vector) -> list[Decimal]:
    return [Decimal(str(value)) for value in values]


def many(values: list[Decimal]) -> Vector:
    return [mpf(str(value)) for value in values]


def numbers(element: Element, **values: Any) -> Definition:
    """Return the element's functions with parameters: those named, and zero for the others."""
    definition = Numbers(element)
    p: Vector = []
    for parameter in element.parameters:
        value = values.get(parameter.name, [0] * parameter.size)
        p += [mpf(v) for v in (value if isinstance(value, Sequence) else [value])]
    assert len(p) == len(element.parameter_symbols)
    definition.p = decimals(p)
    return definition


def random_parameters(element: Element, rng: random.Random) -> dict[str, Any]:
    values: dict[str, Any] = {}
    for parameter in element.parameters:
        if parameter.name in (
            "radius_p",
            "radius_q",
        ):  # pulleys and gears that are smaller than their distance
            values[parameter.name] = mpf(rng.uniform(0.01, 0.05))
        elif parameter.size == 1:
            values[parameter.name] = mpf(rng.uniform(0.5, 1.5))
        elif parameter.unit == "1":
            values[parameter.name] = unit(column(rng, parameter.size))
        else:
            values[parameter.name] = column(rng, parameter.size)
    if element.name == "surface":  # of revolution about z
        a, b, c = column(rng, 3)
        values |= {"quadratic": [a, a, b, 0, 0, 0], "linear": [0, 0, c]}
    return values


def random_coordinates(element: Element, rng: random.Random) -> Vector:
    x: Vector = []
    for node in element.nodes:
        values = column(rng, node.size)
        x += unit(values) if node.kind == "frame" else values
    return x


class Motion:
    """A rigid motion: rotation about an axis through the origin, then translation; constant velocities.

    In the plane the axis is z. It maps coordinates to coordinates, and gives the rates of nodes at rest in
    it.
    """

    def __init__(self, axis: Vector, angle: Any, shift: Vector, omega: Vector, velocity: Vector) -> None:
        self.q, self.angle, self.shift = rotation(axis, angle), angle, shift
        self.omega, self.velocity = omega, velocity

    def _nodes(self, element: Element, x: Vector) -> list[tuple[str, Vector]]:
        parts, start = [], 0
        for node in element.nodes:
            parts.append((node.kind, x[start : start + node.size]))
            start += node.size
        return parts

    def moved(self, element: Element, x: Vector, rates: bool = False) -> Vector:
        """Coordinates (or rates) after the motion."""
        result: Vector = []
        for kind, value in self._nodes(element, x):
            if kind == "frame":
                result += product(self.q, value)
            elif kind == "planar_angle":
                result += value if rates else [value[0] + self.angle]
            else:
                turned = rotated(self.q, [*value, 0][:3])
                free = rates or kind.endswith("slope")
                result += (turned if free else plus(turned, self.shift))[: len(value)]
        return result

    def rigid_rates(self, element: Element, x: Vector) -> Vector:
        """Rates of nodes that take part in the motion with angular velocity omega and velocity at the origin."""
        result: Vector = []
        for kind, value in self._nodes(element, x):
            if kind == "frame":
                result += [c / 2 for c in product([0, *self.omega], value)]
            elif kind == "planar_angle":
                result.append(self.omega[2])
            else:
                turning = cross(self.omega, [*value, 0][:3])
                result += (turning if kind.endswith("slope") else plus(self.velocity, turning))[: len(value)]
        return result


def is_planar(element: Element) -> bool:
    return all(node.kind.startswith("planar") for node in element.nodes)


def symmetry(element: Element, values: dict[str, Any], rng: random.Random) -> Motion:
    """Return a rigid motion that the element cannot notice: any, or for a wheel one that keeps the road."""
    if "heading" in values:  # waves: only along their crests
        across = [-values["heading"][1], values["heading"][0], 0]
        shift, velocity = ([mpf(rng.uniform(-1, 1)) * z for z in across] for _ in range(2))
        return Motion(Z, mpf(0), shift, [0, 0, 0], velocity)
    axis, omega = unit(column(rng, 3)), column(rng, 3)
    shift, velocity = column(rng, 3), column(rng, 3)
    if element.name == "surface":
        return Motion(Z, mpf(rng.uniform(-3, 3)), [0, 0, 0], [0, 0, omega[2]], [0, 0, 0])
    normal = Z if is_planar(element) else values.get("normal")
    if normal:
        axis, omega = normal, [omega[0] * n for n in normal]
        shift, velocity = (plus(u, normal, -dot(u, normal)) for u in (shift, velocity))
    most = 0.1 if element.name == "planar_belt" else 3  # its line of centres turns by less than half a turn
    return Motion(axis, mpf(rng.uniform(-most, most)), shift, omega, velocity)


def rates_of_deformations(d: Definition, x: Vector, v: Vector) -> Vector:
    h = mpf(10) ** -16
    ahead, behind = d.D(plus(x, v, h)), d.D(plus(x, v, -h))
    return [(a - b) / (2 * h) for a, b in zip(ahead, behind, strict=True)]


def equal(a: Vector, b: Vector, tolerance: Any = TINY) -> bool:
    return len(a) == len(b) and all(abs(i - j) <= tolerance for i, j in zip(a, b, strict=True))


def as_seen(element: Element, e: Vector, turn: Callable[[Vector], Vector]) -> Vector:
    """Deformations after a motion: the three curvature vectors of a spatial cable turn, all others stay."""
    if element.name != "cable":
        return e
    return [*e[:4], *(c for i in (4, 7, 10) for c in turn(e[i : i + 3]))]


# --- every element -----------------------------------------------------------------------------------------


@with_deformations
def test_deformations_do_not_notice_a_superposed_rigid_motion(element: Element, rng: random.Random) -> None:
    values = random_parameters(element, rng)
    d, x = numbers(element, **values), random_coordinates(element, rng)
    motion = symmetry(element, values, rng)
    before = as_seen(element, d.D(x), lambda vector: rotated(motion.q, vector))
    after = d.D(motion.moved(element, x))
    turns = [mpmath.nint((a - b) / (2 * mpmath.pi)) for a, b in zip(after, before, strict=True)]
    assert all(turn == 0 or mode.angle for turn, mode in zip(turns, element.deformations, strict=True))
    assert equal([a - 2 * mpmath.pi * turn for a, turn in zip(after, turns, strict=True)], before)


@with_deformations
def test_rigid_motion_has_no_rates_of_deformation(element: Element, rng: random.Random) -> None:
    values = random_parameters(element, rng)
    d, x = numbers(element, **values), random_coordinates(element, rng)
    motion = symmetry(element, values, rng)
    rates = rates_of_deformations(d, x, motion.rigid_rates(element, x))
    still = [0] * d.m if element.name != "cable" else [0] * 4 + d.D(x)[4:]
    assert equal(rates, as_seen(element, still, lambda vector: cross(motion.omega, vector)), mpf(10) ** -25)


IN_GLOBAL_AXES = {"rotation", "bar_span", "beam_span", "planar_bar_span", "planar_beam_span"}
IN_GLOBAL_AXES |= {"cable_span", "planar_cable_span"}


@with_slips
def test_slips_turn_with_the_body_or_stay(element: Element, rng: random.Random) -> None:
    values = random_parameters(element, rng)
    d, x, v = numbers(element, **values), random_coordinates(element, rng), random_coordinates(element, rng)
    motion = symmetry(element, values, rng)
    after = d.s(motion.moved(element, x), motion.moved(element, v, rates=True))
    before = d.s(x, v)
    arrow = BY_NAME[
        "planar_point_mass" if is_planar(element) else "point_mass"
    ]  # its rates turn as a vector does
    turned = motion.moved(arrow, before, rates=True) if element.name in IN_GLOBAL_AXES else before
    assert equal(after, turned)


@with_mass
def test_kinetic_energy_does_not_depend_on_place_and_direction(element: Element, rng: random.Random) -> None:
    values = random_parameters(element, rng)
    d, x, v = numbers(element, **values), random_coordinates(element, rng), random_coordinates(element, rng)
    motion = symmetry(element, values, rng)
    after = d.T(motion.moved(element, x), motion.moved(element, v, rates=True))
    assert equal([after], [d.T(x, v)])


@with_mass
def test_weight_is_mass_times_gravity(element: Element, rng: random.Random) -> None:
    """The nodal forces -dU/dx are M a for the accelerations a of a uniform translation."""
    values = random_parameters(element, rng)
    d, x, v = numbers(element, **values), random_coordinates(element, rng), random_coordinates(element, rng)
    a: Vector = []
    for node in element.nodes:
        a += values["gravity"] if node.kind in ("point", "planar_point") else [mpf(0)] * node.size
    h = mpf(10) ** -16
    power = (d.U(plus(x, v, h)) - d.U(plus(x, v, -h))) / (2 * h)
    assert equal([-power], [(d.T(x, plus(v, a)) - d.T(x, plus(v, a, -1))) / 2], mpf(10) ** -25)


@with_mass
def test_kinetic_energy_is_quadratic_and_not_negative(element: Element, rng: random.Random) -> None:
    values = random_parameters(element, rng)
    if "J" in values and element.name in ("body", "rotary_inertia"):
        values["J"] = [1, 2, 2.5, 0.1, 0.2, -0.1]
    values = {k: [abs(c) for c in v] if k == "rhoJ" and isinstance(v, list) else v for k, v in values.items()}
    d, x = numbers(element, **values), random_coordinates(element, rng)
    u, v = random_coordinates(element, rng), random_coordinates(element, rng)
    parallelogram = d.T(x, plus(u, v)) + d.T(x, plus(u, v, -1))
    assert equal([parallelogram], [2 * d.T(x, u) + 2 * d.T(x, v)])
    assert d.T(x, u) > 0


@pytest.mark.parametrize("element", ELEMENTS, ids=lambda e: e.name)
def test_every_element_says_what_it_is_and_where_it_comes_from(element: Element) -> None:
    assert element.doc
    assert element.source
    assert all(parameter.doc for parameter in element.parameters)


def test_names_in_the_tables_are_unique() -> None:
    names = [element.name for element in ELEMENTS] + [f"law_{law.name}" for law in LAWS]
    assert len(names) == len(set(names))


# --- configurations without deformation --------------------------------------------------------------------


def straight(rng: random.Random) -> tuple[dict[str, Any], dict[str, Vector]]:
    """Return parameters and the place of a straight line of nodes p, q with body frames turned at random."""
    l0 = mpf(rng.uniform(0.5, 1.5))
    tp, tq = unit(column(rng, 4)), unit(column(rng, 4))
    values = {"l0": l0, "tp": tp, "tq": tq, "d0": [l0, 0, 0]}
    return values, {"p": [0, 0, 0], "q": [l0, 0, 0], "rp": conjugate(tp), "rq": conjugate(tq)}


@pytest.mark.parametrize("name", ["truss", "bearing", "beam3", "beam", "beam_first_order"])
def test_straight_element_anywhere_in_space_is_undeformed(name: str, rng: random.Random) -> None:
    element = BY_NAME[name]
    values, places = straight(rng)
    d = numbers(element, **values)
    x = [c for node in element.nodes for c in places[node.name]]
    assert equal(d.D(symmetry(element, values, rng).moved(element, x)), [0] * d.m)


@pytest.mark.parametrize("name", ["planar_truss", "planar_beam", "planar_beam_first_order", "planar_beam3"])
def test_straight_element_anywhere_in_the_plane_is_undeformed(name: str, rng: random.Random) -> None:
    element = BY_NAME[name]
    values, x = planar_straight(element, rng)
    d = numbers(element, **values)
    assert equal(d.D(symmetry(element, values, rng).moved(element, x)), [0] * d.m)


def planar_straight(element: Element, rng: random.Random) -> tuple[dict[str, Any], Vector]:
    l0, alpha0, alphaq0 = (mpf(rng.uniform(0.5, 1.5)) for _ in range(3))
    values = {"l0": l0, "alpha0": alpha0, "alphaq0": alphaq0, "d0": [l0, 0]}
    places = {"p": [0, 0], "rp": [-alpha0], "q": [l0, 0], "rq": [-alphaq0]}
    return values, [c for node in element.nodes for c in places[node.name]]


def test_hinge_angle_is_the_prescribed_rotation(rng: random.Random) -> None:
    tp, tq, lp = (unit(column(rng, 4)) for _ in range(3))
    d = numbers(BY_NAME["hinge"], tp=tp, tq=tq)
    for degrees in range(-175, 180, 25):
        angle = mpmath.radians(degrees)
        lq = product(product(product(lp, tp), rotation(X, angle)), conjugate(tq))
        assert equal(d.D([*lp, *lq]), [angle, 0, 0])


def test_hinge_bendings_are_small_rotations_about_y_and_z(rng: random.Random) -> None:
    """The axis of q in the triad of p is (1, -bend2, bend1): turned by bend1 about -y and by -bend2 about z."""
    t = [1, 0, 0, 0]
    d = numbers(BY_NAME["hinge"], tp=t, tq=t)
    small = mpf(10) ** -12
    assert equal(d.D([*t, *rotation(Y, small)]), [0, -small, 0], small**2)
    assert equal(d.D([*t, *rotation(Z, small)]), [0, 0, -small], small**2)


# --- bodies ------------------------------------------------------------------------------------------------


def test_body_is_a_cloud_of_point_masses(rng: random.Random) -> None:
    masses = [mpf(rng.uniform(0.5, 1)) for _ in range(5)]
    arms = [column(rng, 3) for _ in masses]
    mass = sum(masses)
    centre = [sum(m * a[i] for m, a in zip(masses, arms, strict=True)) / mass for i in range(3)]
    about = [plus(arm, centre, -1) for arm in arms]

    def moment(i: int, j: int) -> Any:
        pairs = zip(masses, about, strict=True)
        return sum(m * ((i == j) * dot(a, a) - a[i] * a[j]) for m, a in pairs)

    tensor = [moment(0, 0), moment(1, 1), moment(2, 2), moment(0, 1), moment(0, 2), moment(1, 2)]
    gravity = column(rng, 3)
    d = numbers(BY_NAME["body"], mass=mass, c=centre, J=tensor, gravity=gravity)
    x, lam, velocity, omega = column(rng, 3), unit(column(rng, 4)), column(rng, 3), column(rng, 3)
    global_arms = [rotated(lam, arm) for arm in arms]
    speeds = [plus(velocity, cross(omega, arm)) for arm in global_arms]
    T = sum(m * dot(v, v) / 2 for m, v in zip(masses, speeds, strict=True))
    U = -sum(m * dot(gravity, plus(x, arm)) for m, arm in zip(masses, global_arms, strict=True))
    rates = [c / 2 for c in product([0, *omega], lam)]
    assert equal([d.T([*x, *lam], [*velocity, *rates]), d.U([*x, *lam])], [T, U])


@beams
def test_kinetic_energy_of_a_rigidly_moving_beam_is_that_of_a_rod(name: str, rng: random.Random) -> None:
    values, places = straight(rng)
    rhoJ = [abs(c) for c in column(rng, 3)]
    values |= {"rhoA": mpf("1.3"), "rhoJ": rhoJ, "phi_y": mpf("0.4"), "phi_z": mpf("0.7")}
    element, l0 = BY_NAME[name], values["l0"]
    x = [c for node in element.nodes for c in places[node.name]]
    motion = symmetry(element, values, rng)
    v = motion.rigid_rates(element, x)
    centre, w, mass = (
        plus(motion.velocity, cross(motion.omega, [l0 / 2, 0, 0])),
        motion.omega,
        l0 * mpf("1.3"),
    )
    inertia = [l0 * rhoJ[0], l0 * rhoJ[1] + mass * l0**2 / 12, l0 * rhoJ[2] + mass * l0**2 / 12]
    T = mass * dot(centre, centre) / 2 + sum(j * c**2 for j, c in zip(inertia, w, strict=True)) / 2
    assert equal([numbers(element, **values).T(x, v)], [T])
    weight = numbers(element, **(values | {"gravity": Z})).U(x)
    assert equal([weight], [0])


def test_rigid_beam_moves_like_the_flexible_one_when_rigid(rng: random.Random) -> None:
    values, places = straight(rng)
    values |= {"rhoA": mpf("1.3"), "rhoJ": [mpf("0.1"), mpf("0.2"), mpf("0.3")], "gravity": column(rng, 3)}
    motion = symmetry(BY_NAME["beam"], values, rng)
    energies = []
    for name in ("beam", "beam3"):
        element = BY_NAME[name]
        x = motion.moved(element, [c for node in element.nodes for c in places[node.name]])
        d = numbers(element, **{k: v for k, v in values.items() if k in {p.name for p in element.parameters}})
        energies.append([d.T(x, motion.rigid_rates(element, x)), d.U(x)])
    assert equal(*energies)


# --- beams -------------------------------------------------------------------------------------------------


def test_second_order_terms_are_of_second_order(rng: random.Random) -> None:
    values, places = straight(rng)
    small = mpf(10) ** -8
    x = [c for name in ("p", "rp", "q", "rq") for c in places[name]]
    x = plus(x, column(rng, 14), small)
    first, second = (numbers(BY_NAME[name], **values).D(x) for name in ("beam_first_order", "beam"))
    assert max(abs(e) for e in first) > small / 10
    assert equal(first, second, 10 * small**2)
    assert not equal(first, second, small**2 / 1000)


def bent(rng: random.Random, size: Any) -> tuple[dict[str, Any], Vector]:
    values, places = straight(rng)
    x = [c for name in ("p", "rp", "q", "rq") for c in places[name]]
    x = plus(x, column(rng, 14), size)
    return values, [*x[:3], *unit(x[3:7]), *x[7:10], *unit(x[10:])]


@beams
def test_beam_read_from_the_other_end_is_the_same_beam(name: str, rng: random.Random) -> None:
    """Exchange p and q and turn both triads half a turn about e_z: bending modes exchange, the rest stays."""
    values, x = bent(rng, mpf("0.2"))
    values |= {
        "rhoA": 1,
        "rhoJ": [mpf("0.1"), mpf("0.2"), mpf("0.3")],
        "phi_y": mpf("0.4"),
        "gravity": column(rng, 3),
    }
    half = [0, 0, 0, 1]
    turned = values | {"tp": product(values["tq"], half), "tq": product(values["tp"], half)}
    v, exchange = column(rng, 14), lambda x: [*x[7:], *x[:7]]
    there, back = numbers(BY_NAME[name], **values), numbers(BY_NAME[name], **turned)
    e1, e2, e3, e4, e5, e6 = there.D(x)
    assert equal(back.D(exchange(x)), [e1, e2, e4, e3, -e6, -e5])
    assert equal([back.T(exchange(x), exchange(v))], [there.T(x, v)])
    assert equal([back.U(exchange(x))], [there.U(x)])


def test_elongation_of_a_bent_beam_is_the_change_of_its_arc_length(rng: random.Random) -> None:
    """End slopes a, b from the chord: the cubic between them is longer than the chord by l (2a²-ab+2b²)/30."""
    a, b = mpf(10) ** -6, mpf(-2) * mpf(10) ** -6
    length = 1 - (2 * a**2 - a * b + 2 * b**2) / 30
    d = numbers(BY_NAME["planar_beam"], l0=1)
    assert abs(d.D([0, 0, a, length, 0, b])[0]) < mpf(10) ** -22
    assert equal(d.D([0, 0, a, length, 0, b])[1:], [-a, b], mpf(10) ** -17)


def rod(curvature: Callable[[Any], Vector], steps: int = 40) -> tuple[Vector, Vector]:
    """Return the end of an inextensible rod of length 1 from the origin along x: position and quaternion (RK4)."""

    def slope(s: Any, y: Vector) -> Vector:
        turning = [c / 2 for c in product(y[3:], [0, *curvature(s)])]
        return [*rotated(y[3:], X), *turning]

    y, h = [mpf(c) for c in (0, 0, 0, 1, 0, 0, 0)], mpf(1) / steps
    for i in range(steps):
        k1 = slope(i * h, y)
        k2 = slope((i + mpf("0.5")) * h, plus(y, k1, h / 2))
        k3 = slope((i + mpf("0.5")) * h, plus(y, k2, h / 2))
        k4 = slope((i + 1) * h, plus(y, k3, h))
        y = [c + h / 6 * (a + 2 * b + 2 * d + e) for c, a, b, d, e in zip(y, k1, k2, k3, k4, strict=True)]
    return y[:3], unit(y[3:])


@pytest.mark.parametrize(("name", "order"), [("beam", 4), ("beam_first_order", 3)])
def test_energy_of_a_bent_and_twisted_beam_is_that_of_the_rod(
    name: str, order: int, rng: random.Random
) -> None:
    """With bending moments linear along the rod and a constant torque it is in equilibrium to first order.

    The energies then agree to third order in the deformation, for any stiffness; without the second-order
    terms of the deformations to second order only.
    """
    small, GJ, EIy, EIz = mpf("1e-3"), mpf(2), mpf(3), mpf(5)
    torsion, y0, y1, z0, z1 = column(rng, 5)

    def curvature(s: Any) -> Vector:
        return [small * torsion, small * (y0 + y1 * (2 * s - 1)), small * (z0 + z1 * (2 * s - 1))]

    exact = (GJ * torsion**2 + EIy * (y0**2 + y1**2 / 3) + EIz * (z0**2 + z1**2 / 3)) / 2
    end, turned = rod(curvature)
    still = [1, 0, 0, 0]
    d = numbers(BY_NAME[name], l0=1, tp=still, tq=still)
    e1, e2, e3, e4, e5, e6 = d.D([0, 0, 0, *still, *end, *turned])
    energy = e1**2 + GJ * e2**2
    energy += EIy * 4 * (e3**2 - e3 * e4 + e4**2) + EIz * 4 * (e5**2 - e5 * e6 + e6**2)
    error = abs(energy / 2 / small**2 - exact)
    assert error < 10 * small ** (order - 2)
    assert (error < small / 100) == (abs(e1) < 10 * small**3) == (order == 4)


def test_rotary_inertia_is_przemienieckis_for_stiff_shear_and_linear_for_soft_shear() -> None:
    """Without shear: (36, 3 l, 4 l², -l²)/30 in terms of deflections; with soft shear: a rod's (2, 1)/6."""
    P, r = sp.Symbol("P"), sp.Rational
    gram = sp.Matrix(rotary_gram())
    stiff = sp.Matrix(
        [[r(6, 5), -r(1, 10), -r(1, 10)], [-r(1, 10), r(2, 15), -r(1, 30)], [-r(1, 10), -r(1, 30), r(2, 15)]]
    )
    assert gram.subs(P, 0) == stiff
    assert (gram / P**2).applyfunc(lambda g: sp.limit(g, P, sp.oo)) == sp.Matrix(
        [[0, 0, 0], [0, 2, 1], [0, 1, 2]]
    ) / 6


def spatial(element: Element, x: Vector, rates: Vector) -> tuple[Vector, Vector]:
    """Return coordinates and rates of the spatial nodes that move in the plane as the planar ones do."""
    y: Vector = []
    w: Vector = []
    start = 0
    for node in element.nodes:
        value, rate = x[start : start + node.size], rates[start : start + node.size]
        start += node.size
        if node.kind == "planar_angle":
            lam = rotation(Z, value[0])
            y += lam
            w += [c / 2 for c in product([0, 0, 0, rate[0]], lam)]
        else:
            y += [*value, mpf(0)]
            w += [*rate, mpf(0)]
    return y, w


SPATIAL = {"planar_beam": "beam", "planar_beam_first_order": "beam_first_order", "planar_beam3": "beam3"}
SPATIAL |= {"planar_truss": "truss", "planar_hinge": "hinge", "planar_body": "body"}
SPATIAL |= {"planar_rotary_inertia": "rotary_inertia"}
SPATIAL |= {"planar_point_mass": "point_mass", "planar_body_velocity": "body_velocity"}
SPATIAL |= {"planar_bar_span": "bar_span", "planar_beam_span": "beam_span"}
SPATIAL |= {"planar_cable": "cable", "planar_cable_span": "cable_span", "planar_slope_clamp": "slope_clamp"}
SPATIAL |= {"planar_cable_circle": "cable_cylinder", "planar_cable_line": "cable_plane"}
MODES = {"planar_beam": (0, 4, 5), "planar_beam_first_order": (0, 4, 5), "planar_beam3": (0, 1)}
MODES |= {"planar_cable": (0, 1, 2, 3, 6, 9, 12), "planar_slope_clamp": (0,)}
MODES |= {"planar_cable_circle": (0,), "planar_cable_line": (0,)}
MODES |= {"planar_truss": (0,), "planar_hinge": (0,), "planar_body": (), "planar_point_mass": ()}


# Quaternions from the plane's axes to those of the spatial surface: x along z; z along y with x along x.
CIRCLE_AXES = [mpf(1) / 2, mpf(-1) / 2, mpf(-1) / 2, mpf(-1) / 2]
LINE_AXES = rotation(X, -mpmath.pi / 2)


def spatial_parameters(values: dict[str, Any], turned: bool) -> dict[str, Any]:
    """Parameters of the spatial element for those of the planar one; `turned`: the hinge's axis is x, not z."""
    result = dict(values)
    in_plane = rotation(Z, values.get("alpha0", mpf(0)))
    if "offset" in values:
        x, y = values["offset"]
        circle = "radius" in values
        result["t"] = product(in_plane, CIRCLE_AXES if circle else LINE_AXES)
        result["offset"] = rotated(conjugate(CIRCLE_AXES if circle else LINE_AXES), [x, y, 0])
    elif "alpha0" in values:
        result["t"] = in_plane
    for name, angle in (("tp", values.get("alpha0", mpf(0))), ("tq", values.get("alphaq0", mpf(0)))):
        result[name] = rotation(Y, -mpmath.pi / 2) if turned else rotation(Z, angle)
    if turned:
        result["tp"] = product(rotation(Z, values["offset0"]), result["tp"])
    for name in ("gravity", "c", "d0"):
        if name in values:
            result[name] = [*values[name], 0]
    if "rhoJ" in values:
        result["rhoJ"] = [0, 0, values["rhoJ"]]
    if "phi_z" in values:
        result |= {"phi_y": values["phi_z"], "phi_z": 0}
    if "J" in values:
        result["J"] = [0, 0, values["J"], 0, 0, 0]
    return result


@pytest.mark.parametrize("name", sorted(SPATIAL))
def test_planar_element_is_the_spatial_one_in_a_plane(name: str, rng: random.Random) -> None:
    planar, space = BY_NAME[name], BY_NAME[SPATIAL[name]]
    values = random_parameters(planar, rng)
    x, v = random_coordinates(planar, rng), random_coordinates(planar, rng)
    names = {p.name for p in space.parameters}
    twin = spatial_parameters(values, turned="hinge" in name)
    flat, full = numbers(planar, **values), numbers(space, **{k: u for k, u in twin.items() if k in names})
    y, w = spatial(planar, x, v)
    e = full.D(y)
    modes = MODES.get(name, ())
    assert equal([e[i] for i in modes], flat.D(x))
    assert equal([e[i] for i in range(full.m) if i not in modes], [0] * (full.m - flat.m))
    assert equal(full.s(y, w)[: len(planar.slips)], flat.s(x, v))
    assert equal([full.T(y, w), full.U(y)], [flat.T(x, v), flat.U(x)])


PLANAR_ALONE = {"planar_bearing", "planar_belt", "planar_gear", "planar_wheel"}  # tested below


@pytest.mark.parametrize("element", [e for e in ELEMENTS if is_planar(e)], ids=lambda e: e.name)
def test_every_planar_element_has_its_spatial_counterpart(element: Element) -> None:
    assert (element.name in SPATIAL) != (element.name in PLANAR_ALONE)


def test_planar_bearing_measures_what_a_rigid_link_and_a_hinge_do(rng: random.Random) -> None:
    element = BY_NAME["planar_bearing"]
    values, x = random_parameters(element, rng), random_coordinates(element, rng)
    link = numbers(BY_NAME["planar_beam3"], alpha0=values["alpha0"], d0=values["d0"]).D(x[:5])
    angle = numbers(BY_NAME["planar_hinge"], offset0=values["offset0"]).D([x[2], x[5]])
    assert equal(numbers(element, **values).D(x), [*link, *angle])


# --- pulleys, gears and wheels in the plane; surfaces ------------------------------------------------------


def belt_force(radii: Vector, x: Vector) -> Vector:
    """Forces and moments on the nodes that do the work of a unit tension, by differences."""
    d, h = numbers(BY_NAME["planar_belt"], radius_p=radii[0], radius_q=radii[1]), mpf(10) ** -16
    steps = [[h if i == j else mpf(0) for i in range(6)] for j in range(6)]
    return [(d.D(plus(x, u))[0] - d.D(plus(x, u, -1))[0]) / (2 * h) for u in steps]


@pytest.mark.parametrize("radii", [(0.3, 0.3), (0.5, 0.2), (0.2, -0.4), (-0.3, -0.1)])
def test_tension_of_a_belt_acts_along_the_common_tangent(radii: tuple[float, float]) -> None:
    a, b = map(mpf, radii)
    x = [mpf(0), mpf(0), mpf("0.3"), mpf("1.2"), mpf("0.5"), mpf("-0.2")]
    px, py, moment_p, qx, qy, moment_q = belt_force([a, b], x)
    small = mpf(10) ** -25
    assert equal([px + qx, py + qy, qx * qx + qy * qy], [0, 0, 1], small)  # a unit force and its reaction
    assert equal([moment_p, moment_q], [a, -b], small)
    # the line of the force passes both centres at the distances of the radii, on the left where they are positive
    total = moment_p + moment_q + x[3] * qy - x[4] * qx
    assert abs(total) < small


def test_gears_roll_without_slip_on_centres_that_move(rng: random.Random) -> None:
    a, b, arm, turn = (mpf(rng.uniform(0.2, 0.6)) for _ in range(4))
    d = numbers(BY_NAME["planar_gear"], radius_p=a, radius_q=b)
    start = [mpf(0), mpf(0), mpf(0), a + b, mpf(0), mpf(0)]
    assert equal(d.D(start), [0])
    # planetary gear: the arm turns about the fixed sun, the planet by (1 + a/b) as much
    x = [mpf(0), mpf(0), mpf(0), (a + b) * cos(arm), (a + b) * sin(arm), arm * (1 + a / b)]
    assert equal(d.D(x), [0])
    # fixed centres: opposite turns in the ratio of the radii
    assert equal(d.D([0, 0, turn, a + b, 0, -turn * a / b]), [0])


def test_planar_wheel_rolls_where_it_heads(rng: random.Random) -> None:
    radius, heading, alpha0, spin = (mpf(rng.uniform(0.2, 0.6)) for _ in range(4))
    d = numbers(BY_NAME["planar_wheel"], radius=radius, alpha0=alpha0)
    ahead = [cos(heading + alpha0), sin(heading + alpha0)]
    x = [mpf(0), mpf(0), heading, mpf(0)]
    assert equal(d.s(x, [radius * spin * ahead[0], radius * spin * ahead[1], mpf(1), spin]), [0, 0])
    assert equal(d.s(x, [-ahead[1], ahead[0], 0, 0]), [0, 1])


def test_surface_is_its_polynomial() -> None:
    d = numbers(BY_NAME["surface"], quadratic=[1, 2, 3, 4, 5, 6], linear=[7, 8, 9], constant=10)
    assert equal(d.D([mpf(1), mpf(2), mpf(3)]), [1 + 8 + 27 + 8 + 15 + 36 + 7 + 16 + 27 + 10])


# --- wheels ------------------------------------------------------------------------------------------------


def leaning_wheel(rng: random.Random) -> tuple[Definition, Vector, Vector]:
    """Return a wheel on a tilted road, leaning, in contact, and r from the hub to the contact point."""
    road = unit(column(rng, 4))
    radius, height, lean, heading, pitch = (mpf(rng.uniform(0.3, 0.6)) for _ in range(5))
    body = product(rotation(Z, heading), product(rotation(X, lean), rotation(Y, pitch)))
    contact = rotated(road, [mpf("0.3"), mpf("-0.7"), height])
    r = rotated(product(road, product(rotation(Z, heading), rotation(X, lean))), [0, 0, -radius])
    normal = rotated(road, Z)
    d = numbers(BY_NAME["wheel"], radius=radius, axle=Y, normal=normal, height=height)
    return d, [*plus(contact, r, -1), *product(road, body), *contact], r


def test_wheel_in_contact_is_undeformed(rng: random.Random) -> None:
    d, x, _ = leaning_wheel(rng)
    assert equal(d.D(x), [0, 0, 0, 0])


def test_rolling_wheel_does_not_slip_but_spins(rng: random.Random) -> None:
    d, x, r = leaning_wheel(rng)
    omega, normal = column(rng, 3), many(d.p[4:7])
    hub = cross(r, omega)
    rates = [c / 2 for c in product([0, *omega], x[3:7])]
    assert equal(d.s(x, [*hub, *rates, *column(rng, 3)]), [0, 0, dot(omega, normal)])


def test_slips_of_a_sliding_wheel_are_its_velocity_in_the_road(rng: random.Random) -> None:
    """An upright wheel with axle y, above the road z = 0: r x a points to +x and n x (r x a) to +y."""
    d = numbers(BY_NAME["wheel"], radius=1, axle=Y, normal=Z, height=0)
    x = [0, 0, 1, 1, 0, 0, 0, 0, 0, 0]
    v = [mpf("0.3"), mpf("-0.2"), 0, 0, 0, 0, 0, 0, 0, 0]
    assert equal(d.s(x, v), [mpf("0.3"), mpf("-0.2"), 0])


def test_angular_velocities_in_body_and_global_axes_are_one_vector(rng: random.Random) -> None:
    t, lam, omega = unit(column(rng, 4)), unit(column(rng, 4)), column(rng, 3)
    rates = [c / 2 for c in product([0, *omega], lam)]
    assert equal(numbers(BY_NAME["rotation"]).s(lam, rates), omega)
    local = numbers(BY_NAME["body_rotation"], t=t).s(lam, rates)
    assert equal(rotated(product(lam, t), local), omega)


# --- laws --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("law", LINEAR, ids=lambda law: law.name)
def test_stored_energy_is_the_potential_of_the_stresses_at_rest(law: Law) -> None:
    at_rest = {rate: 0 for rate in (*law.ed, *law.s)}
    for e, sigma in zip(law.e, law.sigma, strict=True):
        assert sp.expand(sp.diff(law.energy, e) - sigma.subs(at_rest)) == 0


@pytest.mark.parametrize("law", LINEAR, ids=lambda law: law.name)
def test_laws_of_the_table_are_symmetric(law: Law) -> None:
    for outputs, inputs in ((law.sigma, law.e), (law.sigma, law.ed), (law.tau, law.s)):
        jacobian = sp.Matrix(outputs).jacobian(inputs) if outputs else sp.zeros(0)
        assert jacobian == jacobian.T


# --- what a declaration may not contain --------------------------------------------------------------------

P, R = Point("p"), Frame("r")
LENGTH = sp.sqrt(P.x.dot(P.x))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"deformations": (Deformation("d", "m", LENGTH - symbol("l0")),)}, "'d' contains l0"),
        ({"deformations": (Deformation("d", "m", P.x),)}, "'d' is not a scalar"),
        ({"deformations": (Deformation("d", "", LENGTH),)}, "'d' has no unit"),
        ({"deformations": (Deformation("d", "m", P.v[0]),)}, "'d' depends on rates"),
        (
            {"deformations": (Deformation("d", "m", LENGTH), Deformation("d", "m", LENGTH))},
            "'d' is used twice",
        ),
        ({"slips": (Slip("s", "m/s", P.v[0] ** 2),)}, "'s' is not linear"),
        ({"slips": (Slip("s", "m/s", P.v[0] + 1),)}, "'s' is not linear"),
        ({"slips": (Slip("s", "m/s", sp.sqrt(P.v[0] ** 2)),)}, "'s' is not linear"),
        ({"kinetic_energy": P.v[0]}, "kinetic energy is not quadratic"),
        ({"potential": P.v[0]}, "potential depends on rates"),
        ({"parameters": (Parameter("p_x", 1, "m", "clash"),)}, "'p_x' is used twice"),
        ({"parameters": (Parameter("double", 1, "m", "word of C"),)}, "'double' cannot be a name"),
        ({"nodes": (P, P)}, "is used twice"),
        ({"nodes": ()}, "has no nodes"),
        ({"let": ((symbol("l"), symbol("k")),)}, "let 'l' contains k"),
    ],
)
def test_a_wrong_declaration_is_refused_by_name(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Element(**({"name": "wrong", "nodes": (P,)} | arguments))


def test_a_parameter_needs_a_unit() -> None:
    with pytest.raises(ValueError, match="no unit"):
        Parameter("k", 1, "", "stiffness")


def test_a_law_gives_a_stress_for_each_deformation() -> None:
    e, ed = symbol("e"), symbol("ed")
    with pytest.raises(ValueError, match="a stress for each deformation"):
        Law(name="wrong", doc="", parameters=(), e=(e,), ed=(ed,), s=(), sigma=(), tau=())


def test_coordinates_have_readable_names() -> None:
    assert [s.name for s in Point("p").x] == ["p_x", "p_y", "p_z"]
    assert [s.name for s in Frame("r").v] == ["r_vl0", "r_vl1", "r_vl2", "r_vl3"]
    assert [s.name for s in PlanarPoint("p").v] == ["p_vx", "p_vy"]
    assert [s.name for s in PlanarAngle("r").x] == ["r_angle"]
