"""Put objects at a wanted distance from where a robot passes."""

from __future__ import annotations

import hashlib
from dataclasses import replace

import numpy as np
import pinocchio as pin
from scipy.spatial import ConvexHull

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.convex_parts import ConvexParts
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from kinematics.ik.arm_frames import link_moved_by
from kinematics.model.robot_model import RobotModel
from kinematics.motion.trajectory import Trajectory
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from tools.checking.ray import Ray
from tools.checking.referee import Referee
from tools.checking.solid_world import SolidWorld

_CLOSENESS_M = 0.00005
_MOST_CORNERS = 40
# Along a ray from the robot, at most.
_FAR_M = 1.2


def random_shape(rng: np.random.Generator) -> Shape:
    """Anything from a rod of 1 mm to a box of half a metre."""
    kind = rng.choice(["box", "plate", "cylinder", "rod", "ball"])
    if kind == "box":
        x, y, z = rng.uniform(0.03, 0.3, 3)
        return Box((x, y, z))
    if kind == "plate":
        return Box((rng.uniform(0.1, 0.5), rng.uniform(0.1, 0.5), rng.uniform(0.005, 0.02)))
    if kind == "cylinder":
        return Cylinder(rng.uniform(0.02, 0.1), rng.uniform(0.05, 0.3))
    if kind == "rod":
        radius = float(np.exp(rng.uniform(np.log(0.0005), np.log(0.006))))
        return Cylinder(radius, rng.uniform(0.1, 0.6))
    return Ball(rng.uniform(0.01, 0.12))


def shape_of_parts(rng: np.random.Generator, size_m: tuple[float, float, float] | None = None) -> Box:
    """Some convex parts at random that together are one thing, and the box that holds them.

    Args:
        rng: Draws them.
        size_m: Of the box; drawn when left out.
    """
    size = np.array(rng.uniform(0.04, 0.3, 3) if size_m is None else size_m)
    hulls = []
    for _ in range(int(rng.integers(2, 7))):
        flat = np.where(rng.random(3) < 0.3, 0.08, 1.0)  # walls, handles and stems are thin
        points = rng.normal(size=(int(rng.integers(8, 60)), 3))
        points *= flat * rng.uniform(0.15, 0.5, 3) / np.linalg.norm(points, axis=1)[:, None]
        turned = points @ random_rotation(rng).T + rng.uniform(-0.3, 0.3, 3)
        corners = turned[ConvexHull(turned).vertices]
        hulls.append(corners[:_MOST_CORNERS])
    corners = np.concatenate(hulls)
    low, high = corners.min(axis=0), corners.max(axis=0)
    corners = (corners - 0.5 * (low + high)) * (size / (high - low))
    ends = tuple(int(end) for end in np.cumsum([len(hull) for hull in hulls]))
    key = hashlib.sha256(corners.tobytes()).hexdigest()
    x, y, z = size.tolist()
    return Box((x, y, z), ConvexParts(key, corners, ends))


def random_thing(rng: np.random.Generator, parts: bool) -> Shape:
    """Anything: of convex parts, or a simple solid."""
    return shape_of_parts(rng) if parts else random_shape(rng)


def random_rotation(rng: np.random.Generator) -> Array:
    """Uniform rotation, shape (3, 3)."""
    return np.asarray(pin.Quaternion(*(lambda w: w / np.linalg.norm(w))(rng.normal(size=4))).matrix())


