"""Services and an action in front of a served robot, by rclpy.

It runs where rclpy is, and imports nothing of the product: it speaks the robot's sockets itself. Give it the
folder of a served robot::

    python humanoid_node.py FOLDER

The action ``execute_task`` is of ``humanoid_executive_interfaces``, a package beside this file, where that is
built. Without it, ``--sentences FILE`` serves ``execute_numbered`` of ``test_msgs`` instead: the goal's order
is the number of a line in the file, the result's sequence holds the exit code. Services: ``stop``, ``cancel``
and ``reset`` (``std_srvs/Trigger``); ``reset`` only tells how a person does it.

A goal lives as long as its client (``client_watch.py`` beside this file). One that is killed is known by its
missing acknowledgements within 5 s where no other client of the action is there, or its process was one of
this machine; else when its DDS participant's lease has run out (Fast DDS: 20 s unless its profile says
otherwise). Before Kilted nobody tells which of several clients sent a goal, which then lives as long as the
last of those that were there. A client that publishes its goal's id (``unique_identifier_msgs/UUID``) on
``<action>/alive`` every second is judged by that alone.
"""

from __future__ import annotations

import argparse
import json
import socket
import struct
import threading
import time
from pathlib import Path
from typing import Any

import rclpy
from client_watch import LEASE_S, RARELY_ASKED_LEASE_S, ClientWatch
from ending import Ending
from fast_dds import PARTICIPANT, Processes, ask_often
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.duration import Duration
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from rclpy.qos import QoSProfile
from rclpy.signals import SignalHandlerOptions
from std_srvs.srv import Trigger
from unique_identifier_msgs.msg import UUID

HEAD = struct.Struct(">2sBBI")
MAGIC, VERSION, MESSAGE = b"HX", 1, 0
RESET = "an emergency stop is left by a person at the robot alone: `executive reset` in a terminal there"
POLL_S = 0.1
ANSWER_WITHIN_S = 5.0
LONGEST_MESSAGE = 65_536
AT_ONCE = Duration(nanoseconds=1_000)
MOST_SENDERS = 50
REQUEST_RECEIVED = 1
GOALS_END_WITHIN_S, EXECUTOR_ENDS_WITHIN_S = 5.0, 2.0


class Link:
    """A connection to one of the robot's sockets: JSON messages in frames of eight bytes and a payload."""

    def __init__(self, path: Path) -> None:
        """Connect; OSError when nobody listens."""
        self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self._socket.connect(str(path))
        self._buffer = b""

    def send(self, kind: str, **values: Any) -> None:
        """Send a message."""
        payload = json.dumps({"type": kind, **values}).encode()
        self._socket.sendall(HEAD.pack(MAGIC, VERSION, MESSAGE, len(payload)) + payload)

    def receive(self, within_s: float) -> dict[str, Any] | None:
        """The next message, or None when none came in time; ConnectionError when the other side has gone."""
        self._socket.settimeout(within_s)
        while True:
            if len(self._buffer) >= HEAD.size:
                _, _, _, length = HEAD.unpack_from(self._buffer)
                if length > LONGEST_MESSAGE:
                    raise ConnectionError("a frame is too long")
                if len(self._buffer) >= HEAD.size + length:
                    payload = self._buffer[HEAD.size : HEAD.size + length]
                    self._buffer = self._buffer[HEAD.size + length :]
                    message: dict[str, Any] = json.loads(payload)
                    return message
            try:
                arrived = self._socket.recv(65_536)
            except TimeoutError:
                return None
            if not arrived:
                raise ConnectionError("the robot's side has ended the connection")
            self._buffer += arrived

    def close(self) -> None:
        """Hang up; a task that was begun here is cancelled by that."""
        self._socket.close()


