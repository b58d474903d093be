"""What the full screen says: titles, the status line, its answers, and what each action is for.

``action-NAME`` is the purpose of an action, ``key-NAME`` its label in the bottom line, ``kind-NAME`` the
kind of a line in the log. Titles and labels are no sentences: they have no full stop.
"""

from donnie_tui.i18n import first_screen
from donnie_tui.i18n.sentence import Sentence

_PANES = {
    "pane-program": Sentence("Program: {name}", "Programa: {name}", "Programa: {name}"),
    "pane-program-changed": Sentence(
        "Program: {name}, changed", "Programa: {name}, alterado", "Programa: {name}, cambiado"
    ),
    "pane-map": Sentence(
        "Map: {world}, {width} by {height} steps",
        "Mapa: {world}, {width} por {height} passos",
        "Mapa: {world}, {width} por {height} pasos",
    ),
    "pane-map-empty": Sentence(*first_screen.MAP),
    "pane-log": Sentence(*first_screen.LOG),
    "pane-inspector": Sentence(*first_screen.VARIABLES),
    "new-program": Sentence("new program", "programa novo", "programa nuevo"),
    "typed-program": Sentence("command line", "linha de comando", "línea de comandos"),
}

_STATUS = {
    "status-program": Sentence(
        "Program, line {line} of {lines}.",
        "Programa, linha {line} de {lines}.",
        "Programa, línea {line} de {lines}.",
    ),
    "status-map": Sentence("Map.", "Mapa.", "Mapa."),
    "status-map-cell": Sentence("Map, {what}", "Mapa, {what}", "Mapa, {what}"),
    "status-log": Sentence(
        "Log, line {line} of {lines}.",
        "Registro, linha {line} de {lines}.",
        "Registro, línea {line} de {lines}.",
    ),
    "status-inspector": Sentence("Variables.", "Variáveis.", "Variables."),
    "status-command": Sentence("Command line.", "Linha de comando.", "Línea de comandos."),
    "status-robot": Sentence(
        "{robot} at {x}, {y} facing {facing}.",
        "{robot} em {x}, {y} virado para {facing}.",
        "{robot} en {x}, {y} mirando al {facing}.",
    ),
    "status-degrees": Sentence(
        "{degrees} {degrees:degree|degrees}",
        "{degrees} {degrees:grau|graus}",
        "{degrees} {degrees:grado|grados}",
    ),
    "status-ready": Sentence("Ready.", "Pronto.", "Listo."),
    "status-running": Sentence("Running.", "Executando.", "Ejecutando."),
    "status-paused": Sentence("Paused.", "Pausado.", "En pausa."),
    "status-stopping": Sentence("Stopping.", "Parando.", "Deteniendo."),
    "status-ready-speed": Sentence(
        "Ready, speed {speed}.", "Pronto, velocidade {speed}.", "Listo, velocidad {speed}."
    ),
    "status-running-speed": Sentence(
        "Running, speed {speed}.", "Executando, velocidade {speed}.", "Ejecutando, velocidad {speed}."
    ),
    "status-paused-speed": Sentence(
        "Paused, speed {speed}.", "Pausado, velocidade {speed}.", "En pausa, velocidad {speed}."
    ),
    "status-stopping-speed": Sentence("Stopping.", "Parando.", "Deteniendo."),
    "status-starting": Sentence(*first_screen.STARTING),
}

