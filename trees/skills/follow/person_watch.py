"""Eyes that stay on one person: each picture is looked through for them, at the rate that pictures come."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import ClassVar

import numpy as np

from kinematics.geometry.planar import PlanarPose
from trees.beliefs.grounding.destination import Place
from trees.skills.follow.person_track import PersonTrack
from trees.toolbox import Toolbox

_FRESH_S = 0.5
"""Who was seen so recently is there."""
_MOVED_M = 0.05


class PersonWatch:
    """Looks for one person in each picture, and tells where the head has to turn to keep them in view."""

    TILT_RAD: ClassVar[float] = 0.2
    """From chest to face of somebody at a metre, and the floor two metres ahead."""

    def __init__(self, toolbox: Toolbox, place: Place, still_m: float) -> None:
        """Begin where the person was found.

        Args:
            toolbox: Has the detector.
            place: Where the person is, by name.
            still_m: Who moves less than this stands.
        """
        self._toolbox = toolbox
        x_m, y_m = place.odom_T_place[:2, 3].tolist()
        self.track = PersonTrack(place.name, x_m, y_m, toolbox.clock.now_s(), still_m)
        self._sequence = -1

    def look(self) -> None:
        """Take in the newest picture, if it is a new one."""
        toolbox = self._toolbox
        frame = toolbox.detector.latest()
        if frame is None or frame.sequence <= self._sequence or frame.stamp_s < self.track.seen_s:
            return
        self._sequence = frame.sequence
        people = [one for one in frame.detections if one.category == "person"]
        if not people:
            return
        model = toolbox.model
        q = toolbox.sensing.state_at(frame.stamp_s).q
        odom_T_camera = model.frame_pose(q, model.description.camera.frame)
        found: list[tuple[float, float, float]] = []
        for one in people:
            x_m, y_m = (odom_T_camera @ one.camera_T_object)[:2, 3].tolist()
            if self.track.fits(one.name, x_m, y_m, frame.stamp_s):
                away_m = math.dist((x_m, y_m), (self.track.x_m, self.track.y_m))
                found.append((away_m, x_m, y_m))
        if found:
            _, x_m, y_m = min(found)
            self.track.take(x_m, y_m, frame.stamp_s)

    def gaze_rad(self, body: PlanarPose) -> tuple[float, float]:
        """Pan and tilt of the head that show the person.

        Args:
            body: Where the body is, and where it heads.
        """
        x_m, y_m = self.track.place(self._toolbox.clock.now_s())
        seen = body.to(PlanarPose(x_m, y_m))
        return math.atan2(seen.y_m, seen.x_m), self.TILT_RAD

    def unseen_s(self) -> float:
        """For how long the person was not seen."""
        return self._toolbox.clock.now_s() - self.track.seen_s

    def believe(self) -> None:
        """Have the world model believe the person to be where they were seen last, or nowhere known.

        Who has walked on is no obstacle where they stood; looks of later tasks show them again.
        """
        world, name = self._toolbox.world, self.track.name
        item = world.scene.objects.get(name)
        if item is None:
            return
        place = item.world_T_object.copy()
        place[:2, 3] = self.track.x_m, self.track.y_m
        if self.unseen_s() > _FRESH_S:
            world.update(world.scene.without_object(name))
        elif float(np.hypot(*(place - item.world_T_object)[:2, 3])) > _MOVED_M:
            world.update(world.scene.with_object(replace(item, world_T_object=place)))
