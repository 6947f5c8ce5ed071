"""What really is the case in the simulated world; for the perception stub, evaluation and tests."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import mujoco
import numpy as np
from numpy.typing import NDArray

from kinematics import poses
from kinematics.poses import Transform
from kinematics.robot_description import Hand
from kinematics.shapes import Ball, Box, Cylinder
from robots import articulated, furniture, scene_solids
from robots.perception.truth_view import TrueObject
from robots.scene_description import SceneItem
from robots.simulated.furniture_model import part_body
from robots.simulated.geom_roles import (
    FINGER_DRAWN_GROUP,
    HULL_GROUP,
    WORLD_GROUP,
    Role,
)
from robots.simulated.physics import Physics
from robots.simulated.support import SupportPolygon

Array = NDArray[np.float64]

FALLEN_HEIGHT = 0.7
"""A base below this share of its height at the start has fallen."""
FALLEN_TILT_RAD = 0.7
SOLE_LIFTED_M = 0.003
"""A sole whose centre is higher than this does not carry."""
RAY_SLACK_M = 0.002
"""A ray that ends this near to the point has reached it."""

_ROBOT = (Role.BODY, Role.FINGER, Role.PAD)
_THINGS = (Role.FURNITURE, Role.OBJECT, Role.PERSON)
_THING, _ROBOT_AND_THING = 4, 5


@dataclass(frozen=True, slots=True)
class TrueContact:
    """One touching pair.

    Attributes:
        first, second: Robot link, then furniture solid, object or person.
        force_n: Normal force, the sum over the pair's contact points.
    """

    first: str
    second: str
    force_n: float


@dataclass(frozen=True, slots=True)
class PadContact:
    """One contact point between a finger pad and an object.

    Attributes:
        pad: Fingertip link.
        friction: Coefficient of sliding friction that the simulator uses for it.
        normal_n: Normal force.
        tangential: Friction force on the object in the world, N, shape (3,).
    """

    pad: str
    friction: float
    normal_n: float
    tangential: Array


class SimulatorTruth:
    """The simulator's own knowledge; satisfies ``TruthView``."""

    def __init__(self, physics: Physics) -> None:
        self._physics = physics
        self._removed: set[str] = set()
        self._items: dict[str, SceneItem] = {item.name: item for item in physics.scene.objects}
        self._fixed = tuple(
            TrueObject(solid.name, "furniture", piece.kind, None, solid.shape, solid.world_T_solid)
            for piece in physics.scene.furniture
            for solid in furniture.solids(piece)
        )
        self._people = tuple(
            TrueObject(person.name, "person", "person", None, *scene_solids.person_solid(person))
            for person in physics.scene.people
        )
        self._parts = tuple(
            (TrueObject(solid.name, "furniture", solid.kind, None, solid.shape, solid.part_T_solid), body)
            for piece in physics.scene.furniture
            if piece.opens is not None
            for body in (physics.body_id(part_body(piece)),)
            for solid in articulated.moving_solids(piece)
            if solid.kind
        )
        self._camera_body = physics.body_id(physics.description.camera.frame)
        self._tcp_body = {
            hand: physics.body_id(item.tcp_frame) for hand, item in physics.description.grippers.items()
        }
        self._ray_groups = np.zeros(6, dtype=np.uint8)
        self._ray_groups[[WORLD_GROUP, HULL_GROUP, FINGER_DRAWN_GROUP]] = 1
        self._part_of = np.isin(physics.geom_role, _ROBOT) + _THING * np.isin(physics.geom_role, _THINGS)
        self._support = SupportPolygon()
        self._wrench = np.zeros(6)
        self._start_height_m = float(self.world_T_base()[2, 3])

    # --- what a perception stub may look at -------------------------------------------------

    def solids(self) -> tuple[TrueObject, ...]:
        """Everything that could be seen: furniture, people, then objects, in the scene's order."""
        objects = tuple(
            TrueObject(item.name, "object", item.kind, item.color, item.shape, self.world_T_object(item.name))
            for item in self._items.values()
            if item.name not in self._removed
        )
        return self._fixed + self._moving() + self._people + objects

    def _moving(self) -> tuple[TrueObject, ...]:
        """Doors, drawers and their handles where they are now."""
        return tuple(
            replace(solid, world_T_object=self._pose(body) @ solid.world_T_object)
            for solid, body in self._parts
        )

    def opening(self, furniture_name: str) -> float:
        """How far a door, rad, or a drawer, m, is open.

        Raises:
            KeyError: The scene has no such furniture, or it does not open.
        """
        return float(self._physics.data.qpos[self._physics.furniture.qpos[furniture_name]])

    def world_T_camera(self) -> Transform:
        """Pose of the camera's optical frame, shape (4, 4)."""
        return self._pose(self._camera_body)

    def visible(self, name: str, points: Array) -> NDArray[np.bool_]:
        """Tell for each world point, shape (n, 3), on a solid whether a ray from the camera meets
        that solid before it meets anything else (robot included), shape (n,).
        """
        physics = self._physics
        physics.refresh()
        start = physics.data.xpos[self._camera_body].copy()
        geom = -2 if any(person.name == name for person in self._people) else physics.geom_id(name)
        rays = np.ascontiguousarray(np.atleast_2d(points) - start)
        count = rays.shape[0]
        hit = np.full(count, -1, dtype=np.int32)
        share = np.zeros(count)  # of the ray's length: the rays are not normalised
        mujoco.mj_multiRay(
            physics.model, physics.data, start, rays.ravel(), self._ray_groups, True, -1, hit, share, None,
            count, 10.0,
        )  # fmt: skip
        length = np.linalg.norm(rays, axis=1)
        reached = (share < 0.0) | (share * length >= length - RAY_SLACK_M)
        return np.asarray((hit == geom) | reached, dtype=np.bool_)

    # --- where things are -------------------------------------------------------------------

    @property
    def time_s(self) -> float:
        """Simulated time."""
        return float(self._physics.data.time)

    def objects(self) -> tuple[str, ...]:
        """Names of the objects that are in the world, in the scene's order."""
        return tuple(name for name in self._items if name not in self._removed)

    def world_T_object(self, name: str) -> Transform:
        """Pose of an object, shape (4, 4).

        Raises:
            KeyError: The scene has no such object.
        """
        return self._pose(self._physics.object_body[name])

    def world_T_base(self) -> Transform:
        """Pose of the robot's base, shape (4, 4)."""
        return self._pose(self._physics.base_body)

    def world_T_tcp(self, hand: Hand) -> Transform:
        """Pose of a hand's TCP, shape (4, 4)."""
        return self._pose(self._tcp_body[hand])

    def world_T_link(self, link: str) -> Transform:
        """Pose of any link or frame of the robot, shape (4, 4)."""
        return self._pose(self._physics.body_id(link))

    def tcp_T_object(self, hand: Hand, name: str) -> Transform:
        """Pose of an object in a hand's TCP frame; its change while held is slip."""
        return poses.inverse(self.world_T_tcp(hand)) @ self.world_T_object(name)

    def world_T_odom(self) -> Transform:
        """Where the odometry frame (between the soles at the start, x ahead) lies in the world."""
        start = self._physics.scene.robot_start
        return poses.transform(poses.rotation_z(start.yaw_rad), (start.x_m, start.y_m, 0.0))

    def joint_positions(self) -> Array:
        """Joint positions without noise, shape (n,), order of ``RobotDescription.actuated``."""
        return np.array(self._physics.data.qpos[self._physics.joint_qpos])

    def joint_velocities(self) -> Array:
        """Joint velocities without noise, rad/s, shape (n,), same order."""
        return np.array(self._physics.data.qvel[self._physics.joint_qvel])

    def lowest_m(self, name: str) -> float:
        """Height of an object's lowest point above the floor."""
        world_T_object = self.world_T_object(name)
        shape, z = self._items[name].shape, world_T_object[2, :3]
        match shape:
            case Box(size_m=size):
                extent = float(0.5 * np.abs(z) @ np.asarray(size))
            case Cylinder(radius_m=radius, height_m=height):
                extent = float(0.5 * height * abs(z[2]) + radius * math.hypot(z[0], z[1]))
            case Ball(radius_m=radius):
                extent = radius
        return float(world_T_object[2, 3]) - extent

    def lift_m(self, name: str) -> float:
        """Height of an object's lowest point above the furniture under it, or above the floor."""
        return self.lowest_m(name) - self._ground_m(name)

    def tilt_rad(self, name: str) -> float:
        """Angle between an object's own z axis and the vertical."""
        return math.acos(float(np.clip(self.world_T_object(name)[2, 2], -1.0, 1.0)))

    def _ground_m(self, name: str) -> float:
        x, y, z = self.world_T_object(name)[:3, 3]
        height = 0.0
        for piece in self._physics.scene.furniture:
            for solid in furniture.solids(piece):
                local = poses.inverse(solid.world_T_solid) @ np.array([x, y, 0.0, 1.0])
                depth, width, thick = solid.shape.size_m
                top = float(solid.world_T_solid[2, 3]) + 0.5 * thick
                if abs(local[0]) <= 0.5 * depth and abs(local[1]) <= 0.5 * width and top <= z:
                    height = max(height, top)
        return height

    # --- balance ----------------------------------------------------------------------------

    def com(self) -> Array:
        """Centre of mass of the robot in the world, shape (3,)."""
        self._physics.refresh()
        return np.array(self._physics.data.subtree_com[self._physics.base_body])

    def com_margin_m(self) -> float:
        """Distance of the CoM's projection to the edge of the true support polygon, positive inside;
        ``-inf`` while no sole carries.
        """
        return self._support.margin_m(self.com()[:2], self._carrying_corners())

    def _carrying_corners(self) -> Array:
        physics = self._physics
        physics.refresh()
        corners = []
        for body, sole in zip(physics.sole_body, physics.description.soles, strict=True):
            rotation, origin = physics.data.xmat[body].reshape(3, 3), physics.data.xpos[body]
            if origin[2] > SOLE_LIFTED_M:
                continue
            local = np.array([(x, y, 0.0) for x in sole.x_m for y in sole.y_m])
            corners.append((local @ rotation.T + origin)[:, :2])
        return np.concatenate(corners) if corners else np.zeros((0, 2))

    def fallen(self) -> bool:
        """Tell whether the robot lies or is falling: base low or tilted far."""
        world_T_base = self.world_T_base()
        low = world_T_base[2, 3] < FALLEN_HEIGHT * self._start_height_m
        return bool(low or world_T_base[2, 2] < math.cos(FALLEN_TILT_RAD))

    # --- contacts ---------------------------------------------------------------------------

    def contacts_with_furniture(self) -> tuple[TrueContact, ...]:
        """What of the robot touches furniture now."""
        return self._contacts(_ROBOT, (Role.FURNITURE,))

    def furniture_force_on_robot(self) -> NDArray[np.float64]:
        """Sum of the forces of furniture and handles on the robot in the last physics step, N, shape (3,)."""
        physics, data, pairs = self._physics, self._physics.data, self._contact_geoms()
        total = np.zeros(3)
        roles = physics.geom_role[pairs]
        robot = np.isin(roles, _ROBOT)
        theirs = (roles == Role.FURNITURE) | (roles == Role.HANDLE)
        for i in np.flatnonzero(robot.any(axis=1) & theirs.any(axis=1)):
            mujoco.mj_contactForce(physics.model, data, int(i), self._wrench)
            force = data.contact.frame[i].reshape(3, 3).T @ self._wrench[:3]
            # MuJoCo's force acts on the second geom.
            total += force if robot[i, 1] else -force
        return total

    def contacts_with_people(self) -> tuple[TrueContact, ...]:
        """What of the robot touches a person now."""
        return self._contacts(_ROBOT, (Role.PERSON,))

    def contacts_with_objects(self) -> tuple[TrueContact, ...]:
        """What of the robot but its finger pads touches an object now."""
        return self._contacts((Role.BODY, Role.FINGER), (Role.OBJECT,))

    def robot_touches_something(self) -> bool:
        """Tell whether any part of the robot touches furniture, an object or a person; fast."""
        parts = self._part_of[self._contact_geoms()]
        return bool(np.any(parts.sum(axis=1) == _ROBOT_AND_THING))

    def in_pads_only(self) -> dict[str, Hand]:
        """Objects that finger pads of one hand touch and nothing else does, with that hand."""
        physics, pairs = self._physics, self._contact_geoms()
        is_pad = np.any(physics.geom_role[pairs] == Role.PAD, axis=1)
        is_object = physics.geom_role[pairs] == Role.OBJECT
        candidates = {int(geom) for geom in pairs[is_pad][is_object[is_pad]]}
        found: dict[str, Hand] = {}
        for geom in sorted(candidates):
            name = physics.geom_label[geom]
            touching = self.object_contacts(name)
            for hand, gripper in physics.description.grippers.items():
                if set(touching) <= set(gripper.pad_links):
                    found[name] = hand
        return found

    def object_contacts(self, name: str) -> tuple[str, ...]:
        """Everything that an object touches: links, furniture solids, objects, the floor; sorted.

        Raises:
            KeyError: The scene has no such object.
        """
        pairs, label = self._contact_geoms(), self._physics.geom_label
        mine = pairs == self._physics.object_geom[name]
        others = pairs[:, ::-1][mine]
        return tuple(sorted({label[geom] for geom in others}))

    def pad_contacts(self, name: str) -> tuple[PadContact, ...]:
        """Contact points between finger pads and an object, with their forces in the last physics step.

        Raises:
            KeyError: The scene has no such object.
        """
        physics, data = self._physics, self._physics.data
        geom, pairs = physics.object_geom[name], self._contact_geoms()
        is_pad = physics.geom_role[pairs] == Role.PAD
        found = []
        for i in np.flatnonzero(np.any(pairs == geom, axis=1) & np.any(is_pad, axis=1)):
            first, second = pairs[i]
            frame = data.contact.frame[i].reshape(3, 3)
            mujoco.mj_contactForce(physics.model, data, int(i), self._wrench)
            # MuJoCo's force acts on the second geom.
            sign = 1.0 if second == geom else -1.0
            tangential = sign * (frame[1] * self._wrench[1] + frame[2] * self._wrench[2])
            pad = physics.geom_label[first if second == geom else second]
            friction = float(data.contact.friction[i, 0])
            found.append(PadContact(pad, friction, float(self._wrench[0]), tangential))
        return tuple(found)

    def _contacts(self, mine: tuple[Role, ...], others: tuple[Role, ...]) -> tuple[TrueContact, ...]:
        physics, pairs = self._physics, self._contact_geoms()
        is_mine, is_other = np.zeros(len(Role), dtype=np.bool_), np.zeros(len(Role), dtype=np.bool_)
        is_mine[list(mine)], is_other[list(others)] = True, True
        roles = physics.geom_role[pairs]
        forward = is_mine[roles[:, 0]] & is_other[roles[:, 1]]
        backward = is_mine[roles[:, 1]] & is_other[roles[:, 0]]
        sums: dict[tuple[str, str], float] = {}
        for i in np.flatnonzero(forward | backward):
            first, second = pairs[i] if forward[i] else pairs[i, ::-1]
            mujoco.mj_contactForce(physics.model, physics.data, int(i), self._wrench)
            key = (physics.geom_label[first], physics.geom_label[second])
            sums[key] = sums.get(key, 0.0) + float(self._wrench[0])
        return tuple(TrueContact(a, b, force) for (a, b), force in sorted(sums.items()))

    def _contact_geoms(self) -> NDArray[np.int32]:
        """Pairs of touching geoms, shape (contacts, 2)."""
        return np.asarray(self._physics.data.contact.geom, dtype=np.int32).reshape(-1, 2)

    # --- for the fault injector ---------------------------------------------------------------

    def forget(self, name: str) -> None:
        """Treat an object as gone: it was taken out of the world."""
        self._removed.add(name)

    def remember(self, name: str) -> None:
        """Treat an object as there again."""
        self._removed.discard(name)

    def _pose(self, body: int) -> Transform:
        self._physics.refresh()
        return self._physics.body_pose(body)
