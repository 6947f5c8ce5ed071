"""Read a robot's data: ``robots/models/<name>/description.toml`` and the URDF that it names.

What the keys mean is told in ``docs/extend/a-robot.md``.
"""

from __future__ import annotations

import importlib.metadata
import importlib.resources
import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping
from importlib.resources.abc import Traversable
from itertools import combinations
from pathlib import Path

from kinematics.model.reachability import ReachabilityMap
from kinematics.model.robot_description import (
    GROUPS,
    Hand,
    JointLimits,
    RobotDescription,
)
from robots.errors import DescriptionError, UnknownRobotError, UnknownRobotFolderError
from robots.interface.hardware import RobotData
from robots.models.description_document import (
    DescriptionDocument,
    GripperTable,
    SourceTable,
    by_kind,
)
from robots.models.fitted_urdf import bound_joints, forget_capsules, with_joints_held, without_world
from robots.models.gripper_tables import grippers_of, motor_efforts
from robots.models.hardware_tables import hardware_of
from robots.models.reachability_file import REACHABILITY, read_reachability
from robots.models.urdf import (
    add_collision_box,
    add_frame,
    joints_named,
    link_names,
    moving_joints,
    read_urdf,
    with_fixed_joints,
)
from robots.outside import DESCRIPTION, is_path, known_robots, robot_folder
from robots.strict_table import read_table
from robots.toml_text import TomlTextError, read_toml

DISABLED_COLLISIONS = "disabled_collisions.toml"
"""Pairs of links that are not judged, for robots without an SRDF; made by
``tools.robot_data.disabled_collisions``.
"""

_GRIPPER_KIND = "gripper"
"""Joints of this kind are held open for planning."""
_NO_JOINT = "(?!)"


def load_description(name: str) -> RobotDescription:
    """Read where the parts of a robot are; raises what ``load_robot`` does."""
    return load_robot(name).description


def load_robot(name: str) -> RobotData:
    """Read the data of a robot.

    Raises:
        UnknownRobotError: There is no robot of that name.
        DescriptionError: Its data contradict the URDF, or the URDF's package is not installed.
    """
    folder = robot_folder(name)
    if folder is None and is_path(name):
        raise UnknownRobotFolderError(name, DESCRIPTION)
    if folder is None:
        raise UnknownRobotError(name, known_robots())

    def fail(key: str, reason: str) -> DescriptionError:
        return DescriptionError(f"{DESCRIPTION}: {key}: {reason}")

    try:
        data = read_toml((folder / DESCRIPTION).read_text("utf-8"))
        document = read_table(DescriptionDocument, data, fail)
        description = _describe(_told_name(name), document, folder)
        return RobotData(description, hardware_of(document, description))
    except KeyError as missing:
        raise DescriptionError(f"robot {name!r}: the URDF lacks {missing}") from missing
    except TomlTextError as broken:
        raise DescriptionError(f"robot {name!r}: {DESCRIPTION} is no TOML: {broken}") from broken
    except DescriptionError as wrong:
        raise DescriptionError(f"robot {name!r}: {wrong}") from wrong


def _told_name(name: str) -> str:
    """What a robot is called that was named so: of a path, the folder."""
    return Path(name).expanduser().resolve().name if is_path(name) else name


def load_robot_for_tasks(name: str) -> RobotData:
    """Read the data of a robot that is to carry out sentences.

    Raises:
        UnknownRobotError: There is no robot of that name.
        DescriptionError: As for ``load_robot``, or the robot lacks a part that the skills need.
    """
    robot = load_robot(name)
    description = robot.description
    if missing := description.missing_for_tasks:
        raise DescriptionError(
            f"robot {name!r} can plan but not carry out tasks yet: it has no {', no '.join(missing)}"
        )
    return robot


