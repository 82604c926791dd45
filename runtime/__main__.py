"""``python -m flexel``: the same as the command ``flexel``."""

from flexel.apps.cli.main import main

if __name__ == "__main__":
    main(prog_name="python -m flexel")
