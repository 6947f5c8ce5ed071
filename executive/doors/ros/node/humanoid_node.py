"""Services and actions in front of a served robot, by rclpy.

It runs where rclpy is, and imports nothing of the product: it speaks the robot's sockets itself. Give it the
folder of a served robot::

    python humanoid_node.py FOLDER

The action ``execute_task`` and the service ``answer`` are of ``humanoid_executive_interfaces``, a package
beside this file, where that is built. Without it, ``--sentences FILE`` serves ``execute_numbered`` of
``test_msgs`` instead: the goal's order is the number of a line in the file, the result's sequence holds the
exit code; and ``answer`` is ``test_msgs/BasicTypes`` with the answer in ``string_value``. Further services:
``stop``, ``cancel`` and ``reset`` (``std_srvs/Trigger``); ``reset`` only tells how a person does it. Where
``control_msgs`` is, ``follow_joint_trajectory`` carries out motions that were planned elsewhere, if the
robot's checker agrees.

A goal lives as long as its client (``client_watch.py`` beside this file). One that is killed is known by its
missing acknowledgements within 5 s where no other client of the action is there, or its process was one of
this machine; else when its DDS participant's lease has run out (Fast DDS: 20 s unless its profile says
otherwise). Before Kilted nobody tells which of several clients sent a goal, which then lives as long as the
last of those that were there. A client that publishes its goal's id (``unique_identifier_msgs/UUID``) on
``<action>/alive`` every second is judged by that alone.
"""

from __future__ import annotations

import argparse
import contextlib
import threading
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import rclpy
from client_watch import LEASE_S, RARELY_ASKED_LEASE_S, ClientWatch
from ending import Ending
from fast_dds import ask_often
from follow_trajectory import GivenFile, InvalidGoalError, joint_motion, result_of
from goal_clients import GoalClients
from own_messages import feedback_fields, result_fields
from progress import Progress, account_of
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions
from robot_link import CONTROL, EXECUTIVE, ask
from std_srvs.srv import Trigger
from task_goal import POLL_S, carry_out

RESET = "an emergency stop is left by a person at the robot alone: `executive reset` in a terminal there"
NO_QUESTION = "no question is open"
GOALS_END_WITHIN_S, EXECUTOR_ENDS_WITHIN_S = 5.0, 2.0


