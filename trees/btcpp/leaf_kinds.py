"""Leaves as kinds of nodes: ID, ports and description come from what each leaf declares."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from typing import Any

from py_trees.behaviour import Behaviour
from py_trees.ports import PortInformation

import trees.given_motion
import trees.leaves
import trees.skills
from trees.btcpp.literals import to_text, type_name
from trees.btcpp.node_kind import NodeKind, Parts, Port
from trees.btcpp.outside_leaves import outside_leaves
from trees.nodes.leaf import Leaf
from trees.nodes.leaf_settings import setting_types


@cache
def leaf_kind(cls: type[Leaf]) -> NodeKind:
    """The kind of a class of leaves.

    Raises:
        NameError: An annotation of its arguments names what its module does not have.
        ValueError: A default of one of its arguments cannot be written.
    """
    ports = [
        *_settings(cls),
        *_references(cls.INPUT_PORTS, "input"),
        *_references(cls.OUTPUT_PORTS, "output"),
    ]
    return NodeKind(
        cls.__name__,
        "Action",
        _maker(cls),
        lambda leaf: leaf.settings,
        tuple(ports),
        description=_described(cls),
    )


def known_leaves() -> Mapping[str, type[Leaf]]:
    """All leaves by their IDs: those of this package and those of others, in the order of the IDs.

    Raises:
        ValueError: Two leaves of this package have the same ID.
    """
    found = {cls.__name__: cls for cls in outside_leaves().leaves}
    for package in (trees.leaves, trees.skills):
        for module in pkgutil.walk_packages(package.__path__, f"{package.__name__}."):
            importlib.import_module(module.name)
    own: dict[str, type[Leaf]] = {}
    for cls in _below(Leaf):
        if not cls.__module__.startswith("trees.") or not _is_whole(cls):
            continue
        if own.setdefault(cls.__name__, cls) is not cls:
            raise ValueError(f"two leaves are called {cls.__name__}; one is in {cls.__module__}")
    return dict(sorted({**found, **own}.items()))


def _below(cls: type[Leaf]) -> Iterator[type[Leaf]]:
    for one in cls.__subclasses__():
        yield one
        yield from _below(one)


def _is_whole(cls: type[Leaf]) -> bool:
    return all(hasattr(cls, name) for name in ("CONTRACT", "INPUT_PORTS", "OUTPUT_PORTS"))


def _maker(cls: type[Leaf]) -> Callable[[Parts], Behaviour]:
    return lambda parts: cls(parts.name, parts.toolbox, **parts.settings)


def _settings(cls: type[Leaf]) -> Iterator[Port]:
    for name, (hint, default) in setting_types(cls).items():
        text = None if default is inspect.Parameter.empty else to_text(default)
        yield Port(name, "input", type_name(hint), hint, text)


def _references(ports: Mapping[str, PortInformation], direction: Any) -> Iterator[Port]:
    for name, port in ports.items():
        may_lack = "" if port.required and port.default_value is None else "may have no value yet"
        yield Port(name, direction, type_name(port.data_type), description=port.description or may_lack)


def _described(cls: type[Leaf]) -> str:
    says, contract = (inspect.getdoc(cls) or "").partition("\n\n")[0].replace("\n", " "), cls.CONTRACT
    return f"{says} Before: {contract.precondition}. After: {contract.postcondition}."
