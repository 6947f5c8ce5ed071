"""Put an object on a board behind a door that is open: come within reach, find room, set it down, look."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.leaves.go_home import GoHome, tidily
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.judgements import looking_elsewhere_is_useless
from trees.skills.carrying.draw_back import DrawBack
from trees.skills.carrying.get_in_hand import get_in_hand
from trees.skills.carrying.look_at_placement import LookAtPlacement
from trees.skills.carrying.regrasp import regrasping
from trees.skills.looking.survey import Survey
from trees.skills.place.tree import bring
from trees.skills.place.verify_placed import VerifyPlaced
from trees.skills.put_in.ask_for_hand import AskForHand
from trees.skills.put_in.come_to_board import come_to_board
from trees.skills.put_in.find_board_room import FindBoardRoom
from trees.skills.put_in.look_at_board import LookAtBoard
from trees.skills.put_in.not_shut import NotShut
from trees.skills.put_in.settings import PutInSettings
from trees.toolbox import Toolbox


def put_behind_door(toolbox: Toolbox) -> Behaviour:
    """The whole skill. Reads "task" of the tree's namespace, writes "evidence"."""
    policy = toolbox.policy
    carry: list[Behaviour] = [
        # who stands beside an open door reaches in with the hand beside the hinge; with the other one hardly
        get_in_hand(toolbox, with_hand=AskForHand("say which hand", toolbox)),
        NotShut("is it open after all", toolbox),
        come_to_board(toolbox),
        bring(toolbox, find_board_room),
    ]
    children: list[Behaviour] = [
        NotShut("is it open", toolbox),
        regrasping(carry, toolbox),
        BestEffort(DrawBack("draw back", toolbox)),
        GoHome("clear the view", toolbox),
        BestEffort(LookAtPlacement("look", toolbox)),
        VerifyPlaced("verify placed", toolbox, policy.of(PutInSettings).shelved_tolerance_m),
    ]
    return tidily("put in", children, toolbox, policy.task_timeout_s + policy.walk_timeout_s)


def find_board_room(toolbox: Toolbox) -> Behaviour:
    """Look at the boards, and once more with the hand drawn in. Reads "held", writes "spots"."""
    away: list[Behaviour] = [GoHome("hand away", toolbox)]
    ways = [_looks("look at the boards", [], toolbox), _looks("draw the hand in", away, toolbox)]
    return Alternatives("find room", ways, hopeless=looking_elsewhere_is_useless)


def _looks(name: str, before: list[Behaviour], toolbox: Toolbox) -> Behaviour:
    other: list[Behaviour] = [
        LookAtBoard("look at another board", toolbox, 1),
        Survey("survey", toolbox, {"sightings_now": "sightings"}),
    ]
    looks: list[Behaviour] = [
        *before,
        BestEffort(Sequence("another board", memory=True, children=other)),
        LookAtBoard("look at the board", toolbox),
        FindBoardRoom("find room", toolbox),
    ]
    return Sequence(name, memory=True, children=looks)
