"""A process that does bad calls, one after another: a hang or a crash stops this process, not the tests.

The module `bad_calls` or `bad_files` says what a case is.  Reads cases from a file, one a line as JSON; writes
"begin i" before each and "end i verdict" after it.
"""

import json
import os
import resource
import sys
from importlib import import_module
from pathlib import Path

MEMORY = (
    8 * 2**30
)  # address space [bytes]: a request for more is refused by the system, as on a small machine


def main(module: str, kind: str, file: str, first: int) -> None:
    """Do the cases from number `first` on."""
    campaign = import_module(module)
    case = getattr(campaign, kind)

    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    campaign.prepare()
    out = os.fdopen(os.dup(1), "w", buffering=1)
    os.dup2(2, 1)  # what a call prints is not a verdict
    for i, line in list(enumerate(Path(file).read_text().splitlines()))[first:]:
        out.write(f"begin {i}\n")
        out.write(f"end {i} {json.dumps(campaign.verdict(case(*json.loads(line))))}\n")


if __name__ == "__main__":
    main(*sys.argv[1:4], int(sys.argv[4]))
