"""Why something failed: typed, placed in the tree, with numbers for people and the failure that caused it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import Enum, unique
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kinematics.motion.verdict import Finding


class FailureKind(Enum):
    """What sort of failure it is.

    Attributes:
        INFEASIBLE: No plan exists or none was found, or a person has to say which thing is meant.
        UNSAFE: The trajectory checker refused a motion, which was not begun.
        REFUSED: The gate, the online checker or the state of the robot did not let a motion pass.
        EXECUTION: A motion was begun and did not end where it should.
        POSTCONDITION: What has to be true was measured not to be.
        TIMEOUT: It took longer than its deadline.
        CANCELED: Somebody halted it.
        ERROR: A behavior raised an exception, which is a defect of the program.
    """

    INFEASIBLE = "INFEASIBLE"
    UNSAFE = "UNSAFE"
    REFUSED = "REFUSED"
    EXECUTION = "EXECUTION"
    POSTCONDITION = "POSTCONDITION"
    TIMEOUT = "TIMEOUT"
    CANCELED = "CANCELED"
    ERROR = "ERROR"


@unique
class Reason(Enum):
    """Why it failed, as far as programs have to tell such failures of one kind apart.

    A member's value is its meaning, for people. Documents hold a member's name.
    """

    KIND_ONLY = "its kind says all that programs need to know"

    # looking for something
    NOT_SEEN = "no look showed what is meant; it may be where nobody has looked yet"
    LOST_FROM_VIEW = "the looks to the sides were to compare what is meant, and did not show it again"
    SEEN_FROM_AFAR = "what is meant was seen, but from too far away to see all that is on it"
    OUT_OF_VIEW = "what is meant is known from before, and is not in view now"
    MORE_LOOKS_NEEDED = "only looks to the sides as well can say which thing is meant"
    UNSURE = "something was seen that may be what is meant; a look from elsewhere may tell, or a person"
    SEVERAL_FIT = "several things fit; a person has to say which one is meant"
    CANNOT_SEE = "the camera gives no picture in which anything could be looked for"
    SEES_BADLY = "the camera's pictures tell less than usual; things may be missed"
    NOBODY_SEEN = "a look all around has shown no person"
    PERSON_LOST = "somebody who was followed or guided is out of sight"
    NO_FURNITURE_LEFT = "no furniture is left that was not looked at from nearby"
    NO_ROOMS_LEFT = "no room of the map is left that nobody has looked around in"
    NO_OUTLOOKS_LEFT = "nothing tall is left that nobody has looked behind"

    # planning, and the room that there is
    NO_GRASP = "no grasp of the thing or handle was found that a hand can come to"
    ON_FLOOR = "the thing is on the floor, where no hand takes anything"
    TOO_WIDE = "the thing is wider than any hand opens"
    NO_WAY_TO_SPOT = "there are free spots, and the hand comes to none of them with what it holds"
    CANNOT_WALK = "the robot cannot walk here"
    NO_ROOM = "there is not enough free floor to walk, stand or turn there"
    PERSON_TOO_FAR = "the person stands too far away to be handed something"
    STALE_PLAN = "the plan was made for a scene that is no longer believed"

    # moving, and what came of it
    NOT_FOLLOWED = "a joint did not come to where it was told to go"
    STUCK = "what the hand led did not give way"
    SLIPPED_OFF_STUCK = "the hand slid off a handle before what it pulled at could give way"
    SLIPPED = "a hand lost what it held"
    DROPPED = "what was let go was seen to have fallen"
    TAKEN_BY_ANOTHER = "what was let go was seen with somebody for whom it was not meant"
    SEEN_NOT_AS_ASKED = "it was seen not to be as the task asks, not only felt"

    # senses that do not agree
    CLOSED_ON_NOTHING = "the fingers closed on nothing where the camera shows the thing"
    FELT_OTHER_SIZE = "the fingers feel another size than the camera shows"
    FELT_ELSEWHERE = "the hand feels the thing elsewhere than the camera shows it"
    FELT_OTHER_HEIGHT = "the hand feels a top at another height than the camera shows it"
    FELT_IN_THE_WAY = "the arm met something where nothing is known to be"
    SEEN_TO_FLOAT = "what stands on a top is seen above it, or sunk in it"
    CAMERAS_DIFFER = "two cameras show one thing at different places"
    CAMERA_ASKEW = "what is level leans in the camera's pictures: it looks elsewhere than is believed"
    CAMERA_BLIND = "one camera shows nothing while another one shows things"
    MOVED_SINCE_LOOK = "the thing is seen elsewhere than the look before has shown it"
    GONE_SINCE_LOOK = "the thing is not seen any more where the look before has shown it"
    FRAMES_FROZEN = "the camera delivers the same picture again and again"
    FRAMES_STALE = "the camera delivers pictures that are too old"


DISAGREEMENTS = frozenset(
    {
        Reason.CLOSED_ON_NOTHING,
        Reason.FELT_OTHER_SIZE,
        Reason.FELT_ELSEWHERE,
        Reason.FELT_OTHER_HEIGHT,
        Reason.FELT_IN_THE_WAY,
        Reason.SEEN_TO_FLOAT,
        Reason.CAMERAS_DIFFER,
        Reason.CAMERA_ASKEW,
        Reason.CAMERA_BLIND,
        Reason.MOVED_SINCE_LOOK,
        Reason.GONE_SINCE_LOOK,
        Reason.FRAMES_FROZEN,
        Reason.FRAMES_STALE,
    }
)
"""Reasons that say that one sense, or one time, contradicts another."""

_UNSEEN = frozenset({Reason.NOT_SEEN, Reason.LOST_FROM_VIEW, Reason.SEEN_FROM_AFAR})


Number = float | int | str | bool

CHOICES_JOINED_BY = " | "
"""Between the words of several choices, where a failure's numbers tell them to people."""


