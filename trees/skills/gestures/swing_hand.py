"""Wave the raised hand."""

from __future__ import annotations

from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.ik.arm_frames import arm_share
from kinematics.requests.gesture import SwingRequest
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf
from trees.nodes.ports import ports
from trees.skills.gestures.settings import GestureSettings


class SwingHand(PlannedMotionLeaf):
    """Swing the raised hand from side to side, and count the swings that the encoders show."""

    INPUT_PORTS = ports(waving_hand=str)
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="the hand is raised",
        postcondition="so many swings of such a width were measured as the policy asks for",
        deadline_s=30.0,
        moves="body",
        on_success="the hand is raised and still",
    )

    def goal(self) -> SwingRequest:
        """Swings from where the hand is."""
        settings = self.toolbox.policy.of(GestureSettings)
        self._aside_m: list[float] = []
        return SwingRequest(
            q_start=self.toolbox.motion.reference(),
            stance=self.toolbox.motion.stance(),
            scene=self.toolbox.world.scene,
            hand=self.get_input("waving_hand"),
            width_m=self._share() * settings.wave_width_m,
            swings=settings.wave_swings,
        )

    def step(self) -> Status | Failure:
        """Move, and watch the hand."""
        outcome = super().step()
        if self._handle is not None:
            self._aside_m.append(self._hand_aside_m())
        if outcome is not DONE:
            return outcome
        settings = self.toolbox.policy.of(GestureSettings)
        swings = swings_in(self._aside_m, self._share() * settings.wave_least_m)
        numbers = {"swings": swings, "width_m": max(self._aside_m) - min(self._aside_m)}
        self.measured(**numbers)
        if swings < settings.wave_least_swings:
            return Failure.postcondition("the hand did not swing enough", None, **numbers)
        self._set_output("evidence", {"hand": self.get_input("waving_hand"), **numbers})
        return DONE

    def _share(self) -> float:
        return arm_share(self.toolbox.model, self.get_input("waving_hand"))

    def _hand_aside_m(self) -> float:
        """Where the measured hand is across the camera's heading."""
        model, q = self.toolbox.model, self.toolbox.sensing.state().q
        frame = model.description.tcp_frames[self.get_input("waving_hand")]
        camera, hand = model.frame_poses(q, [model.description.camera.frame, frame])
        return float((poses.inverse(camera) @ hand)[0, 3])


def swings_in(aside_m: list[float], least_m: float) -> int:
    """How many times something went from one side to the other by at least so much."""
    if not aside_m:
        return 0
    count, lowest, highest, rising = 0, aside_m[0], aside_m[0], 0
    for place in aside_m:
        lowest, highest = min(lowest, place), max(highest, place)
        if rising <= 0 and place - lowest >= least_m:
            count, rising, lowest, highest = count + 1, 1, place, place
        elif rising >= 0 and highest - place >= least_m:
            count, rising, lowest, highest = count + 1, -1, place, place
        elif rising > 0 and place == highest:
            lowest = place
        elif rising < 0 and place == lowest:
            highest = place
    return count
