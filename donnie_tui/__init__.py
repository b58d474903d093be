"""Donnie: learners program a robot in the terminal, by ear, by touch and by eye."""

__version__ = "0.1.0"

LANGUAGES = ("en", "pt", "es")
"""Which it speaks. Whatever has a text for each has them in this order."""

DETAILS = ("brief", "normal", "full")
"""How much it tells."""
