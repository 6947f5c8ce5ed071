"""A scene of somebody else's, named where one of ours could be: it is imported on the way."""

from __future__ import annotations

import hashlib
from pathlib import Path

import typer

from executive.config import cache_directory


def imported_scene(named: str) -> str:
    """The path of the scene file that is made of a foreign one.

    One that stands beside it already, and is newer, is taken as it is: a person may have mended it. What
    could not be taken over, and what only a person can tell, goes to standard error. Where the folder cannot
    be written, the scene file is put into the cache.

    Raises:
        CannotImportError: Nothing can be made of it.
    """
    from robots.errors import CannotImportError
    from robots.simulated.importing.import_scene import import_scene

    file = Path(named)
    beside = file.with_suffix(".toml")
    if not file.is_file():
        raise CannotImportError(f"{file}: there is no such file")
    if beside.is_file() and beside.stat().st_mtime >= file.stat().st_mtime:
        return str(beside)
    try:
        made = import_scene(file, beside)
    except CannotImportError as refused:
        if not isinstance(refused.__cause__, OSError):
            raise
        digest = hashlib.sha256(str(file.resolve()).encode()).hexdigest()[:16]
        made = import_scene(file, cache_directory() / "scenes" / digest / beside.name)
    for line in (*made.told, *(f"question: {asked}" for asked in made.asked)):
        typer.echo(f"{file.name}: {line}", err=True)
    typer.echo(f"{file.name}: made {made.scene}; every guess is in {made.guesses}", err=True)
    return str(made.scene)
