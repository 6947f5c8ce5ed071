"""Learn from a failed attempt which grasp not to try again."""

from __future__ import annotations

from py_trees.common import Status
from py_trees.ports import PortInformation

from kinematics.requests.grasp import Grasp
from trees.failures import Failure, FailureKind
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import optional, ports

# Parts of a skill in which a failure says something about the grasp.
_GRASP_STAGES = frozenset({"approach", "grasp", "lift", "push"})


class ExcludeGrasp(Leaf):
    """Note after a failed attempt which grasp is not to be tried again.

    It is noted if the failure was its fault: at approach, closing or lift, or because the checker refused its
    motion. When the planner found no grasp at all, those that were noted are forgotten, so that the next
    attempt may use them again.
    """

    INPUT_PORTS = ports(
        failure=Failure, grasp=optional(Grasp), tried=PortInformation(frozenset, default_value=frozenset())
    )
    OUTPUT_PORTS = ports(tried_now=frozenset)
    CONTRACT = Contract(
        precondition="an attempt has failed",
        postcondition="the next plan uses another grasp if this one was to blame",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Judge the failed attempt."""
        failure: Failure = self.get_input("failure")
        grasp: Grasp | None = self.optional("grasp")
        tried: frozenset[str] = self.get_input("tried")
        if failure.kind is FailureKind.INFEASIBLE:
            tried = frozenset()
        elif grasp is not None and _blames_grasp(failure):
            tried = tried | {f"{grasp.hand} {grasp.label}"}
        self._set_output("tried_now", tried)
        self.feedback_message = f"{len(tried)} grasps excluded"
        return DONE


def _blames_grasp(failure: Failure) -> bool:
    return failure.kind is FailureKind.UNSAFE or bool(_GRASP_STAGES & set(failure.where.split("/")))
