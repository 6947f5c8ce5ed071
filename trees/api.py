"""All that the author of a skill needs, from one module.

The record and its words, what tasks are made of, the base classes of leaves, the nodes between them, what can
be asked of the planner, and the leaves and trees that skills share. A name is loaded when it is first asked
for, so that the ``__init__`` of a skill's folder can import its ``Skill`` from here and stay light.
"""

from __future__ import annotations

import importlib
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour
    from py_trees.common import Status
    from py_trees.composites import Sequence

    from kinematics.model.robot_description import Hand
    from kinematics.requests.gesture import GestureRequest
    from kinematics.requests.move import MoveRequest, RetreatRequest
    from kinematics.requests.step import NoPlan
    from kinematics.requests.view import ViewRequest
    from trees.beliefs.grounding.destination import Place
    from trees.beliefs.scene.held_object import HeldObject
    from trees.events import Measured, Offered, Said
    from trees.failures import Failure, FailureKind, Number, Reason
    from trees.leaves.check_trajectory import CheckTrajectory
    from trees.leaves.go_home import GoHome, tidily
    from trees.leaves.stream_motion import StreamMotion
    from trees.leaves.wait import Hold
    from trees.nodes.alternatives import Alternatives
    from trees.nodes.best_effort import BestEffort
    from trees.nodes.clean_up import CleanUp
    from trees.nodes.contract import Contract
    from trees.nodes.deadline import Deadline
    from trees.nodes.job_leaf import JobLeaf
    from trees.nodes.judgements import defect, judgement, looking_elsewhere_is_useless
    from trees.nodes.leaf import DONE, RUNNING, Leaf
    from trees.nodes.motion_leaf import MotionLeaf
    from trees.nodes.planned_motion_leaf import PlannedMotionLeaf
    from trees.nodes.ports import optional, ports
    from trees.nodes.retry import Retry
    from trees.policy import Gaze
    from trees.port_values import Target
    from trees.skill import After, Before, Evidence, Need, Skill, as_answered, as_asked
    from trees.skills.carrying.get_in_hand import get_in_hand
    from trees.skills.looking.locate import Locate
    from trees.skills.looking.look_at import LookAt
    from trees.skills.looking.search_place import search_place
    from trees.skills.searching.look_elsewhere import found_by_turning, where_it_may_be
    from trees.skills.talking.tree import Say
    from trees.skills.walking.ready_to_walk import ReadyToWalk
    from trees.skills.walking.walk_to import WalkTo
    from trees.tasks import Count, Destination, ObjectDescription, ObjectOf, Relation, Task, Thing
    from trees.toolbox import Toolbox

__all__ = [
    "DONE",
    "RUNNING",
    "After",
    "Alternatives",
    "Before",
    "Behaviour",
    "BestEffort",
    "CheckTrajectory",
    "CleanUp",
    "Contract",
    "Count",
    "Deadline",
    "Destination",
    "Evidence",
    "Failure",
    "FailureKind",
    "Gaze",
    "GestureRequest",
    "GoHome",
    "Hand",
    "HeldObject",
    "Hold",
    "JobLeaf",
    "Leaf",
    "Locate",
    "LookAt",
    "Measured",
    "MotionLeaf",
    "MoveRequest",
    "Need",
    "NoPlan",
    "Number",
    "ObjectDescription",
    "ObjectOf",
    "Offered",
    "Place",
    "PlannedMotionLeaf",
    "ReadyToWalk",
    "Reason",
    "Relation",
    "RetreatRequest",
    "Retry",
    "Said",
    "Say",
    "Sequence",
    "Skill",
    "Status",
    "StreamMotion",
    "Target",
    "Task",
    "Thing",
    "Toolbox",
    "ViewRequest",
    "WalkTo",
    "as_answered",
    "as_asked",
    "defect",
    "found_by_turning",
    "get_in_hand",
    "judgement",
    "looking_elsewhere_is_useless",
    "optional",
    "ports",
    "search_place",
    "tidily",
    "where_it_may_be",
]

_FROM = MappingProxyType(
    {
        "Hand": "kinematics.model.robot_description",
        "GestureRequest": "kinematics.requests.gesture",
        "MoveRequest": "kinematics.requests.move",
        "RetreatRequest": "kinematics.requests.move",
        "NoPlan": "kinematics.requests.step",
        "ViewRequest": "kinematics.requests.view",
        "Behaviour": "py_trees.behaviour",
        "Status": "py_trees.common",
        "Sequence": "py_trees.composites",
        "Place": "trees.beliefs.grounding.destination",
        "HeldObject": "trees.beliefs.scene.held_object",
        "Measured": "trees.events",
        "Offered": "trees.events",
        "Said": "trees.events",
        "Failure": "trees.failures",
        "FailureKind": "trees.failures",
        "Number": "trees.failures",
        "Reason": "trees.failures",
        "CheckTrajectory": "trees.leaves.check_trajectory",
        "GoHome": "trees.leaves.go_home",
        "StreamMotion": "trees.leaves.stream_motion",
        "Hold": "trees.leaves.wait",
        "Alternatives": "trees.nodes.alternatives",
        "BestEffort": "trees.nodes.best_effort",
        "CleanUp": "trees.nodes.clean_up",
        "Contract": "trees.nodes.contract",
        "Deadline": "trees.nodes.deadline",
        "JobLeaf": "trees.nodes.job_leaf",
        "defect": "trees.nodes.judgements",
        "judgement": "trees.nodes.judgements",
        "looking_elsewhere_is_useless": "trees.nodes.judgements",
        "DONE": "trees.nodes.leaf",
        "RUNNING": "trees.nodes.leaf",
        "Leaf": "trees.nodes.leaf",
        "MotionLeaf": "trees.nodes.motion_leaf",
        "PlannedMotionLeaf": "trees.nodes.planned_motion_leaf",
        "optional": "trees.nodes.ports",
        "ports": "trees.nodes.ports",
        "Retry": "trees.nodes.retry",
        "Gaze": "trees.policy",
        "Target": "trees.port_values",
        "After": "trees.skill",
        "Before": "trees.skill",
        "Evidence": "trees.skill",
        "Need": "trees.skill",
        "Skill": "trees.skill",
        "as_answered": "trees.skill",
        "as_asked": "trees.skill",
        "get_in_hand": "trees.skills.carrying.get_in_hand",
        "Locate": "trees.skills.looking.locate",
        "LookAt": "trees.skills.looking.look_at",
        "search_place": "trees.skills.looking.search_place",
        "found_by_turning": "trees.skills.searching.look_elsewhere",
        "where_it_may_be": "trees.skills.searching.look_elsewhere",
        "Say": "trees.skills.talking.tree",
        "tidily": "trees.leaves.go_home",
        "ReadyToWalk": "trees.skills.walking.ready_to_walk",
        "WalkTo": "trees.skills.walking.walk_to",
        "Count": "trees.tasks",
        "Destination": "trees.tasks",
        "ObjectDescription": "trees.tasks",
        "ObjectOf": "trees.tasks",
        "Relation": "trees.tasks",
        "Task": "trees.tasks",
        "Thing": "trees.tasks",
        "Toolbox": "trees.toolbox",
    }
)
"""Where each name is from."""

if not TYPE_CHECKING:  # so that a name that is none is told by a type checker

    def __getattr__(name: str) -> Any:
        """Load a name; the next time it is there already."""
        if name not in _FROM:
            raise AttributeError(
                f"module {__name__!r} has no attribute {name!r}; it has {', '.join(__all__)}"
            )
        found = globals()[name] = getattr(importlib.import_module(_FROM[name]), name)
        return found
