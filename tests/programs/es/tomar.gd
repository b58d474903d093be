-- world: gripper.world
TOMAR
AV 1
TOMAR
RE 5
SOLTAR
