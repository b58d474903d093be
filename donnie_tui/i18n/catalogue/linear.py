"""What the linear mode answers and asks."""

from donnie_tui.i18n import first_words
from donnie_tui.i18n.sentence import Sentence

_GREETING = {
    **{f"linear-cause-{cause}": Sentence(*texts) for cause, texts in first_words.CAUSES.items()},
    "linear-hint": Sentence(*first_words.HINT),
}

_RUNNING = {
    "linear-done": Sentence("Done.", "Feito.", "Hecho."),
    "linear-still-open": Sentence(
        "Still open: {opener} from line {line}.",
        "Ainda aberto: {opener} da linha {line}.",
        "Sigue abierto: {opener} de la línea {line}.",
    ),
    "linear-kept": Sentence(
        "Nothing ran. CHANGE {line} mends line {line}, DELETE {line} deletes it.",
        "Nada foi executado. MUDAR {line} corrige a linha {line}, APAGAR {line} a apaga.",
        "No se ejecutó nada. CAMBIAR {line} corrige la línea {line}, BORRAR {line} la borra.",
        brief=(
            "Nothing ran. CHANGE {line} or DELETE {line}.",
            "Nada feito. MUDAR {line} ou APAGAR {line}.",
            "Nada hecho. CAMBIAR {line} o BORRAR {line}.",
        ),
    ),
    "linear-kept-known": Sentence(
        "Nothing ran. FIX mends line {line}, CHANGE {line} changes it.",
        "Nada foi executado. CORRIGIR corrige a linha {line}, MUDAR {line} a muda.",
        "No se ejecutó nada. CORREGIR corrige la línea {line}, CAMBIAR {line} la cambia.",
        brief=(
            "Nothing ran. FIX or CHANGE {line}.",
            "Nada feito. CORRIGIR ou MUDAR {line}.",
            "Nada hecho. CORREGIR o CAMBIAR {line}.",
        ),
    ),
    "linear-forget": Sentence(
        "DELETE without a number forgets the {lines} lines that did not run.",
        "APAGAR sem número esquece as {lines} linhas que não foram executadas.",
        "BORRAR sin número olvida las {lines} líneas que no se ejecutaron.",
        brief=("DELETE alone forgets all.", "APAGAR sozinho esquece tudo.", "BORRAR solo olvida todo."),
    ),
    "linear-quit-again": Sentence(
        "QUIT again leaves.", "SAIR de novo sai do Donnie.", "SALIR otra vez sale de Donnie."
    ),
    "linear-still-at": Sentence(
        "Still at line {line}: {text}", "Ainda na linha {line}: {text}", "Todavía en la línea {line}: {text}"
    ),
    "linear-still-running": Sentence("Still running.", "Ainda executando.", "Todavía ejecutando."),
    "linear-cleared": Sentence("Line cleared.", "Linha apagada.", "Línea borrada."),
    "linear-nothing-to-stop": Sentence(
        "Nothing is running. QUIT leaves.",
        "Nada em execução. SAIR sai.",
        "Nada se está ejecutando. SALIR sale.",
    ),
    "linear-quit-in-block": Sentence(
        "That is a line of {opener}. Ctrl+D leaves.",
        "Essa é uma linha de {opener}. Ctrl+D sai.",
        "Esa es una línea de {opener}. Ctrl+D sale.",
    ),
    "linear-goodbye": Sentence("Goodbye.", "Até logo.", "Hasta luego."),
    "linear-did-not-run": Sentence(
        "{lines} {lines:line|lines} did not run. {missing} was missing.",
        "{lines} {lines:linha não foi executada|linhas não foram executadas}. Faltou {missing}.",
        "{lines} {lines:línea no se ejecutó|líneas no se ejecutaron}. Faltó {missing}.",
        brief=(
            "{lines} {lines:line|lines} did not run.",
            "{lines} {lines:linha não executada|linhas não executadas}.",
            "{lines} {lines:línea|líneas} sin ejecutar.",
        ),
    ),
    "linear-not-taken": Sentence("Not now: {line}", "Agora não: {line}", "Ahora no: {line}"),
    "linear-did-not-run-mistake": Sentence(
        "{lines} {lines:line|lines} did not run because of the mistake.",
        "{lines} {lines:linha não foi executada|linhas não foram executadas} por causa do erro.",
        "{lines} {lines:línea no se ejecutó|líneas no se ejecutaron} por el error.",
        brief=(
            "{lines} {lines:line|lines} did not run.",
            "{lines} {lines:linha não executada|linhas não executadas}.",
            "{lines} {lines:línea|líneas} sin ejecutar.",
        ),
    ),
    "linear-paused": Sentence(
        "Paused. CONTINUE goes on.", "Pausado. CONTINUAR segue.", "En pausa. CONTINUAR sigue."
    ),
    "linear-stepping": Sentence(
        "Enter goes on. RUN runs the rest. STOP ends.",
        "Enter continua. EXECUTAR faz o resto. PARAR termina.",
        "Enter sigue. EJECUTAR hace el resto. DETENER termina.",
        brief=(
            "Enter: next. RUN: rest. STOP: ends.",
            "Enter: segue. EXECUTAR: resto. PARAR.",
            "Enter: sigue. EJECUTAR: resto. DETENER.",
        ),
    ),
    "linear-too-long": Sentence(
        "The program is too long. That line is lost.",
        "O programa é longo demais. Essa linha se perdeu.",
        "El programa es demasiado largo. Esa línea se perdió.",
        brief=(
            "Program too long. That line is lost.",
            "Programa longo demais. Linha perdida.",
            "Programa muy largo. Línea perdida.",
        ),
    ),
}

