"""The derived kernels, their table and the compiled extension ``_kernels`` (with ``ffi`` and ``lib``).

Written by `flexel derive`; do not edit.
"""
