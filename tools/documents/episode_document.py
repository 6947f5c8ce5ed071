"""A line of an evaluation's journal, as it is published."""

from __future__ import annotations

from typing import Any, Literal

from tools.documents.published import Published

EPISODE_FORMAT: Literal["humanoid-executive/episode/1"] = "humanoid-executive/episode/1"


class CostDocument(Published):
    """What an episode took."""

    wall_s: float
    """Wall time of the process that ran it, in seconds."""
    processor_s: float
    """Processor time of that process, in seconds."""
    memory_mb: float
    """The most memory that this process has had resident up to then."""
    process: str
    """Who ran it, as "host:pid"."""
    deaths: int
    """How many processes died before of the same order."""


class EpisodeDocument(Published):
    """One episode of a suite, a line of the journal."""

    format: Literal["humanoid-executive/episode/1"]
    """Says which form the line has."""
    suite: str
    """Name of the suite."""
    version: str
    """Version of the product that was judged."""
    order: dict[str, Any]
    """What was run: the same order gives the same record, but for wall times."""
    good: bool
    """Whether every demand on the episode was met."""
    record: dict[str, Any] | list[dict[str, Any]]
    """What came of it, in the suite's own words; a list where an order gives several records."""
    cost: CostDocument
    """What it took."""
