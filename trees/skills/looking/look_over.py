"""Look to both sides, so that what stands there is known before a hand goes there."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.nodes.best_effort import BestEffort
from trees.skills.looking.look_at import LookAt
from trees.skills.looking.survey import Survey
from trees.toolbox import Toolbox


def look_over(toolbox: Toolbox) -> Behaviour:
    """Both sides, as far as the head gets there; what was seen, and from where, is in the world model."""
    looks: list[Behaviour] = []
    for gaze in toolbox.policy.survey_gazes:
        children: list[Behaviour] = [
            LookAt("look", toolbox, gaze),
            Survey("survey", toolbox, {"sightings_now": "sightings"}),
        ]
        looks.append(BestEffort(Sequence(f"look {gaze.name}", memory=True, children=children)))
    return Sequence("look it over", memory=True, children=looks)
