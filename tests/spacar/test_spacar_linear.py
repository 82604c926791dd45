"""Linear analyses of files: signs of the file, closed forms, and the split of the matrices."""

from pathlib import Path

import numpy as np
import pytest

import flexel as fx
from flexel.apps.spacar.run_file import run_spacar

DATA = Path(__file__).parent.parent / "data"


@pytest.fixture(scope="module")
def cantilever() -> fx.Spacar:
    return fx.read_spacar(DATA / "spacar_cantilever.dat")


def test_cantilever_buckles_at_eulers_load(cantilever: fx.Spacar) -> None:
    first, second = (load.multiplier for load in cantilever.buckling(2))
    # four cubic elements: 5e-5 above pi²/4 EI, 2e-3 in the second mode; the file's load is a compression
    assert 0 < first / (np.pi**2 / 4) - 1 < 1e-4
    assert 0 < second / (9 * np.pi**2 / 4) - 1 < 1e-2


def test_small_compression_lowers_the_frequencies(cantilever: fx.Spacar) -> None:
    loaded = cantilever.frequencies(count=1)[0].omega
    free = cantilever.variant(loads=False)
    unloaded = free.vibrations(free.equilibrium(), count=1)[0].omega
    # (1.8751)² sqrt(EI / (rho A L^4)), of which rotary inertia takes a part: at the tip with slope 1.377 w(1),
    # mass w(1)²/4 in the mode, 1e-3 * 1.377² * 4 / 2, and 1e-4 along the beam
    assert abs(unloaded / 3.51602 - 1 + 1e-3 * 1.377**2 * 2) < 4e-4
    assert abs((loaded / unloaded) ** 2 - (1 - 1 / (np.pi**2 / 4))) < 0.02  # nearly linear in the load


def test_load_steps_bend_the_cantilever(cantilever: fx.Spacar) -> None:
    system, states = cantilever.static_steps()
    assert [state.t for state in states] == [0.0, 0.25, 0.5, 0.75, 1.0]
    # beam-column: w = F/(P k) (tan k - k), k = sqrt(P/EI), P = 1, F = t/2; small enough to be nearly linear
    assert abs(states[1]["p9.z"] / (0.125 * (np.tan(1.0) - 1.0)) - 1) < 0.02
    found = cantilever.matrices(states[0], system=system)
    assert found.K0.shape == (24, 24) and np.allclose(found.K0, found.K0.T)
    assert abs(found.K0[0, 0] - 1e4 / 0.25) < 1e-8  # EA / l of the first elongation
    assert abs(found.K0[2, 3] + 2 / 0.25**3) < 1e-9  # bending: EI / l³ [[4, -2], [-2, 4]]
    assert np.max(np.abs(found.N0)) < 1e-8 * np.max(np.abs(found.G0))


@pytest.mark.parametrize("motion", ["INPUTX 2 1 0.1 1.0 2.0", "INPUTX 2 1 0.1\nXD 2 1 1.0"])
@pytest.mark.parametrize(("change", "end"), [("", 0.1), ("DELINPX 2 1 0.5", 0.6)])
def test_load_steps_are_static(motion: str, change: str, end: float, tmp_path: Path) -> None:
    """The load parameter is not time: inputs without an increment keep their initial value, velocity or not."""
    path = tmp_path / "steps.dat"
    path.write_text(
        "PLBEAM 1 1 2 3 4\nX 3 1 0\nFIX 1\nDYNE 1 2 3\nINPUTX 2 1\nEND\nHALT\nEM 1 1.0\nESTIFF 1 1e4 100\n"
        "DELXF 3 0 0.1\nITERSTEP 10 2\n"
        f"TIME 3.0\n{motion}\n{change}\n"
    )
    system, states = fx.read_spacar(path).static_steps()
    assert states[0]["o2.angle"] == 0.1
    assert abs(states[-1]["o2.angle"] - end) < 1e-14
    tip = states[-1]["p3.y"] * np.cos(end) - states[-1]["p3.x"] * np.sin(end)
    assert abs(tip / (0.1 * np.cos(end) / (3 * 100)) - 1) < 1e-3  # the force along it stiffens it by 2e-4
    assert not np.any(fx.read_spacar(path).matrices(states[-1], system=system).N0)


def test_damping_of_the_file_is_its_damping_matrix(cantilever: fx.Spacar) -> None:
    D0 = cantilever.matrices().D0
    assert abs(D0[0, 0] - 1e2 / 0.25) < 1e-9
    assert abs(D0[4, 5] + 2 * 1e-1 / 0.25**3) < 1e-9
    assert not np.any(D0[6:, 6:])  # the first element alone is damped


