"""One connection that never blocks: frames in, frames out, both bounded."""

from __future__ import annotations

import select

from robots.live.wire.errors import ProtocolError
from robots.live.wire.framing import Frame, FrameDecoder, FrameKind, encode_frame
from robots.live.wire.unix_socket import UnixSocket, peer_of

_READ_BYTES = 262_144
"""Read at most so much at a time: a long document must not hold up a control period."""
MAX_UNSENT_BYTES = 32_000_000
"""A reader who lets so much pile up has stopped reading."""


class Connection:
    """A connection over a stream socket, on which whole frames are sent and received.

    Attributes:
        peer: Who is at the other end.
        closed: Whether it has ended.
        reason: Why it ended, where that was this side's doing.
        more: Whether frames have been read that ``receive`` has not handed out yet.
    """

    def __init__(self, connected: UnixSocket, documents: bool = False) -> None:
        """Take over a connected socket."""
        connected.setblocking(False)
        self._socket = connected
        self._decoder = FrameDecoder(documents)
        self._unsent = bytearray()
        self._ended = self._unheard = False
        self.peer = peer_of(connected)
        self.closed = False
        self.reason = ""
        self.more = False

    def fileno(self) -> int:
        """For ``select``."""
        return self._socket.fileno()

    def allow_documents(self) -> None:
        """Take documents from now on."""
        self._decoder.documents = True

    @property
    def idle(self) -> bool:
        """Whether everything that was sent has left."""
        return not self._unsent

    def send(self, payload: bytes, kind: FrameKind = FrameKind.MESSAGE) -> None:
        """Send one frame, now or as soon as the other side reads; after the end, nothing happens."""
        if self.closed or self._unheard:
            return
        self._unsent += encode_frame(kind, payload)
        self.flush()
        if len(self._unsent) > MAX_UNSENT_BYTES:
            self.close("the other side does not read")

    def flush(self) -> None:
        """Send what can be sent."""
        while self._unsent and not self.closed:
            try:
                sent = self._socket.send(self._unsent)
            except BlockingIOError:
                return
            except OSError:  # the other side has gone; what it said before can still be read
                self._unsent.clear()
                self._unheard = True
                return
            del self._unsent[:sent]

    def receive(self, most: int = 64) -> list[Frame]:
        """Frames that have arrived, ``most`` at the most; sets ``closed`` once the stream has ended.

        Raises:
            ProtocolError: What arrived cannot be understood.
        """
        frames = self._take(most)
        self.more = len(frames) == most
        if self.more or self.closed:
            return frames
        if not self._ended:
            try:
                data = self._socket.recv(_READ_BYTES)
            except BlockingIOError:
                return frames
            except OSError:
                data = b""
            if data:
                self._decoder.feed(data)
            else:
                self._ended = True
            frames += self._take(most - len(frames))
            self.more = len(frames) == most
        if self._ended and len(frames) < most:
            self.close("")
        return frames

    def wait(self, seconds: float) -> bool:
        """Wait until something arrives or the time is over; tells whether something may be read."""
        if self.closed:
            return False
        readable, _, _ = select.select([self._socket], [], [], max(0.0, seconds))
        return bool(readable)

    def close(self, reason: str) -> None:
        """End it."""
        if not self.closed:
            self.closed, self.reason = True, reason
            self._unsent.clear()
            self._socket.close()

    def _take(self, most: int) -> list[Frame]:
        frames: list[Frame] = []
        while len(frames) < most:
            try:
                frame = self._decoder.next()
            except ProtocolError:
                if frames:  # what came before it counts; it is found again at the next look
                    return frames
                raise
            if frame is None:
                break
            frames.append(frame)
        return frames
