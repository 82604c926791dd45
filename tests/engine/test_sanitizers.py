"""The engine in C without Python, under sanitizers: eight threads on the tables of one model, each in its workspace."""

import os
import shutil
import subprocess
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from threading import Barrier

import numpy as np
import pytest
from image import Image
from wheels import MAGIC, MAGIC_ON, H, K, wheel

import flexel as fx
from flexel.base.arrays import Array
from flexel.engine.covered import Covered
from flexel.engine.structs import Struct
from flexel.examples.bicycle import bicycle, kick
from flexel.generated._kernels import ffi, lib
from flexel.integration.dop853_steps import Steps
from flexel.integration.knots import Knots
from flexel.integration.radau_steps import Collocation
from flexel.model.snapshot import Snapshot

ROOT = Path(__file__).parents[2]
ENGINE, GENERATED = ROOT / "runtime" / "engine", ROOT / "generated"
DRIVER = Path(__file__).parent / "threads" / "driver.c"
STEP, SHORT, STEPS = 1e-3, 1e-5, 20  # as in the driver
THREADS = 8
KINDS = "thread", "address"
# the first race ends a program: threads that spoil each other's arrays may never end
CLEAN = os.environ | {
    "LD_PRELOAD": "",
    "TSAN_OPTIONS": "halt_on_error=1",
    "ASAN_OPTIONS": "",
    "UBSAN_OPTIONS": "",
}
FLAGS = [
    "-std=c11",
    "-O1",
    "-g1",
    "-ffp-contract=off",
    "-fopenmp-simd",
    "-D_GNU_SOURCE",
    "-DFLEXEL_NO_CLONES",
]
FLAGS += [f"-I{ENGINE}", f"-I{GENERATED}", "-Wall", "-Wextra", "-Werror"]

CAMPAIGN = pytest.mark.campaign  # compiles the engine twice; `make sanitize` runs it


def rolling() -> tuple[fx.System, fx.State]:
    """The bicycle after a kick: rolling conditions, eliminated by small dense matrices."""
    system = bicycle()
    return system, kick(system, 4.5, 0.05)[0]


def hanging() -> tuple[fx.System, fx.State]:
    """A rope of twelve cables, whose accelerations come from one sparse matrix."""
    m = fx.Model(gravity=(0, 0, -9.81))
    for i in range(13):
        m.point(f"P{i}", (0.5 * i, 0, 0), fixed=i == 0)
        m.slope(f"S{i}", (1, 0, 0))
    for i in range(12):
        ends = f"P{i}", f"S{i}", f"P{i + 1}", f"S{i + 1}"
        m.cable(f"c{i}", *ends, EA=500.0, EI=2.0, mass_per_length=0.5, damping=0.01, bending_damping=0.01)
    system = m.build()
    return system, system.initial


def slipping() -> tuple[fx.System, fx.State]:
    """A wheel whose tyre has internal states."""
    m = wheel(z=H)
    m.attach("magic_formula", MAGIC_ON, name="rubber", stiffness=K, damping=0.0, **MAGIC)
    for name, rate in (("hub.x", 10.0), ("hub.y", 0.5)):
        m.initial(name, rate=rate)
    system = m.build()
    return system, system.initial


