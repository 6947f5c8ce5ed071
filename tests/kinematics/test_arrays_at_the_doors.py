"""Whatever form numbers come in, every door answers as it answers the same numbers in float64."""

import functools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.compiled import readiness
from kinematics.errors import InvalidArrayError, InvalidMotionError
from kinematics.formats.trajectory_document import StoredTrajectory, read_trajectory, write_trajectory
from kinematics.geometry.poses import translation
from kinematics.ik.placo_ik import PlacoIk
from kinematics.ik.reach_ik import ReachIk
from kinematics.kernel.collision_kernel import CollisionKernel
from kinematics.kernel.robot_arrays import humanoid_arrays
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance, stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import BlendedPolyline
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import free_coordinates
from kinematics.timing.curve_timing import JointLimits, time_coordinates
from robots.models.description import load_description

TYPES = ("f8", ">f8", "f4", ">f4", "f2", "g", "i8", "i4", "u1", "?")
LAYOUTS = ("C", "Fortran", "gaps", "backwards", "unaligned", "read-only", "list")


def laid_out(values, dtype, layout):
    """Numbers in another type and layout."""
    found = np.asarray(values).astype(dtype)
    match layout:
        case "Fortran":
            return np.asfortranarray(found)
        case "gaps":
            wide = np.zeros((*found.shape[:-1], 2 * found.shape[-1]), found.dtype)
            wide[..., ::2] = found
            return wide[..., ::2]
        case "backwards":
            return found[..., ::-1].copy()[..., ::-1]
        case "unaligned":
            room = np.zeros(found.nbytes + 1, np.uint8)
            odd = room[1:].view(found.dtype).reshape(found.shape)
            odd[...] = found
            return odd
        case "read-only":
            found.setflags(write=False)
            return found
        case "list":
            return found.tolist()
    return found


forms = st.tuples(st.sampled_from(TYPES), st.sampled_from(LAYOUTS)).map(
    lambda form: functools.partial(laid_out, dtype=form[0], layout=form[1])
)


def plain(values):
    """The same numbers as everybody has them."""
    return np.array(values, np.float64, order="C")


@functools.cache
def robot():
    return RobotModel(load_description("talos"))


@functools.cache
def feet():
    return stance_at(robot(), robot().q_home)


@functools.cache
def checker():
    return TrajectoryChecker(robot())


@functools.cache
def kernel():
    return CollisionKernel.standing(humanoid_arrays(robot()), StandingRobot(robot(), feet()), PlanningScene())


@functools.cache
def solver(kind):
    return kind(StandingRobot(robot(), feet()), "right")


def told(answer):
    """What a checker says, to be compared."""
    if isinstance(answer, CheckedTrajectory):
        return answer.min_distance_m, answer.min_com_margin_m
    return answer.findings


def compiled_so_far():
    """How many types of arguments code has been compiled for, by function."""
    import gc

    from numba.core.dispatcher import Dispatcher

    # by its type: a proxy of something that is gone cannot be asked for its class
    return {id(item): len(item.overloads) for item in gc.get_objects() if issubclass(type(item), Dispatcher)}


@pytest.mark.requirement("S6")
@settings(max_examples=60, deadline=None)
@given(of_t=forms, of_q=forms, of_v=forms)
def test_the_checker_judges_numbers_of_every_form_alike(of_t, of_q, of_v):
    n = 5
    q, v = np.tile(robot().q_home, (n, 1)), np.zeros((n, robot().nv))
    t_s, q, v = of_t(np.arange(n)), of_q(q), of_v(v)
    if not (np.diff(plain(t_s)) > 0.0).all():  # truth values do not rise
        t_s = np.arange(n)

    answer = checker().check(Trajectory(robot().joints, feet(), t_s, q, v), PlanningScene())

    same = Trajectory(robot().joints, feet(), plain(t_s), plain(q), plain(v))
    assert told(answer) == told(checker().check(same, PlanningScene()))


