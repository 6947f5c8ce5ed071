"""Stand where something that is held can be put on a board behind an open door."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.nodes.alternatives import Alternatives
from trees.nodes.judgements import defect
from trees.nodes.wiring import rewired
from trees.skills.put_in.ask_for_walk import AskForWalk
from trees.skills.put_in.cannot_walk import CannotWalk
from trees.skills.put_in.choose_stand_to_put import ChooseStandToPut
from trees.skills.walk_to.tree import find_place, walks
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.toolbox import Toolbox


def come_to_board(toolbox: Toolbox) -> Behaviour:
    """Nothing for a robot that cannot walk; else find it, walk there, look again, and correct.

    Reads "task" and "held".
    """
    steps = Sequence(
        "walk there",
        memory=True,
        children=[
            find_place(toolbox),
            ReadyToWalk("carry it level", toolbox),
            walks(toolbox, ChooseStandToPut("choose where to stand", toolbox)),
        ],
    )
    walk = Sequence(
        "come within reach",
        memory=True,
        children=[
            AskForWalk("say where to", toolbox),
            rewired(steps, {"task": "walk_task", "evidence": "walk_evidence"}),
        ],
    )
    return Alternatives("come to it", [CannotWalk("cannot walk", toolbox), walk], hopeless=defect)
