"""Masses whose inertia is none."""

import xml.etree.ElementTree as ElementTree

import pytest

from robots.models.description import load_description
from robots.simulated.body.mended_masses import mend_masses

ROBOT = """
<robot name="odd">
  <link name="base"><inertial><mass value="0"/>
    <inertia ixx="1e-9" ixy="0" ixz="0" iyy="-1e-9" iyz="0" izz="0"/>
  </inertial></link>
  <link name="between"/>
  <link name="arm"><inertial><mass value="2"/><inertia ixx="1e-20" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/>
  </inertial></link>
  <joint name="one" type="revolute"><parent link="base"/><child link="between"/></joint>
  <joint name="two" type="revolute"><parent link="between"/><child link="arm"/></joint>
</robot>"""


def test_a_mass_without_inertia_is_a_small_ball_and_a_moved_link_weighs_a_gram():
    urdf = ElementTree.fromstring(ROBOT)

    mend_masses(urdf)

    base, between, arm = urdf.findall("link")
    assert base.find("inertial") is None
    assert float(between.find("inertial/mass").get("value")) == 0.001
    assert float(arm.find("inertial/inertia").get("iyy")) == pytest.approx(0.4 * 2.0 * 0.01**2)


@pytest.mark.parametrize("name", ["talos", "panda", "g1"])
def test_a_robot_whose_masses_are_well_stays_to_the_letter(name):
    urdf = ElementTree.fromstring(load_description(name).urdf)
    before = ElementTree.tostring(urdf)

    mend_masses(urdf)

    assert ElementTree.tostring(urdf) == before
