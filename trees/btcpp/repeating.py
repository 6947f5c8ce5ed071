"""Decorators that tick their child again, as BehaviorTree.CPP's do."""

from __future__ import annotations

from collections.abc import Generator, Iterator

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.decorators import Decorator


class RepeatingDecorator(Decorator):
    """Ticks its child up to a number of times.

    A child that ends in its first tick is not ticked again in the same one, so that a loop of quick
    children cannot keep the tree from returning; one that was running before is.

    Attributes:
        limit: How often at most; -1 is for ever.
    """

    again_after = Status.FAILURE
    """The end of the child after which it is ticked again; the other one is passed on."""
    exhausted = Status.FAILURE
    """The end after the last time."""

    def __init__(self, name: str, child: Behaviour, limit: int) -> None:
        super().__init__(name=name, child=child)
        self.limit = limit
        self._done = 0

    def tick(self) -> Iterator[Behaviour]:
        """Tick the child, more than once if it was running before."""
        if self.status is not Status.RUNNING:
            self._done = 0
        status = yield from self._advance()
        if status is not Status.RUNNING:
            self.stop(status)
        self.status = status
        yield self

    def update(self) -> Status:
        """Not called: ``tick`` does it all."""
        return self.status

    def _advance(self) -> Generator[Behaviour, None, Status]:
        while self._more():
            fresh = self.decorated.status is not Status.RUNNING
            yield from self.decorated.tick()
            if self.decorated.status is not self.again_after:
                return self.decorated.status
            self._done += 1
            if fresh and self._more():
                return Status.RUNNING
        return self.exhausted

    def _more(self) -> bool:
        return self.limit == -1 or self._done < self.limit


class RetryUntilSuccessful(RepeatingDecorator):
    """Ticks its child until it succeeds, up to a number of times."""


class Repeat(RepeatingDecorator):
    """Ticks its child until it fails, up to a number of times; then it has succeeded."""

    again_after = Status.SUCCESS
    exhausted = Status.SUCCESS


class KeepRunningUntilFailure(Decorator):
    """Runs until its child fails."""

    def update(self) -> Status:
        """A success of the child is no end."""
        return Status.FAILURE if self.decorated.status is Status.FAILURE else Status.RUNNING