_PROGRAM = {
    "linear-listed": Sentence("{line}: {text}", "{line}: {text}", "{line}: {text}"),
    "linear-lines": Sentence(
        "{lines} {lines:line|lines}.", "{lines} {lines:linha|linhas}.", "{lines} {lines:línea|líneas}."
    ),
    "linear-no-lines": Sentence("No lines yet.", "Nenhuma linha ainda.", "Ninguna línea todavía."),
    "linear-deleted": Sentence("Line {line} deleted.", "Linha {line} apagada.", "Línea {line} borrada."),
    "linear-deleted-lines": Sentence(
        "Lines {first} to {last} deleted.",
        "Linhas {first} a {last} apagadas.",
        "Líneas {first} a {last} borradas.",
    ),
    "linear-waits-again": Sentence(
        "RUN runs all {lines} lines again.",
        "EXECUTAR faz de novo as {lines} linhas.",
        "EJECUTAR hace de nuevo las {lines} líneas.",
    ),
    "linear-nothing-to-delete": Sentence("Nothing to delete.", "Nada para apagar.", "Nada que borrar."),
    "linear-edit": Sentence(
        "Edit line {line}, then Enter.", "Edite a linha {line}, e Enter.", "Edita la línea {line}, y Enter."
    ),
    "linear-type-line": Sentence(
        "Type line {line}, then Enter.",
        "Digite a linha {line}, e Enter.",
        "Escribe la línea {line}, y Enter.",
    ),
    "linear-like-this": Sentence(
        "I did not understand. Type {example}.",
        "Não entendi. Digite {example}.",
        "No entendí. Escribe {example}.",
        brief=("Type {example}.", "Digite {example}.", "Escribe {example}."),
    ),
}

_FILES = {
    "linear-nothing-to-save": Sentence("Nothing to save.", "Nada para salvar.", "Nada que guardar."),
    "linear-ask-replace-changed": Sentence(
        "{name} was changed by somebody else. Replace it, y or n? Enter means no.",
        "{name} foi mudado por outra pessoa. Substituir, s ou n? Enter é não.",
        "Otra persona cambió {name}. ¿Reemplazar, s o n? Enter es no.",
        brief=(
            "{name} changed. Replace? Enter: no.",
            "{name} mudou. Trocar? Enter: não.",
            "{name} cambió. ¿Cambiar? Enter: no.",
        ),
    ),
    "linear-ask-replace": Sentence(
        "{name} exists. Replace it, y or n? Enter means no.",
        "{name} já existe. Substituir, s ou n? Enter é não.",
        "{name} ya existe. ¿Reemplazar, s o n? Enter es no.",
        brief=(
            "Replace {name}, y or n? Enter: no.",
            "Trocar {name}, s ou n? Enter: não.",
            "¿Cambiar {name}, s o n? Enter: no.",
        ),
    ),
    "linear-ask-lose": Sentence(
        "{lines} {lines:line is|lines are} not saved. Lose them, y or n? Enter means no.",
        "{lines} {lines:linha não foi salva|linhas não foram salvas}. Perder, s ou n? Enter é não.",
        "{lines} {lines:línea no se guardó|líneas no se guardaron}. ¿Perder, s o n? Enter es no.",
        brief=(
            "Lose {lines} {lines:line|lines}, y or n? Enter: no.",
            "Perder {lines} {lines:linha|linhas}, s ou n? Enter: não.",
            "¿Perder {lines} {lines:línea|líneas}, s o n? Enter: no.",
        ),
    ),
    "linear-stays": Sentence(
        "Not saved, so Donnie stays open.",
        "Não foi salvo: o Donnie continua aberto.",
        "No se guardó: Donnie sigue abierto.",
        brief=("Not saved. Donnie stays.", "Não foi salvo. Donnie fica.", "No se guardó. Donnie se queda."),
    ),
    "linear-ask-save": Sentence(
        "{lines} {lines:line is|lines are} not saved. Save first, y or n? Enter means no.",
        "{lines} {lines:linha não foi salva|linhas não foram salvas}. Salvar, s ou n? Enter é não.",
        "{lines} {lines:línea no se guardó|líneas no se guardaron}. ¿Guardar, s o n? Enter es no.",
        brief=(
            "Save {lines} {lines:line|lines}, y or n? Enter: no.",
            "Salvar {lines} {lines:linha|linhas}, s ou n? Enter: não.",
            "¿Guardar {lines} {lines:línea|líneas}, s o n? Enter: no.",
        ),
    ),
    "linear-ask-name": Sentence(
        "Which file name? Enter means none.",
        "Qual nome de arquivo? Enter é nenhum.",
        "¿Qué nombre de archivo? Enter es ninguno.",
        brief=("Which file name? Enter: none.", "Qual nome? Enter: nenhum.", "¿Qué nombre? Enter: ninguno."),
    ),
    "linear-left": Sentence(
        "Not saved. RECOVER brings it back.",
        "Não foi salvo. RECUPERAR traz de volta.",
        "No se guardó. RECUPERAR lo devuelve.",
    ),
    "linear-yes-or-no": Sentence("Type y or n.", "Digite s ou n.", "Escribe s o n."),
}

