"""Read a robot's data: ``robots/models/<name>/description.toml`` and the URDF that it names.

What the keys mean is told in ``docs/extend/a-robot.md``.
"""

from __future__ import annotations

import importlib.metadata
import importlib.resources
import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping
from importlib.resources.abc import Traversable
from itertools import combinations
from pathlib import Path
from typing import Any

from kinematics.model.reachability import ReachabilityMap
from kinematics.model.robot_description import (
    GROUPS,
    HANDS,
    CameraDescription,
    GripperDescription,
    Hand,
    HealthLimits,
    JointGains,
    JointLimits,
    RobotDescription,
    SensorNoise,
    SoleDescription,
)
from kinematics.model.walking_settings import TuckedArms, WalkingSettings
from robots.errors import DescriptionError, UnknownRobotError
from robots.models.reachability_file import REACHABILITY, read_reachability
from robots.models.urdf import (
    Table,
    add_collision_box,
    add_frame,
    joints_named,
    link_names,
    moving_joints,
    read_urdf,
    with_fixed_joints,
)
from robots.outside import ROBOTS, outside_folders
from robots.toml_text import read_toml

DISABLED_COLLISIONS = "disabled_collisions.toml"
"""Pairs of links that are not judged, for robots without an SRDF; made by
``tools.robot_data.disabled_collisions``.
"""

_GRIPPER_KIND = "gripper"
"""Joints of this kind are held open for planning."""
_NO_JOINT = "(?!)"


def known_robots() -> list[str]:
    """Names of the robots that have a folder of data, here or in another package."""
    return sorted(_folders())


def _folders() -> Mapping[str, Traversable]:
    """The folder of each robot; of equal names the one here."""
    here = {item.name: item for item in importlib.resources.files("robots.models").iterdir()}
    folders = {**outside_folders(ROBOTS).folders, **here}
    return {name: item for name, item in folders.items() if (item / "description.toml").is_file()}


def load_description(name: str) -> RobotDescription:
    """Read the data of a robot.

    Raises:
        UnknownRobotError: There is no robot of that name.
        DescriptionError: Its data contradict the URDF, or the URDF's package is not installed.
    """
    folder = _folders().get(name)
    if folder is None:
        raise UnknownRobotError(name, known_robots())
    data = read_toml((folder / "description.toml").read_text("utf-8"))
    try:
        return _describe(name, data, folder)
    except KeyError as missing:
        raise DescriptionError(f"robot {name!r}: description.toml or URDF lacks {missing}") from missing
    except DescriptionError as wrong:
        raise DescriptionError(f"robot {name!r}: {wrong}") from wrong


def load_description_for_tasks(name: str) -> RobotDescription:
    """Read the data of a robot that is to carry out sentences.

    Raises:
        UnknownRobotError: There is no robot of that name.
        DescriptionError: As for ``load_description``, or the robot lacks a part that the skills need.
    """
    description = load_description(name)
    if missing := description.missing_for_tasks:
        reason = f" ({description.cannot_grasp})" if description.cannot_grasp else ""
        raise DescriptionError(
            f"robot {name!r} can plan but not carry out tasks yet: it has no {', no '.join(missing)}{reason}"
        )
    return description


