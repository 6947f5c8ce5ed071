"""A robot's description as a MuJoCo body: URDF, soles, finger pads, actuators, sensors."""

from __future__ import annotations

import copy
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import mujoco

from kinematics.geometry.mesh_hull import hull_corners
from kinematics.model.robot_description import GripperDescription, RobotDescription, SoleDescription
from robots.errors import DescriptionError
from robots.interface.hardware import RobotData
from robots.simulated.body.geom_roles import (
    CONAFFINITY,
    CONTYPE,
    DRAWN_GROUP,
    FINGER_DRAWN_GROUP,
    HULL_GROUP,
    UNSEEN_GROUP,
    Role,
)
from robots.simulated.body.mended_masses import mend_masses

ROOT_JOINT = "root"
GRIPPER_DAMPING = 0.02
"""Nm s/rad. The URDF's friction of the gripper equals its effort and would jam it; damping only."""
HULL_FRICTION = 0.1
"""Of the robot's shell with anything: painted plastic and aluminium, and too slippery to hold by."""
SOLE_FRICTION = 0.9
HULL_PRIORITY, SOLE_PRIORITY = 1, 2
"""MuJoCo takes the friction of the geom with the higher priority."""
PAD_SOLREF = (0.01, 1.0)
PAD_SOLIMP = (0.9, 0.97, 0.002, 0.5, 2.0)
"""Contact stiffness of rubber pads: measured to hold 0.1 to 1.0 kg with 0.1 mm of creep in 10 s."""
PATCH_RADIUS_M = 0.02
"""Torsional friction of a contact is its friction times this: the size of a soft pad's contact patch."""
PAD_SOLREF_FRICTION = (0.002, 1.0)
"""MuJoCo's constraints leave out that a turning hand turns their directions, so that what is held slides
outwards at the centripetal acceleration times half this time: 5 mm/s for 1 m/s^2 with the 0.01 s of normal
forces. Two physics steps are the least."""
MIMIC_SOLREF = (0.005, 1.0)
MIMIC_SOLIMP = (0.95, 0.99, 0.001, 0.5, 2.0)
IMU_SENSORS = {"gyro": mujoco.mjtSensor.mjSENS_GYRO, "accelerometer": mujoco.mjtSensor.mjSENS_ACCELEROMETER}
"""In the order in which they are read."""
_COLLADA, _STL = ".dae", ".stl"
_STL_HEAD = 84
"""Bytes of a binary STL before its triangles; the last four say how many these are, of 50 bytes each."""
_FLAT = re.compile(r"mesh volume is too small: (\S+)")
"""What the simulator says of a drawing that is a sheet."""


def robot_spec(robot: RobotData, *, drawn: bool = True, collides: bool = True) -> mujoco.MjSpec:
    """Build the robot alone, with position servos and sensors: in the air, or welded to the world.

    Args:
        robot: Its data.
        drawn: Whether pictures may be taken of it: meshes that are for these alone are the most of it.
        collides: Whether it is for physics; otherwise the hulls of its links are left out.

    Raises:
        DescriptionError: The URDF lacks a link or joint that the description names.
    """
    description = robot.description
    urdf = ElementTree.fromstring(description.urdf)
    options = ElementTree.Element("mujoco")
    ElementTree.SubElement(
        options,
        "compiler",
        strippath="false",  # two meshes share a file name
        meshdir=description.mesh_dir,
        discardvisual="false",
        fusestatic="false",  # keeps the frames of camera, soles and TCPs
        balanceinertia="true",
    )
    urdf.insert(0, options)
    meshes = Path(description.mesh_dir)
    _draw_by_hulls(urdf, meshes)
    mend_masses(urdf)
    spec = mujoco.MjSpec.from_string(ElementTree.tostring(urdf, encoding="unicode"))
    _read_hulls(spec, meshes)
    if not description.welded:
        body(spec, description.base_link).add_freejoint(name=ROOT_JOINT)
    _assign_roles(spec, description)
    if not drawn:
        _leave_out(spec, DRAWN_GROUP)  # drawn fingers stay, since they stand in lines of sight
    if not collides:
        _leave_out(spec, HULL_GROUP)
    _tune_joints(spec, description)
    for sole in description.soles:
        _add_sole(spec, sole)
    for gripper in description.grippers.values():
        _add_pads(spec, gripper)
    _exclude_pairs(spec, description)
    _add_actuators(spec, robot)
    _add_sensors(spec, description)
    return spec


