"""What colour alone has cut apart is put together again; what stands on something wider stays apart."""

from kinematics.geometry.shapes import Box
from robots.perception.rgbd.eyes import Eyes
from tests.robots.perception.rgbd.conftest import traced

RED, BLUE = (200, 20, 20), (20, 40, 200)


def test_a_red_box_on_a_blue_one_of_its_size_is_one_thing():
    picture = traced(
        [(Box((0.06, 0.06, 0.05)), 0.7, 0.0, 0.3, BLUE), (Box((0.06, 0.06, 0.12)), 0.7, 0.0, 0.3, RED)]
    )
    banded = picture.color.copy()
    rows, columns = (picture.color[..., 0] > 150).nonzero()
    low = rows > (rows.min() + rows.max()) // 2
    banded[rows[low], columns[low]] = BLUE
    things = Eyes().look(type(picture)(**{**_fields(picture), "color": banded})).things

    assert len(things) == 1


def test_two_boxes_side_by_side_are_two_things():
    things = (
        Eyes()
        .look(
            traced(
                [
                    (Box((0.06, 0.06, 0.1)), 0.7, 0.05, 0.0, RED),
                    (Box((0.06, 0.06, 0.1)), 0.7, -0.05, 0.0, BLUE),
                ]
            )
        )
        .things
    )

    assert len(things) == 2


def _fields(picture):
    return {name: getattr(picture, name) for name in type(picture).__dataclass_fields__}
