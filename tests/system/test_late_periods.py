"""A pick with control periods that begin late, on the simulated robot: nothing jumps, nothing is stopped."""

import numpy as np
import pytest

from executive.session.assembly import assemble
from executive.session.session import Session
from executive.understanding.command_parser import parse
from robots.control.events import HealthChanged, SetpointRefused, StopStarted
from robots.scenes.scene_file import load_scene


class LateLoop:
    """The control loop of a busy machine: most periods in time, some late by up to 87 ms."""

    def __init__(self, assembly, seed):
        self._loop, self._tick = assembly.loop, assembly.perception.tick
        self._rng = np.random.default_rng(seed)
        self.sensing = assembly.loop.sensing
        self.spikes = 0

    def step(self):
        draw = self._rng.random()
        missed = 0 if draw < 0.9 else int(self._rng.integers(1, 6))
        if draw > 0.993:
            missed = int(self._rng.integers(10, 44))
            self.spikes += not self._loop.motion.resting
        self._loop.catch_up(missed, self._tick)
        self._loop.step()


@pytest.mark.slow
@pytest.mark.requirement("F4", "S4")
def test_a_pick_on_a_busy_machine_is_done_without_a_jump_or_a_false_stop():
    events = []
    assembly = assemble("talos", load_scene("tabletop"), 3, sink=events.append)
    loop = LateLoop(assembly, 5)
    session = Session(
        assembly.session.toolbox,
        loop,
        assembly.planning,
        events.append,
        tick_sensors=assembly.perception.tick,
    )
    (command,) = parse("pick up the red cup").commands

    result = session.run_task(command)

    stops = [event for event in events if isinstance(event, StopStarted | SetpointRefused)]
    assert not stops, stops
    assert not [event for event in events if isinstance(event, HealthChanged) and event.response == "stop"]
    assert not assembly.world.truth.fallen()
    assert result.outcome == "done", result.failure
    assert loop.spikes >= 5
