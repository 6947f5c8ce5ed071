"""What plans and guarded motions keep in reserve, whoever judges them.

Reserves of distance are added to the margins of a scene and kept between the robot's own links.
"""

PLANNING_RESERVE_M = 0.004
"""What picks keep against the checker."""

MOVING_RESERVE_M = 0.003
"""The same for moves, gestures, looks and placing, which begin and end nearer to things."""

LEAST_RESERVE_M = 0.001
"""What is left of it when there is no other way, and between the legs: the checker has the last word."""

COM_RESERVE_M = 0.025
"""Of the CoM's margin: a robot that leans gives way in its soles and ankles by centimetres, and with a
margin of 30 mm on paper it was seen to tip over slowly."""

SEARCH_COM_RESERVE_M = 0.01
"""What a search keeps beyond the CoM's margin at least, so that the checker's view never differs."""

LIMIT_NOISE_RAD = 1e-6
"""What numerical noise may overstep a joint limit by; plans keep to shrunk ones anyway."""

BRAKING_RESERVE_M = 0.004
"""Kept beyond touching by motions that are made as they go: a stop brakes within that, and what comes to rest
in collision is not planned for again."""

HANDED_ON_RESERVE_M = BRAKING_RESERVE_M + LEAST_RESERVE_M
"""Between the robot's own links at the end of a plan that such a motion goes on from: it has its reserve."""

JOGGING_RESERVE_M = 0.002
"""Kept by a person's jogging beyond what the online checker asks for: what is told is a mean, and cuts
corners by less."""
