"""Progress bars.

A hidden bar does not use tqdm: a forked child would inherit tqdm's locks in the state another thread left them.
"""

from __future__ import annotations

from typing import Any

from tqdm import tqdm


class Hidden:
    """A progress bar that is not shown."""

    def __init__(self) -> None:
        self.n = 0.0

    def update(self, more: float = 1) -> None:
        """Advance by this amount."""
        self.n += more

    def close(self) -> None:
        """Do nothing: no bar is shown."""


def progress_bar(shown: bool, total: float, unit: str, layout: str | None = None) -> Any:
    """Return a progress bar on stderr, with `update`, `close` and the progress `n`, or a hidden one."""
    return tqdm(total=total, unit=unit, leave=False, bar_format=layout) if shown else Hidden()
