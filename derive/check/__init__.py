"""Checks of what users define, beyond those of a declaration: joins, jumps and stored energies."""
