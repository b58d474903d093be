"""Mistakes as data: a kind, a place and parameters. The sentences are made in i18n.

Diagnostic                what was found, where, what was expected, what was probably meant
LanguageError             the family
+-- ProgramError          a mistake of meaning, raised when its line is reached
+-- Refused               raised by an action; the runtime adds the place and makes it a ProgramError
+-- Stopped               the user stopped the program
+-- QuitRequested         QUIT was reached in the terminal
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum

from devices.ports.values import Frozen, field
from language.syntax import Span

MOST_MISTAKES = 100
"""Mistakes of form that are told of one text; nobody listens to more."""


class Kind(Enum):
    """The stable kinds. Scripts rely on the values."""

    SYNTAX = "syntax"
    UNKNOWN_COMMAND = "unknown-command"
    UNKNOWN_CHARACTER = "unknown-character"
    UNTERMINATED_STRING = "unterminated-string"
    INVALID_NAME = "invalid-name"
    RESERVED_WORD = "reserved-word"
    BAD_ARGUMENT = "bad-argument"
    MISSING_END = "missing-end"
    WRONG_END = "wrong-end"
    TOO_DEEP = "too-deep"
    """Blocks or parentheses nested beyond the stated limit: a mistake of form."""
    NUMBER_TOO_LARGE = "number-too-large"
    UNDECLARED_VARIABLE = "undeclared-variable"
    UNDECLARED_PROCEDURE = "undeclared-procedure"
    ALREADY_DECLARED = "already-declared"
    WRONG_ARGUMENT_COUNT = "wrong-argument-count"
    DIVISION_BY_ZERO = "division-by-zero"
    RECURSION_LIMIT = "recursion-limit"
    TERMINAL_ONLY = "terminal-only"
    BELT_OFF = "belt-off"
    ROBOT = "robot"
    """The robot can't do what it was asked, or was lost."""
    UNUSED_VALUE = "unused-value"
    """What does nothing: a sensor on a line of its own, a step below 0; only ever a hint."""


class Severity(Enum):
    ERROR = "error"
    HINT = "hint"


class Diagnostic(Frozen):
    """One mistake, or one hint."""

    kind: Kind
    span: Span
    code: str = ""
    """Which sentence tells it, where a kind has several, such as ``text-plus``; empty: the kind's own."""
    found: str = ""
    """What stands there, as typed; empty at the end of the text."""
    expected: tuple[str, ...] = ()
    """Canonical command words (``TIMES``, ``END REPEAT``) or lower-case classes (``number``, ``name``,
    ``expression``, ``command``, ``comparison``, ``direction``, ``axis``, ``colour``, ``on-or-off``,
    ``end of text``)."""
    meant: str = ""
    """The word that was probably meant, in the language of the program, or empty."""
    details: Mapping[str, str | int] = field(default_factory=dict)
    """What else the sentence needs: ``name``, ``opener``, ``opener_line``, ``wanted``, ``limit`` ..."""
    severity: Severity = Severity.ERROR
    meant_end: int | None = None
    """The offset behind all of what ``meant`` is to replace, where that is more than the span."""
    meant_at: int | None = None
    """The offset at which ``meant`` is to be put in and replaces nothing; it is missing there."""


class CallSite(Frozen):
    """One level of the call stack of a mistake: the procedure's name as declared, and where it was called."""

    procedure: str
    line: int


class LanguageError(Exception):
    """Everything that ends a program before its end."""


class ProgramError(LanguageError):
    """A mistake of meaning, with its place and the calls that led there, innermost first."""

    def __init__(self, diagnostic: Diagnostic, calls: tuple[CallSite, ...] = ()) -> None:
        super().__init__(diagnostic.kind.value)
        self.diagnostic = diagnostic
        self.calls = calls


class Refused(LanguageError):
    """An action that can't be done now, such as VIBRATE while the belt is off."""

    def __init__(self, kind: Kind, **details: str | int) -> None:
        super().__init__(kind.value)
        self.kind = kind
        self.details = details


class Stopped(LanguageError):
    """The user stopped the program."""


class QuitRequested(LanguageError):
    """QUIT was reached where it is allowed."""
