"""Which world a session is in: chosen by name or file, taken into a recording and out of one again."""
