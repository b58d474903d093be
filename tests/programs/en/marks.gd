-- world: marks.world
SCAN
TR 180
SCAN
FW 3
