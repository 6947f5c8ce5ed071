"""Where a colon within a command says nothing: "navigate to: kitchen"."""

_LINES = """
WALK TO_ALSO APPROACH MOVE TURN WAIT WAVE_TO SKILL_AT LOOK_AT POINT_AT FIND COUNT DESCRIBE OPEN CLOSE
PICK UP FETCH BRING CARRY GIVE PUT PUT_DOWN DOWN PUT_IN MOVE_THING
"""

BEFORE_A_COLON = frozenset(_LINES.split())
"""Word classes behind which a colon is passed over."""
