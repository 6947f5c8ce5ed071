"""Look once more before the hand closes in."""

from __future__ import annotations

from py_trees.common import Status

from trees.beliefs.scene.recognition import nearest_sighting
from trees.beliefs.sight.sight import behind_a_hand, in_view
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.port_values import Target
from trees.skills.looking.look_leaf import LookLeaf, View, estimates_of
from trees.skills.pick.settings import PickSettings


class ConfirmTarget(LookLeaf):
    """Look once more before the hand closes in, and measure that the target is where the grasp was planned.

    A target that cannot be seen from here, because a hand hides it or it is out of view, is taken to be where
    it was; whether the hand holds it shows later. A target that should be visible and is not has gone. The
    world model stays as it is, so that the checked approach stays valid.
    """

    INPUT_PORTS = ports(target=Target)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the hand is at the pre-grasp pose, the head at rest",
        postcondition="the target was seen within the tolerance of where it was planned for, or cannot be "
        "seen from here",
        deadline_s=2.0,
    )

    def judge(self, views: list[View]) -> Status | Failure:
        """Compare the new sighting with the plan's."""
        target: Target = self.get_input("target")
        policy, model = self.toolbox.policy, self.toolbox.model
        planned = target.odom_T_object[:3, 3]
        found = nearest_sighting(
            target, planned, estimates_of(views), self.toolbox.world.scene, policy.same_object_m
        )
        if found is not None:
            moved_m = found[1]
            self.measured(moved_m=moved_m)
            if moved_m > policy.of(PickSettings).moved_tolerance_m:
                return Failure.postcondition(
                    f"the {target.name} is not where it was",
                    moved_m=moved_m,
                    tolerance_m=policy.of(PickSettings).moved_tolerance_m,
                ).because(Reason.MOVED_SINCE_LOOK)
            self.feedback_message = f"seen {moved_m * 1000:.0f} mm from where it was planned for"
            return DONE
        odom_T_camera, eye = views[-1].odom_T_camera, views[-1].odom_T_camera[:3, 3]
        q = self.toolbox.sensing.state().q
        if in_view(model.description.camera, odom_T_camera, planned) and not behind_a_hand(
            model, q, eye, planned, policy.hidden_by_hand_m
        ):
            gone = Failure.postcondition(f"the {target.name} is no longer there", frames=len(views))
            return gone.because(Reason.GONE_SINCE_LOOK)
        self.feedback_message = "hidden; taken to be where it was"
        return DONE
