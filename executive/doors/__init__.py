"""Doors to the world: processes beside a served robot through which others command it; none can reset it."""
