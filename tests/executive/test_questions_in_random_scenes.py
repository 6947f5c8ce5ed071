"""Ambiguous scenes at random: a question in each, its choices exactly the candidates, then the right object.

The fake robot makes many of them cheap; ``python -m tools.evaluate question`` does the same with physics.
"""

import numpy as np
import pytest

from executive.dialogue.clarification import OpenQuestion
from robots.fake.fake_world import cup

SCENES = 25
COLORS = ("red", "blue", "green")


def ambiguous(rng):
    """Two to four cups in a row, and which of them is meant."""
    places = rng.permutation([-0.36, -0.18, 0.0, 0.18, 0.36])[: int(rng.integers(2, 5))]
    cups = [
        cup(
            f"c{i}",
            str(rng.choice(COLORS)),
            (float(rng.uniform(0.47, 0.55)), float(y) + float(rng.uniform(-0.03, 0.03))),
        )
        for i, y in enumerate(places)
    ]
    row = sorted(cups, key=lambda item: -item.world_T_object[1, 3])
    return row, int(rng.integers(len(row)))


@pytest.mark.requirement("L6")
@pytest.mark.parametrize("seed", range(SCENES))
def test_every_ambiguous_scene_is_asked_about(fake_stage, seed):
    rng = np.random.default_rng([seed, 6])
    row, meant = ambiguous(rng)
    on = fake_stage(*row)
    ticket, asked = on.requests.submit("pick up the cup"), []

    def answer(question: OpenQuestion) -> str:
        assert not on.arms_moved()
        asked.append(question)
        return str(rng.choice([str(meant + 1), question.choices[meant]]))

    ticket.on_question(answer)
    [result] = ticket.result()

    [question] = asked
    assert len(question.choices) == len(set(question.choices)) == len(row)
    assert all(item.color in words for item, words in zip(row, question.choices, strict=True))
    assert result.outcome == "done", result.failure
    held = on.fake.world.object(row[meant].name).world_T_object[2, 3]
    assert held > row[meant].world_T_object[2, 3] + 0.1
