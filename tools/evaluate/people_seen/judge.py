"""One picture of people, what was told of them, and what is so."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from kinematics.geometry import poses
from robots.interface.hardware import RobotData
from robots.perception.detector import Detection
from robots.perception.rgbd.eyes import Eyes
from robots.perception.rgbd.picture import Picture
from robots.scenes.scene_description import GESTURES, POSTURES, Person, SceneDescription
from robots.simulated.camera.standing_view import standing_picture
from tools.evaluate.people_seen.scenes import people_scene

_NEAR_M = 0.45
_LEGS_WEAR = ("trousers", "jeans", "skirt")


@dataclass(frozen=True, slots=True)
class PersonRecord:
    """What was told of somebody; a name of "" is somebody who is not there.

    Attributes:
        seed, name, posture, gesture, upper, lower: Truth.
        away_m: From the robot.
        light: Of the scene.
        shown: Whether the head is in the picture.
        found: Whether somebody was told at this place.
        told_posture, told_gesture, told_upper, told_lower: None where nothing was told.
        position_m, yaw_rad: How far off.
    """

    seed: int
    name: str
    posture: str = ""
    gesture: str | None = None
    upper: str | None = None
    lower: str | None = None
    away_m: float = 0.0
    light: str = ""
    shown: bool = True
    found: bool = False
    told_posture: str | None = None
    told_gesture: str | None = None
    told_upper: str | None = None
    told_lower: str | None = None
    position_m: float = 0.0
    yaw_rad: float = 0.0


def judged(robot: RobotData, seed: int) -> tuple[list[PersonRecord], Picture]:
    """What is told of the people of one scene."""
    scene, gaze = people_scene(seed)
    picture = standing_picture(robot, scene, gaze, seed)
    return compared(scene, picture, seed), picture


def compared(scene: SceneDescription, picture: Picture, seed: int) -> list[PersonRecord]:
    """What is told of the people in a picture."""
    frame = Eyes().detect(picture, 0)
    told = [one for one in frame.detections if one.category == "person"]
    left = list(told)
    records = []
    for person in scene.people:
        near = sorted(left, key=lambda one: _off_m(one, picture, person))
        shown = _shown(person, picture)
        if near and _off_m(near[0], picture, person) < _NEAR_M:
            left = [one for one in left if one is not near[0]]
            records.append(_record(person, shown, near[0], picture, scene, seed))
        else:
            records.append(_record(person, shown, None, picture, scene, seed))
    return records + [PersonRecord(seed, "", found=True, light=scene.light.kind) for _ in left]


def _place(one: Detection, picture: Picture) -> poses.Transform:
    return picture.odom_T_camera @ one.camera_T_object


def _off_m(one: Detection, picture: Picture, person: Person) -> float:
    return math.dist(_place(one, picture)[:2, 3], person.position_m)


def _shown(person: Person, picture: Picture) -> bool:
    """Whether the middle of the head, and some room about it, is in the picture."""
    local = {"standing": (0.0, 0.0, 1.62), "sitting": (-0.17, 0.0, 1.17), "lying": (0.745, 0.0, 0.16)}
    pose = poses.transform(poses.rotation_z(person.yaw_rad), (*person.position_m, 0.0))
    head = pose @ np.array([*local[person.posture], 1.0])
    camera = poses.inverse(picture.odom_T_camera) @ head
    (u, v), room = picture.pixels_of(camera[None, :3])[0], 0.12 * picture.camera.focal_px / camera[2]
    height, width = picture.depth_m.shape
    return bool(room < u < width - room and room < v < height - room)


def _record(
    person: Person,
    shown: bool,
    one: Detection | None,
    picture: Picture,
    scene: SceneDescription,
    seed: int,
) -> PersonRecord:
    upper, lower = (
        next(
            (
                worn.partition(" ")[0]
                for worn in person.clothes
                if (worn.partition(" ")[2] in _LEGS_WEAR) is legs
            ),
            None,
        )
        for legs in (False, True)
    )
    truth = PersonRecord(
        seed,
        person.name,
        posture=person.posture,
        gesture=person.gesture,
        upper=upper,
        lower=lower,
        away_m=math.hypot(*person.position_m),
        light=scene.light.kind,
        shown=shown,
    )
    if one is None:
        return truth
    worn = [trait for trait in one.traits if trait not in POSTURES and trait not in GESTURES]
    pose = _place(one, picture)
    turn = (poses.yaw_of(pose[:3, :3]) - person.yaw_rad + math.pi) % (2.0 * math.pi) - math.pi
    return replace(
        truth,
        found=True,
        told_posture=next((trait for trait in one.traits if trait in POSTURES), None),
        told_gesture=next((trait for trait in one.traits if trait in GESTURES), None),
        told_upper=next((w.partition(" ")[0] for w in worn if w.endswith("shirt")), None),
        told_lower=next((w.partition(" ")[0] for w in worn if w.endswith("trousers")), None),
        position_m=_off_m(one, picture, person),
        yaw_rad=turn,
    )


def told(records: Sequence[PersonRecord]) -> dict[str, float]:
    """Shares, of people whose heads are in the picture."""
    real = [one for one in records if one.name and one.shown]
    seen = [one for one in real if one.found]
    count = max(len(seen), 1)
    poses_right = [one.told_posture == one.posture for one in seen]
    upright = [one for one in seen if one.posture != "lying"]
    gestures_right = [one.told_gesture == one.gesture for one in upright]
    pairs = [(one.upper, one.told_upper) for one in seen] + [(one.lower, one.told_lower) for one in seen]
    named = [(true, said) for true, said in pairs if said is not None]
    return {
        "people": float(len(real)),
        "found": len(seen) / max(len(real), 1),
        "false": float(sum(not one.name for one in records)),
        "posture right": sum(poses_right) / count,
        "posture not told": sum(one.told_posture is None for one in seen) / count,
        "gesture right": sum(gestures_right) / max(len(upright), 1),
        "clothes right of told": sum(a == b for a, b in named) / max(len(named), 1),
        "clothes told": len(named) / max(len(pairs), 1),
        "position p95 m": float(np.quantile([one.position_m for one in seen] or [0.0], 0.95)),
        "yaw median": float(np.median([abs(one.yaw_rad) for one in seen] or [0.0])),
    }
