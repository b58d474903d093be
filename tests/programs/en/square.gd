-- walks a square and is back where it began
REPEAT 4 TIMES
  FW 5
  TR 90
END REPEAT
STATE
SPEAK POS x
SPEAK POS y
SPEAK POS a
