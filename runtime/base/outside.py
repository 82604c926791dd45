"""Types of optional packages, which are imported only when a result is converted to them."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    import matplotlib.figure
    import pandas
    import xarray

Figure: TypeAlias = "matplotlib.figure.Figure"
Dataset: TypeAlias = "xarray.Dataset"
DataFrame: TypeAlias = "pandas.DataFrame"
