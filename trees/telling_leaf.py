"""A leaf that reads the world model and says something about it."""

from __future__ import annotations

import math
from collections.abc import Iterable
from statistics import fmean

from py_trees.common import Status

from trees.believed_thing import Surroundings, surroundings
from trees.events import Said
from trees.failures import Failure, Number
from trees.grounding import Ambiguous, Missing, ground, is_called
from trees.leaf import DONE, Leaf
from trees.questions import which_is_meant
from trees.shut import why_shut
from trees.stated_confidence import calibrated
from trees.tasks import Destination, ObjectDescription

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

    def confidence(self, names: Iterable[str]) -> dict[str, Number]:
        """Evidence of how often such an answer is right, from how surely things were seen.

        Things are seen or missed each on its own, and what was not seen was missed about as easily as
        what was seen was seen badly; from that to a share of right answers goes a fitted line.
        """
        sightings, policy = self.get_input("sightings"), self.toolbox.policy
        there = math.prod(float(sightings.get(name, _SURE)) for name in names)
        complete = fmean(map(float, sightings.values())) if sightings else _SURE
        raw = there * complete
        stated = calibrated(raw, policy.confidence_slope, policy.confidence_offset)
        return {"confidence": stated, "seen_confidence": raw}

    def fitting(
        self, wanted: ObjectDescription, around: Surroundings, source: Destination | None
    ) -> tuple[str, ...] | Failure:
        """Names of all things that fit; none is no failure, if where they would be was seen."""
        if isinstance(source, str):
            if not any(is_called(thing.name, source) for thing in around.things):
                return Failure.postcondition(f"no {source} seen")
            if (shut := why_shut(self.toolbox.world.scene, source)) is not None:
                return shut
        answer = ground(wanted, around, source, "all")
        if isinstance(answer, Ambiguous):
            return which_is_meant(answer)
        return () if isinstance(answer, Missing) else answer.names
