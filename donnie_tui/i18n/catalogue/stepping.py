"""Stepping, pausing, breakpoints, watched variables: the same in both front ends."""

from donnie_tui.i18n.sentence import Sentence

_ROUNDS = {
    "step-round": Sentence("Round {round}.", "Volta {round}.", "Vuelta {round}."),
    "step-round-of": Sentence(
        "Round {round} of {rounds}.", "Volta {round} de {rounds}.", "Vuelta {round} de {rounds}."
    ),
    "step-round-next": Sentence("Next round.", "Próxima volta.", "Vuelta siguiente."),
    "step-true": Sentence(
        "Condition true: {how}.", "Condição verdadeira: {how}.", "Condición verdadera: {how}."
    ),
    "step-false": Sentence("Condition false: {how}.", "Condição falsa: {how}.", "Condición falsa: {how}."),
    "comparison-equal": Sentence(
        "{left} equal to {right}", "{left} igual a {right}", "{left} igual a {right}"
    ),
    "comparison-different": Sentence(
        "{left} not equal to {right}", "{left} diferente de {right}", "{left} distinto de {right}"
    ),
    "comparison-less": Sentence(
        "{left} less than {right}", "{left} menor que {right}", "{left} menor que {right}"
    ),
    "comparison-greater": Sentence(
        "{left} greater than {right}", "{left} maior que {right}", "{left} mayor que {right}"
    ),
    "comparison-less-or-equal": Sentence(
        "{left} at most {right}", "{left} no máximo {right}", "{left} como máximo {right}"
    ),
    "comparison-greater-or-equal": Sentence(
        "{left} at least {right}", "{left} no mínimo {right}", "{left} como mínimo {right}"
    ),
}

_HOLDING = {
    "break-set": Sentence(
        "Breakpoint at line {line}.", "Parada na linha {line}.", "Parada en la línea {line}."
    ),
    "break-gone": Sentence(
        "No breakpoint at line {line} now.",
        "Sem parada na linha {line} agora.",
        "Sin parada en la línea {line}.",
    ),
    "break-nowhere": Sentence(
        "No command begins on line {line}, so nothing holds there.",
        "Nenhum comando começa na linha {line}, então nada para ali.",
        "Ningún comando empieza en la línea {line}, así que nada para ahí.",
        brief=(
            "No command begins on line {line}.",
            "Nenhum comando na linha {line}.",
            "Ningún comando en la línea {line}.",
        ),
    ),
    "step-from-start": Sentence(
        "From the start again.", "Desde o início de novo.", "Desde el inicio otra vez."
    ),
    "break-none": Sentence("No breakpoints.", "Nenhuma parada.", "Ninguna parada."),
    "break-lines": Sentence("Breakpoints: {lines}.", "Paradas: {lines}.", "Paradas: {lines}."),
    "watch-set": Sentence("Watching {name}.", "Vigiando {name}.", "Vigilando {name}."),
    "watch-gone": Sentence("Not watching {name} now.", "Não vigio mais {name}.", "Ya no vigilo {name}."),
    "watch-none": Sentence("Nothing is watched.", "Nada é vigiado.", "Nada se vigila."),
    "variable-is": Sentence("{name} is {value}.", "{name} é {value}.", "{name} es {value}."),
    "variable-not-yet": Sentence(
        "{name} is not there yet.", "{name} ainda não existe.", "{name} todavía no existe."
    ),
    "undone-step": Sentence("Back.", "De volta.", "Atrás."),
    "undone-more": Sentence("Back: {count} more.", "De volta: mais {count}.", "Atrás: {count} más."),
    "variables-none": Sentence("No variables.", "Nenhuma variável.", "Ninguna variable."),
    "call-at": Sentence("In {name}, line {line}.", "Em {name}, linha {line}.", "En {name}, línea {line}."),
    "still-walking": Sentence(
        "Still walking, {done} {done:step|steps} so far.",
        "Ainda andando, {done} {done:passo|passos} até agora.",
        "Todavía caminando, {done} {done:paso|pasos}.",
    ),
    "still-walking-of": Sentence(
        "Still walking, {done} of {asked} steps.",
        "Ainda andando, {done} de {asked} passos.",
        "Todavía caminando, {done} de {asked} pasos.",
    ),
}

_SAID = {
    "spell-blank": Sentence("blank", "espaço", "espacio"),
    "spell-capital": Sentence("capital {letter}", "maiúscula {letter}", "mayúscula {letter}"),
    "find-none": Sentence("{word} was not said.", "{word} não foi dito.", "{word} no se dijo."),
    "find-count": Sentence(
        "{count} {count:line|lines}, the newest last.",
        "{count} {count:linha|linhas}, a mais nova no fim.",
        "{count} {count:línea|líneas}, la más nueva al final.",
    ),
    "answer-nothing-said": Sentence("Nothing was said yet.", "Nada foi dito ainda.", "Nada se dijo todavía."),
    "answer-no-errors": Sentence("No errors.", "Nenhum erro.", "Ningún error."),
    "answer-no-more-errors": Sentence(
        "No more errors. That is {number} of {count}.",
        "Não há mais. É o {number} de {count}.",
        "No hay más. Es el {number} de {count}.",
    ),
    "answer-written": Sentence("Wrote {name}.", "Escrevi {name}.", "Escribí {name}."),
    "report-title": Sentence("Donnie: {what:small}", "Donnie: {what:small}", "Donnie: {what:small}"),
    "report-manual": Sentence("The manual", "O manual", "El manual"),
    "report-words": Sentence("Words of the terminal", "Palavras do terminal", "Palabras del terminal"),
    "report-program": Sentence("The program", "O programa", "El programa"),
    "report-map": Sentence("The map", "O mapa", "El mapa"),
    "report-trail": Sentence("The trail", "A trilha", "El rastro"),
    "report-column-how": Sentence("how it is typed", "como se digita", "cómo se escribe"),
    "report-column-purpose": Sentence("what for", "para quê", "para qué"),
    "report-column-line": Sentence("line", "linha", "línea"),
    "report-column-level": Sentence("level", "nível", "nivel"),
    "report-column-text": Sentence("text", "texto", "texto"),
    "report-column-name": Sentence("name", "nome", "nombre"),
    "report-column-color": Sentence("color", "cor", "color"),
    "report-column-x": Sentence("x", "x", "x"),
    "report-column-y": Sentence("y", "y", "y"),
    "report-column-place": Sentence("place", "lugar", "lugar"),
    "report-column-command": Sentence("command", "comando", "comando"),
    "report-column-done": Sentence("done", "feito", "hecho"),
    "report-column-heading": Sentence("heading", "direção", "dirección"),
    "report-yes": Sentence("yes", "sim", "sí"),
    "report-no": Sentence("no", "não", "no"),
    "report-column-blocked": Sentence("blocked", "bloqueado", "bloqueado"),
}

SENTENCES = _ROUNDS | _HOLDING | _SAID
