"""The report: one page in HTML that says what was checked, with which errors, from the JSON files of the commands.

`parts` reads the files, one module writes each section (`kernels`, `systems`, `convergence`, `campaign`, `sanitizers`,
`speed`), `page` puts them together, `making` runs the commands that write the files.
"""