def _describe(name: str, data: Table, folder: Traversable) -> RobotDescription:
    root = _model_root(data["source"])
    urdf = read_urdf(root / data["source"]["urdf"], root)
    grippers = {hand: _gripper(hand, data["gripper"]) for hand in _hands(data.get("gripper"))}
    tcp_frames = _add_tcps(urdf, data)
    for frame in data.get("frame", ()):
        add_frame(urdf, frame["name"], frame["link"], frame)
    for box in data.get("collision", ()):
        add_collision_box(urdf, box["link"], box)
    members = data["gains"]["members"]
    open_rad = {gripper.joint: gripper.open_rad for gripper in grippers.values()}
    planning = with_fixed_joints(urdf, members.get(_GRIPPER_KIND, _NO_JOINT), open_rad)
    joints = _order(planning, data["groups"])
    gripper_joints = tuple(gripper.joint for gripper in grippers.values())
    actuated = joints + gripper_joints
    srdf = _srdf(data["source"], root)
    posture = {} if srdf is None else _srdf_posture(srdf, data["source"]["srdf_posture"])
    body, limits = data["body"], data["limits"]
    description = RobotDescription(
        name=name,
        urdf=ElementTree.tostring(urdf, encoding="unicode"),
        planning_urdf=ElementTree.tostring(planning, encoding="unicode"),
        mesh_dir=str(root),
        disabled_collisions=_disabled_pairs(srdf, folder, data.get("gripper")),
        joints=joints,
        gripper_joints=gripper_joints,
        limits=_limits(urdf, actuated, data),
        gains={joint: _gains(joint, data["gains"]) for joint in actuated},
        home={joint: data["home"].get(joint, posture.get(joint, 0.0)) for joint in actuated},
        groups={group: tuple(data["groups"].get(group, ())) for group in _group_names(data["groups"])},
        grippers=grippers,
        soles=tuple(_sole(item) for item in data.get("sole", ())),
        tcp_frames=tcp_frames,
        head_camera=_camera(data.get("camera")),
        base_link=body["base_link"],
        imu=body.get("imu_link"),
        noise=SensorNoise(**data["noise"]),
        planning_margin_rad=limits["planning_margin_rad"],
        joint_viscosity_nms_rad=data.get("friction", {}).get("viscosity_nms_rad", 0.0),
        com_margin_m=limits["com_margin_m"] if "sole" in data else 0.0,
        contact_effort_nm={
            joint: limits["contact"][kind]
            for joint in joints
            if (kind := _kind(joint, members)) in limits.get("contact", {})
        },
        base=body.get("base", "floating"),
        mount_xyz_m=tuple(body.get("mount_xyz_m", (0.0, 0.0, 0.0))),
        mount_rpy_rad=tuple(body.get("mount_rpy_rad", (0.0, 0.0, 0.0))),
        cannot_grasp=data.get("hand", {}).get("cannot_grasp", ""),
        walking=_walking(data.get("walking"), joints, members),
        reachability=_reachability(folder),
        health=HealthLimits(**data.get("health", {})),
    )
    _require_consistent(description, link_names(urdf))
    return description


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


def _model_root(source: Table) -> Path:
    try:
        distribution = importlib.metadata.distribution(source["distribution"])
    except importlib.metadata.PackageNotFoundError as missing:
        raise DescriptionError(
            f"the package {source['distribution']!r} with the URDF is not installed"
        ) from missing
    return Path(str(distribution.locate_file(source["root"])))


def _hands(part: Table | None) -> list[Hand]:
    """Hands that a table of grippers or of hands describes, left before right."""
    return [] if part is None else [hand for hand in HANDS if hand in part["tcp"]]


def _add_tcps(urdf: ElementTree.Element, data: Table) -> dict[Hand, str]:
    """Put the TCPs of all hands into the URDF; those of hands with a gripper come from its table."""
    frames: dict[Hand, str] = {}
    for part in (data.get("gripper"), data.get("hand")):
        for hand in _hands(part):
            if part is None or hand in frames:
                continue
            frames[hand] = part["tcp"]["frame"].format(hand=hand)
            add_frame(urdf, frames[hand], part["base_link"].format(hand=hand), part["tcp"][hand])
    return frames


def _group_names(described: Table) -> list[str]:
    return [*described, *(group for group in GROUPS if group not in described)]


def _order(urdf: ElementTree.Element, groups: Table) -> tuple[str, ...]:
    """Body joints in Pinocchio's order."""
    if unknown := sorted(set(groups) - set(GROUPS)):
        raise DescriptionError(f"[groups] {unknown[0]!r} is none of {', '.join(GROUPS)}")
    order = moving_joints(urdf)
    described = {joint for members in groups.values() for joint in members}
    if described != set(order):
        raise DescriptionError(f"groups and URDF disagree on {sorted(described ^ set(order))}")
    return order


def _srdf(source: Table, root: Path) -> ElementTree.Element | None:
    return ElementTree.parse(root / source["srdf"]).getroot() if "srdf" in source else None


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
    srdf: ElementTree.Element | None, folder: Traversable, gripper: Table | None
) -> frozenset[tuple[str, str]]:
    """Pairs of links that are never judged: the SRDF's, the robot's own list, those within a gripper."""
    disabled = [] if srdf is None else srdf.findall("disable_collisions")
    pairs = [(item.attrib["link1"], item.attrib["link2"]) for item in disabled]
    stored = folder / DISABLED_COLLISIONS
    if stored.is_file():
        pairs += [(a, b) for listed in read_toml(stored.read_text("utf-8")).values() for a, b in listed]
    for hand in _hands(gripper):
        names: tuple[str, ...] = () if gripper is None else (*gripper["links"], *gripper.get("cluster", ()))
        pairs += combinations(sorted(name.format(hand=hand) for name in names), 2)
    return frozenset((min(pair), max(pair)) for pair in pairs)


