"""The settings, and the files and folders that keep them from one start to the next."""

ON = ("on", "yes", "true", "1")
OFF = ("off", "no", "false", "0")
"""The spellings of a switch in variables and the file."""
