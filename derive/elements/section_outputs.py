"""Outputs of beams: the forces in their end sections, and the axis that a picture draws.

The forces on the nodes are De' sigma, so those in the end sections follow from virtual work, exactly in equilibrium,
for any deformations (Besseling 1974): the force from the rows of the points, the moment from the rows f of the Euler
parameters, M = W f/4 with omega = W lambda', the bimoment from the row of the twist per length.  Loads along the
element, including weight and inertia, are lumped at its nodes.
"""

from sympy import Matrix

from flexel.derive.declare import Node, Output
from flexel.derive.declare.rotation import body_angular_velocity, components, dot, product
from flexel.derive.declare.shape import hermite_points
from flexel.derive.elements.shared_parameters import L0, TP, TQ
from flexel.derive.elements.triads import Triad

PLACES = 17  # on the axis of a beam: a smooth line, up to half a turn in one element


def section_forces(
    nodes: tuple[Node, ...], us: tuple[Matrix, Matrix], triads: tuple[Triad, Triad]
) -> tuple[Output, ...]:
    """Return force and moment (and bimoment, with six nodes) in the section at each end, in the section's axes there.

    What a section transmits is what the part towards q exerts on the part towards p: De' sigma at q, its opposite at p.
    """
    found = []
    for k, (end, sign, t) in enumerate((("p", -1, TP), ("q", 1, TQ))):
        point, frame = nodes[2 * k : 2 * k + 2]
        moment = body_angular_velocity(us[k], product(frame.f, t.vector)) / 4
        found.append(Output(f"force_{end}", "N", sign * components(triads[k], point.f)))
        found.append(Output(f"moment_{end}", "N m", sign * moment))
        if len(nodes) > 4:
            found.append(Output(f"bimoment_{end}", "N m^2", sign * nodes[4 + k].f[0]))
    return tuple(found)


def planar_section_forces(
    nodes: tuple[Node, ...], directions: tuple[tuple[Matrix, Matrix], tuple[Matrix, Matrix]]
) -> tuple[Output, ...]:
    """Return the forces along and across the section's normal, and the moment, at each end."""
    found = []
    for k, (end, sign) in enumerate((("p", -1), ("q", 1))):
        point, angle = nodes[2 * k : 2 * k + 2]
        force = Matrix([sign * dot(direction, point.f) for direction in directions[k]])
        found.append(Output(f"force_{end}", "N", force))
        found.append(Output(f"moment_{end}", "N m", sign * angle.f[0]))
    return tuple(found)


def axis(p: Node, q: Node, ends: tuple[tuple[Matrix, ...], tuple[Matrix, ...]]) -> tuple[Output, ...]:
    """Return the axis, cubic as in the kinetic energy, and the directions of the section's y at its ends.

    Parameters
    ----------
    ends : tuple of tuple of Matrix
        Directions ex and ey of the element at p and at q.
    """
    places = hermite_points(p.x, ends[0][0], q.x, ends[1][0], L0.symbol, PLACES)
    across = Matrix.vstack(ends[0][1].T, ends[1][1].T)
    return Output("axis", "m", places, draws="beam"), Output("across", "1", across)
