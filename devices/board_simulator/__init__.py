"""Simulators of the robot's and the belt's board: what the original firmware does on its serial connection.

They ship with Donnie, so a program can be tried without a robot, and the driver's tests use them. Tests
compare them with recordings of the real firmware. ``SimulatedBoard`` knows no port and no clock; ``PtyBoard``
gives it a device path and real time, ``VirtualLink`` connects it with the driver in virtual time.
"""
