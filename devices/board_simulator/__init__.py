"""A simulator of the robot's board: what the original firmware does on its serial connection.

It ships with Donnie, so a program can be tried without a robot, and the driver's tests use it. Tests compare
it with recordings of the real firmware. ``SimulatedBoard`` knows no port and no clock; ``VirtualLink``
connects it with the driver in virtual time.
"""
