"""Hands out of a robot's document: ``[gripper]`` and its motors, for each side."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ElementTree
from collections.abc import Sequence
from dataclasses import replace

from kinematics.model.robot_description import GripperDescription, Hand, HandMotor
from robots.errors import DescriptionError
from robots.models.description_document import GripperTable, MotorTable
from robots.models.urdf import joints_named


def grippers_of(table: GripperTable | None, urdf: ElementTree.Element) -> dict[Hand, GripperDescription]:
    """The grippers of a robot by hand; none where it has no such table.

    Args:
        table: Of its document.
        urdf: Its URDF.

    Raises:
        DescriptionError: What drives a gripper is not said, or said twice.
    """
    return {} if table is None else {hand: _gripper(hand, table, urdf) for hand in table.tcp.places()}


def motor_efforts(table: GripperTable | None) -> dict[str, float]:
    """What each of several motors of a hand gives, by joint."""
    hands = () if table is None else table.tcp.places()
    return {
        motor.joint.format(hand=hand): motor.effort_nm
        for hand in hands
        for motor in (() if table is None else table.motor)
    }


def _motors(hand: Hand, table: GripperTable) -> tuple[HandMotor, ...]:
    def motor(described: MotorTable) -> HandMotor:
        sign = -1.0 if described.mirrored and hand == "right" else 1.0
        joint = described.joint.format(hand=hand)
        return HandMotor(joint, sign * described.open_rad, sign * described.closed_rad)

    return tuple(motor(described) for described in table.motor)


def _driven_joint(table: GripperTable, motors: Sequence[HandMotor]) -> str:
    """The joint that a gripper is driven by, first of all.

    Raises:
        DescriptionError: None or several are named, or no motor moves, or the ends are not 0 and 1.
    """
    if (table.joint is None) == (not motors):
        raise DescriptionError("[gripper] has either a joint or a table motor for each of several")
    if table.joint is not None:
        return table.joint
    moving = [motor.joint for motor in motors if motor.open_rad != motor.closed_rad]
    if not moving or (table.open_rad, table.closed_rad) != (1.0, 0.0):
        raise DescriptionError("[gripper] motors go from closed_rad = 0.0 to open_rad = 1.0, and one moves")
    return moving[0]


def _gripper(hand: Hand, table: GripperTable, urdf: ElementTree.Element) -> GripperDescription:
    motors = _motors(hand, table)
    joint = _driven_joint(table, motors).format(hand=hand)
    mirror = 1.0 if hand == "left" else -1.0

    def named(names: Sequence[str]) -> tuple[str, ...]:
        return tuple(name.format(hand=hand) for name in names)

    def sided(place: tuple[float, float, float]) -> tuple[float, float, float]:
        return (place[0], mirror * place[1], place[2]) if table.mirrored_pads else place

    return GripperDescription(
        hand=hand,
        joint=joint,
        tcp_frame=table.tcp.frame.format(hand=hand),
        base_link=table.base_link.format(hand=hand),
        links=named(table.links),
        touch_links=named(table.touch_links),
        pad_links=named(table.pad_links),
        open_rad=table.open_rad,
        closed_rad=table.closed_rad,
        opening_table=tuple(table.opening_table),
        payload_kg=table.payload_kg,
        pad_half_size_m=tuple(table.pad_half_size_m),
        pad_position_m=tuple(sided(place) for place in table.pad_position_m),
        pad_gap_m=table.pad_gap_m,
        palm_distance_m=table.palm_distance_m,
        closing_advance_m=table.closing_advance_m,
        palm_gap_m=table.palm_gap_m,
        tip_gap_m=table.tip_gap_m,
        low_tip_gap_m=table.low_tip_gap_m,
        low_tilt_gap_m=table.low_tilt_gap_m,
        lowest_overlap_m=table.lowest_overlap_m,
        pad_overlap_m=table.pad_overlap_m,
        over_ball_m=table.over_ball_m,
        motors=motors,
        palm_side_m=None if table.palm_side_m is None else mirror * table.palm_side_m,
        beside_palm_m=table.beside_palm_m,
        held_table=tuple((width, mirror * at) for width, at in table.held_table),
        push_table=tuple(table.push_table),
        aside_table=tuple((width, mirror * along) for width, along in table.aside_table),
        felt_n=table.felt_n,
        least_felt_m=table.least_felt_m,
        fingers_half_width_m=table.fingers_half_width_m,
        side_overlap_m=-math.inf if table.side_overlap_m is None else table.side_overlap_m,
        above_middle=table.above_middle,
        side_gap_m=table.side_gap_m,
        steepest_rad=table.steepest_rad,
        around_m=math.inf if table.around_m is None else table.around_m,
        bar=replace(table.bar, approach_rad=mirror * table.bar.approach_rad),
        cannot_grip_bars=table.cannot_grip_bars,
        slides=joints_named(urdf, [joint])[joint].get("type") == "prismatic",
    )
