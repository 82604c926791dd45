"""Functions of LAPACK for the engine in C, by SciPy's pointers to them."""

from __future__ import annotations

import ctypes
from functools import cache
from typing import Any

from scipy.linalg import cython_lapack

from flexel.generated._kernels import ffi

_NAME = ctypes.pythonapi.PyCapsule_GetName
_NAME.restype, _NAME.argtypes = ctypes.c_char_p, [ctypes.py_object]
_POINTER = ctypes.pythonapi.PyCapsule_GetPointer
_POINTER.restype, _POINTER.argtypes = ctypes.c_void_p, [ctypes.py_object, ctypes.c_char_p]


@cache
def lapack(name: str, kind: str) -> Any:
    """Return a pointer of a type of the engine to a function, such as "dgetrf"."""
    functions: dict[str, Any] = dict(cython_lapack.__pyx_capi__)
    capsule = functions[name]
    return ffi.cast(kind, _POINTER(capsule, _NAME(capsule)))
