"""Between a stored trajectory and what the checker is asked: a robot, a motion, a scene."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from kinematics.errors import TrajectoryDocumentError, UnknownNameError
from kinematics.requests import CheckRequest
from kinematics.robot_model import RobotModel
from kinematics.scene import FLOOR, PlanningScene, SceneObject
from kinematics.trajectory import Trajectory
from kinematics.trajectory_document import HeldObject, StoredTrajectory

SOLE_HEIGHT_M = 0.005
SOLE_TILT_RAD = 0.02
"""A sole of the stance lies this flat on the floor, or nothing carries it."""


def fit(stored: StoredTrajectory, model: RobotModel, surroundings: PlanningScene) -> CheckRequest:
    """Compare a stored trajectory with its robot, and put what it holds into the robot's hands.

    Args:
        stored: The document.
        model: The robot.
        surroundings: What is around, in the trajectory's frame.

    Returns:
        What the checker can be asked: the joints in the robot's order, and the scene.

    Raises:
        TrajectoryDocumentError: A name of the document is none of the robot or the scene, or one of the
            scene is ambiguous; a sole of the stance is not on the floor.
    """
    name = model.description.name
    if stored.robot != name:
        raise TrajectoryDocumentError("robot", f"is {stored.robot!r}, to be judged as {name!r}")
    frames = _frames(model)
    for name in surroundings.objects:
        _require_free("scene", name, frames)
    motion = _arranged(stored.trajectory, model)
    for frame, world_T_sole in motion.stance.soles:
        place = f"stance.{frame}"
        _require_known(place, "frame", frame, frames)
        height_m = float(world_T_sole[2, 3])
        tilt_rad = float(np.arccos(np.clip(world_T_sole[2, 2], -1.0, 1.0)))
        if abs(height_m) > SOLE_HEIGHT_M or tilt_rad > SOLE_TILT_RAD:
            raise TrajectoryDocumentError(
                place, f"lies not on the floor: height {height_m:.4g} m, tilt {tilt_rad:.4g} rad"
            )
    return CheckRequest(motion, _scene(stored, model, motion, surroundings, frames))


def stored_from(request: CheckRequest, model: RobotModel) -> StoredTrajectory:
    """What ``fit`` makes the same question of: a motion with all that it was judged in."""
    scene = request.scene
    held = tuple(
        HeldObject(name, item.frame, item.frame_T_object, item.body.shape, item.touch_links)
        for name, item in scene.attached.items()
    )
    known = {*_frames(model), FLOOR, *scene.objects, *scene.attached}
    return StoredTrajectory(
        robot=model.description.name,
        trajectory=request.trajectory,
        held=held,
        # pairs with things that are gone say nothing any more
        allowed=frozenset(pair for pair in scene.allowed if pair <= known),
        objects=tuple(scene.objects.values()),
    )


def _frames(model: RobotModel) -> list[str]:
    return [str(frame.name) for frame in model.pin.frames]


def _arranged(motion: Trajectory, model: RobotModel) -> Trajectory:
    """The same motion with its joints in the robot's order."""
    for name in motion.joints:
        _require_known("joints", "joint", name, list(model.joints))
    for name in model.joints:
        if name not in motion.joints:
            raise TrajectoryDocumentError("joints", f"the robot's {name!r} is missing")
    order = np.array([motion.joints.index(name) for name in model.joints], dtype=np.intp)
    q = np.hstack([motion.q[:, :7], motion.q[:, 7 + order]])
    v = np.hstack([motion.v[:, :6], motion.v[:, 6 + order]])
    return replace(motion, joints=model.joints, q=q, v=v)


def _scene(
    stored: StoredTrajectory,
    model: RobotModel,
    motion: Trajectory,
    surroundings: PlanningScene,
    frames: list[str],
) -> PlanningScene:
    scene = surroundings
    for i, item in enumerate(stored.held):
        place = f"held[{i}]"
        _require_free(f"{place}.name", item.name, frames)
        _require_known(f"{place}.frame", "frame", item.frame, frames)
        for link in sorted(item.touch_links):
            _require_known(f"{place}.touch_links", "link", link, frames)
        world_T_object = model.frame_pose(motion.q[0], item.frame) @ item.frame_T_object
        scene = scene.with_object(SceneObject(item.name, item.shape, world_T_object))
        scene = scene.with_attached(item.name, item.frame, item.frame_T_object, item.touch_links)
    known = [*frames, FLOOR, *scene.objects, *scene.attached]
    for pair in stored.allowed:
        for name in pair:
            _require_known("allowed", "link or object", name, known)
    return scene.allowing((first, second) for first, second in map(tuple, stored.allowed))


def _require_known(place: str, what: str, name: str, known: list[str]) -> None:
    if name not in known:
        raise TrajectoryDocumentError(place, str(UnknownNameError(what, name, known)))


def _require_free(place: str, name: str, frames: list[str]) -> None:
    """Names of objects are not those of links: what may touch goes by name."""
    if name == FLOOR or name in frames:
        whose = "is the floor's name" if name == FLOOR else "is the name of a part of the robot"
        raise TrajectoryDocumentError(place, f"{name!r} {whose}; call the object something else")
