"""What every rule of the grammar of sentences means."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from executive.language.clauses import before_command, scopes, sentences, statements
from executive.language.commands import attention, gestures, going, handling, moving, placing, skilled, speech
from executive.language.phrases import amounts, features, lists, nominals, pairs, places
from executive.language.phrases.values import Meaning

_SENTENCES = (before_command, scopes, sentences, statements)
_COMMANDS = (attention, gestures, going, handling, moving, placing, skilled, speech)
_PHRASES = (amounts, features, lists, nominals, pairs, places)

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        rule: meaning
        for module in (*_SENTENCES, *_COMMANDS, *_PHRASES)
        for rule, meaning in module.MEANINGS.items()
    }
)
