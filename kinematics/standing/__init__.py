"""The free coordinates of a robot on fixed soles, the legs that follow them, and the reserves kept."""
