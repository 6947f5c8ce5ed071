"""Where the parts of one arm are, at a configuration and a little beside it along each of some joints.

The places beside it follow from the joints' axes to first order: one pass over the robot serves a whole
numeric Jacobian, and what is asked of an arm is written once, for rows of places. Where an arm points is told
here too.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.model.robot_build import RobotBuild, robot_build
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel

# A joint that is turned farther from the vertical than this, as a cosine, turns no trunk.
_VERTICAL = 0.99
# From shoulder to TCP of the arm that the measures of gestures were found with, TALOS's.
_USUAL_ARM_M = 0.739


@dataclass(frozen=True, slots=True)
class ArmFrames:
    """Where the parts of one arm, and the chest, are in the world at n configurations.

    Attributes:
        shoulder_m, elbow_m, tcp_m: Of the arm's second and fourth joint, and of the TCP, shape (n, 3).
        world_R_tcp: How the hand is turned, shape (n, 3, 3).
        chest_m: Where the chest is, shape (n, 3).
        heading_rad: Where it faces: its turn about the vertical, shape (n,).
    """

    shoulder_m: Array
    elbow_m: Array
    tcp_m: Array
    world_R_tcp: Array
    chest_m: Array
    heading_rad: Array

    def world_T_tcp(self) -> poses.Transform:
        """Pose of the hand in the first row, shape (4, 4)."""
        return poses.transform(self.world_R_tcp[0], self.tcp_m[0])

    def bearing_rad(self, point: Array) -> Array:
        """Direction of a point from the chest, shape (n,)."""
        return np.asarray(np.arctan2(point[1] - self.chest_m[:, 1], point[0] - self.chest_m[:, 0]))

    def turned_past_rad(self, point: Array) -> Array:
        """How far the chest is turned past a point, -pi to pi, shape (n,)."""
        angle = self.heading_rad - self.bearing_rad(point)
        return np.asarray((angle + np.pi) % (2.0 * np.pi) - np.pi)

    def length_m(self) -> Array:
        """From shoulder to elbow to TCP, shape (n,)."""
        upper, lower = self.elbow_m - self.shoulder_m, self.tcp_m - self.elbow_m
        return np.asarray(np.linalg.norm(upper, axis=1) + np.linalg.norm(lower, axis=1))


class ArmKinematics:
    """Places one arm of a robot. Holds working memory: one thread at a time.

    Args:
        model: The robot.
        hand: Whose arm.
        trunk: Whether the trunk's turn counts among its joints.

    Attributes:
        turning: Joints of the torso that turn the chest about the vertical at home, if they count.
        joints: Those of the arm, then these: what ``around`` moves.
        columns: Where they are in a configuration, shape (k,).
    """

    def __init__(self, model: RobotModel, hand: Hand, trunk: bool) -> None:
        groups, tree = model.description.groups, model.pin
        arm = groups[f"{hand}_arm"]
        self._pin, self._data = tree, tree.createData()
        torso = groups["torso"] if trunk else ()
        self.turning = tuple(joint for joint in torso if self._is_vertical(model, joint))
        self.joints = (*arm, *self.turning)
        self.columns = 7 + model.indices(self.joints)
        self._tcp = model.frame_id(model.description.tcp_frames[hand])
        shoulder, elbow = tree.getJointId(arm[1]), tree.getJointId(arm[3])
        wrist, chest = tree.frames[self._tcp].parentJoint, int(tree.parents[tree.getJointId(arm[0])])
        self._shoulder, self._elbow, self._chest = shoulder, elbow, chest
        moved_by = [set(tree.supports[part]) for part in (shoulder, elbow, wrist, chest)]
        ids = [tree.getJointId(joint) for joint in self.joints]
        self._moves = np.array([[part in moved for moved in moved_by] for part in ids], np.float64)
        pin.forwardKinematics(tree, self._data, model.q_home)
        base_R_world = poses.rotation_from_quaternion(model.q_home[3:7]).T
        # what is ahead at home, as the chest sees it
        self._ahead = np.array((base_R_world @ self._data.oMi[chest].rotation)[0])

    def at(self, q: Array) -> ArmFrames:
        """Places at one configuration, shape (nq,): one row."""
        pin.forwardKinematics(self._pin, self._data, q)
        places_m, world_R_tcp, ahead = self._own()
        return _frames(places_m[None], world_R_tcp[None], ahead[None])

    def around(self, q: Array, step_rad: float) -> ArmFrames:
        """Places at a configuration, and with each of ``joints`` farther by a small step: 1 + k rows."""
        pin.computeJointJacobians(self._pin, self._data, q)
        places_m, world_R_tcp, ahead = self._own()
        twist = self._data.J[:, self.columns - 1] * step_rad
        turn = np.zeros((len(self.joints), 3, 3))
        turn[:, 2, 1], turn[:, 0, 2], turn[:, 1, 0] = twist[3:]
        turn[:, 1, 2], turn[:, 2, 0], turn[:, 0, 1] = -twist[3:]
        shifts_m = (twist[:3].T[:, None, :] + places_m @ turn.transpose(0, 2, 1)) * self._moves[:, :, None]
        turned = (turn @ world_R_tcp) * self._moves[:, 2, None, None]
        swung = (turn @ ahead) * self._moves[:, 3, None]
        return _frames(
            np.concatenate([places_m[None], places_m + shifts_m]),
            np.concatenate([world_R_tcp[None], world_R_tcp + turned]),
            np.concatenate([ahead[None], ahead + swung]),
        )

    def _own(self) -> tuple[Array, Array, Array]:
        """Shoulder, elbow, TCP and chest, shape (4, 3); the hand's rotation; what is ahead of the chest."""
        placed = self._data.oMi
        tcp = pin.updateFramePlacement(self._pin, self._data, self._tcp)
        chest = placed[self._chest]
        places_m = np.array(
            [
                placed[self._shoulder].translation,
                placed[self._elbow].translation,
                tcp.translation,
                chest.translation,
            ]
        )
        return places_m, np.array(tcp.rotation), chest.rotation @ self._ahead

    def _is_vertical(self, model: RobotModel, joint: str) -> bool:
        """Whether a joint turns about the vertical at home."""
        axes = pin.computeJointJacobians(self._pin, self._data, model.q_home)[3:]
        return bool(abs(axes[2, 6 + model.joint_index(joint)]) > _VERTICAL)


