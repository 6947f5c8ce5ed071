"""Places and descriptions as the slots of a task hold them: what "there", "back" and "in it" stand for.

Each function raises ``UnresolvedError`` with a question where nothing fits, or several places do.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from executive.language.commands.placing import HOLDERS
from executive.language.phrases.values import Draft, Nominal, Relative, Trouble, Where
from executive.language.resolve.antecedents import of_one_kind, said_again, told_of
from executive.language.resolve.discourse import LEAVES, THINGS, Discourse, UnresolvedError, ask, is_them
from executive.language.resolve.kinds import listed
from executive.language.resolve.people import asker_or_met, person_meant
from executive.references import references
from trees.tasks import WHERE_IT_WAS, ObjectDescription, ObjectOf, Relation

_SEES = frozenset({"count", "find", "look_at", "describe"})
"""Tasks after which what was opened is still looked into."""

_TELLS_APART = ("color", "size", "material", "ordinal")


def described(told: Discourse, of: Nominal) -> ObjectDescription | str:
    """A thing, a place or a person that is told by words, as a slot's value: a name alone is that name."""
    relation = of.relation
    if of.sort == "name" and relation is None:
        return str(of.kind)
    if of.sort == "name":
        of = replace(of, kind=None, name=of.kind)
    if of.kind is not None and not of.is_place:
        told = replace(told, kind=of)
    beside = None if relation is None else Relation(relation.kind, _neighbor(told, relation.to))
    return ObjectDescription(**{**told_of(of), "relation": beside})


def destination(told: Discourse, of: Nominal) -> Any:
    """A place, a person or a thing that is told by words, as the value of a slot."""
    before = said_again(told, of)
    if isinstance(before, ObjectOf) and of.is_single:
        return before
    named = told.same_kind(before if isinstance(before, Nominal) else of)
    if named.sort in ("me", "you"):
        return named.kind
    if named.sort != "name" and (named.count != 1 or (named.plural and not named.reference)):
        raise UnresolvedError(Trouble(f"several places at once ({named.kind!r}): name one", named.kind))
    if named.is_place and named.is_plain:
        return named.kind
    relation = named.relation
    in_front = relation is not None and relation.kind == "in_front_of" and relation.to.sort == "you"
    if in_front and named.kind == "person" and replace(named, relation=None).is_plain:
        return "in_front"
    return described(told, named)


def place(told: Discourse, of: Nominal | Relative, root: int, *, into: bool = False) -> Any:
    """Where the thing of a task goes, perhaps ``into`` it, or comes from, or who gets it."""
    if isinstance(of, Relative):
        return ObjectDescription(relation=Relation(of.kind, _neighbor(told, of.to, root)))
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
    return destination(told, _another(told, of) if of.anaphoric else of)


def _another(told: Discourse, of: Nominal) -> Nominal:
    """What "the blue one" is: of the only sort that was named and holds things, else of what is handled."""
    named = (*told.places, *told.mentioned, *told.things)
    holders = {one.of.kind: one.of for one in named if one.of.is_place or one.of.kind in HOLDERS}
    held = any(one.task in told.held and one.of.kind in holders for one in told.things)
    last = told.kind or of
    if len(holders) == 1 and not held and not last.is_place and last.kind not in HOLDERS:
        (holder,) = holders.values()
        return replace(of, kind=holder.kind, sort=holder.sort, anaphoric=False, said="")
    of_one_kind(told, *(one.of for one in (*told.places, *told.mentioned)))
    slots = [slot for slot in _TELLS_APART if getattr(of, slot) is not None]
    if not last.is_place and all(getattr(last, slot) is None for slot in slots):
        raise ask("which one is meant?")  # "put the can on the left one"
    return of


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
    """What "it" is, unless it was another thing in this clause: "put the cup in it, the can next to it"."""
    here = [step for step in told.steps if step.clause == told.clause]
    if any(references(step.command) - {step.root, task} for step in here):
        raise ask("what does 'it' stand for?")
    return ObjectOf(task)


def _inner(told: Discourse, root: int, *, into: bool) -> Any:
    """A reference inside a place: "in it", "next to it"."""
    sorts = ("container",) if into else ("furniture", "container")
    recent = told.recent((*THINGS, "container", "furniture", "door", "room"), root)
    recent = [one for one in recent if not into or one.of.sort in (*THINGS, "container")]
    acted = [one.of for one in recent]
    named = dict.fromkeys(one.of for one in told.places if one.of.sort in sorts and one.of not in acted)
    walked = told.walks[-1:] if told.last_action == "walk_to" and not into else []
    if not told.mentioned and walked and all(one.sort == "container" for one in acted) and walked[0] in named:
        return destination(told, walked[0])  # "close the fridge, walk to the table, put the cup on it"
    if not told.mentioned and not recent and len(named) == 1:
        return destination(told, next(iter(named)))
    if len(recent) != 1 or named or told.mentioned or (walked and recent[0].of.sort == "container"):
        raise ask("what does 'it' stand for?")
    (one,) = recent
    if one.task in told.held or one.task in told.moved("hand_over") or one.is_several:
        raise ask(f"the {one.of.kind or 'one'} is moved by then: shall it be put there?")
    return _same_it(told, one.task)