def _draw_by_hulls(urdf: ElementTree.Element, meshes: Path) -> None:
    """Draw links whose drawings MuJoCo cannot read as what they collide with."""
    for link in urdf.findall("link"):
        unread = [item for item in link.findall("visual") if is_unread(_drawing(item), meshes)]
        if unread:
            for item in unread:
                link.remove(item)
            for hull in link.findall("collision"):
                drawn = ElementTree.SubElement(link, "visual")
                drawn.extend(copy.deepcopy(list(hull)))


def _read_hulls(spec: mujoco.MjSpec, meshes: Path) -> None:
    """Give the meshes that MuJoCo cannot read the hulls that planner and checker go by."""
    for mesh in spec.meshes:
        if is_unread(mesh.file, meshes):
            mesh.uservert = hull_corners(str(meshes / mesh.file)).ravel()
            mesh.file = ""
            mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX


def _drawing(visual: ElementTree.Element) -> str:
    """The file of a link's drawing; empty for a simple solid."""
    mesh = visual.find("geometry/mesh")
    return "" if mesh is None else mesh.get("filename", "")


def is_unread(file: str, meshes: Path) -> bool:
    """Whether a mesh is one that MuJoCo does not read: COLLADA, or an STL that is written as text."""
    ending = Path(file).suffix.lower()
    if ending != _STL:
        return ending == _COLLADA
    path = meshes / file
    if not path.is_file():
        return False
    with path.open("rb") as opened:
        head = opened.read(_STL_HEAD)
    triangles = int.from_bytes(head[-4:], "little")
    return path.stat().st_size != _STL_HEAD + 50 * triangles and head.lstrip().startswith(b"solid")


def compiled_spec(spec: mujoco.MjSpec) -> mujoco.MjModel:
    """The model of a spec; a drawing without a volume, a sheet or an open surface, counts as a shell.

    Raises:
        ValueError: The simulator refuses it, with its reason.
    """
    while True:
        try:
            return spec.compile()
        except ValueError as refused:
            flat = _FLAT.search(str(refused))
            mesh = None if flat is None else spec.mesh(flat[1])
            if mesh is None or mesh.inertia == mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL:
                raise
            mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL


def pad_name(link: str) -> str:
    """Name of the pad geom of a fingertip link."""
    return f"pad:{link}"


def sole_name(sole: SoleDescription) -> str:
    """Name of a sole's geom and site."""
    return f"sole:{sole.side}"


def body(spec: mujoco.MjSpec, name: str) -> mujoco.MjsBody:
    """The body of a link.

    Raises:
        DescriptionError: There is none.
    """
    found = spec.body(name)
    if found is None:
        raise DescriptionError(f"the URDF has no link {name!r}")
    return found


def set_role(geom: mujoco.MjsGeom, role: Role) -> None:
    """Make a geom collide as its role says."""
    geom.contype, geom.conaffinity = CONTYPE[role], CONAFFINITY[role]


def _assign_roles(spec: mujoco.MjSpec, description: RobotDescription) -> None:
    fingers = frozenset[str]().union(*(item.finger_links for item in description.grippers.values()))
    grippers = frozenset(link for item in description.grippers.values() for link in item.links)
    soles = {sole.link for sole in description.soles}
    camera = description.head_camera
    head = frozenset() if camera is None else _rigidly_with(spec, camera.frame)
    for geom in spec.geoms:
        link = geom.parent.name
        if not geom.contype:
            geom.group = FINGER_DRAWN_GROUP if link in fingers else DRAWN_GROUP
            geom.rgba = (0.30, 0.32, 0.36, 1.0) if link in grippers else (0.82, 0.82, 0.84, 1.0)
            continue
        role = Role.FINGER if link in fingers else Role.NONE if link in soles else Role.BODY
        set_role(geom, role)
        geom.group = UNSEEN_GROUP if link in fingers or link in head else HULL_GROUP
        geom.priority = HULL_PRIORITY
        geom.friction = (HULL_FRICTION, 0.005, 0.0001)


def _leave_out(spec: mujoco.MjSpec, group: int) -> None:
    """Take away the geoms of a group, and the meshes that nothing else has."""
    for geom in list(spec.geoms):
        if geom.group == group:
            spec.delete(geom)
    used = {geom.meshname for geom in spec.geoms}
    for mesh in list(spec.meshes):
        if mesh.name not in used:
            spec.delete(mesh)


def _rigidly_with(spec: mujoco.MjSpec, frame: str) -> frozenset[str]:
    """Links that cannot move against a frame's link: up to the first joint, and all that hangs there.

    A frame that no joint moves is of a camera that stands apart, before nothing of the robot.
    """
    top = body(spec, frame)
    while not top.joints:
        top = top.parent
        if top is None or top == spec.worldbody:
            return frozenset({frame})
    names, open_ends = set(), [top]
    while open_ends:
        link = open_ends.pop()
        names.add(link.name)
        open_ends += [child for child in link.bodies if not child.joints]
    return frozenset(names)