def _frames(places_m: Array, world_R_tcp: Array, ahead: Array) -> ArmFrames:
    """From places, shape (n, 4, 3), rotations, and directions, shape (n, 3)."""
    shoulder_m, elbow_m, tcp_m, chest_m = places_m.transpose(1, 0, 2)
    heading_rad = np.arctan2(ahead[:, 1], ahead[:, 0])
    return ArmFrames(shoulder_m, elbow_m, tcp_m, world_R_tcp, chest_m, heading_rad)


def arm_kinematics(model: RobotModel, hand: Hand, trunk: bool = True) -> ArmKinematics:
    """Those of a model's arm, made once for each robot."""
    return robot_build(model).derived(_made, hand, trunk)


def arm_share(model: RobotModel, hand: Hand) -> float:
    """How long an arm is beside the one that gestures were measured with, as a share of it; at most 1."""
    length_m = float(arm_kinematics(model, hand).at(model.q_home).length_m()[0])
    return min(1.0, length_m / _USUAL_ARM_M)


def _made(build: RobotBuild, hand: Hand, trunk: bool) -> ArmKinematics:
    return ArmKinematics(build.model, hand, trunk)


def beside_ray_m(start: Array, through: Array, point: Array) -> float:
    """Distance of a point from the ray from ``start`` through another point; infinite behind its start.

    Args:
        start, through, point: World points, shape (3,) each.
    """
    way = (through - start) / np.linalg.norm(through - start)
    along = float((point - start) @ way)
    return float(np.linalg.norm(point - start - along * way)) if along > 0.0 else np.inf


def link_moved_by(model: RobotModel, joint: str) -> str:
    """Name of the link that a joint moves; its origin is on the joint's axis."""
    return model.moved_links[joint]


def elbow_frame(model: RobotModel, hand: Hand) -> str:
    """The link that an arm's fourth joint moves: the forearm begins at its origin."""
    return link_moved_by(model, model.description.groups[f"{hand}_arm"][3])


def pointing_error_m(model: RobotModel, q: Array, hand: Hand, target: Array) -> float:
    """Distance of a world point, shape (3,), from the line through an arm's forearm and hand."""
    elbow, tcp = model.frame_poses(q, [elbow_frame(model, hand), model.description.tcp_frames[hand]])
    return beside_ray_m(elbow[:3, 3], tcp[:3, 3], target)
