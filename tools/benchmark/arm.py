"""Planning for an arm: the Panda in six kinds of scenes, side by side with the peers."""

from __future__ import annotations

import contextlib
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain
from pathlib import Path

import numpy as np

from kinematics.arrays import Array
from tools.benchmark.contest import Answer, ArmPlanner, Result, run_contest, standings
from tools.benchmark.own_arm_planner import OwnArmPlanner
from tools.benchmark.peers.environments import PeerEnvironment
from tools.benchmark.peers.peer_process import PeerProcess, peer_process
from tools.benchmark.problems.arm_judge import Arm, ArmJudge
from tools.benchmark.problems.families import FAMILIES
from tools.benchmark.problems.generator import problems
from tools.benchmark.problems.panda_files import RobotFiles, write_panda
from tools.benchmark.problems.problem import Problem
from tools.benchmark.report import Report, contest_figures

# A path must begin and end where it was asked to.
END_TOLERANCE_RAD = 1e-3
SEED = 0


@dataclass(frozen=True, slots=True)
class PeerEntry:
    """A peer as it takes part.

    Attributes:
        environment: Name of its environment.
        runner: Name of its script.
        step_rad: How finely it looks along an edge.
        remark: What to add to its name.
        slow: Whether it is left out of quick runs.
    """

    environment: str
    runner: str
    step_rad: float = 0.05
    remark: str = ""
    slow: bool = False


# The fastest of them take part twice: as documented, and so fine that nearly all of their paths are free,
# which is what this project's planner owes.
PEERS = (
    PeerEntry("roboplan", "plan_roboplan"),
    PeerEntry("roboplan", "plan_roboplan", 0.005, ", step 0.005"),
    PeerEntry("ompl", "plan_ompl"),
    PeerEntry("ompl", "plan_ompl", 0.005, ", step 0.005"),
    PeerEntry("pyroboplan", "plan_pyroboplan", slow=True),
)


class PeerPlanner:
    """A peer that plans in its own environment."""

    def __init__(self, process: PeerProcess, entry: PeerEntry, files: RobotFiles, budget_s: float) -> None:
        self.name = process.environment.version.replace("==", " ") + entry.remark
        self._process = process
        self._options = {"budget_s": budget_s, "step_rad": entry.step_rad}
        process.ask("load", urdf=str(files.urdf), srdf=str(files.srdf), seed=0)

    def plan(self, problem: Problem, seed: int) -> Answer:
        """Ask the peer."""
        answer = self._process.ask("plan", problem=problem.to_json(), seed=seed, **self._options)
        path = answer["path"]
        return Answer(
            path=None if path is None else np.array(path),
            set_up_s=answer["set_up_s"],
            plan_s=answer["plan_s"],
            shorten_s=answer["shorten_s"],
        )


class Referee:
    """Coal at 1/256 rad, which asks for the ends too."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def __call__(self, problem: Problem, path: Array) -> bool:
        """Tell whether a path leads from start to goal and is free."""
        ends = np.abs(path[0] - problem.start), np.abs(path[-1] - problem.goal)
        if float(np.max(ends)) > END_TOLERANCE_RAD:
            return False
        return ArmJudge(self._arm, problem.objects).path_is_free(path)


def arm(quick: bool, cache: Path, samples: int | None = None) -> Report:
    """The product's planner and every peer that is there, on 100 problems of each family (quick: 2)."""
    names = dict.fromkeys(entry.environment for entry in PEERS)
    missing = [name for name in names if not PeerEnvironment(name, cache).is_ready]
    count = samples or (2 if quick else 100)
    peers = [entry for entry in PEERS if not (quick and entry.slow)]
    found = standings(arm_contest(count, SEED, cache, ours=[OwnArmPlanner()], peers=peers))
    notes = [f"{name}: its environment is not there (python -m tools.benchmark.peers)" for name in missing]
    return Report("arm", quick, contest_figures("plan and shorten, ms", found), found, notes)


def arm_contest(
    count: int,
    seed: int,
    cache: Path,
    ours: Sequence[ArmPlanner] = (),
    peers: Sequence[PeerEntry] = PEERS,
    families: Sequence[str] = tuple(FAMILIES),
    budget_s: float = 10.0,
) -> list[Result]:
    """Let planners of this project and the peers whose environments are ready take turns.

    Args:
        count: Problems of each family.
        seed: Of the problems.
        cache: Folder with the peers' environments; the robot's files are written there too.
        ours: Planners of this project; the first one is what ratios are taken to.
        peers: Those that take part when their environment is ready.
        families: Which kinds of scenes.
        budget_s: Longest search a problem; a planner that needs more did not solve it.
    """
    files = write_panda(cache / "panda")
    arm = Arm(files)
    with contextlib.ExitStack() as stack:
        planners = list(ours)
        for entry in peers:
            environment = PeerEnvironment(entry.environment, cache)
            if environment.is_ready:
                process = stack.enter_context(peer_process(environment, entry.runner))
                planners.append(PeerPlanner(process, entry, files, budget_s))
        drawn = chain.from_iterable(problems(arm, family, count, seed) for family in families)
        return run_contest(planners, drawn, Referee(arm)) if planners else []
