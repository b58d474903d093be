HELP FW
HELP procedure
HELP nonsense
