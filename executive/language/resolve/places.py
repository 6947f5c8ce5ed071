"""Places and descriptions as a task's slots hold them: what "there", "back", "in it" and "the blue one" stand for."""

from __future__ import annotations

from dataclasses import fields, replace
from typing import Any

from executive.language.commands.placing import HOLDERS
from executive.language.phrases.values import Nominal, Relative, Trouble, Where
from executive.language.resolve.antecedents import of_one_kind, said_again, standing_open
from executive.language.resolve.discourse import LEAVES, THINGS, Discourse, UnresolvedError, ask, is_them
from executive.language.resolve.kinds import listed
from executive.language.resolve.people import asker_or_met, person_meant
from trees import tasks
from trees.tasks import ObjectDescription, ObjectOf, RelationKind

_SEES = frozenset({"count", "find", "look_at", "describe"})
"""Tasks after which what was opened is still looked into."""

_CONTRASTED = ("color", "size", "material", "ordinal")
_DESCRIBED = tuple(
    one.name
    for one in fields(ObjectDescription)
    if one.name in Nominal.__dataclass_fields__ and one.name != "relation"
)


def described(told: Discourse, of: Nominal) -> ObjectDescription | str:
    """A thing, a place or a person that is told by words, as the value of a slot: a name alone is that name.

    Raises:
        UnresolvedError: Where it is, is not clear.
    """
    if of.sort == "name" and of.relation is None:
        return str(of.kind)
    if of.sort == "name":
        of = replace(of, kind=None, name=of.kind)
    relation = None
    if of.relation is not None:
        if of.kind is not None and not of.is_place:
            told = replace(told, kind=of)
        relation = tasks.Relation(*_where(told, of.relation))
    return ObjectDescription(**{name: getattr(of, name) for name in _DESCRIBED}, relation=relation)


def _where(told: Discourse, of: Relative) -> tuple[RelationKind, Any]:
    """Where something is; "the cabinet there" is in the room that was gone to."""
    if of.to.reference != "there":
        return of.kind, _neighbor(told, of.to)
    room = there(told, of.to, -1)
    if room.sort != "room":
        raise ask("which place does 'there' stand for?")
    return "in", room.kind


def destination(told: Discourse, of: Nominal) -> Any:
    """A place, a person or a thing that is told by words, as the value of a slot.

    Raises:
        UnresolvedError: It may be one of several.
    """
    before = said_again(told, of)
    if isinstance(before, ObjectOf) and (of.is_single or of.whose):
        return before
    named = told.same_kind(before if isinstance(before, Nominal) else of)
    if named.sort in ("me", "you"):
        return named.kind
    if named.sort == "name":
        return described(told, named)
    if named.count != 1 or (named.plural and not named.reference):
        raise UnresolvedError(Trouble(f"several places at once ({named.kind!r}): name one", named.kind))
    if named.is_plain and (of.anaphoric or named.kind is None):
        raise ask("which one is meant?")  # "put the box in that one"
    if named.is_place and named.is_plain:
        return named.kind
    if _is_in_front(named):
        return "in_front"
    return described(told, named)


def _is_in_front(of: Nominal) -> bool:
    """Whether it is "the person in front of you"."""
    relation = of.relation
    in_front = relation is not None and relation.kind == "in_front_of" and relation.to.sort == "you"
    return in_front and of.kind == "person" and replace(of, relation=None).is_plain


def place(told: Discourse, of: Nominal | Relative, root: int, *, into: bool = False) -> Any:
    """Where a thing goes or comes from, or who gets it.

    Args:
        told: What was said so far.
        of: How the place is said.
        root: The first task of the thing.
        into: Whether the thing goes into it.

    Raises:
        UnresolvedError: It may be one of several.
    """
    if isinstance(of, Relative):
        return ObjectDescription(relation=tasks.Relation(of.kind, _neighbor(told, of.to, root)))
    if of.reference == "him" or (of.sort == "person" and of.whose):
        return destination(told, person_meant(told, of))
    if of.reference == "asker":
        return destination(told, asker_or_met(told, of))
    if of.reference == "there":
        return destination(told, there(told, of, root))
    if of.reference in ("it", "previous"):
        return _inner(told, root, into=into)
    if of.reference:
        raise ask("which place is meant?")
    if of.anaphoric and (holder := _holder(told)) is not None:
        return destination(told, replace(of, kind=holder.kind, sort=holder.sort, anaphoric=False, said=""))
    if of.anaphoric:
        _contrasted(told, of)
        of_one_kind(told, *(one.of for one in (*told.places, *told.mentioned)))
        if (
            not into
            and any(one.of == told.kind and one.task in told.held for one in told.things)
            and root not in told.held
        ):
            raise ask("which one is meant?")
    return destination(told, of)


