"""The base layer: errors, checks of arguments, quaternions, units, functions of time."""
