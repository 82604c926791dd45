"""BEAMW of files: the same model by hand, Vlasov's closed form, roles and inputs of warping nodes."""

from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from programs import printed as printed_by
from spacar_declarations import declared
from spacar_lines import file

import flexel as fx
from flexel.apps.cli.main import main
from flexel.parts.roles import Prescribe

HALT = ["END", "HALT"]
EA, GJ, EIY, EIZ, EIW = 2.1e6, 9.3e-3, 7e-3, 437.5, 2.3e-6
RHO_A, JXX, JW = 0.078, 1.6e-5, 3e-10
NODES = ["BEAMW 1 1 2 3 4 5 6 0 0 1", "X 4 0 0.1 0", "FIX 1", "FIX 2"]
LAWS = [f"ESTIFF 1 {EA} {GJ} {EIY} {EIZ} 0 0 {EIW}", f"EM 1 {RHO_A} {JXX} 0 0 0 {JW}"]


MODES = ("elongation", "torsion", "bend1", "bend2", "bend3", "bend4", "warp1", "warp2")


def by_hand(vlasov: bool, *rigid: str) -> fx.Model:
    """The clamped beam of NODES and LAWS, with a torque; the free end may warp."""
    m = fx.Model()
    p, q = m.point("p1", (0, 0, 0), fixed=True), m.point("p4", (0, 0.1, 0))
    frames = m.frame("o2", fixed=True), m.frame("o5")
    warps = m.warping("w3", fixed=True), m.warping("w6")
    stiffness = {"EA": EA, "GJ": GJ, "EIy": EIY, "EIz": EIZ, "EIw": EIW}
    mass = {"mass_per_length": RHO_A, "warping_inertia_per_length": JW if vlasov else 0.0}
    options = stiffness | mass | {"twist_shortens": vlasov}
    m.beam("leaf", p, frames[0], q, frames[1], direction=(0, 0, 1), warping=warps, **options)
    if not vlasov:
        m.rotary_inertia("warping", "w6", JW * 0.1 / 2)  # lumped
    m.rotary_inertia("end", "o5", (0.0, JXX * 0.1 / 2, 0.0, 0.0, 0.0, 0.0))  # lumped, about the beam's axis
    m.load("o5", (0.0, 1e-3, 0.0))
    for name in rigid:  # a mode with a law
        m.prescribe(name, 0.0)
    m.independent(*(f"leaf.{mode}" for mode in MODES if mode != "warp1" and f"leaf.{mode}" not in rigid))
    return m


def spacars(state: fx.State, i: int) -> tuple[float, float]:
    """Deformation and stress i of the model by hand as SPACAR defines them: e7 = l0² w, e8 likewise."""
    value, stress = state[f"leaf.{MODES[i - 1]}"], state.force(f"leaf.{MODES[i - 1]}")
    if i == 2:
        return value, stress - state.force("leaf.warp1") - state.force("leaf.warp2")
    return (0.1**2 * state["w3.twist" if i == 7 else "w6.twist"] if i > 6 else value), stress


@pytest.mark.parametrize("vlasov", [False, True])
@pytest.mark.parametrize("rigid", [(), (5,)])
def test_a_file_is_the_model_by_hand(rigid: tuple[int, ...], vlasov: bool, tmp_path: Path) -> None:
    """With all modes flexible, and with a rigid one that leaves no whole group of stiffnesses."""
    chosen = " ".join(str(i) for i in (1, 2, 3, 4, 5, 6, 8) if i not in rigid)
    file(tmp_path, *NODES, "FIX 3", "RLSE 1 7", f"DYNE 1 {chosen}", *HALT, *LAWS, "XF 5 0 1e-3 0")
    found = fx.read_spacar(tmp_path / "model.dat", warping="vlasov" if vlasov else "spacar")
    assert bool(declared(found, "element")) == bool(rigid)
    system = by_hand(vlasov, *(f"leaf.{MODES[i - 1]}" for i in rigid)).build()
    ours, theirs = found.system.equilibrium(), system.equilibrium()
    assert abs(theirs["leaf.warp1"]) > 1e-6
    for i in range(1, 9):
        value, stress = spacars(theirs, i)
        assert found.deformation(ours, 1, i) == pytest.approx(value, rel=1e-9, abs=1e-15)
        assert found.stress(ours, 1, i) == pytest.approx(stress, rel=1e-9, abs=1e-10)
    mine, hand = found.frequencies(ours), system.vibrations(theirs, count=10)
    assert np.allclose([mode.omega for mode in mine], [mode.omega for mode in hand], rtol=1e-9)
    assert any(
        ("flexel's own beam: Jw" if vlasov else "as in SPACAR (warping=") in note for note in found.notes
    )


