"""What fingers on a palm have pushed is told as placed only where the error of a look leaves room."""

import dataclasses

import pytest

from trees.skills.place.tree import place
from trees.skills.place.verify_placed import VerifyPlaced


class OnPalm:
    """A model whose fingers close on a palm, or the same with two pads."""

    def __init__(self, model, palm_side_m):
        self._model = model
        grippers = {
            hand: dataclasses.replace(gripper, palm_side_m=palm_side_m)
            for hand, gripper in model.description.grippers.items()
        }
        self.description = dataclasses.replace(model.description, grippers=grippers)

    def __getattr__(self, name):
        return getattr(self._model, name)


@pytest.mark.requirement("U4")
@pytest.mark.parametrize(("palm_side_m", "tolerance_m"), [(None, 0.02), (0.03, 0.015)])
def test_a_claim_leaves_room_for_the_error_of_the_look(stage, palm_side_m, tolerance_m):
    toolbox = dataclasses.replace(stage.toolbox, model=OnPalm(stage.toolbox.model, palm_side_m))

    last = [leaf for leaf in place(toolbox).iterate() if isinstance(leaf, VerifyPlaced)][-1]

    assert last.tolerance_m == pytest.approx(tolerance_m)
