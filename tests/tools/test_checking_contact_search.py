"""The referee leaves out nothing that looking at every instant would find."""

import dataclasses

import numpy as np
import pinocchio as pin
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.models.description import load_description
from tools.checking.contact_search import STEP_M, STEP_S, ContactSearch
from tools.checking.farthest import Farthest
from tools.checking.generator import Generator
from tools.checking.referee import Definition, Referee
from tools.checking.solid_world import SolidWorld


@pytest.fixture(scope="module")
def talos():
    return RobotModel(load_description("talos"))


@pytest.fixture(scope="module")
def generator(talos):
    return Generator(talos, longest_s=3.0)


@pytest.mark.parametrize("kind", ["scene", "thin", "brief", "sound"])
@pytest.mark.parametrize("number", range(2))
def test_a_search_finds_what_looking_at_every_instant_finds(talos, generator, kind, number):
    case = generator.case(kind, np.random.default_rng([3, number, len(kind)]))
    trajectory = case.trajectory
    world = SolidWorld(talos, case.scene, only=frozenset(case.scene.objects))
    times = np.linspace(0.0, trajectory.duration_s, int(np.ceil(trajectory.duration_s / STEP_S)) + 1)
    gaps = np.array([world.gaps(q) for q in Definition(trajectory)(times)]).reshape(len(times), -1)

    search = ContactSearch(talos, world, Definition(trajectory), trajectory.duration_s)

    for pair in np.flatnonzero((gaps < 0.0).any(axis=0)):
        touching = times[gaps[:, pair] < 0.0]
        found = search.contacts[int(pair)]
        assert found.first_s <= touching[0]
        assert found.last_s >= touching[-1]
        assert found.depth_m >= -gaps[:, pair].min() - STEP_M
    moving = np.ptp(gaps, axis=0) > 1e-6
    if moving.any():
        assert search.least_m <= gaps[:, moving].min() + STEP_M


@pytest.mark.parametrize("seed", range(2))
def test_no_gap_changes_by_more_than_the_bound(talos, seed):
    rng = np.random.default_rng(seed)
    balls = [
        SceneObject(f"ball {k}", Ball(0.02), poses.translation(*rng.uniform(-1.5, 1.5, 3))) for k in range(4)
    ]
    world = SolidWorld(talos, PlanningScene().with_objects(balls))
    farthest, pairs = Farthest(talos, world), np.arange(len(world.names))
    shares = []
    for velocity in [*0.1 * np.eye(talos.nv), *0.1 * rng.normal(size=(5, talos.nv))]:
        rows = [random_posture(talos, rng)]
        for _ in range(3):
            rows.append(pin.integrate(talos.pin, rows[-1], velocity))

        most = farthest.apart_m(farthest.travelled(np.array(rows))[-1], pairs)

        changed = np.abs(world.gaps(rows[-1]) - world.gaps(rows[0]))
        assert (changed <= most + 1e-5).all()
        shares.append(np.max(changed[most > 0.0] / most[most > 0.0], initial=0.0))
    assert max(shares) > 0.5


def test_what_touches_a_link_that_stays_touches_it_all_the_time(talos, generator):
    case = generator.case("sound", np.random.default_rng(1))
    still = dataclasses.replace(
        case.trajectory, q=np.tile(talos.q_home, (len(case.trajectory.t_s), 1)), v=0.0 * case.trajectory.v
    )
    chest = SceneObject("ball", Ball(0.1), talos.frame_pose(talos.q_home, "torso_2_link"))

    verdict = Referee(talos).judge(still, PlanningScene().with_object(chest))

    assert verdict.duration_s["scene"] == pytest.approx(still.duration_s)


def random_posture(talos, rng):
    joints = rng.uniform(talos.lower_rad, talos.upper_rad)
    turn = rng.normal(size=4)
    return np.concatenate([0.3 * rng.normal(size=3), turn / np.linalg.norm(turn), joints])
