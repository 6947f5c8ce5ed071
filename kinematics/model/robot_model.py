"""One object for what planner, checker, balance and estimation need to know of a robot's body."""

from __future__ import annotations

import copy
from collections.abc import Hashable, Mapping, Sequence
from functools import cached_property, lru_cache
from typing import Any

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.errors import ModelError, UnknownNameError
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.model.derived import Derivable
from kinematics.model.judged_bodies import require_hinges, require_judged_solids, require_no_capsules
from kinematics.model.robot_description import Hand, RobotDescription


class RobotModel(Derivable):
    """A robot's kinematic tree, limits and collision geometry.

    Attributes:
        description: The data it was built from.
        pin: The Pinocchio model, free-flyer first, grippers fixed open. A welded base has the
            free-flyer too, so that configurations of all robots have one form; it stays at ``mount``.
        joints: Body joints, the order of ``q[7:]`` and ``v[6:]``.
        lower_rad, upper_rad, velocity, acceleration, jerk, effort: Limits, shape (n,) each, in
            that order, SI units.

    Raises:
        ModelError: The URDF's joints are not those of the description, or it has joints or collision solids
            that the trajectory checker cannot judge.
    """

    def __init__(self, description: RobotDescription) -> None:
        self.description = description
        self.pin = pin.buildModelFromXML(description.planning_urdf, pin.JointModelFreeFlyer())
        self.joints = tuple(self.pin.names)[2:]
        if self.joints != description.joints:
            raise ModelError(f"{description.name}: URDF joints {self.joints} are not those described")
        require_hinges(description.name, self.pin)
        require_no_capsules(description.name, description.planning_urdf)
        limits = [description.limits[name] for name in self.joints]
        self.lower_rad = np.array([limit.position[0] for limit in limits])
        self.upper_rad = np.array([limit.position[1] for limit in limits])
        self.velocity = np.array([limit.velocity for limit in limits])
        self.acceleration = np.array([limit.acceleration for limit in limits])
        self.jerk = np.array([limit.jerk for limit in limits])
        self.effort = np.array([limit.effort for limit in limits])
        self._index = {name: i for i, name in enumerate(self.joints)}
        self._data = self.pin.createData()
        self._frame_ids: dict[str, int] = {}
        self._derived: dict[Hashable, Any] = {}

    @property
    def nq(self) -> int:
        """Size of a configuration: 7 for the base and one a joint."""
        return int(self.pin.nq)

    @property
    def nv(self) -> int:
        """Size of a velocity: 6 for the base and one a joint."""
        return int(self.pin.nv)

    @cached_property
    def mass_kg(self) -> float:
        """Mass of the whole robot."""
        return float(pin.computeTotalMass(self.pin))

    @cached_property
    def moved_links(self) -> Mapping[str, str]:
        """The link that each joint moves, by the joint's name; its origin is on the joint's axis."""
        links: dict[str, str] = {}
        for frame in self.pin.frames:
            if frame.type == pin.FrameType.BODY:
                links.setdefault(str(self.pin.names[frame.parentJoint]), str(frame.name))
        return links

    @cached_property
    def free_joints(self) -> tuple[str, ...]:
        """Joints that are in no leg, in the model's order: what a robot that stands moves freely."""
        groups = self.description.groups
        in_legs = {joint for name, members in groups.items() if name.endswith("_leg") for joint in members}
        return tuple(joint for joint in self.joints if joint not in in_legs)

    def carrying(self, masses_kg: Mapping[Hand, float]) -> RobotModel:
        """The same robot with point masses at its TCPs: its CoM, its mass and its dynamics are those of both.

        Args:
            masses_kg: What hangs on each hand; hands left out are empty.
        """
        frames = self.description.tcp_frames
        return self.with_point_masses(
            [(frames[hand], mass_kg, np.zeros(3)) for hand, mass_kg in masses_kg.items()]
        )

    def with_point_masses(self, loads: Sequence[tuple[str, float, NDArray[np.float64]]]) -> RobotModel:
        """The same robot with point masses: its CoM, its mass and its dynamics are those of both.

        Args:
            loads: Of each, the frame that carries it, its mass in kg and its place in that frame, shape (3,).

        Raises:
            UnknownNameError: There is no such frame.
        """
        if not loads:
            return self
        loaded = copy.copy(self)
        loaded.pin = pin.Model(self.pin)
        for name, mass_kg, point_m in loads:
            frame = self.pin.frames[self.frame_id(name)]
            load = pin.Inertia(mass_kg, frame.placement.act(point_m), np.zeros((3, 3)))
            loaded.pin.inertias[frame.parentJoint] += load
        loaded._data = loaded.pin.createData()
        loaded._derived = {}
        vars(loaded).pop("mass_kg", None)
        return loaded

    def twin(self) -> RobotModel:
        """The same robot, of which nothing was made yet."""
        twin = copy.copy(self)
        twin._data = twin.pin.createData()
        twin._derived = {}
        return twin

    def joint_index(self, name: str) -> int:
        """Index of a joint in ``q[7:]``.

        Raises:
            UnknownNameError: There is no such joint.
        """
        try:
            return self._index[name]
        except KeyError:
            raise UnknownNameError("joint", name, self.joints) from None

    def indices(self, names: Sequence[str]) -> NDArray[np.intp]:
        """Indices of several joints in ``q[7:]``, shape (len(names),)."""
        return np.array([self.joint_index(name) for name in names], dtype=np.intp)

    def group(self, name: str) -> NDArray[np.intp]:
        """Indices in ``q[7:]`` of the joints of a group.

        Raises:
            UnknownNameError: There is no such group.
        """
        groups = self.description.groups
        if name not in groups:
            raise UnknownNameError("group", name, list(groups))
        return self.indices(groups[name])

    def frame_id(self, name: str) -> int:
        """Pinocchio's index of a frame.

        Raises:
            UnknownNameError: There is no such frame.
        """
        known = self._frame_ids.get(name)
        if known is None:
            if not self.pin.existFrame(name):
                raise UnknownNameError("frame", name, [frame.name for frame in self.pin.frames])
            known = self._frame_ids[name] = int(self.pin.getFrameId(name))
        return known

    def configuration(self, joints: Mapping[str, float], world_T_base: Transform) -> Array:
        """Make ``q`` from a base pose and joint positions; joints left out are at home."""
        home = self.description.home
        values = [joints.get(name, home.get(name, 0.0)) for name in self.joints]
        quaternion = poses.quaternion_from_rotation(world_T_base[:3, :3])
        return np.concatenate([world_T_base[:3, 3], quaternion, values])

    @cached_property
    def mount(self) -> Transform:
        """``odom_T_base`` of a welded base, shape (4, 4)."""
        roll, pitch, yaw = self.description.mount_rpy_rad
        turn = poses.rotation_z(yaw) @ poses.rotation_y(pitch) @ poses.rotation_x(roll)
        return poses.transform(turn, self.description.mount_xyz_m)

    def on_the_floor(self, joints: Mapping[str, float]) -> Array:
        """Configuration with the soles flat on z = 0, the point between them at the origin, x ahead.

        A welded base is where it is mounted.
        """
        if self.description.welded:
            return self.configuration(joints, self.mount)
        q = self.configuration(joints, np.eye(4))
        soles = [self.frame_pose(q, sole.frame) for sole in self.description.soles]
        middle = poses.interpolate(soles[0], soles[1], 0.5)
        heading = poses.transform(poses.rotation_z(poses.yaw_of(middle[:3, :3])), middle[:3, 3])
        return self.configuration(joints, poses.inverse(heading))

    @cached_property
    def q_home(self) -> Array:
        """The home posture, standing at the origin or where it is mounted, shape (nq,)."""
        return self.on_the_floor({})

    @cached_property
    def imu_up(self) -> Array:
        """Which way is up in the IMU's frame while the robot is at home, shape (3,); z without an IMU."""
        imu = self.description.imu
        return np.array([0.0, 0.0, 1.0]) if imu is None else self.frame_pose(self.q_home, imu)[2, :3].copy()

    def frame_pose(self, q: Array, frame: str) -> Transform:
        """``world_T_frame`` at a configuration."""
        frame_id = self.frame_id(frame)
        pin.forwardKinematics(self.pin, self._data, q)
        return np.array(pin.updateFramePlacement(self.pin, self._data, frame_id).homogeneous)

    def frame_jacobian(self, q: Array, frame: str) -> Array:
        """How a frame moves with the joints: m and rad per m and rad, world axes, shape (6, nv)."""
        kind = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        return np.array(pin.computeFrameJacobian(self.pin, self._data, q, self.frame_id(frame), kind))

    def frame_poses(self, q: Array, frames: Sequence[str]) -> list[Transform]:
        """Several frames' poses from one pass of forward kinematics."""
        ids = [self.frame_id(frame) for frame in frames]
        pin.framesForwardKinematics(self.pin, self._data, q)
        return [np.array(self._data.oMf[i].homogeneous) for i in ids]

    def com(self, q: Array) -> Array:
        """Centre of mass in the world, shape (3,)."""
        return np.array(pin.centerOfMass(self.pin, self._data, q, False))

    def geometry(self) -> pin.GeometryModel:
        """A fresh collision model: one convex hull or primitive a link, all pairs but the disabled ones.

        Each call builds its own, so that planner and checker share no state.
        """
        return self._pristine_geometry.copy()

    @cached_property
    def _pristine_geometry(self) -> pin.GeometryModel:
        description = self.description
        disabled = frozenset(frozenset(pair) for pair in description.disabled_collisions)
        return _collision_model(description.name, description.planning_urdf, disabled)

    def link_of(self, item: pin.GeometryObject) -> str:
        """Name of the link that a geometry belongs to."""
        return str(self.pin.frames[item.parentFrame].name)


