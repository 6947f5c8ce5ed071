"""The sensors' readings with the configuration that was estimated from them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robots.interface import RobotState


@dataclass(frozen=True, slots=True)
class SensedState:
    """What the robot knows about itself at one instant.

    Attributes:
        readings: The sensors' readings.
        q: Estimated configuration of the planning model, shape (nq,): base pose in the odometry
            frame from encoders, IMU and stance feet, then the encoders' joint positions.
    """

    readings: RobotState
    q: NDArray[np.float64]