@pytest.mark.requirement("S6")
def test_a_policys_float32_is_judged_by_distances_that_were_measured():
    q = np.tile(robot().q_home, (101, 1)).astype(np.float32)
    v = np.zeros((101, robot().nv), np.float32)
    motion = Trajectory(robot().joints, feet(), np.linspace(0.0, 1.0, 101, dtype=np.float32), q, v)

    answer = checker().check(motion, PlanningScene())

    assert isinstance(answer, CheckedTrajectory), answer
    assert 0.0 < answer.min_distance_m < 1.0


@settings(max_examples=60, deadline=None)
@given(form=forms, rows=st.integers(0, 4))
def test_the_kernel_judges_numbers_of_every_form_alike(form, rows):
    rng = np.random.default_rng(rows)
    x = form(
        free_coordinates(StandingRobot(robot(), feet())).home
        + rng.normal(size=(rows, kernel().size), scale=0.2)
    )
    q = form(robot().q_home + rng.normal(size=(rows, robot().nq), scale=0.2))
    if rows == 0:
        x, q = np.reshape(x, (0, kernel().size)), np.reshape(q, (0, robot().nq))

    answers = [kernel().points_are_free(x), kernel().polyline_is_free(x), kernel().contacts(q).tolist()]
    answers += [kernel().is_free(row) for row in x] + [kernel().collides(row) for row in q]
    answers += [kernel().why_not(row) for row in x]

    a, b = plain(x), plain(q)
    same = [kernel().points_are_free(a), kernel().polyline_is_free(a), kernel().contacts(b).tolist()]
    same += [kernel().is_free(row) for row in a] + [kernel().collides(row) for row in b]
    assert answers == same + [kernel().why_not(row) for row in a]


@settings(max_examples=40, deadline=None)
@given(form=forms, of_target=forms)
@pytest.mark.parametrize("kind", [ReachIk, PlacoIk])
def test_inverse_kinematics_takes_numbers_of_every_form_alike(kind, form, of_target):
    ik = solver(kind)
    target, seed = of_target(translation(0.5, -0.25, 1.0)), form(robot().q_home)
    if not np.linalg.norm(plain(seed)[3:7]) > 0.5 or not np.isfinite(plain(seed)).all():
        seed = robot().q_home

    answer = ik.solve(target, seed, iterations=5)

    assert np.array_equal(answer.q, ik.solve(plain(target), plain(seed), iterations=5).q, equal_nan=True)


@settings(max_examples=40, deadline=None)
@given(form=forms, of_limits=forms)
def test_timing_takes_numbers_of_every_form_alike(form, of_limits):
    points = form([[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 0.0]])
    limits = [of_limits(np.full(3, most)) for most in (1.0, 4.0, 60.0)]

    def timed(corners, *most):
        weights = form(np.ones(3))
        curve = BlendedPolyline(plain(corners), plain(weights), 0.003)
        answers = form if form.keywords["dtype"] == "f8" else plain  # a coarse type would be another motion
        return time_coordinates(curve, answers, JointLimits(*most), weights)

    answer, same = timed(points, *limits), timed(plain(points), *map(plain, limits))

    for name in ("t_s", "q", "rate"):
        assert np.array_equal(getattr(answer, name), getattr(same, name))


@settings(max_examples=60, deadline=None)
@given(form=forms)
def test_documents_hold_numbers_of_every_form_alike(form):
    q, v = form(np.tile([0, 0, 1, 0, 0, 0, 1, 1], (2, 1))), form(np.zeros((2, 7)))
    soles = ((("sole"), form(translation(0.0, 1.0, 0.0))),)
    motion = Trajectory(("joint",), Stance(soles), form([0, 1]), q, v)

    back = read_trajectory(write_trajectory(StoredTrajectory("robot", motion))).trajectory

    assert np.array_equal(back.q, plain(q))
    assert np.array_equal(back.v, plain(v))
    assert np.array_equal(back.stance.soles[0][1], translation(0.0, 1.0, 0.0))


