"""A leaf that reads the world model and says something about it."""

from __future__ import annotations

import math
from collections.abc import Iterable

from py_trees.common import Status

from trees.believed_thing import Surroundings, surroundings
from trees.events import Said
from trees.failures import Number
from trees.leaf import DONE, Leaf

# A thing that was seen less surely is told as perhaps being there.
_SURE = 0.5


class TellingLeaf(Leaf):
    """Reads the world model, and gives out words with what they rest on."""

    def around(self) -> Surroundings:
        """What is believed, from where the robot stands."""
        toolbox, model = self.toolbox, self.toolbox.model
        base = model.frame_pose(toolbox.sensing.state().q, model.description.base_link)
        gap_m = toolbox.policy.support_gap_m
        return surroundings(toolbox.world.scene, base, gap_m, toolbox.world.last_acted_on)

    def say(self, words: str, evidence: dict[str, Number]) -> Status:
        """Give words out, with what they rest on."""
        self.toolbox.events(Said(self.toolbox.clock.now_s(), words))
        self.measured(**evidence)
        self._set_output("evidence", {"said": words, **evidence})
        self.feedback_message = words
        return DONE

    def confidence(self, names: Iterable[str]) -> float:
        """Chance that all of these are there: things are seen or missed each on its own."""
        sightings = self.get_input("sightings")
        return math.prod(float(sightings.get(name, _SURE)) for name in names)
