"""The property campaign: random models, each held against independent equations of motion and against itself."""
