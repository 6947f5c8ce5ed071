"""Wave, point at, look at."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trees.skill import Need, Skill
from trees.tasks import LookAtTask, PointAtTask, WaveTask

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox


def _wave(_task: WaveTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.gestures.tree import wave

    return wave(toolbox)


def _point_at(_task: PointAtTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.gestures.tree import point_at

    return point_at(toolbox)


def _look_at(_task: LookAtTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.gestures.tree import look_at

    return look_at(toolbox)


SKILLS = (
    Skill(
        task=WaveTask, tree=_wave, example="wave at Ana", toward="to", needs=frozenset({Need.ARM, Need.EYES})
    ),
    Skill(task=PointAtTask, tree=_point_at, example="point at the blue box", needs=frozenset({Need.ARM})),
    Skill(task=LookAtTask, tree=_look_at, example="look at the red cup", needs=frozenset({Need.EYES})),
)
