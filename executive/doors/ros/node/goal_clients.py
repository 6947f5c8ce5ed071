"""The clients of an action's goals, as far as rclpy lets them be known: a watch over each goal's own."""

from __future__ import annotations

import time
from typing import Any

from client_watch import ClientWatch
from fast_dds import PARTICIPANT, Processes
from rclpy.callback_groups import CallbackGroup
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.qos import QoSProfile
from unique_identifier_msgs.msg import UUID

AT_ONCE = Duration(nanoseconds=1_000)
MOST_SENDERS = 50
REQUEST_RECEIVED = 1


class GoalClients:
    """Watches over the clients of one action.

    Args:
        node: Whose action it is.
        name: Of the action.
        kind: Its type.
        group: In which callbacks are called.
        lease_s: For how long an acknowledgement may be missing.
    """

    def __init__(self, node: Node, name: str, kind: Any, group: CallbackGroup, lease_s: float) -> None:
        self._node, self._name, self._kind, self._group = node, name, kind, group
        self._lease_s, self._processes = lease_s, Processes()
        self._topic = f"{name}/_action/feedback"
        # feedback of no goal: clients pass over it, and their middleware acknowledges it
        self._feedback = kind.Impl.FeedbackMessage
        self._probe = node.create_publisher(self._feedback, self._topic, 10)
        self._silent: set[bytes] = set()
        self._watches: dict[bytes, ClientWatch] = {}
        self._senders: dict[bytes, bytes] = {}
        node.create_subscription(UUID, f"{name}/alive", self._alive, 10, callback_group=group)

    @property
    def goals(self) -> int:
        """How many goals are under way."""
        return len(self._watches)

    def hear_senders(self, server: Any) -> None:
        """Hear of each goal who sent it, where the action's server can tell: since Kilted."""
        if not hasattr(server, "configure_introspection"):
            return
        from rclpy.service_introspection import ServiceIntrospectionState

        qos, event = QoSProfile(depth=MOST_SENDERS), self._kind.Impl.SendGoalService.Event
        server.configure_introspection(self._node.get_clock(), qos, ServiceIntrospectionState.CONTENTS)
        topic = f"{self._name}/_action/send_goal/_service_event"
        self._node.create_subscription(event, topic, self._sent, qos, callback_group=self._group)

    def begin(self, goal: Any) -> ClientWatch:
        """Watch over the client of a goal, until ``end``."""
        watch = ClientWatch(
            self._listeners,
            lambda: self._probe.publish(self._feedback()),
            lambda: bool(self._probe.wait_for_all_acked(AT_ONCE)),
            self._silent,
            time.monotonic(),
            self._processes.has_ended,
            self._lease_s,
        )
        self._watches[bytes(goal.goal_id.uuid)] = watch
        self._tell_sender(bytes(goal.goal_id.uuid))
        return watch

    def end(self, goal: Any) -> None:
        """The goal has ended."""
        del self._watches[bytes(goal.goal_id.uuid)]

    def _listeners(self) -> frozenset[bytes]:
        found = self._node.get_subscriptions_info_by_topic(self._topic)
        there = frozenset(bytes(one.endpoint_gid) for one in found)
        mine = [
            bytes(one.endpoint_gid)
            for one in self._node.get_publishers_info_by_topic(self._topic)
            if one.node_name == self._node.get_name()
        ]
        self._processes.see(there, mine[0] if mine else b"")
        return there

    def _alive(self, goal_id: Any) -> None:
        watch = self._watches.get(bytes(goal_id.uuid))
        if watch is not None:
            watch.told(time.monotonic())

    def _sent(self, event: Any) -> None:
        """Hear who sent a goal, before or after it was begun."""
        if event.info.event_type != REQUEST_RECEIVED or not event.request:
            return
        goal_id = bytes(event.request[0].goal_id.uuid)
        self._senders[goal_id] = bytes(event.info.client_gid)
        for old in list(self._senders)[:-MOST_SENDERS]:
            self._senders.pop(old, None)
        self._tell_sender(goal_id)

    def _tell_sender(self, goal_id: bytes) -> None:
        watch, sender = self._watches.get(goal_id), self._senders.get(goal_id)
        if watch is not None and sender is not None:
            watch.sent_by(sender[:PARTICIPANT])
