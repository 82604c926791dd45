"""Results in files and tables, and states restored from them."""
