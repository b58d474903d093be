FW 4
SPEAK "here"
