"""Measure that the object was lifted and stays held."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from py_trees.common import Status

from kinematics.dynamics.held_load import loaded, loads_in
from kinematics.estimation.held_centre import HeldCentre
from kinematics.estimation.held_mass import HeldMass
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.requests.grasp import Grasp
from kinematics.scene.planning_scene import AttachedBody
from robots.perception.fusion.gaussian import Innovation
from robots.perception.fusion.hand_senses import compare_places, place_by_hand, place_felt
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.scene.recognition import nearest_sighting
from trees.failures import Failure, Number, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING
from trees.nodes.ports import ports
from trees.port_values import Target
from trees.readings.disagreement import tell_disagreement
from trees.skills.looking.look_leaf import GatheringLeaf, View, estimates_of
from trees.skills.pick.settings import PickSettings
from trees.skills.pick.verify_hold import expected_grasp, grip_failure

_READINGS_APART_S = 0.002
"""Readings are looked for so often; nobody makes them faster."""


class VerifyLift(GatheringLeaf):
    """Watch gripper and camera while the object is held in the air.

    The gripper must measure all the time that it holds something of the object's size; nothing the camera
    sees makes up for that. The camera must agree as far as it sees the object: it has risen, is in the hand,
    and does not move there. When it cannot be seen, the gripper has to hold on for longer, and the evidence
    says that it was not seen. Meanwhile the mass of the object is found from the torques of the arm; later
    motions are planned, checked and carried out with that mass in the hand.

    Where the hand feels the object elsewhere than the camera shows it, it is looked at again; if that shows
    the same, people are told, and the object is taken to be where the hand feels it.
    """

    INPUT_PORTS = ports(grasp=Grasp, target=Target)
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="the lift has ended; the target is an attached body",
        postcondition="the gripper said holding for the whole time; as far as it was seen, the object has "
        "risen, is in the hand and stays there; the scene knows its mass",
        deadline_s=2.0,
        on_success="the hand holds the object",
        on_failure="the gripper goes on pressing on whatever it holds",
        on_cancel="the gripper goes on pressing",
    )

    @property
    def deadline_s(self) -> float:
        """The longest hold that the policy may ask for, and the contract's allowance."""
        settings = self.toolbox.policy.of(PickSettings)
        looking_again_s = settings.hold_s if self._looked_again else 0.0
        return settings.hold_s * settings.unseen_hold_factor + looking_again_s + self.CONTRACT.deadline_s

    _looked_again = False

    def begin(self) -> None:
        """Start to watch."""
        super().begin()
        self._looked_again, self._since_s = False, 0.0
        self._lost_since_s: float | None = None
        self._weighing = self._scales()
        self._centre = HeldCentre(self._weighing)
        self._weighed_s = self.toolbox.sensing.state().readings.stamp_s

    def step(self) -> Status | Failure:
        """Watch the grip at each tick, and judge the pictures at the end of the hold."""
        if (lost := self._lost_grip()) is not None:
            return lost
        self._weigh()
        self.gather()
        settings = self.toolbox.policy.of(PickSettings)
        until_s = self._since_s + settings.hold_s
        if self.elapsed_s < until_s:
            self.feedback_message = f"held for {self.elapsed_s:.1f} of {until_s:.1f} s"
            return RUNNING
        seen = self._seen()
        if isinstance(seen, Failure):
            return seen
        if not seen and self.elapsed_s < settings.hold_s * settings.unseen_hold_factor:
            self.feedback_message = "not seen; held for longer instead"
            return RUNNING
        if self._lost_since_s is not None:
            return RUNNING  # never end on a doubtful reading
        apart = self._felt_apart() if seen else None
        if apart is not None and not self._looked_again:
            self._looked_again, self._since_s = True, self.elapsed_s
            self._views = []
            self.feedback_message = "felt elsewhere than it is seen; looking again"
            return RUNNING
        return self._succeed(seen, apart)

    def _scales(self) -> HeldMass:
        """What weighs it, on a robot that carries what was weighed in the other hand."""
        scene, grasp = self.toolbox.world.scene, self.get_input("grasp")
        return HeldMass(loaded(self.toolbox.model, loads_in(scene)), grasp.hand)

    def _weigh(self) -> None:
        """Take in every reading since the last tick: the noise of one is worth some hundred grams."""
        sensing, bodies = self.toolbox.sensing, len(self.toolbox.model.joints)
        newest = sensing.state()
        now_s = newest.readings.stamp_s
        steps = max(1, round((now_s - self._weighed_s) / _READINGS_APART_S))
        stamps = np.linspace(self._weighed_s, now_s, steps + 1)[1:].tolist()
        read = {one.stamp_s: one for one in (sensing.state_at(stamp_s).readings for stamp_s in stamps)}
        effort = np.mean([one.effort[:bodies] for one in read.values()], axis=0)
        v = np.mean([one.v[:bodies] for one in read.values()], axis=0)
        self._weighing.add(newest.q, v, effort, self._body().frame_T_object[:3, 3], len(read))
        self._centre.add(newest.q, v, effort, len(read))
        self._weighed_s = now_s

    def _lost_grip(self) -> Failure | None:
        grasp = expected_grasp(self.toolbox.world, self.get_input("grasp"), self.get_input("target"))
        reading = self.toolbox.grippers[grasp.hand].reading()
        failure = grip_failure(reading, grasp, self.toolbox.policy.of(PickSettings).opening_tolerance_m)
        if failure is None:
            self._lost_since_s = None
            return None
        if self._lost_since_s is None:
            self._lost_since_s = self.elapsed_s
        if self.elapsed_s - self._lost_since_s < self.toolbox.policy.lost_grip_s:
            return None
        target: Target = self.get_input("target")
        return Failure.postcondition(
            f"the {target.name} was lost after the lift", failure, held_s=self.elapsed_s
        )

    def _seen(self) -> dict[str, float] | Failure:
        """What the pictures say; empty when the object is not to be seen in them."""
        target, body, policy = self.get_input("target"), self._body(), self.toolbox.policy
        settings = policy.of(PickSettings)
        half = len(self._views) // 2
        if half == 0:
            return {}
        early, late = self._in_tcp(self._views[:half]), self._in_tcp(self._views[half:])
        if late is None:
            return {}
        odom_T_tcp = self._odom_T_tcp(self._views[-1])
        off_m = float(np.linalg.norm(late - body.frame_T_object[:3, 3]))
        rise_m = float((odom_T_tcp[:3, :3] @ late + odom_T_tcp[:3, 3])[2] - target.odom_T_object[2, 3])
        numbers: dict[str, float] = {"lift_m": rise_m, "off_m": off_m}
        if off_m > policy.in_hand_tolerance_m:
            return Failure.postcondition(
                f"the {target.name} is seen outside the hand",
                None,
                tolerance_m=policy.in_hand_tolerance_m,
                **numbers,
            )
        if rise_m < settings.lifted_min_m:
            return Failure.postcondition(
                f"the {target.name} has not risen enough",
                None,
                needed_m=settings.lifted_min_m,
                **numbers,
            )
        if early is not None:
            slip_m = float(np.linalg.norm(late - early))
            numbers |= {"slip_m": slip_m}
            if slip_m > settings.slip_max_m:
                return Failure.postcondition(
                    f"the {target.name} is slipping",
                    None,
                    tolerance_m=settings.slip_max_m,
                    **numbers,
                )
        return numbers

    def _felt_apart(self) -> Innovation | None:
        """By how much it is seen elsewhere than fingers and weight feel it, where that is too much."""
        found = self._sighting(self._views)
        if found is None:
            return None
        view = self._views[-1]
        felt = place_felt(self._centre, self._held_at_m())
        innovation = compare_places(felt, found, self._odom_T_tcp(view), view.frame.stamp_s)
        return innovation if innovation is not None and innovation.disagrees else None

    def _held_at_m(self) -> float:
        """Where along the opening the middle of the object is."""
        grasp: Grasp = self.get_input("grasp")
        return grasp.off_centre_m

    def _believe_the_hand(self, apart: Innovation) -> None:
        """Take the thing to be where the hand feels it, which holds it, and say that the camera errs."""
        target, body, scene = self.get_input("target"), self._body(), self.toolbox.world.scene
        failure = Failure.postcondition(
            f"the hand feels the {target.name} {apart.size * 1e3:.0f} mm from where the camera shows it",
            apart_m=apart.size,
            usual_m=apart.sigma,
        )
        tell_disagreement(self.toolbox, failure.because(Reason.FELT_ELSEWHERE).at(self.where))
        tcp_T_object = body.frame_T_object.copy()
        tcp_T_object[:3, 3] = place_by_hand(place_felt(self._centre, self._held_at_m()), tcp_T_object[:3, 3])
        q = self.toolbox.sensing.state().q
        freed = scene.with_detached(target.name, self.toolbox.model.frame_pose(q, body.frame) @ tcp_T_object)
        self.toolbox.world.update(
            freed.with_attached(target.name, body.frame, tcp_T_object, body.touch_links, body.mass_kg)
        )

    def _succeed(self, seen: dict[str, float], apart: Innovation | None) -> Status:
        grasp: Grasp = self.get_input("grasp")
        reading = self.toolbox.grippers[grasp.hand].reading()
        world, mass_kg = self.toolbox.world, self._weighing.mass_kg
        if apart is not None:
            self._believe_the_hand(apart)
        world.update(world.scene.with_held_mass(self.get_input("target").name, mass_kg))
        evidence: dict[str, Number] = {
            "hand": grasp.hand,
            "gripper_opening_m": reading.opening_m,
            **reading.effort,
            "held_s": self.elapsed_s,
            "mass_kg": mass_kg,
            "seen": bool(seen),
            **{key: value for key, value in seen.items() if key != "off_m"},
            **({} if apart is None else {"felt_apart_m": apart.size}),
        }
        self._set_output("evidence", evidence)
        self.measured(**evidence)
        rise = f", risen {seen['lift_m'] * 100:.0f} cm" if seen else ", not seen"
        self.feedback_message = f"held for {self.elapsed_s:.1f} s{rise}"
        return DONE

    def _in_tcp(self, views: list[View]) -> NDArray[np.float64] | None:
        """Where the object is seen in the TCP's frame, shape (3,)."""
        found = self._sighting(views)
        if found is None:
            return None
        odom_T_tcp = self._odom_T_tcp(views[-1])
        place: NDArray[np.float64] = (poses.inverse(odom_T_tcp) @ found.odom_T_object)[:3, 3]
        return place

    def _sighting(self, views: list[View]) -> ObjectEstimate | None:
        """The object as some pictures show it."""
        target, body = self.get_input("target"), self._body()
        expected = (self._odom_T_tcp(views[-1]) @ body.frame_T_object)[:3, 3]
        scene, near = self.toolbox.world.scene, self.toolbox.policy.same_object_m
        found = nearest_sighting(target, expected, estimates_of(views), scene, near)
        return None if found is None else found[0]

    def _body(self) -> AttachedBody:
        return self.toolbox.world.scene.attached[self.get_input("target").name]

    def _odom_T_tcp(self, view: View) -> Transform:
        q = self.toolbox.sensing.state_at(view.frame.stamp_s).q
        return self.toolbox.model.frame_pose(q, self._body().frame)
