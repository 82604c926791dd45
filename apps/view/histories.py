"""Plots time histories of named quantities, of one motion or of several for comparison."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from flexel.apps.view.figures import COLOURS, axis_label, caption, panels, save
from flexel.base.arguments import quantities
from flexel.base.errors import ModelError
from flexel.base.shown import listed

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STYLES = ("-", "--", ":", "-.")  # line styles of the compared motions


def plot_histories(
    motion: Any,
    names: Sequence[str | Sequence[str]],
    path: str | Path | None = None,
    *,
    against: Any = (),
    labels: Sequence[str] = (),
    title: str = "",
) -> Figure:
    """Plot time histories, with separate axes for each unit; see `Motion.plot`."""
    motions = _motions(motion, against)
    called = _labels(labels, len(motions))
    groups = list(_groups(motion, names or motion.dofs))
    with panels(len(groups)) as (drawn, axes):
        number = 0
        for panel, (members, unit) in zip(axes[:, 0], groups, strict=True):
            several = len(members) > 1
            for i, name in enumerate(members):
                for j, (one, label) in enumerate(zip(motions, called, strict=True)):
                    colour = number + i if several or len(motions) == 1 else j
                    full = ", ".join(word for word in (name if several or not label else "", label) if word)
                    panel.plot(
                        one.t,
                        one.series(name)[0],
                        STYLES[j % 4],
                        color=COLOURS[colour % len(COLOURS)],
                        label=full,
                    )
            number += len(members)
            panel.set_ylabel(axis_label(members, unit))
            if several or len(motions) > 1:
                panel.legend(loc="best")
        start, end = min(motion.t[0] for motion in motions), max(motion.t[-1] for motion in motions)
        label, over = ("time [s]", "time") if motion.over_time else ("load parameter", "the load")
        axes[-1, 0].set_xlabel(label)
        if end > start:  # a motion interrupted immediately has only one state
            axes[-1, 0].set_xlim(start, end)
        shown = [name for members, _ in groups for name in members]
        axes[0, 0].set_title(caption(title, "plot") or f"{listed(shown, 4)} over {over}")
        drawn.align_ylabels()
    save(drawn, path)
    return drawn


def _motions(motion: Any, against: Any) -> list[Any]:
    """Return the motion and those to compare with it; for a periodic solution, its period."""
    given = list(against) if isinstance(against, list | tuple) else [against]
    found = [motion]
    for other in given:
        one = getattr(other, "motion", other)
        if not hasattr(one, "series"):
            raise ModelError(f"plot: against {other!r}; give a motion, or a list of motions")
        found.append(one)
    return found


def _labels(labels: Sequence[str], count: int) -> list[str]:
    if isinstance(labels, str) or not isinstance(labels, list | tuple):
        raise ModelError(f"plot: labels {labels!r}; give a list with a name for each motion")
    if labels and len(labels) != count:
        raise ModelError(
            f"plot: {len(labels)} labels for {count} motions; give one for each, this motion's first"
        )
    if not labels:
        return [""] if count == 1 else [f"motion {i + 1}" for i in range(count)]
    return [caption(label, "plot", "label") for label in labels]


def _groups(motion: Any, names: Sequence[str | Sequence[str]]) -> Iterator[tuple[list[str], str]]:
    """Return the names that share axes, with their unit: lists as given, other names grouped by unit."""
    alone: dict[str, list[str]] = {}
    order: list[list[str] | str] = []
    for entry in names:
        if not isinstance(entry, str) and isinstance(entry, Sequence):
            order.append(list(quantities(entry, "plot")))
            continue
        quantities([entry], "plot")
        unit = motion.series(entry)[1]
        if unit not in alone:
            order.append(unit)
        if entry not in alone.setdefault(unit, []):
            alone[unit].append(entry)
    for group in order:
        if isinstance(group, str):
            yield alone[group], group
            continue
        units = {name: motion.series(name)[1] for name in group}
        if not group or len(set(units.values())) > 1:
            raise ModelError(
                f"plot: {units} in one list; give names of one unit, as each list has its own axes"
            )
        yield group, next(iter(units.values()))
