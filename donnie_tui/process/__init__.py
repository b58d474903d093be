"""What happens to the process itself: signals, rest, a lost line, garbage.

Rule: nothing here knows of robots or programs.
"""

HIGHEST_STANDARD = 2
"""Input, output and errors are 0, 1 and 2."""
