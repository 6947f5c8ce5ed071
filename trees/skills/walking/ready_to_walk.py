"""Stand upright, ready to walk: hands at home, or what is held level before the shoulder."""

from __future__ import annotations

import math
from collections.abc import Mapping

from py_trees.common import Status

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.model.standing_robot import StandingRobot
from kinematics.model.walking_settings import UPRIGHT_RAD
from kinematics.requests.gesture import CarryRequest, GestureRequest
from kinematics.requests.move import MoveRequest
from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure, FailureKind
from trees.leaves.go_home import GoHome
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING
from trees.nodes.planned_motion_leaf import move_from_here
from trees.nodes.ports import ports
from trees.readings.held import held_object
from trees.skills.walking.empty_arms import are_at, arms_are_tucked, home_joints, tucked_joints
from trees.skills.walking.walking_leaf import hands_have_room
from trees.toolbox import Toolbox

_LEVEL_RAD = 0.035
_TALL_RAD = 0.03
_HEIGHT_M = 0.02


class ReadyToWalk(GoHome):
    """Stand upright with the hands as a walk needs them.

    Pelvis, trunk and empty hands go home; a held object is brought upright before the shoulder, where it is
    carried.
    """

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="none",
        postcondition="every body joint is measured to be at home, where the held object is level, or arms "
        "are drawn in",
        deadline_s=30.0,
        moves="body",
        on_success="the robot stands upright; what it holds is level; where hands have no room at home, the "
        "arms are drawn in",
    )

    def __init__(
        self,
        name: str,
        toolbox: Toolbox,
        wiring: Mapping[str, str] | None = None,
        *,
        only_if_it_leans: bool = False,
    ) -> None:
        """Make the leaf.

        Args:
            name: Its name.
            toolbox: What it may call.
            wiring: As for every leaf.
            only_if_it_leans: Leave everything as it is where the pelvis is upright enough to set out.
        """
        super().__init__(name, toolbox, wiring)
        self._only_if_it_leans = only_if_it_leans

    def begin(self) -> None:
        """Plan the way home first."""
        self._barred: Failure | None = None
        super().begin()

    def goal(self) -> MoveRequest | GestureRequest | Failure | None:
        """Home with empty hands; else the carrying posture, unless it is taken already.

        Nobody walks with what leans in a hand by nobody knows how much.
        """
        toolbox = self.toolbox
        leaning = toolbox.world.leans & toolbox.world.scene.attached.keys()
        if leaning:
            names = " and ".join(f"the {name}" for name in sorted(leaning))
            return Failure.infeasible(
                f"{names} was taken steeply and may lean in the hand: a walk might spill it"
            )
        if self._only_if_it_leans and _leans_by_at_most(UPRIGHT_RAD, toolbox.motion.reference()):
            return None
        held = held_object(toolbox, None, None)
        if isinstance(held, Failure):
            if self._barred is not None:
                return self._drawn_in()
            if arms_are_tucked(toolbox) and hands_have_room(toolbox) is False:
                return None if self._stands_tall(toolbox.motion.reference()) else self._drawn_in()
            return super().goal()
        if self._carries(held):
            return None
        return CarryRequest(
            q_start=toolbox.motion.reference(),
            stance=toolbox.motion.stance(),
            scene=toolbox.world.scene,
            held=held.name,
            seed=int(toolbox.rng.integers(2**31)),
        )

    def step(self) -> Status | Failure:
        """Where hands have no room at home, arms that are drawn in are ready as well."""
        outcome = super().step()
        if not isinstance(outcome, Failure) or outcome.kind is not FailureKind.INFEASIBLE:
            return outcome
        toolbox = self.toolbox
        if arms_are_tucked(toolbox) and self._stands_tall(toolbox.motion.reference()):
            return DONE
        if self._barred is not None or toolbox.world.scene.attached or not tucked_joints(toolbox):
            return self._barred or outcome
        self._barred = outcome
        super().begin()
        return RUNNING

    def _drawn_in(self) -> MoveRequest:
        toolbox = self.toolbox
        return move_from_here(toolbox, tucked_joints(toolbox))

    def _carries(self, held: HeldObject) -> bool:
        toolbox = self.toolbox
        model, q = toolbox.model, toolbox.motion.reference()
        item = model.frame_pose(q, model.description.tcp_frames[held.hand]) @ held.tcp_T_object
        level = bool(item[2, 2] >= math.cos(_LEVEL_RAD))
        return level and self._stands_tall(q) and are_at(toolbox, home_joints(toolbox))

    def _stands_tall(self, q: Array) -> bool:
        toolbox = self.toolbox
        home_m = float(StandingRobot.of(toolbox.model, toolbox.motion.stance()).q_home[2])
        return _leans_by_at_most(_TALL_RAD, q) and abs(float(q[2]) - home_m) <= _HEIGHT_M


def _leans_by_at_most(angle_rad: float, q: Array) -> bool:
    """Whether the pelvis of a configuration is so upright."""
    return bool(poses.rotation_from_quaternion(q[3:7])[2, 2] >= math.cos(angle_rad))
