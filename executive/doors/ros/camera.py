"""The robot's camera on its topics: pictures that are taken anyway, while somebody listens."""

from __future__ import annotations

import contextlib
import threading
from bisect import bisect_left
from collections import deque
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from cyclonedds.core import DDSException
from cyclonedds.idl import IdlStruct
from cyclonedds.pub import DataWriter
from numpy.typing import NDArray

from executive.doors.ros.camera_messages import CameraInfo, Image
from executive.doors.ros.graph import RosNode, reliable
from executive.doors.ros.messages import Header, Time
from robots.clock import WallClock
from robots.perception.rgbd.picture_slot import PictureSlotReader, ShownPicture

M = TypeVar("M", bound=IdlStruct)

_POLL_S = 1.0 / 15.0
_APART_S = 0.5 * _POLL_S
"""Wall time between colours and depths: a listener's socket does not hold both at once."""
_MOST_KEPT = 1000
_KEPT = 5
"""Pictures that wait for a slow listener."""
_BEYOND_S = 0.05


class StateStamps:
    """When states were read, so that a picture gets the stamp that its robot's frames have; thread-safe."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._kept: deque[tuple[float, int]] = deque(maxlen=_MOST_KEPT)

    def note(self, t_s: float, stamp: Time) -> None:
        """Note a state.

        Args:
            t_s: Its control time.
            stamp: With which it is published.
        """
        with self._lock:
            if self._kept and t_s < self._kept[-1][0]:  # another control process, whose time begins anew
                self._kept.clear()
            self._kept.append((t_s, stamp.sec * 1_000_000_000 + stamp.nanosec))

    def at(self, t_s: float) -> Time | None:
        """The stamp of an instant of control time; None where no state is known of about then."""
        with self._lock:
            kept = list(self._kept)
        if not kept or not kept[0][0] <= t_s <= kept[-1][0] + _BEYOND_S:
            return None
        index = min(bisect_left(kept, (t_s, 0)), len(kept) - 1)
        (before_s, before), (after_s, after) = kept[max(index - 1, 0)], kept[index]
        share = min((t_s - before_s) / (after_s - before_s), 1.0) if after_s > before_s else 1.0
        return Time(*divmod(before + round(share * (after - before)), 1_000_000_000))


class CameraTopics:
    """Publishes the pictures of one robot's camera.

    Args:
        node: Where the topics are.
        slot: The newest picture.
        stamps: Of the states.
    """

    def __init__(self, node: RosNode, slot: Path, stamps: StateStamps) -> None:
        self._slot, self._stamps = PictureSlotReader(slot), stamps
        # a reader of either kind hears a reliable writer, and on a busy machine more arrives
        kept = reliable(_KEPT)
        self._ended = threading.Event()
        self._thread: threading.Thread | None = None
        self._depths_left: Image | None = None
        self._color = node.writer("/camera/color/image_raw", Image, kept)
        self._depth = node.writer("/camera/depth/image_raw", Image, kept)
        self._infos = [
            node.writer(f"/camera/{which}/camera_info", CameraInfo, kept) for which in ("color", "depth")
        ]

    def begin(self, wall: WallClock) -> None:
        """Publish pictures as they come, in a thread of its own."""
        self._thread = threading.Thread(target=self._run, args=(wall,), name="ros pictures", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Publish nothing any more, and want nothing."""
        self._ended.set()
        if self._thread is not None:
            self._thread.join()
        self._slot.want(False)

    def poll(self) -> None:
        """Publish the colours of a new picture, if there is one, and with the next call its depths.

        Pictures are wanted while somebody listens.
        """
        if self._depths_left is not None:
            _write(self._depth, self._depths_left)
            self._depths_left = None
            return
        wanted = any(map(_is_heard, (self._color, self._depth, *self._infos)))
        with contextlib.suppress(OSError):  # asked again with the next poll
            self._slot.want(wanted)
        shown = self._slot.newest() if wanted else None
        stamp = None if shown is None else self._stamps.at(shown.stamp_s)
        if shown is None or stamp is None:
            return
        for writer in self._infos:
            _write(writer, camera_info(shown, stamp))
        if _is_heard(self._color):
            _write(self._color, color_image(shown, stamp))
        if _is_heard(self._depth):
            self._depths_left = depth_image(shown, stamp)

    def _run(self, wall: WallClock) -> None:
        while not self._ended.is_set():
            self.poll()
            wall.sleep(_APART_S)


def _write(writer: DataWriter[M], message: M) -> None:
    """Write a sample; one that a slow reader leaves no room for is lost: a late picture is worth nothing."""
    with contextlib.suppress(DDSException):
        writer.write(message)


def color_image(shown: ShownPicture, stamp: Time) -> Image:
    """A picture's colours, 8 bits each of red, green and blue."""
    return _image(shown.frame, stamp, "rgb8", shown.color)


def depth_image(shown: ShownPicture, stamp: Time) -> Image:
    """A picture's depths along the optical axis, mm, 0 where nothing came back."""
    return _image(shown.frame, stamp, "16UC1", shown.depth_mm.astype("<u2", copy=False))


def camera_info(shown: ShownPicture, stamp: Time) -> CameraInfo:
    """The lens that took a picture: pixels are square, and nothing is distorted.

    The axis goes through the middle; the middle of the first pixel is at 0.
    """
    height, width = shown.depth_mm.shape
    f, u, v = shown.focal_px, 0.5 * (width - 1), 0.5 * (height - 1)
    return CameraInfo(
        Header(stamp, shown.frame),
        height,
        width,
        "plumb_bob",
        [0.0] * 5,
        [f, 0.0, u, 0.0, f, v, 0.0, 0.0, 1.0],
        [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
        [f, 0.0, u, 0.0, 0.0, f, v, 0.0, 0.0, 0.0, 1.0, 0.0],
    )


def _image(frame: str, stamp: Time, encoding: str, pixels: NDArray[Any]) -> Image:
    height, width = pixels.shape[:2]
    step = pixels.nbytes // height
    data: Any = np.ascontiguousarray(pixels).tobytes()
    return Image(Header(stamp, frame), height, width, encoding, 0, step, data)


def _is_heard(writer: Any) -> bool:
    return bool(writer.get_matched_subscriptions())
