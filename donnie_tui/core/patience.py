"""How long anybody is left without a word, and how long a program may take to be gone. In seconds."""

SLOW, SLOW_AGAIN = 1.0, 10.0
"""After which something that takes long is told, and then each time again."""

LAST_WORDS = 1.0
"""For a run that was stopped or has told its end; it needs a few thousandths unless its output is stuck."""
