"""The memory that this process uses, as its allocators count it: independent of the size of pages."""

import ctypes
import gc
import sys

OBJECT_BYTES = 64.0  # of a small object of Python, which has an allocator of its own
FIELDS = (
    "arena",
    "ordblks",
    "smblks",
    "hblks",
    "hblkhd",
    "usmblks",
    "fsmblks",
    "uordblks",
    "fordblks",
    "keepcost",
)


class _Counts(ctypes.Structure):
    _fields_ = [(name, ctypes.c_size_t) for name in FIELDS]


def memory_in_use() -> float:
    """Memory that is in use [MB]: what C, NumPy and Python hold; needs glibc 2.33."""
    gc.collect()
    library = ctypes.CDLL(None)
    library.mallinfo2.restype = _Counts
    counts = library.mallinfo2()
    return float(counts.uordblks + counts.hblkhd + OBJECT_BYTES * sys.getallocatedblocks()) / 2**20
