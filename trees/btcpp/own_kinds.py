"""Our own nodes between root and leaves, as kinds that BehaviorTree.CPP's editor can show."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from py_trees.behaviour import Behaviour

from trees.btcpp.literals import type_name
from trees.btcpp.node_kind import NodeKind, Parts, Port
from trees.failures import Failure, FailureKind
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.clean_up import CleanUp
from trees.nodes.deadline import Deadline
from trees.nodes.judgements import always_worth_trying, defect
from trees.nodes.retry import Retry
from trees.nodes.skipping import IfShifted, OnlyAfter, UnlessHeld
from trees.skills.gestures.turn_to import IfBeside
from trees.skills.home.tree import IfNothingIsKnown
from trees.skills.looking.look_along_way import UnlessSeen
from trees.skills.meeting.if_far import IfFar
from trees.skills.meeting.if_outside import IfOutside

JUDGES = Callable[[Failure], bool]
JUDGES_WAYS = Callable[[Behaviour, Failure | None], bool]
JUDGES_ATTEMPTS = Callable[[Failure, Failure | None], bool]


def _literal(name: str, hint: Any, description: str, default: str | None = None) -> Port:
    return Port(name, "input", type_name(hint), hint, default, description)


def _failure(direction: Any) -> Port:
    return Port("failure", direction, "Failure", description="why the attempt failed")


def _retry(parts: Parts) -> Behaviour:
    attempt, recover = parts.children
    return Retry(parts.name, attempt, recover, parts.settings["attempts"], parts.settings["hopeless"])


def _clean_up(parts: Parts) -> Behaviour:
    main, after = parts.children
    return CleanUp(parts.name, main, after, parts.settings["worth_it"])


def _summary(cls: type) -> str:
    return (inspect.getdoc(cls) or "").partition("\n\n")[0].replace("``", "").replace("\n", " ")


_BY_CLASS: dict[type[Behaviour], NodeKind] = {
    Alternatives: NodeKind(
        "Alternatives",
        "Control",
        lambda parts: Alternatives(parts.name, parts.children, **parts.settings),
        lambda node: {"hopeless": node.hopeless, "worth_trying": node.worth_trying},
        (
            _literal("hopeless", JUDGES, "after such a failure no other way can help", defect.name),
            _literal(
                "worth_trying", JUDGES_WAYS, "a way is tried after such a failure", always_worth_trying.name
            ),
        ),
        (1, 1000),
    ),
    Retry: NodeKind(
        "Retry",
        "Control",
        _retry,
        lambda node: {"attempts": node.limit, "hopeless": node.hopeless},
        (
            _literal("attempts", int, "how many at most"),
            _literal("hopeless", JUDGES_ATTEMPTS, "after such failures no other attempt can help"),
            _failure("output"),
        ),
        (2, 2),
        transparent=True,
    ),
    CleanUp: NodeKind(
        "CleanUp",
        "Control",
        _clean_up,
        lambda node: {"worth_it": node.worth_it},
        (_literal("worth_it", JUDGES, "after such a failure the second child is ticked"),),
        (2, 2),
        transparent=True,
    ),
    Deadline: NodeKind(
        "Deadline",
        "Decorator",
        lambda parts: Deadline(
            parts.name,
            parts.children[0],
            parts.settings["deadline_s"],
            parts.toolbox.clock,
            parts.toolbox.pauses,
        ),
        lambda node: {"deadline_s": node.deadline_s},
        (_literal("deadline_s", float, "seconds on the injected clock"),),
        (1, 1),
        transparent=True,
    ),
    BestEffort: NodeKind(
        "BestEffort",
        "Decorator",
        lambda parts: BestEffort(parts.children[0]),
        children=(1, 1),
        transparent=True,
    ),
    OnlyAfter: NodeKind(
        "OnlyAfter",
        "Decorator",
        lambda parts: OnlyAfter(parts.children[0], parts.settings["kinds"]),
        lambda node: {"kinds": node.kinds},
        (
            _literal("kinds", frozenset[FailureKind], "kinds of failure after which the child is needed"),
            _failure("input"),
        ),
        (1, 1),
        transparent=True,
    ),
    IfBeside: NodeKind(
        "IfBeside",
        "Decorator",
        lambda parts: IfBeside(parts.children[0], parts.toolbox, parts.settings["beyond_rad"]),
        lambda node: {"beyond_rad": node.beyond_rad},
        (
            _literal("beyond_rad", float, "so far to a side it is too far for the trunk, rad"),
            Port("place", "input", "Place", description="what was found"),
        ),
        (1, 1),
        transparent=True,
    ),
    IfFar: NodeKind(
        "IfFar",
        "Decorator",
        lambda parts: IfFar(parts.children[0], parts.toolbox),
        lambda _node: {},
        (Port("place", "input", "Place", description="the person who was found"),),
        (1, 1),
        transparent=True,
    ),
    IfOutside: NodeKind(
        "IfOutside",
        "Decorator",
        lambda parts: IfOutside(parts.children[0], parts.toolbox, parts.settings["room"]),
        lambda node: {"room": node.room},
        (_literal("room", str, "a room of the map that the robot does not stand in"),),
        (1, 1),
        transparent=True,
    ),
    IfShifted: NodeKind(
        "IfShifted",
        "Decorator",
        lambda parts: IfShifted(parts.children[0]),
        ports=(Port("shifted", "input", "bool", description="whether it has shifted in the hand"),),
        children=(1, 1),
        transparent=True,
    ),
    IfNothingIsKnown: NodeKind(
        "IfNothingIsKnown",
        "Decorator",
        lambda parts: IfNothingIsKnown(parts.children[0], parts.toolbox),
        children=(1, 1),
        transparent=True,
    ),
    UnlessHeld: NodeKind(
        "UnlessHeld",
        "Decorator",
        lambda parts: UnlessHeld(parts.children[0]),
        ports=(Port("in_hand", "input", "bool", description="whether it is held already"),),
        children=(1, 1),
        transparent=True,
    ),
    UnlessSeen: NodeKind(
        "UnlessSeen",
        "Decorator",
        lambda parts: UnlessSeen(parts.children[0]),
        ports=(Port("unseen", "input", "UnseenPlaces", description="what no look has shown"),),
        children=(1, 1),
        transparent=True,
    ),
}


OWN_KINDS = {cls: replace(kind, description=_summary(cls)) for cls, kind in _BY_CLASS.items()}
"""By class."""
