"""What the tests of household skills share: things, and what a stage was asked and told."""

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from robots.fake.fake_world import person
from robots.perception.truth_view import TrueObject
from trees.build import build_tree
from trees.events import Said
from trees.tasks import ObjectDescription

RED_CUP = ObjectDescription("cup", "red")
BLUE_CUP = ObjectDescription("cup", "blue")
ANA = person()
BOX_BEFORE_IT = TrueObject(
    "brown box",
    "object",
    "box",
    "brown",
    Box((0.06, 0.24, 0.30)),
    poses.translation(0.42, -0.2, 1.05),
)


def run(stage, task):
    return stage.play(build_tree(task, stage.toolbox))


def long_enough_to_feel_on_the_way(stage):
    """Make motions so long that a touch is felt twice before the end."""
    stage.fake.planning.motion_s = 0.08


def said(stage):
    return [event.text for event in stage.events if isinstance(event, Said)]


def asked(stage, kind):
    return [request for request in stage.fake.planning.requests if isinstance(request, kind)]
