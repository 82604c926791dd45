"""Kernels of another derivation than the table's are refused, not run."""

from dataclasses import replace

import pytest

import flexel as fx
from flexel.engine.batches import kernel_struct
from flexel.generated.table import ELEMENTS, LAWS


@pytest.mark.parametrize("spec", [*ELEMENTS.values(), *LAWS.values()], ids=lambda spec: spec.name)
def test_table_and_compiled_kernels_are_of_one_derivation(spec: object) -> None:
    kernel_struct(spec, None)  # type: ignore[arg-type]


def test_kernels_of_another_derivation_are_refused_by_name() -> None:
    other = replace(ELEMENTS["truss"], digest="0" * 16)
    with pytest.raises(fx.FlexelError, match="'truss' do not match generated.*pip install -e"):
        kernel_struct(other, None)
