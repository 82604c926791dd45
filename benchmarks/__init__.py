"""What flexel costs, measured: the rows of `flexel bench`, in `flexel.benchmarks.table`, one module for each family."""
