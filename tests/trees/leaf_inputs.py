"""Inputs of leaves to which no run on the fake robot leads, and the world in which they do their work."""

from dataclasses import replace

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.requests.check import CheckRequest
from kinematics.requests.control import ControlRequest
from kinematics.requests.handle import HandleRequest
from kinematics.requests.place import Spot
from kinematics.scene.planning_scene import SceneObject
from robots.fake.fake_world import cup, person, table
from robots.perception.object_estimate import ObjectEstimate
from robots.perception.truth_view import TrueObject
from robots.scenes.articulated import furniture_T_part, moving_solids, opened
from robots.scenes.furniture import floor_pose, solids
from robots.scenes.scene_description import Region
from robots.scenes.scene_file import load_scene
from tests.trees.cabinet_seen import CABINET, seen, shown
from trees.beliefs.grounding.destination import Place, place_of_region
from trees.beliefs.openings.handles import OPEN_TO, handles_in
from trees.beliefs.scene.held_object import HeldObject
from trees.port_values import CheckedStep, Placement
from trees.skills.about_people.about import About
from trees.skills.about_people.tell_about import TellAbout
from trees.skills.controls.control_target import ControlTarget
from trees.skills.controls.detect_control import DetectControl, VerifyKnob
from trees.skills.controls.fingers import CloseOnKnob, MakeFist
from trees.skills.controls.plan_control import PlanControl, PlanTurn
from trees.skills.controls.press_in import DrawBackFrom, PressIn
from trees.skills.doors.choose_handle import ChooseHandle
from trees.skills.doors.choose_stand_at_handle import ChooseStandAtHandle, WalkToStandAtHandle
from trees.skills.doors.handle.approach_handle import ApproachHandle
from trees.skills.doors.handle.grasp_handle import GraspHandle
from trees.skills.doors.handle.held_handle import HeldHandle
from trees.skills.doors.handle.lead_handle import LeadHandle
from trees.skills.doors.handle.touch_front import TouchFront
from trees.skills.doors.handle_standing import WalkToHandle
from trees.skills.doors.plan_handle import PlanHandle
from trees.skills.doors.reach_watching import ReachWatching
from trees.skills.doors.stands_at_handle import StandsAtHandle, StandsThereAlready
from trees.skills.doors.verify_opening import IsItSo, VerifyOpening
from trees.skills.follow import FollowTask
from trees.skills.follow.see_again import SeeAgain
from trees.skills.follow.walk_behind import WalkBehind
from trees.skills.gestures.turn_to import TurnTo
from trees.skills.guide import GuideTask
from trees.skills.guide.lead import Lead
from trees.skills.guide.speak_to_guest import SpeakToGuest
from trees.skills.hand_over.look_at_taker import LookAtTaker
from trees.skills.meeting.is_near import IsNear
from trees.skills.place.stand_before_spot import AskForWalkThere, ChooseStandToPlace
from trees.skills.place.swap_hands import AskForSwap
from trees.skills.put_in.choose_stand_to_put import ChooseStandToPut
from trees.skills.put_in.find_board_room import FindBoardRoom
from trees.skills.telling.tell_found import TellFound
from trees.skills.walk_to.choose_stand import ChooseStand
from trees.skills.walk_to.see_front import SeeFront
from trees.skills.walk_to.squared_up import SquaredUp
from trees.skills.walking.reachable_standing import Stand
from trees.skills.walking.walk_to import WalkTo
from trees.tasks import ObjectDescription, OpenTask, PlaceTask, PressTask, PutInTask, TurnKnobTask

OPEN = OpenTask("open the fridge", ObjectDescription("fridge"))
(FRIDGE,) = load_scene("fridge").furniture
_AJAR_RAD = 0.3
TURN = TurnKnobTask("turn on the stove", ObjectDescription("stove"))
PRESS = PressTask("press the button", ObjectDescription("button"))


