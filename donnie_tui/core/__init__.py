"""What Donnie does, without a screen and without hardware: programs run, and everything is an event."""

PAINTED = {
    **{"red": "#ff9e94", "green": "#7ee787", "blue": "#9cc4ff", "yellow": "#ffe066", "orange": "#ffb366"},
    **{"pink": "#ffb3e0", "gray": "#c8c8c8"},
}
"""The colour words of the language as things are painted: bright enough on black, and under black letters."""
