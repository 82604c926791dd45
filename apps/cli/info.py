"""Implements `flexel info`: facts about this installation."""

import click


@click.command()
def info() -> None:
    """Print versions, compiler, cache directory and whether the kernels load."""
    from flexel.apps.cli.facts import facts

    rows = facts()
    width = max(len(name) for name, _ in rows)
    for name, fact in rows:
        click.echo(f"{name:<{width}}  {fact}")