def fridge(opening_rad, away_m=0.0):
    """What is seen of the fridge of that scene, farther away by so much."""
    moved = poses.translation(away_m, 0.0, 0.0)
    part = floor_pose(FRIDGE) @ furniture_T_part(FRIDGE) @ opened(FRIDGE, opening_rad)
    told = [(FRIDGE.kind, solid.shape, solid.world_T_solid) for solid in solids(FRIDGE)]
    told += [(one.kind, one.shape, part @ one.part_T_solid) for one in moving_solids(FRIDGE) if one.kind]
    counts = {}
    for kind, shape, pose in told:
        counts[kind] = counts.get(kind, 0) + 1
        name = kind if counts[kind] == 1 else f"{kind} {counts[kind]}"
        yield TrueObject(name, "furniture", kind, None, shape, moved @ pose)


def believe(stage, things):
    """Have the world model know things where they are."""
    scene = stage.told.scene
    for one in things:
        movable = one.category == "object"
        scene = scene.with_object(SceneObject(one.name, one.shape, one.world_T_object, 0.01, movable=movable))
    stage.told.update(scene)


def clear(stage):
    """Take everything away."""
    for one in stage.fake.world.solids():
        stage.fake.world.remove(one.name)
    stage.told.update(stage.told.scene.with_objects(()))


def before_fridge(stage, opening_rad=0.0, away_m=0.0):
    """Stand before a fridge that is known; gives its handle."""
    clear(stage)
    things = list(fridge(opening_rad, away_m))
    for one in things:
        stage.fake.world.put(one)
    believe(stage, things)
    seen = {
        one.name: ObjectEstimate(one.category, one.kind, None, one.world_T_object, one.shape, 0.9, 8, 0.0)
        for one in things
    }
    (handle,) = handles_in(seen)
    return handle


def body_of_fridge(away_m=0.0):
    """The fridge as a place."""
    top = max(
        (one for one in fridge(0.0, away_m) if one.kind == FRIDGE.kind),
        key=lambda one: one.world_T_object[2, 3],
    )
    return Place("fridge", "furniture", top.shape, top.world_T_object, 0.9)


def far_table(stage):
    """A table that is a short walk away."""
    top = table()
    pose = poses.translation(1.2, 0.0, 0.0) @ top.world_T_object
    clear(stage)
    believe(stage, [replace(top, world_T_object=pose)])
    return {"place": Place("table", "furniture", top.shape, pose, 0.9)}


def far_handle(stage):
    return {"handle": before_fridge(stage, away_m=0.8)}


def handle_of_cabinet(stage):
    """A drawer of a fixture that a robot stands before."""
    things = list(shown(CABINET))
    clear(stage)
    for one in things:
        stage.fake.world.put(one)
    scene = stage.told.scene
    for one in things:
        item = SceneObject(one.name, one.shape, one.world_T_object, 0.01, movable=False, moves=one.moves)
        scene = scene.with_object(item)
    stage.told.update(scene)
    look = seen(CABINET)
    for name, one in look.items():
        item = SceneObject(name, one.shape, one.odom_T_object, 0.01, movable=False, moves=one.moves)
        scene = scene.with_object(item)
    stage.told.update(scene)
    handle = next(one for one in handles_in(look) if one.moves.part == "top drawer")
    return {"task": OpenTask("open the drawer", ObjectDescription("drawer")), "handle": handle}


def stand_at_cabinet(stage):
    """And a place beside it, a short walk away."""
    wired = handle_of_cabinet(stage)
    x, y = wired["handle"].path.at(0.0).position_m[:2]
    return {**wired, "stand": Stand(wired["handle"].handle, -0.4 - float(x), -float(y), 0.0)}


def near_handle(stage):
    return {"handle": before_fridge(stage)}


def open_fridge(stage):
    return {"task": OPEN, "handle": before_fridge(stage, OPEN_TO["door"])}


def cup_to_stand_for(stage):
    believe(stage, [table(), cup()])
    red = cup()
    return {"place": Place("red cup", "object", red.shape, red.world_T_object, 0.9)}


def cup_behind(stage):
    """The red cup as a place, behind the left shoulder; no table is in the way."""
    clear(stage)
    red = cup(place_m=(-0.8, 0.5))
    return {"place": Place("red cup", "object", red.shape, red.world_T_object, 0.9)}


def somebody_near(stage):
    ana = person()
    return {"place": Place("Ana", "person", ana.shape, ana.world_T_object, 0.9)}


