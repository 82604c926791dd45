"""Cables and ropes: their initial configuration, contact with surfaces, and results."""
