"""One way after the other, until one works."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Composite

from trees.failures import Failure
from trees.nodes.judgements import always_worth_trying, defect, failure_of


class Alternatives(Composite):
    """A selector with memory: it tries one child after the other, and stops early when no other can help.

    Its failure is that of the last child that was tried.

    Attributes:
        failure: Why it failed; None otherwise.
        hopeless, worth_trying: The judgements that it was made with: whether a failure makes all other
            children useless, and whether a child is worth trying after it.
    """

    def __init__(
        self,
        name: str,
        children: Sequence[Behaviour],
        hopeless: Callable[[Failure], bool] = defect,
        worth_trying: Callable[[Behaviour, Failure | None], bool] = always_worth_trying,
    ) -> None:
        """Make the node.

        Args:
            name: Its name.
            children: The ways, in order.
            hopeless: Tells from a failure that no other way can help.
            worth_trying: Tells whether a way is worth trying after the failure of the one before; a way
                that is not is passed over.
        """
        super().__init__(name, children)
        self.worth_trying = worth_trying
        self.failure: Failure | None = None
        self.transparent = False
        self.hopeless = hopeless

    def tick(self) -> Iterator[Behaviour]:
        """Go on with the way under way, and over to the next when it fails."""
        if self.status is not Status.RUNNING:
            for child in self.children:
                if child.status is not Status.INVALID:
                    child.stop(Status.INVALID)
            self.failure = None
            self.current_child = self.children[0]
        first = 0 if self.current_child is None else self.children.index(self.current_child)
        for child in self.children[first:]:
            if child.status is not Status.RUNNING and not self.worth_trying(child, self.failure):
                continue
            self.current_child = child
            yield from child.tick()
            if child.status is Status.RUNNING:
                self.status = Status.RUNNING
                yield self
                return
            if child.status is Status.SUCCESS:
                self.stop(Status.SUCCESS)
                yield self
                return
            self.failure = failure_of(child)
            if self.failure is not None and self.hopeless(self.failure):
                break
        self.stop(Status.FAILURE)
        yield self
