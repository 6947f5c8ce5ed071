"""Answers a question by the service ``answer``; prints whether one was open, and what was told.

Arguments: the answer, and for how many seconds it is asked again while no question is open.
"""

import json
import sys
import time

import rclpy
from test_msgs.srv import BasicTypes

rclpy.init()
node = rclpy.create_node("answerer")
client = node.create_client(BasicTypes, "answer")
assert client.wait_for_service(30.0)
until = time.monotonic() + float(sys.argv[2])
while True:
    future = client.call_async(BasicTypes.Request(string_value=sys.argv[1]))
    rclpy.spin_until_future_complete(node, future, timeout_sec=10.0)
    answer = future.result()
    if answer.bool_value or time.monotonic() >= until:
        break
    time.sleep(0.2)
print(json.dumps({"asked": answer.bool_value, "told": answer.string_value}))
