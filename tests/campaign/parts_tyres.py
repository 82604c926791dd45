"""What the calls of tyres and of their laws mean."""

from campaign.calls import Call
from campaign.parts import Drawing, handler
from campaign.tyre_twins import LAWS, PLACES, RATES, Tyre, TyreForces

LAW = (
    "name initial stiffness damping cornering camber_stiffness trail standstill A B SN AF load0 rolling_radius "
    "friction slip_stiffness shape relaxation"
)


@handler("tyre", options="radius axle normal height crown road")
def _tyre(drawing: Drawing, call: Call) -> None:
    name, hub, frame = call.args
    tyre = Tyre(name, (hub, frame), drawing.x(frame), call.options)
    drawing.twins.append(tyre)
    for i, place in enumerate(PLACES):
        drawing.measure(f"{name}.{place}", tyre.nodes, lambda x, i=i: tyre.places(x)[i], False)
    for i, rate in enumerate(RATES):
        drawing.slip(f"{name}.{rate}", tyre.nodes, lambda x, i=i: tyre.rows(x)[i], False)


@handler("attach", options=LAW)
def _attach(drawing: Drawing, call: Call) -> None:
    law, on = call.args
    if law not in LAWS:
        raise KeyError(f"no twin of the law {law}")
    name, _, part = on[0].rpartition(".")
    tyre = next(z for z in drawing.twins if isinstance(z, Tyre) and z.name == name)
    parameters = {key: z for key, z in call.options.items() if key not in ("name", "initial")}
    drawing.twins.append(TyreForces(tyre, law, call.options.get("name", ""), parameters, part))
