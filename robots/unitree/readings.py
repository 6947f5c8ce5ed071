"""What a state on the wire tells, as the control loop reads it."""

from __future__ import annotations

import numpy as np

from robots.interface.robot import RobotState
from robots.unitree.layout import Record
from robots.unitree.motors import Motors

_BUTTONS = slice(2, 4)
_NAMES = (
    "R1",
    "L1",
    "start",
    "select",
    "R2",
    "L2",
    "F1",
    "F2",
    "A",
    "B",
    "X",
    "Y",
    "up",
    "right",
    "down",
    "left",
)
"""By bit, as the remote tells them."""
STOP = frozenset({"L2", "B"})
"""Pressed together they damp the maker's own controllers; here they engage the emergency stop."""


def readings_of(state: Record, motors: Motors, stamp_s: float, age_s: float) -> RobotState:
    """The readings that a state tells.

    Args:
        state: The message.
        motors: The motor of each joint, shape (n,).
        stamp_s: The time now.
        age_s: How old the state is.
    """
    motor = state["motor"][motors]
    return RobotState(
        stamp_s=stamp_s,
        q=motor["q"].astype(np.float64),
        v=motor["dq"].astype(np.float64),
        effort=motor["tau_est"].astype(np.float64),
        gyro=state["imu"]["gyroscope"].astype(np.float64),
        accelerometer=state["imu"]["accelerometer"].astype(np.float64),
        foot_wrench=np.empty((0, 6)),
        age_s=age_s,
        temperature_c=motor["temperature"].max(axis=1).astype(np.float64),
        motor_error=motor["motorstate"].astype(np.float64),
    )


def pressed(state: Record) -> frozenset[str]:
    """Buttons of the remote that are pressed."""
    bits = int(state["wireless_remote"][_BUTTONS].view("<u2")[0])
    return frozenset(name for k, name in enumerate(_NAMES) if bits >> k & 1)
