"""The behavior tree: what one tick costs, planning aside, during a real pick."""

from __future__ import annotations

from executive.session.assembly import Assembly, assemble
from executive.understanding.command_parser import parse
from tools.benchmark.figures import Figure, figure, timed_s
from tools.evaluate.scenes import SENTENCE, pick_scene, read_episode_scene
from trees.build import build_tree
from trees.task_tree import TaskTree
from trees.tasks import Task
from trees.toolbox import Toolbox

_ROBOT = "talos"


class TickTimes:
    """Makes trees that time their ticks; its ``build`` is the assembly's."""

    def __init__(self) -> None:
        self.assembly: Assembly | None = None
        self.ticks_s: list[float] = []
        self.snapshots_s: list[float] = []

    def build(self, task: Task, toolbox: Toolbox) -> TaskTree:
        """The product's tree under a stop watch."""
        return _TimedTree(self, task, toolbox)


class _TimedTree(TaskTree):
    def __init__(self, times: TickTimes, task: Task, toolbox: Toolbox) -> None:
        super().__init__(task, build_tree(task, toolbox).root, toolbox)
        self._times = times

    def tick(self) -> None:
        assert self._times.assembly is not None
        planning = self._times.assembly.planning
        planned_s = planning.wall_s
        seconds = timed_s(super().tick)
        # an answer that is computed at once, because nothing runs beside, is not the tree's work
        if planning.wall_s == planned_s:
            self._times.ticks_s.append(seconds)
            self._times.snapshots_s.append(timed_s(lambda: self.snapshot(0.0)))


def tick(quick: bool) -> list[Figure]:
    """Ticks of whole picks, and the snapshot of the tree that a display or a log takes after each."""
    times = TickTimes()
    for seed in range(1 if quick else 10):
        scene = read_episode_scene(pick_scene(seed), seed)
        times.assembly = assemble(_ROBOT, scene, seed, build=times.build)
        (command,) = parse(SENTENCE).commands
        times.assembly.session.run_task(command)
    return [
        figure("tick, us", [1e6 * s for s in times.ticks_s]),
        figure("snapshot of the tree, us", [1e6 * s for s in times.snapshots_s]),
    ]
