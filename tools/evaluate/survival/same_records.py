"""Whether two journals hold the same episodes, each once, with the same records."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

from tools.documents.episode_document import EpisodeDocument
from tools.evaluate.harness.journal import episodes_of

_OF_THE_MACHINE = frozenset({"wall_s", "planning_ms", "realtime_factor", "slowest_plan_ms"})
"""Fields of a record that tell how quick a machine was."""


@dataclass(frozen=True, slots=True)
class Survived:
    """What became of a run in which something was killed.

    Attributes:
        wanted: Episodes that were ordered.
        recorded: Of these, those that were recorded once.
        doubled, lost: Those that were recorded more often, and not at all.
        other: Those whose record is another one than where nothing was killed.
        died: Processes that died of episodes that were run again.
    """

    wanted: int
    recorded: int
    doubled: Sequence[str]
    lost: Sequence[str]
    other: Sequence[str]
    died: int

    @property
    def whole(self) -> bool:
        """Whether every episode was recorded once, and as where nothing was killed."""
        return self.recorded == self.wanted and not (self.doubled or self.lost or self.other)


def survived(alone: Path, killed: Path) -> Survived:
    """Compare a journal with that of the same orders, left alone.

    Args:
        alone: Where nothing was killed.
        killed: Where something was.

    Raises:
        UserError: One of them is no journal.
    """
    told, found = _by_order(episodes_of(alone)), list(episodes_of(killed))
    count = Counter(_key(one) for one in found)
    records = _by_order(found)
    both = told.keys() & records.keys()
    return Survived(
        wanted=len(told),
        recorded=sum(count[order] == 1 for order in told),
        doubled=sorted(order for order, times in count.items() if times > 1),
        lost=sorted(told.keys() - count.keys()),
        other=sorted(
            {order for order in both if plain(told[order].record) != plain(records[order].record)}
            | (count.keys() - told.keys())
        ),
        died=sum(int(one.cost.deaths) for one in found),
    )


def plain(value: Any) -> Any:
    """A record without what tells how quick a machine was."""
    if isinstance(value, Mapping):
        return {key: plain(one) for key, one in value.items() if key not in _OF_THE_MACHINE}
    if isinstance(value, list):
        return [plain(one) for one in value]
    return "nan" if value != value else value


def _by_order(episodes: Any) -> Mapping[str, EpisodeDocument]:
    return MappingProxyType({_key(one): one for one in episodes})


def _key(episode: EpisodeDocument) -> str:
    return json.dumps(episode.order, sort_keys=True)
