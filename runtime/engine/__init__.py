"""The equations of the whole system: kernels, assembly, factorization."""

from flexel.derive.processor import check_processor
from flexel.generated._kernels import ffi, lib

check_processor(ffi, lib)
