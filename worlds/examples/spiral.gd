VAR way = 1
REPEAT 6 TIMES
  FW way
  TR 90
  way = way + 1
END REPEAT
