"""Send velocities on /cmd_vel; print how far it went and when it stood, as JSON.

Arguments: "twist" or "stamped", forward speed, turning speed, seconds.
"""

import json
import math
import sys
import time

import rclpy
from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Odometry
from std_msgs.msg import String

PERIOD_S, STILL_M = 0.02, 0.002

rclpy.init()
node = rclpy.create_node("driver")
places, lines = [], []
node.create_subscription(
    Odometry, "/odom", lambda one: places.append((one.pose.pose.position.x, one.pose.pose.position.y)), 10
)
node.create_subscription(String, "/ai/status", lambda one: lines.append(one.data), 100)
kind, forward, turning, seconds = sys.argv[1], *map(float, sys.argv[2:5])
publisher = node.create_publisher(TwistStamped if kind == "stamped" else Twist, "/cmd_vel", 1)


def spin(seconds, over=lambda: False):
    until = time.monotonic() + seconds
    while time.monotonic() < until and not over():
        rclpy.spin_once(node, timeout_sec=0.005)


spin(15.0, lambda: publisher.get_subscription_count() and places)
until = time.monotonic() + seconds
while time.monotonic() < until:
    twist = Twist()
    twist.linear.x, twist.angular.z = forward, turning
    publisher.publish(TwistStamped(twist=twist) if kind == "stamped" else twist)
    spin(PERIOD_S)
spin(30.0, lambda: any(line.startswith(("done:", "failed:", "refused:")) for line in lines))
print(json.dumps({"gone_m": math.dist(places[0], places[-1]), "lines": lines}))
