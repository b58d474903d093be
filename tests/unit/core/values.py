"""Values that several tests of the core use."""

from devices.ports.robot import Pose

HERE = Pose(1.0, 2.0, 90.0)
