"""Press a button: look, make a fist, plan, reach, press by feel, and draw back."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from trees.leaves.go_home import GoHome
from trees.leaves.release import Release
from trees.leaves.stream_motion import StreamMotion
from trees.nodes.best_effort import BestEffort
from trees.nodes.retry import Retry
from trees.skills.controls.fingers import MakeFist
from trees.skills.controls.press_in import DrawBackFrom, PressIn
from trees.skills.controls.turn_knob import (
    ATTEMPTS,
    looking,
    planned,
    recover,
    sequence,
    tidy,
    turning_again_is_useless,
)
from trees.toolbox import Toolbox


def press(toolbox: Toolbox) -> Behaviour:
    """The whole skill. Reads "task" of the tree's namespace, writes "evidence"."""
    attempt = sequence(
        "attempt",
        MakeFist("make a fist", toolbox),
        planned(toolbox, ("reach", "approach")),
        StreamMotion("stream reach", toolbox, {"checked": "checked_reach"}),
        StreamMotion("stream approach", toolbox, {"checked": "checked_approach"}),
        PressIn("press in", toolbox),
        DrawBackFrom("draw back", toolbox),
        BestEffort(Release("open gripper", toolbox)),
        BestEffort(GoHome("go home", toolbox)),
    )
    attempts = Retry("attempts", attempt, recover(toolbox), ATTEMPTS, turning_again_is_useless)
    return tidy(toolbox, "press", sequence("press it", looking(toolbox), attempts))
