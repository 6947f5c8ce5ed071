"""A compiled world: MuJoCo's model and data with the look-up tables that the rest needs."""

from __future__ import annotations

import mujoco
import numpy as np
from numpy.typing import NDArray

from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.model.robot_description import RobotDescription
from robots.errors import DescriptionError, SceneError
from robots.interface.hardware import RobotData
from robots.scenes import furniture
from robots.scenes.moving_parts import moving_parts
from robots.scenes.scene_description import SceneDescription
from robots.simulated.body.body_model import ROOT_JOINT, body, compiled_spec, pad_name, robot_spec
from robots.simulated.body.control_model import control_name
from robots.simulated.body.furniture_model import FurnitureForces
from robots.simulated.body.geom_roles import Role, in_scene, in_simulator
from robots.simulated.body.mesh_model import part_names
from robots.simulated.body.scene_model import FLOOR, add_scene, joint_name
from robots.simulated.frugal_memory import give_back

TIMESTEP_S = 0.001
IMPEDANCE_RATIO = 100.0
"""Friction stiffness over normal stiffness; 1 lets a held cup creep by 12 mm in 10 s, 100 by 0.1 mm."""
SETTLED_DEPTH_M = 0.00027
"""How deep 90 kg press the soles into the soft floor: begin there, or the robot drops onto it."""


class Physics:
    """The world as MuJoCo holds it. Internal to ``robots.simulated``.

    Attributes:
        description, hardware, scene: What it was built from.
        furniture: What doors and drawers do by themselves.
        model, data: MuJoCo's.
        geom_role: ``Role`` of each geom, shape (ngeom,).
        geom_label: Name of each geom for people: link, "table/top", object or person.

    Raises:
        SceneError: The robot would start in contact with something, or MuJoCo refuses the scene.
        DescriptionError: The URDF and the description disagree.
    """

    def __init__(self, robot: RobotData, scene: SceneDescription, *, drawn: bool = True) -> None:
        """Build it.

        Args:
            robot: Who stands in it.
            scene: What is around.
            drawn: Whether pictures may be taken in it.

        Raises:
            SceneError: The simulator refuses the scene.
        """
        description = robot.description
        self.description, self.hardware, self.scene = description, robot.hardware, scene
        spec = robot_spec(robot, drawn=drawn)
        _set_options(spec, scene)
        if description.welded:
            _mount(spec, description, scene)
        add_scene(spec, scene, description)
        try:
            self.model = compiled_spec(spec)
        except ValueError as refused:
            raise SceneError(scene.name, "scene", f"the simulator refuses it: {refused}") from refused
        del spec
        give_back()
        self.data = mujoco.MjData(self.model)
        self._fresh_time_s = -1.0
        self.geom_role, self.geom_label = self._label_geoms()
        self.base_body = self.body_id(description.base_link)
        self.object_geoms = {
            item.name: np.array([self.scene_geom_id(part) for part in part_names(item)])
            for item in scene.objects
        }
        self.object_body = {item.name: self.body_id(in_simulator(item.name)) for item in scene.objects}
        self.object_qpos = {item.name: self._qpos_address(joint_name(item.name)) for item in scene.objects}
        self.object_qvel = {item.name: self._dof_address(joint_name(item.name)) for item in scene.objects}
        self.sole_body = [self.body_id(sole.frame) for sole in description.soles]
        self.joint_qpos = np.array([self._qpos_address(name) for name in description.actuated])
        self.joint_qvel = np.array([self._dof_address(name) for name in description.actuated])
        self.furniture = FurnitureForces(self.model, self.data, scene)
        self._stand_up()

    def geom_id(self, name: str) -> int:
        """MuJoCo's index of a geom, by the simulator's name."""
        return self._id(mujoco.mjtObj.mjOBJ_GEOM, name)

    def scene_geom_id(self, name: str) -> int:
        """MuJoCo's index of a geom of the scene: an object, "table/top"."""
        return self.geom_id(in_simulator(name))

    def body_id(self, name: str) -> int:
        """MuJoCo's index of a body."""
        return self._id(mujoco.mjtObj.mjOBJ_BODY, name)

    def pair_id(self, name: str) -> int:
        """MuJoCo's index of a contact pair."""
        return self._id(mujoco.mjtObj.mjOBJ_PAIR, name)

    def _id(self, kind: mujoco.mjtObj, name: str) -> int:
        found = int(mujoco.mj_name2id(self.model, kind, name))
        if found < 0:
            raise DescriptionError(f"the simulated world has no {name!r}")
        return found

    def refresh(self) -> None:
        """Bring body poses and the CoM up to the present joint positions.

        After a step MuJoCo's poses are those of the step's beginning. What this computes anew is
        computed by the next step as well, so looking does not change the course of things.
        """
        if self.data.time != self._fresh_time_s:
            self.refresh_after_change()

    def refresh_after_change(self) -> None:
        """The same after positions were set by hand."""
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_comPos(self.model, self.data)
        self._fresh_time_s = float(self.data.time)

    def body_pose(self, body: int) -> Transform:
        """``world_T_body``; call ``refresh`` first."""
        return poses.transform(self.data.xmat[body].reshape(3, 3), self.data.xpos[body])

    def _qpos_address(self, joint: str) -> int:
        return int(self.model.jnt_qposadr[self._id(mujoco.mjtObj.mjOBJ_JOINT, joint)])

    def _dof_address(self, joint: str) -> int:
        return int(self.model.jnt_dofadr[self._id(mujoco.mjtObj.mjOBJ_JOINT, joint)])

    def _label_geoms(self) -> tuple[NDArray[np.int64], list[str]]:
        description, scene, model = self.description, self.scene, self.model
        role = np.full(model.ngeom, Role.NONE, dtype=np.int64)
        label = [""] * model.ngeom
        fingers = frozenset[str]().union(*(item.finger_links for item in description.grippers.values()))
        link_of_sole = {sole.frame: sole.link for sole in description.soles}
        solids = {solid.name for piece in scene.furniture for solid in furniture.solids(piece)}
        pads = {pad_name(link) for item in description.grippers.values() for link in item.pad_links}
        items = {item.name for item in scene.objects}
        people = {person.name for person in scene.people}
        moving = {
            solid.name: Role.HANDLE if solid.grasped else Role.FURNITURE
            for piece in scene.furniture
            for part in moving_parts(piece)
            for solid in part.solids
        }
        moving |= {
            control_name(piece, control): Role.HANDLE
            for piece in scene.furniture
            for control in piece.controls
        }
        for i in range(model.ngeom):
            geom, owner = model.geom(i).name, model.body(model.geom_bodyid[i]).name
            solid, thing = in_scene(geom), in_scene(owner)
            if geom == FLOOR:
                role[i], label[i] = Role.FLOOR, FLOOR
            elif solid in solids:
                role[i], label[i] = Role.FURNITURE, solid
            elif solid in moving:
                role[i], label[i] = moving[solid], solid
            elif thing in items:
                role[i], label[i] = Role.OBJECT, thing
            elif thing is not None and thing.split("/", 1)[0] in people:  # the hand is a body of its own
                role[i], label[i] = (Role.PERSON if model.geom_contype[i] else Role.NONE), thing
            else:
                label[i] = link_of_sole.get(owner, owner)
                if model.geom_contype[i] or model.geom_conaffinity[i]:
                    role[i] = Role.PAD if geom in pads else Role.FINGER if owner in fingers else Role.BODY
        return role, label

    def _stand_up(self) -> None:
        """Put the robot at its start in its home posture; refuse a start inside things."""
        description, data = self.description, self.data
        data.qpos[self.joint_qpos] = [description.home[name] for name in description.actuated]
        self._let_fingers_follow()
        if not description.welded:
            self._put_on_soles()
        mujoco.mj_forward(self.model, data)
        self._fresh_time_s = float(data.time)
        for first, second in data.contact.geom[: data.ncon]:
            roles = {int(self.geom_role[first]), int(self.geom_role[second])}
            mine = roles & {Role.BODY, Role.FINGER, Role.PAD}
            other = roles & {Role.FURNITURE, Role.OBJECT, Role.PERSON}
            if mine and other:
                touching = f"{self.geom_label[first]!r} and {self.geom_label[second]!r}"
                raise SceneError(self.scene.name, "robot_start", f"the robot starts in contact: {touching}")

    def _let_fingers_follow(self) -> None:
        """Put joints that mimic others where those have them."""
        model, data = self.model, self.data
        for constraint in range(model.neq):
            if model.eq_type[constraint] == mujoco.mjtEq.mjEQ_JOINT:
                follower, driver = model.eq_obj1id[constraint], model.eq_obj2id[constraint]
                at = data.qpos[model.jnt_qposadr[driver]]
                coefficients = model.eq_data[constraint, :5]
                data.qpos[model.jnt_qposadr[follower]] = np.polynomial.polynomial.polyval(at, coefficients)

    def _put_on_soles(self) -> None:
        """Move the base so that the soles stand at the start, pressed into the floor as they settle."""
        data, start = self.data, self.scene.robot_start
        base = self._qpos_address(ROOT_JOINT)
        data.qpos[base : base + 7] = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)
        mujoco.mj_kinematics(self.model, data)
        soles = [self.body_pose(item) for item in self.sole_body]
        middle = poses.interpolate(soles[0], soles[-1], 0.5)
        base_T_stance = poses.transform(poses.rotation_z(poses.yaw_of(middle[:3, :3])), middle[:3, 3])
        world_T_stance = poses.transform(poses.rotation_z(start.yaw_rad), (start.x_m, start.y_m, 0.0))
        world_T_base = world_T_stance @ poses.inverse(base_T_stance)
        x, y, z, w = poses.quaternion_from_rotation(world_T_base[:3, :3])
        data.qpos[base : base + 7] = (*world_T_base[:3, 3], w, x, y, z)
        data.qpos[base + 2] -= SETTLED_DEPTH_M


