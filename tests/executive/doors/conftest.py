"""A real desk in another thread that does what a test says, with a control socket that remembers stops."""

import threading
import time
from collections import deque

import pytest

from executive.dialogue.clarification import OpenQuestion
from executive.exit_codes import ExitCode
from executive.live.desk_messages import Velocity
from executive.live.served_executive.desk import Desk
from robots.live.wire.messages import read_object, write_message
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.socket_server import SocketServer

ENDINGS = {
    "done": ("done: it waves", "done", ExitCode.DONE),
    "cancelled": ("cancelled: enough", "cancelled", ExitCode.CANCELLED),
    "refused": ("refused: too fast", "refused", ExitCode.INVALID),
}


class ServedDouble:
    """Ends a task at once, asks first where ``asks``, or keeps it until it is cancelled where ``holds``.

    Attributes:
        said: What was begun.
        stops: Emergency stops that came.
        cancels: Reasons of cancels.
        velocities: Those that were taken.
    """

    def __init__(self, folder):
        self.folder = folder
        self.asks = self.holds = self.refuses = False
        self.said, self.stops, self.cancels, self.velocities = [], [], [], []
        folder.make()
        self._desk = Desk(folder.executive_socket, self, lambda text: text == "stop")
        self._control = SocketServer(folder.control_socket, self._hear)
        self._cancelled, self._over, self._shown = False, threading.Event(), deque()
        self._thread = threading.Thread(target=self._serve)
        self._thread.start()

    def cancel(self, reason):
        self.cancels.append(reason)
        self._cancelled = True

    def pause(self, reason):
        pass

    def resume(self):
        pass

    def hear_velocity(self, linear_m_s, angular_rad_s):
        self.velocities.append((linear_m_s, angular_rad_s))

    def status(self):
        return {"task": None, "t_s": 1.0, "state": "NORMAL", "paused": False, "question": None, "tree": None}

    def scene(self):
        place = {"place_m": [0.6, 0.1, 0.9], "height_m": 0.1, "radius_m": 0.04}
        return [
            {"name": "red cup", "words": "red cup", "kind": "cup", "color": "red", "is": "object", **place}
        ]

    def world(self):
        return {"version": 7, "things": self.scene()}

    @property
    def watched(self):
        return bool(self._desk.watchers.connections)

    @property
    def trees(self):
        return self._desk.trees

    def show(self, call):
        """Have something told to those who watch, in the desk's own thread."""
        self._shown.append(call)

    def close(self):
        self._over.set()
        self._thread.join()

    def _hear(self, caller, frame):
        message = read_object(frame.payload)
        if message["type"] == "stop":
            self.stops.append(message)
        caller.send(write_message("status", robot="talos", scene="tabletop", seed=7, emergency=""))

    def _serve(self):
        while not self._over.is_set():
            self._poll()
            if (order := self._desk.next_order()) is not None:
                self.said.append(order.said)
                order.tell("EXECUTING: it")
                order.end(*ENDINGS[self._carry_out(order)])
                self._desk.finish()
            time.sleep(0.002)
        self._desk.close()
        self._control.close()

    def _carry_out(self, order):
        self._cancelled = False
        if self.refuses:
            return "refused"
        if self.asks:
            self._desk.question = OpenQuestion("which cup?", ("red", "blue"))
            order.ask(self._desk.question)
        while (self.holds or (self.asks and not self._desk.given)) and not self._cancelled:
            if self._over.is_set():
                break
            self._poll()
            if isinstance(order.said, Velocity) and not self.holds:
                break
            time.sleep(0.002)
        self._desk.question = None
        self._desk.given.clear()
        return "cancelled" if self._cancelled else "done"

    def _poll(self):
        while self._shown:
            self._shown.popleft()(self._desk.watchers)
        self._desk.poll()
        self._control.poll()


@pytest.fixture
def served(tmp_path):
    made = ServedDouble(RuntimeFolder(tmp_path / "live"))
    yield made
    made.close()
