"""What a robot behind the wire has to keep to: it stands, and each failure has its declared consequence.

    python -m tools.unitree.bars --stand 600 --json FILE

The control loop runs against the referee in one process, with 2 ms of delay and a lost percent each way. It
stands freely for a time; in a harness each failure comes once: it has to be told as what it is, followed by
what ``robots.unitree.watch`` declares, and after a reset nothing may jump. Picks and walks over the same wire
are suites: ``python -m tools.evaluate pick --robot g1 --scene low_tabletop --wire``, ``walk_to``.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from kinematics.model.robot_model import RobotModel
from robots.clock import ManualClock
from robots.control.loop.control_loop import ControlLoop
from robots.control.loop.emergency_stop import PersonsReset
from robots.interface.hardware import RobotData
from robots.models.description import load_robot
from robots.unitree.watch import FOLLOWS, Consequence, Trouble
from tools.unitree.over_the_wire import DELAY_S, LOSS, over_the_wire, wired
from tools.unitree.referee import PERIOD_S, WireFault, empty_world

JUMP_RAD = 0.01
"""Between two commands that are followed, at most: 5 rad/s."""
_UP_S, _TAKEN_UP_S = 0.5, 2.2
_FAULTS = (
    ("cable pulled for 20 ms", "silent", 0.03, Trouble.LATE),
    ("cable pulled for 0.1 s", "silent", 0.12, Trouble.SILENT),
    ("cable pulled for 1 s", "silent", 1.1, Trouble.LOST),
    ("wrong check sums", "garbled", 0.05, Trouble.GARBLED),
    ("wrong mode", "mode", 0.05, Trouble.WRONG_MODE),
    ("a motor's error", "motor", 0.05, Trouble.MOTOR_ERROR),
    ("a hand's cable pulled", "hand", 0.2, Trouble.HAND_SILENT),
)


@dataclass(frozen=True, slots=True)
class Trial:
    """How one of them went.

    Attributes:
        name: What was done.
        kept: Whether it kept to what is declared.
        told: Numbers, for people.
    """

    name: str
    kept: bool
    told: str


def standing(robot: RobotData, seconds: float, seed: int) -> Trial:
    """Stand freely for a time."""
    world, clock = empty_world(robot, seed), ManualClock()
    loop = ControlLoop(over_the_wire(world, clock, seed), RobotModel(robot.description), clock, _nobody)
    begun_m, still = world.truth.world_T_base()[:3, 3].copy(), 0
    periods = round(seconds / PERIOD_S)
    for _ in range(periods):
        loop.step()
        still += loop.emergency is None and not loop.defects
        if world.truth.fallen():
            break
    moved_m = float(np.linalg.norm(world.truth.world_T_base()[:3, 3] - begun_m))
    fallen = world.truth.fallen()
    well = f"well {100.0 * still / periods:.1f} % of the time"
    told = f"fallen: {fallen}, base moved by {1e3 * moved_m:.0f} mm, {well}"
    return Trial(f"stands for {seconds:g} s", not fallen and still == periods, told)


def failing(robot: RobotData, name: str, kind: str, for_s: float, trouble: Trouble, seed: int) -> Trial:
    """Let one thing fail in a harness, reset, and look at what was told, done and followed."""
    world, clock = empty_world(robot, seed), ManualClock()
    fault = WireFault(kind, _TAKEN_UP_S, for_s)
    body, referee = wired(world, clock, held=True, faults=(fault,), delay_s=DELAY_S, loss=LOSS, seed=seed)
    loop = ControlLoop(body, RobotModel(robot.description), clock, _nobody)
    seen: set[Trouble] = set()
    damped = False
    for _ in range(round((_TAKEN_UP_S + for_s + _UP_S) / PERIOD_S)):
        loop.step()
        seen |= {one.trouble for one in body.findings}
        damped |= clock.now_s() > _TAKEN_UP_S and not referee.stiff
    follows, before = FOLLOWS[trouble], referee.stiff
    stopped = loop.emergency is not None
    refused = loop.reset(PersonsReset("bars")) if stopped else None
    fastest = 0.0
    for _ in range(round((_TAKEN_UP_S + _UP_S) / PERIOD_S)):
        loop.step()
        fastest = max(fastest, float(np.abs(referee.motors.v).max()))
    wanted = {
        "told": trouble in seen,
        "stop": stopped is (follows is not Consequence.NONE),
        "damped": damped is (follows in (Consequence.DAMP, Consequence.DAMP_UNTIL_RESET)),
        "until reset": before is (follows is not Consequence.DAMP_UNTIL_RESET),
        "reset": refused is None and loop.emergency is None and referee.stiff,
        "no jump": referee.jump_rad <= JUMP_RAD,
    }
    wrong = ", ".join(name for name, so in wanted.items() if not so)
    told = f"{follows.value}; jump {referee.jump_rad:.4f} rad, fastest afterwards {fastest:.2f} rad/s"
    return Trial(name, not wrong, f"{told}; not kept: {wrong} {refused or ''}" if wrong else told)


def _nobody(_event: object) -> None:
    """Events are for others."""


def main(words: Sequence[str] | None = None) -> int:
    """Run all of them; 0 when all are kept."""
    parser = argparse.ArgumentParser(
        prog="tools.unitree.bars", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--robot", default="g1")
    parser.add_argument(
        "--stand", type=float, default=600.0, metavar="S", help="stand for so long; 0 does not"
    )
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--json", type=Path, metavar="FILE", help="write what came of it here")
    chosen = parser.parse_args(words)
    robot, trials = load_robot(chosen.robot), []
    for name, kind, for_s, trouble in _FAULTS:
        trials.append(failing(robot, name, kind, for_s, trouble, chosen.seed))
        _tell(trials[-1])
    if chosen.stand > 0.0:
        trials.append(standing(robot, chosen.stand, chosen.seed))
        _tell(trials[-1])
    if chosen.json is not None:
        chosen.json.write_text(json.dumps([asdict(trial) for trial in trials], indent=1) + "\n")
    return 0 if all(trial.kept for trial in trials) else 1


def _tell(trial: Trial) -> None:
    print(f"{'kept' if trial.kept else 'NOT KEPT'}  {trial.name}: {trial.told}", flush=True)


if __name__ == "__main__":
    raise SystemExit(main())
