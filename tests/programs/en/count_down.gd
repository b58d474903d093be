VAR n = 3
WHILE n > 0 DO
  SPEAK n
  n = n - 1
END WHILE
SPEAK "go"
FOR VAR i = 0; i < 3; i = i + 1 DO
  FW i
END FOR
HISTORY
