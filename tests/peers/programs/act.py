"""A client of the action ``execute_numbered``; prints status and exit code as JSON.

Arguments: the number of a sentence, and perhaps how it ends and when: "cancel 2", "die 2".
"""

import json
import os
import signal
import sys
import time

import rclpy
from rclpy.action import ActionClient
from test_msgs.action import Fibonacci

rclpy.init()
node = rclpy.create_node("client")
client = ActionClient(node, Fibonacci, "execute_numbered")
assert client.wait_for_server(30.0)
heard = []


def result_of(future, seconds=180.0):
    rclpy.spin_until_future_complete(node, future, timeout_sec=seconds)
    return future.result()


goal = Fibonacci.Goal(order=int(sys.argv[1]))
handle = result_of(client.send_goal_async(goal, feedback_callback=heard.append), 10.0)
ends_by, after_s = (sys.argv[2], float(sys.argv[3])) if len(sys.argv) > 3 else ("", 0.0)
result = handle.get_result_async()
until = time.monotonic() + after_s
while time.monotonic() < until:
    rclpy.spin_once(node, timeout_sec=0.05)
if ends_by == "die":
    os.kill(os.getpid(), signal.SIGKILL)
if ends_by == "cancel":
    result_of(handle.cancel_goal_async(), 10.0)
ending = result_of(result)
print(json.dumps({"status": ending.status, "exit_code": ending.result.sequence[0], "heard": len(heard)}))
