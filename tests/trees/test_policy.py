"""Numbers of several skills are the policy's; those of one live with it and can be given all the same."""

import dataclasses
from dataclasses import dataclass

from trees.policy import TreePolicy


@dataclass(frozen=True, slots=True)
class BowSettings:
    depth_rad: float = 0.5


def test_the_settings_of_a_skill_are_the_usual_ones_unless_others_are_given():
    assert TreePolicy().of(BowSettings) == BowSettings()
    assert TreePolicy(skills=(BowSettings(0.2),)).of(BowSettings) == BowSettings(0.2)


def test_the_policy_is_far_from_having_a_number_for_everything():
    assert len(dataclasses.fields(TreePolicy)) < 35
