"""The four looks: dark, light, high contrast, and the terminal's own colours.

Rules: every text is at least 7:1 against what it stands on, the dots of the free floor at least 3:1 (a test
measures the painted cells), and no meaning is in a colour alone. A look has one table of roles; style
sheet and widgets have no other colours.
"""

from __future__ import annotations

from functools import cache

from rich.style import Style
from textual.color import Color
from textual.theme import Theme

from donnie_tui.core import PAINTED

DARK, LIGHT, CONTRAST, TERMINAL = "donnie-dark", "donnie-light", "donnie-contrast", "donnie-terminal"

ROLES = ("background", "foreground", "surface", "panel", "muted", "border", "chosen", "on-chosen", "faint")
"""Roles of backgrounds and texts; ``chosen`` is the background of the focused row or title."""

COLOURS = tuple(PAINTED)
"""The paint of each colour word of the language."""

_PALETTES: dict[str, dict[str, str]] = {
    DARK: {
        "background": "#0e1116", "foreground": "#f2f4f8", "surface": "#161b22", "panel": "#232a33",
        "muted": "#c4cbd6", "faint": "#606976", "border": "#9aa7b8",
        "chosen": "#f2f4f8", "on-chosen": "#0e1116",
        "accent": "#7fd4ff", "success": "#7ee787", "warning": "#ffd866", "error": "#ffb0a6",
        **PAINTED,
    },
    LIGHT: {
        "background": "#ffffff", "foreground": "#14171a", "surface": "#f6f6f3", "panel": "#e7e7e2",
        "muted": "#3a3f45", "faint": "#8a8f96", "border": "#5a6068",
        "chosen": "#14171a", "on-chosen": "#ffffff",
        "accent": "#003f75", "success": "#0a4a1c", "warning": "#573a00", "error": "#860c0c",
        "red": "#8f0d0d", "green": "#0a4a1c", "blue": "#0b3a8f", "yellow": "#524300",
        "orange": "#6e3500", "pink": "#7d0f5c", "gray": "#3f3f3f",
    },
    CONTRAST: {
        "background": "#000000", "foreground": "#ffffff", "surface": "#000000", "panel": "#00004d",
        "muted": "#ffffff", "faint": "#808080", "border": "#ffffff",
        "chosen": "#ffff00", "on-chosen": "#000000",
        "accent": "#00ffff", "success": "#66ff66", "warning": "#ffff00", "error": "#ffb3b3",
        "red": "#ffb3b3", "green": "#66ff66", "blue": "#99ccff", "yellow": "#ffff00",
        "orange": "#ffc266", "pink": "#ffb3ff", "gray": "#ffffff",
    },
    TERMINAL: {
        **dict.fromkeys(ROLES, "ansi_default"),
        "border": "ansi_blue", "accent": "ansi_cyan", "success": "ansi_green", "warning": "ansi_yellow",
        "error": "ansi_red", "red": "ansi_red", "green": "ansi_green", "blue": "ansi_blue",
        "yellow": "ansi_yellow", "orange": "ansi_bright_red", "pink": "ansi_magenta", "gray": "ansi_default",
    },
}  # fmt: skip

NAMES = tuple(_PALETTES)

_BRIGHT = {
    "red": "#ff5555", "green": "#55ff55", "blue": "#5555ff", "yellow": "#ffff55", "orange": "#aa5500",
    "pink": "#ff55ff", "gray": "#aaaaaa",
}  # fmt: skip
_OF_SIXTEEN = {
    DARK: _BRIGHT,
    LIGHT: {
        "red": "#aa0000", "green": "#00aa00", "blue": "#0000aa", "yellow": "#aa5500", "orange": "#ff5555",
        "pink": "#aa00aa", "gray": "#555555",
    },
    CONTRAST: _BRIGHT,
    TERMINAL: _PALETTES[TERMINAL],
}  # fmt: skip
"""The paint of things with 16 colours, where the nearest ones of ``COLOURS`` are often equal.

Only the terminal's look has their names: in the others Textual replaces a name by a mixed colour.
"""

