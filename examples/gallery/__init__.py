"""Classics in less than forty lines each: programs to run, ``python double_pendulum.py``, and to start from."""
