FW 2
VAR total = 1
SPEAK totl
FW 9
