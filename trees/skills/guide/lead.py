"""Walk ahead of somebody in stretches, and look round for them after each."""

from __future__ import annotations

import math
from typing import Literal

from py_trees.common import Status

from kinematics.geometry.planar import PlanarPose, wrapped
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.gazing import Gazing
from kinematics.walking.pattern.steering import PathSteering, Steering
from trees.beliefs.grounding.destination import Place, called
from trees.events import Said
from trees.failures import Failure, Number, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING
from trees.nodes.ports import ports
from trees.readings.odometry import body_pose, feet_pose
from trees.skills.follow.person_watch import PersonWatch
from trees.skills.follow.settings import FollowSettings
from trees.skills.follow.way_behind import Stretch, WayBehind
from trees.skills.guide.settings import GuideSettings
from trees.skills.walking.standing_place import standing_place
from trees.skills.walking.walking_leaf import WalkingLeaf
from trees.skills.walking.walking_room import room_if_it_walks, walking_room

_PLAN_EVERY_S = 0.6
_GAZE_EVERY_S = 0.1
_THERE_M = 0.15
_BEHIND_M = 1.2
"""Who comes along is expected so far back on the way."""
_ROUND_RAD = 1.9
"""Between two headings of a look all round; less than a head that turns sees from one."""
_OVERLAP = 0.85
"""The same of eyes that stay as they are, as a share of what they see."""
_INSIDE = 0.35
"""Such eyes keep somebody in view who is no farther to a side than that share."""
_GLANCE_S = 1.0
"""A head that stands still for so long has seen who is there."""

Doing = Literal["leading", "looking"]


