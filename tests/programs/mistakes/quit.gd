SPEAK "before"
QUIT
