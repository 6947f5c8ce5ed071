"""Say a sentence on /ai/command, perhaps stop or answer meanwhile; print the lines of /ai/status as JSON.

Arguments: the sentence, seconds, and perhaps "stop" or an answer to the first question.
"""

import json
import sys
import time

import rclpy
from std_msgs.msg import Bool, String

ENDS = ("done:", "failed:", "refused:", "cancelled:", "question:")

rclpy.init()
node = rclpy.create_node("speaker")
lines = []
node.create_subscription(String, "/ai/status", lambda message: lines.append(message.data), 100)
commands = node.create_publisher(String, "/ai/command", 10)
answers = node.create_publisher(String, "/ai/answer", 10)
stops = node.create_publisher(Bool, "/emergency_stop", 10)
extra = sys.argv[3] if len(sys.argv) > 3 else ""


def spin(seconds, over=lambda: False):
    until = time.monotonic() + seconds
    while time.monotonic() < until and not over():
        rclpy.spin_once(node, timeout_sec=0.05)


spin(15.0, lambda: commands.get_subscription_count() and stops.get_subscription_count() > 1)
spin(0.5)
commands.publish(String(data=sys.argv[1]))
if extra == "stop":
    spin(3.0, lambda: any("EXECUTING" in line for line in lines))
    stops.publish(Bool(data=True))
elif extra:
    spin(60.0, lambda: any("question" in line for line in lines))
    answers.publish(String(data=extra))
spin(float(sys.argv[2]), lambda: any(line.startswith(ENDS) for line in lines))
spin(0.5)
if extra == "stop":
    stops.publish(Bool(data=False))
    spin(1.0)
print(json.dumps(lines))
