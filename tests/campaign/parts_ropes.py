"""What the calls of cables, of surfaces and of their contact mean."""

from typing import Any

import numpy as np

from campaign.algebra import across, conjugate, dot, rotated, turned
from campaign.calls import Call, Made
from campaign.contact_twins import Body, Gap, RopeContact, circle, cylinder, line, plane, round_groove, vee
from campaign.parts import Drawing, handler
from campaign.parts_bodies import held_in_body
from campaign.rope_twins import Cable
from campaign.twin import Twin
from flexel.rope.cable_lines import CableLine

UP = (0.0, 0.0, 1.0)


class Line(Made):
    """The cables of a rope as the argument of its contact: name, elements, undeformed lengths, radius."""

    def __init__(self, name: str, elements: tuple[str, ...], s: tuple[float, ...], radius: float) -> None:
        super().__init__("rope.cable_lines.CableLine", (name, elements, (), (), s, radius))

    def value(self) -> CableLine:
        name, elements, points, slopes, s, radius = self.args
        return CableLine(name, elements, points, slopes, np.array(s), radius)


class Surface(Twin):
    """A surface on a body: geometry without any force."""

    def __init__(self, name: str, body: Body, gaps: list[Gap]) -> None:
        self.name, self.nodes, self.body, self.gaps = name, body.nodes, body, gaps


def _body(drawing: Drawing, nodes: tuple[str, str], axes: Any) -> Body:
    """The axes (global, as drawn) as vectors fixed in the body."""
    turn = drawing.x(nodes[1])
    if len(drawing.gravity) == 2:
        return Body(
            nodes, [turned(-turn[0], np.array(e)) for e in axes], lambda angle, e: turned(angle[0], e)
        )
    return Body(nodes, [rotated(conjugate(turn), np.array(e)) for e in axes], rotated)


@handler("slope", options="stretch fixed")
def _slope(drawing: Drawing, call: Call) -> None:
    """Slopes are read by `drawn_nodes`."""


@handler("cable", options="EA EI mass_per_length damping bending_damping")
def _cable(drawing: Drawing, call: Call) -> None:
    name, *nodes, length = call.args
    cable = Cable(name, nodes, length, drawing.gravity, **call.options)
    drawing.twins.append(cable)
    for i, mode in enumerate(cable.elastic.modes):
        drawing.measure(f"{name}.{mode}", cable.nodes, lambda x, i=i: cable.deformations(x)[i], False)


@handler("sheave", options="radius axle groove")
def _sheave(drawing: Drawing, call: Call) -> None:
    name, point, frame = call.args
    radius, groove = call.options["radius"], call.options.get("groove")
    if len(drawing.gravity) == 2:
        drawing.twins.append(Surface(name, _body(drawing, (point, frame), np.eye(2)), circle(radius)))
        return
    axle = np.array(call.options.get("axle", UP), float)
    axes = (axle / np.linalg.norm(axle), *across(axle))
    if groove is None:
        gaps = cylinder(radius)
    elif groove.name == "VGroove":
        gaps = vee(radius, *groove.args)
    else:
        gaps = round_groove(radius, *groove.args)
    drawing.twins.append(Surface(name, _body(drawing, (point, frame), axes), gaps))


@handler("plane", options="normal")
def _plane(drawing: Drawing, call: Call) -> None:
    name, point, frame = call.args
    normal = np.array(call.options["normal"], float)
    normal /= np.linalg.norm(normal)
    if len(drawing.gravity) == 2:
        axes: Any = ((normal[1], -normal[0]), normal)
        drawing.twins.append(Surface(name, _body(drawing, (point, frame), axes), line()))
        return
    first = np.eye(3)[0 if abs(normal[0]) < np.cos(np.radians(25)) else 1]
    first -= (first @ normal) * normal
    first /= np.linalg.norm(first)
    axes = (first, np.cross(normal, first), normal)
    drawing.twins.append(Surface(name, _body(drawing, (point, frame), axes), plane()))


@handler("rope_contact")
def _rope_contact(drawing: Drawing, call: Call) -> None:
    given, surface, law = call.args
    _, elements, _, _, s, radius = given.args
    contact = law.value()
    found = next(z for z in drawing.twins if isinstance(z, Surface) and z.name == surface)
    xi, shares = np.polynomial.legendre.leggauss(contact.points)
    cables = {z.name: z for z in drawing.twins if isinstance(z, Cable)}
    for element, l0 in zip(elements, np.diff(s), strict=True):
        names = [f"{element}@{surface}#{j + 1}" for j in range(contact.points)]
        places, weights = (1 + xi) / 2, shares / 2 * l0
        own = cables[element].nodes, cables[element].l0
        drawing.twins.append(
            RopeContact(names, *own, found.body, found.gaps, radius, places, weights, contact)
        )


@handler("clamp")
def _clamp(drawing: Drawing, call: Call) -> None:
    _clamped(drawing, *call.args)


def _clamped(drawing: Drawing, name: str, frame: str, slope: str) -> None:
    """The slope keeps its direction in the body."""
    d, turn = drawing.x(slope), drawing.x(frame)
    if len(drawing.gravity) == 2:
        side = turned(-turn[0], np.array([-d[1], d[0]]))
        drawing.measure(f"{name}.#1", (frame, slope), lambda x: dot(turned(x[0], side), x[1:]), True)
        return
    for i, e in enumerate(across(d)):
        aside = rotated(conjugate(turn), e)
        drawing.measure(
            f"{name}.#{i}", (frame, slope), lambda x, b=aside: dot(rotated(x[:4], b), x[4:]), True
        )


@handler("anchor")
def _anchor(drawing: Drawing, call: Call) -> None:
    name, point, frame, end, *slope = call.args
    held_in_body(drawing, name, point, frame, end)
    for z in slope:
        _clamped(drawing, f"{name} direction", frame, z)
