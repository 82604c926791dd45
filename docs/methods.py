"""Pages of the methods of `flexel.Model` that declare parts, by topic; `pages.py` writes them.

The methods are those of the table in `Model`. A page holds the modules of parts of one topic, a section for each.
"""

from __future__ import annotations

import inspect
from importlib import import_module

import flexel
from flexel.parts.method import METHOD_OF

# Titles of the pages, and the modules of `flexel.parts` on them.
TOPICS = {
    "Nodes, bodies, roles and loads": ("nodes", "rigid_bodies", "bodies", "roles", "loads", "looks"),
    "Joints, gears and cams": (
        "body_joints", "gearing", "cams", "skates", "friction", "joints", "couplings", "relations",
    ),
    "Beams and elements": ("beams", "leaf_springs", "elements"),
    "Springs, laws and controllers": ("springs", "laws", "controllers"),
    "Wheels and tyres": ("wheels",),
    "Ropes, chains and contacts": (
        "ropes", "cables", "cable_lines", "chains", "rope_surfaces", "rope_contacts", "point_contacts",
    ),
}  # fmt: skip


def declaring() -> dict[str, list[str]]:
    """Return the methods that declare parts, by module of `flexel.parts`, in the order of the table in `Model`."""
    order = list(vars(flexel.Model))  # the import of Model fills METHOD_OF
    found: dict[str, list[str]] = {}
    for kind, name in sorted(METHOD_OF.items(), key=lambda row: order.index(row[1])):
        found.setdefault(kind.__module__.rpartition(".")[2], []).append(name)
    return found


def other_methods() -> list[str]:
    """Return the public methods and properties of `Model` that declare nothing, in the order of its file."""
    return [
        name for name in vars(flexel.Model) if not name.startswith("_") and name not in METHOD_OF.values()
    ]


def topics() -> dict[str, dict[str, list[str]]]:
    """Return the modules and their methods by title of the page; a module without a topic is a KeyError."""
    titles = {module: title for title, modules in TOPICS.items() for module in modules}
    ranks = {module: rank for rank, module in enumerate(titles)}
    found: dict[str, dict[str, list[str]]] = {title: {} for title in TOPICS}
    for module, methods in sorted(declaring().items(), key=lambda row: ranks[row[0]]):
        found[titles[module]][module] = methods
    return found


def slug(title: str) -> str:
    """Return the name of a page."""
    return f"api/model-{title.lower().replace(' ', '-').replace(',', '')}"


def method_pages() -> dict[str, str]:
    """Return the pages by file name."""
    pages = {}
    for title, found in topics().items():
        sections = [f"# Methods of Model: {title.lower()}\n"]
        for module, names in found.items():
            text = inspect.getdoc(import_module(f"flexel.parts.{module}")) or module
            head = text.split("\n", 1)[0].partition(":")[0].rstrip(".")
            methods = "\n".join(f".. automethod:: flexel.Model.{name}\n" for name in names)
            sections.append(f"## {head}\n\n```{{eval-rst}}\n{methods}```\n")
        pages[slug(title)] = "\n".join(sections)
    return pages


def method_sections() -> list[tuple[str, str, list[tuple[str, str]]]]:
    """Return title, page, and methods of each topic: the full name of each, and the name that is shown."""
    return [
        (
            f"Model: {title.lower()}",
            slug(title),
            [(f"flexel.Model.{name}", f"m.{name}") for methods in found.values() for name in methods],
        )
        for title, found in topics().items()
    ]
