"""Equilibrium, load paths, steady motion, buckling, vibrations, compliance."""
