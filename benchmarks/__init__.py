"""The measured costs of flexel: the rows of `flexel bench` are in `flexel.benchmarks.table`, one module per family."""
