"""Who the robot says that it is."""

from __future__ import annotations

from trees.toolbox import Toolbox


def name_of_robot(toolbox: Toolbox) -> str:
    """The configured name, or that of the model."""
    return toolbox.identity.name or toolbox.model.description.name.upper()


def introduction(toolbox: Toolbox) -> str:
    """Name and team, as far as they are known: "I am Talos, of the team Red."."""
    team = toolbox.identity.team
    return f"I am {name_of_robot(toolbox)}{f', of the team {team}' if team else ''}."
