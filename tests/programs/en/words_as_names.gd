-- The words of the gripper name variables and procedures, too.
VAR grip = 2
PROCEDURE RELEASE: pegar DO
  SPEAK pegar
END PROCEDURE
RELEASE [grip + 1]
GRIP
FW grip
