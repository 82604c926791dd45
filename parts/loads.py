"""Loads: generalized forces dual to named coordinates, deformations and slips.

A positive load does positive work when its quantity grows.  On a coordinate it is a nodal force; on a
deformation or slip it is an applied stress of the opposite sign.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY
from typing import Any

import numpy as np

from flexel.base.arguments import flag, unknown
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry
from flexel.base.time_functions import Polynomial, as_function
from flexel.generated.table import ELEMENTS
from flexel.model.applied_loads import Load
from flexel.model.instances import Instance
from flexel.model.lowering import Lowering
from flexel.model.node import SENSORS, Node
from flexel.model.part import Part, part


@part
class LoadPart(Part[None]):
    """Apply a force, moment or generalized force, constant or a function of time."""

    target: Node | str = entry(
        "A point takes a force vector [N] in global axes (with ``follower=frame`` in the axes of that frame); a frame "
        "a moment vector [N m] about global axes (with ``follower=True`` about body axes); a coordinate, deformation "
        "or slip a generalized force, positive when it does positive work as the quantity grows.",
        form="node or str",
    )
    value: Any = array_quantity(
        "",
        "Force or moment, in the unit of the target; its components for a node.",
        form="float, function of time, or sequence of them",
    )
    _: KW_ONLY
    follower: bool | Node | str = entry(
        "Whether the moment on a frame turns with it; for a force on a point, the frame with which it turns.",
        default=False,
    )

    @property
    def owner(self) -> str:
        """The load, by its target."""
        return f"load on '{self.target.name if isinstance(self.target, Node) else self.target}'"

    @property
    def label(self) -> str:
        """By its target."""
        return f"load {self.target.name if isinstance(self.target, Node) else self.target}"

    def lower(self, to: Lowering) -> None:
        """Add a load for each component that is not zero."""
        if isinstance(self.target, str) and "." in self.target:
            if self.follower is not False:
                raise ModelError(f"{self.owner}: follower loads act on frames; leave follower out")
            to.quantity_kind(self.target, self.owner)
            to.loads.append(Load(self.target, as_function(self.value, self.owner)))
            return
        node = to.find_node(self.target, "load")
        _check_follower(node, self.follower, self.owner)
        if np.all(node.fixed):
            raise ModelError(
                f"{self.owner}: this node is fixed and cannot move; remove the load or the fixing"
            )
        if node.kind in ("point", "planar_point") and self.follower:
            quantities = _follower_slips(to, node, self.follower, self.owner)
        elif node.kind == "frame":
            measured = sensor(to, node, bool(self.follower))
            quantities = [f"{measured}.{rate}" for rate in ("wx", "wy", "wz")]
        else:
            quantities = list(node.coordinates)
        _add_components(to, self.owner, quantities, self.value)


@part
class DistributedLoad(Part[None]):
    """Load a beam, truss or cable uniformly along its length.

    Raises
    ------
    ModelError
        An unknown name, an element without length, a wrong number of components.
    """

    beam: str = entry("Name of a beam (flexible or rigid), truss or cable.")
    value: Any = array_quantity(
        "N/m",
        "Components in global axes of the force per undeformed length [], applied as consistent nodal forces and "
        "moments.",
        form="sequence of float or functions of time",
    )

    @property
    def owner(self) -> str:
        """The load, by its beam."""
        return f"distributed load on '{self.beam}'"

    @property
    def label(self) -> str:
        """By its beam."""
        return f"distributed_load {self.beam}"

    def lower(self, to: Lowering) -> None:
        """Add the element of the span when it is first needed, and a load for each component that is not zero."""
        if not isinstance(self.beam, str) or self.beam not in to.instances:
            raise ModelError(f"{self.owner}: {unknown(str(self.beam), to.instances, 'element')}")
        loaded = to.instances[self.beam]
        if not loaded.spec.span:
            raise ModelError(f"{self.owner}: a {loaded.spec.name} has no span; load a beam, truss or cable")
        spec = ELEMENTS[loaded.spec.span]
        name = f"{self.beam}.span"
        if name not in to.instances:
            nodes = (
                (loaded.nodes[0], loaded.nodes[-1])
                if len(spec.nodes) == 2
                else loaded.nodes[: len(spec.nodes)]
            )
            values = {parameter.name: loaded.parameters[parameter.name] for parameter in spec.parameters}
            to.instances[name] = Instance(name, spec, nodes, values)
        _add_components(to, self.owner, [f"{name}.{slip.name}" for slip in spec.slips], self.value)


@part
class AngularVelocity(Part[str]):
    """Measure a frame's angular velocity; its components are the slips ``<returned name>.wx``, ``wy``, ``wz``.

    Returns
    -------
    str
        Name of the element that measures it.
    """

    frame: Node | str = entry("Frame whose angular velocity is measured.")
    body_axes: bool = entry("Measure in the frame's axes instead of the global ones.", default=False)

    @property
    def owner(self) -> str:
        """The call, which has no name."""
        return "angular_velocity"

    def lower(self, to: Lowering) -> str:
        """Add the element that measures it when it is first needed."""
        own = flag(self.body_axes, self.owner, "body_axes")
        return sensor(to, to.find_of_kind(self.frame, ("frame",), self.owner), own)


def sensor(to: Lowering, frame: Node, body_axes: bool) -> str:
    """Return the element that measures (and can load) a frame's angular velocity; created when first needed."""
    name = f"{frame.name}.{SENSORS[body_axes]}"
    if name not in to.instances:
        spec = ELEMENTS["body_rotation" if body_axes else "rotation"]
        values = {parameter.name: np.array([1.0, 0.0, 0.0, 0.0]) for parameter in spec.parameters}
        to.instances[name] = Instance(name, spec, (frame.name,), values)
    return name


