"""What a robot is to everything above it: read a state, command a setpoint."""
