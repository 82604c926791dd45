"""Results in files and tables, and states that are restored from them."""
