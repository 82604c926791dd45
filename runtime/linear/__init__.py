"""State space, harmonic balance, Floquet multipliers, periodic motion."""
