"""What really is the case in the simulated world; for the perception stub, evaluation and tests."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property

import mujoco
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.model.robot_description import Hand
from robots.perception.truth_view import TrueObject
from robots.scenes import furniture
from robots.scenes.articulated import MovingSolid
from robots.scenes.fixture import control_solid
from robots.scenes.furniture_names import own_name
from robots.scenes.moving_parts import Moving, moving_parts
from robots.scenes.person_solid import person_solid
from robots.scenes.scene_description import Furniture, Person, SceneItem, told_names
from robots.simulated.body.control_model import control_body, control_name
from robots.simulated.body.furniture_model import part_body
from robots.simulated.body.geom_roles import FINGER_DRAWN_GROUP, HULL_GROUP, WORLD_GROUP, in_simulator
from robots.simulated.body.physics import Physics
from robots.simulated.truth.true_contacts import TrueContacts
from robots.simulated.truth.true_support import SupportPolygon

FALLEN_HEIGHT = 0.7
"""A base below this share of its height at the start has fallen."""
FALLEN_TILT_RAD = 0.7
SOLE_LIFTED_M = 0.003
"""A sole whose centre is higher than this does not carry."""
RAY_SLACK_M = 0.002
"""A ray that ends this near to the point has reached it."""


class SimulatorTruth:
    """The simulator's own knowledge; satisfies ``TruthView``.

    Attributes:
        contacts: What touches what.
    """

    def __init__(self, physics: Physics) -> None:
        self._physics = physics
        self.contacts = TrueContacts(physics)
        self._removed: set[str] = set()
        self._items: dict[str, SceneItem] = {item.name: item for item in physics.scene.objects}
        self._seen_as = {item.name: _seen_as(item) for item in physics.scene.objects}
        self._fixed = tuple(one for piece in physics.scene.furniture for one in _fixed_of(piece))
        self._tops = tuple(
            _top_of(solid) for piece in physics.scene.furniture for solid in furniture.solids(piece)
        )
        self._regions = frozenset(
            plate.name for piece in physics.scene.furniture for plate in furniture.region_plates(piece)
        )
        self._people = tuple(
            (_person_seen_as(person), physics.body_id(in_simulator(person.name)) if person.walks else None)
            for person in physics.scene.people
        )
        self._parts = tuple(
            (_part_seen_as(piece, part, solid), body)
            for piece in physics.scene.furniture
            for part in moving_parts(piece)
            for body in (physics.body_id(part_body(part)),)
            for solid in part.solids
            if solid.kind
        )
        self._parts += tuple(
            (
                TrueObject(
                    control_name(piece, control),
                    "furniture",
                    control.kind,
                    None,
                    control_solid(control).shape,
                    np.eye(4),
                    names=(f"{piece.name} {control.name}",),
                ),
                physics.body_id(control_body(piece, control)),
            )
            for piece in physics.scene.furniture
            for control in piece.controls
        )
        self._tcp_body = {
            hand: physics.body_id(frame) for hand, frame in physics.description.tcp_frames.items()
        }
        self._ray_groups = np.zeros(6, dtype=np.uint8)
        self._ray_groups[[WORLD_GROUP, HULL_GROUP, FINGER_DRAWN_GROUP]] = 1
        self._support = SupportPolygon()
        self._start_height_m = float(self.world_T_base()[2, 3])

    # --- what a perception stub may look at -------------------------------------------------

    def solids(self) -> tuple[TrueObject, ...]:
        """Everything that could be seen: furniture, people, then objects, in the scene's order."""
        objects = tuple(
            replace(self._seen_as[name], world_T_object=self.world_T_object(name))
            for name in self._items
            if name not in self._removed
        )
        return self._fixed + self._moving() + self._present() + objects

    def person(self, name: str) -> TrueObject:
        """A person where they are now: what ``solids`` has of them.

        Raises:
            KeyError: Nobody of that name is there.
        """
        for person, body in self._people:
            if person.name == name and name not in self._removed:
                return self._present_at(person, body)
        raise KeyError(name)

    def _present(self) -> tuple[TrueObject, ...]:
        """People where they are now."""
        return tuple(
            self._present_at(person, body)
            for person, body in self._people
            if person.name not in self._removed
        )

    def _present_at(self, person: TrueObject, body: int | None) -> TrueObject:
        if body is None:
            return person
        above_floor = poses.translation(0.0, 0.0, 0.5 * person.shape.height_m)
        return replace(person, world_T_object=self._pose(body) @ above_floor)

    def _moving(self) -> tuple[TrueObject, ...]:
        """Doors, drawers and their handles where they are now."""
        return tuple(
            replace(solid, world_T_object=self._pose(body) @ solid.world_T_object)
            for solid, body in self._parts
        )

    def opening(self, furniture_name: str) -> float:
        """How far a door, rad, or a drawer, m, is open; of "stove/knob" how far it is turned, or pressed.

        Args:
            furniture_name: "fridge"; of what has several of them "wooden cabinet/top drawer".

        Raises:
            KeyError: The scene has no such furniture, or it does not open.
        """
        return float(self._physics.data.qpos[self._physics.furniture.qpos[furniture_name]])

    def world_T_camera(self) -> Transform:
        """Pose of the camera's optical frame, shape (4, 4)."""
        return self._pose(self._camera_body)

    @cached_property
    def _camera_body(self) -> int:
        """MuJoCo's index of the camera's frame; MissingPartError for a robot that has no camera."""
        return self._physics.body_id(self._physics.description.camera.frame)

    def visible(self, name: str, points: Array) -> NDArray[np.bool_]:
        """Tell for each world point, shape (n, 3), on a solid whether a ray from the camera meets
        that solid before it meets anything else (robot included), shape (n,).
        """
        self._physics.refresh()
        return self.visible_from(self._physics.data.xpos[self._camera_body].copy(), name, points)

    def visible_from(self, start: Array, name: str, points: Array) -> NDArray[np.bool_]:
        """The same from any place in the world, shape (3,)."""
        physics = self._physics
        physics.refresh()
        own = self._own_geoms(name)
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
        return np.asarray(np.isin(hit, own) | reached, dtype=np.bool_)

    def _own_geoms(self, name: str) -> list[int]:
        """What of a solid a ray may meet; of what has a mesh, what is seen of it and its parts."""
        if name in self._regions or any(person.name == name for person, _ in self._people):
            return []
        if name in self._items and self._items[name].model is not None:
            return [k for k, label in enumerate(self._physics.geom_label) if label == name]
        return [self._physics.scene_geom_id(name)]

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

    @property
    def hands(self) -> tuple[Hand, ...]:
        """The hands that can hold something, left before right."""
        return tuple(self._tcp_body)

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
        if shape.parts is not None:
            return float(world_T_object[2, 3] + (shape.parts.corners @ z).min())
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
        height, place = 0.0, np.array([x, y, 0.0, 1.0])
        for solid_T_world, (half_depth, half_width), top in self._tops:
            if height < top <= z:
                local = solid_T_world @ place
                if abs(local[0]) <= half_depth and abs(local[1]) <= half_width:
                    height = top
        return height

    # --- balance ----------------------------------------------------------------------------

    def com(self) -> Array:
        """Centre of mass of the robot in the world, shape (3,)."""
        self._physics.refresh()
        return np.array(self._physics.data.subtree_com[self._physics.base_body])

    def com_margin_m(self) -> float:
        """Distance of the CoM's projection to the edge of the true support polygon, positive inside;
        ``-inf`` while no sole carries, ``inf`` of a welded robot.
        """
        if self._physics.description.welded:
            return math.inf
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
        """Tell whether the robot lies or is falling: base low or tilted far. A welded one cannot fall."""
        if self._physics.description.welded:
            return False
        world_T_base = self.world_T_base()
        low = world_T_base[2, 3] < FALLEN_HEIGHT * self._start_height_m
        return bool(low or world_T_base[2, 2] < math.cos(FALLEN_TILT_RAD))

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


