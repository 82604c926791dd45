"""Functions of time that users write themselves."""

from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass(frozen=True)
class Formula:
    """A function of time by its text, such as ``np.minimum(t, 0.3)``."""

    text: str

    def __call__(self, t: Any) -> Any:
        """Its value."""
        return eval(self.text, {"np": np, "t": t})
