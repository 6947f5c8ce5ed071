"""The wire over DDS: ``rt/lowcmd`` or ``rt/arm_sdk``, ``rt/lowstate``, and ``rt/dex3`` for each hand."""

from __future__ import annotations

import contextlib

from cyclonedds.core import DDSException, ReadCondition, SampleState, ViewState, WaitSet
from cyclonedds.core import InstanceState as Instances
from cyclonedds.domain import Domain, DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.pub import DataWriter
from cyclonedds.qos import Policy, Qos
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

from kinematics.model.robot_description import Hand
from robots.unitree.layout import ARMS, COMMANDS, STATES, Record, hand_commands, hand_states
from robots.unitree.messages import HandCommand, HandState, LowCommand, LowState, carried, carrying

LOOPBACK = "lo"
_MOST_TAKEN = 16
_NEWEST = Qos(Policy.Reliability.BestEffort, Policy.History.KeepLast(4))


def configuration(interface: str) -> str:
    """What Cyclone DDS is told about the network, as XML.

    Args:
        interface: Name of the network interface that the robot is on; "lo" is this machine alone.
    """
    network, peers = f'<NetworkInterface name="{interface}"/>', ""
    if interface == LOOPBACK:
        network = '<NetworkInterface address="127.0.0.1" multicast="true"/>'
        peers = '<Discovery><Peers><Peer address="127.0.0.1"/></Peers></Discovery>'
    general = f"<General><Interfaces>{network}</Interfaces></General>"
    return f"<CycloneDDS><Domain>{general}{peers}</Domain></CycloneDDS>"


class DdsEnd:
    """One end of the wire: one kind of message goes out, another comes in."""

    def __init__(
        self, domain: int, interface: str, out: tuple[str, type[IdlStruct]], into: tuple[str, type[IdlStruct]]
    ) -> None:
        """Join the network.

        Args:
            domain: Of DDS; 0 is a robot's.
            interface: Name of the network interface.
            out, into: Topic and type of what is sent and of what is received.
        """
        self._domain: Domain | None = None
        with contextlib.suppress(DDSException):  # one end in this process has it already
            self._domain = Domain(domain, configuration(interface))
        self._participant = DomainParticipant(domain)
        self._kind = out[1]
        self._writer = DataWriter(self._participant, Topic(self._participant, *out), qos=_NEWEST)
        self._reader = DataReader(self._participant, Topic(self._participant, *into), qos=_NEWEST)
        self._waiting = WaitSet(self._participant)
        mask = SampleState.NotRead | ViewState.Any | Instances.Any
        self._condition = ReadCondition(self._reader, mask)
        self._waiting.attach(self._condition)

    def send(self, message: Record) -> None:
        """Send a message; it is never waited for."""
        self._writer.write(carrying(self._kind, message))

    def received(self) -> list[Record]:
        """What has come since the last call, oldest first."""
        found = (carried(one) for one in self._reader.take(N=_MOST_TAKEN))
        return [record for record in found if record is not None]

    def wait(self, longest_s: float) -> None:
        """Wait for the next message, and no longer than so many seconds."""
        self._waiting.wait(duration(microseconds=max(1, round(longest_s * 1e6))))


def controller_end(domain: int = 0, interface: str = LOOPBACK, *, arms_only: bool = False) -> DdsEnd:
    """The end of who controls a robot."""
    topic = ARMS if arms_only else COMMANDS
    return DdsEnd(domain, interface, (topic, LowCommand), (STATES, LowState))


def robot_end(domain: int = 0, interface: str = LOOPBACK, *, arms_only: bool = False) -> DdsEnd:
    """The end of the robot, for who plays one."""
    topic = ARMS if arms_only else COMMANDS
    return DdsEnd(domain, interface, (STATES, LowState), (topic, LowCommand))


def controller_hand_end(hand: Hand, domain: int = 0, interface: str = LOOPBACK) -> DdsEnd:
    """The end of who controls a hand."""
    return DdsEnd(domain, interface, (hand_commands(hand), HandCommand), (hand_states(hand), HandState))


def robot_hand_end(hand: Hand, domain: int = 0, interface: str = LOOPBACK) -> DdsEnd:
    """The end of the hand, for who plays one."""
    return DdsEnd(domain, interface, (hand_states(hand), HandState), (hand_commands(hand), HandCommand))
