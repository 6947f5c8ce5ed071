"""``--config``: a file of settings, for every command that understands sentences."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

ConfigOption = Annotated[
    Path | None,
    typer.Option("--config", metavar="FILE.toml", help="A TOML file with words of your own."),
]