def something_to_tell(_stage):
    return {"about": About("Ana is sitting", "Ana", ("sitting",), True)}


def where_it_stands(stage):
    """A place for which the robot stands well already."""
    red = cup()
    place = Place("red cup", "object", red.shape, red.world_T_object, 0.9)
    return {"place": place, "stand": Stand.beside(place, stage.fake.motion.feet())}


def front_seen(stage):
    before_fridge(stage)
    return {"task": OPEN, "known": body_of_fridge()}


def to_put_inside(stage):
    """The robot holds a cup before the boards of an open fridge."""
    before_fridge(stage, OPEN_TO["door"])
    red, frame = cup(), stage.toolbox.model.description.tcp_frames["right"]
    believe(stage, [red])
    scene = stage.told.scene.with_attached(red.name, frame, np.eye(4), ())
    stage.told.update(scene)
    return {"place": body_of_fridge(), "held": HeldObject(red.name, "right", red.shape, np.eye(4))}


def cup_to_put_elsewhere(stage):
    """A cup in the one hand, and a spot on the table for it."""
    top, red, frame = table(), cup(), stage.toolbox.model.description.tcp_frames["right"]
    believe(stage, [top, red])
    stage.told.update(stage.told.scene.with_attached(red.name, frame, np.eye(4), ()))
    return {
        "task": PlaceTask("put it on the table", on="table"),
        "place": Place("table", "furniture", top.shape, top.world_T_object, 0.9),
        "held": HeldObject(red.name, "right", red.shape, np.eye(4)),
        "spots": (Spot(red.world_T_object, ("table",)),),
    }


def planned(stage, opening_rad=0.0):
    """A plan to take hold of the handle."""
    handle = before_fridge(stage, opening_rad)
    motion = stage.fake.motion
    plan = stage.fake.planning.answer(
        HandleRequest(
            motion.reference(),
            motion.stance(),
            stage.told.scene,
            handle.handle,
            (handle.part, handle.handle),
            handle.path,
            handle.opening,
            OPEN_TO["door"],
            handle.hands,
        )
    )
    return handle, plan


def reaching(stage):
    handle, plan = planned(stage)
    checked = stage.fake.planning.verdict(CheckRequest(plan.reach.trajectory, plan.reach.scene))
    return {"handle": handle, "checked": CheckedStep("reach", checked, stage.told.scene.version)}


def hand_at_handle(stage):
    """The open hand is about the bar."""
    handle, plan = planned(stage, _AJAR_RAD)
    stage.fake.motion.be_at(plan.approach.trajectory.q[-1])
    stage.fake.step()
    return {"handle": handle, "grasp": plan.grasp}


def handle_in_hand(stage):
    """The hand holds the bar."""
    given = hand_at_handle(stage)
    handle, grasp = given["handle"], given["grasp"]
    closing = stage.fake.grippers[grasp.hand].close()
    while not closing.finished:
        stage.fake.step()
    return {"held": HeldHandle(handle, grasp, handle.path, None), "lead_to": OPEN_TO["door"]}


def hand_before_handle(stage):
    """The open hand is where the approach begins."""
    handle, plan = planned(stage)
    stage.fake.motion.be_at(plan.approach.trajectory.q[0])
    stage.fake.step()
    return {"handle": handle, "grasp": plan.grasp}


def cup_in_hand(stage):
    """A cup in the one hand, the other one free."""
    red = cup()
    return {
        "task": PutInTask("put it into the bowl", ObjectDescription("cup", "red"), ObjectDescription("bowl")),
        "held": HeldObject(red.name, "right", red.shape, np.eye(4)),
    }


def somebody_who_walks(stage):
    """Ana, who was somewhere else a moment ago."""
    clear(stage)
    ana = person()
    before = poses.translation(-0.3, 0.0, 0.0) @ ana.world_T_object
    return {"place": Place("Ana", "person", ana.shape, before, 0.9), "task": FollowTask("follow Ana", "Ana")}


