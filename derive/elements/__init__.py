"""The table of elements: one file for each element or close family. A new one is a file and a line."""

from flexel.derive.declare import Element
from flexel.derive.elements.beam import BEAM, BEAM_FIRST_ORDER
from flexel.derive.elements.beam3 import BEAM3
from flexel.derive.elements.beam_logarithmic import BEAM_LOGARITHMIC
from flexel.derive.elements.beam_warping import BEAM_WARPING
from flexel.derive.elements.bearing import BEARING
from flexel.derive.elements.body import BODY, POINT_MASS
from flexel.derive.elements.body_velocity import BODY_VELOCITY, PLANAR_BODY_VELOCITY
from flexel.derive.elements.cable import CABLE, PLANAR_CABLE
from flexel.derive.elements.flat_cam import FLAT_CAM, PLANAR_FLAT_CAM
from flexel.derive.elements.hinge import HINGE
from flexel.derive.elements.norm import NORM
from flexel.derive.elements.planar_beam import PLANAR_BEAM, PLANAR_BEAM_FIRST_ORDER
from flexel.derive.elements.planar_beam3 import PLANAR_BEAM3
from flexel.derive.elements.planar_beam_logarithmic import PLANAR_BEAM_LOGARITHMIC
from flexel.derive.elements.planar_bearing import PLANAR_BEARING
from flexel.derive.elements.planar_belt import PLANAR_BELT
from flexel.derive.elements.planar_body import PLANAR_BODY, PLANAR_POINT_MASS
from flexel.derive.elements.planar_gear import PLANAR_GEAR
from flexel.derive.elements.planar_hinge import PLANAR_HINGE
from flexel.derive.elements.planar_point_contact import PLANAR_DISC_CONTACTS, PLANAR_POINT_CONTACTS
from flexel.derive.elements.planar_rope_contact import PLANAR_CABLE_CIRCLE, PLANAR_CABLE_LINE
from flexel.derive.elements.planar_wheel import PLANAR_WHEEL
from flexel.derive.elements.point_contact import POINT_CONTACTS, SPHERE_CONTACTS
from flexel.derive.elements.roller_cam import PLANAR_ROLLER_CAM, ROLLER_CAM
from flexel.derive.elements.rope_contact import (
    CABLE_CYLINDER,
    CABLE_HELICAL_GROOVE,
    CABLE_PLANE,
    CABLE_ROUND_GROOVE,
    CABLE_V_GROOVE,
)
from flexel.derive.elements.rotary_inertia import PLANAR_ROTARY_INERTIA, ROTARY_INERTIA, WARPING_INERTIA
from flexel.derive.elements.rotation_slips import BODY_ROTATION, ROTATION
from flexel.derive.elements.skate import PLANAR_SKATE, SKATE
from flexel.derive.elements.slope_clamp import PLANAR_SLOPE_CLAMP, SLOPE_CLAMP
from flexel.derive.elements.span_slips import (
    BAR_SPAN,
    BEAM_SPAN,
    CABLE_SPAN,
    PLANAR_BAR_SPAN,
    PLANAR_BEAM_SPAN,
    PLANAR_CABLE_SPAN,
)
from flexel.derive.elements.surface import SURFACE
from flexel.derive.elements.truss import PLANAR_TRUSS, TRUSS
from flexel.derive.elements.tyre import AXLE_SLIP, TYRE, TYRE_ON_ROAD
from flexel.derive.elements.wheel import TOROIDAL_WHEEL, WHEEL

ELEMENTS: tuple[Element, ...] = (
    POINT_MASS,
    BODY,
    ROTARY_INERTIA,
    WARPING_INERTIA,
    NORM,
    TRUSS,
    HINGE,
    BEARING,
    BEAM3,
    BEAM,
    BEAM_FIRST_ORDER,
    BEAM_WARPING,
    BEAM_LOGARITHMIC,
    WHEEL,
    SURFACE,
    TOROIDAL_WHEEL,
    TYRE,
    TYRE_ON_ROAD,
    AXLE_SLIP,
    ROTATION,
    BODY_ROTATION,
    BODY_VELOCITY,
    BAR_SPAN,
    BEAM_SPAN,
    SKATE,
    ROLLER_CAM,
    FLAT_CAM,
    PLANAR_POINT_MASS,
    PLANAR_BODY,
    PLANAR_ROTARY_INERTIA,
    PLANAR_TRUSS,
    PLANAR_HINGE,
    PLANAR_BEAM,
    PLANAR_BEAM_FIRST_ORDER,
    PLANAR_BEAM_LOGARITHMIC,
    PLANAR_BEAM3,
    PLANAR_BEARING,
    PLANAR_BELT,
    PLANAR_GEAR,
    PLANAR_WHEEL,
    PLANAR_SKATE,
    PLANAR_ROLLER_CAM,
    PLANAR_FLAT_CAM,
    PLANAR_BODY_VELOCITY,
    PLANAR_BAR_SPAN,
    PLANAR_BEAM_SPAN,
    CABLE,
    SLOPE_CLAMP,
    CABLE_SPAN,
    CABLE_CYLINDER,
    CABLE_PLANE,
    CABLE_V_GROOVE,
    CABLE_ROUND_GROOVE,
    CABLE_HELICAL_GROOVE,
    *POINT_CONTACTS,
    *SPHERE_CONTACTS,
    PLANAR_CABLE,
    PLANAR_SLOPE_CLAMP,
    PLANAR_CABLE_SPAN,
    PLANAR_CABLE_CIRCLE,
    PLANAR_CABLE_LINE,
    *PLANAR_POINT_CONTACTS,
    *PLANAR_DISC_CONTACTS,
)
