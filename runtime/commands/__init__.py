"""The commands of `flexel`, one in each room; the table of them is `flexel.commands.main`."""
