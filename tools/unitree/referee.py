"""A robot on the wire that is none: MuJoCo behind Unitree's low-level interface, on this machine.

    python -m tools.unitree.referee --hung --fault silent:3:0.2 --delay-ms 2 --loss 0.01

It knows nothing of who controls it: commands are believed when their check sum and mode are right, each motor
follows its own servo's law, states go out every 2 ms with noise. Commands come late and some are lost; states
too. A command that stays away for 0.1 s leaves the motors without effort, as a robot does.

Faults are told as ``kind:from_s:for_s``: ``silent`` sends no states, ``garbled`` sends wrong sums, ``mode``
another mode, ``motor`` an error of motor 3, ``stop`` the remote's L2 and B.
"""

from __future__ import annotations

import argparse
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from robots.clock import WallClock
from robots.models.description import load_robot
from robots.scenes.scene_description import SceneDescription
from robots.simulated.body.motor_side import MotorSide
from robots.simulated.world import build_world
from robots.unitree.layout import LOW_STATE, Record, empty, is_whole, seal
from robots.unitree.motors import motors_of

PERIOD_S = 0.002
MACHINE = 5
KINDS = ("silent", "garbled", "mode", "motor", "stop")
_SERVO = ("q", "dq", "tau", "kp", "kd")
_FORGOTTEN_S = 0.1
_SICK_MOTOR, _CODE = 3, 17
_NOISE_RAD, _NOISE_RAD_S = 1e-4, 2e-3
_L2_AND_B = 1 << 5 | 1 << 9


@dataclass(frozen=True, slots=True)
class WireFault:
    """Something that goes wrong on purpose.

    Attributes:
        kind: One of ``KINDS``.
        from_s: When it begins.
        for_s: How long it lasts.
    """

    kind: str
    from_s: float
    for_s: float

    @classmethod
    def parse(cls, text: str) -> WireFault:
        """Read ``kind:from_s:for_s``.

        Raises:
            ValueError: It is none; the message tells what is expected.
        """
        kind, *times = text.split(":")
        if kind not in KINDS or len(times) != 2:
            raise ValueError(
                f"{text!r} is no fault; expected KIND:FROM_S:FOR_S with one of {', '.join(KINDS)}"
            )
        return cls(kind, float(times[0]), float(times[1]))


class End(Protocol):
    """The robot's end of a wire."""

    def send(self, message: Record) -> None:
        """Send a state."""
        ...

    def received(self) -> list[Record]:
        """Commands that have come."""
        ...


