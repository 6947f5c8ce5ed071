"""A script's statements one after the other: once more, go on or stop, and what was the first surprise.

Who carries a statement out, a session here or a robot that is served elsewhere, makes no difference to it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Protocol, TypeVar

from executive.exit_codes import ExitCode
from executive.understanding.statement import Statement


class Ending(Protocol):
    """How something that was said ended."""

    @property
    def outcome(self) -> str:
        """As in a ``TaskResult``."""
        ...

    @property
    def exit_code(self) -> ExitCode:
        """The exit code that it calls for."""
        ...


E = TypeVar("E", bound=Ending)


def in_order(
    statements: Iterable[Statement], carry_out: Callable[[Statement], Sequence[E]]
) -> list[tuple[Statement, list[E]]]:
    """Carry statements out, until one does not end as expected and does not say to go on.

    Args:
        statements: What to say, in order.
        carry_out: Says one once; gives how its tasks ended, at least one, and the last one counts.

    Returns:
        The statements that were begun, each with how its tasks ended, of both tries where there were two.
    """
    results: list[tuple[Statement, list[E]]] = []
    for statement in statements:
        said: list[E] = []
        results.append((statement, said))
        for _ in range(2 if statement.on_failure == "retry" else 1):
            said += carry_out(statement)
            if said[-1].outcome in (statement.expect, "cancelled"):
                break
        if said[-1].outcome == "cancelled":
            break
        if said[-1].outcome != statement.expect and statement.on_failure != "continue":
            break
    return results


def first_unexpected(results: Iterable[tuple[Statement, Sequence[E]]]) -> tuple[Statement, E] | None:
    """The first statement that did not end as it was expected to, and how it ended; None when all did."""
    for statement, said in results:
        if said[-1].outcome != statement.expect:
            return statement, said[-1]
    return None


def unexpected_code(ending: Ending) -> ExitCode:
    """The exit code of an ending that was not expected: what was done all the same is a failure."""
    return ending.exit_code if ending.exit_code is not ExitCode.DONE else ExitCode.FAILED
