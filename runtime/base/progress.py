"""Progress bars: on stderr in a terminal, tqdm's own in a notebook.

A hidden bar does not use tqdm: a forked child would inherit tqdm's locks in the state another thread left them.
"""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Iterable, Iterator
from typing import Any, TypeVar

from tqdm import tqdm

from flexel.base.arguments import flag

T = TypeVar("T")
DELAY_S = 0.5  # work that is done sooner shows no bar in a notebook, where each leaves a trace in the output


class Hidden:
    """A progress bar that is not shown."""

    def __init__(self) -> None:
        self.n = 0.0

    def update(self, more: float = 1) -> None:
        """Advance by this amount."""
        self.n += more

    def set_postfix_str(self, text: str, refresh: bool = True) -> None:
        """Do nothing: no bar is shown."""

    def close(self) -> None:
        """Do nothing: no bar is shown."""


def in_notebook() -> bool:
    """Whether this is the kernel of a notebook."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return getattr(shell, "kernel", None) is not None


def seen(progress: bool | None, owner: str) -> bool:
    """Whether a progress bar is shown: as requested, by default where stderr is a terminal, and in a notebook."""
    if progress is None:
        return sys.stderr.isatty() or in_notebook()
    return flag(progress, owner, "progress")


def progress_bar(shown: bool, total: float, unit: str, layout: str | None = None) -> Any:
    """Return a progress bar with `update`, `close` and the progress `n`, or a hidden one."""
    if not shown:
        return Hidden()
    if in_notebook() and importlib.util.find_spec("ipywidgets"):
        from tqdm.notebook import tqdm as widget

        return widget(total=total, unit=unit, leave=False, delay=DELAY_S)
    delay = DELAY_S if in_notebook() else 0
    return tqdm(total=total, unit=unit, leave=False, bar_format=layout, delay=delay)


def followed(items: Iterable[T], shown: bool, count: int, unit: str) -> Iterator[T]:
    """Yield items one by one, with a progress bar."""
    bar = progress_bar(shown, count, unit)
    try:
        for item in items:
            yield item
            bar.update(1)
    finally:
        bar.close()
