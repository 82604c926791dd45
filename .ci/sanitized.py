"""Run commands one after another with sanitizers, and write what ran and what was found; `make sanitize` calls it.

    python .ci/sanitized.py FILE.json LOGS [NAME=VALUE...] < commands

A line of the standard input is a command; one that begins with + has the environment NAME=VALUE. What the sanitizers
write is in LOGS.*. The first command that fails ends it, with exit status 1; the file is written in any case.
"""

import json
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

# The last two by a driver in C of the engine's threads, in tests/engine/test_sanitizers.py.
SANITIZERS = ["address", "undefined behaviour", "leaks", "threads"]


def run(command: str, environment: dict[str, str]) -> dict[str, Any]:
    """Run a command; how it ended."""
    begin = time.monotonic()
    under = command.startswith("+")
    words = command.removeprefix("+")
    print(words, flush=True)
    status = subprocess.run(
        words, shell=True, env=os.environ | environment if under else None, check=False
    ).returncode
    return {"command": words, "ok": status == 0, "seconds": time.monotonic() - begin}


def main(file: str, logs: str, *assignments: str) -> int:
    """Run all, and write the file."""
    environment = dict(assignment.split("=", 1) for assignment in assignments)
    commands = [line.strip() for line in sys.stdin if line.strip()]
    for old in Path(logs).parent.glob(f"{Path(logs).name}.*"):
        old.unlink()
    steps: list[dict[str, Any]] = []
    for command in commands:
        stopped = bool(steps) and not steps[-1]["ok"]
        not_run = {"command": command.removeprefix("+"), "ok": None, "seconds": 0.0}
        steps.append(not_run if stopped else run(command, environment))
    found = [
        path.read_text(encoding="utf-8", errors="replace")
        for path in sorted(Path(logs).parent.glob(f"{Path(logs).name}.*"))
    ]
    print(*found, sep="\n")
    Path(file).parent.mkdir(parents=True, exist_ok=True)
    content = {"sanitizers": SANITIZERS, "steps": steps, "found": found}
    Path(file).write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
    return int(bool(found) or not all(step["ok"] for step in steps))


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
