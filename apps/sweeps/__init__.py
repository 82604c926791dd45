"""Sweeps: a model built and analysed at many points of its parameters, over processes and clusters.

- `points`, `sampled_points`: the points of a sweep,
- `work`, `forms`: the task of a worker, and the form of its results,
- `executors`, `drive`: the workers, and the distribution of points among them,
- `store`: the folder to which results are written as they arrive,
- `dataset`: that folder as one labelled dataset,
- `parameter_sweep`: all of this in one call.
"""
