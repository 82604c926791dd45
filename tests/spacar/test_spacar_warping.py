"""BEAMW of files: the same model by hand, Vlasov's closed form, roles and inputs of warping nodes."""

from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from programs import printed as printed_by
from spacar_lines import file

import flexel as fx
from flexel.commands.main import main

HALT = ["END", "HALT"]
EA, GJ, EIY, EIZ, EIW = 2.1e6, 9.3e-3, 7e-3, 437.5, 2.3e-6
RHO_A, JXX, JW = 0.078, 1.6e-5, 3e-10
NODES = ["BEAMW 1 1 2 3 4 5 6 0 0 1", "X 4 0 0.1 0", "FIX 1", "FIX 2"]
LAWS = [f"ESTIFF 1 {EA} {GJ} {EIY} {EIZ} 0 0 {EIW}", f"EM 1 {RHO_A} {JXX} 0 0 0 {JW}"]


MODES = ("elongation", "torsion", "bend1", "bend2", "bend3", "bend4", "warp1", "warp2")


def by_hand(*rigid: str) -> fx.Model:
    """The clamped beam of NODES and LAWS, with a torque; the free end may warp."""
    m = fx.Model()
    p, q = m.point("p1", (0, 0, 0), fixed=True), m.point("p4", (0, 0.1, 0))
    frames = m.frame("o2", fixed=True), m.frame("o5")
    warps = m.warping("w3", fixed=True), m.warping("w6")
    stiffness = {"EA": EA, "GJ": GJ, "EIy": EIY, "EIz": EIZ, "EIw": EIW}
    mass = {"mass_per_length": RHO_A, "warping_inertia_per_length": JW}
    m.beam("leaf", p, frames[0], q, frames[1], direction=(0, 0, 1), warping=warps, **stiffness, **mass)
    m.rotary_inertia("end", "o5", (0.0, JXX * 0.1 / 2, 0.0, 0.0, 0.0, 0.0))  # lumped, about the beam's axis
    m.load("o5", (0.0, 1e-3, 0.0))
    for name in rigid:  # a mode with a law
        m.prescribe(name, 0.0)
    m.independent(*(f"leaf.{z}" for z in MODES if z != "warp1" and f"leaf.{z}" not in rigid))
    return m


@pytest.mark.parametrize("rigid", [(), (5,)])
def test_a_file_is_the_model_by_hand(rigid: tuple[int, ...], tmp_path: Path) -> None:
    """With all modes flexible, and with a rigid one that leaves no whole group of stiffnesses."""
    chosen = " ".join(str(i) for i in (1, 2, 3, 4, 5, 6, 8) if i not in rigid)
    found = file(tmp_path, *NODES, "FIX 3", "RLSE 1 7", f"DYNE 1 {chosen}", *HALT, *LAWS, "XF 5 0 1e-3 0")
    assert any(z.method == "element" for z in found.calls) == bool(rigid)
    system = by_hand(*(f"leaf.{MODES[i - 1]}" for i in rigid)).build()
    ours, theirs = found.system.equilibrium(), system.equilibrium()
    assert abs(theirs["leaf.warp1"]) > 1e-6
    for i, name in enumerate(MODES, 1):
        assert found.deformation(ours, 1, i) == pytest.approx(theirs[f"leaf.{name}"], rel=1e-9, abs=1e-15)
        assert found.stress(ours, 1, i) == pytest.approx(theirs.force(f"leaf.{name}"), rel=1e-9, abs=1e-10)
    mine, hand = found.frequencies(ours), system.vibrations(theirs, count=10)
    assert np.allclose([z.omega for z in mine], [z.omega for z in hand], rtol=1e-9)
    assert any("no description says what signs" in z for z in found.notes)


