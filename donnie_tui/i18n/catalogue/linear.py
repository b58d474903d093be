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
        "Nothing ran. CHANGE {line} mends line {line}.",
        "Nada foi executado. MUDAR {line} corrige a linha {line}.",
        "No se ejecutó nada. CAMBIAR {line} corrige la línea {line}.",
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
        "{lines} {lines:line|lines} did not run. RUN was missing.",
        "{lines} {lines:linha não foi executada|linhas não foram executadas}. Faltou EXECUTAR.",
        "{lines} {lines:línea no se ejecutó|líneas no se ejecutaron}. Faltó EJECUTAR.",
    ),
    "linear-stepping": Sentence(
        "Enter goes on. RUN runs the rest. STOP ends.",
        "Enter continua. EXECUTAR faz o resto. PARAR termina.",
        "Enter sigue. EJECUTAR hace el resto. DETENER termina.",
    ),
    "linear-too-long": Sentence(
        "The program is too long. That line is lost.",
        "O programa é longo demais. Essa linha se perdeu.",
        "El programa es demasiado largo. Esa línea se perdió.",
    ),
}

_PROGRAM = {
    "linear-line-empty": Sentence("Line {line}: empty.", "Linha {line}: vazia.", "Línea {line}: vacía."),
    "linear-listed": Sentence("{line}: {text}", "{line}: {text}", "{line}: {text}"),
    "linear-lines": Sentence(
        "{lines} {lines:line|lines}.", "{lines} {lines:linha|linhas}.", "{lines} {lines:línea|líneas}."
    ),
    "linear-no-lines": Sentence("No lines yet.", "Nenhuma linha ainda.", "Ninguna línea todavía."),
    "linear-deleted": Sentence(
        "{lines} {lines:line|lines} deleted.",
        "{lines} {lines:linha apagada|linhas apagadas}.",
        "{lines} {lines:línea borrada|líneas borradas}.",
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
    ),
}

_FILES = {
    "linear-nothing-to-save": Sentence("Nothing to save.", "Nada para salvar.", "Nada que guardar."),
    "linear-ask-replace": Sentence(
        "{name} exists. Replace it, y or n? Enter means no.",
        "{name} já existe. Substituir, s ou n? Enter é não.",
        "{name} ya existe. ¿Reemplazar, s o n? Enter es no.",
    ),
    "linear-ask-lose": Sentence(
        "{lines} {lines:line is|lines are} not saved. Lose them, y or n? Enter means no.",
        "{lines} {lines:linha não foi salva|linhas não foram salvas}. Perder, s ou n? Enter é não.",
        "{lines} {lines:línea no se guardó|líneas no se guardaron}. ¿Perder, s o n? Enter es no.",
    ),
    "linear-ask-save": Sentence(
        "{lines} {lines:line is|lines are} not saved. Save first, y or n? Enter means no.",
        "{lines} {lines:linha não foi salva|linhas não foram salvas}. Salvar, s ou n? Enter é não.",
        "{lines} {lines:línea no se guardó|líneas no se guardaron}. ¿Guardar, s o n? Enter es no.",
    ),
    "linear-ask-name": Sentence(
        "Which file name? Enter means none.",
        "Qual nome de arquivo? Enter é nenhum.",
        "¿Qué nombre de archivo? Enter es ninguno.",
    ),
    "linear-yes-or-no": Sentence("Type y or n.", "Digite s ou n.", "Escribe s o n."),
}

_SETTINGS = {
    "linear-language": Sentence("Language: English.", "Idioma: português.", "Idioma: español."),
    "linear-detail": Sentence(
        "Detail: normal.",
        "Detalhe: normal.",
        "Detalle: normal.",
        brief=("Detail: brief.", "Detalhe: breve.", "Detalle: breve."),
        full=("Detail: full.", "Detalhe: completo.", "Detalle: completo."),
    ),
    "linear-nothing-said": Sentence("Nothing was said yet.", "Nada foi dito ainda.", "Nada se dijo todavía."),
    "linear-no-errors": Sentence("No errors.", "Nenhum erro.", "Ningún error."),
    "linear-no-screen": Sentence(
        "The full screen needs a terminal.",
        "A tela cheia precisa de um terminal.",
        "La pantalla completa necesita un terminal.",
    ),
    "linear-linear": Sentence(
        "This is the linear mode already.", "Este já é o modo linear.", "Este ya es el modo lineal."
    ),
}

_MAP = {
    "linear-picture": Sentence(
        "Picture, {width} by {height}. The robot is {robot}",
        "Imagem, {width} por {height}. O robô é {robot}",
        "Imagen, {width} por {height}. El robot es {robot}",
    ),
    "linear-picture-wall": Sentence("Wall: {letter}", "Parede: {letter}", "Pared: {letter}"),
    "linear-picture-free": Sentence("Free: {letter}", "Livre: {letter}", "Libre: {letter}"),
    "linear-picture-thing": Sentence("{name}: {letter}", "{name}: {letter}", "{name}: {letter}"),
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
    "linear-keys-leave": Sentence(
        "Ctrl+D: leaves Donnie.", "Ctrl+D: sai do Donnie.", "Ctrl+D: sale de Donnie."
    ),
}

SENTENCES: dict[str, Sentence] = _GREETING | _RUNNING | _PROGRAM | _FILES | _SETTINGS | _MAP | _HELP
