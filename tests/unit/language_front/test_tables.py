"""The shipped tables are those that lark makes of the grammar."""

import subprocess
import sys
from typing import get_args

from language import syntax, tables
from language.lexer import NAME
from language.parser import parse
from language.tree_builder import TreeBuilder
from tests.tools import make_tables

FOLDER = make_tables.FOLDER


def test_the_shipped_tables_are_those_of_the_grammar() -> None:
    assert (FOLDER / "tables.py").read_text(encoding="utf-8") == make_tables.make_tables()


def test_the_tables_do_not_depend_on_the_order_of_sets() -> None:
    code = (
        "from tests.tools import make_tables as m; import zlib; print(zlib.crc32(m.make_tables().encode()))"
    )
    made = {
        subprocess.run(
            [sys.executable, "-c", code],
            env={"PYTHONHASHSEED": seed},
            cwd=FOLDER.parent,
            capture_output=True,
            check=True,
        ).stdout
        for seed in ("1", "2")
    }
    assert len(made) == 1


def test_every_alternative_of_the_grammar_has_its_method() -> None:
    assert all(hasattr(TreeBuilder, rule[2]) for rule in tables.RULES if rule[2])
    assert all(rule[1] == 1 for rule in tables.RULES if rule[2] == "")


def test_every_class_of_nodes_is_in_a_union() -> None:
    """So mypy names the places that a new one lacks."""
    unions = get_args(syntax.Statement | syntax.Expression)

    assert {*syntax.Node.__subclasses__()} == {*unions, syntax.Condition, syntax.TextLiteral}


def test_a_name_is_the_first_terminal_after_the_end() -> None:
    assert tables.TERMINALS[0] == "$END"
    assert tables.TERMINALS[NAME] == "NAME"


def test_reading_needs_no_lark() -> None:
    code = "import sys; from language.parser import parse; parse('FW 1 +'); print('lark' in sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=FOLDER.parent, capture_output=True, check=True, text=True
    )
    assert done.stdout.strip() == "False"


def test_reading_works_from_any_thread_at_once() -> None:
    from concurrent.futures import ThreadPoolExecutor

    texts = [f"REPEAT {n} TIMES FW {n} END REPEAT" for n in range(50)]
    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(parse, texts)) == [parse(text) for text in texts]
