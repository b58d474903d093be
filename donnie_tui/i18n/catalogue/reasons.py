"""Why the system could not do it: parts of sentences, by the name of the error's number.

English has the words of the system. ``reason-NAME-CODE`` is for the sentence of that code only.
"""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    "reason-ENOENT": Sentence(
        "No such file or directory", "não existe esse arquivo ou pasta", "no existe ese archivo o carpeta"
    ),
    "reason-ENOENT-file-unwritable": Sentence(
        "there is no such folder", "essa pasta não existe", "esa carpeta no existe"
    ),
    "reason-EACCES": Sentence("Permission denied", "sem permissão", "sin permiso"),
    "reason-EPERM": Sentence("Operation not permitted", "não é permitido", "no se permite"),
    "reason-ENOSPC": Sentence("No space left on device", "o disco está cheio", "el disco está lleno"),
    "reason-EDQUOT": Sentence(
        "Disk quota exceeded", "não há mais espaço para você", "ya no hay espacio para ti"
    ),
    "reason-EROFS": Sentence(
        "Read-only file system", "esse disco só pode ser lido", "ese disco solo se puede leer"
    ),
    "reason-EISDIR": Sentence("Is a directory", "é uma pasta", "es una carpeta"),
    "reason-ENOTDIR": Sentence(
        "Not a directory", "uma parte do caminho não é pasta", "una parte del camino no es carpeta"
    ),
    "reason-ENAMETOOLONG": Sentence(
        "File name too long", "o nome é longo demais", "el nombre es demasiado largo"
    ),
    "reason-EINVAL": Sentence("it is not understood", "não se entende", "no se entiende"),
    "reason-EIO": Sentence("Input/output error", "o disco ou a linha falhou", "el disco o la línea falló"),
    "reason-EBUSY": Sentence("Device or resource busy", "está em uso", "está en uso"),
    "reason-EMFILE": Sentence(
        "Too many open files", "há arquivos abertos demais", "hay demasiados archivos abiertos"
    ),
    "reason-ETIMEDOUT": Sentence("Connection timed out", "não respondeu a tempo", "no respondió a tiempo"),
    "reason-ECONNREFUSED": Sentence("Connection refused", "a conexão foi recusada", "se rechazó la conexión"),
}
