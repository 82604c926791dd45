"""The property campaign: random models, each compared with independent equations of motion and against itself."""
