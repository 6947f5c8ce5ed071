"""What plans keep in reserve against the checker, whoever judges them."""

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
