"""SPACAR's input files: read, run, analysed and converted to Python.

`reading` is the entry point; `lexer`, `keywords`, `sheet`, `semantics` and `elements` parse the language,
`statements` and `convert` print it as Python, `linear` and `run` are the analyses.
"""
