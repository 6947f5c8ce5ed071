"""Listen to every topic that the wheels have a type of, until each has come and the graph is whole.

Prints what came as JSON. Arguments: the most seconds.
"""

import json
import sys
import time

import rclpy
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import WrenchStamped
from nav_msgs.msg import Odometry
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import Imu, JointState
from std_msgs.msg import String

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
TYPED = {"/tf", "/detections", "/cmd_vel"}

rclpy.init()
node = rclpy.create_node("watcher")
came, wanted = {}, set()


def listen(topic, kind, qos=10):
    wanted.add(topic)
    node.create_subscription(kind, topic, lambda message: came.setdefault(topic, []).append(message), qos)


def graph():
    nodes = [name for name, _ in node.get_node_names_and_namespaces()]
    return nodes, dict(node.get_topic_names_and_types())


def is_whole():
    nodes, types = graph()
    return len(nodes) > 1 and types.keys() >= TYPED and len(types["/cmd_vel"]) > 1


listen("/joint_states", JointState)
listen("/odom", Odometry)
listen("/imu", Imu)
listen("/wrench/left_sole_link", WrenchStamped)
listen("/diagnostics", DiagnosticArray)
listen("/robot_description", String, LATCHED)
until = time.monotonic() + float(sys.argv[1])
while time.monotonic() < until and not (came.keys() >= wanted and is_whole()):
    rclpy.spin_once(node, timeout_sec=0.1)
joints = came["/joint_states"][-1]
nodes, types = graph()
print(
    json.dumps(
        {
            "topics": sorted(came),
            "joints": len(joints.name),
            "positions": len(joints.position),
            "height_m": came["/odom"][-1].pose.pose.position.z,
            "up_m_s2": came["/imu"][-1].linear_acceleration.z,
            "urdf": came["/robot_description"][0].data[:200],
            "parts": {one.name: one.message for one in came["/diagnostics"][-1].status},
            "nodes": nodes,
            "types": types,
        }
    )
)