class Lead(WalkingLeaf):
    """Walk to the goal in stretches; after each, and at the goal, turn round until the person is near.

    Who is not near is waited for; who does not come is told to be lost, and the robot goes no farther.
    """

    INPUT_PORTS = ports(task=object, place=Place, destination=Place)
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="the person was seen, and the robot stands upright with its hands at home or drawn in",
        postcondition="the robot stands at the goal, and the person was seen to be near",
        deadline_s=400.0,
        moves="body",
        on_success="the robot stands at the goal and faces the person",
        on_failure="the robot stops within two steps and stands",
        on_cancel="the robot stops within two steps and stands",
    )

    def begin(self) -> None:
        """Nothing has moved yet."""
        super().begin()
        toolbox = self.toolbox
        still_m = toolbox.policy.of(FollowSettings).still_m
        self._watch = PersonWatch(toolbox, self.get_input("place"), still_m)
        body = feet_pose(toolbox)
        gap_m, room = toolbox.policy.support_gap_m, room_if_it_walks(toolbox)
        self._goal = standing_place(self.get_input("destination"), toolbox.world.scene, body, gap_m, room)
        self._doing: Doing = "leading"
        self._stopping = False
        self._steering: Steering | None = None
        self._stretch: Stretch | None = None
        self._planned_s = self._gazed_s = -math.inf
        self._barred_s: float | None = None
        self._trail: list[PlanarPose] = [body]
        self._walked_m = self._since_look_m = 0.0
        self._looks = self._turns = 0
        camera = toolbox.model.description.camera
        fixed = camera.neck is None
        self._pan_rad = 0.0 if fixed else self._settings.pan_rad
        self._round_rad = _OVERLAP * camera.horizontal_fov_rad if fixed else _ROUND_RAD
        self._aside_rad = _INSIDE * camera.horizontal_fov_rad if fixed else math.inf
        self._waited_from_s = self._stood_s = 0.0

    @property
    def _settings(self) -> GuideSettings:
        return self.toolbox.policy.of(GuideSettings)

    @property
    def deadline_s(self) -> float:
        """The settings'."""
        return self._settings.longest_s

    def step(self) -> Status | Failure:
        """Go on, look round, or wait."""
        toolbox = self.toolbox
        settings = toolbox.model.description.walking
        if settings is None or toolbox.walking is None:
            message = f"{toolbox.model.description.name} cannot walk here"
            return Failure.infeasible(message).because(Reason.CANNOT_WALK)
        self._watch.look()
        if self._handle is not None:
            if (ended := self.ended_early(self._handle)) is not None:
                return ended
            if self._handle.finished:
                self._handle, self._stopping = None, False
                self._stood_s = self.elapsed_s
        body = feet_pose(toolbox) if self._handle is None else body_pose(toolbox)
        self._measure(body)
        return self._lead(settings, body) if self._doing == "leading" else self._look(settings, body)

    # ---------------------------------------------------------------- walking ahead

    def _lead(self, settings: WalkingSettings, body: PlanarPose) -> Status | Failure:
        if self._stopping:
            return RUNNING
        there = body.distance_m(self._goal) < _THERE_M
        if there or self._since_look_m >= self._settings.stretch_m:
            self._begin_to_look(body)
            return RUNNING
        if self.elapsed_s - self._planned_s >= _PLAN_EVERY_S:
            self._planned_s = self.elapsed_s
            way = WayBehind(self.toolbox, settings, walking_room(self.toolbox, settings))
            kept = self._stretch
            if self._handle is None or kept is None or not way.is_free(body, kept):
                self._stretch = way.to(body, self._goal)
                if self._stretch is None:
                    return self._barred()
                self._barred_s = None
                self._walk(Gazing(self._stretch.steering, 0.0, self._watch.TILT_RAD))
        return RUNNING

    def _barred(self) -> Status | Failure:
        if self._barred_s is None:
            self._barred_s = self.elapsed_s
        if self._handle is not None:
            self._stop()
        elif self.elapsed_s - self._barred_s > self._settings.no_way_s:
            return Failure.infeasible(f"no way leads to {self._there}").because(Reason.NO_ROOM)
        self.feedback_message = f"no way leads to {self._there} now"
        return RUNNING

    # ---------------------------------------------------------------- looking round

    def _begin_to_look(self, body: PlanarPose) -> None:
        self._doing, self._turns, self._looks = "looking", 0, self._looks + 1
        self._waited_from_s = self._stood_s = self.elapsed_s
        self._gazed_s = -math.inf
        back = next(
            (one for one in reversed(self._trail) if one.distance_m(body) >= _BEHIND_M), self._trail[0]
        )
        seen = body.to(back)
        self._turn(body, math.atan2(seen.y_m, seen.x_m))

    def _turn(self, body: PlanarPose, bearing_rad: float) -> None:
        """Turn by what the head does not; without a neck that is all of it."""
        settings = self.toolbox.model.description.walking
        if settings is None:
            return
        self._expected_rad = wrapped(body.yaw_rad + bearing_rad)
        turn_rad = math.copysign(max(abs(bearing_rad) - self._pan_rad, 0.0), bearing_rad)
        goal = body @ PlanarPose(yaw_rad=turn_rad)
        self._steering = PathSteering(settings, (PlanarPose(body.x_m, body.y_m, body.yaw_rad), goal))
        self._walk(self._gazing(body))

    def _look(self, settings: WalkingSettings, body: PlanarPose) -> Status | Failure:
        """Until the person is near; then on, or arrived."""
        del settings
        track, now_s = self._watch.track, self.toolbox.clock.now_s()
        away_m = math.dist((track.x_m, track.y_m), (body.x_m, body.y_m))
        in_view = now_s - track.seen_s <= self._settings.seen_s
        bearing_rad = self._watch.gaze_rad(body)[0]
        faced = abs(bearing_rad) <= self._aside_rad
        if in_view and not faced and self._handle is None:
            self._turn(body, bearing_rad)
            return RUNNING
        if in_view and faced and away_m <= self._settings.near_m:
            if body.distance_m(self._goal) >= 2.0 * _THERE_M:
                self._doing, self._since_look_m, self._planned_s = "leading", 0.0, -math.inf
                self._stretch = None
                return RUNNING
            return RUNNING if self._stop() else self._arrived(away_m)
        if self._handle is not None:
            if self._steering is not None and self.elapsed_s - self._gazed_s >= _GAZE_EVERY_S:
                self._gazed_s = self.elapsed_s
                self._walk(self._gazing(body))
            return RUNNING
        return self._wait(body, away_m, in_view=in_view)

    def _wait(self, body: PlanarPose, away_m: float, *, in_view: bool) -> Status | Failure:
        """Stand, and look elsewhere where nobody comes into view."""
        waited_s = self.elapsed_s - self._waited_from_s
        name = self._watch.track.name
        self.feedback_message = f"waiting for {name}"
        glanced = self.elapsed_s - self._stood_s >= _GLANCE_S
        if not in_view and glanced and (self._turns + 1) * self._round_rad < math.tau:
            self._turns += 1
            self._turn(body, wrapped(self._expected_rad + self._round_rad - body.yaw_rad))
            return RUNNING
        if waited_s <= self._settings.waits_s:
            return RUNNING
        self._watch.believe()
        if in_view:
            message = f"{name} does not come along"
            return Failure.postcondition(message, away_m=away_m, waited_s=waited_s)
        self.toolbox.events(Said(self.toolbox.clock.now_s(), f"I lost {name}."))
        unseen_s = self._watch.unseen_s()
        message = f"I lost {name} on the way to {self._there}"
        return Failure.postcondition(message, unseen_s=unseen_s, waited_s=waited_s).because(
            Reason.PERSON_LOST
        )

    def _arrived(self, away_m: float) -> Status:
        self._watch.believe()
        evidence: dict[str, Number] = {
            "guided": self._watch.track.name,
            "to": self._there,
            "away_m": away_m,
            "walked_m": self._walked_m,
            "looks": self._looks,
        }
        self.measured(**evidence)
        self._set_output("evidence", evidence)
        return DONE

    # ---------------------------------------------------------------- the walk

    @property
    def _there(self) -> str:
        return called(getattr(self.get_input("task"), "to", None))

    def _measure(self, body: PlanarPose) -> None:
        step_m = body.distance_m(self._trail[-1])
        if step_m >= 0.1:
            self._trail.append(body)
            if self._doing == "leading":
                self._since_look_m += step_m
            self._walked_m += step_m

    def _walk(self, steering: Steering) -> None:
        walking = self.toolbox.walking
        if walking is None or self._stopping:
            return
        if self._handle is None:
            self._handle = walking.walk(steering, "lead")
        else:
            walking.steer(self._handle, steering)

    def _stop(self) -> bool:
        """Come to rest; whether the robot still moves."""
        if self._handle is None or self.toolbox.walking is None:
            return False
        if not self._stopping:
            self.toolbox.walking.finish(self._handle)
            self._stopping = True
        return True

    def _gazing(self, body: PlanarPose) -> Steering:
        """Turn the head to where the person should be, or is seen."""
        steering = self._steering
        if steering is None:
            raise RuntimeError("there is nowhere to turn")
        pan_rad = wrapped(self._expected_rad - body.yaw_rad)
        if self._watch.unseen_s() <= self._settings.seen_s:
            pan_rad = self._watch.gaze_rad(body)[0]
        return Gazing(steering, pan_rad, self._watch.TILT_RAD)
