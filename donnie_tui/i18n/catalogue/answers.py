"""What both front ends answer to the same request, in the same words."""

from donnie_tui.i18n import first_words
from donnie_tui.i18n.sentence import Sentence

_RUNNING = {
    "answer-nothing-to-run": Sentence("Nothing to run.", "Nada para executar.", "Nada que ejecutar."),
    "answer-nothing-runs": Sentence("Nothing is running.", "Nada em execução.", "No se ejecuta nada."),
    "answer-stopped-at": Sentence(
        "Stopped at line {line}.", "Parado na linha {line}.", "Detenido en la línea {line}."
    ),
    "answer-stopped": Sentence("Stopped.", "Parado.", "Detenido."),
    "answer-paused-at": Sentence(
        "Paused at line {line}.", "Pausado na linha {line}.", "En pausa en la línea {line}."
    ),
    "answer-continued": Sentence("Going on.", "Continuando.", "Continuando."),
    "answer-reset": Sentence("I am back at the start.", "Voltei ao início.", "Volví al inicio."),
    "answer-speed": Sentence("Speed {speed}.", "Velocidade {speed}.", "Velocidad {speed}."),
    "answer-left-out": Sentence(
        "{lines} {lines:line was|lines were} left out.",
        "{lines} {lines:linha ficou|linhas ficaram} de fora.",
        "{lines} {lines:línea quedó|líneas quedaron} fuera.",
    ),
    "speed-max": Sentence("max", "max", "max"),
    "decimal": Sentence("{number:g}", "{number:g}", "{number:g}"),
}

_PROGRAM = {
    "answer-line": Sentence("Line {line}: {text}", "Linha {line}: {text}", "Línea {line}: {text}"),
    "answer-no-line": Sentence(
        "There is no line {line}. The last is {last}.",
        "Não há linha {line}. A última é {last}.",
        "No hay línea {line}. La última es {last}.",
    ),
    "answer-opened": Sentence(
        "Opened {name}, {lines} {lines:line|lines}.",
        "Aberto {name}, {lines} {lines:linha|linhas}.",
        "Abierto {name}, {lines} {lines:línea|líneas}.",
    ),
    "answer-saved": Sentence(
        "Saved {name}, {lines} {lines:line|lines}.",
        "Salvo {name}, {lines} {lines:linha|linhas}.",
        "Guardado {name}, {lines} {lines:línea|líneas}.",
    ),
    "answer-new": Sentence("A new program.", "Um programa novo.", "Un programa nuevo."),
    "answers-so-far": Sentence(
        "{count} {count:answer|answers} so far.",
        "{count} {count:resposta|respostas} até agora.",
        "{count} {count:respuesta|respuestas} hasta ahora.",
    ),
    "answer-unchanged": Sentence("Nothing was changed.", "Nada foi mudado.", "No se cambió nada."),
    "answer-rescued": Sentence(*first_words.RESCUED),
    "answer-rescued-more": Sentence(
        "There is one more. RECOVER opens it.",
        "Há mais um. RECUPERAR o abre.",
        "Hay uno más. RECUPERAR lo abre.",
    ),
    "answer-recovered": Sentence(
        "Here it is again, {lines} {lines:line|lines}.",
        "Aqui está de novo, {lines} {lines:linha|linhas}.",
        "Aquí está de nuevo, {lines} {lines:línea|líneas}.",
    ),
    "answer-recovered-file": Sentence(
        "Here {name} is again, {lines} {lines:line|lines}. SAVE saves it.",
        "Aqui está {name} de novo, {lines} {lines:linha|linhas}. SALVAR salva.",
        "Aquí está {name} de nuevo, {lines} {lines:línea|líneas}. GUARDAR lo guarda.",
        brief=(
            "{name}, {lines} {lines:line|lines}. SAVE saves it.",
            "{name}, {lines} {lines:linha|linhas}. SALVAR salva.",
            "{name}, {lines} {lines:línea|líneas}. GUARDAR lo guarda.",
        ),
    ),
    "answer-nothing-to-recover": Sentence(
        "Nothing to recover.", "Nada para recuperar.", "Nada que recuperar."
    ),
    "answer-not-kept": Sentence(
        "What you type can't be kept safe: {reason}.",
        "O que você digita não pode ser guardado: {reason}.",
        "Lo que escribes no se puede resguardar: {reason}.",
        brief=("Not kept safe: {reason}.", "Não guardado: {reason}.", "Sin guardar: {reason}."),
    ),
}

SENTENCES = _RUNNING | _PROGRAM
