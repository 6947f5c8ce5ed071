"""The guarded motions that run, and the grippers: those that a motion guides and those that are kept."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from kinematics.arrays import Array
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from robots.control.gate.authority import Authority
from robots.control.grip.grip_keeper import GripKeeper
from robots.control.guarded.body_checker import BodyChecker
from robots.control.guarded.guarded_motion import BodyMotion, GuardedMotion
from robots.control.guarded.guarded_track import GuardedTrack
from robots.control.motion_handle import MotionHandle


class GuardedTracks:
    """Runs guarded motions side by side; each holds the joints that it declares.

    A gripper's joint goes from its keeper to the motion that guides it, and back when that ends.

    Attributes:
        keepers: What the grippers do between motions.
    """

    def __init__(self, model: RobotModel, keepers: Mapping[Hand, GripKeeper], authority: Authority) -> None:
        """Keep every gripper where it is.

        Args:
            model: The robot.
            keepers: What the grippers do between motions.
            authority: Book of who moves which joint.
        """
        self._model = model
        self.keepers = dict(keepers)
        self._authority = authority
        self._running: tuple[GuardedTrack, ...] = ()
        for keeper in self.keepers.values():
            authority.claim(_grip(keeper), keeper.joints.names)

    @property
    def running(self) -> tuple[GuardedTrack, ...]:
        """Those that run, in the order in which they began."""
        return self._running

    @property
    def moves_body(self) -> bool:
        """Whether one of them moves a body joint."""
        return any(track.moves_body for track in self._running)

    @property
    def in_contact(self) -> bool:
        """Whether one of them holds something which may not move."""
        return any(track.in_contact for track in self._running)

    @property
    def still(self) -> bool:
        """Whether none runs and no gripper is commanded to move."""
        fingers = any(keeper.moving for keeper in self.keepers.values())
        return not self._running and not fingers

    def start(self, motion: GuardedMotion, handle: MotionHandle, standing: StandingRobot) -> str | None:
        """Begin one; gives the reason why not, or None.

        Args:
            motion: The motion.
            handle: Its handle.
            standing: The robot where it stands.
        """
        joints = motion.bounds.joints
        unjudged = self._unjudged(motion)
        if unjudged:
            return (
                f"{motion.name} moves {', '.join(unjudged)}, and says neither where the body is then nor "
                "what it must not touch: only a BodyMotion moves more than head and fingers"
            )
        kept = [keeper for keeper in self.keepers.values() if keeper.joint in joints]
        if any(self._guide_of(keeper) is not None for keeper in kept):
            return f"{kept[0].joint} is moved by another motion"
        for keeper in kept:
            self._authority.release(_grip(keeper))
        conflict = self._authority.claim(handle.owner, joints)
        if conflict is not None:
            for keeper in kept:
                self._authority.claim(_grip(keeper), keeper.joints.names)
            return f"{conflict[0]} is held by {conflict[1]}"
        checker = BodyChecker(standing, motion) if isinstance(motion, BodyMotion) else None
        actuated, bodies = self._model.description.actuated, len(self._model.joints)
        self._running += (GuardedTrack(motion, handle, actuated, bodies, checker),)
        return None

    def track_of(self, handle: MotionHandle) -> GuardedTrack | None:
        """The one that a handle is of, or None."""
        return next((track for track in self._running if track.handle is handle), None)

    def drop(self, track: GuardedTrack) -> None:
        """Take the joints back from one."""
        self._running = tuple(other for other in self._running if other is not track)
        self._authority.release(track.handle.owner)
        for keeper in self.keepers.values():
            if keeper.joints.lead in track.indices:
                self._authority.claim(_grip(keeper), keeper.joints.names)

    def propose_grips(self, q: Array, v: Array) -> list[str]:
        """Write the grippers' part of a setpoint; gives the owners of those that are not at rest.

        Args:
            q, v: Positions and velocities of the actuated joints, shape (n,).
        """
        owners = []
        for keeper in self.keepers.values():
            guide = self._guide_of(keeper)
            if guide is not None:
                k = int(np.argmax(guide.indices == keeper.joints.lead))
                keeper.follow(float(guide.q[k]), float(guide.v[k]))
            else:
                before, moved = keeper.setpoint, keeper.moving
                if keeper.propose() != before or moved or keeper.moving:
                    owners.append(_grip(keeper))
            keeper.write(q, v)
        return owners

    def commit(self) -> None:
        """The last proposal is what the grippers follow now."""
        for keeper in self.keepers.values():
            keeper.commit()

    def revert(self) -> None:
        """The last proposal was refused: the grippers' setpoints stay where they were."""
        for keeper in self.keepers.values():
            keeper.revert()

    def halt(self) -> None:
        """Rest where the grippers were told to stay."""
        for keeper in self.keepers.values():
            keeper.halt()

    def _unjudged(self, motion: GuardedMotion) -> list[str]:
        """Body joints, but for the head's, of a motion that cannot be judged for collisions and balance."""
        if isinstance(motion, BodyMotion):
            return []
        head = self._model.description.groups.get("head", ())
        return [name for name in motion.bounds.joints if name in self._model.joints and name not in head]

    def _guide_of(self, keeper: GripKeeper) -> GuardedTrack | None:
        return next((track for track in self._running if keeper.joints.lead in track.indices), None)


def _grip(keeper: GripKeeper) -> str:
    return f"grip of {keeper.joint}"
