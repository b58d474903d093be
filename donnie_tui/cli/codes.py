"""The exit codes of every command."""

DONE = 0
FAILED = 1
"""The program had a mistake."""
UNUSABLE = 2
"""Wrong usage, or a world, file or device that can't be used."""
STOPPED = 130
"""By the user."""
