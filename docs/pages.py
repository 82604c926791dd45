"""Write the generated pages of the documentation: one for each element, the laws, the public names, the contents.

``python docs/pages.py`` or `make docs` runs it. The output is in ``docs/_generated`` and is not kept in git. The
numbers of the verification are those of `flexel verify`, computed once for each derivation of the kernels.
"""

import inspect
import json
import math
from collections import defaultdict
from collections.abc import Iterable, Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

from reported import write_report

import flexel
from flexel.commands.reproduce import CASES
from flexel.derive.spec import DeformationSpec, ElementSpec, KernelSpec, LawSpec, ParameterSpec
from flexel.derive.verify import verify_generated
from flexel.generated.table import ELEMENTS, LAWS

# Of the guides, in this order.
FIRST = (
    "start",
    "concepts",
    "coming-from-spacar",
    "coming-from-spacar-light",
    "flexure-design",
    "joints",
    "writing-an-element",
    "adding-an-element",
)
REFERENCE = ("theory", "architecture", "verification", "speed", "report")
Rows = list[dict[str, Any]]

HOMES = {  # sections of the page of public names: title and modules
    "Models": (
        "flexel.model",
        "flexel.structure.rigid_bodies",
        "flexel.mechanics.findings",
        "flexel.declare.sections",
        "flexel.declare.round_sections",
        "flexel.declare.thin_sections",
        "flexel.declare.closed_profile",
        "flexel.declare.materials",
        "flexel.declare.curves",
        "flexel.declare.wheels",
        "flexel.base.quaternions",
        "flexel.declare.user",
    ),
    "Flexure mechanisms": (
        "flexel.flexures.flexure",
        "flexel.flexures.declaring",
        "flexel.flexures.properties",
        "flexel.results.flexure",
        "flexel.results.flexure_step",
    ),
    "Ropes and contact": (
        "flexel.rope.rope",
        "flexel.rope.wire_rope",
        "flexel.rope.surfaces",
        "flexel.rope.contacts",
    ),
    "Functions of time": ("flexel.base.time_functions",),
    "Systems, states and motions": (
        "flexel.system",
        "flexel.structure.state",
        "flexel.integration.events",
        "flexel.analyses.stepper",
        "flexel.analyses.summary",
        "flexel.results.motion",
        "flexel.results.saved.loading",
    ),
    "Statics, stresses and periodic motions": (
        "flexel.mechanics.constraints",
        "flexel.mechanics.stress",
        "flexel.statics.stability",
        "flexel.statics.compliance",
        "flexel.results.periodic",
        "flexel.results.branch",
    ),
    "SPACAR": ("flexel.spacar.reading", "flexel.results.saved.spacar_records"),
    "Sweeps": (
        "flexel.sweeps.sweep",
        "flexel.sweeps.points",
        "flexel.sweeps.sampling",
        "flexel.sweeps.dataset",
    ),
    "Linearization": ("flexel.mechanics.linearization", "flexel.mechanics.modes"),
    "Many variants": ("flexel.results.ensemble", "flexel.results.linearizations"),
    "Errors": ("flexel.base.errors", "flexel.derive.errors"),
    "Pictures": ("flexel.pictures.scene", "flexel.pictures.solids"),
}
RETURNED = {  # functions and options of pictures that are not names of the package itself
    "flexel.linear.tracking": ("Branches", "Boundary"),
    "flexel.results.response": ("FrequencyResponse",),
    "flexel.pictures.scene": ("draw",),
    "flexel.pictures.loci": ("root_loci",),
    "flexel.pictures.view": ("scene_data", "view_modes", "Page"),
}
DECLARATIONS = (
    "flexel.derive.declare.element",
    "flexel.derive.declare.rotation",
    "flexel.derive.declare.shape",
)