def _mount(spec: mujoco.MjSpec, description: RobotDescription, scene: SceneDescription) -> None:
    """Bolt the base to the world where the robot starts."""
    start, (roll, pitch, yaw) = scene.robot_start, description.mount_rpy_rad
    turn = poses.rotation_z(yaw) @ poses.rotation_y(pitch) @ poses.rotation_x(roll)
    world_T_start = poses.transform(poses.rotation_z(start.yaw_rad), (start.x_m, start.y_m, 0.0))
    world_T_base = world_T_start @ poses.transform(turn, description.mount_xyz_m)
    x, y, z, w = poses.quaternion_from_rotation(world_T_base[:3, :3])
    base = body(spec, description.base_link)
    base.pos, base.quat = world_T_base[:3, 3], [w, x, y, z]


def _set_options(spec: mujoco.MjSpec, scene: SceneDescription) -> None:
    option = spec.option
    option.timestep = TIMESTEP_S
    option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    option.impratio = IMPEDANCE_RATIO
    # One solve for all contacts: splitting so few of them into islands costs a tenth of a step. Things of
    # parts have many, and beside a robot's weight one solve ends before theirs are settled: they creep.
    if all(item.model is None for item in scene.objects):
        option.disableflags = int(mujoco.mjtDisableBit.mjDSBL_ISLAND)
    spec.visual.global_.offwidth, spec.visual.global_.offheight = 1920, 1440
