"""Lines of /ai/status, and whether they are heard at all: an answer to no question is refused there."""

import time

import rclpy
from std_msgs.msg import String

NO_QUESTION = "refused: no question is open"


class Hearing:
    """Lines as they come; ``spin`` lets them come."""

    def __init__(self, node):
        self.node, self.lines, self._refusals = node, [], 0
        node.create_subscription(String, "/ai/status", self._hear, 100)
        self.answers = node.create_publisher(String, "/ai/answer", 10)

    def spin(self, seconds, over=lambda: False):
        """Let messages come until something is so, or for so long; whether it was so."""
        until = time.monotonic() + seconds
        while not (done := over()) and time.monotonic() < until:
            rclpy.spin_once(self.node, timeout_sec=0.005)
        return done

    def begin(self):
        """Wait until what is said is answered."""
        assert self.spin(60.0, self.answers.get_subscription_count), "nobody listens on /ai/answer"
        asked = 0
        while not self._refusals:
            assert asked < 60, "nothing is heard on /ai/status"
            self.answers.publish(String(data="nothing"))
            asked += 1
            self.spin(1.0, lambda: self._refusals)
        self.spin(2.0, lambda: self._refusals == asked)

    def _hear(self, message):
        if message.data == NO_QUESTION:
            self._refusals += 1
        else:
            self.lines.append(message.data)
