-- world: gripper.world
GRIP
FW 1
GRIP
GRIP
BW 5
RELEASE
RELEASE
