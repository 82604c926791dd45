"""Write the generated pages of the documentation: one for each element, the laws, the public names, the contents.

`make docs` runs it, from conf.py. The output is in ``docs/_generated`` and is not kept in git. The
numbers of the verification are those of `flexel verify`, computed once for each derivation of the kernels.
"""

import inspect
import json
from collections import defaultdict
from importlib import import_module
from pathlib import Path

import live
from element_pages import Rows, element_page, elements_page, laws_page, table
from methods import method_pages, method_sections, other_methods
from reported import write_report

import flexel
from flexel.apps.cli.reproduce import CASES
from flexel.derive.verify import verify_generated
from flexel.generated.table import ELEMENTS, LAWS

# Of the guides, in this order.
FIRST = (
    "start",
    "concepts",
    "mistakes",
    "words",
    "seeds",
    "joints",
    "flexure-design",
    "vehicles",
    "cranes",
    "control",
    "writing-an-element",
    "coming-from-spacar",
    "coming-from-spacar-light",
    "coming-from-exudyn",
    "coming-from-sympy",
    "many",
    "sweeps",
)
REFERENCE = ("theory", "architecture", "adding-an-element", "verification", "speed", "report")

HOMES = {  # sections of the page of public names: title and modules
    "Models": (
        "flexel.parts.model",
        "flexel.model.rigid_body",
        "flexel.mechanics.findings",
        "flexel.parts.sections",
        "flexel.model.profiles",
        "flexel.parts.round_sections",
        "flexel.parts.thin_sections",
        "flexel.parts.closed_profile",
        "flexel.parts.materials",
        "flexel.parts.curves",
        "flexel.parts.wheels",
        "flexel.base.quaternions",
        "flexel.parts.elements",
        "flexel.parts.element_page",
    ),
    "Flexure mechanisms": (
        "flexel.apps.flexures.flexure",
        "flexel.apps.flexures.declaring",
        "flexel.apps.flexures.properties",
        "flexel.results.flexure_result",
        "flexel.results.flexure_step",
    ),
    "Ropes and contact": (
        "flexel.parts.rope",
        "flexel.parts.wire_rope",
        "flexel.parts.rope_surfaces",
        "flexel.parts.rope_contacts",
    ),
    "Functions of time": ("flexel.base.time_functions", "flexel.base.time_tables"),
    "Systems, states and motions": (
        "flexel.results.system_facade",
        "flexel.model.state",
        "flexel.integration.events",
        "flexel.results.analyses.stepper",
        "flexel.results.analyses.summary",
        "flexel.results.motion",
        "flexel.parts.opening",
    ),
    "Statics, stresses and periodic motions": (
        "flexel.model.constraints",
        "flexel.model.stress",
        "flexel.statics.stability",
        "flexel.statics.compliance",
        "flexel.results.periodic_motion",
        "flexel.results.periodic_branch",
    ),
    "SPACAR": ("flexel.apps.spacar.reading", "flexel.results.saved.spacar_records"),
    "Sweeps": (
        "flexel.apps.sweeps.parameter_sweep",
        "flexel.apps.sweeps.points",
        "flexel.apps.sweeps.sampled_points",
        "flexel.apps.sweeps.dataset",
    ),
    "Linearization": (
        "flexel.results.linearization",
        "flexel.results.time_varying",
        "flexel.results.small_motion",
        "flexel.mechanics.modes",
        "flexel.linear.sampled",
    ),
    "Many variants": ("flexel.results.ensemble", "flexel.results.linearizations"),
    "Errors": ("flexel.base.errors", "flexel.results.interrupted", "flexel.derive.definition_errors"),
    "Pictures": ("flexel.apps.view.scene", "flexel.apps.view.solids"),
}
RETURNED = {  # functions and options of pictures that are not names of the package itself
    "flexel.linear.tracking": ("Branches", "Boundary"),
    "flexel.linear.response": ("FrequencyResponse",),
    "flexel.apps.view.scene": ("draw",),
    "flexel.apps.view.loci": ("root_loci",),
    "flexel.apps.view.page": ("scene_data", "view_modes", "Page"),
}
AUTHORING = ("Part", "part", "quantity", "array_quantity", "entry", "Lowering")  # of `flexel.parts`
DECLARATIONS = (
    "flexel.derive.declare.element",
    "flexel.derive.declare.rotation",
    "flexel.derive.declare.shape",
)


def verification(folder: Path) -> dict[str, Rows]:
    """Return the rows of `flexel verify` by element (a law is ``law <name>``), cached by the digests of kernels."""
    digests = {
        f"{prefix}{spec.name}": spec.digest
        for prefix, t in (("", ELEMENTS), ("law_", LAWS))
        for spec in t.values()
    }
    file = folder / "verification.json"
    kept = json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}
    if kept.get("digests") != digests or "tolerances" not in kept:
        kept = {"digests": digests, **verify_generated(progress=True).as_json()}
        put(file, json.dumps(kept))
    rows: dict[str, Rows] = defaultdict(list)
    for row in kept["rows"]:
        rows[row["element"]].append(row)
    return rows


def put(file: Path, text: str) -> None:
    """Write a file only if it has changed, so that Sphinx does not read it again."""
    file.parent.mkdir(parents=True, exist_ok=True)
    if not file.is_file() or file.read_text(encoding="utf-8") != text:
        file.write_text(text, encoding="utf-8")


