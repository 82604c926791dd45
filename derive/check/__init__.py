"""Checks of user definitions, beyond those of a declaration: joins, jumps and stored energies."""
