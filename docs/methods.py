"""Pages of the methods of `flexel.Model`, by topic; `pages.py` writes them.

`Model` derives its methods from families, classes of a few methods each. A page holds the families of one topic.
"""

from __future__ import annotations

import flexel

# Titles of the pages, and the families on them. A family that is not named here is found by the folder that it is in.
TOPICS = {
    "Nodes, bodies, roles and loads": ("Nodes", "RigidBodies", "Bodies", "Loading"),
    "Joints, gears and cams": (
        "BodyJoints", "Gearing", "Cams", "Skates", "Friction", "Joints", "Couplings", "RelationMethods",
    ),
    "Beams and elements": ("Beams", "LeafSprings", "Elements"),
    "Springs, laws and controllers": ("Springs", "Laws"),
    "Wheels and tyres": ("Wheels",),
    "Ropes, chains and contacts": (),
}  # fmt: skip
BY_PACKAGE = {"flexel.rope": "Ropes, chains and contacts", "flexel.declare": "Springs, laws and controllers"}


def families() -> dict[str, dict[type, list[str]]]:
    """Return the families with public methods, and these, by title of the page."""
    titles = {family: title for title, names in TOPICS.items() for family in names}
    found: dict[str, dict[type, list[str]]] = {title: {} for title in TOPICS}
    for family in flexel.Model.__mro__[1:]:
        methods = [name for name in vars(family) if not name.startswith("_")]
        if methods and family is not object:
            title = titles.get(family.__name__) or BY_PACKAGE[family.__module__.rpartition(".")[0]]
            found[title][family] = methods
    return found


def slug(title: str) -> str:
    """The name of a page."""
    return f"api/model-{title.lower().replace(' ', '-').replace(',', '')}"


def method_pages() -> dict[str, str]:
    """Return the pages by file name."""
    pages = {}
    for title, found in families().items():
        ranks = {name: rank for rank, name in enumerate(TOPICS[title])}
        parts = [f"# Methods of Model: {title.lower()}\n"]
        for family in sorted(found, key=lambda z: ranks.get(z.__name__, len(ranks))):
            head = (family.__doc__ or family.__name__).split("\n", 1)[0].rstrip(".")
            methods = "\n".join(f".. automethod:: flexel.Model.{name}\n" for name in found[family])
            parts.append(f"## {head}\n\n```{{eval-rst}}\n{methods}```\n")
        pages[slug(title)] = "\n".join(parts)
    return pages


def method_rows() -> list[tuple[str, str]]:
    """Return a row for each page, of its link and its methods, for the table of topics."""
    return [
        (
            f"[Model: {title.lower()}]({slug(title)}.md)",
            ", ".join(f"`m.{name}`" for methods in found.values() for name in methods),
        )
        for title, found in families().items()
    ]
