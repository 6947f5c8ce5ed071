"""What an order comes to: the statements of a script, a sentence, or a velocity."""

from __future__ import annotations

from collections.abc import Iterator
from typing import cast

from executive.conversation import Conversation
from executive.live.desk import Say, Script, ScriptLine
from executive.meaning import Parsed
from executive.statement import Expectation, OnFailure, Statement
from executive.trust import Trust
from executive.understanding import understand
from trees.tasks import MoveTask


def statements_of(said: Say | Script, before: Conversation, trust: Trust) -> Iterator[Statement]:
    """Understand what was said, one statement after the other.

    Args:
        said: The order.
        before: What was said before; remembers what is said now.
        trust: How far a model's output is trusted.
    """
    if isinstance(said, Script):
        for line in said.lines:
            yield _of_script(line, before, trust)
    elif said.text:
        understood = before.understand(said.text, trust)
        yield Statement(understood.parsed, timeout_s=said.timeout_s or None).meaning(understood)
    else:
        text = f"move at {said.linear_m_s:g} m/s and {said.angular_rad_s:g} rad/s"
        yield Statement(Parsed(text, (MoveTask(text, said.linear_m_s, said.angular_rad_s),)))


def _of_script(line: ScriptLine, before: Conversation, trust: Trust) -> Statement:
    """A statement as ``load_script`` makes it; the desk has judged the words for failure and expectation."""
    asks = line.expect == "question"
    understood = understand(line.text, trust) if asks else before.understand(line.text, trust)
    return Statement(
        understood.parsed,
        cast(OnFailure, line.on_failure),
        cast(Expectation, line.expect),
        line.timeout_s or None,
    ).meaning(understood)
