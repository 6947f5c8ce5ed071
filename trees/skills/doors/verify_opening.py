"""See how far a door or drawer is open, after the hand has left it."""

from __future__ import annotations

from py_trees.common import Status

from trees.beliefs.openings.handles import SHUT, HandleTarget, opening_in
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import optional, ports
from trees.skills.looking.look_leaf import LookLeaf, View, estimates_of
from trees.tasks import OpenTask


class VerifyOpening(LookLeaf):
    """Look at a door or drawer, and measure whether it is as far open or closed as the task asks.

    One that swung back or sprang open again is noticed like this. When the camera does not see it, the
    opening counts that the hand has felt.
    """

    INPUT_PORTS = ports(task=object, handle=HandleTarget, opening=optional(float), opened=optional(dict))
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="the hand is clear of it, the head at rest",
        postcondition="it was seen, or if it is out of sight felt, to be as far open as the task asks",
        deadline_s=2.0,
    )

    def judge(self, views: list[View]) -> Status | Failure:
        """Compare what is seen with what was felt and with what was asked."""
        target: HandleTarget = self.get_input("handle")
        # what a pushing hand felt of its way is not the door's
        felt = None if target.pushed else self.felt()
        seen = opening_in(estimates_of(views), target.kind, self.toolbox.world.scene, target)
        best = seen if seen is not None else felt
        if best is None:
            return Failure.postcondition(f"the {target.part} is out of sight")
        evidence = dict(self.optional("opened") or {})
        evidence[f"opening_{target.unit}"] = round(target.shown(best), 3)
        if felt is not None:
            evidence[f"felt_{target.unit}"] = round(target.shown(felt), 3)
        evidence["seen"] = seen is not None
        self.measured(**evidence)
        opening = isinstance(self.get_input("task"), OpenTask)
        enough = best >= target.open_enough if opening else best <= SHUT[target.kind]
        if not enough:
            state = "open" if opening else "closed"
            # before a hand has moved it, it did not fail to stay so
            is_not = "is not" if self.optional("opened") is None else "did not stay"
            reason = Reason.KIND_ONLY if seen is None else Reason.SEEN_NOT_AS_ASKED
            message = f"the {target.part} {is_not} {state}"
            return Failure.postcondition(message, None, **evidence).because(reason)
        self._set_output("evidence", evidence)
        self.feedback_message = f"{target.shown(best):.2f} {target.unit}"
        return DONE

    def felt(self) -> float | None:
        """The opening that the hand has felt."""
        felt: float | None = self.optional("opening")
        return felt


class IsItSo(VerifyOpening):
    """As ``VerifyOpening``, before anything is moved: that it is not as asked is an answer, not a failure.

    It is seen or not known: what an attempt before has felt tells nothing about what came of it.
    """

    ASKS = True

    def felt(self) -> float | None:
        """Nothing."""
        return None
