"""Suite ``gpsr``: commands of a field's exam, carried out in an arena by the robot alone."""

from __future__ import annotations

from tools.evaluate.gpsr.command_trial import command_trial
from tools.evaluate.gpsr.oracle import oracle_for
from tools.evaluate.skills.suite import SkillSuite

BAR = 0.80
GPSR = SkillSuite(command_trial, oracle_for, stands=False, bar=BAR)
