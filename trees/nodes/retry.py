"""Try, recover, try again."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Composite

from trees.failures import Failure
from trees.nodes.judgements import failure_of, followed_by
from trees.nodes.ports import WithPorts, ports


class Retry(WithPorts, Composite):
    """Ticks ``attempt``; when that fails, ticks ``recover`` and tries again, up to a number of attempts.

    It gives up earlier when the failure is hopeless, or when the recovery itself fails. Its failure is that
    of the last attempt, with those of earlier attempts as causes.

    Attributes:
        failure: Why it gave up; None otherwise.
        attempts: Attempts begun.
        limit, hopeless: How many at most, and the judgement that it was made with.
        transparent: It structures, and is left out of places in the tree.
    """

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports(failure=Failure)
    transparent = True

    def __init__(
        self,
        name: str,
        attempt: Behaviour,
        recover: Behaviour,
        attempts: int,
        hopeless: Callable[[Failure, Failure | None], bool],
    ) -> None:
        """Make the node.

        Args:
            name: Its name.
            attempt: What is tried.
            recover: What makes another attempt possible.
            attempts: How many attempts at most, at least 1.
            hopeless: Tells from an attempt's failure, and the one before, that no other attempt can help.
        """
        super().__init__(name, [attempt, recover])
        self.failure: Failure | None = None
        self.attempts = 0
        self.wiring: Mapping[str, str] = {}
        self._attempt, self._recover = attempt, recover
        self.limit = attempts
        self.hopeless = hopeless
        self._earlier: list[Failure] = []

    def wire(self, namespace: str) -> None:
        """Connect the ports inside a tree's namespace."""
        self.setup_ports({"failure": self.wiring.get("failure", "failure")}, namespace)

    def tick(self) -> Iterator[Behaviour]:
        """Tick the child whose turn it is; attempt and recovery may follow each other in one tick."""
        if self.status is not Status.RUNNING:
            self._start()
        while True:
            child = self.current_child
            if child is None:
                raise RuntimeError(f"{self.name} has no child to tick")
            yield from child.tick()
            if child.status is Status.RUNNING:
                self.status = Status.RUNNING
                break
            if not self._advance(child):
                break
        yield self

    def _start(self) -> None:
        for child in self.children:
            if child.status is not Status.INVALID:
                child.stop(Status.INVALID)
        self.failure, self.attempts, self._earlier = None, 1, []
        self.current_child = self._attempt
        self.feedback_message = f"attempt 1 of {self.limit}"

    def _advance(self, child: Behaviour) -> bool:
        """Choose what comes after a child that ended; False when this node has ended."""
        if child.status is Status.SUCCESS:
            if child is self._attempt:
                self.stop(Status.SUCCESS)
                return False
            self.attempts += 1
            self.current_child = self._attempt
            self.feedback_message = f"attempt {self.attempts} of {self.limit}"
            return True
        failure = failure_of(child) or Failure.error(f"{child.name} failed without a reason")
        if child is self._attempt:
            before = self._earlier[-1] if self._earlier else None
            self._earlier.append(failure)
            if self.attempts < self.limit and not self.hopeless(failure, before):
                self._set_output("failure", failure)
                self.current_child = self._recover
                self.feedback_message = f"recovering from: {failure.message}"
                return True
            self.failure = self._chain(failure, self._earlier[:-1])
        else:
            self.failure = self._chain(failure, self._earlier)
        self.feedback_message = f"gave up after {self.attempts} of {self.limit} attempts"
        self.stop(Status.FAILURE)
        return False

    @staticmethod
    def _chain(failure: Failure, earlier: list[Failure]) -> Failure:
        chained: Failure | None = None
        for link in [*earlier, failure]:
            chained = followed_by(link, chained)
        return failure if chained is None else chained
