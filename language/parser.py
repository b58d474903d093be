"""Text to tree, or to all mistakes of form at once.

The tables that lark made (tables.py) read a correct text in one pass. Only after a mistake does the recovery
read the tokens again, to find all mistakes. Colours that the robot can't see are mistakes of form too.
For any text the result is a program or mistakes, in time and memory linear in its length.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Any

from msgspec import Struct

from language.diagnostics import Diagnostic, MistakeKind
from language.keywords import argument
from language.lexer import END as END_WORD
from language.lexer import KIND, TAKE_EXPRESSION, Lexed, Token, lex, span_of
from language.locales import ENGLISH
from language.outline import ENDS, OPENERS
from language.syntax import DeclaredProcedure, Program
from language.tables import ACTIONS, END, GOTOS, RULES, START, TERMINALS
from language.tree_builder import MOST_LEVELS, TooDeep, TreeBuilder

MOST_BLOCKS = 200
"""Blocks in each other. With the limits, recursive functions may walk any tree."""

MOST_PARENTHESES = 200

_LPAR, _RPAR = KIND["LPAR"], KIND["RPAR"]
_AFTER_LAST: Any = (0,)
"""What follows the last token: a kind without a place."""
_SPEAK = KIND["SPEAK"]
"""Fits wherever a statement may begin."""
_CLOSERS = ENDS.keys() | {END_WORD}
_BEGIN_COMMANDS = OPENERS.keys() | {KIND[name] for name in ("VAR", "ASSIGN", *TAKE_EXPRESSION)}

_Reduction = tuple[int, int, Callable[..., Any] | None]
"""A nonterminal, how many parts it replaces, and the method that builds its node."""


class Parsed(Struct, frozen=True):
    """A program, or None and the mistakes."""

    program: Program | None
    diagnostics: tuple[Diagnostic, ...]
    """Mistakes of form in the order of the text; empty if there is a program."""


def parse(
    source: str,
    *,
    first_line: int = 1,
    colours: frozenset[str] | None = None,
    declared: Mapping[str, DeclaredProcedure] | None = None,
    variables: Collection[str] = (),
    learner: str = ENGLISH,
) -> Parsed:
    """Read a program.

    ``first_line`` is the number of its first line. ``colours`` are the colours that the robot can see, as
    English words; another one is a mistake. None allows all. ``declared`` are the procedures of earlier
    batches, by folded name: a mistake about a wrong call of one shows the right call. ``variables`` are the
    folded names of their variables, ``learner`` is the learner's language; both help to guess what was meant.
    """
    lexed = lex(source, first_line)
    mistakes = _unseen_colours(lexed, colours)
    if not mistakes and not lexed.mistakes:
        try:
            body = _tree(lexed)
        except TooDeep as error:
            limit = {"limit": MOST_LEVELS}
            mistakes = (Diagnostic(MistakeKind.TOO_DEEP, error.span, "expression", details=limit),)
        else:
            if body is not None:
                return Parsed(Program(source, body), ())
    from language.recovery import mistakes_in  # only texts with mistakes need it
    from language.recovery.reader import Known

    others = mistakes + _nested_too_deeply(lexed.tokens)
    known = Known(colours, declared or {}, variables, learner)
    return Parsed(None, mistakes_in(lexed, others, known))


def _tree(lexed: Lexed) -> tuple[Any, ...] | None:
    """The statements, or None if there is a mistake. One long loop, because it handles every token.

    Any: reductions make all types of nodes.
    """
    actions, gotos, is_deep = ACTIONS, GOTOS, False
    states = [START]
    parts: list[Any] = []
    state = START
    reduce = _reductions(lexed.source)
    for token in (*lexed.tokens, _AFTER_LAST):
        kind = token[0]
        action = actions[state][kind]
        while action < 0:
            nonterminal, count, build = reduce[action]
            if build is None:
                state = states[-1] = gotos[states[-2]][nonterminal]
                if state == END:
                    return None if is_deep and _nested_too_deeply(lexed.tokens) else tuple(parts[-1])
            elif count == 1:
                parts[-1] = build(parts[-1])
                state = states[-1] = gotos[states[-2]][nonterminal]
            elif count == 2:
                last = parts.pop()
                parts[-1] = build(parts[-1], last)
                del states[-1]
                state = states[-1] = gotos[states[-2]][nonterminal]
            elif count == 0:
                parts.append(build())
                state = gotos[state][nonterminal]
                states.append(state)
            else:
                is_deep = is_deep or len(states) > MOST_BLOCKS  # each level has a state at least
                built = build(*parts[-count:])
                del parts[-count:], states[-count:]
                parts.append(built)
                state = gotos[states[-1]][nonterminal]
                states.append(state)
            action = actions[state][kind]
        if action == 0:
            return None
        states.append(action)
        parts.append(token)
        state = action
    return None


def _reductions(source: str) -> list[_Reduction]:
    builder = TreeBuilder(source)
    return [(rule[0], rule[1], getattr(builder, rule[2]) if rule[2] else None) for rule in RULES]


# --- what may come next -------------------------------------------------------------------------------


def kinds_after(tokens: Sequence[Token]) -> frozenset[int]:
    """The kinds of tokens that may follow these, whatever is wrong in them.

    After a mistake the reading continues at the next token that fits into the innermost block.
    """
    states = [START]
    for token in tokens:
        following = _following(states, token[0])
        if following is None:
            while _following(states, _SPEAK) is None:
                states.pop()
            following = _following(states, token[0])
        states = following or states
    return frozenset(kind for kind in range(1, len(TERMINALS)) if _following(states, kind))


def _following(states: list[int], kind: int) -> list[int] | None:
    """The states after a token of that kind, or None if it doesn't fit."""
    after = list(states)
    while (action := ACTIONS[after[-1]][kind]) < 0:
        nonterminal, count, _, _ = RULES[action]
        del after[len(after) - count :]
        after.append(GOTOS[after[-1]][nonterminal])
    return [*after, action] if action else None


