"""Sweeps: a model built and analysed at many points of its parameters, over processes and clusters.

- `points`, `sampling`: which points there are,
- `work`, `forms`: what a worker does with some of them, and what it hands back,
- `executors`, `drive`: who works, and who gets which points,
- `store`: the folder to which results are written as they come,
- `dataset`: that folder as one labelled dataset,
- `sweep`: all of this in one call.
"""
