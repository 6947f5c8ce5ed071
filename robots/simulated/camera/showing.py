"""Somebody shows the robot a thing from all sides: what it keeps of that."""

from __future__ import annotations

import math

import numpy as np

from robots.errors import SceneError
from robots.interface.hardware import RobotData
from robots.perception.labels.labeller import Boxes
from robots.perception.labels.views import View, view_of
from robots.perception.rgbd.colors import as_in_daylight
from robots.perception.rgbd.eyes import Eyes, Seen
from robots.perception.rgbd.picture import Picture
from robots.scenes.scene_description import SceneDescription
from robots.simulated.camera.standing_view import Gaze, StandingView

USUAL_VIEWS = 8


def shown_views(
    robot: RobotData, scene: SceneDescription, count: int, seed: int, gaze: Gaze | None = None
) -> list[View]:
    """Views of the one object of a scene, which is turned a bit for each.

    Args:
        robot: Who looks.
        scene: With one object, before the robot.
        count: How many views.
        seed: Of the camera's errors.
        gaze: Where the robot looks; at a table before it when left out.

    Raises:
        SceneError: The scene has no object, or several.
        RenderingUnavailableError: Nothing can be drawn here.
    """
    if len(scene.objects) != 1:
        there = ", ".join(item.name for item in scene.objects) or "none"
        raise SceneError(scene.name, "object", f"there must be one object that is shown, not {there}")
    camera = StandingView(robot, scene, gaze or Gaze(), seed)
    eyes, views = Eyes(), []
    try:
        for k in range(count):
            camera.turn(scene.objects[0].name, 2.0 * math.pi * k / count)
            picture = camera.picture()
            if (view := largest_view(picture, eyes.look(picture))) is not None:
                views.append(view)
    finally:
        camera.close()
    return views


def largest_view(picture: Picture, seen: Seen) -> View | None:
    """The part of a picture that shows the largest thing, as in daylight; None when there is none."""
    if not seen.things:
        return None
    thing = max(seen.things, key=lambda one: one.pixels)
    left, top, right, bottom = thing.box
    within = seen.labels[top:bottom, left:right]
    number = int(np.bincount(within[within > 0]).argmax())
    boxes = Boxes(np.array([thing.box]), (seen.labels == number).astype(np.int32))
    return view_of(as_in_daylight(picture.color, seen.light), boxes, 0)
