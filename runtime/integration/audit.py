"""Audits a motion that has ended: evidence against it from its method and dense output gives warnings and a verdict."""

from __future__ import annotations

from dataclasses import replace

from flexel.base.errors import AuditWarning
from flexel.integration.consistent import misfits
from flexel.integration.driver import Run
from flexel.integration.law_energies import wrong_energies
from flexel.integration.outcome import Integration, States
from flexel.integration.passed import warning
from flexel.integration.rope_ends import at_their_ends
from flexel.integration.wheels_pressed import pulling
from flexel.mechanics.internal_dynamics import growth
from flexel.system import CoreSystem

PLACES = (0.25, 0.5, 1.0)  # parts of a motion at which energies of laws and internal dynamics are looked at


def audited(system: CoreSystem, run: Run, found: Integration) -> Integration:
    """Add the verdict to the result; warnings are issued and kept.

    It looks at the energy balance, contacts that were passed, functions of events, rates of prescribed motions,
    positions that are nearly singular, wheels that would lift, ropes at their ends, vibrations that grow while
    actuators hold a path, and energies of the user's laws.

    Parameters
    ----------
    system : CoreSystem
    run : Run
        That has ended.
    found : Integration
        Its result.
    """
    verdict = []
    balance = run.imbalance()
    if balance is not None:  # a motion that is prescribed has nothing to balance
        verdict.append(str(balance))
        if balance.fails:
            found.warn(run.describe_imbalance(balance), AuditWarning)
    if run.events:
        verdict.append(f"{len(found.events)} event{'s' * (len(found.events) != 1)}")
        for look in run.contradictions():
            found.warn(str(look), AuditWarning)
    passages = run.passages()
    if passages.any:
        verdict.append(f"{len(passages.found) or 'no'} contact{'s' * (len(passages.found) > 1)} passed")
        if passages.found:
            found.warn(warning(passages.found), AuditWarning)
    states = found.states
    for text in misfits(system, states.times[0], states.end):
        found.warn(text, AuditWarning)
    for text in run.dangers():
        found.warn(text, AuditWarning)
    for text in pulling(system.structure, system.roles, states, found.statistics.get("evaluations", 0)):
        found.warn(text, AuditWarning)
    for text in at_their_ends(system.structure, states):
        found.warn(text, AuditWarning)
    for text in _growing(system, states):
        found.warn(text, AuditWarning)
    for text in wrong_energies(system, states.moments(PLACES)):
        found.warn(text, AuditWarning)
    return replace(found, verdict="; ".join(verdict))


def _growing(system: CoreSystem, states: States) -> list[str]:
    """Report vibrations that grow while actuators hold a path, at the first of some states where they do."""
    if not system.roles.actuated:
        return []
    some = (states[round(part * (len(states) - 1))] for part in PLACES)
    duration = states.end - states.times[0]
    found = (growth(system.kinematics_of(state.roles), state, duration) for state in some)
    return [text for text in found if text is not None][:1]
