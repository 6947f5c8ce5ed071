"""Control time waits for a commander that the machine keeps from running, for a while, and for no other."""

import os
from pathlib import Path

import pytest

from robots.live.process.hold_back import HOLD_AFTER_S, MOST_S, RAN_S, HoldBack, ProcessorUse, processor_use

PID = 7


class Machine:
    """Says of the commander what the test wants; its wall time passes while control time is held."""

    def __init__(self):
        self.t_s, self.wants, self.ran_s = 0.0, True, 3.0
        self.hold = HoldBack(self, self.use)

    def now_s(self):
        return self.t_s

    def use(self, pid):
        assert pid == PID
        return ProcessorUse(self.wants, self.ran_s)

    def silence(self, until_s, from_s=0.0):
        """Let a silence grow, in steps of a control period; gives where it was held first, or None."""
        silence_s = from_s
        while silence_s < until_s:
            if self.hold.wanted(PID, silence_s):
                return silence_s
            silence_s += 0.002
        return None


@pytest.mark.requirement("F4")
def test_a_commander_that_is_kept_from_running_is_waited_for():
    machine = Machine()

    assert machine.silence(1.0) == pytest.approx(HOLD_AFTER_S, abs=0.003)
    assert machine.hold.wanted(PID, HOLD_AFTER_S)


@pytest.mark.requirement("S3")
@pytest.mark.parametrize("hang", ["it sleeps", "it runs without end", "it has gone"])
def test_a_commander_that_hangs_is_not(hang):
    machine = Machine()
    machine.wants = hang != "it sleeps"
    if hang == "it has gone":
        machine.use = lambda _pid: None
        machine.hold = HoldBack(machine, machine.use)
    assert hang == "it has gone" or not machine.hold.wanted(PID, 0.2)

    if hang == "it runs without end":
        machine.ran_s += RAN_S + 0.01

    assert machine.silence(1.2, from_s=0.2) is None


@pytest.mark.requirement("S3")
def test_it_is_waited_for_no_longer_than_is_told():
    machine = Machine()
    held_at_s = machine.silence(1.0)
    machine.t_s += MOST_S - 0.01
    assert machine.hold.wanted(PID, held_at_s)

    machine.t_s += 0.02

    assert not machine.hold.wanted(PID, held_at_s)
    assert machine.silence(1.2, from_s=held_at_s) is None


@pytest.mark.requirement("F4")
def test_a_new_silence_is_waited_for_anew():
    machine = Machine()
    machine.silence(1.0)
    machine.t_s += 2.0 * MOST_S
    assert not machine.hold.wanted(PID, 0.6)

    assert not machine.hold.wanted(PID, 0.0)

    assert machine.silence(1.0) is not None


def test_the_kernel_is_asked_for_the_state_and_the_time_of_a_process(tmp_path):
    folder = tmp_path / "41"
    folder.mkdir()
    (folder / "stat").write_text("41 (a) b) R) D 1 2 3", "ascii")
    (folder / "schedstat").write_text("2500000000 17 3\n", "ascii")
    assert processor_use(41, tmp_path) == ProcessorUse(True, 2.5)

    (folder / "stat").write_text("41 (python) T 1 2 3", "ascii")
    assert processor_use(41, tmp_path) == ProcessorUse(False, 2.5)
    assert processor_use(42, tmp_path) is None


@pytest.mark.skipif(not Path("/proc/self/schedstat").exists(), reason="this kernel does not tell")
def test_this_process_wants_to_run():
    first = processor_use(os.getpid())
    assert first.wants_to_run
    assert first.ran_s > 0.0
