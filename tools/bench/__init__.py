"""The measured costs of flexel.

`flexel bench` is `bench.command`; its rows are in `bench.table`, with one module per family.
"""
