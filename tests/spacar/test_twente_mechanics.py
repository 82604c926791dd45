"""The mechanics of UT SPACAR in files of its dialect: inertia, rigid beams, degrees of freedom, modes 0 and 9."""

import re
from pathlib import Path

import numpy as np
import pytest
from spacar_declarations import declared
from spacar_lines import file

import flexel as fx
from flexel.apps.spacar.run_file import run_spacar
from flexel.base.arrays import Array

NODES = ["BEAM 1 1 2 3 4 0 1 0", "X 3 0.6 0 0.8", "FIX 1", "FIX 2"]
HALT = ["END", "HALT"]
J = (3e-3, 1e-3, 2e-3, 5e-4)  # Jxx Jyy Jzz Jyz per length; the beam is one metre long
AXES = np.array([[0.6, 0.0, -0.8], [0.0, 1.0, 0.0], [0.8, 0.0, 0.6]])  # of the section: columns x, y, z


def inertia(found: fx.Spacar, name: str) -> Array:
    xx, yy, zz, xy, xz, yz = found.model.instances[name].p
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def test_rotary_inertia_of_em_is_lumped_at_the_nodes(tmp_path: Path) -> None:
    """Half of the length's at each, in the axes of the section; the mass is not."""
    lines = [*NODES, "DYNE 1", *HALT, "ESTIFF 1 1e6 10 20 30", f"EM 1 1.5 {' '.join(map(str, J))}"]
    found = file(tmp_path, *lines)
    own = np.array([[J[0], 0, 0], [0, J[1], J[3]], [0, J[3], J[2]]]) / 2
    for end in "pq":
        assert np.allclose(inertia(found, f"beam1_{end}"), AXES @ own @ AXES.T, rtol=1e-12, atol=1e-18)
    assert any("Jyz is read as a component of the tensor" in note for note in found.notes)
    # a turn about the axis at the free end: only the lumped one; consistent would be a third of the whole
    assert found.matrices().M0[1, 1] == pytest.approx(J[0] / 2, rel=1e-9)
    # the mass along the axis is consistent, 13/35 of it at the free end
    assert found.matrices().M0[0, 0] == pytest.approx(1.5 * 13 / 35, rel=1e-9)


PLANAR = ["PLBEAM 1 1 2 3 4", "X 3 2.0 0", "FIX 1", "FIX 2", "DYNE 1"]


def test_the_second_number_of_a_planar_beam_is_lumped_too(tmp_path: Path) -> None:
    """Turning the free end alone moves half of the inertia of the whole length."""
    lines = [*PLANAR, *HALT, "ESTIFF 1 1e6 10", "EM 1 0.001532 2.393e-5 # rhoA J"]
    found, plain = file(tmp_path, *lines).system, file(tmp_path, *lines[:-1], "EM 1 0.001532").system
    turned = {"o4.angle": 1.0, "p3.x": 0.0, "p3.y": 0.0}
    energies = [system.state_at(rates=turned).energy.kinetic for system in (found, plain)]
    assert energies[0] - energies[1] == pytest.approx(2.393e-5 * 2.0 / 2 / 2, rel=1e-9)


def test_further_inertias_of_planar_elements_are_refused(tmp_path: Path) -> None:
    with pytest.raises(fx.ModelError, match=r"line 9: EM: a planar beam takes rhoA and its rotary inertia"):
        file(tmp_path, *PLANAR, *HALT, "ESTIFF 1 1e6 10", "EM 1 0.0015 1e-5 1e-5")
    delft = [*PLANAR, "ESTIFF 1 1e6 10", "EMASS 1 0.0015 1e-5"]
    with pytest.raises(fx.ModelError, match=r"line 7: EMASS: it takes rhoA alone here"):
        file(tmp_path, *delft)


def test_rotary_inertia_of_the_delft_dialect_is_consistent(tmp_path: Path) -> None:
    found = file(tmp_path, *NODES, "DYNE 1", "ESTIFF 1 1e6 10 20 30", "EMASS 1 1.5 3e-3 1e-3 2e-3")
    assert not declared(found, "rotary_inertia")
    assert found.matrices().M0[1, 1] == pytest.approx(J[0] / 3, rel=1e-9)


