"""Compiled for this processor only: the digits are those of every other width, and another processor is told so."""

import ctypes
import subprocess
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from flexel.base.arrays import Array
from flexel.derive.processor import ProcessorError, check_processor, native_flags, processor
from flexel.derive.shared_object import FLAGS
from flexel.derive.verify.kernel_calls import Compiled, generated_elements
from flexel.generated._kernels import ffi, lib

ROOT = Path(__file__).parents[2]
ENGINE, GENERATED = ROOT / "runtime" / "engine", ROOT / "generated"
NAMES = ("popcnt", "sse4.2", "avx", "avx2", "fma", "bmi", "bmi2") + tuple(
    f"avx512{kind}" for kind in ("f", "dq", "bw", "vl", "cd")
)


def library(made: Path, sources: Sequence[Path], flags: Sequence[str]) -> ctypes.CDLL:
    """Compile to a shared object, and load it."""
    command = ["cc", "-std=gnu11", *FLAGS, *flags, f"-I{GENERATED}", f"-I{ENGINE}", "-shared", "-fPIC"]
    subprocess.run([*command, *map(str, sources), "-o", str(made), "-lm"], check=True)
    return ctypes.CDLL(str(made))


def outputs(compiled: Compiled) -> dict[tuple[str, str], Array]:
    """Every output of every kernel of the hinge, at 19 configurations."""
    rng, struct = np.random.default_rng(3), compiled.struct
    sizes = {"p": struct.np, "sigma": struct.m, "tau": struct.k} | dict.fromkeys("xva", struct.n)
    data = {name: rng.uniform(0.2, 1.5, (19, size)) for name, size in sizes.items()}
    return {
        (kernel, name): values
        for kernel in compiled.spec.kernels
        for name, values in compiled(kernel, data).items()
    }


@pytest.mark.parametrize(
    "flags", [native_flags(), ("-DFLEXEL_NO_CLONES",), ()], ids=["native", "least", "all"]
)
def test_every_vector_width_gives_the_same_bits(flags: Sequence[str], tmp_path: Path) -> None:
    made = library(tmp_path / "hinge.so", [GENERATED / "hinge.c"], flags)
    address = ctypes.addressof(ctypes.c_char.in_dll(made, "flexel_hinge"))
    spec, here_address = generated_elements()["hinge"]
    found, here = outputs(Compiled(spec, address)), outputs(Compiled(spec, here_address))
    assert found.keys() == here.keys() and len(found) == 10
    for key, values in here.items():
        assert values.tobytes() == found[key].tobytes(), key


def test_the_extension_runs_here() -> None:
    check_processor(ffi, lib)


@pytest.mark.skipif("x86_64" not in processor(), reason="the features are those of x86")
def test_what_this_processor_lacks_is_found(tmp_path: Path) -> None:
    """Asked for everything, it names the first feature that the kernel of the system does not report."""
    everything = tmp_path / "everything.c"
    ones = ", ".join("1" for _ in NAMES)
    everything.write_text(f'#include "processor.h"\nconst flexel_features flexel_needs = {{{ones}}};\n')
    made = library(tmp_path / "everything.so", [ENGINE / "processor.c", everything], ())
    made.flexel_lacking_feature.restype = ctypes.c_char_p
    there = processor().split()
    known = {"sse4.2": "sse4_2", "bmi": "bmi1"}
    lacking = [name for name in NAMES if known.get(name, name) not in there]
    assert made.flexel_lacking_feature() == (lacking[0].encode() if lacking else None)


@pytest.mark.skipif("x86_64" not in processor(), reason="the features are those of x86")
@pytest.mark.parametrize("flag", ["-mavx2", "-mfma", "-mbmi2", "-mpopcnt", "-mavx512f", "-mavx512vl"])
def test_what_the_compiler_may_use_is_needed(flag: str, tmp_path: Path) -> None:
    made = library(tmp_path / "needs.so", [ENGINE / "features.c"], (flag,))
    needs = dict(zip(NAMES, (ctypes.c_int * len(NAMES)).in_dll(made, "flexel_needs"), strict=True))
    assert needs[flag.removeprefix("-m")] == 1 and not needs["avx512cd"]


def test_an_extension_for_another_processor_is_refused_before_it_runs() -> None:
    class Other:
        def flexel_lacking_feature(self) -> object:
            return name

    name = ffi.new("char[]", b"avx512f")
    with pytest.raises(ProcessorError, match=r"no 'avx512f'; compile it here .*FLEXEL_PORTABLE=1"):
        check_processor(ffi, Other())
