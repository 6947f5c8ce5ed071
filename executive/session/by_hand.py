"""A task in a person's hands: jogged until it is given back, and what is so then is measured."""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import dataclass
from typing import Any, Protocol

from executive.manual.handed_back import HoldCheck, hand_of, note_held
from executive.manual.manual_control import ManualControl
from executive.manual.word_text import write_word
from executive.manual.words import ByHandTask, Ending, JogFeed, TakenOver
from executive.session.events import EventSink, InputTaken
from executive.session.task_result import Outcome
from trees.failures import Failure, FailureKind, Number
from trees.registry import skill_of
from trees.skill import After
from trees.toolbox import Toolbox


class _Ticks(Protocol):
    def tick(self, count: int = 1) -> None: ...


@dataclass(frozen=True, slots=True)
class GivenBack:
    """How a person gave a task back.

    Attributes:
        outcome: How the task has ended by it, or None where it goes on with its tree.
        failure: Why it was not done.
        evidence: What was measured.
        acted_on: What a hand holds now, as the scene names it, or None.
    """

    outcome: Outcome | None
    failure: Failure | None
    evidence: dict[str, Number]
    acted_on: str | None = None


class ByHand:
    """Lets a person carry on with tasks.

    Args:
        toolbox: What moves the robot.
        lockstep: Lets time pass.
        sink: Told when a person takes over, and what they say is so at the end.
        interruption: Why the request is over, or None.

    Attributes:
        feed: What the person says.
        offer: Asked after a failure whether a person takes over; nobody does when left out.
    """

    def __init__(
        self,
        toolbox: Toolbox,
        lockstep: _Ticks,
        sink: EventSink,
        interruption: Callable[[], Failure | None],
    ) -> None:
        self._toolbox, self._lockstep, self._sink = toolbox, lockstep, sink
        self._interruption = interruption
        self.feed = JogFeed()
        self.offer: Callable[[Failure], bool] | None = None
        self._noted = False
        self._said = (0, False)

    @property
    def asked(self) -> bool:
        """Whether a person wants what is under way."""
        return self.feed.asked

    def wants(self, outcome: Outcome, failure: Failure | None) -> bool:
        """Whether a person takes over a task that has ended so."""
        if self.feed.asked and outcome == "done":
            self.feed.asked = False  # it was done before the person had it
        if self.feed.asked:
            self.note_asked("in its middle")
            return True
        if outcome != "failed" or failure is None or self.offer is None:
            return False
        if self.offer(failure):
            self.take_over("after its failure")
        return self.feed.asked

    def take_over(self, when: TakenOver) -> None:
        """Let a person have what is under way."""
        self.feed.take_over()
        self.note_asked(when)

    def note_asked(self, when: TakenOver) -> None:
        """Tell that a person wants what is under way, once, at the instant at which it is known."""
        if not self._noted:
            self._noted = True
            self._sink(InputTaken(self._toolbox.clock.now_s(), "take_over", when))

    def steps(self, command: Any) -> Generator[None, object, GivenBack]:
        """Be jogged until the robot is given back, then measure what is said to be so."""
        feed = self.feed
        feed.asked, feed.active, self._noted = False, True, False
        try:
            ending = yield from self._jogged()
        finally:
            feed.active = False
        if isinstance(ending, Failure):
            return GivenBack("cancelled", ending, {})
        hand, alone = hand_of(ending), isinstance(command, ByHandTask)
        if hand is None and alone:
            return GivenBack("done", None, {})
        if hand is None:
            if ending == "go_on":
                return GivenBack(None, None, {})
            given_up = Failure(FailureKind.CANCELED, "a person took over, and gave it up")
            return GivenBack("cancelled", given_up, {})
        check = HoldCheck(self._toolbox, hand)
        while (found := check.tick()) is None:
            if (ended := self._interruption()) is not None:
                return GivenBack("cancelled", ended, {})
            self._lockstep.tick()
            yield
        if isinstance(found, Failure):
            return GivenBack("failed", found, {})
        name = note_held(self._toolbox, command, hand, float(found["gripper_opening_m"]))
        skill = skill_of(command)
        ends = alone or (skill is not None and After.THING_HELD in skill.after)
        return GivenBack("done" if ends else None, None, dict(found), name)

    def _jogged(self) -> Generator[None, object, Ending | Failure]:
        control, feed = ManualControl(self._toolbox, self.feed), self.feed
        while feed.ending is None:
            if (ended := self._interruption()) is not None:
                control.end()
                return ended
            self._note_said()
            control.tick()
            self._lockstep.tick()
            yield
        ending: Ending = feed.ending
        self._sink(InputTaken(self._toolbox.clock.now_s(), "hand_back", ending))
        while not control.at_rest:
            if (ended := self._interruption()) is not None:
                return ended
            control.end()
            self._lockstep.tick()
            yield
        return ending

    def _note_said(self) -> None:
        """Tell what the person has said since the last tick: with it a run can be repeated."""
        newest, may_touch = self.feed.newest, self.feed.may_touch
        said = (0 if newest is None else newest.number, may_touch)
        if said != self._said:
            self._said = said
            words = write_word(None if newest is None else newest.word, may_touch)
            self._sink(InputTaken(self._toolbox.clock.now_s(), "jog", words))
