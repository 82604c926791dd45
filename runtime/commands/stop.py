"""What commands that are stopped by Ctrl-C have in common."""

INTERRUPTED = 130  # exit status of a program that was interrupted: 128 and the number of the signal
