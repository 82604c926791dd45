"""Small files of the parts of the report, one of each part, without a failure."""

from typing import Any

VERIFY: dict[str, Any] = {
    "ok": True,
    "tolerances": {"differences": 1e-7, "reference": 1e-12},
    "seconds": 12.5,
    "rows": [
        {"element": "truss", "kernel": "position", "output": "De", "differences": 3.4e-11, "reference": 2.2e-16,
         "lanes": True, "note": "", "ok": True},
        {"element": "truss", "kernel": "position", "output": "e", "differences": None, "reference": 1.1e-16,
         "lanes": True, "note": "", "ok": True},
    ],
}  # fmt: skip


def row(name: str, computed: Any, reference: Any, error: float | None, **more: Any) -> dict[str, Any]:
    """A row of `flexel reproduce --json`."""
    kind = "none" if reference is None else more.pop("kind", "closed form")
    return {"name": name, "computed": computed, "reference": reference, "kind": kind, "error": error,
            "tolerance": 1e-3, "tolerance_kind": "absolute", "reason": "", "unit": "m", "source": "Euler & <Bernoulli>",
            "ok": None if reference is None else True, **more}  # fmt: skip


REPRODUCE: dict[str, Any] = {
    "case": "beams",
    "quantities": [
        row("tip", 0.30172, 0.30174, 2e-5, kind="published"),
        row("roots", [[-1.0, 2.5], [-1.0, -2.5]], [[-1.0, 2.5], [-1.0, -2.5]], 0.0, kind="own", complex=True),
        row("shape", [1.0, 2.0, 3.0, 4.0, 5.5], [1.0, 2.0, 3.0, 4.0, 5.4999], 1e-4, kind="other program"),
        row("mass", 12.5, None, None),
        row("sag_error", 6e-5, 0.0, 6e-5, meshes=[8, 16, 32], errors=[1e-3, 2.4e-4, 6e-5], order=2.0),
    ],
    "files": [],
    "seconds": 61.0,
}
BENCH: list[dict[str, Any]] = [
    {"name": "bicycle_rhs", "value": 8.4, "unit": "µs", "error": 2e-11, "target": 6, "goal": 3.5, "accuracy": "x",
     "within": 1e-8, "peers": {"symbrim": {"value": 42.0, "error": 1e-14}, "exudyn": None}},
]  # fmt: skip
CAMPAIGN: dict[str, Any] = {
    "campaign": "property",
    "seed": 71,
    "models": 200,
    "seconds": 95.0,
    "families": {"planar chains": 120, "ropes": 80},
    "properties": [{"name": "energy", "models": 150, "largest": 3.3e-10, "median": 1e-14, "tolerance": 1e-8}],
    "skipped": [{"reason": "no independent equations", "models": 50}],
    "failures": [],
}
SANITIZE: dict[str, Any] = {
    "sanitizers": ["address", "undefined"],
    "steps": [{"command": "python -m flexel verify", "ok": True, "seconds": 40.0}],
    "found": [],
}
FACTS: dict[str, Any] = {
    "verify": {
        "date": "2026-11-22 10:00 UTC",
        "commit": "abc123",
        "seconds": 12.5,
        "facts": {"machine": "Z80"},
    }
}
ALL = {"verify": VERIFY, "reproduce": REPRODUCE, "bench": BENCH, "campaign": CAMPAIGN, "sanitize": SANITIZE}