def _fixed_of(piece: Furniture) -> Iterator[TrueObject]:
    """The solids of a piece that do not move, and behind them the floors of its named regions."""
    for solid in furniture.solids(piece):
        yield TrueObject(
            solid.name,
            "furniture",
            piece.kind,
            None,
            solid.shape,
            solid.world_T_solid,
            names=piece.names,
            categories=piece.categories,
        )
    for region, plate in zip(piece.regions, furniture.region_plates(piece), strict=True):
        name = region.name.lower()
        yield TrueObject(plate.name, "furniture", name, None, plate.shape, plate.world_T_solid)


def _part_seen_as(piece: Furniture, part: Moving, solid: MovingSolid) -> TrueObject:
    """What a camera is shown of a door or drawer, where its own frame has it."""
    of = own_name(piece.name, piece.kind) or piece.kind
    moves = part.known_part(furniture.floor_pose(piece), solid, of, piece.names)
    pose = solid.part_T_solid
    return TrueObject(solid.name, "furniture", solid.kind, None, solid.shape, pose, moves=moves)


def _top_of(solid: furniture.FurnitureSolid) -> tuple[Array, tuple[float, float], float]:
    """World to solid, half depth and width, and the height of the top: what a thing may be above."""
    depth, width, thick = solid.shape.size_m
    top = float(solid.world_T_solid[2, 3]) + 0.5 * thick
    return poses.inverse(solid.world_T_solid), (0.5 * depth, 0.5 * width), top


def _seen_as(item: SceneItem) -> TrueObject:
    """What a camera is shown of an object, where the scene has it at first."""
    names = told_names(item.name, item.kind, item.names)
    return TrueObject(
        item.name, "object", item.kind, item.color, item.shape, item.world_T_object, names, item.categories
    )


def _person_seen_as(person: Person) -> TrueObject:
    """What a camera is shown of somebody."""
    shape, place = person_solid(person)
    gesture = () if person.gesture is None else (person.gesture,)
    traits = (person.posture, *gesture, *person.clothes)
    return TrueObject(person.name, "person", "person", None, shape, place, traits=traits)
