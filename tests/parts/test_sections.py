"""Sections and materials: closed forms, limits, what a beam takes from them, and stresses at a state."""

import numpy as np
import pytest

import flexel as fx
from flexel.model.profiles import SectionForces
from flexel.parts.materials import MATERIALS, Profile

STEEL = MATERIALS["steel"]


def quadrature(section: fx.Rectangle) -> float:
    """Torsion constant by Prandtl's stress function on a grid: 4 times the integral of the solved Poisson problem."""
    from scipy.sparse import diags_array as diags
    from scipy.sparse import eye, kron
    from scipy.sparse.linalg import spsolve

    def constant(n: int) -> float:
        hy, hz = section.height / n, section.width / n

        def second(h: float) -> object:
            return diags([1.0, -2.0, 1.0], offsets=[-1, 0, 1], shape=(n - 1, n - 1)) / h**2

        A = kron(second(hy), eye(n - 1)) + kron(eye(n - 1), second(hz))
        phi = spsolve(A.tocsc(), -2 * np.ones((n - 1) ** 2))
        return float(2 * phi.sum() * hy * hz)

    coarse, fine = constant(40), constant(80)
    return fine + (fine - coarse) / 3


@pytest.mark.parametrize("ratio", [1.0, 2.0, 5.0])
def test_torsion_constant_of_a_rectangle_is_that_of_prandtls_stress_function(ratio: float) -> None:
    section = fx.Rectangle(1.0, ratio)
    assert section.J == pytest.approx(quadrature(section), rel=2e-5)


@pytest.mark.parametrize(
    ("ratio", "constant", "modulus"), [(1.0, 0.1406, 0.208), (2.0, 0.229, 0.246), (10.0, 0.312, 0.312)]
)
def test_torsion_of_a_rectangle_is_as_tabulated(ratio: float, constant: float, modulus: float) -> None:
    # Timoshenko and Goodier, Theory of Elasticity, art. 109, table of k1 and k2
    for section in (fx.Rectangle(1.0, ratio), fx.Rectangle(ratio, 1.0)):
        assert pytest.approx(constant * ratio, abs=6e-4 * ratio) == section.J
        assert 1 / max(section.torsion_shear()) == pytest.approx(modulus * ratio, abs=6e-4 * ratio)


def test_a_square_has_the_same_torsional_shear_on_all_faces() -> None:
    a, b = fx.Rectangle(1.0, 1.0).torsion_shear()
    assert a == pytest.approx(b, rel=1e-10)


def test_a_thin_strip_has_a_third_of_width_times_thickness_cubed() -> None:
    t, w = 0.3, 100.0
    exact = w * t**3 / 3 * (1 - 0.630249 * t / w)
    assert fx.Rectangle(t, w).J == pytest.approx(exact, rel=1e-8)
    assert max(fx.Rectangle(t, w).torsion_shear()) == pytest.approx(t / exact, rel=1e-7)


def test_tube_and_circle_agree_and_a_thin_tube_has_half_the_shear_factor() -> None:
    assert fx.Circle(2.0).Iy == pytest.approx(np.pi / 4)
    assert fx.Circle(2.0).J == pytest.approx(np.pi / 2)
    assert fx.Circle(2.0).shear_factors(0.3)[0] == pytest.approx(6 * 1.3 / (7 + 6 * 0.3))
    assert fx.Tube(2.0, 1.9999).shear_factors(0.3)[0] == pytest.approx(2 * 1.3 / (4 + 3 * 0.3), rel=1e-4)


def test_an_i_section_without_web_step_is_a_rectangle() -> None:
    i, r = fx.IBeam(0.2, 0.1, flange=0.01, web=0.1), fx.Rectangle(0.2, 0.1)
    np.testing.assert_allclose([i.A, i.Iy, i.Iz], [r.A, r.Iy, r.Iz], rtol=1e-12)


def test_hea_200_without_fillets() -> None:
    # EN profile table: A = 53.8 cm2, Iy = 3692 cm4, Iz = 1336 cm4 with fillets of 18 mm, which add 2.8 cm2
    i = fx.IBeam(0.190, 0.200, flange=0.010, web=0.0065)
    assert pytest.approx(53.8e-4, rel=0.06) == i.A
    assert pytest.approx(3692e-8, rel=0.06) == i.Iz
    assert pytest.approx(1336e-8, rel=0.01) == i.Iy


