"""A client of the action ``execute_numbered``, by rclpy; prints how its goal ended as JSON.

Arguments: the number of a sentence, "hear", "cancel" or "die", after how many seconds, and "tell" to tell its
goal's id every half second.
"""

from __future__ import annotations

import json
import os
import signal
import sys
import time
from typing import Any

import rclpy
from rclpy.action import ActionClient
from test_msgs.action import Fibonacci
from unique_identifier_msgs.msg import UUID

_ANSWERS_WITHIN_S, _ENDS_WITHIN_S, _TELLS_EVERY_S = 30.0, 240.0, 0.5


def main(number: str, ending: str, after_s: str, tells: str) -> None:
    """Give the goal, and hear it out, cancel it or die."""
    rclpy.init()
    node = rclpy.create_node("action_client")
    client = ActionClient(node, Fibonacci, "execute_numbered")
    alive = node.create_publisher(UUID, "execute_numbered/alive", 10)
    heard: list[Any] = []

    def answer(future: Any, within_s: float) -> Any:
        rclpy.spin_until_future_complete(node, future, timeout_sec=within_s)
        return future.result()

    if not client.wait_for_server(_ANSWERS_WITHIN_S):
        raise SystemExit("no server")
    goal = Fibonacci.Goal(order=int(number))
    handle = answer(client.send_goal_async(goal, feedback_callback=heard.append), _ANSWERS_WITHIN_S)
    if handle is None or not handle.accepted:
        raise SystemExit("not accepted")
    if tells == "tell":
        node.create_timer(_TELLS_EVERY_S, lambda: alive.publish(handle.goal_id))
    result = handle.get_result_async()
    until_s = time.monotonic() + float(after_s)
    while time.monotonic() < until_s and not result.done():
        rclpy.spin_once(node, timeout_sec=0.05)
    if ending == "die":
        print(json.dumps({"died": True}), flush=True)
        os.kill(os.getpid(), signal.SIGKILL)
    if ending == "cancel":
        answer(handle.cancel_goal_async(), _ANSWERS_WITHIN_S)
    ended = answer(result, _ENDS_WITHIN_S)
    told = {"status": ended.status, "code": ended.result.sequence[0], "heard": len(heard)}
    print(json.dumps(told), flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