class HumanoidNode(Node):
    """The services and the actions of one served robot."""

    def __init__(self, folder: Path, sentences: list[str], ending: Ending, lease_s: float) -> None:
        super().__init__("humanoid_executive_node")
        self._folder, self._sentences = folder, sentences
        self._ending, self._lease_s = ending, lease_s
        self._group = ReentrantCallbackGroup()
        self._goal_clients: list[GoalClients] = []
        self._action_servers: list[ActionServer] = []
        for name, call in (("stop", self._stop), ("cancel", self._cancel), ("reset", self._reset)):
            self.create_service(Trigger, name, call, callback_group=self._group)
        if sentences:
            from test_msgs.action import Fibonacci
            from test_msgs.srv import BasicTypes

            self._serve("execute_numbered", Fibonacci, self._numbered)
            self.create_service(BasicTypes, "answer", self._answer_basic, callback_group=self._group)
        else:
            from humanoid_executive_interfaces.action import ExecuteTask
            from humanoid_executive_interfaces.srv import Answer

            self._serve("execute_task", ExecuteTask, self._task)
            self.create_service(Answer, "answer", self._answer, callback_group=self._group)
        with contextlib.suppress(ImportError):  # it is no part of rclpy's wheels
            from control_msgs.action import FollowJointTrajectory

            self._serve("follow_joint_trajectory", FollowJointTrajectory, self._follow)

    def _serve(self, name: str, kind: Any, execute: Callable[[Any, GoalClients], Any]) -> None:
        clients = GoalClients(self, name, kind, self._group, self._lease_s)
        server = ActionServer(
            self,
            kind,
            name,
            execute_callback=lambda goal: execute(goal, clients),
            goal_callback=self._accept,
            cancel_callback=lambda _goal: CancelResponse.ACCEPT,
            callback_group=self._group,
        )
        clients.hear_senders(server)
        self._goal_clients.append(clients)
        self._action_servers.append(server)

    def _accept(self, _goal: Any) -> GoalResponse:
        return GoalResponse.REJECT if self._ending.is_asked else GoalResponse.ACCEPT

    def wait_for_goals(self) -> None:
        """Wait until the tasks of running goals have been cancelled, as far as that goes in time."""
        until_s = time.monotonic() + GOALS_END_WITHIN_S
        while any(one.goals for one in self._goal_clients) and time.monotonic() < until_s:
            time.sleep(POLL_S)

    # ------------------------------------------------------------------ services

    def _stop(self, _request: Any, response: Any) -> Any:
        return self._told(response, CONTROL, "stop", "stopped", category=1, reason="the service stop")

    def _cancel(self, _request: Any, response: Any) -> Any:
        return self._told(response, EXECUTIVE, "cancel", "cancelled", reason="the service cancel")

    def _reset(self, _request: Any, response: Any) -> Any:
        response.success, response.message = False, RESET
        return response

    def _told(self, response: Any, name: str, kind: str, done: str, **values: Any) -> Any:
        try:
            ask(self._folder / name, kind, **values)
        except OSError as wrong:
            response.success, response.message = False, str(wrong)
        else:
            response.success, response.message = True, done
        return response

    def _answer(self, request: Any, response: Any) -> Any:
        response.success, response.message = self._answered(request.text)
        return response

    def _answer_basic(self, request: Any, response: Any) -> Any:
        response.bool_value, response.string_value = self._answered(request.string_value)
        return response

    def _answered(self, text: str) -> tuple[bool, str]:
        """Answer the question that is open; whether one was, and what there is to say."""
        spaced = "".join(" " if one.isspace() else one for one in text)
        try:
            asked = bool(ask(self._folder / EXECUTIVE, "answer", text=spaced)["asked"])
        except OSError as wrong:
            return False, str(wrong)
        return asked, "answered" if asked else NO_QUESTION

    # ------------------------------------------------------------------ actions

    def _numbered(self, goal: Any, clients: GoalClients) -> Any:
        from test_msgs.action import Fibonacci

        number = goal.request.order
        if not 0 <= number < len(self._sentences):
            goal.abort()
            return Fibonacci.Result(sequence=[2])
        steps = 0

        def tell(progress: Progress) -> None:
            nonlocal steps
            steps += 1
            goal.publish_feedback(Fibonacci.Feedback(sequence=[steps, len(progress.tree_path)]))

        ending = self._carried_out(goal, clients, {"kind": "say", "text": self._sentences[number]}, tell)
        return Fibonacci.Result(sequence=[int(ending["exit_code"])])

    def _task(self, goal: Any, clients: GoalClients) -> Any:
        from humanoid_executive_interfaces import msg
        from humanoid_executive_interfaces.action import ExecuteTask

        def tell(progress: Progress) -> None:
            goal.publish_feedback(ExecuteTask.Feedback(**feedback_fields(progress, msg)))

        ending = self._carried_out(goal, clients, {"kind": "say", "text": goal.request.text}, tell)
        return ExecuteTask.Result(**result_fields(account_of(ending), msg))

    def _follow(self, goal: Any, clients: GoalClients) -> Any:
        from control_msgs.action import FollowJointTrajectory

        try:
            motion = joint_motion(goal.request)
        except InvalidGoalError as wrong:
            goal.abort()
            return FollowJointTrajectory.Result(error_code=wrong.code, error_string=str(wrong))
        with GivenFile(self._folder, bytes(goal.goal_id.uuid).hex(), motion) as given:
            ending = self._carried_out(goal, clients, given.order, lambda _progress: None)
        code, told = result_of(ending)
        return FollowJointTrajectory.Result(error_code=code, error_string=told)

    def _carried_out(
        self,
        goal: Any,
        clients: GoalClients,
        order: Mapping[str, Any],
        tell: Callable[[Progress], None],
    ) -> dict[str, Any]:
        """Carry an order out for a goal, which ends as the task does."""
        watch = clients.begin(goal)
        try:
            ending: dict[str, Any] = carry_out(
                self._folder, order, tell, lambda: self._why_to_end(goal, watch)
            )
        finally:
            clients.end(goal)
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


def main() -> None:
    """Serve until interrupted."""
    parser = argparse.ArgumentParser(description="Services and actions in front of a served robot.")
    parser.add_argument("folder", type=Path, help="where the robot is served")
    parser.add_argument("--sentences", type=Path, help="a sentence a line, for the action of test_msgs")
    chosen = parser.parse_args()
    sentences = chosen.sentences.read_text("utf-8").splitlines() if chosen.sentences else []
    ending = Ending()
    is_kilted = hasattr(ActionServer, "configure_introspection")
    lease_s = LEASE_S if ask_often(3 if is_kilted else 2) else RARELY_ASKED_LEASE_S
    rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
    node = HumanoidNode(chosen.folder, sentences, ending, lease_s)
    executor = MultiThreadedExecutor(8)
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