class Placer:
    """Places objects beside, or into, the way of a motion."""

    def __init__(self, model: RobotModel) -> None:
        self._model = model
        self._referee = Referee(model)

    def place(
        self,
        rng: np.random.Generator,
        trajectory: Trajectory,
        scene: PlanningScene,
        item: SceneObject,
        gap_m: float,
        link: str | None = None,
        around_s: float | None = None,
        beside: bool = False,
    ) -> SceneObject | None:
        """Move an object along a ray from the robot until it is ``gap_m`` beyond its margin away.

        Args:
            rng: Draws link, time and direction.
            trajectory: What moves.
            scene: What else is there; held objects count as the robot.
            item: The object; its orientation is kept.
            gap_m: Smallest distance over the motion, less the margin; negative to collide.
            link: Link or held object at which the ray starts; a moving one when not given.
            around_s: Look at so much time around the drawn instant alone, but every millisecond.
            beside: Around the instant at which the link is fastest, and across its way.

        Returns:
            The object in place, or none when the ray does not get there.
        """
        count = int(np.clip(trajectory.duration_s / 0.02, 20, 100))
        rows = self._referee.configurations(trajectory, np.linspace(0.0, trajectory.duration_s, count))
        when = int(rng.integers(count))
        if around_s is not None:
            middle_s = trajectory.duration_s * rng.uniform(0.2, 0.8)
            link = link or self._moving_link(rng, trajectory)
            if beside:
                way = np.diff([self._centre(row, scene, link) for row in rows], axis=0)
                middle_s = trajectory.duration_s * int(np.linalg.norm(way, axis=1).argmax()) / (count - 1)
            start, end = max(middle_s - around_s, 0.0), min(middle_s + around_s, trajectory.duration_s)
            instants = np.linspace(start, end, int((end - start) / 0.001) + 1)
            rows = self._referee.configurations(trajectory, instants)
            when = len(rows) // 2
        origin = self._centre(rows[when], scene, link or self._moving_link(rng, trajectory))
        ray = rng.normal(size=3)
        if beside and 0 < when < len(rows) - 1:
            after, before = (self._centre(rows[when + k], scene, link or "") for k in (1, -1))
            ahead = (after - before) / max(float(np.linalg.norm(after - before)), 1e-9)
            ray -= (ray @ ahead) * ahead
        ray /= np.linalg.norm(ray)

        placed = replace(item, world_T_object=poses.transform(item.world_T_object[:3, :3], origin))
        world = SolidWorld(self._model, scene.with_object(placed), only=frozenset([item.name]))
        along = Ray(self._model, world, item.name, origin, ray, rows)
        if along.nearer_than(_FAR_M, gap_m) or not along.nearer_than(0.0, gap_m):
            return None
        low, high = 0.0, _FAR_M
        while high - low > _CLOSENESS_M:
            middle = 0.5 * (low + high)
            low, high = (middle, high) if along.nearer_than(middle, gap_m) else (low, middle)
        distance = low if gap_m < 0.0 else high
        pose = poses.transform(item.world_T_object[:3, :3], origin + distance * ray)
        return replace(item, world_T_object=pose)

    def is_brief(self, trajectory: Trajectory, scene: PlanningScene, name: str, most_s: float) -> bool:
        """Tell whether an object is touched for about ``most_s`` at most in the whole motion."""
        world = SolidWorld(self._model, scene, only=frozenset([name]))
        # a coarse look tells most of the cases that are not, soon
        for step_s, most in ((0.02, 1), (0.25 * most_s, 4)):
            instants = np.asarray(np.arange(0.0, trajectory.duration_s, step_s), dtype=np.float64)
            touched = 0
            for q in self._referee.configurations(trajectory, instants):
                touched += world.nearer_than(q, 0.0)
                if touched > most:
                    return False
        return True

    def _moving_link(self, rng: np.random.Generator, trajectory: Trajectory) -> str:
        moving = np.ptp(trajectory.q[:, 7:], axis=0) > 0.02
        robot, group = self._model.description, self._model.group
        sides = [hand for hand in robot.gripping_hands if moving[group(f"{hand}_arm")].any()]
        hand = rng.choice(sides or ["right"])
        arm = robot.groups[f"{hand}_arm"]
        names = [
            *robot.grippers[hand].links,
            *(link_moved_by(self._model, arm[from_end]) for from_end in (-1, -3, -4)),
        ]
        return str(rng.choice(names))

    def _centre(self, q: Array, scene: PlanningScene, name: str) -> Array:
        model = self._model
        if name in scene.attached:
            body = scene.attached[name]
            return np.asarray((model.frame_pose(q, body.frame) @ body.frame_T_object)[:3, 3])
        return np.asarray(model.frame_pose(q, name)[:3, 3])
