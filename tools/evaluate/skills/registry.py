"""Every skill's suite by its name."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from tools.evaluate.gpsr import exam
from tools.evaluate.people import following, greeting, guiding
from tools.evaluate.skills import (
    carrying,
    controls,
    errands,
    gestures,
    goals,
    handing_over,
    naming,
    placing,
    putting_in,
    putting_in_drawer,
    putting_in_fridge,
    sequences,
    talk,
    telling,
    walking,
)
from tools.evaluate.skills.suite import SkillSuite
from tools.evaluate.upon import openings, putting_things, regions_and_lids, stacking, things

SKILL_SUITES: Mapping[str, SkillSuite] = MappingProxyType(
    {
        "say": talk.SAY,
        "wait": talk.WAIT,
        "wave": gestures.WAVE,
        "point_at": gestures.POINT_AT,
        "look_at": gestures.LOOK_AT,
        "place": placing.PLACE,
        "put_in": putting_in.PUT_IN,
        "stack": stacking.STACK,
        "regions": regions_and_lids.REGIONS,
        "put_in_drawer": putting_in_drawer.PUT_IN_DRAWER,
        "put_in_fridge": putting_in_fridge.PUT_IN_FRIDGE,
        "things": things.THINGS,
        "in_place": things.IN_PLACE,
        "put_things": putting_things.PUT_THINGS,
        "openings": openings.OPENINGS,
        "turn_knob": controls.TURN_KNOB,
        "press": controls.PRESS,
        "hand_over": handing_over.HAND_OVER,
        "find": telling.FIND,
        "count": telling.COUNT,
        "describe": telling.DESCRIBE,
        "sequence": sequences.SEQUENCE,
        "walk": walking.WALK,
        "walk_stop": walking.WALK_STOP,
        "walk_to": goals.WALK_TO,
        "flat_fridge": errands.FLAT_FRIDGE,
        "names": naming.NAMES,
        "greet": greeting.GREET,
        "carry": carrying.CARRY,
        "flat_pick": errands.FLAT_PICK,
        "flat_bring": errands.FLAT_BRING,
        "follow": following.FOLLOW,
        "follow_lost": following.FOLLOW_LOST,
        "guide": guiding.GUIDE,
        "guide_left": guiding.GUIDE_LEFT,
        "gpsr": exam.GPSR,
    }
)
