"""Compiled arithmetic of a simulated robot: what its servos are given and what its sensors say."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled

Indices = NDArray[np.intp]


@compiled
def add_readings(
    row: Array,
    qpos: Array,
    qpos_of: Indices,
    qvel: Array,
    qvel_of: Indices,
    effort: Array,
    sensors: Array,
    sensor_of: Indices,
    sensor_sign: Array,
    encoder_offset: Array,
    gyro_bias: Array,
) -> None:
    """Add what the sensors see to their noise.

    Args:
        row: Noise, and the result: positions, velocities, efforts (n each), then the k other sensors.
        qpos, qvel: The simulator's state.
        qpos_of, qvel_of: Where the joints stand in it, shape (n,).
        effort: Shape (n,), Nm.
        sensors: The simulator's sensors.
        sensor_of, sensor_sign: Which of them, shape (k,), and what they are multiplied by; the gyro first.
        encoder_offset: Added to the positions, shape (n,), rad.
        gyro_bias: Shape (3,), rad/s.
    """
    n = effort.shape[0]
    for j in range(n):
        row[j] += qpos[qpos_of[j]] + encoder_offset[j]
        row[n + j] += qvel[qvel_of[j]]
        row[2 * n + j] += effort[j]
    for k in range(sensor_of.shape[0]):
        row[3 * n + k] += sensors[sensor_of[k]] * sensor_sign[k]
    for k in range(3):
        row[3 * n + k] += gyro_bias[k]


@compiled
def servo_inputs(
    q: Array, v: Array, tau: Array, damping_ratio: Array, inverse_stiffness: Array, inputs: Array
) -> bool:
    """Fold setpoints into the one input of each position servo.

    Args:
        q, v, tau: Setpoint, shape (n,) each.
        damping_ratio: Damping over stiffness of each servo, shape (n,), s.
        inverse_stiffness: Shape (n,), rad/Nm.
        inputs: Result, shape (n,), rad.

    Returns:
        Whether all of them are finite.
    """
    finite = True
    for j in range(q.shape[0]):
        inputs[j] = v[j] * damping_ratio[j] + tau[j] * inverse_stiffness[j] + q[j]
        finite &= math.isfinite(inputs[j])
    return finite


@compiled
def begin_ramp(
    former: Array, target: Array, encoder_offset: Array, steps: int, inputs: Array, change: Array
) -> None:
    """Put the servos' inputs where the last period left them, by their encoders.

    Args:
        former, target: Where the inputs were and where they go, shape (n,), rad.
        encoder_offset: What the encoders are wrong by, shape (n,), rad.
        steps: In so many steps.
        inputs: Result, shape (n,), rad.
        change: Result: what each step adds, shape (n,), rad.
    """
    for j in range(former.shape[0]):
        change[j] = (target[j] - former[j]) / steps
        inputs[j] = former[j] - encoder_offset[j]
