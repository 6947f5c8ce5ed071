"""Lead a person to a place."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.leaves.go_home import tidily
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.judgements import looking_elsewhere_is_useless
from trees.skills.guide.find_goal import FindGoal
from trees.skills.guide.lead import Lead
from trees.skills.guide.settings import GuideSettings
from trees.skills.guide.speak_to_guest import SpeakToGuest
from trees.skills.looking.look_at import LookAt
from trees.skills.walk_to.choose_stand import ChooseStand
from trees.skills.walk_to.tree import find_place, walks
from trees.skills.walking.draw_arms_in import DrawArmsIn
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.toolbox import Toolbox


def guide(toolbox: Toolbox) -> Behaviour:
    """Go to the person, lead the way, wait for who stays behind. Reads "task", writes "evidence"."""
    policy = toolbox.policy
    children: list[Behaviour] = [
        _know_goal(toolbox),
        find_place(toolbox),
        walks(toolbox, ChooseStand("choose where to stand", toolbox)),
        ReadyToWalk("stand upright", toolbox),
        BestEffort(DrawArmsIn("draw the arms in", toolbox)),
        SpeakToGuest("ask to follow", toolbox, "invite"),
        Lead("lead", toolbox),
        SpeakToGuest("tell of the arrival", toolbox, "arrive"),
        BestEffort(DrawArmsIn("let the arms out", toolbox, out=True)),
    ]
    return tidily("guide", children, toolbox, policy.of(GuideSettings).longest_s + policy.walk_timeout_s)


def _know_goal(toolbox: Toolbox) -> Behaviour:
    """From the map, from what was seen, or by looking about."""
    ways: list[Behaviour] = [FindGoal("know where to", toolbox)]
    for gaze in toolbox.policy.level_gazes:
        looks: list[Behaviour] = [LookAt("look", toolbox, gaze), FindGoal("see where to", toolbox)]
        ways.append(Sequence(f"look {gaze.name}", memory=True, children=looks))
    return Alternatives("find out where to", ways, looking_elsewhere_is_useless)
