"""Loads: generalized forces dual to named coordinates, deformations and slips, and the methods of `Model`.

A positive load does positive work when its quantity grows.  On a coordinate it is a nodal force; on a
deformation or slip it is an applied stress of the opposite sign.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from flexel.base.arguments import flag, unknown
from flexel.base.errors import ModelError
from flexel.base.time_functions import Polynomial, as_function
from flexel.declare.declarations import Declarations
from flexel.generated.table import ELEMENTS
from flexel.structure.instances import Instance
from flexel.structure.loads import Load
from flexel.structure.nodes import SENSORS, Node


class Loading(Declarations):
    """Forces, moments and generalized forces."""

    def load(self, target: Node | str, value: Any, *, follower: bool | Node | str = False) -> None:
        """Apply a force, moment or generalized force, constant or a function of time.

        Parameters
        ----------
        target : node or name
            A point takes a force vector [N] in global axes (with ``follower=frame`` in the axes of that frame); a frame
            a moment vector [N m] about global axes (with ``follower=True`` about body axes); a coordinate, deformation
            or slip a generalized force, positive when it does positive work as the quantity grows.
        value : number or function of time, or a sequence of them for a node
        """
        if isinstance(target, str) and "." in target:
            if follower is not False:
                raise ModelError(f"load on '{target}': follower loads act on frames; leave follower out")
            self._quantity_kind(target, f"load on '{target}'")
            self.loads.append(Load(target, as_function(value, f"load on '{target}'")))
            return
        node = self._find_node(target, "load")
        owner = f"load on '{node.name}'"
        _check_follower(node, follower, owner)
        if np.all(node.fixed):
            raise ModelError(f"{owner}: this node is fixed and cannot move; remove the load or the fixing")
        if node.kind in ("point", "planar_point") and follower:
            quantities = _follower_slips(self, node, follower, owner)
        elif node.kind == "frame":
            quantities = [f"{sensor(self, node, bool(follower))}.{w}" for w in ("wx", "wy", "wz")]
        else:
            quantities = list(node.coordinates)
        for quantity, component in zip(quantities, _components(value, len(quantities), owner), strict=True):
            function = as_function(component, owner)
            if function != Polynomial((0.0,)):
                self.loads.append(Load(quantity, function))

    def distributed_load(self, beam: str, value: Any) -> None:
        """Load a beam, truss or cable evenly along its length.

        Parameters
        ----------
        beam : str
            Name of a beam (flexible or rigid), truss or cable.
        value : sequence of numbers or functions of time
            Force per undeformed length [N/m] in global axes; the nodal forces and moments are the consistent ones.

        Raises
        ------
        ModelError
            Unknown name, an element without length, wrong number of components.
        """
        owner = f"distributed load on '{beam}'"
        if not isinstance(beam, str) or beam not in self.instances:
            raise ModelError(f"{owner}: {unknown(str(beam), self.instances, 'element')}")
        loaded = self.instances[beam]
        if not loaded.spec.span:
            raise ModelError(f"{owner}: a {loaded.spec.name} has no span; load a beam, truss or cable")
        spec = ELEMENTS[loaded.spec.span]
        name = f"{beam}.span"
        if name not in self.instances:
            nodes = (
                (loaded.nodes[0], loaded.nodes[-1])
                if len(spec.nodes) == 2
                else loaded.nodes[: len(spec.nodes)]
            )
            values = {z.name: loaded.parameters[z.name] for z in spec.parameters}
            self.instances[name] = Instance(name, spec, nodes, values)
        axes = [slip.name for slip in spec.slips]
        for axis, component in zip(axes, _components(value, len(axes), owner), strict=True):
            function = as_function(component, owner)
            if function != Polynomial((0.0,)):
                self.loads.append(Load(f"{name}.{axis}", function))

    def angular_velocity(self, frame: Node | str, body_axes: bool = False) -> str:
        """Measure a frame's angular velocity; its components are the slips ``<returned name>.wx``, ``wy``, ``wz``."""
        own = flag(body_axes, "angular_velocity", "body_axes")
        return sensor(self, self._find_of_kind(frame, ("frame",), "angular_velocity"), own)


def _check_follower(node: Node, follower: bool | Node | str, owner: str) -> None:
    """A frame's moment follows itself (True); a point's force follows a named frame; an angle's cannot follow."""
    if not isinstance(follower, (bool, np.bool_, Node, str)):
        raise ModelError(f"{owner}: follower {follower!r:.60} is neither True nor a frame; give one of them")
    if node.kind in ("planar_angle", "warping") and follower:
        what = "bimoment" if node.kind == "warping" else "planar moment"
        raise ModelError(f"{owner}: a {what} has no direction to follow; leave follower out")
    if node.kind == "frame" and not isinstance(follower, bool):
        raise ModelError(f"{owner}: a moment follows its own frame; write follower=True")
    if node.kind in ("point", "planar_point") and follower is True:
        raise ModelError(f"{owner}: a point has no axes for the force to follow; write follower=frame")


def _follower_slips(model: Declarations, point: Node, frame: Any, owner: str) -> list[str]:
    """Slips of the element that measures a point's velocity in a frame's axes; created when first needed."""
    planar = point.kind == "planar_point"
    body = model._find_of_kind(frame, ("planar_angle" if planar else "frame",), owner)
    name = f"{point.name}.in {body.name}"
    if name not in model.instances:
        spec = ELEMENTS["planar_body_velocity" if planar else "body_velocity"]
        model.instances[name] = Instance(name, spec, (point.name, body.name), {})
    return [f"{name}.{v}" for v in (("vx", "vy") if planar else ("vx", "vy", "vz"))]


def _components(value: Any, size: int, owner: str) -> list[Any]:
    if size == 1 and not isinstance(value, (list, tuple)):
        return [value]
    if not isinstance(value, (list, tuple, np.ndarray)):
        raise ModelError(
            f"{owner}: {value!r} given; it takes a list of {size} components, each a number or a function of time"
        )
    if len(value) != size:
        raise ModelError(f"{owner}: {len(value)} components given; it takes {size}")
    return list(value)


def sensor(model: Declarations, frame: Node, body_axes: bool) -> str:
    """The element that measures (and can load) a frame's angular velocity; created when first needed."""
    name = f"{frame.name}.{SENSORS[body_axes]}"
    if name not in model.instances:
        spec = ELEMENTS["body_rotation" if body_axes else "rotation"]
        values = {z.name: np.array([1.0, 0.0, 0.0, 0.0]) for z in spec.parameters}
        model.instances[name] = Instance(name, spec, (frame.name,), values)
    return name
