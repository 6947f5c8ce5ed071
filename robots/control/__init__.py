"""The control loop and what runs inside of it: motions, balance, health, stops, the one gate."""
