"""Say something; wait."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.leaves.wait import Wait
from trees.skills.talking.say import Say
from trees.toolbox import Toolbox


def say(toolbox: Toolbox) -> Behaviour:
    """Give the words out. Reads "task", writes "evidence"."""
    return Sequence("say", memory=True, children=[Say("give out", toolbox)])


def wait(toolbox: Toolbox) -> Behaviour:
    """Let the time pass. Reads "task", writes "evidence"."""
    return Sequence("wait", memory=True, children=[Wait("hold still", toolbox)])