def _check_follower(node: Node, follower: bool | Node | str, owner: str) -> None:
    """Check what a load follows: a frame's moment itself (True), a point's force a named frame, an angle's nothing."""
    if not isinstance(follower, (bool, np.bool_, Node, str)):
        raise ModelError(f"{owner}: follower {follower!r:.60} is neither True nor a frame; give one of them")
    if node.kind in ("planar_angle", "warping") and follower:
        what = "bimoment" if node.kind == "warping" else "planar moment"
        raise ModelError(f"{owner}: a {what} has no direction to follow; leave follower out")
    if node.kind == "frame" and not isinstance(follower, bool):
        raise ModelError(f"{owner}: a moment follows the frame it acts on; write follower=True")
    if node.kind in ("point", "planar_point") and follower is True:
        raise ModelError(f"{owner}: a point has no axes for the force to follow; write follower=frame")


def _follower_slips(to: Lowering, point: Node, frame: Any, owner: str) -> list[str]:
    """Return slips of the element that measures a point's velocity in a frame's axes; created when first needed."""
    planar = point.kind == "planar_point"
    body = to.find_of_kind(frame, ("planar_angle" if planar else "frame",), owner)
    name = f"{point.name}.in {body.name}"
    if name not in to.instances:
        spec = ELEMENTS["planar_body_velocity" if planar else "body_velocity"]
        to.instances[name] = Instance(name, spec, (point.name, body.name), {})
    return [f"{name}.{velocity}" for velocity in (("vx", "vy") if planar else ("vx", "vy", "vz"))]


def _add_components(to: Lowering, owner: str, quantities: Sequence[str], value: Any) -> None:
    """Add a load on each quantity whose component is not zero."""
    for quantity, component in zip(quantities, _components(value, len(quantities), owner), strict=True):
        function = as_function(component, owner)
        if function != Polynomial((0.0,)):
            to.loads.append(Load(quantity, function))


def _components(value: Any, size: int, owner: str) -> list[Any]:
    """Return the components of a load, as many as are needed."""
    if size == 1 and not isinstance(value, (list, tuple)):
        return [value]
    if not isinstance(value, (list, tuple, np.ndarray)):
        raise ModelError(
            f"{owner}: {value!r} given; it takes a list of {size} components, each a number or a function of time"
        )
    if len(value) != size:
        raise ModelError(f"{owner}: {len(value)} components given; it takes {size}")
    return list(value)