_LOOKS: dict[str, tuple[str, str, str]] = {
    "note": ("error", "", "italic"), "selected": ("on-chosen", "chosen", ""),

    "robot": ("accent", "", "bold reverse"), "other": ("warning", "", "bold reverse"),
    "start": ("success", "", "bold"), "goal": ("warning", "", "bold"),
    "trail": ("success", "", ""), "wall": ("foreground", "", ""), "free": ("faint", "", ""),
    "ray": ("warning", "", ""), "name": ("foreground", "", "italic"), "ruler": ("muted", "panel", ""),
    "outside": ("warning", "", "bold"),
    **{f"thing-{colour}": (colour, "", "bold") for colour in COLOURS},

    "kind": ("muted", "", "italic"), "error": ("error", "", "bold"), "warning": ("warning", "", "bold"),
    "heading": ("accent", "", "bold"), "changed": ("warning", "", "bold"), "chart": ("success", "", ""),
    "says": ("accent", "", ""), "typed": ("success", "", "italic"), "row": ("on-chosen", "chosen", ""),
}  # fmt: skip
"""The looks by name that widgets paint row by row: in the editor, on the map, in rows of text. Its role, that
of its background where it has one of its own, and how it is written. As classes of the style sheet each was
worked out for each widget before the first frame, and whenever the focus came or went."""


def name_of(setting: str) -> str:
    """The look of a setting: ``dark``, ``light``, ``contrast`` or ``terminal``."""
    return f"donnie-{setting}"


def theme(name: str) -> Theme:
    """Textual's form of a look."""
    roles = _PALETTES[name]
    own = {role: roles[role] for role in ("muted", "chosen", "on-chosen")}
    return Theme(
        name=name,
        primary=roles["accent"],
        secondary=roles["accent"],
        accent=roles["accent"],
        success=roles["success"],
        warning=roles["warning"],
        error=roles["error"],
        foreground=roles["foreground"],
        background=roles["background"],
        surface=roles["surface"],
        panel=roles["panel"],
        boost=roles["surface"],
        dark=name != LIGHT,
        ansi=name == TERMINAL,
        variables=own | _of_textual(roles, is_ansi=name == TERMINAL),
    )


def _of_textual(roles: dict[str, str], *, is_ansi: bool) -> dict[str, str]:
    """Variables of Textual's own widgets, which would otherwise be mixed colours of lower contrast."""
    chosen = ("ansi_white", "ansi_black") if is_ansi else (roles["chosen"], roles["on-chosen"])
    background, foreground = chosen
    return {
        "ansi-background": "ansi_black",
        "ansi-foreground": "ansi_white",
        "text": roles["foreground"],
        "text-muted": roles["muted"],
        "text-disabled": roles["muted"],
        "border": roles["border"],
        "border-blurred": roles["border"],
        "block-cursor-background": background,
        "block-cursor-foreground": foreground,
        "block-cursor-blurred-background": background,
        "block-cursor-blurred-foreground": foreground,
        "block-hover-background": roles["panel"],
        "input-cursor-background": background,
        "input-cursor-foreground": foreground,
        "input-cursor-text-style": "none",
        "input-selection-background": background,
        "input-selection-foreground": foreground,
        "screen-selection-background": background,
        "screen-selection-foreground": foreground,
    }


@cache
def looks(name: str) -> dict[str, Style]:
    """The styles of the looks in that theme."""
    roles = _PALETTES.get(name, _PALETTES[TERMINAL])

    def painted(role: str, behind: str, how: str) -> Style:
        colour, background = (
            Color.parse(roles[each]).rich_color if each else None for each in (role, behind)
        )
        return Style(color=colour, bgcolor=background) + Style.parse(how)

    found = {look: painted(*of_it) for look, of_it in _LOOKS.items()}
    if roles["chosen"] == roles["background"]:
        found["selected"] += Style(reverse=True)
        found["free"] += Style(dim=True)
    return found


@cache
def block_of_sixteen(name: str, colour: str) -> Style:
    """The style of a thing in the picture with 16 colours; never bold, which is brighter on a console."""
    found = _OF_SIXTEEN.get(name, _OF_SIXTEEN[TERMINAL])[colour]
    return Style(color=Color.parse(found).rich_color, bold=False)


def syntax_styles(name: str) -> dict[str, Style]:
    """The editor's syntax styles; colours repeat what weight and slant say."""
    roles = _PALETTES.get(name, _PALETTES[TERMINAL])

    def painted(role: str, *, bold: bool = False, italic: bool = False) -> Style:
        colour = None if roles[role].startswith("ansi") else roles[role]
        return Style(color=colour, bold=bold or None, italic=italic or None)

    return {
        "command": painted("accent", bold=True),
        "argument": painted("success", bold=True),
        "number": painted("warning"),
        "string": painted("orange", italic=True),
        "comment": painted("muted", italic=True),
        "operator": painted("foreground"),
    }
