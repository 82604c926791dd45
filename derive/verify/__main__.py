"""``python -m flexel.derive.verify``."""

from flexel.derive.verify import main

if __name__ == "__main__":
    main(prog_name="flexel verify")
