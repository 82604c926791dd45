"""Values in a new Python process, for tests."""

import os
import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any


def other_process(folder: Path, code: str, *values: Any, **environment: str) -> str:
    """What a new Python prints that has unpickled the values as the tuple `given`."""
    file = folder / "values.pickle"
    file.write_bytes(pickle.dumps(values))
    start = f"import pickle, sys; given = pickle.load(open({str(file)!r}, 'rb'))\n"
    known = os.environ | {"PYTHONPATH": str(Path(__file__).parent)} | environment
    done = subprocess.run([sys.executable, "-c", start + code], env=known, capture_output=True, text=True)
    assert not done.returncode, done.stderr
    return done.stdout.strip()
