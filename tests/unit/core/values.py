"""Values that several tests of the core need."""

from devices.ports.robot import Pose

HERE = Pose(1.0, 2.0, 90.0)
