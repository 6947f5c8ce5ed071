"""Another client of the action ``execute_numbered``, which gives no goal; the argument is for how long."""

import sys
import time

import rclpy
from rclpy.action import ActionClient
from test_msgs.action import Fibonacci

rclpy.init()
node = rclpy.create_node("listener")
client = ActionClient(node, Fibonacci, "execute_numbered")
until = time.monotonic() + float(sys.argv[1])
while time.monotonic() < until:
    rclpy.spin_once(node, timeout_sec=0.1)
