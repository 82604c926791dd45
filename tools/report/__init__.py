"""The report: one HTML page about all checks and the errors found, from the JSON files of the commands.

`parts` reads the files, one module writes each section (`kernel_errors`, `systems`, `convergence_errors`, `campaign`,
`sanitizers`, `speed`), `page` puts them together, `making` runs the commands that write the files.
"""
