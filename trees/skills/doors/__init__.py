"""Open and close hinged doors and drawers."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING

from trees.skill import After, Need, Skill, Written
from trees.tasks import CloseTask, OpenTask

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox


def _open(_task: OpenTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.doors.open import open_or_close

    return open_or_close(toolbox)


def _close(_task: CloseTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.doors.close import close

    return close(toolbox)


def _about(written: Written) -> str | None:
    """The drawer, or what the door belongs to."""
    from robots.scenes.articulated import DRAWER
    from trees.beliefs.openings.handles import BODY_OF

    handle = written("handle")
    if handle is None:
        return None
    if handle.kind == DRAWER:
        return str(handle.part)
    return BODY_OF[handle.kind] if handle.moves is None else str(handle.moves.of)


def _refuses(task: OpenTask | CloseTask, fronts: Collection[str]) -> str:
    from trees.skills.doors.meant_part import opens_nothing

    return opens_nothing(task, fronts)


SKILLS = (
    Skill(
        task=OpenTask,
        tree=_open,
        example="open the fridge",
        needs=frozenset({Need.HAND, Need.BARS}),
        after=frozenset({After.THING_OPEN}),
        about=_about,
        goes_away=True,
        refuses=_refuses,
    ),
    Skill(
        task=CloseTask,
        tree=_close,
        example="close the drawer",
        needs=frozenset({Need.HAND, Need.BARS}),
        about=_about,
        goes_away=True,
        refuses=_refuses,
    ),
)
