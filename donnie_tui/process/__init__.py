"""What happens to the process itself: signals, rest, a lost line, garbage.

Rule: nothing here knows of robots or programs.
"""
