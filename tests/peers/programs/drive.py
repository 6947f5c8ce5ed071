"""Send velocities on /cmd_vel until it has gone so far or said why not; print how far it went, as JSON.

Like a joystick it goes on after a walk that was done too soon: on a busy machine its messages may be late,
which is a silence.

Arguments: "twist" or "stamped", forward speed, turning speed, metres, the most seconds.
"""

import json
import math
import sys
import time

import rclpy
from geometry_msgs.msg import Twist, TwistStamped
from hearing import Hearing
from nav_msgs.msg import Odometry

PERIOD_S = 0.02
DONE, WHY_NOT = "done:", ("failed:", "refused:")

rclpy.init()
node = rclpy.create_node("driver")
heard, places = Hearing(node), []
node.create_subscription(
    Odometry, "/odom", lambda one: places.append((one.pose.pose.position.x, one.pose.pose.position.y)), 10
)
kind = sys.argv[1]
forward, turning, far_m, seconds = map(float, sys.argv[2:6])
publisher = node.create_publisher(TwistStamped if kind == "stamped" else Twist, "/cmd_vel", 1)


def gone_m():
    return math.dist(places[0], places[-1])


def is_refused():
    return any(line.startswith(WHY_NOT) for line in heard.lines)


def times_done():
    return sum(line.startswith(DONE) for line in heard.lines)


assert heard.spin(60.0, lambda: publisher.get_subscription_count() and places), "the robot is not there"
heard.begin()
until = time.monotonic() + seconds
while time.monotonic() < until and gone_m() < far_m and not is_refused():
    twist = Twist()
    twist.linear.x, twist.angular.z = forward, turning
    publisher.publish(TwistStamped(twist=twist) if kind == "stamped" else twist)
    heard.spin(PERIOD_S)
before = times_done()
heard.spin(60.0, lambda: is_refused() or times_done() > before)
print(json.dumps({"gone_m": gone_m(), "lines": heard.lines}))
