"""Speech: what is said next, by which voice, through which channel, in which words.

Everything here but ``renderer`` is pure or silent; ``renderer`` is loaded in the audio worker only.
"""
