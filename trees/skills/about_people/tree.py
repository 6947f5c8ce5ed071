"""See somebody, and tell what is asked about them: here, or to somebody else."""

from __future__ import annotations

from trees.api import Behaviour, Locate, Toolbox, tidily
from trees.beliefs.grounding.destination import PERSON_SLOTS, WHOSE
from trees.beliefs.scene.person_looks import ENOUGH_LOOKS
from trees.skills.about_people.note_about import NoteAbout
from trees.skills.about_people.tell_about import TellAbout
from trees.skills.meeting.tree import found_person, met
from trees.skills.telling.who_speaks import SPEAKER

_OF = (WHOSE,)


def tell(task: object, toolbox: Toolbox) -> Behaviour:
    """See whose, look again, perhaps go to somebody, and say it. Reads "task", writes "evidence".

    Args:
        task: What is to be done.
        toolbox: What leaves may call.
    """
    children: list[Behaviour] = [
        found_person(task, toolbox, _OF),
        *(Locate("look again", toolbox, _OF) for _ in range(1, ENOUGH_LOOKS)),
        NoteAbout("note it", toolbox),
    ]
    if getattr(task, "person", None) not in (None, SPEAKER):
        children += met(task, toolbox, PERSON_SLOTS)
    children.append(TellAbout("tell", toolbox))
    return tidily("tell", children, toolbox, toolbox.policy.walk_timeout_s)