@settings(max_examples=40, deadline=None)
@given(form=forms)
def test_free_coordinates_take_numbers_of_every_form_alike(form):
    space = free_coordinates(StandingRobot(robot(), feet()))
    q = form(robot().q_home)

    x = space.from_q(q)

    assert x.dtype == np.float64
    assert np.array_equal(x, space.from_q(plain(q)))
    assert np.array_equal(space.to_q(form(x[None]))[0], space.to_q(plain(form(x[None])))[0], equal_nan=True)


@pytest.mark.parametrize("dtype", ["c16", "U8", "O", "M8[s]"])
def test_what_is_no_real_number_is_refused_by_name(dtype):
    q = np.zeros((2, robot().nq)).astype("i8").astype(dtype)

    with pytest.raises(InvalidMotionError, match=r"q holds .*, not real numbers"):
        Trajectory(robot().joints, feet(), np.arange(2.0), q, np.zeros((2, robot().nv)))


@pytest.mark.parametrize("shape", [(), (0,), (38,), (1, 39), (39, 1)])
def test_the_kernel_reads_no_memory_beyond_an_array_of_another_size(shape):
    with pytest.raises(InvalidArrayError, match="q has shape"):
        kernel().collides(np.zeros(shape))
    with pytest.raises(InvalidArrayError, match="x has shape"):
        kernel().is_free(np.zeros(shape)[..., :-1] if shape else np.zeros(shape))
    with pytest.raises(InvalidArrayError, match="x has shape"):
        kernel().polyline_is_free(np.zeros((2, kernel().size + 1)))


@pytest.mark.parametrize("kind", [ReachIk, PlacoIk])
@pytest.mark.parametrize("shape", [(), (0,), (38,), (1, 39)])
def test_inverse_kinematics_refuses_a_seed_of_another_size(kind, shape):
    with pytest.raises(InvalidArrayError, match="q_seed has shape"):
        solver(kind).solve(translation(0.5, -0.25, 1.0), np.zeros(shape))


@pytest.mark.parametrize("t_s", [[], [0.0], 0.0, [[0.0, 1.0]]])
def test_a_trajectory_without_two_samples_is_none(t_s):
    n = np.size(t_s)
    with pytest.raises(InvalidMotionError):
        Trajectory(robot().joints, feet(), t_s, np.zeros((n, robot().nq)), np.zeros((n, robot().nv)))


def test_no_form_of_numbers_compiles_anything_anew():
    assert readiness.ready(), "executive doctor --warm compiles what is tried here"
    x, q = free_coordinates(StandingRobot(robot(), feet())).home[None], robot().q_home
    asked = [
        lambda form: kernel().points_are_free(form(x)),
        lambda form: kernel().contacts(form(q[None])),
        lambda form: kernel().distances_m(form(q)),
        lambda form: solver(ReachIk).solve(form(translation(0.5, -0.25, 1.0)), form(q), iterations=3),
        lambda form: solver(ReachIk).follow([form(translation(0.5, -0.25, 1.0))], form(q)),
        lambda form: free_coordinates(StandingRobot(robot(), feet())).to_q(form(x)),
        lambda form: checker().check(
            Trajectory(robot().joints, feet(), [0, 1], form([q, q]), form(np.zeros((2, robot().nv)))),
            PlanningScene(),
        ),
        lambda form: time_coordinates(
            BlendedPolyline(np.array([[0.0], [1.0]]), np.ones(1), 0.003),
            form,
            JointLimits(form([1.0]), form([4.0]), form([60.0])),
            form([1.0]),
        ),
    ]
    for ask in asked:
        ask(plain)
    before = compiled_so_far()

    for dtype, layout in (("f8", "read-only"), ("f4", "C"), ("f8", "gaps"), (">f8", "Fortran")):
        for ask in asked:
            ask(functools.partial(laid_out, dtype=dtype, layout=layout))

    assert compiled_so_far() == before
