"""Declarations by family: the methods of `Model`."""
