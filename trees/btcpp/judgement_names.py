"""Judgements by the names that documents call them by: our own, and those that other packages declare.

Our own are found as leaves are, wherever they stand below ``trees``. Another package declares its own in its
``pyproject.toml``, in the group ``humanoid_executive.judgements``; one that cannot be loaded, or whose name
is taken, is left out, and its error is kept to be told. Nothing that a document names is imported.
"""

from __future__ import annotations

import difflib
import importlib
import importlib.metadata
import pkgutil
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType, ModuleType
from typing import Any

import trees.leaves
import trees.nodes
import trees.skills
from trees.btcpp.outside_leaves import load_declared
from trees.nodes.judgements import Judgement

JUDGEMENTS = "humanoid_executive.judgements"
AnyJudgement = Judgement[...]

_FORMER_NAMES = MappingProxyType(
    {
        "open:looking_elsewhere_is_useless": "what_was_seen_decides",
        "hopeless": "moving_it_again_is_useless",
        "no_other_spot_helps": "no_other_attempt_helps",
        "nothing_else_helps": "no_other_attempt_helps",
    }
)
"""Of functions that older documents name with their modules; one only of a module of that name."""


@dataclass(frozen=True, slots=True)
class OutsideJudgements:
    """Judgements of other packages.

    Attributes:
        judgements: By name.
        complaints: Why an entry point was left out, one line each.
    """

    judgements: Mapping[str, AnyJudgement]
    complaints: tuple[str, ...] = ()


def judgement_called(text: str, takes: Sequence[Any]) -> AnyJudgement:
    """The judgement that a document means.

    Older documents write ``module:function``. The module says only which package it is of: a function that
    has moved since is found all the same, and so is one that has another name by now.

    Args:
        text: Its name, or a function of before.
        takes: Types of what it is to judge; only such judgements are proposed in place of one that is not.

    Raises:
        ValueError: There is none of that name.
    """
    module, of_module, function = text.rpartition(":")
    name = _present_name(module, function) if of_module else function
    found = known_judgements().get(name)
    if found is None or (of_module and module.partition(".")[0] != found.package):
        fitting = [one.name for one in known_judgements().values() if one.takes == tuple(takes)]
        close = difflib.get_close_matches(name, fitting, n=1)
        hint = f"did you mean {close[0]!r}?" if close else f"there are {', '.join(fitting)}"
        raise ValueError(f"there is no judgement {text[:80]!r}; {hint}")
    return found


def name_of(judgement: AnyJudgement) -> str:
    """The name by which documents call a judgement.

    Raises:
        ValueError: It could not be found by that name.
    """
    if known_judgements().get(judgement.name) is not judgement:
        raise ValueError(
            f"the judgement {judgement.name!r} of {judgement.package} could not be read again: judgements of "
            f"other packages are declared in the group {JUDGEMENTS}"
        )
    return judgement.name


@cache
def known_judgements() -> Mapping[str, AnyJudgement]:
    """All judgements by their names, in the order of the names."""
    return MappingProxyType(dict(sorted({**outside_judgements().judgements, **own_judgements()}.items())))


@cache
def own_judgements() -> Mapping[str, AnyJudgement]:
    """Judgements that stand below ``trees``, by their names.

    Raises:
        ValueError: Two of them have the same name.
    """
    found: dict[str, AnyJudgement] = {}
    for module in _modules():
        for value in vars(module).values():
            if isinstance(value, Judgement) and found.setdefault(value.name, value) is not value:
                raise ValueError(f"two judgements are called {value.name!r}; one is in {module.__name__}")
    return MappingProxyType(found)


@cache
def outside_judgements() -> OutsideJudgements:
    """Judgements of other packages, loaded once."""
    return load_judgements(importlib.metadata.entry_points(group=JUDGEMENTS))


def load_judgements(points: Any) -> OutsideJudgements:
    """Load entry points of judgements, those with the smaller names first.

    Args:
        points: Entry points of the group.
    """

    def called(found: Any) -> str:
        if not isinstance(found, Judgement):
            raise ValueError("is no judgement: declare the function with @judgement")
        if found.name in own_judgements():
            raise ValueError(f"there is a judgement {found.name!r} already")
        if None in found.takes:
            raise ValueError(f"what {found.name!r} judges has to be annotated")
        return found.name

    return OutsideJudgements(*load_declared(points, "judgement", called))


def _modules() -> Iterator[ModuleType]:
    for package in (trees.nodes, trees.leaves, trees.skills):
        for module in pkgutil.walk_packages(package.__path__, f"{package.__name__}."):
            yield importlib.import_module(module.name)


def _present_name(module: str, function: str) -> str:
    name = function.lstrip("_")
    of_module = f"{module.rpartition('.')[2]}:{name}"
    return _FORMER_NAMES.get(of_module, _FORMER_NAMES.get(name, name))
