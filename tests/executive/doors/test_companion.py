"""When a process beside a served robot is to end."""

from types import SimpleNamespace

from executive.doors.companion import LeftBehind


class Alone:
    """A process whose parent may go, with a clock that goes on by a second with each look."""

    def __init__(self, folder):
        self.parent, self.signals, self._now_s = 7, [], 0.0
        self.is_to_end = LeftBehind(
            folder, self.signals, lambda: self.parent, SimpleNamespace(now_s=self._later)
        )

    def _later(self):
        self._now_s += 1.0
        return self._now_s


def test_it_stays_while_the_robot_is_there_and_ends_with_it_where_nobody_is_left_to_end_it(served):
    beside = Alone(served.folder.path)
    beside.parent = 1
    assert not beside.is_to_end()

    served.close()
    assert beside.is_to_end()


def test_while_who_began_it_is_there_it_is_not_for_it_to_say(tmp_path):
    assert not Alone(tmp_path).is_to_end()


def test_a_signal_ends_it(tmp_path):
    beside = Alone(tmp_path)
    beside.signals.append(15)

    assert beside.is_to_end()
