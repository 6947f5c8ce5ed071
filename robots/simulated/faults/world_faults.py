"""Things that go wrong in the world on purpose."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from robots.scenes.scene_description import SceneItem
from robots.simulated.body.body_model import PATCH_RADIUS_M, pad_name
from robots.simulated.body.geom_roles import in_simulator
from robots.simulated.body.physics import Physics
from robots.simulated.body.scene_model import friction_row, pair_name
from robots.simulated.truth.truth import SimulatorTruth

AWAY_M = 30.0
"""Objects that were taken out of the world wait on the floor this far behind the robot."""
GRAVITY_M_S2 = 9.81
SHOVE_SPEED_M_S = 0.15
SHOVE_ACCELERATION_M_S2 = 0.5
SHOVE_TIME_CONSTANT_S = 0.02
SHOVE_TIMEOUT_S = 3.0


@dataclass(slots=True)
class _Shove:
    name: str
    heading: Array
    distance_m: float
    since_s: float | None = None
    start: Array = field(default_factory=lambda: np.zeros(3))


class FaultInjector:
    """Changes the world behind the robot's back: at once, at a time, or when a condition holds."""

    def __init__(self, physics: Physics, truth: SimulatorTruth) -> None:
        self._physics, self._truth = physics, truth
        self._items: dict[str, SceneItem] = {item.name: item for item in physics.scene.objects}
        self._shoves: list[_Shove] = []
        self._waiting: list[tuple[Callable[[], bool], Callable[[], None]]] = []

    # --- when ---------------------------------------------------------------------------------

    def at(self, time_s: float, action: Callable[[], None]) -> None:
        """Do something at a simulated time, once, before the control period that begins then."""
        self.when(lambda: self._truth.time_s >= time_s - 1e-9, action)

    def when(self, condition: Callable[[], bool], action: Callable[[], None]) -> None:
        """Do something once, at the beginning of the first control period in which a condition holds."""
        self._waiting.append((condition, action))

    def tick(self) -> None:
        """Do what is due; called at the beginning of each control period by the robot."""
        if self._shoves:
            self._shoves = [shove for shove in self._shoves if self._go_on(shove)]
        if not self._waiting:
            return
        due = [item for item in self._waiting if item[0]()]
        if due:
            self._waiting = [item for item in self._waiting if item not in due]
            for _, action in due:
                action()

    # --- what ---------------------------------------------------------------------------------

    def teleport(self, name: str, world_T_object: Transform) -> None:
        """Put an object somewhere else, at rest.

        Raises:
            KeyError: The scene has no such object.
        """
        physics = self._physics
        start, speed = physics.object_qpos[name], physics.object_qvel[name]
        x, y, z, w = poses.quaternion_from_rotation(world_T_object[:3, :3])
        physics.data.qpos[start : start + 7] = (*world_T_object[:3, 3], w, x, y, z)
        physics.data.qvel[speed : speed + 6] = 0.0
        physics.data.xfrc_applied[physics.object_body[name]] = 0.0
        self._shoves = [shove for shove in self._shoves if shove.name != name]
        physics.refresh_after_change()
        self._truth.remember(name)

    def remove(self, name: str) -> None:
        """Take an object out of the world: from its place, or from the hand that holds it.

        Raises:
            KeyError: The scene has no such object.
        """
        height = 0.5 * self._items[name].shape.height_m
        index = list(self._items).index(name)
        self.teleport(name, poses.translation(-AWAY_M, 2.0 * index, height))
        self._truth.forget(name)

    def displace(self, name: str, offset_m: tuple[float, float]) -> None:
        """Move an object that stands somewhere by a step in the world's x and y, upright as it was."""
        self.teleport(name, poses.translation(*offset_m, 0.0) @ self._truth.world_T_object(name))

    def set_opening(self, furniture_name: str, opening: float) -> None:
        """Somebody moves a door, rad, or a drawer, m, and lets it stand there.

        Raises:
            KeyError: The scene has no such furniture, or it does not open.
        """
        parts = self._physics.furniture
        self._physics.data.qpos[parts.qpos[furniture_name]] = opening
        self._physics.data.qvel[parts.dof[furniture_name]] = 0.0

    def push(self, name: str, impulse_ns: tuple[float, float, float], height_m: float = 0.0) -> None:
        """Hit an object: a momentum in the world, given at a height above its centre.

        Args:
            name: The object.
            impulse_ns: Momentum, kg m/s.
            height_m: Where it hits, above the object's centre, along the world's z.
        """
        physics = self._physics
        physics.refresh()
        body, speed = physics.object_body[name], physics.object_qvel[name]
        impulse = np.asarray(impulse_ns, dtype=np.float64)
        rotation = physics.data.ximat[body].reshape(3, 3)
        torque = np.cross((0.0, 0.0, height_m), impulse)
        spin = (rotation.T @ torque) / physics.model.body_inertia[body]
        # A free joint's velocity: linear in the world, angular in the body.
        body_R_inertia = physics.data.xmat[body].reshape(3, 3).T @ rotation
        physics.data.qvel[speed : speed + 3] += impulse / physics.model.body_mass[body]
        physics.data.qvel[speed + 3 : speed + 6] += body_R_inertia @ spin

    def knock(self, name: str, direction_rad: float, distance_m: float = 0.05) -> None:
        """Shove an object along what it stands on, so that it stays standing.

        A short hit would not do: friction tips over what is taller than it is wide before it has slid
        far. So it is pushed at its base for as long as it takes, at ``SHOVE_SPEED_M_S``.

        Args:
            name: The object.
            direction_rad: Heading of the shove in the world.
            distance_m: How far it is shoved, unless something is in the way.

        Raises:
            KeyError: The scene has no such object.
        """
        heading = np.array([np.cos(direction_rad), np.sin(direction_rad), 0.0])
        self._shoves.append(_Shove(self._items[name].name, heading, distance_m))

    def tip_over(self, name: str, direction_rad: float) -> None:
        """Push an object at its top, just hard enough that it falls over and lies.

        Args:
            name: The object.
            direction_rad: Heading in which it falls.
        """
        item, body = self._items[name], self._physics.object_body[name]
        half_base, half_height = _half_base(item.shape), 0.5 * item.shape.height_m
        mass, inertia = item.mass_kg, float(self._physics.model.body_inertia[body].max())
        # Energy to lift the centre over the edge of the base, half as much again, as spin about that edge.
        radius = float(np.hypot(half_base, half_height))
        rise = radius - half_height
        about_edge = inertia + mass * radius * radius
        spin = float(np.sqrt(2.0 * 1.5 * mass * GRAVITY_M_S2 * max(rise, 0.002) / about_edge))
        axis = np.array([-np.sin(direction_rad), np.cos(direction_rad), 0.0])
        heading = np.array([np.cos(direction_rad), np.sin(direction_rad), 0.0])
        to_centre = np.array([0.0, 0.0, half_height]) - half_base * heading
        self._physics.refresh()
        start = self._physics.object_qvel[name]
        world_R_body = self._physics.data.xmat[body].reshape(3, 3)
        self._physics.data.qvel[start : start + 3] += np.cross(spin * axis, to_centre)
        self._physics.data.qvel[start + 3 : start + 6] += world_R_body.T @ (spin * axis)

    def set_pad_friction(self, name: str, friction: float) -> None:
        """Make an object slippery or rough to the finger pads.

        Args:
            name: The object.
            friction: Coefficient of sliding friction, above 0.
        """
        model = self._physics.model
        for gripper in self._physics.description.grippers.values():
            for link in gripper.pad_links:
                pair = self._physics.pair_id(pair_name(pad_name(link), in_simulator(name)))
                model.pair_friction[pair] = friction_row(friction, PATCH_RADIUS_M)

    def _go_on(self, shove: _Shove) -> bool:
        """Push for one more period; tell whether the shove goes on after it."""
        physics, truth = self._physics, self._truth
        body, speed = physics.object_body[shove.name], physics.object_qvel[shove.name]
        if shove.since_s is None:
            shove.since_s, shove.start = truth.time_s, truth.world_T_object(shove.name)[:3, 3].copy()
        done_m = float((truth.world_T_object(shove.name)[:3, 3] - shove.start) @ shove.heading)
        left_m = shove.distance_m - done_m
        if left_m <= 0.0005 or truth.time_s - shove.since_s > SHOVE_TIMEOUT_S:
            physics.data.xfrc_applied[body] = 0.0
            return False
        ramp = np.sqrt(2.0 * SHOVE_ACCELERATION_M_S2 * np.array([done_m + 0.0002, left_m]).clip(0.0))
        wanted = min(SHOVE_SPEED_M_S, float(ramp.min()))
        item = self._items[shove.name]
        friction_n = self._ground_friction() * item.mass_kg * GRAVITY_M_S2
        present = float(physics.data.qvel[speed : speed + 3] @ shove.heading)
        push_n = friction_n + item.mass_kg * (wanted - present) / SHOVE_TIME_CONSTANT_S
        force = min(max(push_n, 0.0), 2.0 * friction_n) * shove.heading
        # At the base, where friction is: the two make no couple that would tip it.
        lever = np.array([0.0, 0.0, truth.lowest_m(shove.name) - truth.world_T_object(shove.name)[2, 3]])
        physics.data.xfrc_applied[body] = (*force, *np.cross(lever, force))
        return True

    def _ground_friction(self) -> float:
        pieces = self._physics.scene.furniture
        return max((piece.friction for piece in pieces), default=0.7)


def _half_base(shape: Shape) -> float:
    match shape:
        case Box(size_m=size):
            return 0.5 * max(size[0], size[1])
        case Cylinder(radius_m=radius) | Ball(radius_m=radius):
            return radius
