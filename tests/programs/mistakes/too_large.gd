VAR n = 10
WHILE n > 0 DO
  n = n * n
END WHILE
