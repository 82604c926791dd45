"""Flexure mechanisms from tables of nodes and elements, in the manner of SPACAR Light: one call for all results."""
