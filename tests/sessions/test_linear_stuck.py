"""Whoever typed something wrong finds a way on: it is said each time what to type."""

from __future__ import annotations

from pathlib import Path

from tests.sessions.learner import Learner


def test_lines_that_are_refused_again_can_be_forgotten_by_a_word_that_is_told(tmp_path: Path) -> None:
    learner = Learner(tmp_path, language="pt")
    learner.enters("ola", "PF 2", "EXECUTAR")
    learner.sees("Nada foi executado. MUDAR 1 corrige a linha 1, APAGAR 1 a apaga.\r\n")
    learner.enters("GD 90", "EXECUTAR")
    learner.sees("APAGAR sem número esquece as 3 linhas que não foram executadas.\r\n")
    learner.enters("APAGAR", "PF 3", "EXECUTAR")
    learner.sees("Andei 3 passos para frente.\r\n")


def test_where_quit_can_not_run_what_waits_it_is_told_how_to_leave(tmp_path: Path) -> None:
    learner = Learner(tmp_path, language="es")
    learner.enters("hola", "AV 2", "SALIR")
    learner.sees("SALIR otra vez sale de Donnie.\r\n")
    learner.enters("SALIR")

    assert learner.leaves() == 0


def test_on_the_tour_the_prompt_tells_how_many_blocks_are_open_and_an_empty_line_goes_on(
    tmp_path: Path,
) -> None:
    learner = Learner(tmp_path)
    learner.enters("TOUR", "REPEAT 2 TIMES")
    learner.sees("1> ")
    learner.types("FW 1\rEND REPEAT\r\r")
    learner.sees("I walked 1 step forward.\r\nI walked 1 step forward.\r\n> ")
    learner.types("\r")
    learner.sees("Page 2 of 9.")


def test_a_head_without_its_last_word_is_mended_where_it_belongs(tmp_path: Path) -> None:
    """What is told points at the head and not at the first line of the block, where it was noticed."""
    learner = Learner(tmp_path, language="pt")
    learner.enters("APRENDER canto: n", "PF n", "FIM APRENDER", "canto [2]", "EXECUTAR")
    learner.sees("FAÇA vai no fim da linha 1.\r\nNada foi executado. CORRIGIR corrige a linha 1,")
    learner.enters("EXPLICAR")
    learner.sees("Forma: APRENDER nome: nome FAÇA comandos FIM APRENDER.")
    learner.enters("CORRIGIR")
    learner.sees("nível 0: APRENDER canto: n FAÇA\r\n")
    learner.enters("EXECUTAR")
    learner.sees("Andei 2 passos para frente.")


def test_an_empty_line_in_an_open_block_tells_what_no_further_line_puts_right(tmp_path: Path) -> None:
    learner = Learner(tmp_path, language="pt")
    learner.enters("REPITA 3 VEZES", "PF 1", "")
    learner.sees("Ainda aberto: REPITA da linha 1.")
    learner.enters("FIM SE", "")
    learner.sees("FIM SE não fecha REPITA da linha 1.")
    learner.enters("CORRIGIR")
    learner.sees("FIM REPITA, fecha a linha 1.\r\n")
    learner.enters("")
    learner.sees("Andei 1 passo para frente.")


def test_a_word_of_the_terminal_that_counts_later_is_not_unknown_while_a_program_is_held(
    tmp_path: Path,
) -> None:
    learner = Learner(tmp_path, language="pt")
    learner.enters("PF 1", "PF 2", "PASSO")
    learner.sees("Linha 1: PF 1")
    learner.enters("NOVAMENTE")
    learner.sees("Agora não: NOVAMENTE\r\n")


def test_a_text_that_was_spoken_without_quotes_is_explained_as_one(tmp_path: Path) -> None:
    learner = Learner(tmp_path, language="pt")
    learner.enters("FALAR olá", "EXECUTAR")
    learner.sees("Não existe a variável olá.")
    learner.enters("EXPLICAR")
    learner.sees('Crie antes: CRIAR x = 5.\r\nOu, se é um texto: FALAR "oi".')


def test_steps_below_0_are_told_with_the_way_back(tmp_path: Path) -> None:
    learner = Learner(tmp_path, language="pt")
    learner.enters("PF -2", "EXECUTAR")
    learner.sees("Andei 0 passos para frente.\r\nUm número menor que 0 não move nada.\r\n")
    learner.sees("Você quis dizer PT 2?")
