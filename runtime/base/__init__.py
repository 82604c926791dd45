"""What everything stands on: errors, checks of arguments, quaternions, units, functions of time."""
