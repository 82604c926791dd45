"""Explicit and implicit time integration, events, the energy balance."""
