"""One sink for all layers, with listeners that come and go."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from executive.session.events import Event, EventSink


class EventHub:
    """Passes each event to its sink, and to whoever listens at the time."""

    def __init__(self, sink: EventSink) -> None:
        self._sink = sink
        self._listeners: list[EventSink] = []

    def __call__(self, event: Event) -> None:
        """Take an event."""
        self._sink(event)
        for listener in self._listeners:
            listener(event)

    def listen(self, listener: EventSink) -> None:
        """Have every event told to a listener as well, from now on."""
        self._listeners.append(listener)

    @contextmanager
    def heard_by(self, listener: EventSink) -> Iterator[None]:
        """Have every event told to a listener as well."""
        self._listeners.append(listener)
        try:
            yield
        finally:
            self._listeners.remove(listener)