def leaf(elements: int, *rest: str) -> list[str]:
    """A leaf clamped at both ends, of elements with three nodes each, twisted at the second end."""
    lines, last = [], 3 * elements + 1
    for e in range(1, elements + 1):
        a, b = 3 * e - 2, 3 * e + 1
        lines += [
            f"BEAMW {e} {a} {a + 1} {a + 2} {b} {b + 1} {b + 2} 0 0 1",
            f"X {b} 0 {0.1 * e / elements} 0",
        ]
        free = "1 2 3 4 5 6" + (" 8" if e < elements else "")
        lines += [f"DYNE {e} {free}", f"RLSE {e} 7 8"]
    lines += ["FIX 1", "FIX 2", "FIX 3", f"FIX {last + 2}", *HALT]
    for e in range(1, elements + 1):
        lines += [f"ESTIFF {e} {EA} {GJ} {EIY} {EIZ} 0 0 {EIW}", f"EM {e} {RHO_A} {JXX} 0 0 0 {JW}"]
    return [*lines, f"XF {last + 1} 0 1e-4 0", *rest]


def test_a_clamped_leaf_is_as_stiff_as_vlasov_says(tmp_path: Path) -> None:
    found = file(tmp_path, *leaf(8))
    state = found.system.equilibrium()
    angle = 2 * np.arctan2(state["o26.lambda2"], state["o26.lambda0"])  # about y, the leaf's axis
    half = 0.1 * np.sqrt(GJ / EIW) / 2
    assert half > 2.0  # so that the clamps matter, by a factor
    assert 1e-4 * 0.1 / angle == pytest.approx(GJ / (1 - np.tanh(half) / half), rel=3.5e-4)


def test_run_and_the_converted_program_give_the_same(tmp_path: Path) -> None:
    file(tmp_path, *leaf(2), "END", "END")
    dat, target = tmp_path / "model.dat", tmp_path / "model.py"
    ran = CliRunner().invoke(main, ["run", str(dat), "--out", str(tmp_path)])
    assert ran.exit_code == 0, ran.output
    assert CliRunner().invoke(main, ["convert", str(dat), str(target)]).exit_code == 0
    assert "warping=(" in target.read_text()
    printed = dict(line.split() for line in printed_by(target).splitlines())
    with np.load(tmp_path / "model.npz") as kept:
        assert abs(kept["x_6_1"][-1]) > 1e-6
        assert float(printed["w6.twist"]) == pytest.approx(float(kept["x_6_1"][-1]), rel=1e-9)
        assert float(printed["beamw1.warp1"]) == pytest.approx(float(kept["e_1_7"][-1]), rel=1e-9)


def test_roles_loads_and_outputs_of_warping_nodes(tmp_path: Path) -> None:
    held = file(
        tmp_path, *NODES, "FIX 3", "RLSE 1", "INPUTX 6", "DYNE 1 1 2 3 4 5 6", *HALT, *LAWS, "INPUTX 6 1 0.5"
    )
    assert held.system.equilibrium()["w6.twist"] == pytest.approx(0.5)
    rest = ["XF 6 2e-6", *HALT, "INPUTF 1 6 1", "OUTX 1 6 1", "OUTE 2 1 8"]
    free = file(tmp_path, *NODES, "FIX 3", "RLSE 1", "DYNX 6", "DYNE 1 1 2 3 4 5 6", *HALT, *LAWS, *rest)
    assert free.system.dynamic[0] == "w6.twist"
    state = free.system.equilibrium()
    A, B, C, D = free.state_space(state)
    still = D - C @ np.linalg.solve(A, B)  # twist and warp2 per bimoment
    assert still[:, 0] * 2e-6 == pytest.approx([state["w6.twist"], free.deformation(state, 1, 8)], rel=1e-6)


def test_what_a_warping_node_cannot_have_is_refused_or_noted(tmp_path: Path) -> None:
    for line, what in (
        ("XM 6 1.0", "has no mass"),
        ("X 6 0.1", "drawn without twist"),
        ("XF 6 1 2", "takes 1"),
        ("ESTIFF 1 1 1 1 1 0 0 -1", "negative"),
    ):
        with pytest.raises(fx.ModelError, match=what):
            file(tmp_path, *NODES, "FIX 3", "RLSE 1", *HALT, line)
    found = file(
        tmp_path, *NODES, "FIX 3", "RLSE 1 7", "DYNE 1 1 2 3 4 5 6 8", *HALT, f"{LAWS[0]} 4.0", LAWS[1]
    )
    assert any("the last numbers are left out" in z for z in found.notes)
