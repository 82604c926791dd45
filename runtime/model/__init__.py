"""The model as index maps: nodes, instances, quantities, roles, loads, states."""
