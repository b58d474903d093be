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
