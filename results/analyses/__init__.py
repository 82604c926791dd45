"""Analyses: functions of a system, which `flexel.System` has as methods."""
