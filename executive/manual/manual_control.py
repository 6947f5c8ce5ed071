"""Carries out what a person says who has taken the robot over, a tick at a time.

Whatever is said goes the way of every motion: through a guarded motion, the online checker and the gate. The
base goes only where the range sensor sees room, fingers only as far as they close by themselves.
"""

from __future__ import annotations

import math

from executive.manual.base_room import body_meets, slower, why_no_room
from executive.manual.standing_look import StandingLook
from executive.manual.words import BaseJog, GripJog, HeardWord, JogFeed
from kinematics.following.jog_reference import HandJog, JointJog
from kinematics.model.robot_description import Hand
from kinematics.model.walking_settings import WalkingSettings
from kinematics.scene.planning_scene import PlanningScene
from kinematics.walking.pattern.steering import VelocitySteering
from kinematics.walking.route.swept_body import SweptBody
from robots.control.motion_handle import MotionHandle, MotionStatus
from trees.skills.walking.walking_leaf import without_held
from trees.skills.walking.walking_room import walking_room
from trees.toolbox import JoggingMotion, Toolbox

_LOOK_EVERY_S = 0.1
"""From one look at what the range sensor sees to the next."""


class ManualControl:
    """The robot in a person's hands.

    Args:
        toolbox: What moves the robot, and what it senses.
        feed: What the person says.
    """

    def __init__(self, toolbox: Toolbox, feed: JogFeed) -> None:
        self._toolbox, self._feed = toolbox, feed
        self._jogging: JoggingMotion | None = None
        self._touching = False
        self._walk: MotionHandle | None = None
        self._wanted = (0.0, 0.0)
        self._finishing = False
        self._grip: tuple[Hand, bool, MotionHandle] | None = None
        self._steered = 0
        self._look = StandingLook(toolbox)
        self._scene_version = -1
        self._looked_s = -math.inf
        self._blocked = ""
        self._asked: BaseJog | None = None
        self._allowed = BaseJog(0.0, 0.0)

    @property
    def at_rest(self) -> bool:
        """Whether nothing of what was said goes on."""
        walking = self._toolbox.walking
        jogs = self._jogging is not None and not self._jogging.handle.finished
        grips = self._grip is not None and not self._grip[2].finished
        return not (jogs or grips or (walking is not None and walking.active))

    def tick(self) -> None:
        """Go on by one tick: obey the newest word while it is good, else brake."""
        heard = self._feed.fresh(self._toolbox.clock.now_s())
        word = None if heard is None else heard.word
        if not isinstance(word, GripJog):
            self._hold_fingers()
        if not isinstance(word, BaseJog):
            self._stand()
        self._look.tick(self._stands_still)
        told = ""
        match word:
            case GripJog():
                told = self._move_fingers(word)
            case BaseJog():
                told = self._move_base(word)
            case HandJog() | JointJog() if heard is not None:
                told = self._move_body(heard, word)
        if word is None or isinstance(word, BaseJog):
            self._rest_body(ends=isinstance(word, BaseJog))
        if told or word is not None:
            self._feed.told = told

    @property
    def _stands_still(self) -> bool:
        walking, jogging = self._toolbox.walking, self._jogging
        jogs = jogging is not None and not jogging.handle.finished and jogging.report.moving
        return not (jogs or (walking is not None and walking.active))

    def end(self) -> None:
        """Bring everything to rest."""
        self._hold_fingers()
        self._stand()
        self._rest_body(ends=True)

    # ---------------------------------------------------------------- trunk, arms, head

    def _move_body(self, heard: HeardWord, word: HandJog | JointJog) -> str:
        if self._walk is not None:
            return "it still walks: it stands within two steps"
        jogging = self._jogging
        if jogging is not None and not jogging.handle.finished and self._knows_better(jogging):
            jogging.finish()
            return ""
        if jogging is None or jogging.handle.finished:
            if self._toolbox.jogging is None:
                return f"{self._toolbox.model.description.name} cannot be jogged here"
            stopped = jogging is not None and jogging.handle.status is not MotionStatus.DONE
            if jogging is not None and stopped and self._steered == heard.number:
                return jogging.handle.reason or "it was stopped"
            self._touching, self._scene_version = self._feed.may_touch, self._toolbox.world.scene.version
            jogging = self._jogging = self._toolbox.jogging.start(self._scene())
            if jogging.handle.finished:
                self._steered = heard.number
                return jogging.handle.reason
        if heard.number != self._steered:
            jogging.steer(word)
            self._steered = heard.number
        return jogging.report.held_back

    def _knows_better(self, jogging: JoggingMotion) -> bool:
        """Whether what it goes by is old: it begins anew, when it rests."""
        touches = self._touching != self._feed.may_touch
        return touches or (
            self._scene_version != self._toolbox.world.scene.version and not jogging.report.moving
        )

    def _rest_body(self, ends: bool) -> None:
        if self._jogging is None or self._jogging.handle.finished:
            return
        if ends:
            self._jogging.finish()
        elif self._feed.newest is None:  # taken back: silence brakes by itself
            self._jogging.brake()

    def _scene(self) -> PlanningScene:
        """What is around; fingers that may touch may come near to what can be picked up."""
        scene = self._toolbox.world.scene
        if not self._touching:
            return scene
        grippers = self._toolbox.model.description.grippers.values()
        links = [link for gripper in grippers for link in gripper.touch_links]
        things = [item.name for item in scene.objects.values() if item.movable]
        return scene.allowing((link, thing) for link in links for thing in things)

    # ---------------------------------------------------------------- fingers

    def _move_fingers(self, word: GripJog) -> str:
        gripper = self._toolbox.grippers.get(word.hand)
        if gripper is None:
            return f"there are no fingers at the {word.hand} hand"
        if self._grip is not None and self._grip[:2] == (word.hand, word.opens):
            if not self._grip[2].finished:
                return ""
            if self._grip[2].status is MotionStatus.DONE:
                return "" if word.opens else self._felt(word.hand)
        else:
            self._hold_fingers()
        handle = gripper.open() if word.opens else gripper.close()
        self._grip = word.hand, word.opens, handle
        return handle.reason

    def _felt(self, hand: Hand) -> str:
        reading = self._toolbox.grippers[hand].reading()
        if reading.holding:
            return f"the fingers hold something {reading.opening_m * 1000:.0f} mm wide"
        return "the fingers are closed, and hold nothing"

    def _hold_fingers(self) -> None:
        if self._grip is not None and not self._grip[2].finished:
            self._toolbox.motion.cancel(self._grip[2], "the key was let go")
            self._grip = None

    # ---------------------------------------------------------------- base

    def _move_base(self, word: BaseJog) -> str:
        walking, settings = self._toolbox.walking, self._toolbox.model.description.walking
        if walking is None or settings is None:
            return f"{self._toolbox.model.description.name} cannot walk here"
        if self._jogging is not None and not self._jogging.handle.finished:
            return ""  # it comes to rest first
        if word == BaseJog(0.0, 0.0):
            self._stand()
            return ""
        word = self._roomy(word, settings)
        wanted = (word.linear_m_s, word.angular_rad_s)
        if wanted == (0.0, 0.0):
            self._stand()
            return self._blocked
        if self._walk is None:
            if walking.active:
                return ""  # its last steps
            self._walk = walking.walk(VelocitySteering(settings, *wanted, quick=True), "jog the base")
            self._wanted, self._finishing = wanted, False
        elif self._walk.finished or self._finishing:
            why = self._walk.reason if self._walk.status is MotionStatus.REFUSED else ""
            self._stand()
            return why
        elif wanted != self._wanted:
            walking.steer(self._walk, VelocitySteering(settings, *wanted, quick=True))
            self._wanted = wanted
        return self._blocked

    def _stand(self) -> None:
        """Bring a walk to its end; it is forgotten once the robot stands."""
        walking, walk = self._toolbox.walking, self._walk
        if walking is None or walk is None:
            return
        if walk.finished:
            if not walking.active:
                self._walk = None
        elif not self._finishing:
            walking.finish(walk)
            self._finishing = True

    def _roomy(self, word: BaseJog, settings: WalkingSettings) -> BaseJog:
        """The word as fast as hands and body have room; looked at a few times a second, or for a new word."""
        toolbox, now_s = self._toolbox, self._toolbox.clock.now_s()
        if toolbox.ranging is None:
            return word
        if word == self._asked and now_s - self._looked_s < _LOOK_EVERY_S:
            return self._allowed
        self._allowed, self._asked = BaseJog(0.0, 0.0), word
        points = toolbox.ranging.scan()
        if points is None:
            self._blocked = "the range sensor has shown nothing yet"
            return self._allowed
        self._looked_s = now_s
        seen, room = without_held(toolbox, points), walking_room(toolbox, settings)
        body = SweptBody(toolbox.model, toolbox.sensing.state().q, toolbox.world.scene, settings)
        turns_on = word.linear_m_s == 0.0 and self._walk is not None
        self._blocked = ""
        for tried in slower(word):
            why = body_meets(body, settings, tried)
            if not why and not turns_on:
                why = why_no_room(room, seen, settings, tried)
            if not why:
                self._allowed = tried
                break
            self._blocked = self._blocked or why
        return self._allowed
