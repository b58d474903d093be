"""Voice and cues: what is spoken and played, through which channel, and the worker process that plays it."""
