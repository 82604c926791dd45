"""Analyses of a system: families of methods on top of the core."""
