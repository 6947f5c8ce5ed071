"""What really touches what in the simulated world, and how hard."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.model.robot_description import Hand
from robots.simulated.body.geom_roles import Role
from robots.simulated.body.physics import Physics

_ROBOT = (Role.BODY, Role.FINGER, Role.PAD)
_THINGS = (Role.FURNITURE, Role.OBJECT, Role.PERSON)
_THING, _ROBOT_AND_THING = 4, 5


@dataclass(frozen=True, slots=True)
class TrueContact:
    """Two bodies that really touch, and how hard.

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


class TrueContacts:
    """The contacts of the last physics step."""

    def __init__(self, physics: Physics) -> None:
        self._physics = physics
        self._is_robot = np.isin(physics.geom_role, _ROBOT)
        self._may_hinder = np.isin(physics.geom_role, (Role.FURNITURE, Role.HANDLE))
        self._part_of = self._is_robot + _THING * np.isin(physics.geom_role, _THINGS)
        self._wrench = np.zeros(6)

    def robot_with_furniture(self) -> tuple[TrueContact, ...]:
        """What of the robot touches furniture now."""
        return self._contacts(_ROBOT, (Role.FURNITURE,))

    def furniture_force_on_robot(self) -> NDArray[np.float64]:
        """Sum of the forces of furniture and handles on the robot in the last physics step, N, shape (3,)."""
        physics, data, pairs = self._physics, self._physics.data, self._contact_geoms()
        total = np.zeros(3)
        robot, theirs = self._is_robot[pairs], self._may_hinder[pairs]
        for i in np.flatnonzero(robot.any(axis=1) & theirs.any(axis=1)):
            mujoco.mj_contactForce(physics.model, data, int(i), self._wrench)
            force = data.contact.frame[i].reshape(3, 3).T @ self._wrench[:3]
            # MuJoCo's force acts on the second geom.
            total += force if robot[i, 1] else -force
        return total

    def robot_with_people(self) -> tuple[TrueContact, ...]:
        """What of the robot touches a person now."""
        return self._contacts(_ROBOT, (Role.PERSON,))

    def robot_with_objects(self) -> tuple[TrueContact, ...]:
        """What of the robot, finger pads included, touches an object now."""
        return self._contacts(_ROBOT, (Role.OBJECT,))

    def robot_with_floor(self) -> tuple[TrueContact, ...]:
        """What of the robot stands on the floor now."""
        return self._contacts(_ROBOT, (Role.FLOOR,))

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
            touching = self.of_object(name)
            for hand, gripper in physics.description.grippers.items():
                if set(touching) <= set(gripper.pad_links):
                    found[name] = hand
        return found

    def of_object(self, name: str) -> tuple[str, ...]:
        """Everything that an object touches: links, furniture solids, objects, the floor; sorted.

        Raises:
            KeyError: The scene has no such object.
        """
        pairs, label = self._contact_geoms(), self._physics.geom_label
        mine = np.isin(pairs, self._physics.object_geoms[name])
        others = pairs[:, ::-1][mine]
        return tuple(sorted({label[geom] for geom in others}))

    def of_pads(self, name: str) -> tuple[PadContact, ...]:
        """Contact points between finger pads and an object, with their forces in the last physics step.

        Raises:
            KeyError: The scene has no such object.
        """
        physics, data = self._physics, self._physics.data
        pairs = self._contact_geoms()
        is_mine = np.isin(pairs, physics.object_geoms[name])
        is_pad = physics.geom_role[pairs] == Role.PAD
        found = []
        for i in np.flatnonzero(np.any(is_mine, axis=1) & np.any(is_pad, axis=1)):
            first, second = pairs[i]
            frame = data.contact.frame[i].reshape(3, 3)
            mujoco.mj_contactForce(physics.model, data, int(i), self._wrench)
            # MuJoCo's force acts on the second geom.
            sign = 1.0 if is_mine[i, 1] else -1.0
            tangential = sign * (frame[1] * self._wrench[1] + frame[2] * self._wrench[2])
            pad = physics.geom_label[first if is_mine[i, 1] else second]
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
