"""Lower what the hand holds until it stands."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.model.robot_description import Hand
from kinematics.requests.move import RetreatRequest
from kinematics.scene.concessions import ConcessionReason, touching
from kinematics.scene.planning_scene import PlanningScene
from kinematics.scene.support_of import furniture_right_below, top_m
from robots.control.motion_handle import MotionHandle, MotionStatus
from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING
from trees.nodes.motion_leaf import MotionLeaf, motion_failure
from trees.nodes.plan_failures import why_stale
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf
from trees.nodes.ports import ports
from trees.port_values import CheckedStep, Placement
from trees.readings.touch_watch import TouchWatch
from trees.skills.place.felt_top import foot_m, note_felt_top
from trees.skills.place.settings import PlaceSettings

# Two readings in a row: one may be a jolt.
_READINGS = 2
# After a touch the body comes to rest within this.
_BRAKING_S = 0.5


class Lower(MotionLeaf):
    """Stream the checked way down, and stop as soon as the hand feels that something carries the object."""

    INPUT_PORTS = ports(checked=CheckedStep, held=HeldObject, placement=Placement)
    OUTPUT_PORTS = ports(touched=bool)
    CONTRACT = Contract(
        precondition="the object hovers over its spot, at rest",
        postcondition="the way is at its end, or the hand was lifted by the policy's force where the object "
        "should stand; which of the two is written",
        deadline_s=8.0,
        moves="body",
        on_success="the robot holds the object where it stands",
        on_failure="the robot holds the object",
        on_cancel="the robot holds the object",
    )

    def begin(self) -> None:
        """Feel the hand anew."""
        super().begin()
        hand: Hand = self.get_input("held").hand
        self._watch = TouchWatch(self.toolbox, hand)
        self._felt_n = self.toolbox.model.description.grippers[hand].felt_n
        self._placement: Placement = self.get_input("placement")
        self._strong = 0
        self._touched_s: float | None = None
        self._touched_m = 0.0

    def start(self) -> MotionHandle | Failure:
        """Start, unless the world model has changed since the check."""
        step: CheckedStep = self.get_input("checked")
        if (stale := why_stale(step.name, step.world_version, self.toolbox.world.scene.version)) is not None:
            return stale
        return self.toolbox.motion.start(step.checked)

    def step(self) -> Status | Failure:
        """Feel the hand at rest, then move and feel."""
        if self.elapsed_s < self.toolbox.policy.of(PlaceSettings).rest_s:
            self._watch.feel_rest()
            return RUNNING
        if self._touched_s is not None:
            return RUNNING if self.elapsed_s < self._touched_s + _BRAKING_S else self._judge_touch()
        if self._handle is None:
            started = self.start()
            if isinstance(started, Failure):
                return started
            self._handle = started
            return motion_failure(started) or RUNNING  # the sensors speak of the time before
        if (ended := motion_failure(self._handle)) is not None:
            return ended
        trajectory = None if self._handle.finished else self.get_input("checked").checked.trajectory
        lift_n = float(self._watch.feel(trajectory, self._handle.progress)[2])
        self._strong = self._strong + 1 if lift_n >= self._felt_n else 0
        self.feedback_message = f"{self._handle.progress:.0%}, {lift_n:.1f} N"
        if self._strong >= _READINGS:
            self.measured(lift_n=lift_n)
            self._touched_s = self.elapsed_s
            self._touched_m = foot_m(self.toolbox, self.get_input("held"))
            if not self._handle.finished:
                self.toolbox.motion.cancel(self._handle, "what the hand holds stands")
            return RUNNING
        if self._handle.status is MotionStatus.RUNNING:
            return RUNNING
        self._set_output("touched", False)
        return DONE

    def release(self, reason: str) -> None:
        """Brake and hold."""
        super().release(reason)

    @property
    def deadline_s(self) -> float:
        """The contract's deadline, longer by the motion's duration."""
        step: CheckedStep = self.get_input("checked")
        return self.CONTRACT.deadline_s + step.checked.trajectory.duration_s

    def _judge_touch(self) -> Status | Failure:
        placement, held = self._placement, self.get_input("held")
        model = self.toolbox.model
        q = self.toolbox.sensing.state().q
        tcp = model.frame_pose(q, model.description.tcp_frames[held.hand])
        early_m = float((tcp @ held.tcp_T_object)[2, 3] - placement.odom_T_object[2, 3])
        self.measured(above_plan_m=early_m)
        if early_m > self.toolbox.policy.of(PlaceSettings).early_touch_m:
            return Failure.postcondition(
                f"something is in the way of the {held.name}",
                above_m=early_m,
                tolerance_m=self.toolbox.policy.of(PlaceSettings).early_touch_m,
            )
        note_felt_top(self.toolbox, held, placement, self._touched_m)
        self._set_output("touched", True)
        self.feedback_message = "it stands"
        return DONE


class LowerFurther(PlannedMotionLeaf):
    """Go down a little farther if the hand has not felt anything yet.

    The furniture below is then lower than it was seen to be. If the object stands already, nothing moves.
    """

    INPUT_PORTS = ports(held=HeldObject, placement=Placement, touched=bool)
    OUTPUT_PORTS = ports(touched_now=bool)
    CONTRACT = Contract(
        precondition="the hand holds the object over its spot",
        postcondition="as that of Lower; nothing moves when it stands already",
        deadline_s=10.0,
        moves="body",
        on_success="the robot holds the object where it stands",
        on_failure="the robot holds the object",
        on_cancel="the robot holds the object",
    )

    def begin(self) -> None:
        """Feel the hand anew."""
        super().begin()
        hand: Hand = self.get_input("held").hand
        self._watch = TouchWatch(self.toolbox, hand)
        self._felt_n = self.toolbox.model.description.grippers[hand].felt_n
        self._strong = 0
        self._touched_s: float | None = None
        self._touched_m = 0.0

    def goal(self) -> RetreatRequest | None:
        """A little straight down."""
        if self.get_input("touched"):
            return None
        toolbox, held, placement = self.toolbox, self.get_input("held"), self.get_input("placement")
        # it gets there only if nothing carries it before: a touch ends the motion
        comes_to_m = foot_m(toolbox, held) - toolbox.policy.of(PlaceSettings).further_m
        scene = lowered_supports(toolbox.world.scene, placement.touches, comes_to_m)
        place_m = np.array([*placement.odom_T_object[:2, 3], comes_to_m])
        near = dict.fromkeys((*placement.touches, *furniture_right_below(place_m, toolbox.world.scene)))
        return RetreatRequest(
            q_start=toolbox.motion.reference(),
            stance=toolbox.motion.stance(),
            scene=scene,
            hand=held.hand,
            world_offset_m=(0.0, 0.0, -toolbox.policy.of(PlaceSettings).further_m),
            concessions=touching([held.name], near, ConcessionReason.SUPPORT_OF_HELD_OBJECT, "retreat"),
        )

    def step(self) -> Status | Failure:
        """Plan and check while the hand is felt at rest; then move and feel."""
        if self._touched_s is not None:
            if self.elapsed_s < self._touched_s + _BRAKING_S:
                return RUNNING
            self._set_output("touched_now", True)
            note_felt_top(self.toolbox, self.get_input("held"), self.get_input("placement"), self._touched_m)
            return DONE
        if self._handle is None:
            self._watch.feel_rest()
        outcome = super().step()
        if self._handle is None or isinstance(outcome, Failure) or self._handle.progress == 0.0:
            return outcome
        if self._checked is None:
            raise RuntimeError(f"{self.name} moves without a checked trajectory")
        trajectory = None if self._handle.finished else self._checked.trajectory
        lift_n = float(self._watch.feel(trajectory, self._handle.progress)[2])
        self._strong = self._strong + 1 if lift_n >= self._felt_n else 0
        if self._strong >= _READINGS:
            self._touched_s = self.elapsed_s
            self._touched_m = foot_m(self.toolbox, self.get_input("held"))
            if not self._handle.finished:
                self.toolbox.motion.cancel(self._handle, "what the hand holds stands")
            return RUNNING
        return outcome


def lowered_supports(scene: PlanningScene, names: Iterable[str], below_m: float) -> PlanningScene:
    """The scene with furniture no higher than what was lowered onto it and did not touch it.

    Fingers keep a margin from a top for the error of its height; a top that is known to be lower than it
    seemed would keep them from going on by an error that it has not got.

    Args:
        scene: As it was seen.
        names: Of what should have carried the object; what is no furniture is left as it is.
        below_m: Height of the object's lowest point.
    """
    for name in names:
        item = scene.objects.get(name)
        if item is None or item.movable or top_m(item) <= below_m:
            continue
        down = poses.translation(0.0, 0.0, below_m - top_m(item))
        scene = scene.with_object(replace(item, world_T_object=down @ item.world_T_object))
    return scene
