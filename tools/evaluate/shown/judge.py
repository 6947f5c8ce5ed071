"""Shows packages to the eyes, and judges what they are called on tables afterwards."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from kinematics.geometry import poses
from robots.interface.hardware import RobotData
from robots.perception.labels.labeller import Labeller
from robots.perception.labels.shown import ShownLabeller
from robots.perception.labels.views import View
from robots.perception.rgbd.eyes import Eyes
from robots.perception.rgbd.picture import Picture
from robots.scenes.scene_description import SceneDescription
from robots.simulated.camera.showing import USUAL_VIEWS, shown_views
from robots.simulated.camera.standing_view import standing_picture
from tools.evaluate.shown.tables import NAMES, Package, gaze, packages, shown_scene, table_scene

SCENES_A_SET = 20
_NEAR_M = 0.05


@dataclass(frozen=True, slots=True)
class NameRecord:
    """What one thing on a table was called.

    Attributes:
        seed: Of the table.
        name: What it is; empty for a stranger.
        found: Whether there was a thing at its place.
        told: What it was called, empty where nothing was sure.
        maybe: What it may be.
        visible: Pixels that show it.
        light: Of the table.
    """

    seed: int
    name: str
    found: bool
    told: tuple[str, ...] = ()
    maybe: tuple[str, ...] = ()
    visible: int = 0
    light: str = ""


@dataclass(slots=True)
class Shelf:
    """Packages of one set, and who has been shown them."""

    known: list[Package]
    strangers: list[Package]
    views: dict[str, list[View]]
    labeller: Labeller


def stock(robot: RobotData, seed: int, folder: Path) -> Shelf:
    """Make a set of packages, and show each from all sides."""
    known = packages(seed, NAMES, folder)
    strangers = packages(seed + 500_000, ["", "", ""], folder)
    views = {one.name: shown_views(robot, shown_scene(one, 0.0), USUAL_VIEWS, seed) for one in known}
    return Shelf(known, strangers, views, ShownLabeller(views))


def judged(robot: RobotData, shelf: Shelf, seed: int) -> list[NameRecord]:
    """What the things of one table are called."""
    scene = table_scene(seed, shelf.known, shelf.strangers)
    picture = standing_picture(robot, scene, gaze(seed), seed)
    return compared(scene, picture, Eyes(labeller=shelf.labeller), seed)


def compared(scene: SceneDescription, picture: Picture, eyes: Eyes, seed: int) -> list[NameRecord]:
    """What was told of each thing of a scene."""
    frame = eyes.detect(picture, 0)
    start = scene.robot_start
    odom_T_world = poses.inverse(
        poses.transform(poses.rotation_z(start.yaw_rad), (start.x_m, start.y_m, 0.0))
    )
    places = np.array([(picture.odom_T_camera @ one.camera_T_object)[:3, 3] for one in frame.detections])
    objects = [one.category == "object" for one in frame.detections]
    records = []
    for item in scene.objects:
        name = "" if item.name.startswith("stranger") else item.name
        place = (odom_T_world @ item.world_T_object[:, 3])[:3]
        away = np.where(objects, np.linalg.norm(places[:, :2] - place[:2], axis=1), np.inf)
        if not len(away) or away.min() > _NEAR_M:
            records.append(NameRecord(seed, name, False, light=scene.light.kind))
            continue
        one = frame.detections[int(away.argmin())]
        names = frozenset(NAMES)
        records.append(
            NameRecord(
                seed, name, True, one.names, tuple(word for word in one.alike if word in names),
                light=scene.light.kind,
            )
        )  # fmt: skip
    return records


def told(records: Sequence[NameRecord]) -> dict[str, float]:
    """Shares of what was right, wrong, asked and not found."""
    known = [one for one in records if one.name]
    strange = [one for one in records if not one.name and one.found]
    count = max(len(known), 1)
    return {
        "things": float(len(known)),
        "right": sum(one.told == (one.name,) for one in known) / count,
        "wrong": sum(bool(one.told) and one.told != (one.name,) for one in known) / count,
        "asked": sum(one.found and not one.told and bool(one.maybe) for one in known) / count,
        "asked rightly": sum(one.found and not one.told and one.name in one.maybe for one in known) / count,
        "nothing told": sum(one.found and not one.told and not one.maybe for one in known) / count,
        "not found": sum(not one.found for one in known) / count,
        "strangers": float(len(strange)),
        "strangers named": sum(bool(one.told) for one in strange) / max(len(strange), 1),
    }
