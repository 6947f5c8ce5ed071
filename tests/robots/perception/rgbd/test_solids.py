import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from robots.perception.rgbd.solids import ball_distance, box_distance, cylinder_distance

lengths = st.floats(0.02, 0.15)
places = st.floats(-0.1, 0.1)
SOLIDS = [
    (cylinder_distance, st.tuples(places, places, lengths, lengths)),
    (box_distance, st.tuples(places, places, st.floats(-1.5, 1.5), lengths, lengths, lengths)),
    (ball_distance, st.tuples(places, places, lengths)),
]


@pytest.mark.parametrize(("distance", "parameters"), SOLIDS)
@given(data=st.data())
@settings(max_examples=40, deadline=None)
def test_derivatives_are_those_of_the_distance(distance, parameters, data):
    p = np.array([data.draw(parameters)])
    point = np.array([[[data.draw(places), data.draw(places), data.draw(st.floats(0.0, 0.2))]]])
    value, gradient = distance(point, p)
    step = 1e-6
    numeric = []
    for i in range(p.shape[1]):
        more, less = p.copy(), p.copy()
        more[0, i] += step
        less[0, i] -= step
        ahead, behind = distance(point, more)[0][0, 0], distance(point, less)[0][0, 0]
        one_sided = (ahead - value[0, 0]) / step, (value[0, 0] - behind) / step
        if abs(one_sided[0] - one_sided[1]) > 1e-3:  # an edge between two faces: both are right
            return
        numeric.append(0.5 * sum(one_sided))

    assert gradient[0, 0] == pytest.approx(numeric, abs=2e-3)


def test_distances_of_a_cylinder():
    points = np.array([[[0.05, 0.0, 0.05], [0.0, 0.0, 0.12], [0.0, 0.0, 0.05], [0.06, 0.0, 0.14]]])

    distance, _ = cylinder_distance(points, np.array([[0.0, 0.0, 0.03, 0.10]]))

    assert distance[0] == pytest.approx([0.02, 0.02, -0.03, 0.05])
