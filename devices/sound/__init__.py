"""Sound: the cues that Donnie makes itself, when they may be heard, and what plays them."""
