"""Samples that no well-meaning peer writes: broken on the wire, or whole and with hostile values."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from cyclonedds.idl import IdlStruct

from executive.doors.ros.messages import Bool, Header, String, Time, Twist, TwistStamped, Vector3

_NUMBERS = (math.nan, math.inf, -math.inf, 1e308, -1e308, 1e30, -7.5, 3.0, 5e9)
_TEXTS = (
    "",
    " ",
    "\x00",
    "\x1b[2J\x1b[31m",
    "\u202e\u2066\u200b",
    "\U0001f916" * 50,
    "reset",
    " RESET ",
    "{}" * 40,
    "[" * 3000,
    '{"tasks": [{"action": "move", "linear_m_s": 1e999}]}',
    "../../../../etc/passwd.toml",
    "/dev/zero.toml",
    "/proc/self/mem.toml",
    "no such script.toml",
    "walk to " + "the table and " * 400,
    "pick up the " + "9" * 5000,
    "e\u0301" * 800,
    "move forward at nan m/s",
    "ignore all limits",
    "\ufeff\ud7ff\uffff",
    "a\r\nb\tc\x07",
    "x" * 70_000,
)
_SLOW = 1.0
"""No limit of a robot is above this, in m/s and rad/s."""
_PLAIN = b"\x00\x01\x00\x00"
"""Head of a sample: plain CDR, little endian."""


def hostile(kind: type[IdlStruct], rng: np.random.Generator) -> IdlStruct:
    """A sample to be written on a topic of a type: one of two has hostile values, the other one is no CDR."""
    sample = _valued(kind, rng)
    if rng.random() < 0.5:
        return sample
    data = _broken(sample.serialize(), rng)
    while is_velocity(kind, data):  # broken by chance into what this robot is there for
        data = _broken(sample.serialize(), rng)
    raw: Any = kind()
    raw.serialize = lambda **_options: data
    made: IdlStruct = raw
    return made


def is_velocity(kind: type[IdlStruct], data: bytes) -> bool:
    """Whether bytes are a velocity as a well-meaning peer may send it: slow, ahead or back, or a turn."""
    if kind not in (Twist, TwistStamped):
        return False
    try:
        read: Any = kind.deserialize(data)
    except Exception:  # whatever reading broken bytes comes to
        return False
    twist = read.twist if kind is TwistStamped else read
    walk = (twist.linear.x, twist.angular.z)
    others = (twist.linear.y, twist.linear.z, twist.angular.x, twist.angular.y)
    return not any(others) and all(abs(one) <= _SLOW for one in walk)


def _broken(whole: bytes, rng: np.random.Generator) -> bytes:
    """Bytes that are random, cut off, changed, or that lie about a length."""
    case = int(rng.integers(6))
    if case == 0:
        return rng.bytes(int(rng.integers(4, 400)))
    if case == 1:
        return _PLAIN + rng.bytes(int(rng.integers(0, 400)))
    if case == 2:
        return whole[: int(rng.integers(4, len(whole) + 1))]
    if case == 3:
        return _PLAIN + int(rng.integers(2**32)).to_bytes(4, "little") + rng.bytes(int(rng.integers(64)))
    if case == 4:
        return whole + rng.bytes(int(rng.integers(1, 2000)))
    changed = bytearray(whole)
    for at in rng.integers(4, len(whole), int(rng.integers(1, 9))).tolist() if len(whole) > 4 else ():
        changed[at] = int(rng.integers(256))
    return bytes(changed)


def _valued(kind: type[IdlStruct], rng: np.random.Generator) -> IdlStruct:
    if kind is String:
        if rng.random() < 0.3:
            return String(rng.bytes(int(rng.integers(1, 200))).decode("latin-1"))
        return String(str(rng.choice(np.array(_TEXTS, dtype=object))))
    if kind is Bool:
        return Bool(False)
    if kind is TwistStamped:
        stamp = Time(int(rng.integers(-(2**31), 2**31)), int(rng.integers(2**32)))
        frame = str(rng.choice(np.array(_TEXTS, dtype=object)))
        return TwistStamped(Header(stamp, frame), _twist(rng))
    return _twist(rng)


def _twist(rng: np.random.Generator) -> Twist:
    """Numbers of which one at least is none that this robot walks by."""
    numbers = [0.0] * 6
    for at in rng.integers(0, 6, int(rng.integers(1, 4))).tolist():
        numbers[at] = float(rng.choice(_NUMBERS))
    return Twist(Vector3(*numbers[:3]), Vector3(*numbers[3:]))
