"""Control nodes of BehaviorTree.CPP that py_trees has not, or has otherwise."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Generator, Iterator, Sequence

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Composite

Advance = Generator[Behaviour, None, Status]


class ControlNode(Composite):
    """A composite whose tick is one method that yields what it ticks and returns its status."""

    def __init__(self, name: str, children: Sequence[Behaviour]) -> None:
        super().__init__(name, list(children))

    @abstractmethod
    def advance(self) -> Advance:
        """Tick children, and tell this node's status."""

    def begin(self) -> None:
        """Start anew."""

    def tick(self) -> Iterator[Behaviour]:
        """Tick what it is the turn of; when this node ends, what still runs below it is halted."""
        if self.status is not Status.RUNNING:
            self.begin()
        status = yield from self.advance()
        if status is not Status.RUNNING:
            for child in self.children:
                if child.status is Status.RUNNING:
                    child.stop(Status.INVALID)
            self.stop(status)
        self.status = status
        yield self


class SequenceWithMemory(ControlNode):
    """A sequence that begins again with the child that failed, not with the first.

    A halt does not make it forget, either; only its success does. After a child that succeeded in its
    first tick the next one waits for the next tick.
    """

    def __init__(self, name: str, children: Sequence[Behaviour]) -> None:
        super().__init__(name, children)
        self._next = 0

    def advance(self) -> Advance:
        """One child after the other."""
        while self._next < len(self.children):
            child = self.children[self._next]
            fresh = child.status is not Status.RUNNING
            yield from child.tick()
            if child.status is not Status.SUCCESS:
                return child.status
            self._next += 1
            if fresh and self._next < len(self.children):
                return Status.RUNNING
        self._next = 0
        return Status.SUCCESS


class Parallel(ControlNode):
    """Ticks all children that have not ended; ends when enough have succeeded, or failed.

    Attributes:
        success_count: So many successes are enough; negative ones count from the number of children (-1).
        failure_count: So many failures are too many, counted likewise.
    """

    def __init__(
        self, name: str, children: Sequence[Behaviour], success_count: int = -1, failure_count: int = 1
    ) -> None:
        super().__init__(name, children)
        self.success_count, self.failure_count = success_count, failure_count
        self._ended: dict[int, Status] = {}

    def begin(self) -> None:
        """Nobody has ended."""
        self._ended = {}

    def advance(self) -> Advance:
        """Each child in its turn; an end counts at once, and those after it are not ticked any more."""
        enough, too_many = self._threshold(self.success_count), self._threshold(self.failure_count)
        for number, child in enumerate(self.children):
            if number not in self._ended:
                yield from child.tick()
                if child.status is not Status.RUNNING:
                    self._ended[number] = child.status
            succeeded = sum(status is Status.SUCCESS for status in self._ended.values())
            failed = len(self._ended) - succeeded
            if succeeded >= enough:
                return Status.SUCCESS
            if len(self.children) - failed < enough or failed == too_many:
                return Status.FAILURE
        return Status.RUNNING

    def _threshold(self, count: int) -> int:
        return count if count >= 0 else max(len(self.children) + count + 1, 0)


class ParallelAll(ControlNode):
    """Ticks all children until every one has ended; fails when too many failed.

    Attributes:
        max_failures: So many are too many; negative ones count from the number of children (-1).
    """

    def __init__(self, name: str, children: Sequence[Behaviour], max_failures: int = 1) -> None:
        super().__init__(name, children)
        self.max_failures = max_failures
        self._ended: dict[int, Status] = {}

    def begin(self) -> None:
        """Nobody has ended."""
        self._ended = {}

    def advance(self) -> Advance:
        """Each child that has not ended."""
        for number, child in enumerate(self.children):
            if number not in self._ended:
                yield from child.tick()
                if child.status is not Status.RUNNING:
                    self._ended[number] = child.status
        if len(self._ended) < len(self.children):
            return Status.RUNNING
        limit = self.max_failures
        limit = limit if limit >= 0 else max(len(self.children) + limit + 1, 0)
        failed = sum(status is Status.FAILURE for status in self._ended.values())
        return Status.FAILURE if failed >= limit else Status.SUCCESS


class IfThenElse(ControlNode):
    """The first child chooses the second or the third, once; without a third its failure is this node's."""

    def __init__(self, name: str, children: Sequence[Behaviour]) -> None:
        super().__init__(name, children)
        self._chosen: Behaviour | None = None

    def begin(self) -> None:
        """Nothing is chosen."""
        self._chosen = None

    def advance(self) -> Advance:
        """The condition, then the branch."""
        condition, *branches = self.children
        if self._chosen is None:
            yield from condition.tick()
            if condition.status is Status.RUNNING:
                return Status.RUNNING
            number = 0 if condition.status is Status.SUCCESS else 1
            if number == len(branches):
                return Status.FAILURE
            self._chosen = branches[number]
        yield from self._chosen.tick()
        return self._chosen.status


class WhileDoElse(ControlNode):
    """The first child chooses the second or the third at each tick; the other one is halted."""

    def advance(self) -> Advance:
        """The condition, then the branch."""
        condition, *branches = self.children
        yield from condition.tick()
        if condition.status is Status.RUNNING:
            return Status.RUNNING
        number = 0 if condition.status is Status.SUCCESS else 1
        if number == len(branches):
            return Status.FAILURE
        for other in branches:
            if other is not branches[number] and other.status is Status.RUNNING:
                other.stop(Status.INVALID)
        yield from branches[number].tick()
        return branches[number].status
