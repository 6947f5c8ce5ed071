"""Planning: every request of real picks in random scenes, timed where it is answered."""

from __future__ import annotations

from collections import defaultdict

from executive.session.assembly import Assembly, assemble
from executive.session.events import Event, PlanningAnswered
from executive.understanding.command_parser import parse
from tools.benchmark.figures import Figure, figure
from tools.evaluate.scenes import SENTENCE, pick_scene, read_episode_scene

_ROBOT = "talos"


class AnswerTimes:
    """Splits the planning service's wall time by kind of request; its ``take`` is the session's sink."""

    def __init__(self) -> None:
        self.assembly: Assembly | None = None
        self.seconds: dict[str, list[float]] = defaultdict(list)
        self._before_s = 0.0

    def take(self, event: Event) -> None:
        """Take an event; an answer is told right after it was found."""
        if isinstance(event, PlanningAnswered) and self.assembly is not None:
            now_s = self.assembly.planning.wall_s
            self.seconds[event.request].append(now_s - self._before_s)
            self._before_s = now_s


def planning(quick: bool) -> list[Figure]:
    """Wall time of each kind of request, and of everything that one pick asks for."""
    by_kind: dict[str, list[float]] = defaultdict(list)
    whole: list[float] = []
    for seed in range(4 if quick else 30):
        times = AnswerTimes()
        times.assembly = assemble(_ROBOT, read_episode_scene(pick_scene(seed), seed), seed, sink=times.take)
        (command,) = parse(SENTENCE).commands
        result = times.assembly.session.run_task(command)
        for kind, seconds in times.seconds.items():
            by_kind[kind] += seconds
        if result.outcome == "done" and result.attempts == 1:
            whole.append(result.times.planning_wall_s)
    figures = [figure(f"{kind}, ms", [1e3 * s for s in values]) for kind, values in sorted(by_kind.items())]
    if whole:
        figures.insert(0, figure("one pick: everything planned and checked, ms", [1e3 * s for s in whole]))
    return figures
