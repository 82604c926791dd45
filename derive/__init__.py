"""From elements declared in SymPy to C: the floor that derives. See `flexel.derive.element` for the declaration."""
