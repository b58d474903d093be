-- world: living_room
-- to the north wall, or what stands before it
SPEAK DISTANCE F
WHILE DISTANCE F > 3 DO
  FW 1
END WHILE
FW 10
BW 2
SCAN
SPEAK COLOR blue
