"""What tyres and their laws mean."""

from campaign.parts import Drawing, handler
from campaign.tyre_twins import LAWS, PLACES, RATES, Tyre, TyreForces
from flexel.parts import wheels
from flexel.parts.laws import AttachedLaw


@handler(wheels.Tyre, options="normal height crown road")
def _tyre(drawing: Drawing, part: wheels.Tyre) -> None:
    tyre = Tyre(part, drawing.x(str(part.frame)))
    drawing.twins.append(tyre)
    for i, place in enumerate(PLACES):
        drawing.measure(f"{tyre.name}.{place}", tyre.nodes, lambda x, i=i: tyre.places(x)[i], False)
    for i, rate in enumerate(RATES):
        drawing.slip(f"{tyre.name}.{rate}", tyre.nodes, lambda x, i=i: tyre.rows(x)[i], False)


@handler(AttachedLaw, options="name initial parameters")
def _attach(drawing: Drawing, part: AttachedLaw) -> None:
    if part.law not in LAWS:
        raise KeyError(f"no twin of the law {part.law}")
    name, _, place = str(part.on[0]).rpartition(".")
    tyre = next(twin for twin in drawing.twins if isinstance(twin, Tyre) and twin.name == name)
    drawing.twins.append(TyreForces(tyre, part.law, part.name or "", part.parameters or {}, place))
