"""What happens to the process: signals, suspension, lost connections, garbage collection. No robots."""

HIGHEST_STANDARD = 2
"""Input, output and errors are 0, 1 and 2."""
