"""A parameter study of the hoist on a dask cluster: how the dynamic factor depends on damping and rope.

``python -m flexel.examples.hoist_cluster`` starts two workers on this machine; with the address of a scheduler, such as
``tcp://node:8786``, it uses the cluster there.  Each point computes the rope at rest under the first share of the load,
applies the rest at once, and follows the blow.
The cluster needs dask.distributed, the extra ``cluster``.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import flexel as fx
from flexel.examples.hoist import BLOW, BLOW_STEP, dynamic_factor, peak, simulate
from flexel.examples.hoist_data import HOIST, Hoist

POINTS = {"damping_ratio": [0.03, 0.07, 0.15], "modulus": [0.9e11, 1.1e11]}  # modulus of the rope [N/m²]


def build(damping_ratio: float, modulus: float) -> Hoist:
    """Return the data of the hoist with another damping ratio and modulus of its rope; the analysis lays the rope."""
    return replace(HOIST, damping_ratio=damping_ratio, EA=HOIST.EA * modulus / 1.0e11)


def analyse(data: Hoist) -> dict[str, float]:
    """Compute the largest tension at the drum over that at rest, when the load is applied, with the closed form."""
    results = simulate(data, BLOW, BLOW_STEP, round(1 / BLOW_STEP))
    return {"factor": peak(results.tension[:, 0]) / (data.weight / 4), "closed_form": dynamic_factor(data)}


@contextmanager
def cluster(address: str | None) -> Iterator[Any]:
    """Return a client of the cluster with this address, or of one with two workers here."""
    from distributed import Client, LocalCluster

    if address is not None:
        with Client(address) as client:
            yield client
        return
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as local,
        Client(local) as client,
    ):
        yield client


def study(address: str | None = None) -> Any:
    """Return the dataset of the study."""
    with cluster(address) as client:
        return fx.sweep(build, POINTS, analyse, executor=client)


if __name__ == "__main__":
    print(study(*sys.argv[1:2]))
