"""The compiled collision kernel of the planner; see ``collision_kernel`` for what to call.

Nothing here imports numba until a kernel is made: ``readiness.ready()`` tells whether that would
have to compile first.
"""