_INSPECTOR = {
    "inspector-variables": Sentence("Variables:", "Variáveis:", "Variables:"),
    "inspector-no-variables": Sentence("No variables.", "Nenhuma variável.", "Ninguna variable."),
    "inspector-variable": Sentence("{name} is {value}", "{name} é {value}", "{name} es {value}"),
    "inspector-calls": Sentence("Calls:", "Chamadas:", "Llamadas:"),
    "inspector-call": Sentence("{name}, line {line}", "{name}, linha {line}", "{name}, línea {line}"),
    "inspector-main": Sentence("program, line {line}", "programa, linha {line}", "programa, línea {line}"),
    "inspector-distances": Sentence("Distances now:", "Distâncias agora:", "Distancias ahora:"),
    "inspector-readings": Sentence("Last readings:", "Últimas leituras:", "Últimas lecturas:"),
    "inspector-reading": Sentence("{what}: {value}", "{what}: {value}", "{what}: {value}"),
    "reading-distance": Sentence("distance {where}", "distância {where}", "distancia {where}"),
    "reading-position": Sentence("position {where}", "posição {where}", "posición {where}"),
    "reading-colour": Sentence("color {where}", "cor {where}", "color {where}"),
    "where-front": Sentence("ahead", "à frente", "al frente"),
    "where-front-right": Sentence("ahead right", "à frente à direita", "al frente a la derecha"),
    "where-front-left": Sentence("ahead left", "à frente à esquerda", "al frente a la izquierda"),
    "where-back": Sentence("behind", "atrás", "atrás"),
    "where-back-right": Sentence("behind right", "atrás à direita", "atrás a la derecha"),
    "where-back-left": Sentence("behind left", "atrás à esquerda", "atrás a la izquierda"),
}

_ANSWERS = {
    "screen-start": Sentence(*first_screen.START),
    "screen-fault": Sentence(*first_screen.FAULT),
    "screen-done": Sentence("The program is done.", "O programa terminou.", "El programa terminó."),
    "screen-busy": Sentence(
        "A program is running. STOP stops it.",
        "Um programa está sendo executado. PARAR para.",
        "Un programa se está ejecutando. DETENER lo detiene.",
    ),
    "screen-starting": Sentence(*first_screen.ONE_MOMENT),
    "screen-bad-speed": Sentence(
        "A speed is a number from {slowest:g} to {fastest:g}, or max.",
        "A velocidade é um número de {slowest:g} a {fastest:g}, ou max.",
        "La velocidad es un número de {slowest:g} a {fastest:g}, o max.",
        brief=(
            "From {slowest:g} to {fastest:g}, or max.",
            "De {slowest:g} a {fastest:g}, ou max.",
            "De {slowest:g} a {fastest:g}, o max.",
        ),
    ),
}

_QUESTIONS = {
    "ask-open": Sentence("File to open:", "Arquivo para abrir:", "Archivo para abrir:"),
    "ask-save": Sentence("Save as:", "Salvar como:", "Guardar como:"),
    "ask-yes-no": Sentence("Type yes or no.", "Digite sim ou não.", "Escribe sí o no."),
    "ask-replace": Sentence(
        "{name} exists. Replace it? yes or no:",
        "{name} já existe. Substituir? sim ou não:",
        "{name} ya existe. ¿Reemplazar? sí o no:",
    ),
    "ask-replace-changed": Sentence(
        "{name} was changed by somebody else. Replace it? yes or no:",
        "{name} foi mudado por outra pessoa. Substituir? sim ou não:",
        "Otra persona cambió {name}. ¿Reemplazar? sí o no:",
    ),
    "ask-unsaved": Sentence(
        "{name} is not saved. Save it? yes or no:",
        "{name} não foi salvo. Salvar? sim ou não:",
        "{name} no se guardó. ¿Guardar? sí o no:",
    ),
    "ask-keys": Sentence(
        "Enter answers, Esc goes back", "Enter responde, Esc volta", "Enter responde, Esc vuelve"
    ),
    "help-title": Sentence(
        "Help. F1: the manual. Esc goes back",
        "Ajuda. F1: o manual. Esc volta",
        "Ayuda. F1: el manual. Esc vuelve",
    ),
    "help-further": Sentence(
        "F1 again: the manual of the language. Esc goes back, from there too.",
        "F1 outra vez: o manual da linguagem. Esc volta, de lá também.",
        "F1 otra vez: el manual del lenguaje. Esc vuelve, de allí también.",
    ),
    "chooser-keys": Sentence(
        "Up and Down choose, typing narrows, Enter takes it, Esc goes back",
        "Seta acima e abaixo escolhem, digitar filtra, Enter aceita, Esc volta",
        "Arriba y abajo eligen, escribir filtra, Enter acepta, Esc vuelve",
    ),
    "palette-ask": Sentence("Type what to do", "Digite o que fazer", "Escribe qué hacer"),
    "palette-nothing": Sentence("Nothing of that name.", "Nada com esse nome.", "Nada con ese nombre."),
    "help-palette": Sentence(
        "Ctrl+P: lists all of these to choose from.",
        "Ctrl+P: lista tudo isto para escolher.",
        "Ctrl+P: lista todo esto para elegir.",
    ),
    "help-screen-words": Sentence("Keys and words:", "Teclas e palavras:", "Teclas y palabras:"),
    "help-program-words": Sentence("GoDonnie:", "GoDonnie:", "GoDonnie:"),
}