def _holder(told: Discourse) -> Nominal | None:
    """What "the blue one" is after "the ball in the red box and the pen": one of the only sort that held something."""
    holders = [one.of for one in (*told.places, *told.mentioned) if one.role in ("goal", "source")]
    kinds = {one.kind for one in holders}
    if any(one.kind in HOLDERS for one in (told.kind, *(one.of for one in told.things)) if one is not None):
        return None  # "put the cup on the big one"
    apart = told.kind is not None and not told.kind.is_place and told.kind.kind not in kinds
    return holders[0] if apart and len(kinds) == 1 else None


def _contrasted(told: Discourse, of: Nominal) -> None:
    """Check that "the blue one" beside or under a thing is told from that very thing by what is said of it.

    Raises:
        UnresolvedError: It is not: "put the can on the left one".
    """
    slots = [slot for slot in _CONTRASTED if getattr(of, slot) is not None]
    if (
        told.kind is not None
        and not told.kind.is_place
        and all(getattr(told.kind, slot) is None for slot in slots)
    ):
        raise ask("which one is meant?")


def _neighbor(told: Discourse, of: Nominal, root: int = -1) -> Any:
    """What a relation is to: a thing rather than the furniture that it stands on."""
    if of.reference == "it":
        recent = told.recent(THINGS, root)
        if len(recent) == 1 and recent[0].task in told.held:
            raise ask(f"the {recent[0].of.kind or 'one'} is in the hand by then: shall it be put down first?")
        if len(recent) == 1 and not recent[0].is_several and not told.mentioned:
            return _same_it(told, recent[0].task)
    if of.anaphoric:
        lately = (one.of for one in told.things if one.clause >= told.clause - 1 and one.of.sort == "thing")
        of_one_kind(told, *lately, *(one.of for one in told.mentioned))
        return destination(told, of)
    return place(told, of, root)


def _same_it(told: Discourse, task: int) -> ObjectOf:
    """What "it" is beside another one of the clause: "put the bottle next to it and the can behind it".

    Raises:
        UnresolvedError: Two different things.
    """
    for step in told.steps:
        goal = getattr(step.command, "on", None) or getattr(step.command, "to", None)
        beside = getattr(getattr(goal, "relation", None), "to", goal)
        lately = step.clause == told.clause or any(
            one.task == task and one.clause == step.clause for one in told.things
        )
        if lately and isinstance(beside, ObjectOf) and beside.task != task:
            raise ask("what does 'it' stand for?")
    return ObjectOf(task)


def _inner(told: Discourse, root: int, *, into: bool) -> Any:
    """A reference inside a place: "in it", "next to it".

    Raises:
        UnresolvedError: It may be one of several, or is in the hand or given away by then.
    """
    holds = ("container",) if into else ("furniture", "container")
    recent = told.recent((*THINGS, "container", "furniture", "door", "room"), root)
    if into:
        recent = [one for one in recent if one.of.sort in (*THINGS, "container")]
    acted = [one.of for one in recent]
    places = list(
        dict.fromkeys(one.of for one in told.places if one.of.sort in holds and one.of not in acted)
    )
    if not recent and len(places) == 1 and not told.mentioned:
        return destination(told, places[0])
    walked = not into and told.last_action in ("walk_to", "go_home")
    opened = bool(recent) and all(one.of.sort == "container" for one in recent)
    if walked and opened and not told.mentioned and [one.sort for one in told.walks[-1:]] == ["furniture"]:
        return destination(told, told.walks[-1])  # "close the fridge, walk to the table, put the cup on it"
    if len(recent) != 1 or places or told.mentioned or (walked and recent[0].of.sort == "container"):
        raise ask("what does 'it' stand for?")
    (one,) = recent
    if one.task in told.held or one.is_several:
        raise ask("what does 'it' stand for?")
    if one.task in told.given:
        raise ask(f"the {one.of.kind or 'one'} is given away by then: shall it be put there?")
    return _same_it(told, one.task)


def there(told: Discourse, of: Nominal, root: int) -> Nominal:
    """The one place that was named and that the thing is not at already, or for "back" the one it was at.

    Raises:
        UnresolvedError: It may be one of several.
    """
    source = told.source_of(root)
    if of.name == "back":
        if source is None:
            raise ask("where shall it be put back to?")
        return source
    named = dict.fromkeys((*(one.of for one in told.places), *told.beside))
    places = [one for one in named if one != source]
    if told.last_action == "walk_to":  # just now, unless another place was named since
        last = [one.of for one in told.places][-1:]
        places = [one for one in places if [one] == last == told.walks[-1:]]
    if len(places) != 1:
        raise ask("which place does 'there' stand for?", [f"the {one.kind}" for one in places])
    return places[0]