def _describe(name: str, document: DescriptionDocument, folder: Traversable) -> RobotDescription:
    source, body, gains = document.source, document.body, document.gains
    root = _model_root(source, folder)
    urdf = with_joints_held(read_urdf(root / source.urdf, root), document.held)
    without_world(urdf)
    bound_joints(urdf, document.limits.position)
    if source.capsules_as_cylinders:
        forget_capsules(urdf)
    grippers = grippers_of(document.gripper, urdf)
    tcp_frames = _add_tcps(urdf, document)
    for frame in document.frame:
        add_frame(urdf, frame.name, frame.link, frame.model_dump())
    for box in document.collision:
        add_collision_box(urdf, box.link, box.model_dump())
    open_rad = {
        joint: at
        for gripper in grippers.values()
        for joint, at in zip(gripper.joints, gripper.joints_at(gripper.open_rad), strict=True)
    }
    planning = with_fixed_joints(urdf, gains.members.get(_GRIPPER_KIND, _NO_JOINT), open_rad)
    joints = _order(planning, document.groups)
    gripper_joints = tuple(joint for gripper in grippers.values() for joint in gripper.joints)
    actuated = joints + gripper_joints
    srdf = None if source.srdf is None else ElementTree.parse(root / source.srdf).getroot()
    motors = {motor.joint: motor.open_rad for gripper in grippers.values() for motor in gripper.motors}
    posture = motors | ({} if srdf is None else _srdf_posture(srdf, source.srdf_posture or ""))
    description = RobotDescription(
        name=name,
        urdf=ElementTree.tostring(urdf, encoding="unicode"),
        planning_urdf=ElementTree.tostring(planning, encoding="unicode"),
        mesh_dir=str(root),
        disabled_collisions=_disabled_pairs(srdf, folder, document.gripper),
        joints=joints,
        gripper_joints=gripper_joints,
        limits=_limits(urdf, actuated, document),
        armature={joint: gains.of(joint).armature for joint in actuated},
        home={joint: document.home.get(joint, posture.get(joint, 0.0)) for joint in actuated},
        groups={group: tuple(document.groups.get(group, ())) for group in _group_names(document.groups)},
        grippers=grippers,
        soles=tuple(document.sole),
        tcp_frames=tcp_frames,
        head_camera=document.camera,
        base_link=body.base_link,
        imu=body.imu_link,
        planning_margin_rad=document.limits.planning_margin_rad,
        joint_viscosity_nms_rad=document.friction.viscosity_nms_rad,
        com_margin_m=_com_margin_m(document),
        lean_rad=document.limits.lean_rad,
        base=body.base,
        mount_xyz_m=body.mount_xyz_m,
        mount_rpy_rad=body.mount_rpy_rad,
        reach_m=body.reach_m,
        foot_sensors=body.foot_sensors,
        cannot_grasp="" if document.hand is None else document.hand.cannot_grasp,
        walking=None if document.walking is None else document.walking[0],
        handles=document.handles,
        pushing=document.pushing,
        reachability=_reachability(folder),
    )
    _require_consistent(description, link_names(urdf))
    return description


def _com_margin_m(document: DescriptionDocument) -> float:
    """Of a robot that stands on soles; without any there is nothing to balance."""
    if not document.sole:
        return 0.0
    if document.limits.com_margin_m is None:
        raise DescriptionError(f"{DESCRIPTION}: limits.com_margin_m: is missing, for a robot with soles")
    return document.limits.com_margin_m


def _require_consistent(description: RobotDescription, links: list[str]) -> None:
    """What every user of a description relies on."""
    if description.base not in ("floating", "welded"):
        raise DescriptionError(f"[body] base is floating or welded, not {description.base!r}")
    if description.welded == bool(description.soles):
        state = "welded and has soles" if description.welded else "floating and has no sole to stand on"
        raise DescriptionError(f"the base is {state}")
    if description.hands != tuple(description.grippers) and not description.cannot_grasp:
        raise DescriptionError("a hand has no gripper and [hand] says no reason (cannot_grasp)")
    named = {"base_link": description.base_link, "imu_link": description.imu}
    named.update({f"sole {sole.frame}": sole.frame for sole in description.soles})
    if description.head_camera is not None:
        named["camera"] = description.head_camera.frame
    for what, link in named.items():
        if link is not None and link not in links:
            raise DescriptionError(f"{what}: the URDF has no link {link!r}")
    _check_posture("home posture", description.home, description)
    if (walking := description.walking) is not None and walking.tucked is not None:
        _check_posture("tucked arms", walking.tucked.joints, description)


def _check_posture(what: str, joints: Mapping[str, float], description: RobotDescription) -> None:
    for joint, at in joints.items():
        if joint not in description.limits:
            raise DescriptionError(f"{what}: the URDF has no joint {joint!r}")
        low, high = description.limits[joint].position
        if not low <= at <= high:
            raise DescriptionError(f"{what}: {joint} at {at:g} is outside {low:g} to {high:g} rad")


