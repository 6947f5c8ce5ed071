"""Read a robot's data: ``robots/models/<name>/description.toml`` and the URDF that it names."""

from __future__ import annotations

import importlib.metadata
import importlib.resources
import re
import tomllib
import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping
from itertools import combinations
from pathlib import Path
from typing import Any

from kinematics.robot_description import (
    HANDS,
    CameraDescription,
    GripperDescription,
    Hand,
    JointGains,
    JointLimits,
    RobotDescription,
    SensorNoise,
    SoleDescription,
)
from robots.errors import DescriptionError, UnknownRobotError

Table = Mapping[str, Any]


def known_robots() -> list[str]:
    """Names of the robots that have a folder of data."""
    root = importlib.resources.files("robots.models")
    return sorted(
        item.name for item in root.iterdir() if item.is_dir() and (item / "description.toml").is_file()
    )


def load_description(name: str) -> RobotDescription:
    """Read the data of a robot.

    Raises:
        UnknownRobotError: There is no robot of that name.
        DescriptionError: Its data contradict the URDF, or the URDF's package is not installed.
    """
    if name not in known_robots():
        raise UnknownRobotError(name, known_robots())
    text = (importlib.resources.files("robots.models") / name / "description.toml").read_text("utf-8")
    try:
        return _describe(name, tomllib.loads(text))
    except KeyError as missing:
        raise DescriptionError(f"robot {name!r}: description.toml or URDF lacks {missing}") from missing


def _describe(name: str, data: Table) -> RobotDescription:
    root = _model_root(data["source"])
    urdf = _clean_urdf((root / data["source"]["urdf"]).read_text("utf-8"), root)
    grippers = {hand: _gripper(hand, data["gripper"]) for hand in HANDS}
    for hand in HANDS:
        _add_tcp(urdf, grippers[hand], data["gripper"]["tcp"][hand])
    planning = _with_fixed_joints(urdf, r"gripper_.*")
    srdf = ElementTree.parse(root / data["source"]["srdf"]).getroot()
    joints = _order(planning, data["groups"])
    gripper_joints = tuple(grippers[hand].joint for hand in HANDS)
    actuated = joints + gripper_joints
    posture = _srdf_posture(srdf, data["source"]["srdf_posture"])
    return RobotDescription(
        name=name,
        urdf=ElementTree.tostring(urdf, encoding="unicode"),
        planning_urdf=ElementTree.tostring(planning, encoding="unicode"),
        mesh_dir=str(root),
        disabled_collisions=_disabled_pairs(srdf, data["gripper"]),
        joints=joints,
        gripper_joints=gripper_joints,
        limits=_limits(urdf, actuated, data),
        gains={joint: _gains(joint, data["gains"]) for joint in actuated},
        home={joint: data["home"].get(joint, posture.get(joint, 0.0)) for joint in actuated},
        groups={group: tuple(members) for group, members in data["groups"].items()},
        grippers=grippers,
        soles=tuple(_sole(item) for item in data["sole"]),
        camera=CameraDescription(
            frame=data["camera"]["frame"],
            horizontal_fov_rad=data["camera"]["horizontal_fov_rad"],
            vertical_fov_rad=data["camera"]["vertical_fov_rad"],
            range_m=tuple(data["camera"]["range_m"]),
            pan_joint=data["camera"]["pan_joint"],
            tilt_joint=data["camera"]["tilt_joint"],
            lean_joint=data["camera"].get("lean_joint"),
        ),
        base_link=data["body"]["base_link"],
        imu_link=data["body"]["imu_link"],
        noise=SensorNoise(**data["noise"]),
        planning_margin_rad=data["limits"]["planning_margin_rad"],
        com_margin_m=data["limits"]["com_margin_m"],
        contact_effort_nm={
            joint: data["limits"]["contact"][kind]
            for joint in joints
            if (kind := _kind(joint, data["gains"]["members"])) in data["limits"]["contact"]
        },
    )


def _model_root(source: Table) -> Path:
    try:
        distribution = importlib.metadata.distribution(source["distribution"])
    except importlib.metadata.PackageNotFoundError as missing:
        raise DescriptionError(
            f"the package {source['distribution']!r} with the URDF is not installed"
        ) from missing
    return Path(str(distribution.locate_file(source["root"])))


