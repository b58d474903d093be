"""After each wrong line the answer says what to type."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.sessions.learner import Learner
from tests.sessions.typed_lines import answers_to


def test_the_answer_to_repeatedly_refused_lines_names_the_word_that_forgets_them(tmp_path: Path) -> None:
    learner = Learner(tmp_path, language="pt")
    learner.enters("ola", "PF 2", "EXECUTAR")
    learner.sees("2 linhas esperam. Digite de novo a linha 1, ou APAGAR 1.\r\n")
    learner.enters("GD 90", "EXECUTAR")
    learner.sees("APAGAR sem número apaga 3 linhas que não foram executadas.\r\n")
    learner.enters("APAGAR", "PF 3", "EXECUTAR")
    learner.sees("Andei 3 passos para frente.\r\n")


@pytest.mark.parametrize(
    ("language", "line", "word", "answer"),
    [
        ("pt", "PF 1", "RODAR", "Andei 1 passo para frente."),
        ("es", "AV 1", "CORRER", "Caminé 1 paso hacia adelante."),
    ],
)
def test_the_everyday_word_for_running_a_program_runs_it(
    tmp_path: Path, language: str, line: str, word: str, answer: str
) -> None:
    learner = Learner(tmp_path, language=language)
    learner.enters(line, word)
    learner.sees(f"{answer}\r\n")


def test_a_heading_between_the_points_of_the_compass_is_spanish(tmp_path: Path) -> None:
    learner = Learner(tmp_path, language="es")
    learner.enters("GD 40", "EJECUTAR", "DÓNDE")
    learner.sees("Mirando a 40 grados, cerca del noreste.\r\n")
    learner.enters("GD 50", "EJECUTAR", "DÓNDE")
    learner.sees("Mirando al este.\r\n")


def test_the_prompt_of_the_tour_counts_open_blocks_and_an_empty_line_continues(
    tmp_path: Path,
) -> None:
    learner = Learner(tmp_path)
    learner.enters("TOUR", "REPEAT 2 TIMES")
    learner.sees("1> ")
    learner.types("FW 1\rEND REPEAT\r\r")
    learner.sees("I walked 1 step forward.\r\nI walked 1 step forward.\r\n> ")
    learner.types("\r")
    learner.sees("Page 2 of 9.")


def test_a_head_without_its_last_word_is_fixed_in_the_right_place(tmp_path: Path) -> None:
    """The answer names the head and not the first line of the block, where the mistake was noticed."""
    learner = Learner(tmp_path, language="pt")
    learner.enters("APRENDER canto: n", "PF n", "FIM APRENDER", "canto [2]", "EXECUTAR")
    learner.sees(
        "FAÇA vai no fim da linha 1.\r\nNada foi executado, 4 linhas esperam. CORRIGIR conserta a linha 1."
    )
    learner.enters("EXPLICAR")
    learner.sees("Escreve-se: APRENDER nome: nome FAÇA comandos FIM APRENDER.")
    learner.enters("CORRIGIR")
    learner.sees("nível 0: APRENDER canto: n FAÇA\r\n")
    learner.enters("EXECUTAR")
    learner.sees("Andei 2 passos para frente.")


def test_an_empty_line_in_an_open_block_reports_an_uncorrectable_mistake(tmp_path: Path) -> None:
    learner = Learner(tmp_path, language="pt")
    learner.enters("REPITA 3 VEZES", "PF 1", "")
    learner.sees("Falta fechar o REPITA da linha 1.")
    learner.enters("FIM SE", "")
    learner.sees("FIM SE não fecha o REPITA da linha 1.")
    learner.enters("CORRIGIR")
    learner.sees("FIM REPITA, fecha a linha 1.\r\n")
    learner.enters("")
    learner.sees("Andei 1 passo para frente.")


def test_a_word_that_counts_later_is_not_unknown_while_a_program_is_held(
    tmp_path: Path,
) -> None:
    learner = Learner(tmp_path, language="pt")
    learner.enters("PF 1", "PF 2", "PASSO")
    learner.sees("Linha 1: PF 1")
    learner.enters("NOVAMENTE")
    learner.sees("Um programa está em execução. Para parar, digite PARAR.\r\n")


def test_a_text_that_was_spoken_without_quotes_is_explained_as_one(tmp_path: Path) -> None:
    learner = Learner(tmp_path, language="pt")
    learner.enters("FALAR olá", "EXECUTAR")
    learner.sees("Não existe a variável olá.")
    learner.enters("EXPLICAR")
    learner.sees('Crie antes: CRIAR x = 5.\r\nOu, se é um texto: FALAR "oi".')


def test_steps_below_0_are_answered_with_the_way_back(tmp_path: Path) -> None:
    learner = Learner(tmp_path, language="pt")
    learner.enters("PF -2", "EXECUTAR")
    learner.sees("Andei 0 passos para frente.\r\nUm número menor que 0 não move o robô.\r\n")
    learner.sees("Você quis dizer PT 2?")


def test_after_a_mistake_only_what_is_new_is_said(tmp_path: Path) -> None:
    said = answers_to(tmp_path, "FW", "TR 90", "", "", "WALK 3", "")

    assert said == [
        "Error, line 1, column 1: FW needs a number, such as FW 2.",
        "Line 1: FW",
        "Nothing ran, 2 lines wait. FIX corrects line 1.",
        "Line 1 is still wrong. 2 lines wait. ERROR says why.",
        "DELETE without a number forgets the 2 lines that did not run.",
        "Error, line 3, column 1: I do not know WALK.",
        "Line 3: WALK 3",
        "Did you mean FW 3?",
        "Nothing ran, 3 lines wait. FIX corrects line 3.",
    ]


def test_a_line_that_is_typed_again_replaces_the_wrong_one(tmp_path: Path) -> None:
    said = answers_to(tmp_path, "FW", "TR 90", "WALK 3", "RUN", "FW 3", "FW 2", "RUN", "LIST")

    assert said[-8:] == [
        "Line 3 replaced. 3 lines wait.",
        "Line 1 replaced. 3 lines wait.",
        "I walked 2 steps forward.",
        "I turned 90 degrees to the right.",
        "I walked 3 steps forward.",
        "1: FW 2",
        "2: TR 90",
        "3: FW 3",
    ]


def test_the_end_of_a_block_replaces_no_wrong_line(tmp_path: Path) -> None:
    said = answers_to(tmp_path, "REPEAT 2 TIMES", "FW", "", "END REPEAT", "FW 1", "RUN")

    assert said[-3:] == [
        "Line 2 replaced. 3 lines wait.",
        "I walked 1 step forward.",
        "I walked 1 step forward.",
    ]


def test_a_failed_line_that_is_typed_again_continues_the_program_in_its_place(tmp_path: Path) -> None:
    said = answers_to(tmp_path, "FW 1", "x = 3", "BW 2", "RUN", "VAR x = 3", "RUN", "LIST")

    assert said == [
        "I walked 1 step forward.",
        "Error, line 2, column 1: There is no variable x.",
        "Line 2: x = 3",
        "Write VAR x first.",
        "1 line ran, line 2 failed, 1 line did not run.",
        "Line 2 replaced. 2 lines wait.",
        "I walked 2 steps backward.",
        "1: FW 1",
        "2: VAR x = 3",
        "3: BW 2",
    ]


def test_a_single_wrong_line_is_dropped_and_said_to_be(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "FW", "RUN", "FW 2", "RUN")[-2:] == [
        "Nothing ran, line 1 was dropped.",
        "I walked 2 steps forward.",
    ]


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        (("FW two",), "Nothing ran, line 1 failed."),
        (("SPEAK x",), "Nothing ran, line 1 failed."),
        (("FW 1 SPEAK x",), "The program ran up to the mistake in line 1."),
        (("REPEAT 2 TIMES FW 1 SPEAK 1 / 0 END REPEAT",), "The program ran up to the mistake in line 1."),
        (
            ("REPEAT 2 TIMES", "FW 1", "SPEAK 1 / 0", "END REPEAT"),
            "The program ran up to the mistake in line 3.",
        ),
    ],
)
def test_a_single_statement_that_fails_is_said_to_be_all(
    tmp_path: Path, typed: tuple[str, ...], said: str
) -> None:
    assert answers_to(tmp_path, *typed, "RUN")[-1] == said


def test_what_a_called_procedure_did_before_it_failed_is_not_denied(tmp_path: Path) -> None:
    boxes = ("PROCEDURE BOX: n DO", "FW n", "SPEAK n / 0", "END PROCEDURE", "RUN", "BOX [1]", "RUN")

    assert answers_to(tmp_path, *boxes)[-1] == "The program ran up to the mistake in line 3."


def test_a_block_that_is_run_before_its_end_is_kept(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "REPEAT 2 TIMES", "RUN", "FW 1", "END REPEAT", "RUN")[3:] == [
        "Nothing ran, 1 line waits.",
        "I walked 1 step forward.",
        "I walked 1 step forward.",
    ]


def test_a_line_unlike_the_wrong_ones_is_added_where_several_are_wrong(tmp_path: Path) -> None:
    said = answers_to(tmp_path, "WALK 1", "TR 90", "WALK 2", "RUN", "SCAN", "LIST")

    assert said[-4:] == ["1: WALK 1", "2: TR 90", "3: WALK 2", "4: SCAN"]
