"""Can a pick be done at all? A long, independent search answers, for judging how many our planner solves."""

from __future__ import annotations

import pickle
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from kinematics.collision.relaxed_start import relaxed_at
from kinematics.model.robot_model import RobotModel
from kinematics.requests.pick import PickRequest
from kinematics.scene.support_of import supports_of
from tools.benchmark.peers.peer_process import PeerProcess
from tools.benchmark.problems.problem import object_to_json

RUNNER = "pick_search_ompl"
BUDGET_S = 60.0
_ROOT = Path(__file__).parents[2]


@dataclass(frozen=True, slots=True)
class SearchAnswer:
    """What a long search found.

    Attributes:
        solved: A grasp, a posture and a way to it exist. False proves nothing: none was found.
        search_s: Processor time.
        attempts: How many random grasps ended in which way.
    """

    solved: bool
    search_s: float
    attempts: Mapping[str, int]


class LongSearch:
    """OMPL and Coal in an environment of their own, over twelve coordinates of a standing robot.

    Args:
        process: ``peer_process(PeerEnvironment("ompl", cache), RUNNER)``.
        model: The robot, standing at its home.
        folder: Where the robot's data are written for the other side.
        seed: Of the search.
    """

    def __init__(self, process: PeerProcess, model: RobotModel, folder: Path, seed: int = 0) -> None:
        self._process, self._model = process, model
        folder.mkdir(parents=True, exist_ok=True)
        description = folder / f"{model.description.name}.pickle"
        description.write_bytes(pickle.dumps(model.description))
        process.ask("load", root=str(_ROOT), description=str(description), seed=seed)

    def search(self, request: PickRequest, budget_s: float = BUDGET_S) -> SearchAnswer:
        """Search until a pick is found or the budget is used up.

        Args:
            request: As the product's planner gets it; the robot stands at its home stance.
            budget_s: Processor time; the last attempt may take it over by some seconds.
        """
        scene = relaxed_at(self._model, request.scene, request.q_start)
        objects = [{**object_to_json(item), "margin_m": item.margin_m} for item in scene.objects.values()]
        answer = self._process.ask(
            "search",
            objects=objects,
            allowed=[sorted(pair) for pair in scene.allowed],
            target=request.target,
            supports=supports_of(scene.objects[request.target], scene),
            hands=list(request.hands),
            lift_m=request.lift_m,
            q_start=request.q_start.tolist(),
            budget_s=budget_s,
        )
        return SearchAnswer(answer["solved"], answer["search_s"], answer["attempts"])