@lru_cache(maxsize=8)
def _collision_model(name: str, urdf: str, disabled: frozenset[frozenset[str]]) -> pin.GeometryModel:
    """Hulls and pairs of a robot, read once: its meshes take a tenth of a second.

    Args:
        name: Of the robot.
        urdf: Its planning URDF.
        disabled: Pairs of links that are not judged.
    """
    model = pin.buildModelFromXML(urdf, pin.JointModelFreeFlyer())
    geometry = pin.buildGeomFromUrdfString(model, urdf, pin.GeometryType.COLLISION)
    for item in geometry.geometryObjects:
        if isinstance(item.geometry, coal.BVHModelBase):
            # not buildConvexRepresentation: it keeps concave meshes as they are, and distances are then
            # too large, by up to 13 cm for the grippers' hollow parts
            item.geometry.buildConvexHull(True, "Qt")
            item.geometry = item.geometry.convex
    require_judged_solids(name, geometry)
    for item in geometry.geometryObjects:
        item.geometry.computeLocalAABB()  # and the ball about it
    link = [str(model.frames[item.parentFrame].name) for item in geometry.geometryObjects]
    for i in range(len(link)):
        for j in range(i + 1, len(link)):
            if link[i] != link[j] and frozenset((link[i], link[j])) not in disabled:
                geometry.addCollisionPair(pin.CollisionPair(i, j))
    return geometry
