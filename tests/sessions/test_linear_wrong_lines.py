"""After each wrong line the answer says what to type."""

from __future__ import annotations

from pathlib import Path

from tests.sessions.learner import Learner


def test_the_answer_to_repeatedly_refused_lines_names_the_word_that_forgets_them(tmp_path: Path) -> None:
    learner = Learner(tmp_path, language="pt")
    learner.enters("ola", "PF 2", "EXECUTAR")
    learner.sees("Nada foi executado. MUDAR 1 muda a linha 1, APAGAR 1 apaga.\r\n")
    learner.enters("GD 90", "EXECUTAR")
    learner.sees("APAGAR sem número apaga 3 linhas que não foram executadas.\r\n")
    learner.enters("APAGAR", "PF 3", "EXECUTAR")
    learner.sees("Andei 3 passos para frente.\r\n")


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
    learner.sees("FAÇA vai no fim da linha 1.\r\nNada foi executado. CORRIGIR conserta a linha 1,")
    learner.enters("EXPLICAR")
    learner.sees("Forma: APRENDER nome: nome FAÇA comandos FIM APRENDER.")
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
