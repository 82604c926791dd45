"""Configuration of Sphinx. The generated pages are written first, by pages.py in this folder."""

import logging
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parent
sys.path[:0] = [str(DOCS), str(DOCS.parent / "tools")]

import docstrings  # noqa: E402
import pages  # noqa: E402

import flexel  # noqa: E402

project, author, copyright = "flexel", "flexel contributors", "flexel contributors"  # noqa: A001
version = release = flexel.__version__
extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx_gallery.gen_gallery",
    "mathml",
]
# a package of the theme sets the root logger to INFO when it is imported
logging.getLogger("flexel").setLevel(logging.WARNING)
sphinx_gallery_conf = {
    "examples_dirs": ["../examples/gallery", "lessons"],
    "gallery_dirs": ["_generated/gallery", "_generated/lessons"],
    "image_scrapers": ("matplotlib", "figures"),
    "ignore_repr_types": r"matplotlib\.figure|flexel\.apps\.view\.figures",
    "filename_pattern": ".py",
    "ignore_pattern": "__init__",
    "abort_on_example_error": True,
    "download_all_examples": False,
    "show_signature": False,
    "remove_config_comments": True,
    "min_reported_time": 60,
    "write_computation_times": False,
    "thumbnail_size": (400, 280),
    "within_subsection_order": "FileNameSortKey",
}
html_math_renderer = "mathml"  # from mathml.py in this folder
myst_enable_extensions = ["dollarmath"]
html_extra_path = ["_generated/report", "_generated/extra"]
exclude_patterns = ["_build", "_generated/contents.md", "lessons"]
myst_heading_anchors = 3
default_role = "code"
autodoc_typehints = "none"
autodoc_member_order = "bysource"
napoleon_google_docstring = False
napoleon_use_ivar = True
suppress_warnings = [
    "ref.python"
]  # short attribute names, such as x, occur in several classes, without intended links
html_theme = "furo"
html_title = "flexel"
html_static_path = ["static"]
html_css_files = ["flexel.css"]
html_search_scorer = str(DOCS / "search.js")
html_show_sourcelink = False
templates_path: list[str] = []


def setup(app: object) -> None:
    """Write the generated pages, then let Sphinx read."""
    pages.write(DOCS)
    before = 400  # the extension that reads the sections has 500
    app.connect("autodoc-process-docstring", docstrings.process, priority=before)  # type: ignore[attr-defined]
