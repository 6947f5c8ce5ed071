"""Optional parts: what is missing is told in one line, with what to install."""

from __future__ import annotations

from importlib.util import find_spec

from executive.errors import UserError

PRODUCT = "humanoid-executive"


class MissingExtraError(UserError):
    """A feature needs packages that are not installed."""


def require_extra(extra: str, *modules: str) -> None:
    """Make sure that the packages of an extra are there.

    Args:
        extra: Its name, as in ``pip install "humanoid-executive[mcp]"``.
        modules: Names of modules that it brings.

    Raises:
        MissingExtraError: One is missing.
    """
    for module in modules:
        if find_spec(module) is None:
            raise MissingExtraError(
                f'the package {module!r} is not installed: pip install "{PRODUCT}[{extra}]"'
            )
