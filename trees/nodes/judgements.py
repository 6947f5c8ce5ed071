"""What control nodes ask: why a node failed, and judgements of that failure.

"No other way helps", "tidying up helps": such a question is a function of the failure, declared with
``@judgement`` where it belongs, and is known in stored trees by the function's name, whatever module that
stands in. Names are unique over all skills. Here are those that several skills share.
"""

from __future__ import annotations

import inspect
import typing
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Generic, ParamSpec

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from trees.failures import Failure, FailureKind, Reason

Judged = ParamSpec("Judged")


@dataclass(frozen=True)
class Judgement(Generic[Judged]):
    """A question to a failure that a control node is made with; called as the function that answers it.

    Attributes:
        function: Answers it; its parameters are annotated.
    """

    function: Callable[Judged, bool]

    def __call__(self, *judged: Judged.args, **named: Judged.kwargs) -> bool:
        """The answer."""
        return self.function(*judged, **named)

    @property
    def name(self) -> str:
        """What stored trees call it."""
        return self.function.__name__

    @property
    def package(self) -> str:
        """The top-level package that it comes from."""
        return self.function.__module__.partition(".")[0]

    @property
    def meaning(self) -> str:
        """The first paragraph of its docstring, in one line."""
        return " ".join((inspect.getdoc(self.function) or "").partition("\n\n")[0].split())

    @cached_property
    def takes(self) -> tuple[Any, ...]:
        """Types of what it judges, in order; None where one is not annotated.

        Raises:
            NameError: An annotation names what its module does not have.
        """
        hints = typing.get_type_hints(self.function)
        return tuple(hints.get(name) for name in inspect.signature(self.function).parameters)

    def __repr__(self) -> str:
        return f"<judgement {self.name}>"


def judgement(function: Callable[Judged, bool]) -> Judgement[Judged]:
    """Declare a judgement: ``@judgement`` above a function of a module.

    Raises:
        ValueError: The function has no public name, by which a stored tree could call it.
    """
    name = function.__name__
    if not name.isidentifier() or name.startswith("_"):
        raise ValueError(f"{name} cannot be declared a judgement: it needs a public name, for stored trees")
    return Judgement(function)


@judgement
def no_pick_helps(failure: Failure) -> bool:
    """A defect, or several objects that fit: that takes an answer."""
    return defect(failure) or bool(failure.choices)


@judgement
def defect(failure: Failure) -> bool:
    """No other way helps against a defect or a halt."""
    return failure.kind in (FailureKind.ERROR, FailureKind.CANCELED)


@judgement
def always_worth_trying(_way: Behaviour, _failure: Failure | None) -> bool:
    """Every way, whatever failed before."""
    return True


@judgement
def looking_elsewhere_is_useless(failure: Failure) -> bool:
    """A defect, several objects in view that fit, or one on the floor: that takes an answer, not a look."""
    return defect(failure) or bool(failure.choices) or failure.root.reason is Reason.ON_FLOOR


@judgement
def tidying_helps(failure: Failure) -> bool:
    """Not after a defect; and while a question is open nothing moves."""
    return not defect(failure) and not failure.choices


@judgement
def no_other_attempt_helps(failure: Failure, before: Failure | None) -> bool:
    """A defect, a question, or the planner's second no in a row: it has been asked anew in between."""
    twice = before is not None and before.kind is failure.kind is FailureKind.INFEASIBLE
    return defect(failure) or bool(failure.choices) or twice


def failure_of(node: Behaviour) -> Failure | None:
    """Why a node failed: its own failure, or that of the child that failed it."""
    own = getattr(node, "failure", None)
    if isinstance(own, Failure):
        return own
    failed = [child for child in node.children if child.status is Status.FAILURE]
    return failure_of(failed[-1]) if failed else None


def place_of(node: Behaviour) -> str:
    """Names from the root down to a node, joined by "/"; nodes that only structure are left out."""
    names = [node.name]
    above = node.parent
    while above is not None:
        if above.parent is None or not getattr(above, "transparent", False):
            names.append(above.name)
        above = above.parent
    return "/".join(reversed(names))


def followed_by(failure: Failure, earlier: Failure | None) -> Failure:
    """Append an earlier failure at the end of a failure's chain of causes."""
    if earlier is None:
        return failure
    if failure.cause is None:
        return failure.caused_by(earlier)
    return failure.caused_by(followed_by(failure.cause, earlier))
