"""Whom "them", "him" and "her" stand for: who was met, found or greeted before; "it" never is a person."""

import pytest

from executive.language.phrases.handled_thing import IT
from executive.language.phrases.values import Clause, Nominal, draft
from executive.language.resolve.references import UnresolvedError, commands_of
from executive.meaning import command_json
from executive.understanding.command_parser import parse

ANA = Nominal("name", "Ana", determined=True)
BEN = Nominal("name", "Ben", determined=True)
GUEST = Nominal("person", "guest", determined=True)
KITCHEN = Nominal("room", "kitchen", determined=True)
SOFA = Nominal("furniture", "sofa", determined=True)
CUPS = Nominal("thing", "cup", plural=True, count="all", determined=True)
THEM = Nominal("any", reference="them", plural=True, determined=True, said="them")
BOTH = Nominal("any", reference="them", plural=True, determined=True, said="both")
HER = Nominal("person", reference="him", determined=True, said="her")


def commands(*drafts):
    return [command_json(one) for one in commands_of([Clause(((one,),), "base") for one in drafts])]


@pytest.mark.parametrize("met", ["find", "greet", "wave", "follow", "guide"])
@pytest.mark.parametrize("pronoun", [THEM, HER])
@pytest.mark.parametrize("action", ["follow", "guide", "greet"])
def test_a_pronoun_is_the_person_whom_a_task_before_was_about(met, pronoun, action):
    _, last = commands(draft(met, person=ANA), draft(action, person=pronoun))

    assert (last["action"], last["person"]) == (action, "Ana")


def test_who_was_walked_up_to_is_followed_to_a_place():
    _, last = commands(draft("walk_to", to=ANA), draft("follow", person=THEM, to=SOFA))

    assert last == {"action": "follow", "person": "Ana", "to": "sofa"}


def test_who_was_found_somewhere_is_guided_from_there():
    _, last = commands(draft("find", person=GUEST, source=KITCHEN), draft("guide", person=THEM, to=SOFA))

    assert last["person"] == {"kind": "guest", "relation": {"is": "in", "to": "kitchen"}}


def test_what_is_told_may_be_of_whom_was_found():
    _, last = commands(draft("find", person=ANA), draft("tell", about="pose", of=HER))

    assert last == {"action": "tell", "about": "pose", "of": "Ana"}


def test_who_was_met_is_looked_for_elsewhere():
    told = parse("go to Ana in the kitchen, then find them in the bathroom").to_json()["tasks"]

    assert told[-1] == {"action": "find", "person": "Ana", "from": "bathroom"}


def test_both_of_two_are_greeted():
    told = commands(draft("find", person=ANA), draft("find", person=BEN), draft("greet", person=BOTH))

    assert [one["person"] for one in told] == ["Ana", "Ben", "Ana", "Ben"]


@pytest.mark.parametrize(
    "drafts",
    [
        (draft("follow", person=THEM),),
        (draft("find", person=ANA), draft("find", person=BEN), draft("follow", person=THEM)),
        (draft("find", person=ANA), draft("find", person=BEN), draft("guide", person=BOTH, to=SOFA)),
        (draft("find", person=BEN), draft("follow", person=HER)),
        (draft("find", person=ANA), draft("pick", object=CUPS, count="all"), draft("follow", person=THEM)),
        (draft("find", person=ANA), draft("follow", person=IT)),
        (draft("find", person=ANA), draft("pick", object=IT)),
    ],
)
def test_who_may_be_nobody_or_one_of_several_is_asked(drafts):
    with pytest.raises(UnresolvedError) as unresolved:
        commands(*drafts)

    assert unresolved.value.trouble.asks
