"""A robot on the wire that is none: MuJoCo behind Unitree's low-level interface, on this machine.

    python -m tools.unitree.referee --hung --fault silent:3:0.2 --delay-ms 2 --loss 0.01

It knows nothing of who controls it: commands are believed when their check sum and mode are right, each motor
follows its own servo's law, states go out every 2 ms with noise. Commands come late and some are lost; states
too. A command that stays away for 0.1 s leaves the motors without effort, as a robot does.

Its hands have topics of their own. Faults are told as ``kind:from_s:for_s``: ``silent`` sends no states at
all, ``garbled`` sends wrong sums, ``mode`` another mode, ``motor`` an error of motor 3, ``hand`` no states of
the left hand, ``stop`` the remote's L2 and B.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from executive.ending_signals import taken_by
from kinematics.model.robot_description import Hand
from robots.clock import WallClock
from robots.interface.hardware import RobotData
from robots.models.description import load_robot
from robots.scenes.scene_description import SceneDescription
from robots.simulated.body.motor_side import MotorSide
from robots.simulated.world import SimulatedWorld, build_world
from robots.unitree.layout import HAND_STATE, LOW_STATE, Record, empty, is_whole, seal
from robots.unitree.motors import Motors, hand_motors_of, motors_of
from tools.unitree.played_motors import SERVO, End, PlayedMotors

PERIOD_S = 0.002
MACHINE = 5
KINDS = ("silent", "garbled", "mode", "motor", "hand", "stop")
_BODY_ENABLED, _HAND_ENABLED = (0xFF, 1), (0x70, 0x10)
"""Bits of a motor's mode, and what they are when it follows."""
_SICK_MOTOR, _CODE = 3, 17
_NOISE_RAD, _NOISE_RAD_S = 1e-4, 2e-3
_CAUGHT_UP_S = 0.05
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


class Referee:
    """The robot on the wire; one call of ``step`` is 2 ms.

    Attributes:
        motors: Its motors and joints.
        refused: Commands with a wrong sum or mode.
    """

    def __init__(
        self,
        world: SimulatedWorld,
        end: End,
        hands: Mapping[Hand, End],
        *,
        hung: bool = False,
        held: bool = False,
        delay_s: float = 0.0,
        loss: float = 0.0,
        faults: tuple[WireFault, ...] = (),
        seed: int = 0,
    ) -> None:
        """Play the robot of a world.

        Args:
            world: Nobody else lets its time pass.
            end: The robot's end of the wire.
            hands: The ends of its hands.
            hung: Whether it is without weight.
            held: Whether a harness keeps its base where it is.
            delay_s: Commands come so late, and states.
            loss: Share of the messages that is lost, each way.
            faults: What goes wrong.
            seed: Of noise and loss.
        """
        self._rng = np.random.default_rng(seed)
        self._world, self._faults, description = world, faults, world.robot.description

        def played(at: End, joints: tuple[str, ...], slots: Motors, enabled: tuple[int, int]) -> PlayedMotors:
            columns = [description.actuated.index(name) for name in joints]
            late = round(delay_s / PERIOD_S)
            return PlayedMotors(at, columns, slots, enabled, late=late, loss=loss, rng=self._rng)

        joints = description.joints
        self._body = played(end, joints, motors_of(joints), _BODY_ENABLED)
        self._hands = {
            hand: played(hands[hand], one.joints, hand_motors_of(one.joints, hand), _HAND_ENABLED)
            for hand, one in description.grippers.items()
        }
        self._t_s, self._tick = 0.0, 0
        self.motors = MotorSide(world.physics, hung=hung, held=held)
        self.refused = 0

    @property
    def fallen(self) -> bool:
        """Whether the robot lies."""
        return self._world.truth.fallen()

    @property
    def stiff(self) -> bool:
        """Whether the last command of the body asked for stiffness."""
        return self._body.stiff

    @property
    def jump_rad(self) -> float:
        """The largest step between the positions of two commands that were followed with stiffness."""
        return max(one.jump_rad for one in (self._body, *self._hands.values()))

    def step(self) -> None:
        """Take what has come, let the motors follow for a period, and send states."""
        for command in self._body.commands():
            if is_whole(command) and int(command["mode_machine"]) == MACHINE:
                self._body.take(command, self._t_s)
            else:
                self.refused += 1
        servo = np.zeros((len(SERVO), len(self.motors.q)))
        for hand in self._hands.values():
            for command in hand.commands():
                hand.take(command, self._t_s)
            servo[:, hand.columns] = hand.servo(self._t_s)
        servo[:, self._body.columns] = self._body.servo(self._t_s)
        q, v, tau, kp, kd = servo
        self._world.before_period()
        self.motors.step(q, v, tau, kp, kd, PERIOD_S)
        self._t_s += PERIOD_S
        now = {one.kind for one in self._faults if one.from_s <= self._t_s < one.from_s + one.for_s}
        self._body.tell(None if "silent" in now else self._state(now))
        for name, hand in self._hands.items():
            silent = "silent" in now or ("hand" in now and name == "left")
            hand.tell(None if silent else self._sensed(empty(HAND_STATE), hand))

    def _sensed(self, state: Record, played: PlayedMotors) -> Record:
        """A state with what the motors sense, with noise."""
        motor, n = state["motor"], len(played.slots)
        motor["q"][played.slots] = self.motors.q[played.columns] + self._rng.normal(0.0, _NOISE_RAD, n)
        motor["dq"][played.slots] = self.motors.v[played.columns] + self._rng.normal(0.0, _NOISE_RAD_S, n)
        motor["tau_est"][played.slots] = self.motors.effort[played.columns]
        motor["temperature"][played.slots] = 40
        return state

    def _state(self, now: set[str]) -> Record:
        """The body's, with the faults of now."""
        self._tick += 1
        state = self._sensed(empty(LOW_STATE), self._body)
        state["tick"], state["mode_machine"] = self._tick, MACHINE + ("mode" in now)
        state["imu"]["gyroscope"], state["imu"]["accelerometer"] = self.motors.imu()
        if "motor" in now:
            state["motor"]["motorstate"][_SICK_MOTOR] = _CODE
        if "stop" in now:
            state["wireless_remote"][2:4] = np.frombuffer(np.uint16(_L2_AND_B).tobytes(), dtype=np.uint8)
        seal(state)
        if "garbled" in now:
            state["crc"] ^= 1
        return state


