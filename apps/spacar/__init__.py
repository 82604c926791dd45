"""SPACAR's input files: read, run, analysed and converted to Python.

`reading` is the entry point; `lexer`, `keywords` and `sheet` parse the language, `semantics` and `converted_elements`
convert it to the parts of a model, `python_program` writes these as Python, `linear_analyses` and `run_file` perform
the analyses.
"""
