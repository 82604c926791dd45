"""Explicit and implicit motion, events, the energy balance."""
