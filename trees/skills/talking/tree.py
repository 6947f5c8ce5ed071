"""Say a sentence, or wait."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence

from trees.events import Said
from trees.failures import Failure
from trees.leaves.wait import Wait
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.tasks import SayTask
from trees.toolbox import Toolbox


class Say(Leaf):
    """Say the words of the task, to everybody or to the person that it names."""

    INPUT_PORTS = ports(task=SayTask)
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract("none", "the words were given out", deadline_s=1.0)

    def step(self) -> Status | Failure:
        """Give the words out."""
        task: SayTask = self.get_input("task")
        if not task.words.strip():
            return Failure.postcondition("there is nothing to say")
        to = "" if task.person is None else str(task.person)
        self.toolbox.events(Said(self.toolbox.clock.now_s(), task.words, to))
        self._set_output("evidence", {"said": task.words})
        self.feedback_message = task.words
        return DONE


def say(toolbox: Toolbox) -> Behaviour:
    """Give the words out. Reads "task", writes "evidence"."""
    return Sequence("say", memory=True, children=[Say("give out", toolbox)])


def wait(toolbox: Toolbox) -> Behaviour:
    """Let the time pass. Reads "task", writes "evidence"."""
    return Sequence("wait", memory=True, children=[Wait("hold still", toolbox)])