def _limits(urdf: ElementTree.Element, actuated: tuple[str, ...], data: Table) -> dict[str, JointLimits]:
    """The URDF's limits where the data do not say otherwise, by joint (position) or by kind."""
    elements = joints_named(urdf, actuated)
    table, members = data["limits"], data["gains"]["members"]
    positions: Mapping[str, Any] = table.get("position", {})
    if unknown := sorted(set(positions) - set(actuated)):
        raise DescriptionError(f"[limits.position] names no joint of the robot: {unknown[0]!r}")
    limits = {}
    for name in actuated:
        element = elements[name].find("limit")
        if element is None:
            raise DescriptionError(f"joint {name!r} has no limits in the URDF")
        kind = _kind(name, members)
        lower, upper = positions.get(name, (float(element.attrib["lower"]), float(element.attrib["upper"])))
        limits[name] = JointLimits(
            position=(lower, upper),
            velocity=float(element.attrib["velocity"]),
            acceleration=table["acceleration"][kind],
            jerk=table["jerk"][kind],
            effort=table.get("effort", {}).get(kind, float(element.attrib["effort"])),
        )
    return limits


def _kind(joint: str, members: Table) -> str:
    for kind, pattern in members.items():
        if re.fullmatch(pattern, joint):
            return str(kind)
    raise DescriptionError(f"joint {joint!r} belongs to no kind of [gains.members]")


def _gains(joint: str, table: Table) -> JointGains:
    return JointGains(**table[_kind(joint, table["members"])])


def _gripper(hand: Hand, data: Table) -> GripperDescription:
    def links(key: str) -> tuple[str, ...]:
        return tuple(item.format(hand=hand) for item in data[key])

    return GripperDescription(
        hand=hand,
        joint=data["joint"].format(hand=hand),
        tcp_frame=data["tcp"]["frame"].format(hand=hand),
        base_link=data["base_link"].format(hand=hand),
        links=links("links"),
        touch_links=links("touch_links"),
        pad_links=links("pad_links"),
        open_rad=data["open_rad"],
        closed_rad=data["closed_rad"],
        opening_table=tuple((row[0], row[1]) for row in data["opening_table"]),
        effort_nm=data["effort_nm"],
        closing_speed_rad_s=data["closing_speed_rad_s"],
        empty_below_rad=data["empty_below_rad"],
        held_effort_nm=data["held_effort_nm"],
        payload_kg=data["payload_kg"],
        pad_half_size_m=tuple((x, y, z) for x, y, z in data["pad_half_size_m"]),
        pad_position_m=tuple((x, y, z) for x, y, z in data["pad_position_m"]),
        pad_gap_m=data["pad_gap_m"],
        palm_distance_m=data["palm_distance_m"],
        closing_advance_m=data["closing_advance_m"],
    )


def _sole(item: Table) -> SoleDescription:
    return SoleDescription(
        side=item["side"],
        frame=item["frame"],
        link=item["link"],
        x_m=tuple(item["x_m"]),
        y_m=tuple(item["y_m"]),
        thickness_m=item["thickness_m"],
    )


def _walking(data: Table | None, joints: tuple[str, ...], members: Table) -> WalkingSettings | None:
    if data is None:
        return None
    by_kind = data["joint_acceleration"]
    by_joint = {joint: by_kind[kind] for joint in joints if (kind := _kind(joint, members)) in by_kind}
    tucked = TuckedArms(**data["tucked"]) if "tucked" in data else None
    return WalkingSettings(**{**data, "joint_acceleration": by_joint, "tucked": tucked})


def _reachability(folder: Traversable) -> ReachabilityMap | None:
    file = folder / REACHABILITY
    return read_reachability(file.read_text("utf-8")) if file.is_file() else None


def _camera(data: Table | None) -> CameraDescription | None:
    if data is None:
        return None
    return CameraDescription(
        frame=data["frame"],
        horizontal_fov_rad=data["horizontal_fov_rad"],
        vertical_fov_rad=data["vertical_fov_rad"],
        range_m=tuple(data["range_m"]),
        pan_joint=data["pan_joint"],
        tilt_joint=data["tilt_joint"],
        lean_joint=data.get("lean_joint"),
    )
