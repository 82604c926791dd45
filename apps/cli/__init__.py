"""The commands of `flexel`, one per module; their table is in `flexel.apps.cli.main`."""
