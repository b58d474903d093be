"""Choosing a robot and a world from a list, in words."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    "ask-connect": Sentence("Robots to connect to", "Robôs para conectar", "Robots para conectar"),
    "ask-robot": Sentence("Robots of this world", "Robôs deste mundo", "Robots de este mundo"),
    "connect-choice-missing": Sentence(
        "{number}: {what}, not plugged in.", "{number}: {what}, desligado.", "{number}: {what}, desconectado."
    ),
    "connect-choice-forbidden": Sentence(
        "{number}: {what}, you may not open it.",
        "{number}: {what}, você não pode abrir.",
        "{number}: {what}, no puedes abrirlo.",
    ),
    "world-row": Sentence(
        "{name}: {title}, {difficulty}. {about} Task: {task}",
        "{name}: {title}, {difficulty}. {about} Tarefa: {task}",
        "{name}: {title}, {difficulty}. {about} Tarea: {task}",
    ),
}