def test_state_space_has_the_inputs_and_outputs_of_the_file(cantilever: fx.Spacar) -> None:
    state = cantilever.system.equilibrium()
    A, B, C, D = cantilever.state_space(state)
    assert A.shape == (48, 48) and B.shape == (48, 3) and C.shape == (4, 48) and not np.any(D)
    static = -C @ np.linalg.solve(A, B)
    # a force up lifts, a moment about y turns the tip down, both as a beam-column under P = 1, EI = 1
    k = 1.0
    assert abs(static[0, 0] / (np.tan(k) - k) - 1) < 1e-3
    assert abs(static[0, 1] / -(1 / np.cos(k) - 1) - 1) < 1e-3
    assert np.max(np.abs(static[[1, 3]])) < 1e-9  # outputs that are rates
    assert static[2, 2] < 0  # a stress as input acts against its deformation


def test_signs_of_a_planar_beam_are_those_of_the_file(tmp_path: Path) -> None:
    """SPACAR's planar beam bends with the opposite sign: a stress and its deformation keep their work."""
    path = tmp_path / "plane.dat"
    path.write_text(
        "PLBEAM 1 1 2 3 4\nX 3 2 0\nFIX 1\nFIX 2\nDYNE 1 2\nDYNE 1 3\nEM 1 3.0\nESTIFF 1 0 5.0\n"
        "XF 3 0 1e-3\nINPUTS 1 1 2\nOUTE 1 1 2\nEND END\n"
    )
    file = fx.read_spacar(path)
    assert file.dialect == "twente"
    state = file.system.equilibrium()
    tip, e2, e3 = state["p3.y"], file.deformation(state, 1, 2), file.deformation(state, 1, 3)
    phi = state["o4.angle"]
    length = np.hypot(state["p3.x"], tip)
    # e2 = dx sin(phi_p) - dy cos(phi_p), e3 = -dx sin(phi_q) + dy cos(phi_q), as in the manual
    assert abs(e2 + tip) < 1e-12 and tip > 0
    assert abs(e3 - (-state["p3.x"] * np.sin(phi) + tip * np.cos(phi))) < 1e-12
    assert abs(length - 2.0) < 1e-12
    stress = np.array([[4, -2], [-2, 4]]) * 5.0 / 2**3 @ [e2, e3]
    assert np.allclose([file.stress(state, 1, 2), file.stress(state, 1, 3)], stress, rtol=1e-10)
    A, B, C, _ = file.state_space(file.system.initial)
    flexibility = np.linalg.inv(np.array([[4, -2], [-2, 4]]) * 5.0 / 2**3)[0, 0]
    assert abs(-(C @ np.linalg.solve(A, B))[0, 0] / -flexibility - 1) < 1e-3


def test_lateral_buckling_of_a_cantilever_converges_as_with_all_terms(tmp_path: Path) -> None:
    """EIy = GJ = 1, EIz large: 4.0126 exactly; without second-order terms (Delft's BEAM) much slower."""
    errors = {}
    for dialect, head in (("twente", "XF"), ("delft", "FORCE")):
        lines = [f"BEAM {i} {2 * i - 1} {2 * i} {2 * i + 1} {2 * i + 2} 0 1 0" for i in range(1, 5)]
        lines += [f"X {2 * i + 1} {i / 4} 0 0" for i in range(1, 5)]
        lines += [f"RLSE {i} 1 2 3 4 5 6" for i in range(1, 5)]
        lines += [f"ESTIFF {i} 1e7 1 1 1e4" for i in range(1, 5)]
        path = tmp_path / f"{dialect}.dat"
        # EIz bends in the plane of the section's y axis, in which the load acts
        path.write_text("\n".join([*lines, "FIX 1", "FIX 2", f"{head} 9 0 1 0"]))
        errors[dialect] = abs(fx.read_spacar(path, dialect).buckling(1)[0].multiplier) / 4.0126 - 1
    assert abs(errors["twente"] - 0.0155) < 2e-4
    assert abs(errors["delft"] - 0.046) < 5e-4


def test_state_space_along_a_motion_is_written(tmp_path: Path) -> None:
    path = tmp_path / "pendulum.dat"
    path.write_text(
        "PLBEAM 1 1 2 3 4\nX 3 0 -0.5\nFIX 1\nDYNX 2 1\nXD 2 1 1.0\nXM 3 2.0\nGRAVITY 0 -9.81\n"
        "INPUTF 1 3 1\nOUTX 1 2 1\nTIMESTEP 1.0 10\nEND END\n"
    )
    report = run_spacar(path, tmp_path, mode=9).report
    assert "pendulum.npz" in report
    with np.load(tmp_path / "pendulum.npz") as kept:
        A, angle = kept["A"], kept["x_2_1"]
    assert A.shape == (11, 2, 2)
    assert np.allclose(A[:, 1, 0], -9.81 / 0.5 * np.cos(angle), rtol=1e-9)  # of (q, q')
    assert np.array_equal(A[:, 0], np.tile([0.0, 1.0], (11, 1)))
    run_spacar(path, tmp_path, mode=4)
    with np.load(tmp_path / "pendulum.npz") as kept:
        assert np.allclose(kept["M0"][:, 0, 0], 2.0 * 0.25)
        total = kept["K0"] + kept["N0"] + kept["G0"]
        assert np.allclose(total[:, 0, 0], 2 * 9.81 * 0.5 * np.cos(angle), rtol=1e-9)