def directive(name: str, module: str = "flexel") -> str:
    """Return the autodoc directive of a name."""
    value = getattr(import_module(module), name)
    if not inspect.isclass(value):
        return f".. autofunction:: {module}.{name}\n"
    if issubclass(value, BaseException):
        return f".. autoexception:: {module}.{name}\n"
    if value is flexel.Model:  # the methods that declare parts have pages of their own
        return f".. autoclass:: {module}.{name}\n   :members: {', '.join(other_methods())}\n"
    families = [family for family in value.__mro__[1:] if family.__module__.startswith("flexel.")]
    if not families:
        return f".. autoclass:: {module}.{name}\n   :members:\n"
    # Methods in separate families; those of Python's base classes, as of a sequence, are left out.
    members = dict.fromkeys(
        key
        for base in (value, *families)
        for key, member in vars(base).items()
        if not key.startswith("_")
        and inspect.getdoc(member)
        and not isinstance(member, str | tuple | int | float)
    )
    return f".. autoclass:: {module}.{name}\n   :members: {', '.join(members)}\n"


def section(title: str, slug: str, names: list[tuple[str, str]]) -> str:
    """Return a section of the list of public names: a link for each, and its first sentence.

    Parameters
    ----------
    title, slug : str
        Of the page of a topic.
    names : list of (str, str)
        The full name of each, and the name that is shown.
    """
    rows = [(f"{{py:obj}}`{shown} <{full}>`", sentence(full)) for full, shown in names]
    return f"## [{title}]({slug}.md)\n\n" + (table(("name", "purpose"), rows) if rows else "")


def sentence(full: str) -> str:
    """Return the first sentence of the documentation of a name ``module.name`` or ``module.class.name``."""
    module, _, name = full.rpartition(".")
    owner, _, kind = module.rpartition(".")
    home = getattr(import_module(owner), kind) if kind[:1].isupper() else import_module(module)
    first = (inspect.getdoc(getattr(home, name)) or "").partition("\n\n")[0]
    return " ".join(first.split())


def api_pages() -> dict[str, str]:
    """Return the pages of public names by file name: one for each topic, and ``api``, which lists topics and names."""
    titles = {module: title for title, homes in HOMES.items() for module in homes}
    names: dict[str, list[tuple[str, str]]] = {title: [] for title in HOMES}  # module and name
    for name, module in flexel._HOMES.items():
        names[titles[module]].append(("flexel", name))
    names["Pictures"] += [(module, name) for module, given in RETURNED.items() for name in given]
    names["Parts of your own"] = [("flexel.parts", name) for name in AUTHORING]
    entries = {title: [directive(name, module) for module, name in found] for title, found in names.items()}
    entries["Declaring elements and laws"] = [
        f".. automodule:: {module}\n   :members:\n" for module in DECLARATIONS
    ]
    slugs = {title: f"api/{title.lower().replace(' ', '-').replace(',', '')}" for title in entries}
    sections = [
        (title, slugs[title], [(f"{module}.{name}", name) for module, name in names.get(title, [])])
        for title in entries
    ]
    sections[1:1] = method_sections()
    methods = method_pages()
    text = "# Public names\n\nAfter `import flexel as fx`, each of these is available as `fx.NAME`, except methods\n"
    text += "(`m` is a `Model`) and the names of the last three topics, whose pages name their modules.\n\n"
    text += "\n".join(section(*given) for given in sections)
    text += "\n```{toctree}\n:hidden:\n\n" + "\n".join([*slugs.values(), *methods]) + "\n```\n"
    pages = {
        slugs[title]: f"# {title}\n\n```{{eval-rst}}\n" + "\n".join(found) + "```\n"
        for title, found in entries.items()
    }
    return {"api": text, **methods, **pages}


def contents(folder: Path) -> str:
    """Return the tables of contents: guides, systems, reference. A new page in the folder belongs to one of them."""
    found = {file.stem for file in folder.glob("*.md")} - {"index"}
    systems = [name for name in CASES if name in found]
    guides = [*FIRST, *sorted(found - {*FIRST, *REFERENCE, *systems})]
    elements = ["_generated/elements", "_generated/laws", "_generated/api"]
    groups = {
        "Guides": [guides[0], "_generated/lessons/index", *guides[1:], "_generated/gallery/index"],
        "Systems reproduced": systems,
        "Reference": [*REFERENCE, *elements],
    }
    return "\n".join(
        f"```{{toctree}}\n:caption: {caption}\n:maxdepth: 1\n\n" + "\n".join(names) + "\n```\n"
        for caption, names in groups.items()
    )


def write(folder: Path) -> None:
    """Write all generated pages under a folder of documentation."""
    out = folder / "_generated"
    rows = verification(out)
    for name, spec in ELEMENTS.items():
        picture = f"images/element_{name}.png"
        link = f"../../{picture}" if (folder / picture).is_file() else ""
        put(out / "elements" / f"{name}.md", element_page(spec, rows.get(name, []), link))
    put(out / "elements.md", elements_page())
    put(out / "laws.md", laws_page(rows))
    public = api_pages()
    for name, text in public.items():
        put(out / f"{name}.md", text)
    for file in (out / "api").glob("*.md"):
        if f"api/{file.stem}" not in public:  # of a removed topic
            file.unlink()
    put(out / "contents.md", contents(folder))
    live.write(folder, out / "extra" / "live")
    write_report(folder, out / "verification.json", out / "report" / "report-latest.html")