class HumanoidNode(Node):
    """The services and the action of one served robot."""

    def __init__(self, folder: Path, sentences: list[str], ending: Ending, lease_s: float) -> None:
        super().__init__("humanoid_executive_node")
        self._lease_s, self._processes = lease_s, Processes()
        self._folder, self._sentences, self._ending = folder, sentences, ending
        self._group = ReentrantCallbackGroup()
        for name, call in (("stop", self._stop), ("cancel", self._cancel), ("reset", self._reset)):
            self.create_service(Trigger, name, call, callback_group=self._group)
        if sentences:
            from test_msgs.action import Fibonacci

            self._serve("execute_numbered", Fibonacci, self._numbered)
        else:
            from humanoid_executive_interfaces.action import ExecuteTask

            self._serve("execute_task", ExecuteTask, self._task)

    def _serve(self, name: str, kind: type, execute: Any) -> None:
        self._feedback_topic = f"{name}/_action/feedback"
        # feedback of no goal: clients pass over it, and their middleware acknowledges it
        self._feedback_type = kind.Impl.FeedbackMessage  # type: ignore[attr-defined]
        self._probe = self.create_publisher(self._feedback_type, self._feedback_topic, 10)
        self._silent: set[bytes] = set()
        self._watches: dict[bytes, ClientWatch] = {}
        self._senders: dict[bytes, bytes] = {}
        self.create_subscription(UUID, f"{name}/alive", self._alive, 10, callback_group=self._group)
        self._server = ActionServer(
            self,
            kind,
            name,
            execute_callback=execute,
            goal_callback=self._accept,
            cancel_callback=lambda _goal: CancelResponse.ACCEPT,
            callback_group=self._group,
        )
        if hasattr(self._server, "configure_introspection"):  # since Kilted
            self._hear_senders(name, kind)

    def _hear_senders(self, name: str, kind: Any) -> None:
        """Hear of each goal who sent it."""
        from rclpy.service_introspection import ServiceIntrospectionState

        clock, qos = self.get_clock(), QoSProfile(depth=MOST_SENDERS)
        self._server.configure_introspection(clock, qos, ServiceIntrospectionState.CONTENTS)
        event, topic = kind.Impl.SendGoalService.Event, f"{name}/_action/send_goal/_service_event"
        self.create_subscription(event, topic, self._sent, MOST_SENDERS, callback_group=self._group)

    def _accept(self, _goal: Any) -> GoalResponse:
        return GoalResponse.REJECT if self._ending.is_asked else GoalResponse.ACCEPT

    def wait_for_goals(self) -> None:
        """Wait until the tasks of running goals have been cancelled, as far as that goes in time."""
        until_s = time.monotonic() + GOALS_END_WITHIN_S
        while self._watches and time.monotonic() < until_s:
            time.sleep(POLL_S)

    # ------------------------------------------------------------------ services

    def _ask(self, name: str, kind: str, **values: Any) -> dict[str, Any]:
        link = Link(self._folder / name)
        try:
            link.send(kind, **values)
            answer = link.receive(ANSWER_WITHIN_S)
        finally:
            link.close()
        if answer is None:
            raise ConnectionError("the robot does not answer")
        return answer

    def _stop(self, _request: Any, response: Any) -> Any:
        return self._told(response, "control.sock", "stop", "stopped", category=1, reason="the service stop")

    def _cancel(self, _request: Any, response: Any) -> Any:
        return self._told(response, "executive.sock", "cancel", "cancelled", reason="the service cancel")

    def _reset(self, _request: Any, response: Any) -> Any:
        response.success, response.message = False, RESET
        return response

    def _told(self, response: Any, name: str, kind: str, done: str, **values: Any) -> Any:
        try:
            self._ask(name, kind, **values)
        except OSError as wrong:
            response.success, response.message = False, str(wrong)
        else:
            response.success, response.message = True, done
        return response

    # ------------------------------------------------------------------ actions

    def _numbered(self, goal: Any) -> Any:
        from test_msgs.action import Fibonacci

        number = goal.request.order
        known = 0 <= number < len(self._sentences)
        text = self._sentences[number] if known else ""
        steps = 0

        def feedback(_line: str) -> None:
            nonlocal steps
            steps += 1
            goal.publish_feedback(Fibonacci.Feedback(sequence=[steps]))

        if not known:
            goal.abort()
            return Fibonacci.Result(sequence=[2])
        ending = self._carry_out(goal, text, feedback)
        return Fibonacci.Result(sequence=[int(ending["exit_code"])])

    def _task(self, goal: Any) -> Any:
        from humanoid_executive_interfaces.action import ExecuteTask

        def feedback(line: str) -> None:
            goal.publish_feedback(ExecuteTask.Feedback(line=line))

        ending = self._carry_out(goal, goal.request.text, feedback)
        report = _report(str(ending.get("run", "")))
        return ExecuteTask.Result(
            outcome=str(ending["outcome"]), message=str(ending.get("text", "")), report=report
        )

    def _carry_out(self, goal: Any, text: str, feedback: Any) -> dict[str, Any]:
        """Give a sentence to the robot, and hear it out; the goal ends as the task did."""
        ending: dict[str, Any] = {"outcome": "failed", "exit_code": 1}
        asked_to_end, watch = False, self._watch(goal)
        try:
            link = Link(self._folder / "executive.sock")
            try:
                link.send("say", text=text)
                while True:
                    message = link.receive(POLL_S)
                    if message is not None and message["type"] == "line":
                        feedback(str(message["text"]))
                    if message is not None and message["type"] in ("result", "error"):
                        refused = {"outcome": "refused", "exit_code": 2, "text": message.get("reason", "")}
                        ending = message if message["type"] == "result" else refused
                        break
                    reason = "" if asked_to_end else self._why_to_end(goal, watch)
                    if reason:
                        self._ask("executive.sock", "cancel", reason=reason)
                        asked_to_end = True
            finally:
                link.close()
        except OSError as wrong:
            ending = {"outcome": "failed", "exit_code": 1, "text": f"failed: {wrong}"}
        finally:
            del self._watches[bytes(goal.goal_id.uuid)]
        if goal.is_cancel_requested and ending["outcome"] == "cancelled":
            goal.canceled()
        elif ending["outcome"] == "done":
            goal.succeed()
        else:
            goal.abort()
        return ending

    def _why_to_end(self, goal: Any, watch: ClientWatch) -> str:
        """Why a goal's task has to be cancelled, or nothing."""
        if watch.is_gone(time.monotonic()):
            return "the action's client is gone"
        if goal.is_cancel_requested:
            return "the action was cancelled"
        return "the action's node ends" if self._ending.is_asked else ""

    # ------------------------------------------------------------------ clients

    def _watch(self, goal: Any) -> ClientWatch:
        watch = ClientWatch(
            self._listeners,
            lambda: self._probe.publish(self._feedback_type()),
            lambda: bool(self._probe.wait_for_all_acked(AT_ONCE)),
            self._silent,
            time.monotonic(),
            self._processes.has_ended,
            self._lease_s,
        )
        self._watches[bytes(goal.goal_id.uuid)] = watch
        self._tell_sender(bytes(goal.goal_id.uuid))
        return watch

    def _listeners(self) -> frozenset[bytes]:
        found = self.get_subscriptions_info_by_topic(self._feedback_topic)
        there = frozenset(bytes(one.endpoint_gid) for one in found)
        mine = [
            bytes(one.endpoint_gid)
            for one in self.get_publishers_info_by_topic(self._feedback_topic)
            if one.node_name == self.get_name()
        ]
        self._processes.see(there, mine[0] if mine else b"")
        return there

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

    def _alive(self, goal_id: Any) -> None:
        watch = self._watches.get(bytes(goal_id.uuid))
        if watch is not None:
            watch.told(time.monotonic())


def _report(folder: str) -> str:
    try:
        return (Path(folder) / "report.json").read_text("utf-8") if folder else ""
    except OSError:
        return ""


def main() -> None:
    """Serve until interrupted."""
    parser = argparse.ArgumentParser(description="Services and an action in front of a served robot.")
    parser.add_argument("folder", type=Path, help="where the robot is served")
    parser.add_argument("--sentences", type=Path, help="a sentence a line, for the action of test_msgs")
    chosen = parser.parse_args()
    sentences = chosen.sentences.read_text("utf-8").splitlines() if chosen.sentences else []
    ending = Ending()
    lease_s = LEASE_S if ask_often() else RARELY_ASKED_LEASE_S
    rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
    node = HumanoidNode(chosen.folder, sentences, ending, lease_s)
    executor = MultiThreadedExecutor(4)
    executor.add_node(node)

    def spin() -> None:
        try:
            executor.spin()
        finally:
            ending.ask()

    threading.Thread(target=spin, name="executor", daemon=True).start()
    ending.wait()
    node.wait_for_goals()
    executor.shutdown(EXECUTOR_ENDS_WITHIN_S)
    node.destroy_node()
    rclpy.shutdown()
    ending.leave()


if __name__ == "__main__":
    main()
