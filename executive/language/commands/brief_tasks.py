"""What "for a sec" and "real quick" may be said of without asking for a duration or a speed."""

from __future__ import annotations

from executive.language.phrases.arranging import ME
from executive.language.phrases.values import Clause, Draft

_TAKES_A_MOMENT = frozenset({"pick", "hand_over", "look_at", "point_at", "find", "count", "describe"})


def takes_a_moment(command: Clause, said: str) -> bool:
    """Whether a command is only said to be a short one: "come here for a sec".

    What is opened, held, moved or waited for a second has a duration, what is lent to somebody has one
    too, and a walk "real quick" a speed. A minute is a duration of all but coming: "look at it for a
    minute", "bring me the cup for a minute".
    """
    drafts = [one for bundle in command.bundles for one in bundle]
    return all(_is_brief(one, quick="quick" in said, minute="min" in said) for one in drafts)


def _is_brief(one: Draft, *, quick: bool, minute: bool) -> bool:
    if one.action == "walk_to":
        return one.get("to") == ME and not quick
    lent = one.action == "hand_over" and one.get("to") != ME
    if minute or lent or one.get("holds") or one.get("watches"):
        return False
    return one.action in _TAKES_A_MOMENT