@pytest.mark.parametrize("turned", [False, True])
def test_rigid_beams_have_no_fixed_end_moments(turned: bool, tmp_path: Path) -> None:
    """A rigid cantilever carries its weight as if half of it hung at the tip; a stiff one has the moments as well."""
    tilt = ["LAMBDA 2 0.8 0.6 0 0", "LAMBDA 4 0.8 0.6 0 0"] if turned else []
    rest = [*tilt, *HALT, "EM 1 3.0", "GRAVITY 0 1.0 -9.81"]
    rigid = file(tmp_path, *NODES, *rest)
    state = rigid.system.initial
    ours = [state.force(f"beam1.{mode}") for mode in ("bend1", "bend2", "bend3", "bend4")]
    theirs = [rigid.stress(state, 1, i) for i in range(3, 7)]
    gy, gz = AXES.T[1] @ [0, 1.0, -9.81], AXES.T[2] @ [0, 1.0, -9.81]
    pair = 3.0 / 12 * np.array([gz, gz, -gy, -gy])
    assert np.allclose(np.subtract(ours, theirs), pair, rtol=1e-12)
    # nothing acts on the free end but half the weight: only the moment at the clamp remains
    assert np.allclose(theirs, 3.0 / 2 * np.array([-gz, 0.0, gy, 0.0]), rtol=1e-12, atol=1e-14)
    stiff = file(tmp_path, *NODES, "DYNE 1", *rest, "ESTIFF 1 1e9 1e9 1e9 1e9")
    bent = stiff.system.equilibrium()
    assert np.allclose([stiff.stress(bent, 1, i) for i in range(3, 7)], ours, rtol=1e-6)


def test_planar_rigid_beams_have_none_either(tmp_path: Path) -> None:
    lines = ["PLBEAM 1 1 2 3 4", "X 3 0.6 0.8", "FIX 1", "FIX 2", *HALT, "EM 1 3.0", "GRAVITY 0 -9.81"]
    found = file(tmp_path, *lines)
    state = found.system.initial
    ours = [-state.force(f"plbeam1.{mode}") for mode in ("bend1", "bend2")]
    normal = -9.81 * 0.6  # of gravity to the beam
    assert np.allclose(np.subtract(ours, [found.stress(state, 1, i) for i in (2, 3)]), 3.0 / 12 * normal)


def test_degrees_of_freedom_are_in_spacars_order(tmp_path: Path) -> None:
    """By number and component, coordinates of nodes first; not in the order of the lines, as in the Delft dialect."""
    beams = ["BEAM 9 1 2 3 4 0 1 0", "BEAM 2 3 4 5 6 0 1 0", "X 3 1 0 0", "X 5 2 0 0", "FIX 1", "FIX 2"]
    roles = ["DYNE 9 4 3 2", "RLSE 9 1 5 6", "DYNX 5 2", "DYNE 2 6 5", "DYNX 3 2 1"]
    masses = ["EM 9 1 1 1 1", "EM 2 1 1 1 1", "ESTIFF 9 1e4 10 20 30", "ESTIFF 2 1e4 10 20 30"]
    found = file(tmp_path, *beams, *roles, *HALT, *masses)
    assert found.system.dynamic == (
        *("p3.x", "p3.y", "p5.y"),
        *("beam2.bend3", "beam2.bend4", "beam9.torsion", "beam9.bend1", "beam9.bend2"),
    )
    assert found.matrices().coordinates == found.system.dynamic
    delft = [*beams, *roles, *(line.replace("EM ", "EMASS ") for line in masses)]
    assert file(tmp_path, *delft).system.dynamic[:2] == ("p5.y", "p3.y")


COLUMN = ["BEAM 1 1 2 3 4 0 1 0", "X 3 1 0 0", "FIX 1", "FIX 2", "DYNE 1 3 4", *HALT, "EM 1 1.0"]
COLUMN += ["ESTIFF 1 0 0 1.0", "DELXF 3 -4.0 0 0", "ITERSTEP 10 4"]


def test_unstable_frequencies_are_shown_as_growth(tmp_path: Path) -> None:
    """A column beyond Euler's load (2.47): in the last of four steps its first motion grows."""
    file(tmp_path, *COLUMN, "END", "END")
    with pytest.warns(fx.UnstableWarning):
        report = run_spacar(tmp_path / "model.dat", tmp_path / "out").report
    with np.load(tmp_path / "out" / "model.npz") as kept:
        frequencies, M, K = kept["frequencies"], kept["M0"], kept["K0"] + kept["N0"] + kept["G0"]
    assert frequencies.shape == (5, 2)
    assert not frequencies[:3].imag.any() and frequencies[0, 0].real == pytest.approx(3.53, rel=1e-2)
    assert frequencies[4, 0].real == 0.0 and frequencies[4, 0].imag > 1.0
    assert np.allclose(frequencies[4] ** 2, np.sort(np.linalg.eigvals(np.linalg.solve(M[4], K[4])).real))
    shown = re.search(r"unstable: grows as exp\((\S+) t\)", report)
    assert shown is not None and float(shown[1]) == pytest.approx(frequencies[4, 0].imag)


