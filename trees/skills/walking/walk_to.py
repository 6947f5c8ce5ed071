"""Walk to where the next task can be done."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
from py_trees.common import Status

from kinematics.arrays import Array
from kinematics.geometry.planar import PlanarPose
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.steering import PathSteering, Steering, StretchSteering, foreseen
from kinematics.walking.route.path_planning import Footprint, blocked, footprints
from kinematics.walking.route.room import BESIDE_HANDS_M, WalkingRoom
from kinematics.walking.route.ways import BESIDE_TUCKED_M, NoWay, WayFinder
from trees.beliefs.grounding.destination import Place
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING
from trees.nodes.ports import optional, ports
from trees.readings.odometry import body_pose, feet_pose
from trees.skills.walking.reachable_standing import Stand
from trees.skills.walking.seen_points import SeenPoints, apart_from
from trees.skills.walking.standing_place import standing_place
from trees.skills.walking.walking_leaf import WalkingLeaf, without_held
from trees.skills.walking.walking_room import room_if_it_walks, walking_room
from trees.toolbox import Toolbox

_APPROACH_M = 0.45
"""The last stretch to furniture is straight ahead and so long."""
_BACK_M_S = 0.25
_BEYOND_M = 0.1
"""A step back goes so much farther than turning needs,"""
_BACK_SHARES = (1.0, 0.67, 0.33)
"""or not so far, where there is something behind as well."""
_AHEAD_M = 0.1
"""From the middle of the body; the hands at home reach three times as far."""
_IN_THE_WAY_M = 0.06
"""Something new that is nearer to the path than its clearance by more than this makes it plan anew."""
_ELSEWHERE_M = 0.1
"""A place to stand in a room that is nearer to the last one is the same."""
_SCAN_EVERY_S = 0.4
_SCAN_WITHIN_S, _ASKED_TIMES = 1.0, 25
_SILENT = "the range sensor says nothing"
_NO_WAY = {
    True: "the hands have no room on the way there",
    False: "no way leads there around what is known",
}


class WalkTo(WalkingLeaf):
    """Walk around all obstacles that are known or seen on the way, and stand square in front of the place.

    Where the robot is too near to something to turn, it first steps straight back. It is led by its odometry;
    how well it has arrived is measured by another leaf that looks. Made with ``if_hands_fit``, it fails
    before it sets out if the hands have no room on the whole way.
    """

    INPUT_PORTS = ports(place=Place, stand=optional(Stand))
    OUTPUT_PORTS = ports(goal=PlanarPose)
    CONTRACT = Contract(
        precondition="the place was seen, and the robot stands upright with its hands at home or drawn in",
        postcondition="the robot stands; by odometry within the policy's tolerance of its goal",
        deadline_s=120.0,
        moves="body",
        on_success="the robot stands in front of the place",
        on_failure="the robot stops within two steps and stands",
        on_cancel="the robot stops within two steps and stands",
    )

    def __init__(
        self,
        name: str,
        toolbox: Toolbox,
        if_hands_fit: bool = False,
        wiring: Mapping[str, str] | None = None,
    ) -> None:
        """Make the leaf.

        Args:
            name: Its name.
            toolbox: What it may call.
            if_hands_fit: Do not go where a hand comes to something, if the arms can be drawn in.
            wiring: Other names of its ports.
        """
        super().__init__(name, toolbox, wiring)
        self._if_hands_fit = if_hands_fit

    def begin(self) -> None:
        """Nothing has moved yet."""
        super().begin()
        self._into_room = False
        self.aim()
        self._goal = PlanarPose()
        self._backing = False
        self._seen = SeenPoints(self.toolbox.ranging)
        self._path: tuple[PlanarPose, ...] = ()
        self._clearance_m = 0.0
        self._stopped_for: Failure | None = None
        self._scanned_s, self._asked = -math.inf, 0

    def aim(self) -> None:
        """Take in what to walk to."""
        self._place: Place = self.get_input("place")
        self._into_room = self._place.category == "region"
        self._straight_m = 0.0 if self._into_room else _APPROACH_M

    def place(self, body: PlanarPose) -> PlanarPose:
        """Where to stand, for a body that is here now."""
        toolbox = self.toolbox
        stand: Stand | None = self.optional("stand")
        if stand is not None and stand.name == self._place.name:
            return stand.body(self._place)
        gap_m, room, scene = toolbox.policy.support_gap_m, room_if_it_walks(toolbox), toolbox.world.scene
        points = None
        if self._into_room:  # who stands in a room, behind a wall, is seen on the way
            points = self._seen.beside(footprints(scene))
        return standing_place(self._place, scene, body, gap_m, room, points)

    def step(self) -> Status | Failure:
        """Choose the goal, walk, and measure."""
        toolbox = self.toolbox
        settings = toolbox.model.description.walking
        if settings is None or toolbox.walking is None:
            message = f"{toolbox.model.description.name} cannot walk here"
            return Failure.infeasible(message).because(Reason.CANNOT_WALK)
        if self._handle is None:
            steering = self._plan(settings)
            if self._seen.silent:
                return self._wait_for_scan()
            if isinstance(steering, Failure):
                return steering
            if steering is None:
                return self._arrived()
            self._handle = toolbox.walking.walk(steering, "walk")
        if (ended := self.ended_early(self._handle)) is not None:
            return ended
        if not self._handle.finished:
            left_m = body_pose(toolbox).distance_m(self._goal)
            self.feedback_message = f"{left_m:.2f} m to go"
            if self._stopped_for is None and (reason := self._look_out(settings)) is not None:
                self._stopped_for = reason
                toolbox.walking.finish(self._handle)
            return RUNNING
        if self._stopped_for is not None:
            return self._stopped_for
        if self._backing:
            self._handle = None
            return RUNNING
        return self._arrived()

    def _plan(self, settings: WalkingSettings) -> Steering | Failure | None:
        toolbox = self.toolbox
        policy = toolbox.policy
        body = feet_pose(toolbox)
        self._goal = self.place(body)
        self._set_output("goal", self._goal)
        left = body.to(self._goal)
        if math.hypot(left.x_m, left.y_m) < policy.stand_m and abs(left.yaw_rad) < policy.stand_rad:
            return None
        if math.hypot(left.x_m, left.y_m) < 0.3 and abs(left.yaw_rad) < 0.3:
            return PathSteering(settings, (body, self._goal))
        scene, room = toolbox.world.scene, walking_room(toolbox, settings)
        obstacles = room.footprints(scene)
        self._look(obstacles)
        if self._seen.silent:
            return None
        self._backing = not self._backing and (back := self._step_back(settings, room, body)) is not None
        if self._backing:
            return back
        return self._way(settings, room, body, obstacles)

    def _wait_for_scan(self) -> Status | Failure:
        """A sensor that nobody asked before needs a moment; who computes meanwhile does not hear it."""
        self._asked += 1
        silent_s = self.elapsed_s
        if silent_s < _SCAN_WITHIN_S or self._asked < _ASKED_TIMES:
            return RUNNING
        return Failure.execution(_SILENT, silent_s=silent_s)

    def _step_back(
        self, settings: WalkingSettings, room: WalkingRoom, body: PlanarPose
    ) -> StretchSteering | None:
        """Straight back to where there is most room to turn; None where there is enough, or none behind."""
        scene = self.toolbox.world.scene
        lack_m = room.tightest(scene, body, at_ease=True).lack_m
        best: StretchSteering | None = None
        least_m = lack_m
        # what is beside the hands here already is no reason to stay: the way leads back from it
        beside_m = next((m for m in BESIDE_TUCKED_M if not room.hands_meet(scene, [body], m)), BESIDE_HANDS_M)
        for share in _BACK_SHARES if lack_m > 0.0 else ():
            back_m = share * (lack_m + _BEYOND_M)
            back = StretchSteering(settings, body, -_BACK_M_S, back_m)
            left_m = room.tightest(scene, body @ PlanarPose(-back_m), at_ease=True).lack_m
            way = foreseen(back, body)
            free = not room.hands_meet(scene, way, beside_m) and not self._comes_to_seen(settings, room, way)
            if max(left_m, 0.0) < least_m and free:
                best, least_m = back, max(left_m, 0.0)
        return best

    def _comes_to_seen(self, settings: WalkingSettings, room: WalkingRoom, way: Sequence[PlanarPose]) -> bool:
        """Whether hands or legs come to something on a way that was seen, and that nobody knows.

        Somebody may stand there whom the eyes have not met. A way straight back leads away from what is
        ahead; what the legs are beside already is left out as well.
        """
        scene, here = self.toolbox.world.scene, way[0]
        tall = self._seen.beside(footprints(scene), settings.hands_from_m)
        tall = tall[
            (tall - (here.x_m, here.y_m)) @ (math.cos(here.yaw_rad), math.sin(here.yaw_rad)) < _AHEAD_M
        ]
        beside_m = next((m for m in BESIDE_TUCKED_M if not room.hands_meet_seen(tall, way[:1], m)), None)
        if beside_m is None or room.hands_meet_seen(tall, way, beside_m):
            return True
        points, legs_m = self._seen.beside(footprints(scene)), settings.legs_radius_m + settings.sway_m
        away_m = np.hypot(points[:, 0] - here.x_m, points[:, 1] - here.y_m)
        return blocked(way, points[away_m > legs_m], legs_m)

    def _way(
        self,
        settings: WalkingSettings,
        room: WalkingRoom,
        body: PlanarPose,
        obstacles: tuple[Footprint, ...],
    ) -> Steering | Failure:
        scene, points = self.toolbox.world.scene, self._seen.beside(obstacles)
        tall = self._seen.beside(footprints(scene), settings.hands_from_m)
        finder = WayFinder(settings, room, scene, points, self._straight_m, self._if_hands_fit, tall)
        way = finder.find(body, self._goal)
        if isinstance(way, NoWay):
            return Failure.infeasible(_NO_WAY[way.for_hands], clearance_m=way.clearance_m)
        self._path, self._clearance_m = way.path, way.clearance_m
        return way.steering

    def _look(self, obstacles: tuple[Footprint, ...]) -> Array:
        """Scan; gives what is new and belongs to nothing known, shape (n, 2)."""
        self._scanned_s = self.elapsed_s
        toolbox = self.toolbox
        new = self._seen.look(body_pose(toolbox), lambda scan: without_held(toolbox, scan))
        return apart_from(new, obstacles)

    def _look_out(self, settings: WalkingSettings) -> Failure | None:
        """Walk around what comes into sight."""
        toolbox = self.toolbox
        due = self.elapsed_s - self._scanned_s >= _SCAN_EVERY_S
        if self._handle is None or toolbox.walking is None or not self._path or not due:
            return None
        room = walking_room(toolbox, settings)
        obstacles = room.footprints(toolbox.world.scene)
        new = self._look(obstacles)
        if self._seen.silent:
            return Failure.execution(_SILENT)
        moved = len(new) > 0 and self._goes_elsewhere()
        if not moved and not blocked(self._path, new, self._clearance_m + room.widest_m - _IN_THE_WAY_M):
            return None
        steering = self._way(settings, room, body_pose(toolbox), obstacles)
        if isinstance(steering, Failure):
            return steering
        self.measured(new_points=len(new))
        toolbox.walking.steer(self._handle, steering)
        return None

    def _goes_elsewhere(self) -> bool:
        """Whether somebody stands where it was going to stand in a room, and it goes beside them instead."""
        if not self._into_room:
            return False
        goal = self.place(body_pose(self.toolbox))
        if goal.distance_m(self._goal) < _ELSEWHERE_M:
            return False
        self._goal = goal
        self._set_output("goal", goal)
        return True

    def _arrived(self) -> Status | Failure:
        left = feet_pose(self.toolbox).to(self._goal)
        self.measured(off_m=math.hypot(left.x_m, left.y_m), off_rad=abs(left.yaw_rad))
        return DONE
