"""Whether the robot stands where it should, by what it sees from there."""

from __future__ import annotations

import math

from py_trees.common import Status

from kinematics.geometry.planar import PlanarPose
from trees.beliefs.grounding.destination import Place
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import optional, ports
from trees.readings.odometry import feet_pose
from trees.skills.walking.reachable_standing import Stand
from trees.skills.walking.standing_place import standing_place, stands_inside
from trees.skills.walking.walking_room import room_if_it_walks


class SquaredUp(Leaf):
    """Compare where the robot stands with where it should, from the last sighting of the place."""

    INPUT_PORTS = ports(place=Place, stand=optional(Stand))
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="the place was seen from where the robot stands",
        postcondition="distance and angle to the standing place are within the policy's tolerance; in a "
        "region it stands well inside",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Measure once."""
        toolbox, policy = self.toolbox, self.toolbox.policy
        body = feet_pose(toolbox)
        place: Place = self.get_input("place")
        if place.category == "region":
            return self._inside(place, body)
        stand: Stand | None = self.optional("stand")
        room = room_if_it_walks(toolbox)
        goal = standing_place(place, toolbox.world.scene, body, policy.support_gap_m, room)
        if stand is not None and stand.name == place.name:
            goal = stand.seen_again(place, goal)
        left = body.to(goal)
        off_m, off_rad = math.hypot(left.x_m, left.y_m), abs(left.yaw_rad)
        self.measured(off_m=off_m, off_rad=off_rad)
        if off_m > policy.stand_m or off_rad > policy.stand_rad:
            return Failure.postcondition(
                f"it stands {100 * off_m:.1f} cm and {math.degrees(off_rad):.1f} degrees beside its place",
                off_m=off_m,
                off_rad=off_rad,
            )
        self._set_output("evidence", {"off_m": off_m, "off_rad": off_rad})
        return DONE

    def _inside(self, place: Place, body: PlanarPose) -> Status | Failure:
        middle_m = PlanarPose.of(place.odom_T_place).distance_m(body)
        self.measured(from_middle_m=middle_m)
        if not stands_inside(place, body):
            return Failure.postcondition(f"it does not stand inside the {place.name}", from_middle_m=middle_m)
        self._set_output("evidence", {"from_middle_m": middle_m})
        return DONE