# --- mistakes that the grammar allows -----------------------------------------------------------------


def _unseen_colours(lexed: Lexed, colours: frozenset[str] | None) -> tuple[Diagnostic, ...]:
    """A mistake for each colour outside ``colours``, which are English words; None allows all."""
    if colours is None:
        return ()
    details = {"word": "COLOR", "wanted": ", ".join(sorted(colours))}
    unseen = [
        token
        for token in lexed.colours
        if (found := argument("COLOUR", token[5])) and found.value not in colours
    ]
    return tuple(
        Diagnostic(
            MistakeKind.BAD_ARGUMENT,
            span_of(token),
            code="unseen-colour",
            found=lexed.source[token[1] : token[2]],
            expected=("colour",),
            details=details,
        )
        for token in unseen
    )


def _nested_too_deeply(tokens: list[Token]) -> tuple[Diagnostic, ...]:
    """The first block and the first parenthesis that are too deep."""
    return (
        *_too_deep(tokens, OPENERS, _CLOSERS, (), "blocks", MOST_BLOCKS),
        *_too_deep(tokens, (_LPAR,), (_RPAR,), _BEGIN_COMMANDS, "parentheses", MOST_PARENTHESES),
    )


def _too_deep(
    tokens: list[Token],
    openers: Collection[int],
    closers: Collection[int],
    reset: Collection[int],
    code: str,
    limit: int,
) -> list[Diagnostic]:
    """A mistake at the first opener in more than ``limit`` others. A kind in ``reset`` is in none."""
    depth = 0
    for token in tokens:
        kind = token[0]
        if kind in openers:
            depth += 1
            if depth > limit:
                return [Diagnostic(MistakeKind.TOO_DEEP, span_of(token), code, details={"limit": limit})]
        elif kind in closers:
            depth = max(0, depth - 1)
        elif kind in reset:
            depth = 0
    return []
