FOR VAR i = 1; i <= 6; i = i + 1 DO
FW 2 * i
TR 90
END FOR
