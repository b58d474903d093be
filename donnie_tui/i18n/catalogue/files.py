"""Program files: why one can't be read or written."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    "file-not-found": Sentence(
        "There is no file {path}.", "Não existe o arquivo {path}.", "No existe el archivo {path}."
    ),
    "file-is-folder": Sentence("{path} is a folder.", "{path} é uma pasta.", "{path} es una carpeta."),
    "file-too-large": Sentence(
        "{path} is too large for a program.",
        "{path} é grande demais para um programa.",
        "{path} es demasiado grande para un programa.",
    ),
    "file-not-text": Sentence("{path} is no text.", "{path} não é um texto.", "{path} no es un texto."),
    "file-in-use": Sentence(
        "{path} is in use here. Give another name.",
        "{path} está em uso aqui. Dê outro nome.",
        "{path} está en uso aquí. Da otro nombre.",
    ),
    "file-is-open": Sentence(
        "{path} is an open program. Give another name.",
        "{path} é um programa aberto. Dê outro nome.",
        "{path} es un programa abierto. Da otro nombre.",
        brief=(
            "{path} is an open program.",
            "{path} é um programa aberto.",
            "{path} es un programa abierto.",
        ),
    ),
    "file-exists": Sentence(
        "{path} exists. Give another name.",
        "{path} já existe. Dê outro nome.",
        "{path} ya existe. Da otro nombre.",
        brief=("{path} exists already.", "{path} já existe.", "{path} ya existe."),
    ),
    "file-no-file": Sentence(
        "{path} is no ordinary file.", "{path} não é um arquivo comum.", "{path} no es un archivo común."
    ),
    "file-unreadable": Sentence(
        "I can't read {path}: {reason}.",
        "Não consigo ler {path}: {reason}.",
        "No puedo leer {path}: {reason}.",
    ),
    "file-unwritable": Sentence(
        "I can't write {path}: {reason}.",
        "Não consigo escrever {path}: {reason}.",
        "No puedo escribir {path}: {reason}.",
    ),
}
