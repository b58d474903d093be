"""Donnie: learners program a robot in the terminal, by ear, by touch and by eye."""

__version__ = "0.1.0"

DETAILS = ("brief", "normal", "full")
"""How much Donnie prints."""
