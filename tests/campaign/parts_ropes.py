"""What cables, surfaces and of their contact mean."""

from typing import Any

import numpy as np

import flexel as fx
from campaign.algebra import across, conjugate, dot, rotated, turned
from campaign.contact_twins import Body, Gap, RopeContact, circle, cylinder, plane, round_groove, vee
from campaign.contact_twins import line as straight
from campaign.known_lines import KnownLine
from campaign.parts import Drawing, handler, options_of
from campaign.parts_bodies import held_in_body
from campaign.rope_twins import Cable
from campaign.twin import Twin
from flexel.parts import cables, rope_contacts, rope_surfaces

UP = (0.0, 0.0, 1.0)


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


@handler(cables.Cable, options="length EA EI mass_per_length damping bending_damping")
def _cable(drawing: Drawing, part: cables.Cable) -> None:
    name, *nodes = map(str, (part.name, part.p, part.slope_p, part.q, part.slope_q))
    given = options_of(part)
    cable = Cable(name, nodes, given.pop("length"), drawing.gravity, **given)
    drawing.twins.append(cable)
    for i, mode in enumerate(cable.elastic.modes):
        drawing.measure(f"{name}.{mode}", cable.nodes, lambda x, i=i: cable.deformations(x)[i], False)


@handler(rope_surfaces.Sheave, options="axle groove")
def _sheave(drawing: Drawing, part: rope_surfaces.Sheave) -> None:
    name, point, frame = part.name, str(part.point), str(part.frame)
    radius, groove = part.radius, part.groove
    if len(drawing.gravity) == 2:
        drawing.twins.append(Surface(name, _body(drawing, (point, frame), np.eye(2)), circle(radius)))
        return
    axle = np.array(part.axle, float)
    axes = (axle / np.linalg.norm(axle), *across(axle))
    if groove is None:
        gaps = cylinder(radius)
    elif isinstance(groove, fx.VGroove):
        gaps = vee(radius, groove.opening)
    else:
        assert isinstance(groove, fx.RoundGroove)
        gaps = round_groove(radius, groove.radius, groove.opening)
    drawing.twins.append(Surface(name, _body(drawing, (point, frame), axes), gaps))


@handler(rope_surfaces.Plane, options="normal")
def _plane(drawing: Drawing, part: rope_surfaces.Plane) -> None:
    name, point, frame = part.name, str(part.point), str(part.frame)
    normal = np.array(part.normal, float)
    normal /= np.linalg.norm(normal)
    if len(drawing.gravity) == 2:
        axes: Any = ((normal[1], -normal[0]), normal)
        drawing.twins.append(Surface(name, _body(drawing, (point, frame), axes), straight()))
        return
    first = np.eye(3)[0 if abs(normal[0]) < np.cos(np.radians(25)) else 1]
    first -= (first @ normal) * normal
    first /= np.linalg.norm(first)
    axes = (first, np.cross(normal, first), normal)
    drawing.twins.append(Surface(name, _body(drawing, (point, frame), axes), plane()))


@handler(KnownLine)
def _line(drawing: Drawing, part: KnownLine) -> None:
    drawing.lines[part.name] = part


@handler(rope_contacts.RopeContact)
def _rope_contact(drawing: Drawing, part: rope_contacts.RopeContact) -> None:
    line, surface, contact = drawing.lines[str(part.cables)], str(part.surface), part.contact
    elements, s, radius = line.elements, line.s, line.radius
    found = next(twin for twin in drawing.twins if isinstance(twin, Surface) and twin.name == surface)
    xi, shares = np.polynomial.legendre.leggauss(contact.points)
    cables = {twin.name: twin for twin in drawing.twins if isinstance(twin, Cable)}
    for element, l0 in zip(elements, np.diff(s), strict=True):
        names = [f"{element}@{surface}#{j + 1}" for j in range(contact.points)]
        places, weights = (1 + xi) / 2, shares / 2 * l0
        own = cables[element].nodes, cables[element].l0
        drawing.twins.append(
            RopeContact(names, *own, found.body, found.gaps, radius, places, weights, contact)
        )


@handler(cables.Clamp)
def _clamp(drawing: Drawing, part: cables.Clamp) -> None:
    _clamped(drawing, part.name, str(part.frame), str(part.slope))


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


@handler(cables.Anchor, options="slope")
def _anchor(drawing: Drawing, part: cables.Anchor) -> None:
    held_in_body(drawing, part.name, str(part.point), str(part.frame), str(part.end))
    if part.slope is not None:
        _clamped(drawing, f"{part.name} direction", str(part.frame), str(part.slope))
