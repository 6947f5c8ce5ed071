"""What leaves are made with: the arguments of their classes beside name, toolbox and wiring."""

from __future__ import annotations

import inspect
import typing
from collections.abc import Mapping
from functools import cache
from types import MappingProxyType
from typing import Any

GIVEN_BY_TREE = ("name", "toolbox", "wiring")
"""Arguments that come from a leaf's place in its tree."""


def settings_of(cls: type, arguments: tuple[Any, ...], named: Mapping[str, Any]) -> Mapping[str, Any]:
    """Values of a leaf's own arguments, by name, as a call of its class gives them, defaults included.

    A call that does not fit has none: making the leaf tells what is wrong with it.
    """
    try:
        bound = _signature(cls).bind(None, *arguments, **named)
    except TypeError:
        return MappingProxyType({})
    bound.apply_defaults()
    given = bound.arguments.items()
    return MappingProxyType({name: value for name, value in given if name not in (*GIVEN_BY_TREE, "self")})


def setting_types(cls: type) -> dict[str, tuple[Any, Any]]:
    """Type and default of each of a leaf's own arguments, by name; ``inspect.Parameter.empty`` is no default.

    Raises:
        NameError: An annotation names what its module does not have.
    """
    hints = typing.get_type_hints(cls.__init__)  # type: ignore[misc]
    return {
        name: (hints.get(name, str), parameter.default)
        for name, parameter in list(_signature(cls).parameters.items())[1:]
        if name not in GIVEN_BY_TREE
    }


@cache
def _signature(cls: type) -> inspect.Signature:
    return inspect.signature(cls.__init__)  # type: ignore[misc]