def _tune_joints(spec: mujoco.MjSpec, description: RobotDescription) -> None:
    grippers = set(description.gripper_joints)
    followers = {item.name1: item.name2 for item in spec.equalities}
    for joint in spec.joints:
        if joint.type == mujoco.mjtJoint.mjJNT_FREE:
            continue
        driver = followers.get(joint.name, joint.name)
        if driver not in description.armature:
            raise DescriptionError(f"joint {joint.name!r} is not described")
        joint.armature = description.armature[driver]
        viscosity = description.joint_viscosity_nms_rad
        joint.damping = (GRIPPER_DAMPING if driver in grippers else viscosity, 0.0, 0.0)
        joint.frictionloss = 0.0
        joint.actfrclimited = False  # the actuators carry the limits
    for equality in spec.equalities:
        equality.solref, equality.solimp = MIMIC_SOLREF, MIMIC_SOLIMP


def _add_sole(spec: mujoco.MjSpec, sole: SoleDescription) -> None:
    """Give the sole's own link the box that stands: what its weld transmits is then the ground's wrench."""
    link = body(spec, sole.frame)
    (x0, x1), (y0, y1), z = sole.x_m, sole.y_m, sole.thickness_m
    geom = link.add_geom(
        name=sole_name(sole),
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=[0.5 * (x1 - x0), 0.5 * (y1 - y0), 0.5 * z],
        pos=[0.5 * (x0 + x1), 0.5 * (y0 + y1), 0.5 * z],
        mass=0.0,
        condim=4,
        friction=[SOLE_FRICTION, 0.01, 0.0001],
        solref=[0.01, 1.0],
        priority=SOLE_PRIORITY,
        group=HULL_GROUP,
    )
    set_role(geom, Role.BODY)
    link.add_site(name=sole_name(sole))


def _add_pads(spec: mujoco.MjSpec, gripper: GripperDescription) -> None:
    pads = zip(gripper.pad_links, gripper.pad_half_size_m, gripper.pad_position_m, strict=True)
    for name, half_size, position in pads:
        geom = body(spec, name).add_geom(
            name=pad_name(name),
            type=mujoco.mjtGeom.mjGEOM_BOX,
            size=list(half_size),
            pos=list(position),
            mass=0.0,
            condim=4,
            friction=[HULL_FRICTION, 0.005, 0.0001],  # with objects the pairs of the scene rule
            solref=list(PAD_SOLREF),
            solimp=list(PAD_SOLIMP),
            priority=HULL_PRIORITY,
            group=UNSEEN_GROUP,
        )
        set_role(geom, Role.PAD)


def _exclude_pairs(spec: mujoco.MjSpec, description: RobotDescription) -> None:
    names = {item.name for item in spec.bodies}
    frames = {sole.link: sole.frame for sole in description.soles}
    pairs = set(description.disabled_collisions)
    # The soles stand in for the hulls of the links that they are part of.
    pairs |= {(frames.get(first, first), frames.get(second, second)) for first, second in pairs}
    for first, second in sorted(pairs):
        if first in names and second in names and first != second:
            spec.add_exclude(bodyname1=first, bodyname2=second)


def _add_actuators(spec: mujoco.MjSpec, robot: RobotData) -> None:
    description = robot.description
    for name in description.actuated:
        if spec.joint(name) is None:
            raise DescriptionError(f"the URDF has no joint {name!r}")
        gains, effort = robot.hardware.gains[name], description.limits[name].effort
        actuator = spec.add_actuator(name=name, target=name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
        actuator.set_to_position(kp=gains.stiffness, kv=gains.damping)
        actuator.forcelimited = True
        actuator.forcerange = [-effort, effort]


def _add_sensors(spec: mujoco.MjSpec, description: RobotDescription) -> None:
    site = mujoco.mjtObj.mjOBJ_SITE
    if description.imu is not None:
        body(spec, description.imu).add_site(name=description.imu)
        for name, kind in IMU_SENSORS.items():
            spec.add_sensor(name=name, type=kind, objtype=site, objname=description.imu)
    for sole in description.soles:
        for label, kind in (
            ("force", mujoco.mjtSensor.mjSENS_FORCE),
            ("torque", mujoco.mjtSensor.mjSENS_TORQUE),
        ):
            name = sole_name(sole)
            spec.add_sensor(name=f"{label}:{sole.side}", type=kind, objtype=site, objname=name)
