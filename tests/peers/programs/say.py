"""Say a sentence on /ai/command, perhaps stop or answer meanwhile; print the lines of /ai/status as JSON.

Arguments: the sentence, seconds, and perhaps "stop" or an answer to the first question.
"""

import json
import sys

import rclpy
from hearing import Hearing
from std_msgs.msg import Bool, String

ENDS = ("done:", "failed:", "refused:", "cancelled:", "question:")

rclpy.init()
node = rclpy.create_node("speaker")
heard = Hearing(node)
commands = node.create_publisher(String, "/ai/command", 10)
stops = node.create_publisher(Bool, "/emergency_stop", 10)
extra = sys.argv[3] if len(sys.argv) > 3 else ""


def has(*words):
    return any(word in line for line in heard.lines for word in words)


assert heard.spin(60.0, lambda: commands.get_subscription_count() and stops.get_subscription_count() > 1), (
    "the robot does not listen"
)
heard.begin()
commands.publish(String(data=sys.argv[1]))
if extra == "stop":
    assert heard.spin(60.0, lambda: has("EXECUTING")), heard.lines
    stops.publish(Bool(data=True))
elif extra:
    assert heard.spin(60.0, lambda: has("question")), heard.lines
    heard.answers.publish(String(data=extra))
heard.spin(float(sys.argv[2]), lambda: any(line.startswith(ENDS) for line in heard.lines))
if extra == "stop":
    heard.spin(30.0, lambda: has("emergency stop engaged"))
    stops.publish(Bool(data=False))
    stops.wait_for_all_acked()
print(json.dumps(heard.lines))