_SETTINGS = {
    "linear-in-words": Sentence("Here you type {word}.", "Aqui se digita {word}.", "Aquí se escribe {word}."),
    "linear-on-screen": Sentence(
        "Only in the full screen: type VISUAL.",
        "Só na tela cheia: digite VISUAL.",
        "Solo en la pantalla: escribe VISUAL.",
    ),
    "linear-language": Sentence("Language: English.", "Idioma: português.", "Idioma: español."),
    "linear-detail": Sentence(
        "Detail: normal.",
        "Detalhe: normal.",
        "Detalle: normal.",
        brief=("Detail: brief.", "Detalhe: breve.", "Detalle: breve."),
        full=("Detail: full.", "Detalhe: completo.", "Detalle: completo."),
    ),
    "linear-no-screen": Sentence(
        "The full screen needs a terminal.",
        "A tela cheia precisa de um terminal.",
        "La pantalla completa necesita un terminal.",
        brief=(
            "The full screen needs a terminal.",
            "A tela cheia precisa de um terminal.",
            "La pantalla necesita un terminal.",
        ),
    ),
    "linear-linear": Sentence(
        "This is the linear mode already.", "Este já é o modo linear.", "Este ya es el modo lineal."
    ),
}

_HELP = {
    "linear-help": Sentence(
        "{count} words of the terminal:",
        "{count} palavras do terminal:",
        "{count} palabras del terminal:",
    ),
    "linear-help-keys": Sentence(
        "HELP KEYS tells the keys.", "AJUDA TECLAS diz as teclas.", "AYUDA TECLAS dice las teclas."
    ),
    "linear-keys-enter": Sentence(
        "Enter: the next line.", "Enter: próxima linha.", "Enter: línea siguiente."
    ),
    "linear-keys-run": Sentence(
        "Esc, RUN or an empty line: runs.",
        "Esc, EXECUTAR ou linha vazia: executa.",
        "Esc, EJECUTAR o línea vacía: ejecuta.",
    ),
    "linear-keys-stop": Sentence(
        "Ctrl+C: stops the robot.", "Ctrl+C: para o robô.", "Ctrl+C: detiene el robot."
    ),
    "linear-keys-past": Sentence(
        "Up and down: lines typed before.",
        "Para cima e para baixo: linhas de antes.",
        "Arriba y abajo: líneas de antes.",
    ),
    "linear-keys-line": Sentence(
        "Home, End, Delete, Backspace: edit.",
        "Home, End, Delete, Backspace: editam.",
        "Inicio, Fin, Supr, Retroceso: editan.",
    ),
    "linear-keys-word": Sentence(
        "Ctrl+W: deletes a word.", "Ctrl+W: apaga uma palavra.", "Ctrl+W: borra una palabra."
    ),
    "linear-keys-clear": Sentence(
        "Ctrl+U: clears the line.", "Ctrl+U: apaga a linha.", "Ctrl+U: borra la línea."
    ),
    "linear-keys-tab": Sentence(
        "Tab: completes a word.", "Tab: completa uma palavra.", "Tab: completa una palabra."
    ),
    "linear-keys-leave": Sentence(
        "Ctrl+D: leaves Donnie.", "Ctrl+D: sai do Donnie.", "Ctrl+D: sale de Donnie."
    ),
}