def _model_root(source: SourceTable, folder: Traversable) -> Path:
    """Where the paths of the URDF begin: in a package's files, or in the robot's own folder."""
    if source.distribution is None:
        return Path(str(folder), source.root).resolve()
    try:
        distribution = importlib.metadata.distribution(source.distribution)
    except importlib.metadata.PackageNotFoundError as missing:
        raise DescriptionError(
            f"the package {source.distribution!r} with the URDF is not installed"
        ) from missing
    return Path(str(distribution.locate_file(source.root)))


def _add_tcps(urdf: ElementTree.Element, document: DescriptionDocument) -> dict[Hand, str]:
    """Put the TCPs of all hands into the URDF; those of hands with a gripper come from its table."""
    frames: dict[Hand, str] = {}
    for part in (document.gripper, document.hand):
        for hand, place in part.tcp.places().items() if part is not None else ():
            if part is not None and hand not in frames:
                frames[hand] = part.tcp.frame.format(hand=hand)
                add_frame(urdf, frames[hand], part.base_link.format(hand=hand), place.model_dump())
    return frames


def _group_names(described: Mapping[str, list[str]]) -> list[str]:
    return [*described, *(group for group in GROUPS if group not in described)]


def _order(urdf: ElementTree.Element, groups: Mapping[str, list[str]]) -> tuple[str, ...]:
    """Body joints in Pinocchio's order."""
    if unknown := sorted(set(groups) - set(GROUPS)):
        raise DescriptionError(f"[groups] {unknown[0]!r} is none of {', '.join(GROUPS)}")
    order = moving_joints(urdf)
    described = {joint for members in groups.values() for joint in members}
    if described != set(order):
        raise DescriptionError(f"groups and URDF disagree on {sorted(described ^ set(order))}")
    return order


def _srdf_posture(srdf: ElementTree.Element, name: str) -> dict[str, float]:
    for state in srdf.findall("group_state"):
        if state.get("name") == name:
            return {
                joint.attrib["name"]: float(joint.attrib["value"])
                for joint in state.findall("joint")
                if " " not in joint.attrib["value"].strip()
            }
    raise DescriptionError(f"the SRDF has no group_state {name!r}")


def _disabled_pairs(
    srdf: ElementTree.Element | None, folder: Traversable, gripper: GripperTable | None
) -> frozenset[tuple[str, str]]:
    """Pairs of links that are never judged: the SRDF's, the robot's own list, those within a gripper."""
    disabled = [] if srdf is None else srdf.findall("disable_collisions")
    pairs = [(item.attrib["link1"], item.attrib["link2"]) for item in disabled]
    stored = folder / DISABLED_COLLISIONS
    if stored.is_file():
        pairs += [(a, b) for listed in read_toml(stored.read_text("utf-8")).values() for a, b in listed]
    for hand in () if gripper is None else gripper.tcp.places():
        names = () if gripper is None else (*gripper.links, *gripper.cluster)
        pairs += combinations(sorted(name.format(hand=hand) for name in names), 2)
    return frozenset((min(pair), max(pair)) for pair in pairs)


def _limits(
    urdf: ElementTree.Element, actuated: tuple[str, ...], document: DescriptionDocument
) -> dict[str, JointLimits]:
    """The URDF's limits where the data do not say otherwise, by joint (position) or by kind."""
    elements, table = joints_named(urdf, actuated), document.limits
    if unknown := sorted(set(table.position) - set(actuated)):
        raise DescriptionError(f"[limits.position] names no joint of the robot: {unknown[0]!r}")
    efforts = motor_efforts(document.gripper)
    limits = {}
    for name in actuated:
        element = elements[name].find("limit")
        if element is None or "lower" not in element.attrib:
            raise DescriptionError(f"joint {name!r} has no limits in the URDF, and [limits.position] none")
        kind = document.gains.kind_of(name)
        lower, upper = (float(element.attrib["lower"]), float(element.attrib["upper"]))
        limits[name] = JointLimits(
            position=table.position.get(name, (lower, upper)),
            velocity=table.velocity.get(kind, float(element.get("velocity", "0"))),
            acceleration=by_kind(table.acceleration, kind, "limits.acceleration"),
            jerk=by_kind(table.jerk, kind, "limits.jerk"),
            effort=efforts.get(name, table.effort.get(kind, float(element.get("effort", "0")))),
        )
    return limits


def _reachability(folder: Traversable) -> ReachabilityMap | None:
    file = folder / REACHABILITY
    return read_reachability(file.read_text("utf-8")) if file.is_file() else None
