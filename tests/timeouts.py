"""How long a test waits for an event: the machine may be slow and busy."""

TIMEOUT = 240
"""Seconds after which the test fails."""