_PAGES = {
    "linear-numbers": Sentence(
        "Those were {count} numbers.", "Foram {count} números.", "Fueron {count} números."
    ),
    "linear-more": Sentence(
        "More, {lines} {lines:line|lines}. Enter goes on, Q stops.",
        "Mais {lines} {lines:linha|linhas}. Enter segue, S para.",
        "Más, {lines} {lines:línea|líneas}. Enter sigue, S para.",
        brief=(
            "{lines} more. Enter, or Q to stop.",
            "Mais {lines}. Enter, ou S para parar.",
            "{lines} más. Enter, o S para parar.",
        ),
    ),
    "linear-choices": Sentence(
        "{count} words.",
        "{count} palavras.",
        "{count} palabras.",
    ),
    "linear-chapters": Sentence(
        "{count} chapters. MANUAL 1 reads the first.",
        "{count} capítulos. MANUAL 1 lê o primeiro.",
        "{count} capítulos. MANUAL 1 lee el primero.",
        brief=(
            "{count} chapters. MANUAL 1 reads one.",
            "{count} capítulos. MANUAL 1 lê um.",
            "{count} capítulos. MANUAL 1 lee uno.",
        ),
    ),
    "linear-nothing-typed": Sentence(
        "Nothing was typed yet.", "Nada foi digitado ainda.", "Nada se escribió todavía."
    ),
    "linear-type-number": Sentence(
        "Type a number to do it again.", "Digite um número para repetir.", "Escribe un número para repetir."
    ),
}

_HABITS = {
    "habit-page": Sentence(
        "Long answers, {name}: {value}.",
        "Respostas longas, {name}: {value}.",
        "Respuestas largas, {name}: {value}.",
    ),
    "habit-prompt": Sentence(
        "Before the line, {name}: {value}.",
        "Antes da linha, {name}: {value}.",
        "Antes de la línea, {name}: {value}.",
    ),
    "habit-hold": Sentence(
        "Wait at each line, {name}: {value}.",
        "Esperar a cada linha, {name}: {value}.",
        "Esperar en cada línea, {name}: {value}.",
    ),
    "habit-editor": Sentence(
        "Typing, {name}: {value}.", "Digitação, {name}: {value}.", "Escritura, {name}: {value}."
    ),
    "habit-enter": Sentence(
        "Enter key, {name}: {value}.", "Tecla Enter, {name}: {value}.", "Tecla Enter, {name}: {value}."
    ),
    "habit-progress": Sentence(
        "Signs of life, {name}: {value} {value:second|seconds}.",
        "Sinais de vida, {name}: {value} {value:segundo|segundos}.",
        "Señales, {name}: {value} {value:segundo|segundos}.",
    ),
    "habit-progress-never": Sentence(
        "Signs of life, {name}: never.", "Sinais de vida, {name}: nunca.", "Señales, {name}: nunca."
    ),
    "habit-clock": Sentence(
        "Clock face, {name}: {value}.", "Como relógio, {name}: {value}.", "Como reloj, {name}: {value}."
    ),
    "habit-free": Sentence(
        "Free squares, {name}: {value}.",
        "Casas livres, {name}: {value}.",
        "Casillas libres, {name}: {value}.",
    ),
    "habit-numbers": Sentence(
        "Choose a number, {least} to {most}.",
        "Escolha um número, de {least} a {most}.",
        "Elige un número, de {least} a {most}.",
    ),
    "habit-choices": Sentence("Choose: {choices}.", "Escolha: {choices}.", "Elige: {choices}."),
}

_MODES = {
    "mode-ask-linear": Sentence(
        "Always begin in linear mode, y or n? Enter means no.",
        "Começar sempre no modo linear, s ou n? Enter é não.",
        "¿Empezar siempre en modo lineal, s o n? Enter es no.",
        brief=(
            "Always linear, y or n? Enter means no.",
            "Sempre linear, s ou n? Enter é não.",
            "¿Siempre lineal, s o n? Enter es no.",
        ),
    ),
    "mode-ask-visual": Sentence(
        "Always begin in the full screen, y or n? Enter means no.",
        "Começar sempre na tela cheia, s ou n? Enter é não.",
        "¿Empezar siempre en pantalla completa, s o n? Enter es no.",
        brief=(
            "Always full screen, y or n? Enter: no.",
            "Sempre tela cheia, s ou n? Enter: não.",
            "¿Siempre pantalla, s o n? Enter: no.",
        ),
    ),
    "mode-remembered": Sentence("I will remember it.", "Vou lembrar disso.", "Lo voy a recordar."),
}

SENTENCES: dict[str, Sentence] = (
    _GREETING | _RUNNING | _PROGRAM | _FILES | _SETTINGS | _HELP | _PAGES | _HABITS | _MODES
)
