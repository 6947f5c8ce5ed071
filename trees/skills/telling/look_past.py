"""Look past what hides things."""

from __future__ import annotations

from kinematics.requests.view import ViewRequest
from trees.beliefs.grounding.destination import aim_of, words_of
from trees.beliefs.sight.hidden_places import hidden_places
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf
from trees.nodes.ports import ports


class LookPast(PlannedMotionLeaf):
    """Move head, trunk and pelvis so that the camera sees past what hides something.

    Of the postures that can be reached, the one is taken that shows most of what no look has shown yet.
    """

    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="tops were seen",
        postcondition="the robot is measured to be in a posture that shows places which no look has shown",
        deadline_s=30.0,
        moves="body",
        on_success="the head holds the gaze",
    )

    def goal(self) -> ViewRequest | Failure:
        """Towards what is left to be seen."""
        toolbox, world, task = self.toolbox, self.toolbox.world, self.get_input("task")
        wanted = aim_of(task)
        if getattr(task, "object", None) is None:  # people do not hide behind what stands on a table
            return Failure.postcondition(f"no {words_of(wanted)} seen")
        clear_m = toolbox.policy.blocked_by_hand_m
        points, worth = hidden_places(world.scene, world.glimpses, toolbox.model.description.camera, clear_m)
        if len(points) == 0:
            return Failure.postcondition(f"no {words_of(wanted)} seen, and every place was looked at")
        self.measured(unseen_places=len(points))
        return ViewRequest(
            q_start=toolbox.motion.reference(),
            stance=toolbox.motion.stance(),
            scene=world.scene,
            points_m=points,
            worth=worth,
            clear_m=clear_m,
            seed=int(toolbox.rng.integers(2**31)),
        )
