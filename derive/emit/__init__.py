"""From programs to text: C, the table of specifications, and the files of ``generated/``."""