_KEY_LABELS = {
    "run": ("Run", "Executar", "Ejecutar"),
    "stop": ("Stop", "Parar", "Detener"),
    "pause": ("Pause", "Pausar", "Pausa"),
    "continue_": ("Go on", "Continuar", "Continuar"),
    "step": ("Step", "Passo", "Paso"),
    "step_over": ("Over", "Inteiro", "Entero"),
    "run_to": ("To here", "Até aqui", "Hasta aquí"),
    "slower": ("Slower", "Devagar", "Lento"),
    "faster": ("Faster", "Rápido", "Rápido"),
    "speed": ("Speed", "Velocidade", "Velocidad"),
    "reset": ("Reset", "Reiniciar", "Reiniciar"),
    "where": ("Where", "Onde", "Dónde"),
    "open": ("Open", "Abrir", "Abrir"),
    "save": ("Save", "Salvar", "Guardar"),
    "save_as": ("Save as", "Salvar como", "Guardar como"),
    "new": ("New", "Novo", "Nuevo"),
    "recover": ("Recover", "Recuperar", "Recuperar"),
    "show_program": ("Program", "Programa", "Programa"),
    "show_map": ("Map", "Mapa", "Mapa"),
    "show_log": ("Log", "Registro", "Registro"),
    "show_variables": ("Variables", "Variáveis", "Variables"),
    "help": ("Help", "Ajuda", "Ayuda"),
    "linear": ("Linear", "Linear", "Lineal"),
    "quit": ("Quit", "Sair", "Salir"),
}
"""What an action is called where there is little room: in the bottom line and the palette."""

_ACTIONS = {f"key-{name}": Sentence(*label) for name, label in _KEY_LABELS.items()}

_KINDS = {
    f"kind-{kind}": Sentence(en, pt, es)
    for kind, en, pt, es in (
        ("moved", "moved", "andou", "caminó"),
        ("turned", "turned", "girou", "giró"),
        ("obstacle", "obstacle", "obstáculo", "obstáculo"),
        ("collision", "collision", "batida", "choque"),
        ("stopped", "stopped", "parou", "detenido"),
        ("spoke", "says", "fala", "habla"),
        ("error", "error", "erro", "error"),
        ("typed", "typed", "digitado", "escrito"),
        ("answer", "", "", ""),
        ("state", "state", "estado", "estado"),
        ("position", "position", "posição", "posición"),
        ("scan", "sees", "vê", "ve"),
        ("history", "history", "histórico", "historial"),
        ("sound", "sound", "som", "sonido"),
        ("belt", "belt", "cinto", "cinturón"),
        ("waiting", "waits", "espera", "espera"),
        ("link", "robot", "robô", "robot"),
        ("hint", "hint", "dica", "pista"),
        ("help", "help", "ajuda", "ayuda"),
    )
}

SENTENCES = _PANES | _STATUS | _INSPECTOR | _ANSWERS | _QUESTIONS | _ACTIONS | _KINDS
