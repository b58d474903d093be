"""The command line: what can't be done, what is still to come, and the settings."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    # --- still to come
    "command-to-come": Sentence(
        "The command {command} is not there yet.",
        "O comando {command} ainda não existe.",
        "El comando {command} aún no existe.",
    ),
    # --- wrong usage
    "bad-option": Sentence(
        "The option {option} can't be {value}. It takes {wanted}.",
        "A opção {option} não pode ser {value}. Ela aceita {wanted}.",
        "La opción {option} no puede ser {value}. Acepta {wanted}.",
    ),
    "events-need-run": Sentence(
        "The option --events - is for donnie run. Name a file here.",
        "A opção --events - é de donnie run. Aqui, dê um arquivo.",
        "La opción --events - es de donnie run. Aquí, da un archivo.",
    ),
    "usage-missing": Sentence(
        "Missing: {what}. The option --help tells more.",
        "Falta: {what}. A opção --help diz mais.",
        "Falta: {what}. La opción --help dice más.",
    ),
    "usage-unrecognized": Sentence(
        "I do not understand {what}. The option --help tells more.",
        "Não entendo {what}. A opção --help diz mais.",
        "No entiendo {what}. La opción --help dice más.",
    ),
    "usage-without-value": Sentence(
        "The option {what} needs a value. The option --help tells more.",
        "A opção {what} precisa de um valor. A opção --help diz mais.",
        "La opción {what} necesita un valor. La opción --help dice más.",
    ),
    "usage-no-number": Sentence(
        "The option {what} takes a whole number, such as 12.",
        "A opção {what} aceita um número inteiro, por exemplo 12.",
        "La opción {what} acepta un número entero, por ejemplo 12.",
    ),
    "usage-not-together": Sentence(
        "The option {what} contradicts another one.",
        "A opção {what} contradiz outra.",
        "La opción {what} contradice a otra.",
    ),
    "usage-prefix": Sentence("usage:", "uso:", "uso:"),
    "usage-arguments": Sentence("arguments", "argumentos", "argumentos"),
    "output-unwritable": Sentence(
        "I can't write the output: {reason}.",
        "Não consigo escrever a saída: {reason}.",
        "No puedo escribir la salida: {reason}.",
    ),
    # --- settings
    "setting-unknown": Sentence(
        "Unknown setting in the file: {name}.",
        "Configuração desconhecida no arquivo: {name}.",
        "Ajuste desconocido en el archivo: {name}.",
        brief=(
            "Unknown setting: {name}.",
            "Configuração desconhecida: {name}.",
            "Ajuste desconocido: {name}.",
        ),
    ),
    "setting-not-understood": Sentence(
        "The setting {name} can't be {value}. It takes {wanted}.",
        "A configuração {name} não pode ser {value}. Aceita {wanted}.",
        "El ajuste {name} no puede ser {value}. Acepta {wanted}.",
        brief=(
            "Setting {name}: {wanted}, not {value}.",
            "Ajuste {name}: {wanted}, não {value}.",
            "Ajuste {name}: {wanted}, no {value}.",
        ),
    ),
    "variable-not-understood": Sentence(
        "The variable {name} can't be {value}. It takes {wanted}.",
        "A variável {name} não pode ser {value}. Aceita {wanted}.",
        "La variable {name} no puede ser {value}. Acepta {wanted}.",
        brief=(
            "Variable {name}: {wanted}, not {value}.",
            "Variável {name}: {wanted}, não {value}.",
            "Variable {name}: {wanted}, no {value}.",
        ),
    ),
    "setting-not-understood-example": Sentence(
        "The setting {name} can't be {value}. For example: {wanted}.",
        "A configuração {name} não pode ser {value}. Por exemplo: {wanted}.",
        "El ajuste {name} no puede ser {value}. Por ejemplo: {wanted}.",
        brief=(
            "Setting {name}: {wanted}, not {value}.",
            "Ajuste {name}: {wanted}, não {value}.",
            "Ajuste {name}: {wanted}, no {value}.",
        ),
    ),
    "variable-not-understood-example": Sentence(
        "The variable {name} can't be {value}. For example: {wanted}.",
        "A variável {name} não pode ser {value}. Por exemplo: {wanted}.",
        "La variable {name} no puede ser {value}. Por ejemplo: {wanted}.",
        brief=(
            "Variable {name}: {wanted}, not {value}.",
            "Variável {name}: {wanted}, não {value}.",
            "Variable {name}: {wanted}, no {value}.",
        ),
    ),
    "setting-not-understood-choice": Sentence(
        "The setting {name} can't be {value}. It takes one of {wanted}.",
        "A configuração {name} não pode ser {value}. Aceita um destes: {wanted}.",
        "El ajuste {name} no puede ser {value}. Acepta uno de estos: {wanted}.",
        brief=(
            "Setting {name}: {wanted}, not {value}.",
            "Ajuste {name}: {wanted}, não {value}.",
            "Ajuste {name}: {wanted}, no {value}.",
        ),
    ),
    "variable-not-understood-choice": Sentence(
        "The variable {name} can't be {value}. It takes one of {wanted}.",
        "A variável {name} não pode ser {value}. Aceita um destes: {wanted}.",
        "La variable {name} no puede ser {value}. Acepta uno de estos: {wanted}.",
        brief=(
            "Variable {name}: {wanted}, not {value}.",
            "Variável {name}: {wanted}, não {value}.",
            "Variable {name}: {wanted}, no {value}.",
        ),
    ),
    "settings-file-damaged": Sentence(
        "Settings file damaged, line {line}. Defaults count.",
        "Arquivo de configurações com erro, linha {line}. Valem os padrões.",
        "Archivo de ajustes con errores, línea {line}. Valen los de siempre.",
        brief=(
            "Settings file damaged, line {line}.",
            "Erro nas configurações, linha {line}.",
            "Error en los ajustes, línea {line}.",
        ),
    ),
    "settings-file-unreadable": Sentence(
        "Settings file unreadable. Defaults count.",
        "Arquivo de configurações ilegível. Valem os padrões.",
        "Archivo de ajustes ilegible. Valen los de siempre.",
        brief=(
            "Settings file unreadable.",
            "Arquivo de configurações ilegível.",
            "Archivo de ajustes ilegible.",
        ),
    ),
    # --- check
    "check-clean": Sentence("{file}: no mistakes.", "{file}: sem erros.", "{file}: sin errores."),
    "check-no-programs": Sentence(
        "There are no programs in {path}, files that end in .gd.",
        "Não há programas em {path}, arquivos que acabam em .gd.",
        "No hay programas en {path}, archivos que acaban en .gd.",
    ),
    # --- help of the command line
    "usage-donnie": Sentence(
        "Program a robot in GoDonnie, by ear, by touch and by eye.",
        "Programe um robô em GoDonnie, pelo ouvido, pelo tato e pela visão.",
        "Programa un robot en GoDonnie, con el oído, el tacto y la vista.",
    ),
    "usage-commands": Sentence(
        "Commands, each with its own --help. A file of that name runs as ./NAME.",
        "Comandos, cada um com seu --help. Um arquivo com esse nome: ./NOME.",
        "Comandos, cada uno con su --help. Un archivo con ese nombre: ./NOMBRE.",
    ),
    "usage-run": Sentence(
        "Run a program without asking anything.",
        "Executar um programa sem perguntar nada.",
        "Ejecutar un programa sin preguntar nada.",
    ),
    "usage-check": Sentence(
        "Tell all mistakes of programs. Nothing runs.",
        "Dizer todos os erros de programas. Nada é executado.",
        "Decir todos los errores de programas. No se ejecuta nada.",
    ),
    "usage-format": Sentence(
        "Lay programs out anew, and translate their keywords.",
        "Arrumar programas e traduzir suas palavras-chave.",
        "Ordenar programas y traducir sus palabras clave.",
    ),
    "usage-worlds": Sentence("List the worlds.", "Listar os mundos.", "Listar los mundos."),
    "usage-world": Sentence(
        "Describe a world in words.", "Descrever um mundo em palavras.", "Describir un mundo con palabras."
    ),
    "usage-options": Sentence("options everywhere", "opções em todo lugar", "opciones en todas partes"),
    "option-file": Sentence("a program to open", "um programa para abrir", "un programa para abrir"),
    "option-file-or-input": Sentence(
        "a program; - is standard input",
        "um programa; - é a entrada padrão",
        "un programa; - es la entrada estándar",
    ),
    "option-linear": Sentence(
        "plain lines, for screen readers and braille",
        "linhas simples, para leitores de tela e braile",
        "líneas simples, para lectores de pantalla y braille",
    ),
    "option-visual": Sentence("the full screen", "a tela cheia", "la pantalla completa"),
    "option-f": Sentence(
        "run a program, as the original GoDonnie did",
        "executar um programa, como no GoDonnie original",
        "ejecutar un programa, como el GoDonnie original",
    ),
    "option-m": Sentence("no voice, no sounds", "sem voz e sem sons", "sin voz ni sonidos"),
    "option-l": Sentence(
        "log what is told in the folder Log",
        "registrar o que é dito na pasta Log",
        "registrar lo que se dice en la carpeta Log",
    ),
    "option-version": Sentence("tell the version", "dizer a versão", "decir la versión"),
    "option-help": Sentence("this help", "esta ajuda", "esta ayuda"),
    "option-trace": Sentence(
        "an event for each statement", "um evento para cada comando", "un evento por cada comando"
    ),
    "option-to": Sentence(
        "the language of the keywords", "a língua das palavras-chave", "el idioma de las palabras clave"
    ),
    "option-write": Sentence(
        "write into the file", "escrever no próprio arquivo", "escribir en el propio archivo"
    ),
    "option-map": Sentence("the map in letters", "o mapa em letras", "el mapa en letras"),
    "option-report": Sentence(
        "what was loaded, ignored and repaired",
        "o que foi carregado, ignorado e corrigido",
        "lo cargado, ignorado y corregido",
    ),
    "option-json": Sentence("the models as JSON", "os modelos em JSON", "los modelos en JSON"),
    "option-svg": Sentence(
        "write a raised-line picture for swell paper",
        "gravar um desenho em relevo para papel microcapsulado",
        "guardar un dibujo en relieve para papel microcápsula",
    ),
    "option-brf": Sentence(
        "write a braille page for an embosser",
        "gravar uma página em braille para impressora braille",
        "guardar una página en braille para impresora braille",
    ),
    "option-world": Sentence(
        "a world by name, or a file",
        "um mundo pelo nome, ou um arquivo",
        "un mundo por su nombre, o un archivo",
    ),
    "option-robot": Sentence("which robot", "qual robô", "qué robot"),
    "option-lang": Sentence("language of the messages", "língua das mensagens", "idioma de los mensajes"),
    "option-speed": Sentence(
        "times the real robot's pace", "vezes o ritmo do robô real", "veces el ritmo del robot real"
    ),
    "option-seed": Sentence(
        "of chance, where there is any", "do acaso, onde houver", "del azar, donde lo haya"
    ),
    "option-speech": Sentence("who speaks", "quem fala", "quién habla"),
    "option-sound": Sentence("sounds", "sons", "sonidos"),
    "option-verbosity": Sentence("how much is told", "quanto é dito", "cuánto se dice"),
    "option-record": Sentence("a file to record into", "um arquivo para gravar", "un archivo para grabar"),
    "option-events": Sentence(
        "what happens, as JSON lines", "o que acontece, em linhas JSON", "lo que pasa, en líneas JSON"
    ),
}