def test_the_numbers_of_a_warping_node_are_spacars(tmp_path: Path) -> None:
    """M0 of e8 = l0² w is the lumped Jw l0/2 over l0⁴, of the coordinate itself Jw l0/2; tension has no G0 of twist."""
    lines, rest = [*NODES, "FIX 3", "RLSE 1 7"], [*HALT, *LAWS, "XF 4 0 100 0"]
    half, l0 = JW * 0.1 / 2, 0.1
    by_mode = file(tmp_path, *lines, "DYNE 1 1 2 3 4 5 6 8", *rest)
    ours = by_mode.matrices(by_mode.system.equilibrium())
    assert ours.M0[6, 6] == pytest.approx(half / l0**4, rel=1e-12)
    assert np.abs(ours.M0[6, :6]).max() < 1e-12 * ours.M0[6, 6]
    own = fx.read_spacar(tmp_path / "model.dat", warping="vlasov")
    G0 = own.matrices(own.system.equilibrium()).G0
    radius = (EIY + EIZ) / EA  # Wagner's term: tension times the square of the polar radius of gyration
    assert G0[1, 1] - ours.G0[1, 1] == pytest.approx(100 * radius / l0**3 * 1.2, rel=1e-4)
    assert abs(ours.G0[6, 6]) < 1e-9 * abs(G0[6, 6])
    by_node = file(tmp_path, *NODES, "FIX 3", "RLSE 1 7 8", "DYNX 6", "DYNE 1 1 2 3 4 5 6", *rest)
    found = by_node.matrices(by_node.system.equilibrium()).M0
    assert found[0, 0] == pytest.approx(half, rel=1e-12)
    held = file(tmp_path, *lines, "DYNE 1 1 2 3 4 5 6", *rest)  # mode 8 is rigid
    assert "w6.twist" not in held.system.dynamic and held.system.equilibrium()["w6.twist"] == 0


def test_another_kind_of_warping_is_refused(tmp_path: Path) -> None:
    file(tmp_path, *NODES, "FIX 3", "RLSE 1", *HALT, *LAWS)
    with pytest.raises(fx.ModelError, match="warping 'wagner' is unknown; give 'spacar' or 'vlasov'"):
        fx.read_spacar(tmp_path / "model.dat", warping="wagner")
    with pytest.raises(fx.ModelError, match="mode 2 of a BEAMW as an input"):
        file(tmp_path, *NODES, "FIX 3", "RLSE 1", *HALT, *LAWS, *HALT, "INPUTS 1 1 2")


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
        assert 0.05**2 * float(printed["w6.twist"]) == pytest.approx(float(kept["e_1_8"][-1]), rel=1e-9)


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
    assert any("the last numbers are ignored" in note for note in found.notes)


def as_light(elements: int, *rest: str) -> list[str]:
    """The same leaf in the form of SPACAR Light: modes 1 to 6 are named alone; at its end a rigid beam."""
    lines = [line for line in leaf(elements) if not line.startswith(("DYNE", "RLSE", "FIX"))]
    a, b = 3 * elements + 1, 3 * elements + 4
    end = lines.index("END")
    rigid = f"BEAMW {elements + 1} {a} {a + 1} {a + 2} {b} {b + 1} {b + 2} 0 0 1"
    flexible = [f"DYNE {e} 1 2 3 4 5 6" for e in range(1, elements + 1)]
    more = [rigid, f"X {b} 0 0.12 0", *flexible, "FIX 1", "FIX 2", "FIX 3  #warping"]
    return [*lines[:end], *more, *lines[end:], *rest]


def test_modes_of_warping_that_no_line_names_are_no_conditions(tmp_path: Path) -> None:
    """As in files of SPACAR Light, whose releases are as many as without warping; a rigid end stays plane."""
    found = file(tmp_path, *as_light(4))
    named = file(tmp_path, *leaf(4))
    turn = [model.system.equilibrium()["o14.lambda2"] for model in (found, named)]
    assert turn[0] == pytest.approx(turn[1], rel=1e-9) and abs(turn[0]) > 1e-4
    assert found.system.dynamic[:3] == ("w6.twist", "w9.twist", "w12.twist")
    assert len(found.system.dynamic) == 3 + 4 * 6
    notes = [note for note in found.notes if "modes 7 and 8 are not named" in note]
    assert len(notes) == 2 and "BEAMW 1 to 4" in notes[0] and "BEAMW 5: " in notes[1]
    assert not any("are not named" in note for note in named.notes)
    w = [[mode.omega for mode in model.frequencies(count=3)] for model in (found, named)]
    assert w[0] == pytest.approx(w[1], rel=1e-6)


def test_nodes_of_warping_that_are_named_keep_their_roles(tmp_path: Path) -> None:
    lines = as_light(2)
    end = lines.index("END")
    found = file(tmp_path, *lines[:end], "INPUTX 6", *lines[end:])
    prescribed = [part for part in found.model.parts if isinstance(part, Prescribe)]
    assert [(part.name, part.motion) for part in prescribed] == [("w6.twist", 0.0)]
    assert not any("w6" in name or "w9" in name for name in found.system.dynamic)
