"""Equations in coordinates and multipliers on sparse matrices, and implicit integration of them."""
