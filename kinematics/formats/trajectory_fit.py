"""Between a stored trajectory and what the checker is asked: a robot, a motion, a scene."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np

from kinematics.arrays import Array
from kinematics.errors import TrajectoryDocumentError, UnknownNameError
from kinematics.formats.loosening import is_of_a_hand, is_smaller, links_about, why_not_allowed
from kinematics.formats.solid_document import HeldObject
from kinematics.formats.trajectory_document import StoredTrajectory
from kinematics.model.robot_model import RobotModel
from kinematics.motion.trajectory import Trajectory
from kinematics.requests.check import CheckRequest
from kinematics.scene.planning_scene import FLOOR, Pair, PlanningScene, SceneObject

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
            scene is ambiguous; a sole of the stance is none, or not on the floor; it loosens more than
            ``kinematics.formats.loosening`` lists.
    """
    name = model.description.name
    if stored.robot != name:
        raise TrajectoryDocumentError("robot", f"is {stored.robot!r}, to be judged as {name!r}")
    motion = _arranged(stored.trajectory, model)
    soles = [sole.frame for sole in model.description.soles]
    if soles and not motion.stance.soles:
        raise TrajectoryDocumentError(
            "stance", f"names no sole that carries; the robot has {', '.join(soles)}"
        )
    for frame, world_T_sole in motion.stance.soles:
        place = f"stance.{frame}"
        _require_known(place, "sole", frame, soles)
        height_m = float(world_T_sole[2, 3])
        tilt_rad = float(np.arccos(np.clip(world_T_sole[2, 2], -1.0, 1.0)))
        if abs(height_m) > SOLE_HEIGHT_M or tilt_rad > SOLE_TILT_RAD:
            raise TrajectoryDocumentError(
                place, f"lies not on the floor: height {height_m:.4g} m, tilt {tilt_rad:.4g} rad"
            )
    scene = furnished(surroundings, stored.held, stored.allowed, model, motion.q[0])
    return CheckRequest(motion, scene, stored.concessions)


def stored_from(request: CheckRequest, model: RobotModel) -> StoredTrajectory:
    """What ``fit`` makes the same question of: a motion with all that it was judged in."""
    return StoredTrajectory(
        robot=model.description.name,
        trajectory=request.trajectory,
        held=held_in(request.scene),
        allowed=allowed_in(request.scene, model, request.trajectory.q[0]),
        objects=tuple(request.scene.objects.values()),
        concessions=request.concessions,
    )


def held_in(scene: PlanningScene) -> tuple[HeldObject, ...]:
    """What a robot carries in a scene."""
    return tuple(
        HeldObject(name, item.frame, item.frame_T_object, item.body.shape, item.touch_links, item.mass_kg)
        for name, item in scene.attached.items()
    )


def allowed_in(scene: PlanningScene, model: RobotModel, q: Array | None = None) -> frozenset[Pair]:
    """Pairs that a document may say to be allowed; those with things that are gone say nothing any more.

    Args:
        scene: Of the motion.
        model: The robot.
        q: Where the motion begins, shape (nq,); when left out, all of them are kept that may be allowed
            wherever it begins.
    """
    known = {*_frames(model), FLOOR, *scene.objects, *scene.attached}
    return frozenset(
        pair for pair in scene.allowed if pair <= known and why_not_allowed(pair, scene, model, q) is None
    )


def furnished(
    surroundings: PlanningScene,
    held: Sequence[HeldObject],
    allowed: Iterable[Pair],
    model: RobotModel,
    q: Array,
) -> PlanningScene:
    """Put what a robot holds into its hands, in a scene.

    Args:
        surroundings: What is around.
        held: What the robot carries.
        allowed: Pairs that may touch.
        model: The robot.
        q: Its configuration, shape (nq,).

    Raises:
        TrajectoryDocumentError: A name is none of the robot or the scene, or one of the scene is ambiguous;
            more is loosened than ``kinematics.formats.loosening`` lists.
    """
    frames = _frames(model)
    for name in surroundings.objects:
        _require_free("scene", name, frames)
    scene = surroundings
    for i, item in enumerate(held):
        place = f"held[{i}]"
        _require_free(f"{place}.name", item.name, frames)
        _require_known(f"{place}.frame", "frame", item.frame, frames)
        if not is_of_a_hand(model, item.frame):
            raise TrajectoryDocumentError(f"{place}.frame", f"{item.frame!r} is of no hand of the robot")
        about = links_about(model, item.frame)
        for link in sorted(item.touch_links):
            _require_known(f"{place}.touch_links", "link", link, frames)
            if link not in about:
                raise TrajectoryDocumentError(
                    f"{place}.touch_links", f"{link!r} is of another part of the robot than {item.frame!r}"
                )
        _require_taken(place, item, surroundings)
        world_T_object = model.frame_pose(q, item.frame) @ item.frame_T_object
        scene = scene.with_object(SceneObject(item.name, item.shape, world_T_object))
        scene = scene.with_attached(
            item.name, item.frame, item.frame_T_object, item.touch_links, item.mass_kg
        )
    known = [*frames, FLOOR, *scene.objects, *scene.attached]
    for pair in allowed:
        for name in pair:
            _require_known("allowed", "link or object", name, known)
        if (reason := why_not_allowed(pair, scene, model, q)) is not None:
            raise TrajectoryDocumentError("allowed", reason)
    return scene.allowing((first, second) for first, second in map(tuple, allowed))


def _require_taken(place: str, item: HeldObject, surroundings: PlanningScene) -> None:
    """What a hand holds of the scene is something that a hand can hold, and the thing itself."""
    there = surroundings.objects.get(item.name)
    if there is None:
        return
    if not there.movable:
        raise TrajectoryDocumentError(
            f"{place}.name", f"{item.name!r} is nothing of the scene that a hand holds"
        )
    if is_smaller(item.shape, there.shape):
        raise TrajectoryDocumentError(f"{place}.shape", f"is smaller than the scene's {item.name!r}")


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


def _require_known(place: str, what: str, name: str, known: list[str]) -> None:
    if name not in known:
        raise TrajectoryDocumentError(place, str(UnknownNameError(what, name, known)))


def _require_free(place: str, name: str, frames: list[str]) -> None:
    """Names of objects are not those of links: what may touch goes by name."""
    if name == FLOOR or name in frames:
        whose = "is the floor's name" if name == FLOOR else "is the name of a part of the robot"
        raise TrajectoryDocumentError(place, f"{name!r} {whose}; call the object something else")
