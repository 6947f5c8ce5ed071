"""Walk behind a person who walks, and stand where the person stands."""

from __future__ import annotations

import math

from py_trees.common import Status

from kinematics.geometry.planar import PlanarPose
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.gazing import Gazing
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
from trees.skills.follow.whether_reached import has_reached
from trees.skills.walking.walking_leaf import WalkingLeaf
from trees.skills.walking.walking_room import walking_room

_PLAN_EVERY_S = 0.4
_GAZE_EVERY_S = 0.1
_MOVED_M = 0.08
"""A person who has moved less since the way was planned is where it leads to."""
_STEP_M = 0.1
"""The way is added up in pieces of this length: less is the sway of a walk."""
_ASIDE_RAD = 0.45
"""Who stands farther to a side is turned to: from there the person may walk out of the picture."""
_SEEN_S = 0.3
"""Who was seen so recently is not lost any more."""


class WalkBehind(WalkingLeaf):
    """Walk behind the person who was found, at a distance, as long as the person walks.

    The person is looked for in each picture; the head follows while the feet walk. Who is not seen for a
    while is told to be lost, and the robot stops; where the person does not come into view again before it
    stands, it fails.
    """

    INPUT_PORTS = ports(task=object, place=Place)
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="the person was seen, and the robot stands upright with its hands at home or drawn in",
        postcondition="the person was seen to walk, and to stand again or to have come to the goal; the "
        "robot stands behind",
        deadline_s=300.0,
        moves="body",
        on_success="the robot stands behind the person",
        on_failure="the robot stops within two steps and stands",
        on_cancel="the robot stops within two steps and stands",
    )

    def begin(self) -> None:
        """Nothing has moved yet."""
        super().begin()
        self._watch = PersonWatch(self.toolbox, self.get_input("place"), self._settings.still_m)
        self._lost = self._stopping = False
        self._planned_s = self._gazed_s = -math.inf
        self._planned_for: tuple[float, float] | None = None
        self._stretch: Stretch | None = None
        self._last = body_pose(self.toolbox)
        self._walked_m = 0.0

    @property
    def _settings(self) -> FollowSettings:
        return self.toolbox.policy.of(FollowSettings)

    @property
    def deadline_s(self) -> float:
        """The settings'."""
        return self._settings.longest_s

    def step(self) -> Status | Failure:
        """Look, and go on or stop."""
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
        body = feet_pose(toolbox) if self._handle is None else body_pose(toolbox)
        self._measure()
        if self._is_lost():
            return RUNNING if self._stop() else self._failure_of_loss()
        outcome = self._outcome(body)
        if outcome is not None:
            return RUNNING if self._stop() else self._concluded(outcome)
        if self._handle is None:
            self._set_out(settings, body)
        elif not self._stopping:
            self._go_on(settings, body)
        return RUNNING

    # ---------------------------------------------------------------- the person

    @property
    def _name(self) -> str:
        return self._watch.track.name

    def _away_m(self, body: PlanarPose) -> float:
        track = self._watch.track
        return math.dist((track.x_m, track.y_m), (body.x_m, body.y_m))

    def _is_lost(self) -> bool:
        """Whether the person is out of sight for long; told as soon as that is so."""
        unseen_s = self._watch.unseen_s()
        if self._lost and unseen_s < _SEEN_S:
            self._lost = False
        elif not self._lost and unseen_s > self._settings.lost_s:
            self._lost = True
            self.toolbox.events(Said(self.toolbox.clock.now_s(), f"I lost {self._name}."))
            self.feedback_message = f"lost {self._name}"
        return self._lost

    def _failure_of_loss(self) -> Failure:
        unseen_s = self._watch.unseen_s()
        self._watch.believe()
        message = f"I lost {self._name}"
        return Failure.postcondition(message, unseen_s=unseen_s, walked_m=self._walked_m).because(
            Reason.PERSON_LOST
        )

    def _outcome(self, body: PlanarPose) -> str | Failure | None:
        """How it has ended, in words; None while it goes on. To its goal the robot comes as well."""
        settings, track = self._settings, self._watch.track
        still_s = track.still_s
        to = getattr(self.get_input("task"), "to", None)
        if to is not None and has_reached(self.toolbox, to, (track.x_m, track.y_m), settings.near_m):
            behind_m = settings.near_m + settings.distance_m + settings.slack_m
            followed = has_reached(self.toolbox, to, (body.x_m, body.y_m), behind_m)
            stands = self._handle is None and still_s > settings.still_s
            return f"{self._name} has reached {called(to)}" if followed or stands else None
        if not track.walked and still_s > settings.sets_out_s:
            return Failure.postcondition(f"{self._name} does not walk", stood_s=still_s)
        if to is not None and still_s > settings.stays_s:
            return Failure.postcondition(
                f"{self._name} stands, and has not reached {called(to)}", stood_s=still_s
            )
        stands = self._handle is None and track.walked and still_s > settings.still_s
        if to is not None or not stands:
            return None
        return f"{self._name} stands"

    def _concluded(self, outcome: str | Failure) -> Status | Failure:
        self._watch.believe()
        if isinstance(outcome, Failure):
            return outcome
        away_m = self._away_m(feet_pose(self.toolbox))
        evidence: dict[str, Number] = {
            "followed": self._name,
            "because": outcome,
            "away_m": away_m,
            "walked_m": self._walked_m,
        }
        self.measured(**evidence)
        self._set_output("evidence", evidence)
        self.feedback_message = outcome
        return DONE

    # ---------------------------------------------------------------- the walk

    def _measure(self) -> None:
        body = body_pose(self.toolbox)
        if (step_m := body.distance_m(self._last)) >= _STEP_M:
            self._walked_m += step_m
            self._last = body

    def _stop(self) -> bool:
        """Come to rest; whether the robot still moves."""
        if self._handle is None or self.toolbox.walking is None:
            return False
        if not self._stopping:
            self.toolbox.walking.finish(self._handle)
            self._stopping = True
        return True

    def _set_out(self, settings: WalkingSettings, body: PlanarPose) -> None:
        """Begin to walk where the person is too far away, or too far to a side."""
        track = self._watch.track
        seen = body.to(PlanarPose(track.x_m, track.y_m))
        too_far = self._away_m(body) > self._settings.distance_m + self._settings.slack_m
        aside = abs(math.atan2(seen.y_m, seen.x_m)) > _ASIDE_RAD
        due = self.elapsed_s - self._planned_s >= _PLAN_EVERY_S
        if not due or not (too_far or aside) or self.toolbox.walking is None:
            return
        self._plan(settings, body)
        if self._stretch is not None:
            self._handle = self.toolbox.walking.walk(self._gazing(self._stretch, body), "walk behind")

    def _go_on(self, settings: WalkingSettings, body: PlanarPose) -> None:
        """Keep to where the person is by now, and stop in time."""
        toolbox = self.toolbox
        if self._handle is None or toolbox.walking is None:
            return
        away_m = self._away_m(body)
        self.feedback_message = f"{away_m:.1f} m behind {self._name}"
        turning = self._stretch is not None and body.distance_m(self._stretch.steering.goal) < _MOVED_M
        if away_m < self._settings.nearest_m and not turning:
            self._stop()
            return
        if self.elapsed_s - self._planned_s >= _PLAN_EVERY_S and self._has_changed(settings, body):
            self._plan(settings, body)
            if self._stretch is None:
                self._stop()
                return
            self._gazed_s = -math.inf
        if self._stretch is not None and self.elapsed_s - self._gazed_s >= _GAZE_EVERY_S:
            self._gazed_s = self.elapsed_s
            toolbox.walking.steer(self._handle, self._gazing(self._stretch, body))

    def _has_changed(self, settings: WalkingSettings, body: PlanarPose) -> bool:
        """Whether the person has gone on, or something has come into the way."""
        track = self._watch.track
        self._planned_s = self.elapsed_s
        if self._planned_for is None or self._stretch is None:
            return True
        at = track.x_m, track.y_m
        if math.dist(self._planned_for, at) > _MOVED_M:
            return True
        return not self._ways(settings).is_free(body, self._stretch, at)

    def _plan(self, settings: WalkingSettings, body: PlanarPose) -> None:
        toolbox, track = self.toolbox, self._watch.track
        self._planned_s = self.elapsed_s
        person = track.place(toolbox.clock.now_s())
        self._stretch = self._ways(settings).behind(body, person, self._settings.distance_m)
        self._planned_for = track.x_m, track.y_m
        if self._stretch is None:
            self.feedback_message = f"no way leads to {self._name} now"

    def _ways(self, settings: WalkingSettings) -> WayBehind:
        return WayBehind(self.toolbox, settings, walking_room(self.toolbox, settings), self._settings.pace)

    def _gazing(self, stretch: Stretch, body: PlanarPose) -> Gazing:
        return Gazing(stretch.steering, *self._watch.gaze_rad(body))