@dataclass(frozen=True, slots=True)
class OpenChoice:
    """What a person has to choose from, where several things fit.

    Attributes:
        words: What people call each thing.
        names: The names that the planning scene has for them, in the same order; empty where it has none.
        slot: The task's slot that the choice fills in.
        unseen: How many of them this task has not seen: they may be gone by now.
        one_will_do: Whether nobody has to be asked where there is one choice alone.
    """

    words: tuple[str, ...]
    names: tuple[str, ...] = ()
    slot: str = "object"
    unseen: int = 0
    one_will_do: bool = False


@dataclass(frozen=True, slots=True)
class Failure:
    """One link of a failure chain: what failed, why, and which failure had caused it.

    Programs decide by its kind and reason, and take values from its typed fields. Its message and numbers are
    for people.

    Attributes:
        kind: What sort of failure.
        message: One sentence for people, without the names of the numbers.
        numbers: What was measured and what it had to be, for people; keys carry their unit.
        where: The place in the tree, as names from the root down, joined by "/"; the life cycle of leaves
            fills it in.
        cause: The failure that led to this one.
        reason: Which one of its kind, where that is told apart.
        open_choice: What a person has to choose from, when several things fit.
        finding: What the checker found first, when it refused a motion.
    """

    kind: FailureKind
    message: str
    numbers: Mapping[str, Number] = field(default_factory=dict)
    where: str = ""
    cause: Failure | None = None
    reason: Reason = Reason.KIND_ONLY
    open_choice: OpenChoice | None = None
    finding: Finding | None = None

    @classmethod
    def infeasible(cls, message: str, cause: Failure | None = None, **numbers: Number) -> Failure:
        """No plan or no grasp exists, or none was found."""
        return cls(FailureKind.INFEASIBLE, message, numbers, cause=cause)

    @classmethod
    def asking(cls, message: str, open_choice: OpenChoice) -> Failure:
        """Several things fit; the message is the question that a person has to answer."""
        words = open_choice.words
        return cls(
            FailureKind.INFEASIBLE,
            message,
            {"choices": CHOICES_JOINED_BY.join(words), "count": len(words)},
            reason=Reason.SEVERAL_FIT,
            open_choice=open_choice,
        )

    @classmethod
    def unsafe(
        cls,
        message: str,
        cause: Failure | None = None,
        *,
        finding: Finding | None = None,
        **numbers: Number,
    ) -> Failure:
        """The trajectory checker said no; the finding is the first that it made."""
        return cls(FailureKind.UNSAFE, message, numbers, cause=cause, finding=finding)

    @classmethod
    def refused(cls, message: str, cause: Failure | None = None, **numbers: Number) -> Failure:
        """The gate or the online checker stopped the motion."""
        return cls(FailureKind.REFUSED, message, numbers, cause=cause)

    @classmethod
    def execution(cls, message: str, cause: Failure | None = None, **numbers: Number) -> Failure:
        """The motion did not end where it should."""
        return cls(FailureKind.EXECUTION, message, numbers, cause=cause)

    @classmethod
    def postcondition(cls, message: str, cause: Failure | None = None, **numbers: Number) -> Failure:
        """What had to be true afterwards was measured not to be."""
        return cls(FailureKind.POSTCONDITION, message, numbers, cause=cause)

    @classmethod
    def timeout(cls, message: str, cause: Failure | None = None, **numbers: Number) -> Failure:
        """It took longer than its deadline."""
        return cls(FailureKind.TIMEOUT, message, numbers, cause=cause)

    @classmethod
    def error(cls, message: str, cause: Failure | None = None, **numbers: Number) -> Failure:
        """A defect: an exception in a behavior."""
        return cls(FailureKind.ERROR, message, numbers, cause=cause)

    def at(self, where: str) -> Failure:
        """The same failure with its place in the tree."""
        return replace(self, where=where)

    def because(self, reason: Reason) -> Failure:
        """The same failure, told apart from others of its kind."""
        return replace(self, reason=reason)

    def caused_by(self, cause: Failure | None) -> Failure:
        """The same failure with its cause."""
        return replace(self, cause=cause)

    @property
    def is_unseen(self) -> bool:
        """Whether the chain began with a look that did not show what is meant: it may be seen elsewhere."""
        return self.root.reason in _UNSEEN

    @property
    def choices(self) -> tuple[str, ...]:
        """What a person has to choose from, when several things fit; at the root of the chain."""
        return () if (choice := self.root.open_choice) is None else choice.words

    @property
    def choice_names(self) -> tuple[str, ...]:
        """The names that the planning scene has for the ``choices``, in the same order."""
        return () if (choice := self.root.open_choice) is None else choice.names

    @property
    def choice_slot(self) -> str:
        """The task's slot that a choice fills in."""
        return "object" if (choice := self.root.open_choice) is None else choice.slot

    @property
    def root(self) -> Failure:
        """The failure that began the chain."""
        root = self
        while root.cause is not None:
            root = root.cause
        return root

    def to_json(self) -> dict[str, Any]:
        """As the command-line contract writes a failure; a typed field that says nothing is left out."""
        typed: dict[str, Any] = {}
        if self.reason is not Reason.KIND_ONLY:
            typed["reason"] = self.reason.name
        if (choice := self.open_choice) is not None:
            typed["open_choice"] = {
                "words": list(choice.words),
                "names": list(choice.names),
                "slot": choice.slot,
                "unseen": choice.unseen,
                "one_will_do": choice.one_will_do,
            }
        if (finding := self.finding) is not None:
            typed["finding"] = {
                "kind": finding.kind.value,
                "t_s": finding.t_s,
                "subject": list(finding.subject),
                "value": finding.value,
                "limit": finding.limit,
                **({} if finding.place_m is None else {"place_m": [round(v, 4) for v in finding.place_m]}),
            }
        return {
            "kind": self.kind.value,
            "where": self.where,
            "message": self.message,
            "numbers": dict(self.numbers),
            **typed,
            "cause": None if self.cause is None else self.cause.to_json(),
        }
