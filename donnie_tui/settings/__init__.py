"""The settings, and the files and folders that keep them from one start to the next."""

ON = ("on", "yes", "true", "1")
OFF = ("off", "no", "false", "0")
"""The spellings of a switch in variables and the file."""

PROFILES = ("auto", "2016", "2018")
"""The firmware of a real robot; ``auto`` assumes that of 2016 until the wheels count backwards."""
SPEECH = ("auto", "off", "text", "ssip", "tts", "robot")
"""What says the sentences: a setting, explained in docs/speech-and-sound.md."""
