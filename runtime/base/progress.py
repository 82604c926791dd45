"""Progress bars.

A hidden bar is not one of tqdm: a forked child would inherit the locks of tqdm as another thread held them.
"""

from __future__ import annotations

from typing import Any

from tqdm import tqdm


class Hidden:
    """A progress bar that is not shown."""

    def __init__(self) -> None:
        self.n = 0.0

    def update(self, more: float = 1) -> None:
        """Progress by so much."""
        self.n += more

    def close(self) -> None:
        """Nothing was shown."""


def progress_bar(shown: bool, total: float, unit: str, layout: str | None = None) -> Any:
    """A progress bar on stderr, with `update`, `close` and the progress `n`, or a hidden one."""
    return tqdm(total=total, unit=unit, leave=False, bar_format=layout) if shown else Hidden()