def there(told: Discourse, of: Nominal, root: int) -> Nominal:
    """The one place that was named and that the thing is not at already, or for "back" the one it was at."""
    source = told.source_of(root)
    if of.name == "back":
        if source is None:
            raise ask("where shall it be put back to?")
        return source
    beside = [one.of for one in told.as_named("beside") if one.of.is_place]
    named = [one for one in dict.fromkeys((*(one.of for one in told.places), *beside)) if one != source]
    if told.last_action == "walk_to":  # just now, unless another place was named since
        last = [one.of for one in told.places][-1:]
        named = [one for one in named if [one] == last == told.walks[-1:]]
    if len(named) != 1:
        raise ask("which place does 'there' stand for?", [f"the {one.kind}" for one in named])
    return named[0]


def put_there(told: Discourse, where: Where, root: int) -> dict[str, Any]:
    """The slots of a place task whose place was named before."""
    if where.of.name == "back" and told.remembers and told.source_of(root) is None:
        return {"to": WHERE_IT_WAS}
    of = there(told, where.of, root)
    if of.sort in (*THINGS, "door"):
        raise ask(f"into the {of.kind}, or on it?")
    value = destination(told, of)
    if of.sort == "container":
        return {"action": "put_in", "to": value}
    return {"to": value} if of.sort == "room" else {"on": value}


def walked_to(told: Discourse, of: Nominal | Relative) -> tuple[Any, Nominal | Relative | None]:
    """Where the robot goes, and what was named by it."""
    if isinstance(of, Nominal) and of.name == "back":
        if len(told.walks) != 1:
            raise ask("back to where?", ["the start", *(f"the {one.kind}" for one in told.walks[:-1])])
        return "start", Nominal("room", "start")
    if not isinstance(of, Nominal) or of.reference not in ("it", "them"):
        return place(told, of, -1), of
    recent = told.recent()
    if is_them(of) and not recent:
        return destination(told, person_meant(told, of)), None  # "find a person and go to them"
    if len(recent) != 1 or recent[0].of.sort == "animal":
        raise ask("what does 'it' stand for?")
    return ObjectOf(recent[0].task), None


def as_before(told: Discourse, of: Any) -> Any:
    """A place or a person as it was told before; "the top shelf" as that of the fridge that stands open."""
    if isinstance(of, Nominal) and (of.is_place or of.sort == "person"):
        before = said_again(told, of)
        of = before if isinstance(before, Nominal) else of
    on_a_shelf = isinstance(of, Nominal) and of.kind in listed("shelf") and of.ordinal in listed("levels")
    if not on_a_shelf or of.relation is not None or of.owner is not None or not told.standing_open():
        return of
    (container, task), *others = told.standing_open().items()
    if others or told.backwards or told.actions(task) & LEAVES:
        raise ask(f"the {of.ordinal} shelf of the {container.kind}, or another one?")
    return replace(of, relation=Relative("in", container))


def implied_source(told: Discourse, said: Draft, named: Nominal) -> tuple[Nominal, Any] | None:
    """What a thing is taken out of, counted or looked for in where that is not said, and as a slot's value.

    That is the only thing that stands open before the robot, or into which it just looked.
    """
    if named.sort not in THINGS or named.relation is not None or named.reference:
        return None
    before = [step for step in told.steps if step.clause < told.clause or step.said.get("source") is not None]
    takes = said.action in ("count", "find", "pick") or (said.action == "hand_over" and not told.held)
    if takes and before and before[-1].said.get("looks_in"):
        looked = before[-1].said.get("to")
        return looked, destination(told, looked)
    out, standing = said.get("out"), list(told.standing_open().items())
    holds = {one.of: one.role for one in told.places if one.of.sort in ("container", "furniture")}
    (of, task), *others = standing or [(next(iter(holds), named), -1)]
    unclear = len(holds) != 1 if out else told.backwards or said.action != "count"
    if others or unclear or of.sort != "container":
        return None
    if not standing:  # "the dishwasher is full, take out the plates"
        stated = out and "open" not in told.actions() and holds[of] == "about"
        return (of, destination(told, of)) if stated else None
    since = told.actions(task + 1)
    stays = not since & LEAVES if out else since <= _SEES
    return (of, ObjectOf(told.steps[task].root)) if stays else None


def inside_of(told: Discourse) -> ObjectOf:
    """What is looked into: the only thing that was opened, while it is open."""
    standing = list(told.standing_open().values())
    if len(standing) != 1 or told.actions(standing[0]) & {"place", *LEAVES} or told.mentioned:
        raise ask("into what?")
    return ObjectOf(standing[0])
