"""Look around for the object that is meant."""

from __future__ import annotations

from dataclasses import replace

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.failures import Failure
from trees.leaves.go_home import GoHome
from trees.nodes.alternatives import Alternatives
from trees.nodes.judgements import defect, judgement, looking_elsewhere_is_useless
from trees.policy import Gaze
from trees.skills.looking.detect import Detect, Part, is_sure, is_unsure, lost, out_of_view, wants_survey
from trees.skills.looking.look_at import LookAt, LookAtTarget
from trees.toolbox import Toolbox

_HOME_RAD = 0.1
"""Arms nearer than this to their home posture hide nothing more than they do there."""


def search(name: str, toolbox: Toolbox) -> Alternatives:
    """One gaze after the other, until the object is detected.

    When several things fit, or the description compares them, or a part of what the only one stands on is out
    of view, the head looks to both sides before one is chosen or a question is put: what was not in the first
    picture counts as well. What those looks have lost is looked for ahead once more. What is seen unsurely is
    looked at closer, then by all gazes, and in the end a person is asked whether it is the one. What none of
    them shows, and was seen before, is looked for where that was. Eyes that nothing aims look once, those on
    a trunk to both sides as well where they see nothing, and once more before a choice is made.
    """
    policy, survey = toolbox.policy, toolbox.policy.survey_gazes
    upright, *others = policy.search_gazes
    first, upright = replace(upright, lean_rad=policy.first_lean_rad), replace(upright, name="far ahead")
    if toolbox.model.description.camera.fixed:
        aside = [gaze for gaze in others if gaze.pan_rad] if toolbox.model.description.camera.aims else []
        looks = [_look(gaze, toolbox, "first") for gaze in (first, *aside)]
        looks.append(_look(survey[-1], toolbox, "last"))
        looks.append(_look_at_it("before asking", toolbox, "asking"))
        return Alternatives(name, looks, looking_elsewhere_is_useless, as_needed)
    looks = [_look(gaze, toolbox, "first") for gaze in (first, *others, upright, policy.last_gaze)]
    looks.insert(1, _look_at_it("closer", toolbox, "closer"))
    looks += [_look(gaze, toolbox, "side") for gaze in survey[:-1]]
    looks.append(_look(survey[-1], toolbox, "last"))
    looks.append(_look(replace(first, name="ahead again"), toolbox, "again"))
    looks.append(_look_at_it("where it was seen", toolbox, "known"))
    looks.append(_look_at_it("before asking", toolbox, "asking"))
    return Alternatives(name, looks, looking_elsewhere_is_useless, as_needed)


@judgement
def as_needed(look: Behaviour, failure: Failure | None) -> bool:
    """The looks to both sides when they are asked for, one ahead when they lost it, the others when not.

    One at the thing itself when that is seen unsurely, and one at where it was seen before.
    """
    part = next(leaf.part for leaf in look.children if isinstance(leaf, Detect))
    if part in ("closer", "asking"):
        return failure is not None and is_unsure(failure)
    if part == "known":
        return failure is not None and out_of_view(failure)
    if part == "again":
        return failure is not None and lost(failure)
    return (part != "first") == (failure is not None and wants_survey(failure))


def search_from_home_too(toolbox: Toolbox) -> Alternatives:
    """From here, and once more from home where the arms are elsewhere: they may hide what is meant."""
    from_here = search("search", toolbox)
    again: list[Behaviour] = [GoHome("go home", toolbox), search("search", toolbox)]
    from_home = Sequence("look from home", memory=True, children=again)
    ways = Alternatives("look", [from_here, from_home], looking_from_home_is_useless, unless_at_home)
    ways.transparent = True
    return ways


@judgement
def unless_at_home(way: Behaviour, _failure: Failure | None) -> bool:
    """A way that begins by going home, only where the arms are elsewhere; any other always."""
    home = next((leaf for leaf in way.children if isinstance(leaf, GoHome)), None)
    return home is None or not _arms_at_home(home.toolbox)


def _arms_at_home(toolbox: Toolbox) -> bool:
    model = toolbox.model
    groups = model.description.groups
    arms = {joint for hand in model.description.arms for joint in groups[f"{hand}_arm"]}
    off = toolbox.motion.reference()[7:] - model.q_home[7:]
    return all(abs(float(off[i])) <= _HOME_RAD for i, name in enumerate(model.joints) if name in arms)


def _look(gaze: Gaze, toolbox: Toolbox, part: Part) -> Behaviour:
    children: list[Behaviour] = [LookAt("look", toolbox, gaze), Detect("detect", toolbox, part=part)]
    return Sequence(f"look {gaze.name}", memory=True, children=children)


def _look_at_it(name: str, toolbox: Toolbox, part: Part) -> Behaviour:
    """A look at what may be the thing that is meant."""
    children: list[Behaviour] = [
        LookAtTarget("look", toolbox, leaning=True),
        Detect("detect", toolbox, part=part),
    ]
    return Sequence(f"look {name}", memory=True, children=children)


@judgement
def looking_from_home_is_useless(failure: Failure) -> bool:
    """The same, unless arms may have hidden that one of the several is not there any more."""
    return looking_elsewhere_is_useless(failure) and (defect(failure) or is_sure(failure))
