"""The nodes that BehaviorTree.CPP brings along, made of py_trees' and our own."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from py_trees import behaviours, composites, decorators
from py_trees.behaviour import Behaviour

from trees.btcpp.composites import IfThenElse, Parallel, ParallelAll, SequenceWithMemory, WhileDoElse
from trees.btcpp.node_kind import NodeKind, Parts, Port
from trees.btcpp.repeating import KeepRunningUntilFailure, Repeat, RepeatingDecorator, RetryUntilSuccessful
from trees.nodes.deadline import Deadline

_MANY = (1, 1000)


def _number(name: str, default: str | None, description: str) -> Port:
    return Port(name, "input", "int", int, default, description)


def _control(
    name: str,
    make: Callable[[Parts], Behaviour],
    children: tuple[int, int] = _MANY,
    *ports: Port,
    **more: Any,
) -> NodeKind:
    return NodeKind(name, "Control", make, ports=ports, children=children, builtin=True, **more)


def _decorator(name: str, make: Callable[[Parts], Behaviour], *ports: Port, **more: Any) -> NodeKind:
    return NodeKind(name, "Decorator", make, ports=ports, children=(1, 1), builtin=True, **more)


def _of(cls: Callable[..., Behaviour], **more: Any) -> Callable[[Parts], Behaviour]:
    return lambda parts: cls(parts.name, children=parts.children, **more)


def _around(cls: Callable[..., Behaviour]) -> Callable[[Parts], Behaviour]:
    return lambda parts: cls(name=parts.name, child=parts.children[0])


def _times(cls: type[RepeatingDecorator], port: str) -> Callable[[Parts], Behaviour]:
    return lambda parts: cls(parts.name, parts.children[0], parts.settings[port])


def _timeout(parts: Parts) -> Behaviour:
    return Deadline(parts.name, parts.children[0], 1e-3 * parts.settings["msec"], parts.toolbox.clock)


def _branches(cls: Callable[..., Behaviour]) -> Callable[[Parts], Behaviour]:
    return lambda parts: cls(parts.name, parts.children)


SEQUENCE = _control("Sequence", _of(composites.Sequence, memory=True))
REACTIVE_SEQUENCE = _control("ReactiveSequence", _of(composites.Sequence, memory=False))
FALLBACK = _control("Fallback", _of(composites.Selector, memory=True))
REACTIVE_FALLBACK = _control("ReactiveFallback", _of(composites.Selector, memory=False))

_BY_CLASS: dict[type[Behaviour], NodeKind] = {
    SequenceWithMemory: _control("SequenceWithMemory", _branches(SequenceWithMemory)),
    Parallel: _control(
        "Parallel",
        lambda parts: Parallel(parts.name, parts.children, **parts.settings),
        _MANY,
        _number("success_count", "-1", "successes that are enough; -1 is all"),
        _number("failure_count", "1", "failures that are too many"),
        settings=lambda node: {"success_count": node.success_count, "failure_count": node.failure_count},
    ),
    ParallelAll: _control(
        "ParallelAll",
        lambda parts: ParallelAll(parts.name, parts.children, **parts.settings),
        _MANY,
        _number("max_failures", "1", "failures that are too many"),
        settings=lambda node: {"max_failures": node.max_failures},
    ),
    IfThenElse: _control("IfThenElse", _branches(IfThenElse), (2, 3)),
    WhileDoElse: _control("WhileDoElse", _branches(WhileDoElse), (2, 3)),
    decorators.Inverter: _decorator("Inverter", _around(decorators.Inverter)),
    decorators.FailureIsSuccess: _decorator("ForceSuccess", _around(decorators.FailureIsSuccess)),
    decorators.SuccessIsFailure: _decorator("ForceFailure", _around(decorators.SuccessIsFailure)),
    RetryUntilSuccessful: _decorator(
        "RetryUntilSuccessful",
        _times(RetryUntilSuccessful, "num_attempts"),
        _number("num_attempts", None, "times at most; -1 is for ever"),
        settings=lambda node: {"num_attempts": node.limit},
    ),
    Repeat: _decorator(
        "Repeat",
        _times(Repeat, "num_cycles"),
        _number("num_cycles", None, "times at most; -1 is for ever"),
        settings=lambda node: {"num_cycles": node.limit},
    ),
    KeepRunningUntilFailure: _decorator("KeepRunningUntilFailure", _around(KeepRunningUntilFailure)),
    behaviours.Success: NodeKind(
        "AlwaysSuccess", "Action", lambda parts: behaviours.Success(parts.name), builtin=True
    ),
    behaviours.Failure: NodeKind(
        "AlwaysFailure", "Action", lambda parts: behaviours.Failure(parts.name), builtin=True
    ),
}

TIMEOUT = _decorator("Timeout", _timeout, _number("msec", None, "milliseconds, on the injected clock"))
"""Only read; such a node is one of our deadlines, and is written as one."""

BUILTIN_KINDS = (
    SEQUENCE, REACTIVE_SEQUENCE, FALLBACK, REACTIVE_FALLBACK, TIMEOUT, *_BY_CLASS.values(),
)  # fmt: skip


def builtin_kind(node: Behaviour) -> NodeKind | None:
    """The kind of a node that BehaviorTree.CPP knows as well, or None."""
    if isinstance(node, composites.Sequence):
        return SEQUENCE if node.memory else REACTIVE_SEQUENCE
    if isinstance(node, composites.Selector):
        return FALLBACK if node.memory else REACTIVE_FALLBACK
    return _BY_CLASS.get(type(node))
