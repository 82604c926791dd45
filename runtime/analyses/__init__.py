"""Analyses of a system, each family of methods on the core."""
