"""Shared handling of Ctrl-C in commands."""

INTERRUPTED = 130  # exit status of a program that was interrupted: 128 and the number of the signal