def test_stress_is_bending_over_modulus_and_combines_after_mises() -> None:
    corner = fx.Rectangle(2.0, 3.0).stresses(SectionForces(N=6.0, My=3.0, Mz=2.0))[0]
    assert corner.normal == pytest.approx(1 + 3.0 / (2 * 9 / 6) + 2.0 / (3 * 4 / 6))
    fibre = fx.Circle(2.0).stresses(SectionForces(T=1.0, My=3.0, Mz=4.0))[0]
    sigma, tau = 5 * 4 / np.pi, 2 / np.pi
    assert fibre.mises == pytest.approx(np.sqrt(sigma**2 + 3 * tau**2))
    with_shear = fx.Circle(2.0).stresses(SectionForces(Vy=3.0))[1]
    assert with_shear.shear == pytest.approx(4 * 3 / (3 * np.pi))


def leaf(**beam: object) -> fx.Model:
    """One beam of 0.1 m along x, clamped at the left."""
    m = fx.Model()
    m.point("P", (0, 0, 0), fixed=True)
    m.frame("R", fixed=True)
    m.point("Q", (0.1, 0, 0))
    m.frame("S")
    m.beam("b", "P", "R", "Q", "S", direction=(0, 1, 0), **beam)
    return m


SECTION = fx.Rectangle(5e-3, 20e-3)


def test_a_section_gives_the_beam_its_stiffness_and_mass() -> None:
    profile = Profile(SECTION, STEEL)
    mass, inertia = profile.mass()
    numbers = leaf(mass_per_length=mass, inertia_per_length=inertia, **profile.stiffness()).build()
    named = leaf(section=SECTION, material="steel").build()
    for a, b in zip(numbers.vibrations(), named.vibrations(), strict=True):
        assert a.omega == pytest.approx(b.omega, rel=1e-12)


def test_flexible_modes_can_be_chosen() -> None:
    m = leaf(section=SECTION, material="steel", flexible=["bend3", "bend4", "torsion"])
    assert [law.deformations for law in m.laws] == [("b.torsion",), ("b.bend3", "b.bend4")]
    assert m.build().counts["degrees_of_freedom"] == 3


def test_section_forces_balance_the_load_in_the_deformed_state() -> None:
    m = leaf(section=fx.Rectangle(0.5e-3, 10e-3), material="steel")
    F, M = np.array([1.0, 0.1, 2.0]), np.array([0.01, 0.0, 0.02])
    m.load("Q", list(F))
    m.load("S", list(M))
    state = m.build().equilibrium()
    p, q = state.section_forces("b")
    np.testing.assert_allclose([p.N, p.Vy, p.Vz], F, atol=1e-9)
    moment = M + np.cross(state.position("Q"), F)
    np.testing.assert_allclose([p.T, p.My, p.Mz], moment, atol=1e-9)
    assert np.linalg.norm([q.N, q.Vy, q.Vz]) == pytest.approx(np.linalg.norm(F))
    assert np.linalg.norm([q.T, q.My, q.Mz]) == pytest.approx(np.linalg.norm(M))


def test_planar_and_spatial_beams_have_the_same_stress() -> None:
    section = fx.Rectangle(0.5e-3, 10e-3)
    m = fx.Model()
    m.point("P", (0, 0), fixed=True)
    m.angle("R", fixed=True)
    m.point("Q", (0.1, 0))
    m.angle("S")
    m.beam("b", "P", "R", "Q", "S", section=section, material="steel")
    m.load("Q", (2.0, 1.0))
    space = leaf(section=section, material="steel")
    space.load("Q", (2.0, 1.0, 0.0))
    flat, full = (model.build().equilibrium().stress("b") for model in (m, space))
    assert flat.mises == pytest.approx(full.mises, rel=1e-9)
    assert flat.end == full.end == "p"
    np.testing.assert_allclose(flat.forces.Mz, full.forces.Mz, rtol=1e-9)


def test_the_largest_stress_of_a_cantilever_is_at_the_clamp_and_has_a_safety() -> None:
    m = leaf(section=fx.Rectangle(5e-3, 10e-3), material="aluminium")
    m.load("Q.y", 10.0)
    worst = m.build().equilibrium().largest_stress()
    assert (worst.beam, worst.end, worst.point.place) == ("b", "p", "corner")
    assert worst.mises == pytest.approx(10 * 0.1 * 6 / (10e-3 * 5e-3**2), rel=1e-3)
    assert worst.safety == pytest.approx(503e6 / worst.mises)


