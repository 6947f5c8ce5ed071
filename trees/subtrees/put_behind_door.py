"""Put an object on a board behind a door that is open: come within reach, find room, set it down, look."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.alternatives import Alternatives
from trees.best_effort import BestEffort
from trees.leaves.door_not_shut import DoorNotShut
from trees.leaves.draw_back import DrawBack
from trees.leaves.find_board_room import FindBoardRoom
from trees.leaves.go_home import GoHome
from trees.leaves.look_at_board import LookAtBoard
from trees.leaves.look_at_placement import LookAtPlacement
from trees.leaves.verify_placed import VerifyPlaced
from trees.subtrees.come_to_board import come_to_board
from trees.subtrees.have_it import have_it
from trees.subtrees.place import bring
from trees.subtrees.regrasp import regrasping
from trees.subtrees.search import looking_elsewhere_is_useless
from trees.subtrees.tidily import tidily
from trees.toolbox import Toolbox


def put_behind_door(toolbox: Toolbox) -> Behaviour:
    """The whole skill. Reads "task" of the tree's namespace, writes "evidence"."""
    carry: list[Behaviour] = [
        have_it(toolbox),
        DoorNotShut("is it open after all", toolbox),
        come_to_board(toolbox),
        bring(toolbox, find_board_room),
    ]
    children: list[Behaviour] = [
        DoorNotShut("is it open", toolbox),
        regrasping(carry, toolbox),
        BestEffort(DrawBack("draw back", toolbox)),
        GoHome("clear the view", toolbox),
        BestEffort(LookAtPlacement("look", toolbox)),
        VerifyPlaced("verify placed", toolbox),
    ]
    policy = toolbox.policy
    return tidily("put in", children, toolbox, policy.task_timeout_s + policy.walk_timeout_s)


def find_board_room(toolbox: Toolbox) -> Behaviour:
    """Look at one board after the other, later with the hand drawn in. Reads "held", writes "spots"."""
    ways: list[Behaviour] = []
    for rank, before in ((0, []), (0, [GoHome("hand away", toolbox)]), (1, [])):
        board = "the board" if rank == 0 else "another board"
        looks: list[Behaviour] = [
            *before,
            LookAtBoard(f"look at {board}", toolbox, rank),
            FindBoardRoom("find room on it", toolbox),
        ]
        name = "draw the hand in" if before else f"look at {board}"
        ways.append(Sequence(name, memory=True, children=looks))
    return Alternatives("find room", ways, hopeless=looking_elsewhere_is_useless)
