"""Straight-line programs: built from expressions, differentiated, and made into the kernels of elements and laws."""
