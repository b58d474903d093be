"""Every setting by its name: what it takes, and what reads its text."""

from __future__ import annotations

import os
from collections.abc import Callable

from devices.ports.values import Frozen
from donnie_tui import DETAILS, LANGUAGES
from donnie_tui.settings.devices import (
    BUMPERS_WANTED,
    COLUMNS_WANTED,
    METRES_WANTED,
    RESET_WANTED,
    ROBOT_WANTED,
    SONARS_WANTED,
    STEPS_WANTED,
    read_bumpers,
    read_columns,
    read_metres,
    read_reset_line,
    read_robot,
    read_sonars,
    read_steps,
)
from donnie_tui.settings.readers import (
    FASTEST,
    PERCENTS,
    RATES,
    SLOWEST,
    SPEECH,
    one_of,
    read_cues,
    read_folders,
    read_free,
    read_language,
    read_line,
    read_percent,
    read_progress,
    read_rate,
    read_seed,
    read_sound,
    read_speech,
    read_speed,
    read_switch,
    read_text,
)

SPEAK = ("here", "robot", "both")
PUNCTUATION = ("none", "some", "all")
KEY_ECHO = ("none", "characters", "words")
THEMES = ("dark", "light", "contrast", "terminal")
MOTION = ("full", "reduced")

SOUND_WANTED = "on, off, wav:FILE"
RATE_WANTED, PERCENT_WANTED = (f"{least}-{most}" for least, most in (RATES, PERCENTS))
CUES_WANTED = "NAME 0-100, NAME 0-100"


class Key(Frozen):
    """One setting: its name on the command line, in the file and (with DONNIE_) in the environment."""

    key: str
    name: str
    read: Callable[[str], object]
    """The value of a text. Raises ``ValueError``."""
    wanted: str
    """What it takes, for the error."""
    is_example: bool = False
    """Whether ``wanted`` is one of many that it takes."""

    @property
    def is_choice(self) -> bool:
        """Whether ``wanted`` lists the very words that it takes, of which one is chosen."""
        words = self.wanted.split(", ")
        return len(words) > 1 and not any(each.isupper() or any(map(str.isdigit, each)) for each in words)

    @property
    def variable(self) -> str:
        return f"DONNIE_{self.key.upper()}"


KEYS = (
    Key("world", "world", read_text, "NAME_OR_FILE"),
    Key("worlds", "world_folders", read_folders, f"FOLDER{os.pathsep}FOLDER"),
    Key("robot", "robot", read_robot, ROBOT_WANTED),
    Key("lang", "language", read_language, ", ".join(LANGUAGES)),
    Key("speed", "speed", read_speed, f"{SLOWEST:g}-{FASTEST:g}, max"),
    Key("seed", "seed", read_seed, "0, 1, 2 ..."),
    Key("speech", "speech", read_speech, ", ".join(SPEECH)),
    Key("sound", "sound", read_sound, SOUND_WANTED),
    Key("speak", "speak", one_of(SPEAK), ", ".join(SPEAK)),
    Key("rate", "rate", read_rate, RATE_WANTED),
    Key("pitch", "pitch", read_percent, PERCENT_WANTED),
    Key("volume", "volume", read_percent, PERCENT_WANTED),
    Key("punctuation", "punctuation", one_of(PUNCTUATION), ", ".join(PUNCTUATION)),
    Key("key_echo", "key_echo", one_of(KEY_ECHO), ", ".join(KEY_ECHO)),
    Key("cues", "cues", read_cues, CUES_WANTED),
    Key("wait_for_speech", "wait_for_speech", read_switch, "on, off"),
    Key("verbosity", "verbosity", one_of(DETAILS), ", ".join(DETAILS)),
    Key("events", "events", read_text, "FILE, -"),
    Key("record", "record", read_text, "FILE"),
    Key("belt", "belt", read_text, "PORT"),
    Key("belt_steps", "belt_steps", read_steps, STEPS_WANTED, is_example=True),
    Key("belt_columns", "belt_columns", read_columns, COLUMNS_WANTED, is_example=True),
    Key("wheel_radius", "wheel_radius", read_metres, METRES_WANTED),
    Key("axle_length", "axle_length", read_metres, METRES_WANTED),
    Key("sonars", "sonars", read_sonars, SONARS_WANTED, is_example=True),
    Key("bumpers", "bumpers", read_bumpers, BUMPERS_WANTED, is_example=True),
    Key("reset_line", "reset_line", read_reset_line, RESET_WANTED),
    Key("linear", "linear", read_switch, "on, off"),
    Key("page", "page", one_of(("rest", "ask", "off")), "rest, ask, off"),
    Key("prompt", "prompt", one_of(("short", "none", "word", "answer")), "short, none, word, answer"),
    Key("hold", "hold", one_of(("off", "on")), "off, on"),
    Key("editor", "editor", one_of(("own", "plain")), "own, plain"),
    Key("enter", "enter", one_of(("waits", "runs")), "waits, runs"),
    Key("progress", "progress", read_progress, "0-3600"),
    Key("clock", "clock", one_of(("off", "on")), "off, on"),
    Key("free", "free", read_free, "dot, a-z"),
    Key("tour", "tour", read_switch, "on, off"),
    Key("theme", "theme", one_of(THEMES), ", ".join(THEMES)),
    Key("plain", "plain", read_switch, "on, off"),
    Key("mouse", "mouse", read_switch, "on, off"),
    Key("motion", "motion", one_of(MOTION), ", ".join(MOTION)),
    Key("completion", "completion", read_switch, "on, off"),
    Key("keys", "keys", read_line, "ACTION KEY, ACTION KEY"),
)
BY_KEY = {each.key: each for each in KEYS}
