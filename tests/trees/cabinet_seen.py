"""What looks at the scene "cabinet" show of its fixtures, for tests of beliefs and of leaves."""

from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.perception.object_estimate import ObjectEstimate
from robots.perception.truth_view import TrueObject
from robots.scenes.furniture import floor_pose, solids
from robots.scenes.moving_parts import moving_parts
from robots.scenes.scene_file import load_scene

CABINET, MICROWAVE = load_scene("cabinet").furniture[1:]


def shown(piece, **openings):
    """The solids of a fixture as the truth has them, each part open so far."""
    for solid in solids(piece):
        yield TrueObject(solid.name, "furniture", piece.kind, None, solid.shape, solid.world_T_solid)
    for part in moving_parts(piece):
        moved = part.opened(openings.get(part.name.rpartition("/")[2].replace(" ", "_"), 0.0))
        for solid in part.solids:
            if solid.kind:
                pose = floor_pose(piece) @ part.furniture_T_part @ moved @ solid.part_T_solid
                told = part.known_part(floor_pose(piece), solid, piece.name)
                yield TrueObject(solid.name, "furniture", solid.kind, None, solid.shape, pose, moves=told)


def estimate(one):
    """A perfect look at a solid."""
    pose = one.world_T_object
    return ObjectEstimate(
        "furniture", one.kind, None, pose, one.shape, 0.9, 8, 0.0, name=one.told_name, moves=one.moves
    )


def seen(piece, **openings):
    """A perfect look at what moves of a fixture, by names as scenes give them."""
    found = {}
    for one in shown(piece, **openings):
        if one.moves is not None:
            number = sum(name.rstrip(" 0123456789") == one.kind for name in found) + 1
            found[one.kind if number == 1 else f"{one.kind} {number}"] = estimate(one)
    return found


def believed(look):
    """A scene that has what a look shows."""
    return PlanningScene().with_objects(
        SceneObject(name, one.shape, one.odom_T_object, 0.01, movable=False, moves=one.moves)
        for name, one in look.items()
    )
