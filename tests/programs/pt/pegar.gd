-- world: gripper.world
PF 1
PEGAR
PT 5
SOLTAR
SOLTAR
