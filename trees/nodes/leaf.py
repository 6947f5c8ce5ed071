"""The one life cycle that every leaf has."""

from __future__ import annotations

import traceback
from collections.abc import Mapping
from pathlib import Path
from typing import Any, ClassVar, Self

from py_trees.behaviour import Behaviour
from py_trees.blackboard import Blackboard, Client
from py_trees.common import Status
from py_trees.ports import NoDataAvailable, PortInformation

from trees.events import LeafFailed, Measured, NotSo
from trees.failures import Failure, FailureKind, Number
from trees.nodes.contract import Contract
from trees.nodes.judgements import place_of
from trees.nodes.leaf_settings import settings_of
from trees.nodes.ports import WithPorts
from trees.toolbox import Toolbox

RUNNING = Status.RUNNING
DONE = Status.SUCCESS


class Leaf(WithPorts, Behaviour):
    """A behavior that does one thing.

    A subclass declares ``INPUT_PORTS``, ``OUTPUT_PORTS`` and ``CONTRACT``, and fills in ``begin``, ``step``
    and ``release``. This class does the rest. It holds the deadline on the injected clock, turns an exception
    into a failure, notes the place of a failure in the tree, puts out events, and calls ``release`` when the
    leaf ends in any way but success, so that nothing that it started goes on.

    Attributes:
        ASKS: Whether the leaf only asks if something is so. That it is not so is then an answer (``NotSo``),
            and is not told to people as a failure.
        failure: Why it failed or was cancelled, since its last start; None otherwise.
        halt_reason: The reason that a halt is reported with; whoever halts the tree sets it.
        wiring: The key of the blackboard that each port is connected to, by the port's name. A port that is
            left out is connected to the key of its own name.
    """

    INPUT_PORTS: dict[str, PortInformation]
    OUTPUT_PORTS: dict[str, PortInformation]
    CONTRACT: ClassVar[Contract]
    ASKS: ClassVar[bool] = False
    _made_with: tuple[tuple[Any, ...], Mapping[str, Any]]
    _namespace: str | None
    _unconnected: str | None

    def __new__(cls, *arguments: Any, **named: Any) -> Self:
        """Note what it is made with, so that a tree can be written down and made again."""
        leaf = super().__new__(cls)
        leaf._made_with = arguments, named
        return leaf

    def __init__(self, name: str, toolbox: Toolbox, wiring: Mapping[str, str] | None = None) -> None:
        super().__init__(name=name)
        self.toolbox = toolbox
        self.wiring = dict(wiring or {})
        self.failure: Failure | None = None
        self.halt_reason = "halted"
        self._started_s = self._paused_before_s = 0.0
        self._start_error: Exception | None = None
        self._namespace = self._unconnected = None
        self._keys: dict[str, str] = {}

    # what a leaf fills in

    def begin(self) -> None:
        """Start anew: called once before the first ``step`` of each run."""

    def step(self) -> Status | Failure:
        """One tick: ``RUNNING``, ``DONE``, or why it failed.

        Raises:
            Exception: Anything; it becomes this leaf's failure.
        """
        raise NotImplementedError

    def release(self, reason: str) -> None:
        """Stop and give back whatever was started; called after a failure and on a halt."""

    @property
    def deadline_s(self) -> float:
        """Seconds from the start after which it has failed."""
        return self.CONTRACT.deadline_s

    @property
    def settings(self) -> Mapping[str, Any]:
        """What it was made with, beside name, toolbox and wiring, by the names of the arguments."""
        return settings_of(type(self), *self._made_with)

    # what a leaf may use

    @property
    def elapsed_s(self) -> float:
        """Seconds on the injected clock since this run began, pauses left out."""
        paused_s = self.toolbox.pauses.total_s - self._paused_before_s
        return self.toolbox.clock.now_s() - self._started_s - paused_s

    @property
    def where(self) -> str:
        """Its place in the tree."""
        return place_of(self)

    def optional(self, port: str) -> Any | None:
        """The value of an input port, or None when nobody has written it yet."""
        try:
            return self.get_input(port)
        except NoDataAvailable:
            return None

    def measured(self, **numbers: Number) -> None:
        """Tell what was measured."""
        self.toolbox.events(Measured(self.toolbox.clock.now_s(), self.where, numbers))

    def wire(self, namespace: str) -> None:
        """Note in which namespace of a tree the ports are to be.

        They are connected when the leaf first uses one: of a skill's leaves most never do, because they are
        for what seldom goes wrong, and connecting all of them was a third of the time to build a tree.
        """
        self._namespace = self._unconnected = namespace
        self._keys.clear()

    # py_trees' side

    def get_input(self, port_name: str, default: Any = None) -> Any:
        """The value of an input port; see py_trees, which is asked about all that is not as it should be.

        It goes to the storage four times and connects the leaf to it first, which takes thirty times as long.
        """
        port = self.INPUT_PORTS.get(port_name)
        if port is not None and self._namespace is not None:
            value = Blackboard.storage.get(self._key_of(port_name, self._namespace))
            if value is not None and isinstance(port.data_type, type) and isinstance(value, port.data_type):
                return value
        return super().get_input(port_name, default)

    def _key_of(self, port_name: str, namespace: str) -> str:
        if port_name not in self._keys:
            wired = self.wiring.get(port_name, port_name)
            self._keys[port_name] = Blackboard.absolute_name(namespace, wired)
        return self._keys[port_name]

    @property
    def blackboard_client(self) -> Client:
        """The tree's storage, as the ports see it; they are connected to it now, if they were not before."""
        namespace, self._unconnected = self._unconnected, None
        if namespace is not None:
            ports = [*self.INPUT_PORTS, *self.OUTPUT_PORTS]
            self.setup_ports({port: self.wiring.get(port, port) for port in ports}, namespace)
        return super().blackboard_client

    def initialise(self) -> None:
        """Start the run; an exception is kept for ``update`` to report."""
        self.failure = None
        self._start_error = None
        self._started_s = self.toolbox.clock.now_s()
        self._paused_before_s = self.toolbox.pauses.total_s
        self.feedback_message = ""
        try:
            self.begin()
        except Exception as error:
            self._start_error = error

    def update(self) -> Status:
        """Run one tick, with every exception contained."""
        try:
            if self._start_error is not None:
                raise self._start_error
            outcome = self.step()
            if outcome is RUNNING and self.elapsed_s > self.deadline_s:
                outcome = Failure.timeout(
                    f"{self.name} took longer than its deadline",
                    deadline_s=self.deadline_s,
                    elapsed_s=self.elapsed_s,
                )
        except Exception as error:
            outcome = from_exception(error)
        if isinstance(outcome, Failure):
            self.failure = outcome if outcome.where else outcome.at(self.where)
            self.feedback_message = outcome.message
            answered = self.ASKS and outcome.kind is FailureKind.POSTCONDITION
            told = NotSo if answered else LeafFailed
            self.toolbox.events(told(self.toolbox.clock.now_s(), self.failure))
            return Status.FAILURE
        return outcome

    def terminate(self, new_status: Status) -> None:
        """Release what was started, unless the leaf succeeded or had ended before."""
        halted = new_status is Status.INVALID and self.status is RUNNING
        if halted:
            self.failure = Failure(FailureKind.CANCELED, self.halt_reason, where=self.where)
        if not halted and new_status is not Status.FAILURE:
            return
        try:
            self.release(self.halt_reason if halted else self.feedback_message)
        except Exception as error:
            self.failure = from_exception(error, cause=self.failure).at(self.where)
            self.toolbox.events(LeafFailed(self.toolbox.clock.now_s(), self.failure))


def from_exception(error: Exception, cause: Failure | None = None) -> Failure:
    """Turn an exception into a failure that names it and the line that raised it."""
    frames = traceback.extract_tb(error.__traceback__)
    raised_at = f"{Path(frames[-1].filename).name}:{frames[-1].lineno}" if frames else "unknown"
    what = str(error) or "no message"
    return Failure.error(
        f"{type(error).__name__}: {what}", cause, exception=type(error).__name__, raised_at=raised_at
    )


def rewired(tree: Behaviour, keys: Mapping[str, str]) -> Behaviour:
    """Connect ports of every leaf of a subtree to other keys, where it has them under their own names.

    Args:
        tree: Made, and not wired yet.
        keys: Port name to key.
    """
    for node in tree.iterate():
        if isinstance(node, Leaf):
            ports = {*node.INPUT_PORTS, *node.OUTPUT_PORTS}
            for port, key in keys.items():
                if port in ports and port not in node.wiring:
                    node.wiring[port] = key
    return tree
