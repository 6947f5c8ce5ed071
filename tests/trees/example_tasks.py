"""One task for every skill."""

import numpy as np

from kinematics.formats.joint_motion import JointMotion
from trees.given_motion import FollowTrajectoryTask
from trees.registry import skills
from trees.skills.about_people import TellTask
from trees.skills.answer import AnswerTask
from trees.skills.follow import FollowTask
from trees.skills.guide import GuideTask
from trees.tasks import (
    CloseTask,
    CountTask,
    DescribeTask,
    FindTask,
    GoHomeTask,
    HandOverTask,
    LookAtTask,
    MoveTask,
    ObjectDescription,
    OpenTask,
    PickTask,
    PlaceTask,
    PointAtTask,
    PressTask,
    PutInTask,
    SayTask,
    TurnKnobTask,
    WaitTask,
    WalkToTask,
    WaveTask,
)

RED_CUP = ObjectDescription("cup", "red")

# A skill of which a sentence alone makes a task needs no row here.
TASKS = {
    PickTask: PickTask("pick up the red cup", ObjectDescription("cup", "red")),
    GoHomeTask: GoHomeTask("go home"),
    PlaceTask: PlaceTask("put the red cup on the table", RED_CUP, on="table"),
    PutInTask: PutInTask("put the red cup into the bowl", RED_CUP, ObjectDescription("bowl")),
    HandOverTask: HandOverTask("give the red cup to Ana", RED_CUP, "Ana"),
    FindTask: FindTask("find the red cup", RED_CUP),
    CountTask: CountTask("how many cups are there", ObjectDescription("cup")),
    DescribeTask: DescribeTask("what is on the table", source="table"),
    WaveTask: WaveTask("wave at Ana", "Ana"),
    PointAtTask: PointAtTask("point at the red cup", RED_CUP),
    LookAtTask: LookAtTask("look at the red cup", RED_CUP),
    SayTask: SayTask("say hello", "hello"),
    WaitTask: WaitTask("wait a moment", 0.1),
    OpenTask: OpenTask("open the fridge", ObjectDescription("fridge")),
    CloseTask: CloseTask("close the fridge", ObjectDescription("fridge")),
    MoveTask: MoveTask("go forward", 0.3, 0.0, 0.5),
    WalkToTask: WalkToTask("walk to the table", ObjectDescription("table")),
    FollowTask: FollowTask("follow Ana", "Ana"),
    GuideTask: GuideTask("guide Ana to the table", "Ana", to="table"),
    AnswerTask: AnswerTask("tell me the time", "time"),
    TurnKnobTask: TurnKnobTask("turn on the stove", ObjectDescription("stove")),
    PressTask: PressTask("press the button", ObjectDescription("button")),
    TellTask: TellTask("tell me the name of the person", "name", ObjectDescription("person")),
}
TASKS |= {skill.task: skill.task_of(skill.example) for skill in skills().values() if skill.task not in TASKS}

ELBOW = JointMotion(("arm_left_4_joint",), np.array([1.0]), np.array([[-1.2]]), np.zeros((1, 1)))

# Where another tree does it when another thing, or several, are named, a task that names them.
FURTHER = {
    PutInTask: (PutInTask("put the red cup into the fridge", RED_CUP, "fridge"),),
    FindTask: (FindTask("find all cups", ObjectDescription("cup"), count="all"),),
    AnswerTask: (AnswerTask("tell Ana the time", "time", "Ana"),),
    MoveTask: (MoveTask("follow the velocities", is_fed=True),),
    WaitTask: (FollowTrajectoryTask("follow a trajectory", ELBOW),),  # it is no skill
}


def root_of(task, toolbox):
    """The root of a task's tree, without what clears the hands."""
    return skills()[task.action].tree(task, toolbox)
