"""Moves the hand of a simulated person: a spring with a force limit, and a pinch."""

from __future__ import annotations

import math

import mujoco
import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from robots.simulated.body.geom_roles import Role
from robots.simulated.body.person_model import HAND_REST_M, PINCH_M, hand_body, hand_joint, pad_geom
from robots.simulated.body.physics import Physics

STIFFNESS_N_M = 250.0
FORCE_N = 20.0
"""The most that the spring pulls with."""
SPEED_M_S = 0.35
"""The spring's other end moves no faster than this."""
PINCH_N = 22.0
ROLL_STIFFNESS_NM = 4.0
_GAP_STIFFNESS_N_M = 400.0
_CENTRE_STIFFNESS_N_M = 1000.0
"""Of the two fingers together, once they have hold: else what they carry would sink with both of them."""
_FAR_M = 0.05


class PersonHand:
    """One person's hand; ``tick`` is called once each control period.

    Attributes:
        force_n: Limit of the spring's force.
        pinching: Whether the pads press together; else they are open.
        open_m: How far from the hand's middle an open pad is.
        roll_rad: Turn of the pinch about the forearm: 0 is from above and below.
    """

    def __init__(self, physics: Physics, person: str) -> None:
        """Take over a hand at rest.

        Raises:
            StopIteration: There is no such person.
        """
        self._physics = physics
        self._body = physics.body_id(hand_body(person))
        place = next(one for one in physics.scene.people if one.name == person)
        self._world_T_person = poses.transform(poses.rotation_z(place.yaw_rad), (*place.position_m, 0.0))
        self._dof = {
            axis: self._addresses(hand_joint(person, axis))
            for axis in ("x", "y", "z", "roll", "upper", "lower")
        }
        self.force_n = FORCE_N
        self.pinching = False
        self.open_m = PINCH_M[1]
        self.roll_rad = 0.0
        self._centre_m: float | None = None
        self._pads = [physics.geom_id(pad_geom(person, side)) for side in ("upper", "lower")]
        mine = np.isin(physics.geom_role, (Role.BODY, Role.FINGER, Role.PAD))
        self._robot = [int(i) for i in np.flatnonzero(mine)]
        self._elsewhere = mujoco.MjData(physics.model)
        self._rest = (self._world_T_person @ [*HAND_REST_M, 1.0])[:3]
        self._goal, self._anchor = self._rest.copy(), self._rest.copy()

    def place(self) -> Array:
        """Where the middle of the hand is, in the world, shape (3,)."""
        self._physics.refresh()
        return np.array(self._physics.data.xpos[self._body])

    def turn_to(self, direction: Array) -> None:
        """Point somewhere else, where the hand is, as that of somebody who turns does.

        Args:
            direction: Horizontal, world, shape (3,).
        """
        half = 0.5 * math.atan2(direction[1], direction[0])
        turned = poses.rotation_z(2.0 * half)
        across = turned.T @ self._world_T_person[:3, :3]
        self._physics.model.body_quat[self._body] = (math.cos(half), 0.0, 0.0, math.sin(half))
        data = self._physics.data
        for values, column in ((data.qpos, 0), (data.qvel, 1)):
            places = [self._dof[axis][column] for axis in "xyz"]
            values[places] = across @ values[places]
        self._world_T_person = poses.transform(turned, self._world_T_person[:3, 3])

    def hold_fast(self) -> None:
        """Keep what is pinched where it is between the fingers' ends."""
        self._centre_m = self._off_centre_m()

    def let_loose(self) -> None:
        """Forget how something was held between the fingers."""
        self._centre_m = None

    def move_to(self, point: Array) -> None:
        """Have the spring's other end go to a world point."""
        self._goal = np.asarray(point, dtype=np.float64)

    def room_m(self, point: Array, roll_rad: float, gap_m: float) -> float:
        """Distance of the pads to the robot, 5 cm at most, if the hand were somewhere else.

        Args:
            point: Where the middle of the hand would be, in the world, shape (3,).
            roll_rad: Its turn.
            gap_m: From there to each pad.
        """
        model, data = self._physics.model, self._elsewhere
        data.qpos[:] = self._physics.data.qpos
        own = self._world_T_person[:3, :3].T @ (np.asarray(point) - self._rest)
        for axis, value in zip("xyz", own, strict=True):
            data.qpos[self._dof[axis][0]] = value
        data.qpos[self._dof["roll"][0]] = roll_rad
        for axis in ("upper", "lower"):
            data.qpos[self._dof[axis][0]] = gap_m
        mujoco.mj_kinematics(model, data)
        room_m = _FAR_M
        for pad in self._pads:
            reach = np.linalg.norm(data.geom_xpos[self._robot] - data.geom_xpos[pad], axis=1)
            near = reach - model.geom_rbound[self._robot] - model.geom_rbound[pad] < room_m
            for other in np.array(self._robot)[near].tolist():
                room_m = min(room_m, mujoco.mj_geomDistance(model, data, pad, other, _FAR_M, None))
        return room_m

    def tick(self, period_s: float) -> None:
        """Apply the forces of the next period."""
        way = self._goal - self._anchor
        far = float(np.linalg.norm(way))
        self._anchor = (
            self._goal.copy()
            if far <= SPEED_M_S * period_s
            else self._anchor + way * (SPEED_M_S * period_s / far)
        )
        force = STIFFNESS_N_M * (self._anchor - self.place())
        strength = float(np.linalg.norm(force))
        force *= min(1.0, self.force_n / max(strength, 1e-9))
        data = self._physics.data
        own = self._world_T_person[:3, :3].T @ force
        for axis, value in zip("xyz", own, strict=True):
            data.qfrc_applied[self._dof[axis][1]] = value
        qpos, dof = self._dof["roll"]
        data.qfrc_applied[dof] = ROLL_STIFFNESS_NM * (self.roll_rad - data.qpos[qpos])
        centre_m = self._centre_m if self.pinching else None
        pushed_n = 0.0 if centre_m is None else _CENTRE_STIFFNESS_N_M * (centre_m - self._off_centre_m())
        for axis, sign in (("upper", 1.0), ("lower", -1.0)):
            qpos, dof = self._dof[axis]
            gap = _GAP_STIFFNESS_N_M * (self.open_m - float(data.qpos[qpos]))
            pinch = sign * pushed_n - PINCH_N
            data.qfrc_applied[dof] = pinch if self.pinching else float(np.clip(gap, -PINCH_N, PINCH_N))

    def _off_centre_m(self) -> float:
        """How far the middle between the pads is from the middle of the hand, to the upper one's side."""
        qpos = self._physics.data.qpos
        return 0.5 * float(qpos[self._dof["upper"][0]] - qpos[self._dof["lower"][0]])

    def _addresses(self, joint: str) -> tuple[int, int]:
        model = self._physics.model
        index = int(mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, joint))
        return int(model.jnt_qposadr[index]), int(model.jnt_dofadr[index])
