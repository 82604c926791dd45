"""Without any optional package flexel computes, and shows motions in a browser; the rest names what installs it."""

import subprocess
import sys
from pathlib import Path

PROGRAM = """
import sys

OPTIONAL = {"matplotlib", "PIL", "xarray", "pandas", "h5netcdf", "h5py", "control", "joblib", "cloudpickle",
            "distributed", "gymnasium"}


class Without:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in OPTIONAL:
            raise ModuleNotFoundError(f"No module named '{name}'", name=name)


sys.meta_path.insert(0, Without())
import flexel as fx
from flexel.apps.view.element_modes import plot_element
from flexel.apps.view.scene import draw
from mechanisms import cantilever, pendulum

s = pendulum()
motion, lin, loci = s.simulate(0.5, progress=False), s.linearize(), s.root_loci(rates={"pivot.angle": [0.0, 1.0]})
many = s.simulate_many(0.1, initial={"pivot.angle": [0.0, 0.1]}, outputs=["A.x"], samples=3, progress=False)
leaf = cantilever()
rest = leaf.equilibrium()
motion.view("swing.html", progress=False)
motion.save("swing.npz"), motion.save("swing.csv"), motion.save("swing.mat")
lin.view("modes.html"), print(lin.modes())
wanted = {
    "plot": (lambda: motion.plot(), "plot"),
    "plot_phase": (lambda: motion.plot_phase("A.x"), "plot"),
    "spectrum_plot": (lambda: motion.spectrum_plot("A.x"), "plot"),
    "plot_shapes": (lambda: motion.plot_shapes(0.1), "plot"),
    "animate": (lambda: motion.animate("swing.gif"), "plot"),
    "plot_mode": (lambda: lin.plot_mode(0), "plot"),
    "bode": (lambda: lin.bode("pivot.angle", "A.x"), "plot"),
    "loci": (lambda: loci.plot(), "plot"),
    "draw": (lambda: draw(motion[0]), "plot"),
    "plot_element": (lambda: plot_element(rest, "leaf"), "plot"),
    "to_xarray": (lambda: motion.to_xarray(), "xarray"),
    "to_pandas": (lambda: motion.to_pandas(), "xarray"),
    "save .nc": (lambda: motion.save("swing.nc"), "xarray"),
    "load .nc": (lambda: fx.load(given), "xarray"),
    "lin.to_xarray": (lambda: lin.to_xarray(), "xarray"),
    "lin.to_pandas": (lambda: lin.to_pandas(), "xarray"),
    "many.to_xarray": (lambda: many.to_xarray(), "xarray"),
    "to_control": (lambda: lin.to_control("pivot.angle"), "control"),
    "sweep": (lambda: fx.sweep(pendulum, {}, len), "sweep|xarray"),
}
given = sys.argv[1]
for name, (use, extra) in wanted.items():
    try:
        use()
    except fx.FlexelError as error:
        assert any(f"flexel[{one}]" in str(error) for one in extra.split("|")), f"{name}: {error}"
    else:
        raise AssertionError(f"{name} needs no optional package")
"""


def test_a_missing_package_is_named_with_what_installs_it(tmp_path: Path, checkout: Path) -> None:
    saved = tmp_path / "given.nc"
    saved.write_bytes(b"\x89HDF\r\n\x1a\n")
    environment = {"PYTHONPATH": str(checkout / "tests"), "HOME": str(tmp_path), "PATH": ""}
    command = [sys.executable, "-c", PROGRAM, str(saved)]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    assert (tmp_path / "swing.html").stat().st_size > 100_000
