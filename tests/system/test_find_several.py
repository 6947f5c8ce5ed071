"""Asked where several things are, the robot looks all over the table and tells each; judged by the truth."""

import numpy as np
import pytest

from executive.embedding.requests import Requests
from executive.session.assembly import assemble
from robots.scenes.scene_file import load_scene


@pytest.mark.requirement("M2")
def test_both_cups_of_the_laid_table_are_told_with_where_they_truly_are():
    assembly = assemble("talos", load_scene("dinner"), 1)

    (result,) = Requests(assembly.session).submit("where are the cups?").result()

    assert result.outcome == "done"
    assert sorted(str(result.evidence["names"]).split(", ")) == ["blue cup", "red cup"]
    truth = assembly.world.truth
    for told in str(result.evidence["said"]).partition(": ")[2].split("; "):
        name, ahead_m = " ".join(told.split()[1:3]), float(told.split(", ")[1].split()[0])
        off_m = truth.world_T_object(name)[:2, 3] - truth.world_T_base()[:2, 3]
        assert np.hypot(*off_m) == pytest.approx(ahead_m, abs=0.15)