class Referee:
    """The robot on the wire; one call of ``step`` is 2 ms.

    Attributes:
        motors: Its motors and joints.
        jump_rad: The largest step between the positions of two commands that it followed with stiffness.
        refused: Commands with a wrong sum or mode.
    """

    def __init__(
        self,
        robot: str,
        end: End,
        *,
        hung: bool = False,
        delay_s: float = 0.0,
        loss: float = 0.0,
        faults: tuple[WireFault, ...] = (),
        seed: int = 0,
    ) -> None:
        """Stand up in an empty world.

        Args:
            robot: Name of a robot, or its folder.
            end: The robot's end of the wire.
            hung: Whether it hangs in a harness.
            delay_s: Commands come so late, and states.
            loss: Share of the messages that is lost, each way.
            faults: What goes wrong.
            seed: Of noise and loss.
        """
        data = load_robot(robot)
        self._rng = np.random.default_rng(seed)
        world = build_world(data, SceneDescription("empty"), np.random.default_rng(seed), drawn=False)
        self._world = world
        self._slots = motors_of(data.description.joints)
        self._end, self._loss, self._faults = end, loss, faults
        late = round(delay_s / PERIOD_S)
        self._coming: deque[list[Record]] = deque([[] for _ in range(late)])
        self._going: deque[Record | None] = deque([None] * late)
        self._command: Record | None = None
        self._followed = np.zeros(len(self._slots))
        self._stiff = False
        self._commanded_s, self._t_s, self._tick = 0.0, 0.0, 0
        self.motors = MotorSide(world.physics, hung=hung)
        self.jump_rad, self.refused = 0.0, 0

    @property
    def fallen(self) -> bool:
        """Whether the robot lies."""
        return self._world.truth.fallen()

    @property
    def stiff(self) -> bool:
        """Whether the last command asked for stiffness."""
        return self._stiff

    def step(self) -> None:
        """Take what has come, let the motors follow for a period, and send a state."""
        self._coming.append([one for one in self._end.received() if self._rng.random() >= self._loss])
        for command in self._coming.popleft():
            if not is_whole(command) or int(command["mode_machine"]) != MACHINE:
                self.refused += 1
                continue
            self._take(command)
        n = len(self._slots)
        values = [np.zeros(n)] * 5
        if self._command is not None and self._t_s - self._commanded_s <= _FORGOTTEN_S:
            motor = self._command["motor"][self._slots]
            on = motor["mode"] == 1
            values = [
                np.where(on, motor[key], 0.0).astype(np.float64) for key in ("q", "dq", "tau", "kp", "kd")
            ]
        self.motors.step(values[0], values[1], values[2], values[3], values[4], PERIOD_S)
        self._t_s += PERIOD_S
        self._going.append(self._state())
        state = self._going.popleft()
        if state is not None and self._rng.random() >= self._loss:
            self._end.send(state)

    def _take(self, command: Record) -> None:
        motor = command["motor"][self._slots]
        stiff, was = bool((motor["kp"] > 0.0).any()), self._stiff
        q = motor["q"].astype(np.float64)
        if stiff and was:
            self.jump_rad = max(self.jump_rad, float(np.abs(q - self._followed).max()))
        self._command, self._commanded_s, self._followed, self._stiff = command, self._t_s, q, stiff

    def _state(self) -> Record | None:
        now = {one.kind for one in self._faults if one.from_s <= self._t_s < one.from_s + one.for_s}
        if "silent" in now:
            return None
        state, n = empty(LOW_STATE), len(self._slots)
        self._tick += 1
        state["tick"], state["mode_machine"] = self._tick, MACHINE + ("mode" in now)
        motor = state["motor"]
        motor["q"][self._slots] = self.motors.q + self._rng.normal(0.0, _NOISE_RAD, n)
        motor["dq"][self._slots] = self.motors.v + self._rng.normal(0.0, _NOISE_RAD_S, n)
        motor["tau_est"][self._slots] = self.motors.effort
        motor["temperature"][self._slots] = 40
        state["imu"]["gyroscope"], state["imu"]["accelerometer"] = self.motors.imu()
        if "motor" in now:
            motor["motorstate"][_SICK_MOTOR] = _CODE
        if "stop" in now:
            state["wireless_remote"][2:4] = np.frombuffer(np.uint16(_L2_AND_B).tobytes(), dtype=np.uint8)
        seal(state)
        if "garbled" in now:
            state["crc"] ^= 1
        return state


def serve(referee: Referee, clock: WallClock, goes_on: Callable[[], bool]) -> None:
    """Step a referee in real time, for as long as it is to go on; late periods are caught up."""
    due_s = clock.now_s()
    while goes_on():
        referee.step()
        due_s = max(due_s + PERIOD_S, clock.now_s() - 0.05)
        clock.sleep(due_s - clock.now_s())


def main() -> None:
    """Serve until it is told to end, or for a time."""
    parser = argparse.ArgumentParser(
        prog="tools.unitree.referee",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--robot", default="g1")
    parser.add_argument("--domain", type=int, default=0)
    parser.add_argument("--interface", default="lo")
    parser.add_argument("--hung", action="store_true", help="it hangs in a harness that carries it")
    parser.add_argument("--arms", action="store_true", help="take commands of arm_sdk")
    parser.add_argument("--delay-ms", type=float, default=0.0)
    parser.add_argument("--loss", type=float, default=0.0)
    parser.add_argument("--fault", action="append", default=[], type=WireFault.parse)
    parser.add_argument("--seconds", type=float, default=float("inf"))
    parser.add_argument("--seed", type=int, default=0)
    chosen = parser.parse_args()
    from robots.unitree.dds import robot_end

    referee = Referee(
        chosen.robot,
        robot_end(chosen.domain, chosen.interface, arms_only=chosen.arms),
        hung=chosen.hung,
        delay_s=0.001 * chosen.delay_ms,
        loss=chosen.loss,
        faults=tuple(chosen.fault),
        seed=chosen.seed,
    )
    clock = WallClock()
    print("listening", flush=True)
    serve(referee, clock, lambda: clock.now_s() < chosen.seconds)
    print(f"largest jump {referee.jump_rad:.4f} rad, {referee.refused} refused, fallen: {referee.fallen}")


if __name__ == "__main__":
    main()
