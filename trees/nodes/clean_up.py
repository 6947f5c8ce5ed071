"""After a failure, leave things tidy; it remains a failure."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Composite

from trees.failures import Failure
from trees.nodes.judgements import failure_of


class CleanUp(Composite):
    """Ticks ``main``; when that fails, ticks ``after`` to tidy up, and fails with the failure of ``main``.

    What ``after`` comes to makes no difference.

    Attributes:
        failure: Why ``main`` failed; None otherwise.
        worth_it: The judgement that it was made with.
        transparent: It structures, and is left out of places in the tree.
    """

    transparent = True

    def __init__(
        self, name: str, main: Behaviour, after: Behaviour, worth_it: Callable[[Failure], bool]
    ) -> None:
        """Make the node.

        Args:
            name: Its name.
            main: What is to be done.
            after: What is done when that failed.
            worth_it: Tells from the failure whether ``after`` should be tried.
        """
        super().__init__(name, [main, after])
        self.failure: Failure | None = None
        self._main, self._after = main, after
        self.worth_it = worth_it

    def tick(self) -> Iterator[Behaviour]:
        """Tick the main child, or what follows its failure."""
        if self.status is not Status.RUNNING:
            for child in self.children:
                if child.status is not Status.INVALID:
                    child.stop(Status.INVALID)
            self.failure = None
            self.current_child = self._main
        if self.current_child is self._main:
            yield from self._main.tick()
            if self._main.status is Status.FAILURE:
                self.failure = failure_of(self._main)
                self.feedback_message = "" if self.failure is None else self.failure.message
                if self.failure is not None and self.worth_it(self.failure):
                    self.current_child = self._after
        if self.current_child is self._after:
            yield from self._after.tick()
        status = self.current_child.status if self.current_child is not None else Status.FAILURE
        if status is Status.RUNNING:
            self.status = Status.RUNNING
        elif self.failure is None and status is Status.SUCCESS:
            self.stop(Status.SUCCESS)
        else:
            self.stop(Status.FAILURE)
        yield self