def test_unstable_frequencies_of_an_equilibrium_are_shown_as_growth(tmp_path: Path) -> None:
    lines = ["PLBEAM 1 1 2 3 4", "X 3 0 0.5", "FIX 1", "DYNX 2 1", *HALT, "XM 3 2.0", "GRAVITY 0 -9.81"]
    file(tmp_path, *lines)
    with pytest.warns(fx.UnstableWarning):
        report = run_spacar(tmp_path / "model.dat", tmp_path, mode=7).report
    assert f"unstable: grows as exp({np.sqrt(9.81 / 0.5):.9e} t)" in report
    with np.load(tmp_path / "model.npz") as kept:
        assert kept["frequencies"][0] == pytest.approx(1j * np.sqrt(9.81 / 0.5))


def test_mode_9_without_timestep_is_about_the_equilibrium(tmp_path: Path) -> None:
    lines = ["PLBEAM 1 1 2 3 4", "X 3 0 -0.5", "FIX 1", "DYNX 2 1", "INPUTE 1 1", *HALT, "XM 3 2.0"]
    lines += [
        "GRAVITY 0 -9.81",
        "INPUTE 1 1 0 0.25",
        "XD 2 1 1.5",
        *HALT,
        "INPUTF 1 3 1",
        "OUTX 1 2 1",
    ]
    file(tmp_path, *lines, "END", "END")
    run_spacar(tmp_path / "model.dat", tmp_path, mode=9)
    with np.load(tmp_path / "model.npz") as kept:
        # the pendulum hangs still, with the length of the start: l q'' + g q = 0 with the states (q, q')
        assert np.allclose(kept["A"], [[0.0, 1.0], [-9.81 / 0.5, 0.0]], rtol=1e-12)
    with pytest.raises(fx.ModelError, match="mode 4|TIMESTEP"):
        run_spacar(tmp_path / "model.dat", mode=4)


def test_mode_0_counts_constraints_and_lists_the_degrees_of_freedom(tmp_path: Path) -> None:
    found = file(tmp_path, *NODES, "INPUTX 3 2", "DYNE 1 3 4 6", "RLSE 1 5", *HALT, "EM 1 1 1 1 1")
    report = run_spacar(tmp_path / "model.dat", tmp_path, mode=0).report
    assert "14 coordinates of 4 nodes" in report and "6 deformations of 1 elements" in report
    assert "7 coordinates are fixed, 1 motions given, 3 conditions rigid" in report
    rows = re.findall(r"^  (\d) +(\S \d \d) +(\S+)$", report, re.MULTILINE)
    assert rows == [
        ("1", "E 1 3", "beam1.bend1"),
        ("2", "E 1 4", "beam1.bend2"),
        ("3", "E 1 6", "beam1.bend4"),
    ]
    rows_of = found.system.initial.J[found.system.roles.position_rows][:, : found.system.structure.nf]
    with np.load(tmp_path / "model.npz") as kept:
        assert kept["condition"] == pytest.approx(np.linalg.cond(rows_of))


def test_mode_0_reports_what_is_too_much_or_missing(tmp_path: Path) -> None:
    file(tmp_path, *NODES, "FIX 3", *HALT, "EM 1 1")
    assert "over-constrained" in run_spacar(tmp_path / "model.dat", mode=0).report
    file(tmp_path, *NODES, "DYNE 1 1", "RLSE 1 2", *HALT, "EM 1 1 1 1 1")
    report = run_spacar(tmp_path / "model.dat", mode=0).report
    assert "nothing resists" in report and "under-constrained" in report


def test_a_mode_that_does_not_exist_is_refused(tmp_path: Path) -> None:
    file(tmp_path, *NODES, "DYNE 1", *HALT, "EM 1 1 1 1 1")
    with pytest.raises(fx.ModelError, match="mode 5 does not exist; modes are 0, 1, 2, 3, 4, 7, 8, 9, 10"):
        run_spacar(tmp_path / "model.dat", mode=5)
