"""Shows figures of flexel in the pages of programs, where they are the last line of a cell, as a notebook does."""

from collections.abc import Callable
from typing import Any
from weakref import WeakSet

from matplotlib.figure import Figure
from sphinx_gallery.scrapers import figure_rst

LAST = "___"  # where sphinx-gallery keeps the value of the last line, until another cell has one
_shown: WeakSet[Figure] = WeakSet()


def last_of_a_cell(block: Any, block_vars: dict[str, Any], gallery_conf: dict[str, Any]) -> str:
    """Save the figure that the last line of a cell returns, if it is one; return the text that includes it."""
    figure = block_vars["example_globals"].get(LAST)
    if not isinstance(figure, Figure) or figure in _shown:
        return ""
    _shown.add(figure)
    path = next(block_vars["image_path_iterator"])
    figure.savefig(path)
    return str(figure_rst([path], gallery_conf["src_dir"]))


def _get_sg_image_scraper() -> Callable[[Any, dict[str, Any], dict[str, Any]], str]:
    """Return what sphinx-gallery calls after each cell; it looks for this name in the modules of `image_scrapers`."""
    return last_of_a_cell
