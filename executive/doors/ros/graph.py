"""A node of ROS 2 made of DDS: its readers and writers, and its place in the graph of nodes."""

from __future__ import annotations

from typing import Any, TypeVar, cast

from cyclonedds.core import DDSException
from cyclonedds.domain import Domain, DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.internal import InvalidSample
from cyclonedds.pub import DataWriter
from cyclonedds.qos import Policy, Qos
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

from executive.doors.ros.messages import Gid, NodeEntitiesInfo, ParticipantEntitiesInfo
from executive.doors.ros.settings import RosSettings
from executive.doors.ros.type_hashes import TYPE_HASHES

M = TypeVar("M", bound=IdlStruct)

_DEPTH = 10
_BLOCKS_AT_MOST = duration(milliseconds=100)
_MOST_TAKEN = 64
"""Samples that are taken from a reader at once; a flood is read in pieces."""


def reliable(depth: int = _DEPTH, *, latched: bool = False) -> tuple[Any, ...]:
    """Policies of a reliable endpoint; a latched one gives its last samples to those who come later."""
    durability = Policy.Durability.TransientLocal if latched else Policy.Durability.Volatile
    return (Policy.Reliability.Reliable(_BLOCKS_AT_MOST), durability, Policy.History.KeepLast(depth))


def best_effort(depth: int = _DEPTH) -> tuple[Any, ...]:
    """Policies of an endpoint that loses what is not taken in time."""
    return (Policy.Reliability.BestEffort, Policy.Durability.Volatile, Policy.History.KeepLast(depth))


class RosNode:
    """One node: makes readers and writers of topics, and tells the graph of each.

    Args:
        settings: Where it is.
    """

    def __init__(self, settings: RosSettings) -> None:
        self._settings = settings
        self._domain = Domain(settings.domain, settings.dds_config())
        self._participant = DomainParticipant(settings.domain, Qos(Policy.Userdata(b"enclave=/;")))
        self._readers: list[Gid] = []
        self._writers: list[Gid] = []
        self._graph = DataWriter(
            self._participant,
            Topic(self._participant, "ros_discovery_info", ParticipantEntitiesInfo),
            Qos(*reliable(1, latched=True)),
        )
        self._tell_graph()

    def writer(self, topic: str, kind: type[M], policies: tuple[Any, ...]) -> DataWriter[M]:
        """A writer of a topic; ``topic`` begins with "/", the namespace comes before it."""
        made = DataWriter(self._participant, self._topic(topic, kind), self._qos(kind, policies))
        self._writers.append(_gid(made))
        self._tell_graph()
        return made

    def reader(self, topic: str, kind: type[M], policies: tuple[Any, ...]) -> DataReader[M]:
        """A reader of a topic, as ``writer``."""
        made = DataReader(self._participant, self._topic(topic, kind), self._qos(kind, policies))
        self._readers.append(_gid(made))
        self._tell_graph()
        return made

    def _topic(self, name: str, kind: type[M]) -> Topic[M]:
        return Topic(self._participant, f"rt{self._settings.prefix}{name}", kind)

    @staticmethod
    def _qos(kind: type[IdlStruct], policies: tuple[Any, ...]) -> Qos:
        return Qos(*policies, Policy.Userdata(f"typehash={TYPE_HASHES[kind.__name__]};".encode()))

    def _tell_graph(self) -> None:
        settings = self._settings
        node = NodeEntitiesInfo(settings.prefix or "/", settings.node, self._readers, self._writers)
        self._graph.write(ParticipantEntitiesInfo(_gid(self._participant), [node]))


def taken(reader: DataReader[M]) -> list[M]:
    """What has arrived at a reader.

    A sample that cannot be read is passed over, as anybody may write one: DDS has looked at its lengths, and
    not at its text. So is what a writer leaves that goes, which holds nothing.
    """
    found: list[M] = []
    for _ in range(_MOST_TAKEN):
        try:
            samples: list[object] = list(reader.take(N=1))
        except DDSException:
            raise
        except Exception:  # whatever reading foreign bytes comes to
            continue
        if not samples:
            break
        found += [cast("M", one) for one in samples if not isinstance(one, InvalidSample)]
    return found


def _gid(entity: Any) -> Gid:
    return Gid(list(entity.guid.bytes))
