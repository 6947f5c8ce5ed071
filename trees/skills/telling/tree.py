"""Find, count and describe: looks from several points of view, then an answer."""

from __future__ import annotations

from collections.abc import Sequence as Many

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.failures import Failure
from trees.leaves.go_home import GoHome, tidily
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.judgements import judgement, looking_elsewhere_is_useless
from trees.policy import Gaze
from trees.skills.looking.locate import Locate
from trees.skills.looking.look_at import LookAt
from trees.skills.looking.search_place import everywhere, search_place
from trees.skills.looking.survey import Survey
from trees.skills.searching.look_elsewhere import turned_around, where_it_may_be, where_it_was, worth_going
from trees.skills.telling.is_about_farther import AsksFarther
from trees.skills.telling.look_past import LookPast
from trees.skills.telling.much_is_hidden import MuchIsHidden
from trees.skills.telling.settings import TellingSettings
from trees.skills.telling.tell import TellCount, TellDescription
from trees.skills.telling.tell_each import TellEach
from trees.skills.telling.tell_found import TellFound
from trees.skills.telling.who_speaks import nobody_spoke, who_speaks
from trees.skills.walking.change_viewpoint import ChangeViewpoint
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.skills.walking.walk_with_room import change_viewpoint
from trees.tasks import CountTask, DescribeTask, Destination, FindTask, ObjectDescription
from trees.toolbox import Toolbox

_TURNS = 2
"""Turns of 1.9 rad: with a look to both sides after each, nothing around the robot is left out."""
_LOOKS_PAST = 2
"""Of a question about what stands on something; to find a thing there are more of them."""
_ELSEWHERE = "look elsewhere"
_OUTLOOKS = 1
"""With one a search in vain takes 176 s of simulated time in the flat: who asks wants an answer."""


def find(toolbox: Toolbox) -> Behaviour:
    """Look from here and past things, then from elsewhere; say where. Reads "task", writes "evidence"."""
    looks = Alternatives(
        "see it",
        [who_speaks(toolbox), _from_here(toolbox), _from_elsewhere(toolbox)],
        nobody_spoke,
        elsewhere_if_it_walks,
    )
    looks.transparent = True
    children: list[Behaviour] = [looks, TellFound("tell", toolbox)]
    return tidily("find", children, toolbox, toolbox.policy.walk_timeout_s)


def _from_here(toolbox: Toolbox) -> Behaviour:
    past: list[Behaviour] = [
        Sequence(
            f"look past {k}",
            memory=True,
            children=[LookPast("peer", toolbox), Locate("locate", toolbox)],
        )
        for k in range(1, toolbox.policy.of(TellingSettings).looks_past + 1)
    ]
    return search_place("look for it", toolbox, everywhere(toolbox), further=past)


def _from_elsewhere(toolbox: Toolbox) -> Behaviour:
    """Where it was seen before, turned around once, then where it may be; at last a look that tells what is
    not found.
    """
    policy = toolbox.policy
    without_leaning = (*policy.level_gazes, *policy.search_gazes[:1])
    around = turned_around(toolbox, without_leaning)
    ways = [where_it_was(toolbox), *around, *where_it_may_be(toolbox, _OUTLOOKS)]
    ways.append(Locate("look once more", toolbox))
    return Alternatives(_ELSEWHERE, ways, looking_elsewhere_is_useless, worth_going)


@judgement
def elsewhere_if_it_walks(way: Behaviour, _failure: Failure | None) -> bool:
    """Looks from elsewhere only where the robot can go there; any other always."""
    turns = (leaf for leaf in way.iterate() if isinstance(leaf, ChangeViewpoint))
    return way.name != _ELSEWHERE or all(turn.toolbox.can_walk for turn in turns)


def find_several(task: FindTask, toolbox: Toolbox) -> Behaviour:
    """Look everywhere, then say where each is. Reads "task", writes "evidence"."""
    wanted = task.person if task.person is not None else task.object
    return tidily("find", [*_looks(wanted, toolbox), TellEach("tell", toolbox)], toolbox)


def count(task: CountTask, toolbox: Toolbox) -> Behaviour:
    """Look everywhere, then say how many. Reads "task", writes "evidence"."""
    return tidily("count", [*_looks(task.object, toolbox), TellCount("tell", toolbox)], toolbox)


def describe(task: DescribeTask, toolbox: Toolbox) -> Behaviour:
    """Look everywhere, then say what is there. Reads "task", writes "evidence"."""
    return tidily("describe", [*_looks(task.object, toolbox), TellDescription("tell", toolbox)], toolbox)


def _looks(wanted: Destination | None, toolbox: Toolbox) -> list[Behaviour]:
    """A survey from each gaze, farther away and all around where that is asked about, and home again."""
    policy, traits = toolbox.policy, isinstance(wanted, ObjectDescription) and bool(wanted.traits)
    level = _surveys(toolbox, policy.level_gazes, traits=traits)
    farther: list[Behaviour] = [AsksFarther("asked for", toolbox), *level]
    around = _all_around(toolbox, traits=traits)
    return [
        BestEffort(Sequence("look farther", memory=True, children=farther)),
        BestEffort(Sequence("look all around", memory=True, children=around)),
        *_surveys(toolbox, policy.of(TellingSettings).inventory_gazes),
        *(BestEffort(_past_what_hides(k, toolbox)) for k in range(1, _LOOKS_PAST + 1)),
        GoHome("go home", toolbox),
    ]


def _past_what_hides(k: int, toolbox: Toolbox) -> Behaviour:
    survey = Survey("survey", toolbox, {"sightings_now": "sightings"})
    hidden = MuchIsHidden("is much hidden", toolbox)
    return Sequence(f"look past {k}", memory=True, children=[hidden, LookPast("peer", toolbox), survey])


def _all_around(toolbox: Toolbox, *, traits: bool) -> list[Behaviour]:
    """Turned around once, where a room is asked about."""
    policy = toolbox.policy
    children: list[Behaviour] = [AsksFarther("room asked for", toolbox, room=True)]
    for _ in range(_TURNS):
        children += [
            ReadyToWalk("stand upright", toolbox),
            change_viewpoint(toolbox, "around"),
            *_surveys(toolbox, (*policy.level_gazes, *policy.search_gazes[:1]), traits=traits),
        ]
    return children


def _surveys(toolbox: Toolbox, gazes: Many[Gaze], *, traits: bool = False) -> list[Behaviour]:
    """A look and a survey for each gaze: a posture that cannot be reached is left out."""
    looks: list[Behaviour] = []
    for gaze in gazes:
        pair: list[Behaviour] = [
            LookAt("look", toolbox, gaze),
            Survey("survey", toolbox, {"sightings_now": "sightings"}, traits=traits),
        ]
        looks.append(BestEffort(Sequence(f"look {gaze.name}", memory=True, children=pair)))
    return looks