def _clean_urdf(text: str, root: Path) -> ElementTree.Element:
    """Parse a URDF with absolute mesh paths and without what is meant for other simulators."""
    text = re.sub(r"package:///?example-robot-data/robots/", f"{root}/", text)
    urdf = ElementTree.fromstring(text)
    for tag in ("gazebo", "transmission"):
        for element in urdf.findall(tag):
            urdf.remove(element)
    return urdf


def _add_tcp(urdf: ElementTree.Element, gripper: GripperDescription, place: Table) -> None:
    ElementTree.SubElement(urdf, "link", name=gripper.tcp_frame)
    joint = ElementTree.SubElement(urdf, "joint", name=f"{gripper.tcp_frame}_joint", type="fixed")
    ElementTree.SubElement(joint, "parent", link=gripper.base_link)
    ElementTree.SubElement(joint, "child", link=gripper.tcp_frame)
    ElementTree.SubElement(
        joint, "origin", xyz=" ".join(map(str, place["xyz"])), rpy=" ".join(map(str, place["rpy"]))
    )


def _with_fixed_joints(urdf: ElementTree.Element, pattern: str) -> ElementTree.Element:
    copy = ElementTree.fromstring(ElementTree.tostring(urdf))
    for joint in copy.findall("joint"):
        if re.fullmatch(pattern, joint.get("name", "")):
            joint.set("type", "fixed")
            for tag in ("mimic", "limit", "dynamics"):
                for element in joint.findall(tag):
                    joint.remove(element)
    return copy


def _order(urdf: ElementTree.Element, groups: Table) -> tuple[str, ...]:
    """Moving joints in Pinocchio's order: depth first, children in the order of their joints' names."""
    children: dict[str, list[tuple[str, str, bool]]] = {}
    is_child = set()
    for joint in urdf.findall("joint"):
        parent, child = joint.find("parent"), joint.find("child")
        if parent is None or child is None:
            raise DescriptionError(f"joint {joint.get('name')!r} has no parent or no child")
        moving = joint.get("type") not in ("fixed", "floating")
        children.setdefault(parent.attrib["link"], []).append(
            (joint.attrib["name"], child.attrib["link"], moving)
        )
        is_child.add(child.attrib["link"])
    roots = [link.attrib["name"] for link in urdf.findall("link") if link.attrib["name"] not in is_child]
    order: list[str] = []

    def visit(link: str) -> None:
        for name, child, moving in sorted(children.get(link, []), key=lambda item: item[1]):
            if moving:
                order.append(name)
            visit(child)

    visit(roots[0])
    described = {joint for members in groups.values() for joint in members}
    if described != set(order):
        raise DescriptionError(f"groups and URDF disagree on {sorted(described ^ set(order))}")
    return tuple(order)


def _srdf_posture(srdf: ElementTree.Element, name: str) -> dict[str, float]:
    for state in srdf.findall("group_state"):
        if state.get("name") == name:
            return {
                joint.attrib["name"]: float(joint.attrib["value"])
                for joint in state.findall("joint")
                if " " not in joint.attrib["value"].strip()
            }
    raise DescriptionError(f"the SRDF has no group_state {name!r}")


def _disabled_pairs(srdf: ElementTree.Element, gripper: Table) -> frozenset[tuple[str, str]]:
    pairs = [(item.attrib["link1"], item.attrib["link2"]) for item in srdf.findall("disable_collisions")]
    for hand in HANDS:
        cluster = sorted(name.format(hand=hand) for name in (*gripper["links"], *gripper["cluster"]))
        pairs += combinations(cluster, 2)
    return frozenset((min(pair), max(pair)) for pair in pairs)


def _limits(urdf: ElementTree.Element, actuated: tuple[str, ...], data: Table) -> dict[str, JointLimits]:
    by_name = {joint.attrib["name"]: joint for joint in urdf.findall("joint")}
    table, members = data["limits"], data["gains"]["members"]
    limits = {}
    for name in actuated:
        element = by_name[name].find("limit")
        if element is None:
            raise DescriptionError(f"joint {name!r} has no limits in the URDF")
        kind = _kind(name, members)
        lower, upper = table["position"].get(
            name, (float(element.attrib["lower"]), float(element.attrib["upper"]))
        )
        limits[name] = JointLimits(
            position=(lower, upper),
            velocity=float(element.attrib["velocity"]),
            acceleration=table["acceleration"][kind],
            jerk=table["jerk"][kind],
            effort=table["effort"].get(kind, float(element.attrib["effort"])),
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
