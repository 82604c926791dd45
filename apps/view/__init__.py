"""Pictures with matplotlib, and the shapes of all parts, which the viewer uses too."""
