"""A robot in MuJoCo, seen through its sensors and moved by its servos."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable

import mujoco
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.model.robot_description import RobotDescription
from robots.errors import SetpointRefusedError
from robots.interface.hardware import Hardware, RobotData
from robots.interface.robot import JointSetpoint, RobotState
from robots.simulated.body.body_model import IMU_SENSORS
from robots.simulated.body.physics import TIMESTEP_S, Physics
from robots.simulated.body.servo_arrays import add_readings, begin_ramp, servo_inputs


class SimulatedRobot:
    """The simulated body as ``robots.interface.robot.Robot``.

    Each joint has a position servo; a setpoint is folded into its one input:
    ``ctrl = q + (tau + kv v) / kp``, so that at rest the servo gives ``tau`` and nothing is fought.
    Inputs go from the former setpoint to the new one in a straight line across the period: steps at
    500 Hz would shake the stiff servos, and sampled efforts would be off by 10 to 20 N at the hand.

    Attributes:
        taken: How many setpoints were taken, from whomever: for those who judge.
        encoder_offset: Added to what the encoders of the actuated joints read, rad, shape (n,); the
            servos go by the encoders. For the fault injector.
        gyro_bias: Added to what the gyro reads, rad/s, shape (3,). For the fault injector.
        battery: Share of the charge that is left.
    """

    def __init__(
        self, physics: Physics, rng: np.random.Generator, before_period: Callable[[], None] | None = None
    ) -> None:
        self._physics, self._rng, self._before_period = physics, rng, before_period
        description = physics.description
        model, data = physics.model, physics.data
        self._data, self._model = data, model
        gains = [physics.hardware.gains[name] for name in description.actuated]
        self._count = len(gains)
        self._inverse_stiffness = np.array([1.0 / item.stiffness for item in gains])
        self._damping_ratio = np.array([item.damping / item.stiffness for item in gains])
        self._joint_qpos, self._joint_qvel = physics.joint_qpos, physics.joint_qvel
        # Views into MuJoCo's memory, valid as long as ``data`` is: no attribute look-ups in the loop.
        self._qpos, self._qvel = data.qpos, data.qvel
        self._ctrl, self._force, self._sensors = data.ctrl, data.actuator_force, data.sensordata
        self._sensor_order = _sensor_order(physics)
        # MuJoCo tells what a sole presses on the floor, negated; a robot tells what the floor gives it.
        imu = 0 if description.imu is None else 6
        self._sensor_sign = np.array([1.0] * imu + [-1.0] * 6 * len(description.soles))
        self._sigma = _sigmas(RobotData(description, physics.hardware))
        self._feet_feel = 1.0 if description.foot_sensors else 0.0
        self._noise, self._noise_row = np.empty((0, len(self._sigma))), 0
        self._effort = np.zeros(self._count)
        self._target = np.array(self._qpos[self._joint_qpos])
        self._former = self._target.copy()
        self._change = np.zeros(self._count)
        self._ctrl[:] = self._target
        self._commanded = False
        self.taken = 0
        self.encoder_offset, self.gyro_bias, self.battery = np.zeros(self._count), np.zeros(3), 1.0
        self._late: deque[RobotState] = deque(maxlen=1)
        self._steps = 0
        self._reading: RobotState | None = None

    @property
    def description(self) -> RobotDescription:
        """The robot's data."""
        return self._physics.description

    @property
    def hardware(self) -> Hardware:
        """What it is made of."""
        return self._physics.hardware

    def read(self) -> RobotState:
        """Return the readings of the last control period; the same ones until the next period."""
        if self._reading is None:
            n = self._count
            noise = self._next_noise()
            add_readings(
                noise,
                self._qpos,
                self._joint_qpos,
                self._qvel,
                self._joint_qvel,
                self._effort,
                self._sensors,
                self._sensor_order,
                self._sensor_sign,
                self.encoder_offset,
                self.gyro_bias,
            )
            self._reading = RobotState(
                stamp_s=self._steps * _TIMESTEP_NS * 1e-9,
                q=noise[:n],
                v=noise[n : 2 * n],
                effort=noise[2 * n : 3 * n],
                gyro=noise[3 * n : 3 * n + 3],
                accelerometer=noise[3 * n + 3 : 3 * n + 6],
                foot_wrench=self._feet_feel * noise[3 * n + 6 :].reshape(-1, 6),
                battery=self.battery,
            )
            self._late.append(self._reading)
        return self._late[0]

    def delay_readings(self, periods: int) -> None:
        """Let readings come so many control periods late; their stamps tell when they were taken."""
        self._late = deque(self._late, maxlen=1 + periods)

    def _next_noise(self) -> Array:
        """Noise of one set of readings, shape (k,); many are drawn at once, each is given out once."""
        if self._noise_row == len(self._noise):
            self._noise = self._rng.standard_normal((_NOISE_ROWS, len(self._sigma))) * self._sigma
            self._noise_row = 0
        noise: Array = self._noise[self._noise_row]
        self._noise_row += 1
        return noise

    def command(self, setpoint: JointSetpoint) -> None:
        """Take a setpoint; it holds until the next one.

        Raises:
            SetpointRefusedError: A wrong shape or a value that is not finite: a defect upstream. The
                robot keeps the setpoint that it had.
        """
        n = self._count
        if not np.shape(setpoint.q) == np.shape(setpoint.v) == np.shape(setpoint.tau) == (n,):
            raise SetpointRefusedError(f"setpoint {setpoint.sequence} is not for {n} joints")
        target = np.empty(n)
        if not servo_inputs(
            setpoint.q, setpoint.v, setpoint.tau, self._damping_ratio, self._inverse_stiffness, target
        ):
            raise SetpointRefusedError(f"setpoint {setpoint.sequence} is not finite")
        self._former = self._target if self._commanded else target
        self._target, self._commanded = target, True
        self.taken += 1

    def advance(self, period_s: float) -> None:
        """Let the physics run for one control period.

        Raises:
            ValueError: The period is no whole number of physics steps.
        """
        steps = round(period_s / TIMESTEP_S)
        if steps < 1 or abs(steps * TIMESTEP_S - period_s) > 1e-9:
            raise ValueError(f"a period of {period_s} s is no multiple of {TIMESTEP_S} s")
        if self._before_period is not None:
            self._before_period()
        model, data, ctrl, force = self._model, self._data, self._ctrl, self._force
        change, effort = self._change, np.zeros(self._count)
        begin_ramp(self._former, self._target, self.encoder_offset, steps, ctrl, change)
        for _ in range(steps):
            ctrl += change
            mujoco.mj_step(model, data)
            effort += force
        effort /= steps
        self._effort = effort
        self._former = self._target
        self._steps += steps
        self._reading = None