def empty_world(data: RobotData, seed: int) -> SimulatedWorld:
    """A robot that stands on a floor, with nothing else."""
    return build_world(data, SceneDescription("empty"), np.random.default_rng(seed), drawn=False)


def serve(referee: Referee, clock: WallClock, goes_on: Callable[[], bool]) -> float:
    """Step a referee in real time, for as long as it is to go on; late periods are caught up.

    Returns:
        How much time it has lost, s: of a delay, no more than 0.05 s is caught up.
    """
    due_s, lost_s = clock.now_s(), 0.0
    while goes_on():
        referee.step()
        due_s, earliest_s = due_s + PERIOD_S, clock.now_s() - _CAUGHT_UP_S
        lost_s += max(0.0, earliest_s - due_s)
        due_s = max(due_s, earliest_s)
        clock.sleep(due_s - clock.now_s())
    return lost_s


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
    parser.add_argument("--hung", action="store_true", help="it is without weight")
    parser.add_argument("--held", action="store_true", help="a harness keeps its pelvis where it is")
    parser.add_argument("--arms", action="store_true", help="take commands of arm_sdk")
    parser.add_argument("--delay-ms", type=float, default=0.0)
    parser.add_argument("--loss", type=float, default=0.0)
    parser.add_argument("--fault", action="append", default=[], type=WireFault.parse)
    parser.add_argument("--seconds", type=float, default=float("inf"))
    parser.add_argument("--seed", type=int, default=0)
    chosen = parser.parse_args()
    from robots.unitree.dds import robot_end, robot_hand_end

    network, data = (chosen.domain, chosen.interface), load_robot(chosen.robot)
    hands = data.description.grippers
    referee = Referee(
        empty_world(data, chosen.seed),
        robot_end(*network, arms_only=chosen.arms),
        {hand: robot_hand_end(hand, *network) for hand in hands},
        hung=chosen.hung,
        held=chosen.held,
        delay_s=0.001 * chosen.delay_ms,
        loss=chosen.loss,
        faults=tuple(chosen.fault),
        seed=chosen.seed,
    )
    clock = WallClock()
    print("listening", flush=True)
    ended: list[int] = []
    with taken_by(ended.append):
        lost_s = serve(referee, clock, lambda: clock.now_s() < chosen.seconds and not ended)
    print(f"largest jump {referee.jump_rad:.4f} rad, {referee.refused} refused, fallen: {referee.fallen}")
    if lost_s > 0.0:
        print(f"{lost_s:.3f} s lost: this machine did not keep up")


if __name__ == "__main__":
    main()
