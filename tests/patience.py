"""How long every test waits for what must come: the machine may be slow and busy."""

PATIENCE = 240
"""Seconds after which something that must come will not come any more."""
