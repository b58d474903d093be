FOR VAR n = 5; n > 0; n = n - 1 DO
  SPEAK n
  FW 1
END FOR
