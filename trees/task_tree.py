"""One task's tree: tick it, halt it, ask it how things stand."""

from __future__ import annotations

from dataclasses import replace
from itertools import compress
from operator import attrgetter, is_not
from typing import Any, Literal

from py_trees.behaviour import Behaviour
from py_trees.blackboard import Blackboard
from py_trees.common import Status

from trees.beliefs.grounding.destination import Place, called
from trees.beliefs.grounding.report_words import numbered
from trees.events import LeafFailed, NodeChanged
from trees.failures import Failure, FailureKind, Number
from trees.nodes.judgements import failure_of, place_of
from trees.nodes.leaf import Leaf, from_exception
from trees.nodes.retry import Retry
from trees.nodes.snapshot_of import snapshot_of, status_word
from trees.port_values import Target
from trees.registry import skill_of
from trees.skill import Need
from trees.snapshot import TreeSnapshot
from trees.tasks import ObjectDescription, Task
from trees.toolbox import Toolbox

# of two hundred nodes at each tick: a loop of its own would take as long as ticking them
_STATUS = attrgetter("status")


class TaskTree:
    """The behavior tree of one task while it is carried out; ``tick`` never raises and never waits.

    Attributes:
        task: What it does.
        root: The tree's root; for drawing, not for ticking.
        status: "running" until it has ended, then "success" or "failure".
        failure: Why it failed or was halted, the whole chain; None otherwise.
        evidence: What the robot measured that proves the success; empty before.
        acted_on: Name in the planning scene of the object that it was about, or of what was opened or closed;
            None before one was chosen.
        others: Names of further objects that the task means, for trees of their own.
    """

    def __init__(self, task: Task, root: Behaviour, toolbox: Toolbox) -> None:
        self.task = task
        self.root = root
        self.status: Literal["running", "success", "failure"] = "running"
        self.failure: Failure | None = None
        self.evidence: dict[str, Number] = {}
        self.acted_on: str | None = None
        self.others: tuple[str, ...] = ()
        self._toolbox = toolbox
        self._ticks = 0
        self._nodes = list(root.iterate())
        self._told = [Status.INVALID] * len(self._nodes)
        # unique while the process lives; it never shows in any output
        self._namespace = f"/task_{root.id.hex}"
        for node in self._nodes:
            wire = getattr(node, "wire", None)
            if wire is not None:
                wire(self._namespace)
        Blackboard.set(f"{self._namespace}/task", task)

    @property
    def attempts(self) -> int:
        """Attempts begun; 1 for a task that is not tried again."""
        counts = [node.attempts for node in self._nodes if isinstance(node, Retry)]
        return max(counts, default=1)

    @property
    def leaf_places(self) -> frozenset[str]:
        """Where its leaves are, as events name them; branches may bear the name of one of their leaves."""
        return frozenset(place_of(node) for node in self._nodes if isinstance(node, Leaf))

    def tick(self) -> None:
        """Let every running node do a little; does nothing after the end."""
        if self.status != "running":
            return
        if self._ticks == 0:
            self._toolbox.world.begin_task()
        self._ticks += 1
        try:
            for _ in self.root.tick():
                pass
        except Exception as error:  # leaves contain their own; this is for the nodes between them
            self._end_with(from_exception(error).at(self.root.name), f"defect: {error}")
            return
        self._tell_changes()
        if self.root.status is Status.SUCCESS:
            self._succeed()
        elif self.root.status is not Status.RUNNING:
            why = failure_of(self.root) or Failure.error("it failed without a reason")
            self._fail(self._summary(why))

    def halt(self, reason: str) -> None:
        """Stop at once: whatever moves brakes and holds. Does nothing after the end."""
        if self.status != "running":
            return
        running = [node for node in self._nodes if isinstance(node, Leaf) and node.status is Status.RUNNING]
        where = place_of(running[0]) if running else self.root.name
        self._end_with(Failure(FailureKind.CANCELED, reason, where=where), reason)

    def snapshot(self, t_s: float) -> TreeSnapshot:
        """The whole tree as plain values."""
        return TreeSnapshot(t_s, self._ticks, snapshot_of(self.root))

    def _succeed(self) -> None:
        self.evidence = dict(self._written("evidence") or {})
        self.status = "success"
        self._forget()

    def _fail(self, failure: Failure) -> None:
        self.failure = failure
        self.status = "failure"
        self._forget()

    def _end_with(self, failure: Failure, reason: str) -> None:
        """End from outside: every running leaf is terminated, which stops what it moves."""
        for node in self._nodes:
            if isinstance(node, Leaf):
                node.halt_reason = reason
        try:
            self.root.stop(Status.INVALID)
        except Exception as error:
            failure = from_exception(error, cause=failure).at(self.root.name)
        self._toolbox.events(LeafFailed(self._toolbox.clock.now_s(), failure))
        self._tell_changes()
        self._fail(failure)

    def _summary(self, why: Failure) -> Failure:
        """The top of the chain, with what the hands still hold."""
        numbers: dict[str, Number] = {"attempts": self.attempts}
        held = self._held()
        if held:
            numbers["still_held"] = held
        message = f"could not {_verb(self.task)}: {why.message}" + (f"; {held}" if held else "")
        return Failure(why.kind, message, numbers, self.root.name, why, why.reason)

    def _held(self) -> str:
        hands = [hand for hand, gripper in self._toolbox.grippers.items() if gripper.reading().holding]
        return " and ".join(f"the {hand} hand still holds something" for hand in hands)

    def _tell_changes(self) -> None:
        """Tell of each node whose status is another one than it was when this was last asked."""
        statuses = list(map(_STATUS, self._nodes))
        if statuses == self._told:
            return
        now_s = self._toolbox.clock.now_s()
        for node in compress(self._nodes, map(is_not, statuses, self._told)):
            message = node.feedback_message
            self._toolbox.events(NodeChanged(now_s, place_of(node), status_word(node), message))
        self._told = statuses

    def _written(self, port: str) -> Any | None:
        """What some leaf wrote to a port, or None."""
        key = f"{self._namespace}/{port}"
        return Blackboard.get(key) if Blackboard.exists(key) else None

    def _was_taken(self, name: str) -> bool:
        """Whether a hand has a thing, or had it in this task; others a task that failed has not touched."""
        world = self._toolbox.world
        return name in world.taken_from or name in world.scene.attached

    def _forget(self) -> None:
        """Keep what it was about; give the ports' storage back, so that a long session does not fill up."""
        done, target = self.status == "success", self._written("target")
        if isinstance(target, Target):
            self.acted_on = target.name
            if done or self._was_taken(target.name):
                self._toolbox.world.last_acted_on = target.name
            self.others = tuple(self._written("others") or ())
        place, skill = self._written("place"), skill_of(self.task)
        if skill is not None and Need.LEGS in skill.needs:
            self._toolbox.world.sent_to = None
            if done and isinstance(place, Place) and place.category == "furniture":
                self._toolbox.world.sent_to = place.name
        if done and skill is not None and skill.about is not None:
            self.acted_on = skill.about(self._written) or self.acted_on
        for table in (Blackboard.storage, Blackboard.metadata):
            for key in [key for key in table if key.startswith(f"{self._namespace}/")]:
                del table[key]
        for node in self._nodes:
            for client in node.blackboards:
                Blackboard.clients.pop(client.id(), None)


def _verb(task: Task) -> str:
    """What could not be done: "pick up the red cup", "walk to the kitchen"."""
    skill = skill_of(task)
    verb = task.action.replace("_", " ") if skill is None else skill.words
    thing = getattr(task, "object", None)
    count = getattr(task, "count", 1)
    if isinstance(thing, ObjectDescription) and count != 1:
        return f"{verb} {numbered(str(replace(thing, relation=None)), count)}"
    if thing is not None:
        return f"{verb} the {thing}"
    aims = (getattr(task, slot, None) for slot in ("to", "person"))
    aim = next(filter(None, aims), None)
    if aim is None:
        return verb
    said = "it" if hasattr(task, "words") else ""
    toward = "" if skill is None else skill.toward
    person, to = getattr(task, "person", None), getattr(task, "to", None)
    if person is not None and to is not None:
        return " ".join(word for word in (verb, toward, called(person), "to", called(to)) if word)
    return " ".join(word for word in (verb, said, toward, called(aim)) if word)