def somebody_to_lead(stage):
    """Ana, who sees where the robot is going."""
    clear(stage)
    ana = person()
    return {
        "task": GuideTask("guide Ana to the hall", "Ana", to="hall"),
        "place": Place("Ana", "person", ana.shape, ana.world_T_object, 0.9),
        "destination": place_of_region("hall", Region("hall", (-0.5, 0.5), (0.3, 0.3))),
    }


def somebody_in_view(stage):
    ana = person()
    return {"known": Place("Ana", "person", ana.shape, ana.world_T_object, 0.9)}


def somebody_who_took_it(stage):
    """Ana has come for the cup, and stands aside."""
    ana, red = person("Ana", (1.0, -0.5)), cup()
    believe(stage, [ana])
    let_go = poses.translation(0.55, -0.2, 0.25)
    return {
        "place": Place("Ana", "person", ana.shape, ana.world_T_object, 0.9),
        "held": HeldObject(red.name, "right", red.shape, np.eye(4)),
        "placement": Placement("right", let_go, (), (0.55, -0.2)),
    }


def control_of(stage, kind, turned_rad=0.0):
    """A knob or button before the robot, as it was seen."""
    clear(stage)
    size = (0.045, 0.052, 0.024) if kind == "knob" else (0.015, 0.04, 0.04)
    turn = poses.transform(poses.rotation_x(turned_rad), (0.0, 0.0, 0.0))
    pose = poses.translation(0.42, 0.25, 0.05) @ turn
    one = TrueObject(kind, "furniture", kind, None, Box(size), pose, names=(f"stove {kind}",))
    stage.fake.world.put(one)
    believe(stage, [one])
    return ControlTarget(kind, kind, f"stove {kind}", pose)


def knob(stage):
    return {"task": TURN, "control": control_of(stage, "knob")}


def knob_that_is_on(stage):
    return {"task": TURN, "control": control_of(stage, "knob", 1.1)}


def button(stage):
    return {"task": PRESS, "control": control_of(stage, "button")}


def way_to_control(stage, given):
    """With a plan to come to it, at the end of which the hand is."""
    request = ControlRequest(
        stage.fake.motion.reference(), stage.fake.motion.stance(), stage.told.scene, given["control"].name
    )
    plan = stage.fake.planning.answer(request)
    stage.fake.motion.be_at(plan.approach.trajectory.q[-1])
    stage.fake.step()
    return {**given, "grasp": plan.grasp, "short_m": plan.short_m}


def hand_at_knob(stage):
    return way_to_control(stage, knob(stage))


def hand_at_button(stage):
    return way_to_control(stage, button(stage))


GIVEN = {
    CloseOnKnob: hand_at_knob,
    DetectControl: knob,
    DrawBackFrom: hand_at_button,
    MakeFist: button,
    PlanControl: knob,
    PlanTurn: hand_at_knob,
    PressIn: hand_at_button,
    VerifyKnob: knob_that_is_on,
    ApproachHandle: hand_before_handle,
    AskForSwap: cup_in_hand,
    ChooseHandle: open_fridge,
    ChooseStand: cup_to_stand_for,
    ChooseStandAtHandle: handle_of_cabinet,
    AskForWalkThere: cup_to_put_elsewhere,
    ChooseStandToPlace: cup_to_put_elsewhere,
    ChooseStandToPut: to_put_inside,
    FindBoardRoom: to_put_inside,
    GraspHandle: hand_at_handle,
    IsItSo: open_fridge,
    Lead: somebody_to_lead,
    IsNear: somebody_near,
    LeadHandle: handle_in_hand,
    PlanHandle: near_handle,
    ReachWatching: reaching,
    SeeAgain: somebody_in_view,
    LookAtTaker: somebody_who_took_it,
    SeeFront: front_seen,
    SpeakToGuest: somebody_to_lead,
    SquaredUp: where_it_stands,
    StandsAtHandle: near_handle,
    StandsThereAlready: near_handle,
    TellAbout: something_to_tell,
    TellFound: cup_to_stand_for,
    TouchFront: hand_at_handle,
    TurnTo: cup_behind,
    VerifyOpening: open_fridge,
    WalkBehind: somebody_who_walks,
    WalkTo: far_table,
    WalkToHandle: far_handle,
    WalkToStandAtHandle: stand_at_cabinet,
}
