"""Cables, ropes, and what they touch: laying them, contact with surfaces, what they are asked about."""
