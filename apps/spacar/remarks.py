"""Notes of the reader: lines without effect, and assumptions where the descriptions are not explicit."""

from __future__ import annotations

from flexel.apps.spacar.converted_elements import TWENTE_BEAMS
from flexel.apps.spacar.element_laws import coefficients
from flexel.apps.spacar.file_entries import ElementEntry
from flexel.apps.spacar.keywords import ROUTINES, VALUES, WITHOUT_EFFECT
from flexel.apps.spacar.prescribed_motions import E_VALUES
from flexel.apps.spacar.problems import numbered
from flexel.apps.spacar.sheet import Sheet

ORIENTATION = "without components: 2, 3 and 4, which determine the first"

SPACARS = (
    'Jw is lumped at its nodes and no twist shortens it, as in SPACAR (warping="vlasov": flexel\'s own beam)'
)
FLEXELS = (
    "flexel's own beam: Jw is spread over the length, and a twist shortens it (warping=\"spacar\": SPACAR's)"
)


def remark(sheet: Sheet) -> None:
    """Note lines without effect and assumptions, for a file without errors."""
    add = sheet.notes.add
    for line in sheet.lines:
        if line.keyword in WITHOUT_EFFECT:
            add(line, f"has no effect: {WITHOUT_EFFECT[line.keyword]}")
        if line.keyword in VALUES and sheet.dialect == "delft" and len(line.values) > 2:
            add(line, "its numbers are components; values are given in lines X, XD, XDD, E, ED, EDD")
        if line.keyword == "ITERSTEP":
            add(line, "only its second number has an effect, the load steps: iterations stop at rounding")
        if line.keyword in ROUTINES:
            what = "stresses and forces" if line.keyword == "USERSIG" else "motions of inputs"
            add(
                line,
                f"'{' '.join(line.words)}' is a program, which is not run: its {what} are missing; flexel convert "
                "writes a function to fill in",
            )
        if line.keyword in ("INPUTE", E_VALUES) and sheet.dialect == "twente":
            entry = sheet.elements[int(line.values[0])]
            named = line.values[1:2] if line.keyword == E_VALUES else line.values[1:]
            chosen = named or range(1, len(entry.kind.modes) + 1)
            if any(sheet.is_dynamic(entry, int(i)) for i in chosen):
                add(line, "no effect, as in SPACAR, on a mode that is DYNE", entry.number)
        if (
            line.keyword in ("INPUTX", "DYNX", "KINX")
            and len(line.values) == 1
            and sheet.node(line).kind == "frame"
        ):
            add(line, ORIENTATION, sheet.node(line).number)
    for entry in sheet.elements.values():
        _element(sheet, entry)


def _element(sheet: Sheet, entry: ElementEntry) -> None:
    add, line, twente = sheet.notes.add, entry.line, sheet.dialect == "twente"
    if entry.kind.assumed:
        add(line, entry.kind.assumed, entry.number)
    if line.keyword == "BEAMW":
        add(line, FLEXELS if entry.vlasov else SPACARS, entry.number)
    if line.keyword == "BEAMNL" or (twente and line.keyword in TWENTE_BEAMS):
        add(line, "with all terms of second order in its deformations, torsion included", entry.number)
    turned = [n for n in entry.nodes if n.kind == "frame" and abs(n.x[0]) < 1 - 1e-12]
    if turned and entry.numbers and line.keyword != "SURFACE":
        add(line, "its direction is read in global axes as drawn, where frames are turned", entry.number)
    stiff = coefficients(entry, "ESTIFF").diagonal() if "ESTIFF" in entry.lines else ()
    rigid = [i for i, value in enumerate(stiff, 1) if value and i not in entry.free]
    if rigid:
        modes = numbered("mode", rigid)
        add(entry.lines["ESTIFF"], f"its stiffness has no effect in {modes}, rigid here", entry.number)
    inertia = entry.values("EMASS")
    if twente and line.keyword in TWENTE_BEAMS and len(inertia) > 4 and inertia[4]:
        add(entry.lines["EMASS"], "Jyz is read as a component of the tensor, as those of XM", entry.number)