def test_a_beam_with_initial_curvature_takes_its_circle() -> None:
    kappa, n, L = 5.0, 16, 0.1
    m = fx.Model()
    m.point("P0", (0, 0, 0), fixed=True)
    m.frame("R0", fixed=True)
    for i in range(n):
        m.point(f"P{i + 1}", (L * (i + 1) / n, 0, 0))
        m.frame(f"R{i + 1}")
        ends = (f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}")
        m.beam(f"b{i}", *ends, direction=(0, 1, 0), section=SECTION, material="steel",
               initial_strain=0.01, initial_curvature=(0, 0, kappa))  # fmt: skip
    state = m.build().equilibrium()
    a, r = kappa * L, 1 / kappa
    along = 1.01  # of the arc; the curvature is counted per drawn length
    np.testing.assert_allclose(
        state.position(f"P{n}"),
        np.array([r * np.sin(a), r * (1 - np.cos(a)), 0]) * along,
        rtol=1e-3,
        atol=1e-15,
    )
    assert abs(state.largest_stress().mises) < 1e-3 * STEEL.E * kappa * 5e-3 / 2


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_initial_curvature_has_the_sign_of_a_turn_about_its_axis(axis: int) -> None:
    kappa = np.zeros(3)
    kappa[axis] = 0.01
    m = leaf(section=SECTION, material="steel", initial_curvature=kappa)
    state = m.build().equilibrium()
    assert state[f"S.lambda{axis + 1}"] == pytest.approx(0.01 * 0.1 / 2, rel=1e-5)


@pytest.mark.parametrize(
    ("beam", "message"),
    [
        ({"section": SECTION}, "a section needs a material; give one of steel"),
        ({"section": SECTION, "material": "stell"}, "unknown material 'stell'; did you mean steel"),
        ({"material": "steel"}, "material is given without a section"),
        ({"section": 3.0, "material": "steel"}, "3.0 is not a section; give Rectangle"),
        ({"section": SECTION, "material": "steel", "EA": 1.0}, "already give EA; drop these"),
        ({"section": SECTION, "material": "steel", "flexible": ["bend3"]}, "one of bend3 and bend4"),
        (
            {"section": SECTION, "material": "steel", "flexible": ["shear"]},
            "name modes of this beam: elongation, torsion",
        ),
        ({"EA": 1.0, "initial_curvature": (0, 0, 1)}, "in bend3, bend4, which is rigid"),
        ({"EA": 1.0, "initial_strain": np.nan}, "initial_strain nan is not finite"),
    ],
)
def test_bad_sections_of_a_beam_are_named(beam: dict[str, object], message: str) -> None:
    with pytest.raises(fx.ModelError, match="beam 'b'") as error:
        leaf(**beam)
    assert message in str(error.value)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: fx.Rectangle(0.0, 1.0), "Rectangle: height 0 is not positive"),
        (lambda: fx.Tube(1.0, 1.0), "inner 1 is not less than outer 1"),
        (lambda: fx.Circle(0.0), "Circle: diameter 0 is not positive"),
        (lambda: fx.IBeam(1.0, 1.0, flange=0.5, web=0.1), "do not fit"),
        (lambda: fx.Material(E=1.0), "give either nu or G"),
        (lambda: fx.Material(E=1.0, nu=0.7), "Poisson's ratio 0.7"),
        (lambda: fx.Material(E=3.0, G=0.5), "Poisson's ratio 2"),
    ],
)
def test_impossible_sections_and_materials_are_named(make: object, message: str) -> None:
    with pytest.raises(fx.ModelError, match=message):
        make()  # type: ignore[operator]


def test_stress_needs_a_beam_with_a_section() -> None:
    state = leaf(EA=1.0).build().at_rest
    with pytest.raises(fx.ModelError, match="beam 'b' has no section"):
        state.stress("b")
    with pytest.raises(fx.ModelError, match="unknown beam with two frames 'c'; known: b"):
        state.stress("c")
    with pytest.raises(fx.ModelError, match="no beam has a section"):
        state.largest_stress()