def turning() -> tuple[fx.System, fx.State]:
    """A free body, and a rotor in springs: three Euler parameters and a single one are degrees of freedom."""
    m = fx.Model()
    m.body("free", m.point("F", (5, 0, 0)), m.frame("FR"), mass=1.0, inertia=(1.0, 2.0, 3.0))
    m.body("rotor", m.point("P", (0, 0, 0)), m.frame("R"), mass=1.0, inertia=(0.2, 0.2, 0.1))
    for end, z in (("A", -0.3), ("B", 0.3)):
        m.body_point(f"{end} of rotor", "P", "R", m.point(end, (0, 0, z)))
        for side, place in (("x", (1, 0, z)), ("y", (0, 1, z)), ("z", (0, 0, z - 1)))[
            : 3 if end == "A" else 2
        ]:
            m.truss(f"{end}{side} spring", m.point(f"{end}{side}", place, fixed=True), end, stiffness=1e4)
    for frame in ("FR", "R"):
        w = m.angular_velocity(frame)
        m.initial(f"{w}.wx", rate=0.0 if frame == "R" else 1.0)
        m.initial(f"{w}.wz", rate=5.0)
    springs = [f"{name} spring.elongation" for name in ("Ax", "Ay", "Az", "Bx", "By")]
    own = ("F.x", "F.y", "F.z", "FR.lambda1", "FR.lambda2", "FR.lambda3")
    m.independent(*own, *springs, "R.lambda3")
    system = m.build()
    return system, system.initial


MODELS = {model.__name__: model for model in (rolling, hanging, slipping, turning)}


Methods = tuple[Steps, Collocation]


def prepared(system: fx.System, start: fx.State) -> list[Methods]:
    """Steps of both methods for as many threads, each in its own workspace."""
    y, begin = np.concatenate([start.q, start.qd, start.z]), Barrier(THREADS)

    def own(_: int) -> Methods:
        begin.wait()
        knots = Knots(system, 0.0, 1.0)
        kinematics, atol = system.kinematics, np.full(y.size, 1e-10)
        covered = Covered(system.structure, kinematics.lists.step_weight, 1e-8, 1e-10, 1e-15, True)
        covered.take(kinematics.evaluation.work, start.x, start.v, start.z)
        explicit = Steps(kinematics, Snapshot.of(start), y, 1e-8, atol, knots, covered)
        implicit = Collocation(system.kinematics, 1.0, np.ones(y.size))
        implicit.choice, c = explicit.choice, implicit.struct
        c.tolerance, c.enlarged, c.end, c.longest = 1e-12, 1.0, 1.0, 1.0
        c.covered = covered.struct  # a run has one for each method; the driver takes one after the other
        lib.flexel_radau_factorize(c, SHORT)
        implicit.look_again()
        c.factorized, c.real_factorize, c.complex_factorize = (
            SHORT,
            ffi.NULL,
            ffi.NULL,
        )  # the driver has no LAPACK
        return explicit, implicit

    with ThreadPoolExecutor(THREADS) as pool:
        return list(pool.map(own, range(THREADS)))


def moved(methods: Methods) -> Array:
    """What the driver computes: state after some steps, and the derivatives of the forces there."""
    own, implicit = methods
    work, choice, run = own.choice.work.struct, own.choice.struct, own.struct
    lib.flexel_reset(work, choice)
    assert not lib.flexel_dop853_begin(work, choice, run, 0.0)
    t = 0.0
    for _ in range(STEPS):
        assert not lib.flexel_dop853_step(work, choice, run, t, STEP)
        lib.flexel_dop853_accept(work, run)
        t += STEP
    at, c = own.choice.work, implicit.struct
    implicit.y[:], implicit.x[:], implicit.v[:], implicit.e[:], implicit.ed[:] = own.y, at.x, at.v, at.e, 0.0
    c.t, c.h = t, SHORT
    assert not lib.flexel_radau_begin(work, choice, c)
    assert not lib.flexel_radau_step(work, choice, c)
    lib.flexel_radau_accept(work, choice, c)
    lib.flexel_complete(work, choice, 0)
    lib.flexel_rates(work)
    lib.flexel_convective(work)
    arrays, energies = own.choice.work.state()
    own.choice.work.stress[:] = np.frombuffer(
        ffi.buffer(work.element_stress, 8 * (work.m + work.k)), count=work.m + work.k
    )
    lib.flexel_rate_derivatives(work)
    lib.flexel_law_tangents(work, 0.0, 0)
    tangents = np.zeros((2, work.nT))
    lib.flexel_tangents(work, *(ffi.from_buffer("double[]", tangent) for tangent in tangents))
    return np.concatenate([*arrays, energies, tangents.ravel()])


