"""``python -m flexel``: the same as the command ``flexel``."""

from flexel.cli import main

if __name__ == "__main__":
    main(prog_name="python -m flexel")
