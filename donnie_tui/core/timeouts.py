"""Timeouts in seconds: for reports about slow tasks, and for programs that must end."""

SLOW, SLOW_AGAIN = 1.0, 10.0
"""The time until a slow task is reported, and between further reports."""

LAST_WORDS = 1.0
"""The time for a run to end after a stop or its last event. Milliseconds, unless its output is stuck."""