def put_there(told: Discourse, where: Where, root: int) -> dict[str, Any]:
    """The slots of a place task whose place was named before.

    Raises:
        UnresolvedError: It may be one of several.
    """
    if where.of.name == "back" and told.remembers and told.source_of(root) is None:
        return {"to": tasks.WHERE_IT_WAS}
    of = there(told, where.of, root)
    if of.sort in (*THINGS, "door"):
        raise ask(f"into the {of.kind}, or on it?")
    value = destination(told, of)
    if of.sort == "container":
        return {"action": "put_in", "to": value}
    return {"to": value} if of.sort == "room" else {"on": value}


def walked_to(told: Discourse, of: Nominal | Relative) -> tuple[Any, Nominal | Relative | None]:
    """Where the robot goes, and what was named by it.

    Raises:
        UnresolvedError: It may be one of several.
    """
    if not isinstance(of, Nominal) or (of.reference not in ("it", "them") and of.name != "back"):
        return place(told, of, -1), of
    if of.name == "back":
        if len(told.walks) != 1:
            raise ask("back to where?", ["the start", *(f"the {one.kind}" for one in told.walks[:-1])])
        return "start", Nominal("room", "start")
    recent = told.recent()
    if is_them(of) and told.people and not recent:
        return destination(told, person_meant(told, of)), None  # "find a person and go to them"
    places = list(dict.fromkeys(one.of for one in told.places))
    if not recent and len(places) == 1 and not is_them(of):
        return destination(told, places[0]), places[0]  # "point at the door and walk to it"
    if len(recent) != 1 or recent[0].of.sort == "animal":
        raise ask("what does 'it' stand for?")
    return ObjectOf(recent[0].task), None


def on_a_shelf(told: Discourse, of: Any) -> Any:
    """A place, "the top shelf" as the one of the fridge that stands open.

    Raises:
        UnresolvedError: It may be another one.
    """
    if not isinstance(of, Nominal) or of.kind not in listed("shelf") or of.relation is not None:
        return of
    standing = standing_open(told)
    if not standing or of.ordinal not in listed("levels") or of.owner is not None:
        return of
    (container, task), *others = standing.items()
    if others or told.backwards or told.actions_since(task) & LEAVES:
        raise ask(f"the {of.ordinal} shelf of the {container.kind}, or another one?")
    return replace(of, relation=Relative("in", container))


def implied_source(told: Discourse, said: Any, named: Nominal) -> tuple[Nominal, Any] | None:
    """What a thing is taken out of, counted or looked for in where that is not said, and as a slot's value.

    That is the only thing that stands open before the robot, or into which it just looked.
    """
    if named.sort not in THINGS or named.relation is not None or named.reference:
        return None
    before = [step for step in told.steps if step.clause < told.clause or step.said.get("source") is not None]
    takes = said.action in ("count", "find", "pick") or (said.action == "hand_over" and not told.held)
    if before and before[-1].said.get("looks_in") and takes:
        looked = before[-1].said.get("to")
        return looked, destination(told, looked)
    if not said.get("out") and said.action != "count":
        return None
    places = list(dict.fromkeys(one.of for one in told.places if one.of.sort in ("container", "furniture")))
    if said.get("out") and not told.opened and len(places) == 1 and places[0].sort == "container":
        stated = any(one.of == places[0] for one in told.as_named("about"))
        return (places[0], destination(told, places[0])) if stated else None
    opened = standing_open(told)
    unclear = len(places) != 1 if said.get("out") else told.backwards
    if unclear or len(told.opened) != 1 or len(opened) != 1:
        return None
    ((of, task),) = opened.items()
    since = told.actions_since(task + 1)
    if of.sort != "container" or (since & LEAVES if said.get("out") else not since <= _SEES):
        return None
    return of, ObjectOf(told.steps[task].root)


def inside_of(told: Discourse) -> ObjectOf:
    """What is looked into: the only thing that was opened, while it is open.

    Raises:
        UnresolvedError: Nothing was, or several things, or it may be what something was put into.
    """
    since = told.actions_since(told.opened[-1]) if told.opened else frozenset()
    if len(told.opened) != 1 or since & {"close", "place", *LEAVES} or told.mentioned:
        raise ask("into what?")
    return ObjectOf(told.opened[0])
