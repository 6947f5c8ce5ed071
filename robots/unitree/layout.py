"""Topics and bytes of ``unitree_hg`` low-level messages, and their check sum.

In memory a message is the C struct that the check sum is made of: CRC-32/MPEG-2 over the words of all but
the last, each word taken from its high byte down. On the wire (little-endian CDR) structs are not aligned,
only their fields: the first motor's mode stands right behind what is before it, and a word of padding is not
there. Layout and sum are those of Unitree's SDK.
"""

from __future__ import annotations

import zlib

import numpy as np
from numpy.typing import NDArray

from kinematics.model.robot_description import Hand

MOTORS = 35
"""Places for motors in a message; a robot uses the first of them."""

_MOTOR_COMMAND = np.dtype(
    [
        ("mode", "u1"),
        ("_pad", "u1", 3),
        ("q", "<f4"),
        ("dq", "<f4"),
        ("tau", "<f4"),
        ("kp", "<f4"),
        ("kd", "<f4"),
        ("reserve", "<u4"),
    ]
)
LOW_COMMAND = np.dtype(
    [
        ("mode_pr", "u1"),
        ("mode_machine", "u1"),
        ("_pad", "u1", 2),
        ("motor", _MOTOR_COMMAND, MOTORS),
        ("reserve", "<u4", 4),
        ("crc", "<u4"),
    ]
)
"""``LowCmd_``: what each motor is to do."""

_MOTOR_STATE = np.dtype(
    [
        ("mode", "u1"),
        ("_pad", "u1", 3),
        ("q", "<f4"),
        ("dq", "<f4"),
        ("ddq", "<f4"),
        ("tau_est", "<f4"),
        ("temperature", "<i2", 2),
        ("vol", "<f4"),
        ("sensor", "<u4", 2),
        ("motorstate", "<u4"),
        ("reserve", "<u4", 4),
    ]
)
_IMU = np.dtype(
    [
        ("quaternion", "<f4", 4),
        ("gyroscope", "<f4", 3),
        ("accelerometer", "<f4", 3),
        ("rpy", "<f4", 3),
        ("temperature", "<i2"),
        ("_pad", "u1", 2),
    ]
)
LOW_STATE = np.dtype(
    [
        ("version", "<u4", 2),
        ("mode_pr", "u1"),
        ("mode_machine", "u1"),
        ("_pad", "u1", 2),
        ("tick", "<u4"),
        ("imu", _IMU),
        ("motor", _MOTOR_STATE, MOTORS),
        ("wireless_remote", "u1", 40),
        ("reserve", "<u4", 4),
        ("crc", "<u4"),
    ]
)
"""``LowState_``: what motors and IMU sense, and the remote's buttons."""

HAND_MOTORS = 7
"""Motors of a Dex3."""
HAND_COMMAND = np.dtype(
    [("count", "<u4"), ("motor", _MOTOR_COMMAND, HAND_MOTORS), ("reserve", "<u4", 4)],
)
"""``HandCmd_``; ``count`` is the length of its sequence, which DDS writes. It has no check sum."""
HAND_STATE = np.dtype([("count", "<u4"), ("motor", _MOTOR_STATE, HAND_MOTORS)])
"""What is read of ``HandState_``; behind it come pressures, IMU and voltages, which nobody here asks."""
_HAND_REST = 4 + _IMU.itemsize + 4 * 4 + 2 * 4 + 2 * 4
"""Bytes of the rest of ``HandState_`` without any pressures."""

COMMANDS, ARMS, STATES = "rt/lowcmd", "rt/arm_sdk", "rt/lowstate"
"""Topics of the body."""


def hand_commands(hand: Hand) -> str:
    """The topic of a hand's commands."""
    return f"rt/dex3/{hand}/cmd"


def hand_states(hand: Hand) -> str:
    """The topic of a hand's states."""
    return f"rt/dex3/{hand}/state"


Record = NDArray[np.void]
"""One message, shape ()."""

_REVERSED = bytes(int(f"{value:08b}"[::-1], 2) for value in range(256))
_WORD = 4
_PADDED = 2
"""Bytes of padding before the motors, of both messages."""


def empty(kind: np.dtype[np.void]) -> Record:
    """A message of zeros."""
    message = np.zeros((), dtype=kind)
    if kind in (HAND_COMMAND, HAND_STATE):
        message["count"] = HAND_MOTORS
    return message


def crc_of(data: bytes) -> int:
    """CRC-32/MPEG-2 of bytes.

    It is the mirror image of zlib's, without the last inversion.
    """
    mirrored = zlib.crc32(data.translate(_REVERSED)) ^ 0xFFFFFFFF
    return int(f"{mirrored:032b}"[::-1], 2)


def sum_of(message: Record) -> int:
    """The check sum that a message ought to have."""
    words = np.frombuffer(message.tobytes()[:-_WORD], dtype="<u4")
    return crc_of(words.byteswap().tobytes())


def seal(message: Record) -> None:
    """Put the check sum into a message."""
    message["crc"] = sum_of(message)


def is_whole(message: Record) -> bool:
    """Whether a message has the check sum that it ought to have."""
    return int(message["crc"]) == sum_of(message)


def to_wire(message: Record) -> bytes:
    """A message as CDR has it, without its head."""
    data = message.tobytes()
    if message.dtype == HAND_COMMAND:
        return data
    if message.dtype == HAND_STATE:
        return data + bytes(_HAND_REST)
    before, mode = _before_motors(message.dtype)
    return data[:before] + data[mode : mode + 1] + bytes(-(before + 1) % _WORD) + data[mode + _WORD :]


def from_wire(data: bytes, kind: np.dtype[np.void]) -> Record | None:
    """The message that some bytes of CDR are, without their head; None when they are not as many.

    Of a hand's state what is behind its motors is left away: how many pressures it tells depends on the hand.
    """
    if kind in (HAND_COMMAND, HAND_STATE):
        found = record_of(data[: kind.itemsize] if kind == HAND_STATE else data, kind)
        return found if found is not None and int(found["count"]) == HAND_MOTORS else None
    before, mode = _before_motors(kind)
    behind = before + 1 + -(before + 1) % _WORD
    body = data[behind : behind + kind.itemsize - mode - _WORD]
    head = data[:before] + bytes(mode - before) + data[before : before + 1] + bytes(_WORD - 1)
    return record_of(head + body, kind)


def _before_motors(kind: np.dtype[np.void]) -> tuple[int, int]:
    """Where what is before the motors ends without padding, and where the first motor's mode is in memory."""
    mode = int(kind.fields["motor"][1]) if kind.fields is not None else 0
    return mode - _PADDED, mode


def record_of(data: bytes, kind: np.dtype[np.void]) -> Record | None:
    """The message that some bytes are; None when they are not as many."""
    return np.frombuffer(data, dtype=kind)[0].copy() if len(data) == kind.itemsize else None
