"""The processor of this machine, and code that was compiled for one processor only."""

import platform
from pathlib import Path
from typing import Any

X86 = ("x86_64", "AMD64")


class ProcessorError(ImportError):
    """The compiled code needs what this processor does not have."""


def native_flags() -> tuple[str, ...]:
    """Return the compiler's flags for this processor only: one vector width instead of a choice at run time.

    The digits are those of every other width: no operation is contracted or reordered.
    """
    own = ("-march=native", "-mprefer-vector-width=512") if platform.machine() in X86 else ()
    return ("-DFLEXEL_NO_CLONES", *own)


def processor() -> str:
    """Return the machine properties on which ``-march=native`` depends."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return platform.processor()
    own = sorted({line for line in lines if line.startswith(("flags", "Features"))})
    return "\n".join([platform.machine(), *own])


def check_processor(ffi: Any, lib: Any) -> None:
    """Check that this processor can run the extension, before any of its kernels is called.

    Raises
    ------
    ProcessorError
        The extension was compiled for a processor that has instructions which this one lacks.
    """
    lacking = lib.flexel_lacking_feature()
    if lacking != ffi.NULL:
        raise ProcessorError(
            f"flexel was compiled for another processor: this one has no '{ffi.string(lacking).decode()}'; compile it "
            "here (pip install --force-reinstall --no-cache-dir, from the source), or for every processor with "
            "FLEXEL_PORTABLE=1 in the environment"
        )
