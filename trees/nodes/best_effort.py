"""Something that helps when it works, and does no harm when it does not."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.decorators import Decorator

from trees.nodes.judgements import defect, failure_of


class BestEffort(Decorator):
    """Succeeds once its child has ended, even if the child failed; only a defect makes it fail."""

    transparent = True

    def __init__(self, child: Behaviour) -> None:
        super().__init__(name=f"try to {child.name}", child=child)

    def update(self) -> Status:
        """Turn an ordinary failure into a success."""
        if self.decorated.status is not Status.FAILURE:
            return self.decorated.status
        failure = failure_of(self.decorated)
        if failure is not None and defect(failure):
            return Status.FAILURE
        self.feedback_message = "did not work; going on" if failure is None else failure.message
        return Status.SUCCESS