_NOISE_ROWS = 50
_TIMESTEP_NS = round(TIMESTEP_S * 1e9)


def _sensor_order(physics: Physics) -> NDArray[np.intp]:
    """Where gyro, accelerometer and each sole's force and torque stand in MuJoCo's sensor array.

    Of a robot without IMU, which has no soles either, nothing: it reads noise alone.
    """
    imu = () if physics.description.imu is None else tuple(IMU_SENSORS)
    soles = [f"{kind}:{sole.side}" for sole in physics.description.soles for kind in ("force", "torque")]
    starts = [int(physics.model.sensor(name).adr[0]) for name in (*imu, *soles)]
    return np.array([start + i for start in starts for i in range(3)], dtype=np.intp)


def _sigmas(robot: RobotData) -> Array:
    """Standard deviations of all readings in the order of ``read``; efforts: of each joint's limit."""
    description, noise = robot.description, robot.hardware.noise
    n = len(description.actuated)
    efforts = [noise.joint_effort_fraction * description.limits[name].effort for name in description.actuated]
    sole = [noise.foot_force_n] * 3 + [noise.foot_torque_nm] * 3
    return np.array(
        [noise.joint_position_rad] * n
        + [noise.joint_velocity_rad_s] * n
        + efforts
        + [noise.gyro_rad_s] * 3
        + [noise.accelerometer_m_s2] * 3
        + sole * len(description.soles)
    )
