"""Say what time and day it is, and who the robot is."""

from __future__ import annotations

from trees.api import DONE, Contract, Failure, Leaf, Place, Said, Status, optional, ports
from trees.beliefs.grounding.person_words import name_of
from trees.beliefs.grounding.report_words import listed
from trees.skills.answer.answers import QUESTIONS, answer_to


class Answer(Leaf):
    """Answer the question of the task: to the person who was met, or to everybody."""

    INPUT_PORTS = ports(task=object, place=optional(Place))
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="whom the answer is for was met",
        postcondition="the answer was given out; that something is not known is an answer, too",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Give the answer out."""
        toolbox, asked = self.toolbox, self.get_input("task").question
        now_s = toolbox.clock.now_s()
        name = toolbox.model.description.name
        words = answer_to(asked, toolbox.calendar.at(now_s), toolbox.identity, name)
        if words is None:
            return Failure.infeasible(f"there is no answer to {asked!r}, only to {listed(QUESTIONS)}")
        place: Place | None = self.optional("place")
        to = "" if place is None else name_of(place)
        toolbox.events(Said(now_s, words, to))
        self._set_output("evidence", {"said": words, "asked": asked})
        self.feedback_message = words
        return DONE
