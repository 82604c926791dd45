"""Coordinates and their choice, kinematics, dynamics, completed states, linearization."""
