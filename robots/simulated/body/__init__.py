"""The MuJoCo model of robot and scene, and its physics."""