def table(head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """Return a table in Markdown, or "None." if there are no rows."""
    lines = [[str(cell).replace("|", r"\|") for cell in row] for row in rows]
    if not lines:
        return "None.\n"
    return "\n".join(f"| {' | '.join(row)} |" for row in [head, ["---"] * len(head), *lines]) + "\n"


def verification(folder: Path) -> dict[str, Rows]:
    """Return the rows of `flexel verify` by element (a law is ``law <name>``), cached by the digests of kernels."""
    digests = {
        f"{prefix}{z.name}": z.digest for prefix, t in (("", ELEMENTS), ("law_", LAWS)) for z in t.values()
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


def parameters(specs: Sequence[ParameterSpec]) -> str:
    """Table of the parameters of an element or a law."""
    return table(("name", "size", "unit", "meaning"), [(f"`{z.name}`", z.size, z.unit, z.doc) for z in specs])


def kernels(specs: dict[str, KernelSpec]) -> str:
    """Table of kernels: inputs, outputs and number of operations."""
    rows = []
    for name, kernel in specs.items():
        written = [f"{z.name} {'×'.join(map(str, z.shape))} ({len(z.nonzeros)})" for z in kernel.outputs]
        rows.append((name, ", ".join(kernel.inputs), ", ".join(written), kernel.operations))
    return table(("kernel", "inputs", "outputs (stored entries)", "operations"), rows)


def errors(rows: Rows) -> str:
    """Table of the verification."""
    return table(
        ("kernel", "output", "against finite differences", "against the definition"),
        [(z["kernel"], z["output"], number(z["differences"]), number(z["reference"])) for z in rows],
    )


def number(value: float | None) -> str:
    """Format an error; a dash if there is none."""
    return "–" if value is None else f"{value:.0e}"


def element_page(spec: ElementSpec, rows: Rows) -> str:
    """Definition, source, kernels, counts and verification of one element."""
    modes = [(f"`{z.name}`", z.unit, "free" if z.free else "rigid", period(z)) for z in spec.deformations]
    slips = [(f"`{z.name}`", z.unit, "free" if z.free else "zero") for z in spec.slips]
    return f"""# {spec.name}

```text
{spec.doc}
```

Source: {spec.source}.

## Nodes

{table(("node", "kind"), [(f"`{z.name}`", z.kind.replace("_", " ")) for z in spec.nodes])}
## Parameters

{parameters(spec.parameters)}
## Deformations

{table(("name", "unit", "default", "period"), modes)}
## Slips

{table(("name", "unit", "default"), slips)}
## Kernels

{kernels(spec.kernels)}
## Verification

Largest relative errors at random configurations, printed by `flexel verify {spec.name}`: against finite differences of
the kernel one order below, and against the definition in 60 digits.

{errors(rows)}"""


def period(spec: DeformationSpec) -> str:
    """The period of a deformation as a formula."""
    terms = []
    for term in spec.period:
        turns = f"{term.factor / (2 * math.pi):g}·2π".removeprefix("1·").replace("-1·", "-")
        terms.append(" ".join([turns, *(name if n == 1 else f"{name}^{n}" for name, _, n in term.powers)]))
    return " + ".join(terms)


def laws_page(rows: dict[str, Rows]) -> str:
    """All laws on one page."""
    parts = [
        "# Laws\n\nA law gives the stress of free deformations and slips. It does not depend on geometry.\n"
        "`m.spring` and `m.stop` attach the common ones, `m.attach` any of them by name.\n"
    ]
    for spec in LAWS.values():
        parts += [
            f"## {spec.name}\n\n```text\n{spec.doc}\n```\n",
            law_facts(spec),
            parameters(spec.parameters),
        ]
        parts += [kernels(spec.kernels), f"Verification:\n\n{errors(rows.get(f'law {spec.name}', []))}"]
    return "\n".join(parts)


def law_facts(spec: LawSpec) -> str:
    """Return the numbers of deformations and slips of a law, and its internal states."""
    states = ", ".join(f"`{z.name}` [{z.unit}]" for z in spec.states) or "none"
    return f"Deformations: {spec.deformations}; slips: {spec.slips}; internal states: {states}.\n"


def directive(name: str, module: str = "flexel") -> str:
    """The autodoc directive of a name."""
    value = getattr(import_module(module), name)
    if not inspect.isclass(value):
        return f".. autofunction:: {module}.{name}\n"
    if issubclass(value, Exception):
        return f".. autoexception:: {module}.{name}\n"
    families = [z for z in value.__mro__[1:] if z.__module__.startswith("flexel.")]
    if not families:
        return f".. autoclass:: {module}.{name}\n   :members:\n"
    # Methods that stand in families of their own; those of Python's own bases, as of a sequence, stay out.
    members = dict.fromkeys(
        key
        for base in (value, *families)
        for key, member in vars(base).items()
        if not key.startswith("_")
        and inspect.getdoc(member)
        and not isinstance(member, str | tuple | int | float)
    )
    return f".. autoclass:: {module}.{name}\n   :members: {', '.join(members)}\n"


def api_pages() -> dict[str, str]:
    """Return the pages of public names by file name: one for each topic, and ``api``, which lists topics and names."""
    titles = {module: title for title, homes in HOMES.items() for module in homes}
    names: dict[str, list[str]] = {title: [] for title in HOMES}
    for name, module in flexel._HOMES.items():
        names[titles[module]].append(name)
    entries = {title: [directive(name) for name in found] for title, found in names.items()}
    for module, given in RETURNED.items():
        entries["Pictures"] += [directive(name, module) for name in given]
        names["Pictures"] += given
    entries["Declaring elements and laws"] = [f".. automodule:: {z}\n   :members:\n" for z in DECLARATIONS]
    slugs = {title: f"api/{title.lower().replace(' ', '-').replace(',', '')}" for title in entries}
    rows = [
        (f"[{title}]({slugs[title]}.md)", ", ".join(f"`{name}`" for name in names.get(title, [])) or "–")
        for title in entries
    ]
    text = "# Public names\n\nAfter `import flexel as fx`, each of these is available as `fx.NAME`, except those of\n"
    text += "the last two topics, whose pages name their modules.\n\n" + table(("topic", "names"), rows)
    text += "\n```{toctree}\n:hidden:\n\n" + "\n".join(slugs.values()) + "\n```\n"
    pages = {
        slugs[title]: f"# {title}\n\n```{{eval-rst}}\n" + "\n".join(found) + "```\n"
        for title, found in entries.items()
    }
    return {"api": text, **pages}


def contents(folder: Path) -> str:
    """Return the tables of contents: guides, systems, reference. A new page in the folder is in one of them."""
    found = {file.stem for file in folder.glob("*.md")} - {"index"}
    systems = [name for name in CASES if name in found]
    guides = [*FIRST, *sorted(found - {*FIRST, *REFERENCE, *systems})]
    elements = ["_generated/elements", "_generated/laws", "_generated/api"]
    groups = {
        "Guides": [*guides, "_generated/gallery/index"],
        "Systems reproduced": systems,
        "Reference": [*REFERENCE, *elements],
    }
    return "\n".join(
        f"```{{toctree}}\n:caption: {caption}\n:maxdepth: 1\n\n" + "\n".join(names) + "\n```\n"
        for caption, names in groups.items()
    )


def elements_page() -> str:
    """The list of element pages."""
    costs = [(f"[{z.name}](elements/{z.name}.md)", z.source, count(z)) for z in ELEMENTS.values()]
    pages = "\n".join(f"elements/{name}" for name in ELEMENTS)
    return (
        "# Elements\n\nEach element is declared in `derive/elements` and added to a model by a method of `Model`:\n"
        "its own, or `Model.element`.\n\n"
        + table(("element", "source", "operations, all kernels"), costs)
        + f"\n```{{toctree}}\n:hidden:\n\n{pages}\n```\n"
    )


def count(spec: ElementSpec) -> int:
    """Operations of all kernels together."""
    return sum(kernel.operations for kernel in spec.kernels.values())


def write(folder: Path) -> None:
    """Write all generated pages under a folder of documentation."""
    out = folder / "_generated"
    rows = verification(out)
    for name, spec in ELEMENTS.items():
        put(out / "elements" / f"{name}.md", element_page(spec, rows.get(name, [])))
    put(out / "elements.md", elements_page())
    put(out / "laws.md", laws_page(rows))
    public = api_pages()
    for name, text in public.items():
        put(out / f"{name}.md", text)
    for file in (out / "api").glob("*.md"):
        if f"api/{file.stem}" not in public:  # of a topic that is gone
            file.unlink()
    put(out / "contents.md", contents(folder))
    write_report(folder, out / "verification.json", out / "report" / "report-latest.html")


if __name__ == "__main__":
    write(Path(__file__).resolve().parent)