def written(file: Path, methods: Sequence[Methods], workspaces: int = THREADS) -> None:
    """The file for the driver; with fewer workspaces, threads share them."""
    first = methods[0][0]
    evaluation = first.kinematics.evaluation
    roots: list[list[Struct]] = [
        [explicit.choice.work, explicit.choice, explicit, implicit] for explicit, implicit in methods
    ]
    others = [
        struct
        for explicit, implicit in methods
        for struct in (explicit.covered, implicit.turns, implicit.angles)
    ]
    image = Image(evaluation.tables, [struct for root in roots for struct in root] + others)
    samples = evaluation.tables.samples
    assert samples is not None
    length = sum(part.stop - part.start for part in first.choice.work._state) + 4
    place, _ = image.place(samples.ctypes.data)
    image.write(file, [roots[i % workspaces] for i in range(THREADS)], place, samples.shape[1], length)


@pytest.fixture(scope="module", params=KINDS)
def driver(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Path]:
    """Kind of sanitizer, and the driver compiled with the engine and all kernels that the models need."""
    compiler, kind = shutil.which("gcc"), str(request.param)
    if not compiler:
        pytest.skip("gcc is not installed")
    folder = tmp_path_factory.mktemp(kind)
    names = {b.spec.name for model in MODELS.values() for b in model()[0].evaluation.tables.elements}
    sources = [
        *ENGINE.glob("*.c"),
        *(GENERATED / f"{name}.c" for name in sorted(names)),
        GENERATED / "laws.c",
        DRIVER,
    ]
    flags = [*FLAGS, f"-fsanitize={kind}"]

    def called(*arguments: object) -> None:
        command = [compiler, *flags, *map(str, arguments)]
        found = subprocess.run(command, capture_output=True, text=True, check=False, env=CLEAN)
        assert found.returncode == 0, found.stderr

    def compiled(source: Path) -> Path:
        made = folder / f"{source.parent.name}_{source.stem}.o"
        called("-c", source, "-o", made)
        return made

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        objects = list(pool.map(compiled, sources))
    called("-rdynamic", *objects, "-o", folder / "driver", "-lm", "-ldl", "-pthread")
    return kind, folder / "driver"


def run(driver: Path, file: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([driver, file], capture_output=True, text=True, check=False, env=CLEAN, timeout=300)


def test_the_driver_fits_the_engine() -> None:
    """Its calls have the arguments that the engine's functions take."""
    compiler = shutil.which("gcc")
    if not compiler:
        pytest.skip("gcc is not installed")
    command = [compiler, *FLAGS, "-fsyntax-only", str(DRIVER)]
    found = subprocess.run(command, capture_output=True, text=True, check=False, env=CLEAN)
    assert found.returncode == 0, found.stderr


@CAMPAIGN
@pytest.mark.parametrize("name", MODELS)
def test_eight_threads_race_nowhere_and_leave_nothing(
    driver: tuple[str, Path], name: str, tmp_path: Path
) -> None:
    """And find the digits of the extension, up to what another optimization rounds."""
    steps = prepared(*MODELS[name]())
    written(tmp_path / "image", steps)
    found = run(driver[1], tmp_path / "image")
    assert found.returncode == 0 and not found.stderr, found.stderr
    digits, expected = np.array(found.stdout.split(), dtype=float), moved(steps[0])
    assert digits == pytest.approx(expected, rel=1e-9, abs=1e-9 * abs(expected).max())


@CAMPAIGN
def test_two_threads_in_one_workspace_are_noticed(driver: tuple[str, Path], tmp_path: Path) -> None:
    kind, program = driver
    written(tmp_path / "image", prepared(*rolling()), workspaces=4)
    found = run(program, tmp_path / "image")
    assert found.returncode != 0
    if kind == "thread":
        assert "data race" in found.stderr
