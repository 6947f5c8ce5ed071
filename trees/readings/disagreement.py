"""Tell that two senses disagree."""

from __future__ import annotations

from trees.events import NotSo, Said
from trees.failures import Failure
from trees.toolbox import Toolbox


def tell_disagreement(toolbox: Toolbox, failure: Failure) -> None:
    """Tell people, and whoever reads events, that two senses disagree, while the task goes on.

    A task says each disagreement once.

    Args:
        toolbox: Tells it.
        failure: What does not agree, with its reason; where it fails the task it tells itself.
    """
    if toolbox.world.is_new_reason(f"{failure.reason.name}: {failure.message}"):
        now_s = toolbox.clock.now_s()
        toolbox.events(NotSo(now_s, failure))
        toolbox.events(Said(now_s, failure.message))
