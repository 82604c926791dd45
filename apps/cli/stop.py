"""The exit status of commands after Ctrl-C."""

INTERRUPTED = 130  # exit status of a program that was interrupted: 128 and the number of the signal
