"""A draft as the text of ``description.toml``."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable, Mapping

import numpy as np

from kinematics.arrays import Array
from tools.robot_data.drafting.anatomy import WITHOUT_END
from tools.robot_data.drafting.draft import BoxAround, Draft
from tools.robot_data.drafting.eyes import Eyes
from tools.robot_data.drafting.servos import ACCELERATION_RAD_S2, JERK_RAD_S3

CANNOT_GRASP = "its hands are drafted: they reach, and nobody has said how they grasp"
_COM_MARGIN_M = 0.02
_FIELDS = (1.05, 0.86)
_NOISE = """[noise]   # white noise of each reading, of usual encoders and IMUs
joint_position_rad = 0.0001
joint_velocity_rad_s = 0.002
joint_effort_fraction = 0.005
"""
_STANDING_NOISE = """gyro_rad_s = 0.002
accelerometer_m_s2 = 0.02
foot_force_n = 1.0
foot_torque_nm = 0.1
"""


def description_text(draft: Draft, source: Mapping[str, str], home: Mapping[str, float], command: str) -> str:
    """The whole file.

    Args:
        draft: The robot's.
        source: Keys of ``[source]``.
        home: Joint positions of the home posture, rad.
        command: What drafted it.
    """
    parts = [
        f"# {draft.anatomy.urdf.get('name', 'A robot')}. Drafted by {command}\n"
        "# What was guessed is in guesses.txt beside this file: look it through, and mend it here.\n"
        "# Lengths in m, angles in rad, efforts in Nm.\n",
        _source(draft, source),
        _body(draft),
        "[groups]\n" + "".join(f"{name} = {_list(joints)}\n" for name, joints in draft.limbs.groups.items()),
        _table("held", draft.held, "joints that nothing moves, and where they stand"),
        _table("home", {name: value for name, value in home.items() if value}, "joints left out are at 0"),
        _limits(draft),
        _gains(draft),
        _hands(draft),
        *(_frame(f"{side}_sole", sole.link, sole.link_T_sole) for side, sole in draft.soles.items()),
        *_soles(draft),
        *(_box(box) for box in draft.boxes),
        _camera(draft.eyes),
        _NOISE + (_STANDING_NOISE if draft.limbs.standing else ""),
    ]
    return "\n".join(part for part in parts if part)


def _source(draft: Draft, source: Mapping[str, str]) -> str:
    lines = [f"{key} = {json.dumps(value)}" for key, value in source.items()]
    if draft.anatomy.capsules:
        lines.append("capsules_as_cylinders = true")
    return "[source]\n" + "\n".join(lines) + "\n"


def _body(draft: Draft) -> str:
    lines = [f"base_link = {json.dumps(draft.base_link)}"]
    if draft.imu_link is not None:
        lines.append(f"imu_link = {json.dumps(draft.imu_link)}")
    if not draft.limbs.standing:
        lines += ['base = "welded"', f"mount_xyz_m = [0.0, 0.0, {_number(draft.mount_z_m)}]"]
        if not np.allclose(draft.anatomy.turn, np.eye(3)):
            lines.append(f"mount_rpy_rad = [{', '.join(map(_exact, _rpy(draft.anatomy.turn)))}]")
    lines.append(f"reach_m = {_number(round(1.1 * draft.reach_m, 2))}")
    return "[body]\n" + "\n".join(lines) + "\n"


def _limits(draft: Draft) -> str:
    bounds = {
        name: f"[{_number(WITHOUT_END[0])}, {_number(WITHOUT_END[1])}]"
        for name in draft.anatomy.endless
        if name not in draft.held
    }
    kinds = draft.kinds
    lines = ["[limits]", "planning_margin_rad = 0.01"]
    if draft.limbs.standing:
        narrowest = min(0.5 * (sole.y_m[1] - sole.y_m[0]) for sole in draft.soles.values())
        lines.append(f"com_margin_m = {_number(round(min(_COM_MARGIN_M, 0.5 * narrowest), 3))}")
    lines += ["[limits.acceleration]", *(f"{kind.name} = {ACCELERATION_RAD_S2}" for kind in kinds)]
    lines += ["[limits.jerk]", *(f"{kind.name} = {JERK_RAD_S3}" for kind in kinds)]
    for key in ("velocity", "effort"):
        over = [(kind.name, getattr(kind, key)) for kind in kinds if getattr(kind, key) is not None]
        if over:
            lines += [
                f"[limits.{key}]   # over the URDF's",
                *(f"{name} = {_number(value)}" for name, value in over),
            ]
    if bounds:
        lines += ["[limits.position]   # of joints that turn without end"]
        lines += [f"{_key(name)} = {text}" for name, text in bounds.items()]
    return "\n".join(lines) + "\n"


def _gains(draft: Draft) -> str:
    lines = ["[gains]   # stiffness Nm/rad, damping Nm s/rad, armature kg m^2"]
    lines += [
        f"{kind.name} = {{ stiffness = {_number(kind.stiffness)}, damping = {_number(kind.damping)}, "
        f"armature = {_number(kind.armature)} }}"
        for kind in draft.kinds
    ]
    lines += ["", "[gains.members]   # which joints are which, by regular expression"]
    lines += [f"{kind.name} = {json.dumps('|'.join(map(re.escape, kind.joints)))}" for kind in draft.kinds]
    return "\n".join(lines) + "\n"


def _hands(draft: Draft) -> str:
    lines = [
        "[hand]   # they reach; [gripper] in its place describes hands that grasp",
        'base_link = "palm_{hand}"',
        f"cannot_grasp = {json.dumps(CANNOT_GRASP)}",
        "[hand.tcp]   # x along the approach, y along the opening",
        'frame = "tcp_{hand}"',
    ]
    lines += [f"{side} = {{ {', '.join(_place(hand.link_T_tcp))} }}" for side, hand in draft.hands.items()]
    frames = [_frame(f"palm_{side}", hand.link, np.eye(4)) for side, hand in draft.hands.items()]
    return "\n".join([*lines, "", *frames])


def _soles(draft: Draft) -> Iterable[str]:
    for side, sole in draft.soles.items():
        yield (
            f'[[sole]]\nside = "{side}"\nframe = "{side}_sole"\nlink = {json.dumps(sole.link)}\n'
            f"x_m = [{', '.join(map(_number, sole.x_m))}]\ny_m = [{', '.join(map(_number, sole.y_m))}]\n"
            "thickness_m = 0.02\n"
        )


def _camera(eyes: Eyes | None) -> str:
    if eyes is None:
        return "# No camera was found: a robot without [camera] plans, and is given no tasks.\n"
    frame = ""
    if eyes.link is not None and eyes.link_T_frame is not None:
        frame = _frame(eyes.frame, eyes.link, eyes.link_T_frame) + "\n"
    lines = [
        "[camera]",
        f"frame = {json.dumps(eyes.frame)}",
        f"horizontal_fov_rad = {_FIELDS[0]}",
        f"vertical_fov_rad = {_FIELDS[1]}",
        "range_m = [0.2, 6.0]",
    ]
    if eyes.pan is not None and eyes.tilt is not None:
        lines += [f"pan_joint = {json.dumps(eyes.pan)}", f"tilt_joint = {json.dumps(eyes.tilt)}"]
    return frame + "\n".join(lines) + "\n"


def _frame(name: str, link: str, place: Array) -> str:
    lines = ["[[frame]]", f"name = {json.dumps(name)}", f"link = {json.dumps(link)}", *_place(place)]
    return "\n".join(lines) + "\n"


def _box(box: BoxAround) -> str:
    lines = ["[[collision]]", f"link = {json.dumps(box.link)}"]
    lines.append(f"size_m = [{', '.join(map(_number, box.size_m))}]")
    lines.append(f"xyz = [{', '.join(map(_number, box.xyz))}]")
    lines += [f"{key} = true" for key, so in (("drawn", box.drawn), ("instead", box.instead)) if so]
    return "\n".join(lines) + "\n"


def _place(place: Array) -> list[str]:
    xyz, rpy = place[:3, 3], _rpy(place[:3, :3])
    return [f"xyz = [{', '.join(map(_number, xyz))}]", f"rpy = [{', '.join(map(_exact, rpy))}]"]


def _rpy(r: Array) -> tuple[float, float, float]:
    """Roll, pitch, yaw about fixed axes of a rotation."""
    pitch = math.atan2(-r[2, 0], math.hypot(r[0, 0], r[1, 0]))
    if math.hypot(r[0, 0], r[1, 0]) < 1e-9:
        roll, yaw = math.atan2(-r[1, 2], r[1, 1]), 0.0
    else:
        roll, yaw = math.atan2(r[2, 1], r[2, 2]), math.atan2(r[1, 0], r[0, 0])
    return roll, pitch, yaw


def _table(name: str, values: Mapping[str, float], what: str) -> str:
    if not values and name != "home":
        return ""
    return f"[{name}]   # {what}\n" + "".join(
        f"{_key(key)} = {_number(value)}\n" for key, value in values.items()
    )


def _list(names: Iterable[str]) -> str:
    return f"[{', '.join(json.dumps(name) for name in names)}]"


def _key(name: str) -> str:
    return name if re.fullmatch(r"[A-Za-z0-9_-]+", name) else json.dumps(name)


def _number(value: float) -> str:
    return repr(round(float(value), 5) + 0.0)


def _exact(value: float) -> str:
    return repr(round(float(value), 12) + 0.0)
