"""What every rule of the grammar of sentences means."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from executive.language.clauses import before_command, given_reasons, sentences, statements
from executive.language.clauses.fronted import fronted
from executive.language.commands import (
    attention,
    gestures,
    going,
    handling,
    placing,
    skilled,
    speech,
    turns,
    waiting,
)
from executive.language.phrases import amounts, features, lists, nominals, pairs, places, quantities, sharing
from executive.language.phrases.values import Meaning

_MODULES = (
    *(amounts, features, lists, nominals, pairs, places, quantities, sharing),
    *(attention, gestures, going, handling, placing, skilled, speech, turns, waiting),
    *(before_command, given_reasons, sentences, statements),
)

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {"fronted": fronted} | {name: one for module in _MODULES for name, one in module.MEANINGS.items()}
)
