"""Listen to the robot's camera until a picture of each kind has come with its lens, and its frame is known.

Prints what came as JSON. Arguments: the most seconds.
"""

import json
import sys
import time

import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from sensor_msgs.msg import CameraInfo, Image
from std_msgs.msg import String

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)

rclpy.init()
node = rclpy.create_node("seer")
came, wanted = {}, set()


def listen(topic, kind, qos):
    wanted.add(topic)
    node.create_subscription(kind, topic, lambda message: came.setdefault(topic, []).append(message), qos)


def paired(which):
    """The first picture that came with its lens: both have the same stamp."""
    infos = {str(info.header.stamp): info for info in came.get(f"/camera/{which}/camera_info", ())}
    for image in came.get(f"/camera/{which}/image_raw", ()):
        if str(image.header.stamp) in infos:
            return image, infos[str(image.header.stamp)]
    return None


def told(pair):
    image, info = pair
    return {
        "size": [image.width, image.height],
        "step": image.step,
        "bytes": len(image.data),
        "encoding": image.encoding,
        "frame": image.header.frame_id,
        "age_s": time.time() - image.header.stamp.sec - 1e-9 * image.header.stamp.nanosec,
        "values": len(set(bytes(image.data))),
        "info_size": [info.width, info.height],
        "info_frame": info.header.frame_id,
        "model": info.distortion_model,
        "distortion": list(info.d),
        "k": list(info.k),
        "p": list(info.p),
    }


for which in ("color", "depth"):
    listen(f"/camera/{which}/image_raw", Image, qos_profile_sensor_data)
    listen(f"/camera/{which}/camera_info", CameraInfo, qos_profile_sensor_data)
listen("/robot_description", String, LATCHED)
began = time.monotonic()
while time.monotonic() < began + float(sys.argv[1]):
    rclpy.spin_once(node, timeout_sec=0.1)
    if "/robot_description" in came and paired("color") and paired("depth"):
        break
frame = paired("color")[0].header.frame_id
print(
    json.dumps(
        {
            "color": told(paired("color")),
            "depth": told(paired("depth")),
            "counts": {topic: len(messages) for topic, messages in came.items()},
            "is_described": f'name="{frame}"' in came["/robot_description"][0].data,
            "types": dict(node.get_topic_names_and_types()),
        }
    )
)
