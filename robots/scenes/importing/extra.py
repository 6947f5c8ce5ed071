"""The libraries that importing needs, and running does not."""

from __future__ import annotations

import importlib
from typing import Any

from robots.errors import CannotImportError


def library(name: str) -> Any:
    """One of them.

    Raises:
        CannotImportError: It is not installed.
    """
    try:
        return importlib.import_module(name)
    except ImportError as missing:
        told = f"importing needs {missing.name or name}: pip install 'humanoid-executive[import]'"
        raise CannotImportError(told) from missing
