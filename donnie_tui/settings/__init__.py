"""What a learner has chosen, what is kept from one start to the next, and where."""

ON = ("on", "yes", "true", "1")
OFF = ("off", "no", "false", "0")
"""How variables and the file write a switch."""
