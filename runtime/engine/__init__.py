"""The equations of the whole system: kernels, assembly, factorization."""
