"""What every rule of the grammar of sentences means."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from executive.language.clauses import (
    before_command,
    scopes,
    sentences,
    statements,
)
from executive.language.commands import (
    attention,
    gestures,
    going,
    handling,
    moving,
    placing,
    skilled,
    speech,
)
from executive.language.phrases import (
    amounts,
    features,
    lists,
    nominals,
    pairs,
    places,
)
from executive.language.phrases.values import Meaning

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        **amounts.MEANINGS,
        **attention.MEANINGS,
        **before_command.MEANINGS,
        **features.MEANINGS,
        **gestures.MEANINGS,
        **going.MEANINGS,
        **handling.MEANINGS,
        **lists.MEANINGS,
        **moving.MEANINGS,
        **nominals.MEANINGS,
        **pairs.MEANINGS,
        **places.MEANINGS,
        **placing.MEANINGS,
        **scopes.MEANINGS,
        **sentences.MEANINGS,
        **skilled.MEANINGS,
        **speech.MEANINGS,
        **statements.MEANINGS,
    }
)
